#include <thelma/output/observables/observable_name.h>

namespace thelma
{

std::string ObservableName::place(const std::string& entry) const
{
  return "section Observables/" + own + ", entry '" + entry + "'";
}

std::string ObservableName::column(const std::string& of_kind) const
{
  if (own == kind)
    return of_kind;
  const bool begins_with_kind = of_kind == kind || of_kind.rfind(kind + "_", 0) == 0;
  return own + (begins_with_kind ? of_kind.substr(kind.size()) : "_" + of_kind);
}

} // namespace thelma
