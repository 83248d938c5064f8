#include <thelma/output/observables/chosen_observables.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace thelma
{
namespace
{

constexpr char kind_entry[] = "Kind";

/// Sections have a name.
std::vector<std::string> named(std::vector<std::string> names)
{
  names.erase(std::remove(names.begin(), names.end(), ""), names.end());
  return names;
}

bool contains(const std::vector<std::string>& names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Whether columns may begin with it: letters, digits and _, also those of other alphabets in
/// UTF-8.
bool is_name(const std::string& text)
{
  return std::all_of(text.begin(), text.end(), [](const unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c >= 0x80;
  });
}

/// The Kind of each of the @p names whose sections have one.
std::map<std::string, std::string> kinds_of(const ParameterFile& file,
                                            const std::vector<std::string>& names)
{
  std::map<std::string, std::string> kinds;
  file.peek([&](dealii::ParameterHandler& prm) {
    for (const std::string& name : names) {
      const Section section(prm, {"Observables", name});
      prm.add_parameter(kind_entry, kinds[name]);
    }
  });
  for (auto entry = kinds.begin(); entry != kinds.end();)
    entry = entry->second.empty() ? kinds.erase(entry) : std::next(entry);
  return kinds;
}

/// Throws InputError unless @p name, given only once, is a known kind or has one.
template <int dim>
void check_name(const std::string& name, const std::map<std::string, std::string>& kinds)
{
  if (observables<dim>().has(name))
    return;
  if (kinds.count(name) == 0) {
    std::vector<std::string> known = observables<dim>().names();
    for (const auto& entry : kinds)
      if (!contains(known, entry.first))
        known.push_back(entry.first);
    throw InputError("unknown observable '" + name + "', and Observables/" + name + " has no Kind" +
                     did_you_mean(name, known));
  }
  if (!is_name(name))
    throw InputError("the name of the observable '" + name +
                     "' begins the names of its columns; use only letters, digits and _");
}

/// What all of them @p tell, one after the other.
template <int dim>
std::vector<std::string> texts(const std::vector<std::unique_ptr<Observable<dim>>>& observed,
                               std::vector<std::string> (Observable<dim>::*tell)() const)
{
  std::vector<std::string> all;
  for (const auto& observable : observed)
    for (const std::string& text : (*observable.*tell)())
      all.push_back(text);
  return all;
}

} // namespace

template <int dim>
ChosenObservables<dim>::ChosenObservables(const ParameterFile& file)
{
  std::vector<std::string> listed, distinct;
  file.peek([&](dealii::ParameterHandler& prm) {
    const Section section(prm, {"Output"});
    prm.add_parameter("Observables", listed);
  });
  for (const std::string& name : named(listed))
    if (!contains(distinct, name))
      distinct.push_back(name);
  kinds = kinds_of(file, named(file.subsections({"Observables"})));
  for (const std::string& name : distinct)
    if (auto observable = create(name))
      observed.push_back(std::move(observable));
    else
      unknown[name] = named(file.entries({"Observables", name}));
  add_unlisted(file, distinct);
}

/// Their sections are declared too, so that a misspelt name is reported only once.
template <int dim>
void ChosenObservables<dim>::add_unlisted(const ParameterFile& file,
                                          const std::vector<std::string>& listed)
{
  for (const std::string& name : file.subsections({"Observables"}))
    if (!contains(listed, name))
      if (auto observable = create(name)) {
        unlisted.push_back(std::move(observable));
        if (unknown.empty())
          unnamed.push_back(name);
      }
}

template <int dim>
std::unique_ptr<Observable<dim>> ChosenObservables<dim>::create(const std::string& name) const
{
  const auto said = kinds.find(name);
  const std::string& kind =
      observables<dim>().has(name) || said == kinds.end() ? name : said->second;
  return observables<dim>().has(kind) ? observables<dim>().create(kind, {kind, name}) : nullptr;
}

template <int dim>
void ChosenObservables<dim>::declare_names(dealii::ParameterHandler& prm) const
{
  prm.declare_entry("Observables", "", dealii::Patterns::List(dealii::Patterns::Anything()),
                    "Columns of curve.csv in addition to the load: known observables, and names "
                    "of your own whose sections say their `Kind`; known: " +
                        comma_separated(observables<dim>().names()) + ".");
  prm.add_action("Observables", [kinds = kinds](const std::string& names) {
    std::set<std::string> distinct;
    for (const std::string& name : dealii::Utilities::split_string_list(names)) {
      check_name<dim>(name, kinds);
      if (!distinct.insert(name).second)
        throw InputError("'" + name + "' is given twice; write every observable once");
    }
  });
}

template <int dim>
void ChosenObservables<dim>::declare(dealii::ParameterHandler& prm)
{
  for (const List* list : {&observed, &unlisted})
    for (const auto& observable : *list) {
      const Section section(prm, {"Observables", observable->name.own});
      declare_kind(prm, observable->name.own);
      observable->declare(prm);
    }
  for (const auto& [name, entries] : unknown) {
    const Section section(prm, {"Observables", name});
    declare_kind(prm, name);
    for (const std::string& entry : entries)
      if (entry != kind_entry)
        prm.declare_entry(entry, "", dealii::Patterns::Anything());
  }
}

/// A name that is a kind needs none.
template <int dim>
void ChosenObservables<dim>::declare_kind(dealii::ParameterHandler& prm,
                                          const std::string& name) const
{
  const bool is_kind = observables<dim>().has(name);
  if (is_kind && kinds.count(name) == 0)
    return;
  prm.declare_entry(kind_entry, "", dealii::Patterns::Anything(),
                    "Which of the known observables this is, if its name is none of them. The "
                    "names of its columns begin with its own name, in the place of the kind's.");
  prm.add_action(kind_entry, [is_kind, name](const std::string& kind) {
    if (kind.empty())
      return;
    observables<dim>().require(kind);
    if (is_kind && kind != name)
      throw InputError("'" + name + "' is a known observable itself and cannot be of the kind '" +
                       kind + "'; choose another name, or remove the Kind");
  });
}

template <int dim>
void ChosenObservables<dim>::setup(const ObservableInput<dim>& scene, InputErrors& found)
{
  for (const auto& observable : observed)
    found.collect([&]() { observable->setup(scene); });
  for (const std::string& name : unnamed)
    found.add("section Observables/" + name +
              ": the entry 'Observables' of the section Output does not name it; add '" + name +
              "' there, or remove this section");
}

template <int dim>
void ChosenObservables<dim>::require_distinct(const std::vector<std::string>& curve,
                                              InputErrors& found) const
{
  for (const auto& observable : observed)
    if (observable->name.own != observable->name.kind)
      for (const std::string& column : observable->columns())
        if (std::count(curve.begin(), curve.end(), column) > 1)
          found.add("section Observables/" + observable->name.own +
                    ": the curve has another column '" + column + "'; choose another name");
}

template <int dim>
std::vector<std::string> ChosenObservables<dim>::columns() const
{
  return texts<dim>(observed, &Observable<dim>::columns);
}

template <int dim>
std::vector<std::string> ChosenObservables<dim>::remarks() const
{
  return texts<dim>(observed, &Observable<dim>::remarks);
}

template <int dim>
std::vector<double> ChosenObservables<dim>::evaluate(const ObservableInput<dim>& scene)
{
  std::vector<double> values;
  for (const auto& observable : observed)
    for (const double value : observable->evaluate(scene))
      values.push_back(value);
  return values;
}

template <int dim>
void ChosenObservables<dim>::require_column(const std::string& column,
                                            const std::string& place) const
{
  const std::vector<std::string> known = columns();
  if (!contains(known, column))
    throw InputError(place + ": no observable has the column '" + column + "'" +
                     did_you_mean(column, known));
}

template <int dim>
double ChosenObservables<dim>::value(const ObservableInput<dim>& scene, const std::string& column)
{
  for (const auto& observable : observed) {
    const std::vector<std::string> names = observable->columns();
    const auto found = std::find(names.begin(), names.end(), column);
    if (found != names.end())
      return observable->evaluate(scene)[found - names.begin()];
  }
  return 0.;
}

template class ChosenObservables<2>;
template class ChosenObservables<3>;

} // namespace thelma
