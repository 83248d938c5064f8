#pragma once

namespace thelma
{

/// C_ab = sum_k A_ka B_kb, or += with @p add: the hot loop of every tangent. Rows are of length
/// stride, fast ones of 4, 8, 12 or 28; B and C are dense.
struct Product {
  unsigned int n_k, stride;
  const double* const* A; ///< the rows, of any place
  const double* B;
  double* C;
  bool add;
};

/// With the widest registers of the processor it runs on.
void product(const Product& p);

} // namespace thelma
