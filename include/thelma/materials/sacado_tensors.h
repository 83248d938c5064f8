#pragma once

#include <deal.II/differentiation/ad/sacado_product_types.h>

/// deal.II's tensors know Sacado's DFad but not its fixed-size SFad: these traits say that an SFad,
/// or an unevaluated expression of SFads, is a scalar, and what type a product of scalars has.
namespace dealii
{
namespace internal
{
using SacadoExpression = Sacado::Fad::Exp::ExprSpecDefault;

template <int n>
struct ProductTypeImpl<Sacado::Fad::SFad<double, n>, Sacado::Fad::SFad<double, n>> {
  using type = Sacado::Fad::SFad<double, n>;
};

template <int n>
struct ProductTypeImpl<Sacado::Fad::SFad<double, n>, double> {
  using type = Sacado::Fad::SFad<double, n>;
};

template <int n>
struct ProductTypeImpl<double, Sacado::Fad::SFad<double, n>> {
  using type = Sacado::Fad::SFad<double, n>;
};

template <int n, template <typename, typename> class Operation, typename A>
struct ProductTypeImpl<Sacado::Fad::SFad<double, n>, Operation<A, SacadoExpression>> {
  using type = Sacado::Fad::SFad<double, n>;
};

template <int n, template <typename, typename, bool, bool, typename> class Operation, typename A,
          typename B, bool constant_a, bool constant_b>
struct ProductTypeImpl<Sacado::Fad::SFad<double, n>,
                       Operation<A, B, constant_a, constant_b, SacadoExpression>> {
  using type = Sacado::Fad::SFad<double, n>;
};
} // namespace internal

template <int n>
struct EnableIfScalar<Sacado::Fad::SFad<double, n>> {
  using type = Sacado::Fad::SFad<double, n>;
};

template <template <typename, typename> class Operation, typename A>
struct EnableIfScalar<Operation<A, internal::SacadoExpression>>
    : Sacado::BaseExprType<Operation<A, internal::SacadoExpression>> {
};

template <template <typename, typename, bool, bool, typename> class Operation, typename A,
          typename B, bool constant_a, bool constant_b>
struct EnableIfScalar<Operation<A, B, constant_a, constant_b, internal::SacadoExpression>>
    : Sacado::BaseExprType<Operation<A, B, constant_a, constant_b, internal::SacadoExpression>> {
};
} // namespace dealii
