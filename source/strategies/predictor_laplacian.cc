// The matrix of theory.md, eq. 64.

#include <thelma/assembly/tangent_matrix.h>
#include <thelma/elements/integrate.h>
#include <thelma/strategies/predictor.h>

namespace thelma
{

template <int dim>
void Predictor<dim>::make_laplacian()
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
    for (unsigned int q = 0; q < full->basis().n_points; ++q) {
      const auto& point = full->of_cell(index)[q];
      const Gradients<dim> gradients(full->basis(), q, point);
      for (unsigned int a = 0; a < gradients.n_nodes; ++a)
        for (unsigned int b = 0; b < gradients.n_nodes; ++b) {
          double sum = 0.;
          for (int J = 0; J < dim; ++J)
            sum += point.JxW * gradients.g[J][a] * gradients.g[J][b];
          for (int i = 0; i < dim; ++i)
            entries[(a * n_c + i) * n + b * n_c + i] += sum;
        }
    }
    matrix.add(index, cell, entries);
  }
  matrix.finish();
  laplacian = std::make_unique<Laplacian>(matrix.matrix(), is_large);
}

template void Predictor<2>::make_laplacian();
template void Predictor<3>::make_laplacian();

} // namespace thelma
