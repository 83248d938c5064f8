#pragma once

#include <Epetra_CrsMatrix.h>

#include <algorithm>

namespace thelma
{

/// An own row of a complete matrix where Trilinos stores it, with Trilinos' local columns.
struct StoredRow {
  StoredRow(const Epetra_CrsMatrix& matrix, const int row)
  {
    matrix.ExtractMyRowView(matrix.LRID(row), n, values, columns);
  }

  /// Epetra sorts the columns of a matrix that is complete.
  double* entry(const int column) const
  {
    return values + (std::lower_bound(columns, columns + n, column) - columns);
  }

  int n = 0;
  double* values = nullptr;
  int* columns = nullptr;
};

} // namespace thelma
