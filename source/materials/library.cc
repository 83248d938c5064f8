#include <thelma/base/error.h>
#include <thelma/base/quantity.h>
#include <thelma/materials/library.h>
#include <thelma/materials/material_checks.h>
#include <thelma/materials/material_list.h>

namespace thelma
{
namespace
{

template <typename Laws>
std::vector<Choice> choices()
{
  return std::apply(
      [](auto... law) {
        return std::vector<Choice>{{decltype(law)::name, decltype(law)::meaning}...};
      },
      Laws());
}

std::string pattern(const std::vector<Choice>& laws)
{
  std::string names;
  for (const Choice& law : laws)
    names += (names.empty() ? "" : "|") + law.name;
  return names;
}

template <typename Map>
std::vector<std::string> keys(const Map& map)
{
  std::vector<std::string> result;
  for (const auto& entry : map)
    result.push_back(entry.first);
  return result;
}

std::unique_ptr<Material> create(const std::string& elastic, const std::string& dielectric)
{
  std::unique_ptr<Material> material;
  for_each_material([&](auto* type, const std::string& e, const std::string& d) {
    if (e == elastic && d == dielectric)
      material = std::make_unique<std::remove_pointer_t<decltype(type)>>();
  });
  return material;
}

} // namespace

std::vector<Choice> elastic_laws()
{
  return choices<ElasticLaws>();
}
std::vector<Choice> branch_laws()
{
  return Branches::laws();
}
std::vector<Choice> dielectric_laws()
{
  return choices<DielectricLaws>();
}

MaterialLibrary::Entry::Entry() : elastic(NeoHookean::name), dielectric(IdealDielectric::name) {}

MaterialLibrary::MaterialLibrary(const ParameterFile& file)
{
  file.peek([&](dealii::ParameterHandler& prm) { declare_regions(prm); });
  for (const auto& [region, name] : material_of_region)
    materials[name];
  for (auto& [name, entry] : materials) {
    file.peek([&, &name = name, &entry = entry](dealii::ParameterHandler& prm) {
      declare_laws(prm, name, entry);
    });
    entry.material = create(entry.elastic, entry.dielectric);
    entry.material->name = name;
    entry.material->set_branches(Branches(entry.branches));
    entry.has_section = file.has_section({"Materials", name});
  }
}

void MaterialLibrary::declare_regions(dealii::ParameterHandler& prm)
{
  using namespace dealii::Patterns;
  const Section section(prm, {"Regions"});
  prm.add_parameter("Materials", material_of_region,
                    "Material of each region (a physical group of the mesh), as "
                    "`region: material, region: material`.",
                    Map(Anything(), Anything(), 0, 100));
}

void MaterialLibrary::declare_laws(dealii::ParameterHandler& prm, const std::string& name,
                                   Entry& entry)
{
  using dealii::Patterns::Selection;
  namespace Patterns = dealii::Patterns;
  const Section section(prm, {"Materials", name});
  prm.add_parameter("Elastic law", entry.elastic, "Elastic energy W(F_EM, theta).",
                    Selection(pattern(elastic_laws())));
  prm.add_parameter("Branches", entry.branches,
                    "Laws of viscoelastic branches beside the elastic law (a generalised Maxwell "
                    "element), such as `Maxwell, Maxwell`; each has its own section `Branch 1`, "
                    "`Branch 2`, ...",
                    Patterns::List(Selection(pattern(branch_laws())), 0, 20));
  prm.add_parameter("Dielectric law", entry.dielectric, "Electric energy.",
                    Selection(pattern(dielectric_laws())));
}

void MaterialLibrary::declare(dealii::ParameterHandler& prm)
{
  material_of_region.clear(); // the declared defaults; reading brings the choices back
  declare_regions(prm);
  for (auto& [name, entry] : materials) {
    entry.branches.clear();
    entry.elastic = Entry().elastic;
    entry.dielectric = Entry().dielectric;
    declare_laws(prm, name, entry);
    const Section section(prm, {"Materials", name});
    entry.material->declare(prm);
    add_quantity(prm, "Density", entry.material->density, "Mass density, for Loads/Gravity.",
                 Quantity("kg/m^3", 0.));
  }
}

void MaterialLibrary::check(const double theta)
{
  if (materials.empty())
    throw InputError("section Regions, entry 'Materials': it is empty or missing; write `set "
                     "Materials = region: material`");
  check_at({theta, "Temperature/Value"});
  for (const auto& [name, entry] : materials) {
    require_in_tables(*entry.material, {entry.material->thermal.theta_0, "Reference temperature"});
    try {
      Thermal& thermal = entry.material->thermal;
      thermal.follow(entry.material->shear_modulus(thermal.theta_0));
    } catch (const InputError& error) {
      throw InputError("section Materials/" + name + ", entry 'Bulk modulus': " + error.what());
    }
    require_positive(name, "Bulk modulus", entry.material->thermal.K, "");
  }
}

void MaterialLibrary::check_at(const KnownTemperature& known) const
{
  const double theta = known.theta;
  const std::string at = " at " + as_text(theta) + " K";
  for (const auto& [name, entry] : materials) {
    require_in_tables(*entry.material, known);
    if (entry.elastic == ExpressionLaw::name)
      require_stable_rest(*entry.material, theta);
    else
      require_positive(name, "Shear modulus", entry.material->shear_modulus(theta), at);
    if (const std::string wrong = entry.material->branch_defect(theta); !wrong.empty())
      throw InputError("section Materials/" + name + ", entry '" + wrong + "': the value" + at +
                       " must be positive");
    require_positive(name, "Permittivity", entry.material->permittivity(theta), at);
    const double relative = entry.material->permittivity(theta) / vacuum_permittivity;
    if (relative > 1e5)
      throw InputError("section Materials/" + name + ", entry 'Permittivity': the value is " +
                       as_text(relative) +
                       " times that of vacuum; write it in N/kV^2, or with its unit F/m");
    if (relative < 1.)
      throw InputError("section Materials/" + name + ", entry 'Permittivity': the value is " +
                       as_text(relative) + " times that of vacuum" + at +
                       ", less than in any material; write it in N/kV^2, or with its unit F/m");
  }
}

void MaterialLibrary::check_heat(const bool in_time, const bool by_power) const
{
  const std::string flowing = one_that_remembers();
  if (by_power && !flowing.empty())
    throw InputError("section Time, entry 'Structural heat': `power` does not count the heat that "
                     "the flow of the viscoelastic material '" +
                     flowing + "' makes; choose entropy, or none");
  for (const auto& [name, entry] : materials)
    if (in_time)
      require_positive(name, "Heat capacity", entry.material->thermal.c, " in a transient scene");
    else
      require_positive(name, "Conductivity", entry.material->thermal.k, " in a steady scene");
}

std::string MaterialLibrary::one_that_remembers() const
{
  for (const auto& [name, entry] : materials)
    if (entry.material->n_history() > 0)
      return name;
  return "";
}

std::vector<std::string> MaterialLibrary::summary(const double theta) const
{
  std::vector<std::string> lines;
  for (const auto& [name, entry] : materials) {
    std::vector<std::string> places;
    for (const auto& [region, material] : material_of_region)
      if (material == name)
        places.push_back(region);
    lines.push_back(
        "material " + name + " in " + comma_separated(places) + ": " + entry.elastic + ", " +
        entry.dielectric + " dielectric, mu " + as_text(entry.material->shear_modulus(theta)) +
        " MPa, K " + as_text(entry.material->thermal.K) + " MPa, eps " +
        as_text(entry.material->permittivity(theta)) + " N/kV^2" +
        (entry.material->n_history() > 0
             ? ", " + std::to_string(entry.branches.size()) + " branches of in all " +
                   as_text(entry.material->branch_modulus(theta)) + " MPa"
             : "") +
        (entry.has_section ? "" : "; all defaults, because there is no section Materials/" + name));
  }
  return lines;
}

std::vector<std::string> MaterialLibrary::doubts() const
{
  constexpr double softest = 10., hardest = 1e5;
  std::vector<std::string> sentences;
  for (const auto& [name, entry] : materials) {
    const Thermal& thermal = entry.material->thermal;
    const double mu = entry.material->shear_modulus(thermal.theta_0), ratio = thermal.K / mu;
    if (ratio < softest || ratio > hardest)
      sentences.push_back("warning: the bulk modulus of " + name + " is " + as_text(ratio) +
                          " times its shear modulus, " +
                          (ratio < softest ? "typical of a foam" : "which reduces accuracy") +
                          "; rubber has about 1000 (Materials/" + name +
                          "/Bulk over shear modulus)");
  }
  return sentences;
}

double MaterialLibrary::reference_temperature() const
{
  const double theta_0 = materials.begin()->second.material->thermal.theta_0;
  for (const auto& [name, entry] : materials)
    if (entry.material->thermal.theta_0 != theta_0)
      throw InputError("section Materials/" + name +
                       ", entry 'Reference temperature': all materials need the same one, from "
                       "which the scene starts");
  return theta_0;
}

const Material& MaterialLibrary::of_region(const std::string& region) const
{
  const auto found = material_of_region.find(region);
  if (found == material_of_region.end())
    throw InputError(
        "section Regions, entry 'Materials': the region '" + region +
        "' of the mesh has no material; regions with a material: " + comma_separated(regions()));
  return *materials.at(found->second).material;
}

const Material& MaterialLibrary::named(const std::string& name, const std::string& place) const
{
  const auto found = materials.find(name);
  if (found != materials.end())
    return *found->second.material;
  throw InputError(place + ": unknown material '" + name + "'" + did_you_mean(name, names()));
}

std::vector<std::string> MaterialLibrary::names() const
{
  return keys(materials);
}

std::vector<std::string> MaterialLibrary::regions() const
{
  return keys(material_of_region);
}

} // namespace thelma
