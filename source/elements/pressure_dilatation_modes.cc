// The modes of pressure and dilatation, their masses, and the pressure that they make.

#include <thelma/elements/pressure_dilatation.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/full_matrix.h>

#include <numeric>

namespace thelma
{

template <int dim>
std::vector<dealii::Point<dim>> PressureDilatation<dim>::points(const unsigned int n_points)
{
  return dealii::QGauss<dim>(n_points).get_points();
}

template <int dim>
std::vector<Modes> PressureDilatation<dim>::polynomials(const unsigned int n_points,
                                                        const unsigned int n_modes)
{
  std::vector<Modes> values;
  for (const auto& point : points(n_points))
    values.push_back(polynomials_at(point, n_modes));
  return values;
}

template <int dim>
Modes PressureDilatation<dim>::polynomials_at(const dealii::Point<dim>& xi,
                                              const unsigned int n_modes)
{
  Modes values{{1.}};
  for (unsigned int i = 1; i < n_modes; ++i)
    values[i] = 2. * xi[i - 1] - 1.;
  return values;
}

template <int dim>
Modes PressureDilatation<dim>::modes_at(const dealii::Point<dim>& xi) const
{
  return polynomials_at(xi, n_modes);
}

/// Without the part of the stabilisation, whose mean over the cell is zero.
template <int dim>
double PressureDilatation<dim>::pressure(const CellView<dim>& view, const dealii::Point<dim>& xi,
                                         const PointState<>&) const
{
  const Modes m = modes_at(xi);
  return std::inner_product(m.begin(), m.begin() + n_modes, view.internal, 0.);
}

template <int dim>
Modes PressureDilatation<dim>::times(const ModeMatrix& A, const Modes& x) const
{
  Modes y{};
  for (unsigned int i = 0; i < n_modes; ++i)
    for (unsigned int j = 0; j < n_modes; ++j)
      y[i] += A[i][j] * x[j];
  return y;
}

template <int dim>
typename PressureDilatation<dim>::ModeMatrix
PressureDilatation<dim>::invert_mass(const PointGeometry<dim>* geometry) const
{
  dealii::FullMatrix<double> mass(n_modes, n_modes);
  for (std::size_t q = 0; q < modes.size(); ++q)
    for (unsigned int i = 0; i < n_modes; ++i)
      for (unsigned int j = 0; j < n_modes; ++j)
        mass(i, j) += geometry[q].JxW * modes[q][i] * modes[q][j];
  mass.gauss_jordan();
  ModeMatrix inverse{};
  for (unsigned int i = 0; i < n_modes; ++i)
    for (unsigned int j = 0; j < n_modes; ++j)
      inverse[i][j] = mass(i, j);
  return inverse;
}

#define INSTANTIATE(dim)                                                                           \
  template std::vector<dealii::Point<dim>> PressureDilatation<dim>::points(unsigned int);          \
  template std::vector<Modes> PressureDilatation<dim>::polynomials(unsigned int, unsigned int);    \
  template Modes PressureDilatation<dim>::modes_at(const dealii::Point<dim>&) const;               \
  template double PressureDilatation<dim>::pressure(                                               \
      const CellView<dim>&, const dealii::Point<dim>&, const PointState<>&) const;                 \
  template Modes PressureDilatation<dim>::times(const ModeMatrix&, const Modes&) const;            \
  template PressureDilatation<dim>::ModeMatrix PressureDilatation<dim>::invert_mass(               \
      const PointGeometry<dim>*) const;
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

} // namespace thelma
