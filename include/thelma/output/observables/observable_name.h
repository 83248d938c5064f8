#pragma once

#include <string>

namespace thelma
{

/// What a scene calls one of its observables, and which kind of the list that is.
struct ObservableName {
  std::string kind, own;

  /// `section Observables/<own>, entry '<entry>'`, with which an InputError begins.
  std::string place(const std::string& entry) const;

  /// The name of a column that the kind calls @p of_kind. Under a name of its own an observable
  /// begins all its columns with that: in the place of the kind (`probe_theta_K`, `lambda_3`), or
  /// before the rest (`capacitance_nF`).
  std::string column(const std::string& of_kind) const;
};

} // namespace thelma
