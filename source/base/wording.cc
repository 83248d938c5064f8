#include <thelma/base/wording.h>

#include <algorithm>
#include <regex>
#include <utility>
#include <vector>

namespace thelma
{

std::string other_wording(const std::string& entry)
{
  const std::string modulus = "write `Shear modulus`, which is E/(2 (1 + nu)) of Young's modulus E",
                    ratio = "write `Poisson ratio` in addition to `Shear modulus`",
                    permittivity =
                        "write `Permittivity`, the relative permittivity times 8.8542e-12 F/m",
                    voltage = "write `Target` in the section Loading, with `Control = voltage`";
  static const std::vector<std::pair<std::regex, std::string>> known{
      {std::regex("(young('?s)? modulus|elastic modulus|e)", std::regex::icase), modulus},
      {std::regex("(poisson('?s)?( ratio)?|nu)", std::regex::icase), ratio},
      {std::regex("(lame.*|lambda)", std::regex::icase),
       "write `Bulk modulus`, which is Lame's lambda"},
      {std::regex("mu|g", std::regex::icase), "write `Shear modulus`"},
      {std::regex("(relative permittivity|dielectric constant|eps.*)", std::regex::icase),
       permittivity},
      {std::regex("(applied )?voltage", std::regex::icase), voltage},
      {std::regex("density|rho", std::regex::icase), "remove it, because there is no inertia"},
      {std::regex("(electrode distance|thickness)", std::regex::icase),
       "write `Film thickness` in the section Loading"}};
  for (const auto& [form, remedy] : known)
    if (std::regex_match(entry, form))
      return remedy;
  return "";
}

std::string writable(std::string name)
{
  std::replace_if(
      name.begin(), name.end(), [](const char c) { return c == ',' || c == ':'; }, ';');
  return name;
}

std::string unquoted(const std::string& value)
{
  if (std::count(value.begin(), value.end(), '"') % 2 != 0)
    return value;
  std::string result;
  std::size_t begin = 0;
  for (bool is_quoted = false; begin <= value.size(); is_quoted = !is_quoted) {
    const std::size_t end = std::min(value.find('"', begin), value.size());
    const std::string part = value.substr(begin, end - begin);
    result += is_quoted ? writable(part) : part;
    begin = end + 1;
  }
  return result;
}

} // namespace thelma
