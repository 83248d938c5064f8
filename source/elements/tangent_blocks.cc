#include <thelma/elements/product.h>
#include <thelma/elements/tangent_blocks.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace thelma
{
namespace
{

/// Numbers that stand @p step apart.
struct Strided {
  const double* begin;
  unsigned int step;
};

/// Of each of the n parts one number, then the next; n is known to the compiler.
template <unsigned int n>
void interleave(const std::array<Strided, TangentBlocks::most_components>& parts,
                const unsigned int length, double* row)
{
  for (unsigned int b = 0; b < length; ++b)
    for (unsigned int d = 0; d < n; ++d)
      row[b * n + d] = parts[d].begin[std::size_t(b) * parts[d].step];
}

} // namespace

void TangentBlocks::reset(const unsigned int nodes, const unsigned int components,
                          const bool is_symmetric)
{
  AssertThrow(components >= 1 && components <= most_components, dealii::ExcInternalError());
  n_nodes = nodes;
  stride = padded(nodes);
  n_components = components;
  symmetric = is_symmetric;
  filled.fill(false);
  values.resize_fast(std::size_t(components) * components * block_size());
}

void TangentBlocks::add_product(const unsigned int c, const unsigned int d, const unsigned int n_k,
                                const double* const* A, const double* B)
{
  bool& add = filled[place(c, d)];
  product({n_k, stride, A, B, begin(c, d), add});
  add = true;
}

double& TangentBlocks::entry(const unsigned int c, const unsigned int d, const unsigned int a,
                             const unsigned int b)
{
  bool& is_filled = filled[place(c, d)];
  if (!is_filled)
    std::fill_n(begin(c, d), block_size(), 0.);
  is_filled = true;
  return begin(c, d)[std::size_t(a) * stride + b];
}

void TangentBlocks::write(std::vector<double>& tangent) const
{
  const std::size_t n = std::size_t(n_nodes) * n_components;
  tangent.resize(n * n);
  double* row = tangent.data();
  for (unsigned int a = 0; a < n_nodes; ++a)
    for (unsigned int c = 0; c < n_components; ++c, row += n)
      write_row(c, a, row);
}

void TangentBlocks::write_row(const unsigned int c, const unsigned int a, double* row) const
{
  static const double zero = 0.;
  std::array<Strided, TangentBlocks::most_components> parts;
  for (unsigned int d = 0; d < n_components; ++d) {
    const bool mirrored = symmetric && d < c;
    const std::size_t block = mirrored ? place(d, c) : place(c, d);
    const double* entries = values.data() + block * block_size();
    if (!filled[block])
      parts[d] = {&zero, 0};
    else if (mirrored)
      parts[d] = {entries + a, stride};
    else
      parts[d] = {entries + std::size_t(a) * stride, 1};
  }
  switch (n_components) {
  case 1:
    return interleave<1>(parts, n_nodes, row);
  case 2:
    return interleave<2>(parts, n_nodes, row);
  case 3:
    return interleave<3>(parts, n_nodes, row);
  case 4:
    return interleave<4>(parts, n_nodes, row);
  default:
    return interleave<5>(parts, n_nodes, row);
  }
}

} // namespace thelma
