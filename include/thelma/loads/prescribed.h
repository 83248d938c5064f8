#pragma once

#include <thelma/fields/dof_layout.h>

#include <map>

namespace thelma
{

/// Unknowns with a value each.
using PrescribedValues = std::map<dealii::types::global_dof_index, double>;

/// Write into the owned entries of @p x what lies at the part @p level of the way from @p start to
/// the @p values.
inline void prescribe_values(const PrescribedValues& values, const double start, const double level,
                             BlockVector& x)
{
  const dealii::IndexSet owned = x.locally_owned_elements();
  for (const auto& [unknown, value] : values)
    if (owned.is_element(unknown))
      x(unknown) = start + level * (value - start);
}

} // namespace thelma
