#pragma once

#include <cstddef>
#include <vector>

namespace thelma
{

/// A cell's rows in the matrix: where each begins in the values of its blocks and, from there, how
/// far away its columns stand.
struct CellRows {
  CellRows(const std::vector<unsigned int>& block, std::size_t n_blocks);

  static constexpr int absent = -1;

  std::vector<unsigned int> block; ///< of each unknown
  std::vector<bool> own;           ///< rows; the others' offsets are 0 where there is a column
  std::vector<int> begins;         ///< [i * n_blocks + block]
  std::vector<int> offsets;        ///< [i * n + j], or absent
};

/// The same in a sixth of the memory: unknowns that stand next to each other in all rows are one
/// run, and rows with the same offsets (those of one node and field) keep them together.
struct CellPlaces {
  /// Throws where a row is too long for the offsets.
  explicit CellPlaces(const CellRows& rows);

  /// @p length unknowns of the cell from @p first on.
  struct Run {
    unsigned short first, length, block;
  };
  struct Row {
    short pattern; ///< or no_pattern
    short block;
    bool own;
  };
  static constexpr short no_pattern = -1;
  static constexpr unsigned short absent = 0xffff;

  const unsigned short* offsets_of(const Row& row) const
  {
    return offsets.data() + row.pattern * runs.size();
  }

  std::vector<Row> rows;
  std::vector<Run> runs;
  std::vector<unsigned short> offsets; ///< [pattern][run], or absent
  std::vector<int> begins;             ///< [row][block]
};

} // namespace thelma
