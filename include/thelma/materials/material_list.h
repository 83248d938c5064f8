#pragma once

#include <thelma/materials/arruda_boyce.h>
#include <thelma/materials/composed_material.h>
#include <thelma/materials/electrostrictive_dielectric.h>
#include <thelma/materials/expression_law.h>
#include <thelma/materials/fibres.h>
#include <thelma/materials/gent.h>
#include <thelma/materials/ideal_dielectric.h>
#include <thelma/materials/mooney_rivlin.h>
#include <thelma/materials/neo_hookean.h>
#include <thelma/materials/ogden.h>
#include <thelma/materials/saturating_dielectric.h>
#include <thelma/materials/yeoh.h>

#include <tuple>

namespace thelma
{

/// The laws a .prm can choose: one page and one name here each. The derivative test runs over
/// every combination by itself.
using ElasticLaws =
    std::tuple<NeoHookean, Gent, ArrudaBoyce, MooneyRivlin, Yeoh, Ogden, Fibres, ExpressionLaw>;
using DielectricLaws =
    std::tuple<IdealDielectric, ElectrostrictiveDielectric, SaturatingDielectric>;

/// Call @p visit(static_cast<ComposedMaterial<E, D>*>(nullptr), name of E, name of D) for each E,
/// D.
template <typename Visitor>
void for_each_material(const Visitor& visit)
{
  const auto with_elastic = [&](auto elastic) {
    using E = decltype(elastic);
    const auto with_dielectric = [&](auto dielectric) {
      using D = decltype(dielectric);
      visit(static_cast<ComposedMaterial<E, D>*>(nullptr), E::name, D::name);
    };
    std::apply([&](auto... law) { (with_dielectric(law), ...); }, DielectricLaws());
  };
  std::apply([&](auto... law) { (with_elastic(law), ...); }, ElasticLaws());
}

} // namespace thelma
