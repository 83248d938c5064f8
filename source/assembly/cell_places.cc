#include <thelma/assembly/cell_places.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <map>

namespace thelma
{
namespace
{

/// Whether unknown @p j stands right behind its predecessor in every row that has either.
bool follows(const CellRows& cell, const std::size_t j)
{
  const std::size_t n = cell.block.size();
  if (j == 0 || cell.block[j] != cell.block[j - 1])
    return false;
  for (std::size_t i = 0; i < n; ++i) {
    const int here = cell.offsets[i * n + j], before = cell.offsets[i * n + j - 1];
    const int expected = before == CellRows::absent || !cell.own[i] ? before : before + 1;
    if (here != expected)
      return false;
  }
  return true;
}

bool has_entries(const CellRows& cell, const std::size_t j)
{
  const std::size_t n = cell.block.size();
  for (std::size_t i = 0; i < n; ++i)
    if (cell.offsets[i * n + j] != CellRows::absent)
      return true;
  return false;
}

} // namespace

CellRows::CellRows(const std::vector<unsigned int>& block, const std::size_t n_blocks)
    : block(block), own(block.size(), false), begins(block.size() * n_blocks, 0),
      offsets(block.size() * block.size(), absent)
{
}

CellPlaces::CellPlaces(const CellRows& cell) : begins(cell.begins)
{
  const std::size_t n = cell.block.size();
  for (std::size_t j = 0; j < n; ++j)
    if (has_entries(cell, j)) {
      if (!runs.empty() && follows(cell, j))
        ++runs.back().length;
      else
        runs.push_back({static_cast<unsigned short>(j), 1, // its only unknown so far
                        static_cast<unsigned short>(cell.block[j])});
    }
  std::map<std::vector<unsigned short>, short> patterns;
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<unsigned short> row;
    for (const Run& run : runs) {
      const int offset = cell.offsets[i * n + run.first];
      AssertThrow(offset < absent, dealii::ExcMessage("a row of the matrix is too long"));
      row.push_back(offset == CellRows::absent ? absent : static_cast<unsigned short>(offset));
    }
    short pattern = no_pattern;
    if (std::any_of(row.begin(), row.end(), [](const auto offset) { return offset != absent; })) {
      const auto [place, is_new] = patterns.emplace(row, static_cast<short>(patterns.size()));
      if (is_new)
        offsets.insert(offsets.end(), row.begin(), row.end());
      pattern = place->second;
    }
    rows.push_back({pattern, static_cast<short>(cell.block[i]), cell.own[i]});
  }
}

} // namespace thelma
