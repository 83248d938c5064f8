#pragma once

#include <thelma/base/named_list.h>
#include <thelma/loads/load.h>

#include <memory>

namespace thelma
{

/// All loads. Those that stages drive have the name of their stage.
template <int dim>
const NamedList<Load<dim>>& load_kinds();

template <int dim>
std::unique_ptr<Load<dim>> make_uniform_temperature();
template <int dim>
std::unique_ptr<Load<dim>> make_wall_temperature();
template <int dim>
std::unique_ptr<Load<dim>> make_voltage();
template <int dim>
std::unique_ptr<Load<dim>> make_charge();
template <int dim>
std::unique_ptr<Load<dim>> make_force();
template <int dim>
std::unique_ptr<Load<dim>> make_traction();
template <int dim>
std::unique_ptr<Load<dim>> make_body_force();
template <int dim>
std::unique_ptr<Load<dim>> make_gravity();
template <int dim>
std::unique_ptr<Load<dim>> make_pressure();
template <int dim>
std::unique_ptr<Load<dim>> make_free_charge();
template <int dim>
std::unique_ptr<Load<dim>> make_surface_charge();
template <int dim>
std::unique_ptr<Load<dim>> make_motion();
template <int dim>
std::unique_ptr<Load<dim>> make_heat_flux();
template <int dim>
std::unique_ptr<Load<dim>> make_convection();
template <int dim>
std::unique_ptr<Load<dim>> make_heat_source();

} // namespace thelma
