#include <thelma/solvers/anderson.h>

#include <deal.II/lac/lapack_full_matrix.h>

namespace thelma
{

void Unknowns::add(const double factor, const Unknowns& other)
{
  nodal.add(factor, other.nodal);
  for (std::size_t i = 0; i < internal.size(); ++i)
    internal[i] += factor * other.internal[i];
}

double Anderson::product(const Unknowns& a, const Unknowns& b) const
{
  double sum = 0.;
  for (unsigned int i = 0; i < weights.size(); ++i)
    sum += weights[i] * (a.nodal.block(i) * b.nodal.block(i));
  return sum;
}

void Anderson::accelerate(const Unknowns& x, Unknowns& d)
{
  if (!last.empty()) {
    Pair change{x, d};
    change.x.add(-1., last.front().x);
    change.d.add(-1., last.front().d);
    differences.push_back(std::move(change));
    if (differences.size() > memory)
      differences.pop_front();
  }
  last.assign(1, {x, d});

  const std::size_t n = differences.size();
  if (n == 0)
    return;
  dealii::LAPACKFullMatrix<double> normal(n, n);
  dealii::Vector<double> right_side(n), factors(n);
  for (std::size_t i = 0; i < n; ++i) {
    right_side[i] = product(differences[i].d, d);
    for (std::size_t j = 0; j <= i; ++j)
      normal(i, j) = normal(j, i) = product(differences[i].d, differences[j].d);
  }
  // Directions that round-off decides are left out.
  normal.compute_inverse_svd(1e-12);
  normal.vmult(factors, right_side);
  for (std::size_t i = 0; i < n; ++i) {
    d.add(-factors[i], differences[i].x);
    d.add(-factors[i], differences[i].d);
  }
}

} // namespace thelma
