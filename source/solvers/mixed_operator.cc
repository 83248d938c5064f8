#include <thelma/solvers/mixed_operator.h>

#include <cmath>

namespace thelma
{

MixedOperator::MixedOperator(const Tangent& tangent) : tangent(tangent)
{
  std::vector<double> sizes;
  for (unsigned int b = 0; b < size(); ++b) {
    for (unsigned int c = 0; c < size(); ++c)
      copy(b, c);
    const auto& block = tangent.matrix.block(b, b);
    sizes.push_back(block.frobenius_norm() / std::sqrt(static_cast<double>(block.m())));
    row_scales.push_back(std::sqrt(sizes[0] / sizes[b]));
  }
  if (tangent.pressures) {
    pressure_scales = tangent.pressures->inverse_scales();
    pressure_scales *= std::sqrt(sizes[0]);
  }
}

void MixedOperator::copy(const unsigned int b, const unsigned int c)
{
  const auto& block = tangent.matrix.block(b, c);
  blocks.push_back(nullptr);
  if (block.n_nonzero_elements() == 0 || (c < b && is_symmetric(b, c)))
    return;
  const Epetra_CrsMatrix& matrix = block.trilinos_matrix();
  const unsigned int group = tangent.coarse_grids->components(b);
  blocks.back() =
      c == b && is_symmetric(b, b)
          ? std::make_unique<Matrix>(matrix, group)
          : std::make_unique<Matrix>(matrix, group, tangent.coarse_grids->components(c));
}

MixedOperator::BlockVector MixedOperator::new_vector() const
{
  BlockVector vector(size() + (tangent.pressures ? 1 : 0));
  for (unsigned int b = 0; b < size(); ++b)
    vector.block(b).reinit(tangent.matrix.block(b, b).locally_owned_range_indices(),
                           tangent.matrix.get_mpi_communicator());
  if (tangent.pressures)
    vector.block(size()) = tangent.pressures->new_vector();
  vector.collect_sizes();
  return vector;
}

void MixedOperator::vmult(BlockVector& y, const BlockVector& x) const
{
  y = 0.;
  for (unsigned int b = 0; b < size(); ++b)
    for (unsigned int c = 0; c < size(); ++c)
      add(b, c, 1., x.block(c), y.block(b));
  if (tangent.pressures) {
    tangent.pressures->add_forces(x.block(size()), y.block(0));
    tangent.pressures->apply(x.block(0), x.block(size()), y.block(size()));
  }
  scale(y);
}

void MixedOperator::add(const unsigned int b, const unsigned int c, const double factor,
                        const Vector& x, Vector& y) const
{
  if (const auto& block = blocks[b * size() + c])
    block->add(factor, x, y);
  else if (const auto& mirrored = blocks[c * size() + b]; mirrored && is_symmetric(b, c))
    mirrored->add_transposed(factor, x, y);
}

void MixedOperator::scale(BlockVector& y) const
{
  for (unsigned int b = 0; b < size(); ++b)
    y.block(b) *= row_scales[b];
  if (tangent.pressures)
    y.block(size()).scale(pressure_scales);
}

void MixedOperator::unscale(BlockVector& y) const
{
  for (unsigned int b = 0; b < size(); ++b)
    y.block(b) /= row_scales[b];
  if (tangent.pressures)
    for (std::size_t i = 0; i < pressure_scales.locally_owned_size(); ++i)
      y.block(size()).local_element(i) /= pressure_scales.local_element(i);
}

} // namespace thelma
