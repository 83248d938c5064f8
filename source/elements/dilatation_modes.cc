#include <thelma/elements/dilatation_modes.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <utility>

namespace thelma
{

template <int dim>
DilatationModes<dim>::DilatationModes(const Integration<dim>& rule, const std::size_t n_cells,
                                      std::vector<Modes> given, const unsigned int n)
    : n(n), stride(rule.basis().stride), values(std::move(given))
{
  for (std::size_t cell = 0; cell < n_cells; ++cell)
    inverses.push_back(invert_mass(rule.of_cell(cell)));
}

template <int dim>
std::vector<Modes> DilatationModes<dim>::polynomials(const unsigned int n_points,
                                                     const unsigned int n)
{
  std::vector<Modes> values;
  const dealii::QGauss<dim> rule(n_points);
  for (const auto& point : rule.get_points())
    values.push_back(polynomials_at(point, n));
  return values;
}

template <int dim>
Modes DilatationModes<dim>::polynomials_at(const dealii::Point<dim>& xi, const unsigned int n)
{
  Modes values{{1.}};
  for (unsigned int i = 1; i < n; ++i)
    values[i] = 2. * xi[i - 1] - 1.;
  return values;
}

template <int dim>
Modes DilatationModes<dim>::apply_mass_inverse(const std::size_t cell, const Modes& x) const
{
  const ModeMatrix& M = inverses[cell];
  Modes y{};
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      y[i] += M[i][j] * x[j];
  return y;
}

template <int dim>
void DilatationModes<dim>::set_constraint(const CellPoints<dim>& points, const int c,
                                          double* rows) const
{
  const int n_J = stretches<dim>(c, 2) ? points.gradients[0].n_directions() : dim;
  double cofactor[CellPoints<dim>::max][3];
  for (unsigned int q = 0; q < points.n_points; ++q)
    for (int J = 0; J < n_J; ++J)
      cofactor[q][J] =
          points.geometry[q].JxW * points.J(q) * points.G(q, row_of_F<dim>(c, J), axis<dim>(J));
  for (unsigned int a = 0; a < stride; a += 4) {
    Register sums[8] = {};
    for (unsigned int q = 0; q < points.n_points; ++q) {
      Register change{};
      for (int J = 0; J < n_J; ++J)
        change += cofactor[q][J] * *reinterpret_cast<const Register*>(&points.gradients[q].g[J][a]);
      for (unsigned int i = 0; i < n; ++i)
        sums[i] += values[q][i] * change;
    }
    for (unsigned int i = 0; i < n; ++i)
      *reinterpret_cast<Register*>(rows + std::size_t(i) * stride + a) = sums[i];
  }
}

template <int dim>
void DilatationModes<dim>::add_rows(const unsigned int q, const double w, const double* g,
                                    double* rows) const
{
  const Modes& m = values[q];
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int a = 0; a < stride; ++a)
      rows[i * stride + a] += m[i] * w * g[a];
}

template <int dim>
void DilatationModes<dim>::add_product(const double* A, const int first, const int last,
                                       const ModeMatrix& S, const double* B, const int d,
                                       TangentBlocks& blocks) const
{
  alignas(64) std::array<double, 8 * Gradients<dim>::length> answer;
  std::fill_n(answer.begin(), block_size(), 0.);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int b = 0; b < stride; ++b)
        answer[i * stride + b] += S[i][j] * B[j * stride + b];
  std::array<const double*, 8> rows;
  for (int c = first; c < last; ++c, A += block_size()) {
    for (unsigned int i = 0; i < n; ++i)
      rows[i] = A + std::size_t(i) * stride;
    blocks.add_product(c, d, n, rows.data(), answer.data());
  }
}

template <int dim>
ModeMatrix DilatationModes<dim>::invert_mass(const PointGeometry<dim>* geometry) const
{
  dealii::FullMatrix<double> mass(n, n);
  for (std::size_t q = 0; q < values.size(); ++q)
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        mass(i, j) += geometry[q].JxW * values[q][i] * values[q][j];
  mass.gauss_jordan();
  ModeMatrix inverse{};
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      inverse[i][j] = mass(i, j);
  return inverse;
}

template class DilatationModes<2>;
template class DilatationModes<3>;

} // namespace thelma
