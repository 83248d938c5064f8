#include <thelma/assembly/tangent_matrix.h>
#include <thelma/elements/cell_points.h>
#include <thelma/strategies/gradient_fit.h>

#include <deal.II/base/mpi.h>

namespace thelma
{

template <int dim>
GradientFit<dim>::GradientFit(const DofLayout<dim>& layout,
                              const BoundaryConditions<dim>& conditions, const bool is_large)
    : layout(layout), conditions(conditions), is_large(is_large), full(layout, layout.degree() + 1),
      reduced(layout, layout.degree()), moments(layout.new_vector())
{
}

template <int dim>
void GradientFit<dim>::add(const Gradient& wanted, const std::vector<State::Accepted>& states,
                           BlockVector& x)
{
  constexpr double negligible = 1e-5; // root mean square
  std::vector<std::vector<double>> nodal(states.size());
  std::vector<Tensor3<2>> F(states.size());
  std::vector<double> values, size{0., 0.}, sum(2);
  moments = 0.;
  for (std::size_t index = 0; index < layout.cells().size(); ++index) {
    const Cell<dim>& cell = layout.cells()[index];
    for (std::size_t k = 0; k < states.size(); ++k)
      layout.gather(cell, states[k].x, nodal[k]);
    values.assign(cell.dofs.size(), 0.);
    for (unsigned int q = 0; q < reduced.basis().n_points; ++q) {
      const auto& point = reduced.of_cell(index)[q];
      const Gradients<dim> gradients(reduced.basis(), q, point);
      for (std::size_t k = 0; k < states.size(); ++k)
        F[k] = deformation_gradient(cell, nodal[k].data(), gradients);
      const Tensor3<2> H = wanted(F);
      size[0] += point.JxW * H.norm_square();
      size[1] += point.JxW;
      for (unsigned int a = 0; a < gradients.n_nodes; ++a)
        for (int i = 0; i < dim; ++i)
          for (int J = 0; J < gradients.n_directions(); ++J)
            if (stretches<dim>(i, J))
              values[a * cell.n_components + i] +=
                  point.JxW * H[row_of_F<dim>(i, J)][axis<dim>(J)] * gradients.g[J][a];
    }
    layout.scatter(cell, values, moments);
  }
  moments.compress(dealii::VectorOperation::add);
  dealii::Utilities::MPI::sum(size, layout.communicator(), sum);
  if (sum[0] < negligible * negligible * sum[1])
    return;
  if (!laplacian)
    make_laplacian();
  conditions.constraints().set_zero(moments);
  laplacian->solve(moments);
  x.block(0) += moments.block(0);
}

/// The matrix of eq. (78).
template <int dim>
void GradientFit<dim>::make_laplacian()
{
  TangentMatrix<dim> matrix;
  matrix.setup(layout, conditions,
               [](const Cell<dim>&, const unsigned int c, const unsigned int d) {
                 return c == d && c < dim;
               });
  matrix.clear();
  std::vector<double> entries;
  for (std::size_t index = 0; index < layout.cells().size(); ++index) {
    const Cell<dim>& cell = layout.cells()[index];
    const std::size_t n = cell.dofs.size(), n_c = cell.n_components;
    entries.assign(n * n, 0.);
    for (unsigned int q = 0; q < full.basis().n_points; ++q) {
      const auto& point = full.of_cell(index)[q];
      const Gradients<dim> gradients(full.basis(), q, point);
      for (unsigned int a = 0; a < gradients.n_nodes; ++a)
        for (unsigned int b = 0; b < gradients.n_nodes; ++b) {
          for (int i = 0; i < dim; ++i)
            for (int J = 0; J < gradients.n_directions(); ++J)
              if (stretches<dim>(i, J))
                entries[(a * n_c + i) * n + b * n_c + i] +=
                    point.JxW * gradients.g[J][a] * gradients.g[J][b];
        }
    }
    matrix.add(index, cell, entries);
  }
  matrix.finish();
  laplacian = std::make_unique<Laplacian>(matrix.matrix(), is_large);
}

template class GradientFit<2>;
template class GradientFit<3>;

} // namespace thelma
