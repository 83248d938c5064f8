#include <thelma/base/error.h>
#include <thelma/loads/load.h>

#include <sstream>

namespace thelma
{

std::string LevelText::between(const double low, const double high) const
{
  std::ostringstream text;
  text.precision(7);
  text << "between " << before << size * low << " and " << size * high << after;
  return text.str();
}

template <int dim>
void Load<dim>::check(const Stages& stages, const std::string& name, const std::size_t index) const
{
  if (!has_stage() || stages.drive(index) == is_present())
    return;
  if (is_present())
    throw InputError(entry().place() + ": no stage applies it; write `" + name + " 1` into " +
                     Stages::place + ", or remove it");
  throw InputError(std::string(Stages::place) + ": '" + name +
                   "' has nothing to apply; name it in " + entry().place());
}

template class Load<2>;
template class Load<3>;

} // namespace thelma
