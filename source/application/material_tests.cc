#include <thelma/application/material_tests.h>
#include <thelma/base/error.h>
#include <thelma/base/quantity.h>
#include <thelma/materials/library.h>
#include <thelma/materials/material_test.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <istream>
#include <ostream>
#include <set>

namespace thelma
{
namespace
{

using nlohmann::json;

/// The materials of a scene, whatever else is in the file.
class SceneMaterials
{
public:
  SceneMaterials(const std::string& path, const std::vector<Override>& overrides)
      : file(ParameterFile(path, overrides).only({"Regions", "Materials"})), library(file)
  {
    located([&]() {
      dealii::ParameterHandler prm;
      library.declare(prm);
      file.read(prm);
      library.check(library.reference_temperature());
    });
  }

  const Material& named(const std::string& name, const std::set<double>& temperatures) const
  {
    located([&]() {
      for (const double theta : temperatures)
        library.check_at({theta, "a test"});
    });
    if (library.names().size() > 1 && name.empty())
      throw InputError(file.name() + ": it has the materials " + comma_separated(library.names()) +
                       "; name the one that is tested");
    return library.named(name.empty() ? library.names().front() : name, file.name());
  }

private:
  /// Errors in a section name the file.
  template <typename Action>
  void located(const Action& action) const
  {
    try {
      action();
    } catch (const InputError& error) {
      throw InputError(file.located(error.what()));
    }
  }

  ParameterFile file;
  MaterialLibrary library;
};

/// The numbers of a column, `{"unit": "degC", "values": [20, 30]}`, in the unit of @p quantity.
std::vector<double> column(const json& columns, const std::string& name, const Quantity& quantity)
{
  if (!columns.contains(name))
    return {};
  const std::string unit = columns[name].value("unit", "");
  const double zero = quantity.value("0 " + unit), scale = quantity.value("1 " + unit) - zero;
  std::vector<double> values = columns[name].at("values");
  for (double& value : values)
    value = zero + scale * value;
  return values;
}

MaterialTest::Mode mode_of(const std::string& name)
{
  using Mode = MaterialTest::Mode;
  const std::vector<std::pair<std::string, Mode>> modes{{"uniaxial", Mode::uniaxial},
                                                        {"pure shear", Mode::pure_shear},
                                                        {"equibiaxial", Mode::equibiaxial}};
  std::vector<std::string> known;
  for (const auto& [one, mode] : modes) {
    if (one == name)
      return mode;
    known.push_back(one);
  }
  throw InputError("unknown mode '" + name + "'" + did_you_mean(name, known));
}

/// What no test can impose.
void require_possible(const MaterialTest& test)
{
  for (std::size_t i = 0; i < test.rows.size(); ++i) {
    const Imposed& row = test.rows[i];
    const std::string where = "row " + std::to_string(i + 1) + ": ";
    if (!std::isfinite(row.stretch + row.time + row.theta + row.field))
      throw InputError(where + "a value is missing");
    if (!(row.stretch > 0.))
      throw InputError(where + "the stretch is " + as_text(row.stretch) + " but must be positive");
    if (!(row.theta > 0.))
      throw InputError(where + "the temperature is " + as_text(row.theta) +
                       " K but must be above absolute zero; give its unit");
    if (i > 0 && row.time < test.rows[i - 1].time)
      throw InputError(where + "the time is before that of the row above; sort the rows by time");
  }
}

/// The temperature is @p theta if it is not given.
MaterialTest test_of(const json& request, const double theta)
{
  MaterialTest test;
  test.name = request.at("name");
  try {
    test.mode = mode_of(request.at("mode"));
    const json& columns = request.at("columns");
    for (const double stretch : column(columns, "stretch", Quantity("1")))
      test.rows.push_back({0., stretch, theta, 0.});
    const auto read = [&](const std::string& name, const Quantity& quantity, double Imposed::*to) {
      const std::vector<double> values = column(columns, name, quantity);
      if (!values.empty() && values.size() != test.rows.size())
        throw InputError("the columns stretch and " + name + " are not of one length");
      for (std::size_t i = 0; i < values.size(); ++i)
        test.rows[i].*to = values[i];
      return !values.empty();
    };
    test.in_time = read("time", Quantity("s"), &Imposed::time);
    read("temperature", Quantity("K"), &Imposed::theta);
    read("field", Quantity("kV/mm"), &Imposed::field);
    require_possible(test);
  } catch (const InputError& error) {
    throw InputError("test '" + test.name + "', " + error.what());
  }
  return test;
}

/// The stresses of every test, each in the unit it asks for, of the materials with some entries
/// changed.
json stresses(const CommandLine& line, const json& request, const json& changes)
{
  std::vector<Override> overrides = line.overrides;
  for (const std::string change : changes)
    overrides.push_back(Override::parse(change));
  const SceneMaterials materials(line.file, overrides);
  const std::string name = request.value("material", "");
  const double theta_0 = materials.named(name, {}).thermal.theta_0;
  json answer = json::array();
  for (const json& one : request.at("tests")) {
    const MaterialTest test = test_of(one, theta_0);
    std::set<double> temperatures;
    for (const Imposed& row : test.rows)
      temperatures.insert(row.theta);
    const Material& material = materials.named(name, temperatures);
    const double unit = Quantity("MPa").value("1 " + one.value("stress unit", "MPa"));
    std::vector<double> values = test.stresses(material);
    for (double& value : values)
      value /= unit;
    answer.push_back(values);
  }
  return answer;
}

/// Of every set of changes that a request has.
json answer(const CommandLine& line, const std::string& text)
{
  const auto or_error = [](const auto& action) -> json {
    try {
      return action();
    } catch (const InputError& error) {
      return {{"error", error.what()}};
    } catch (const json::exception& error) {
      return {
          {"error", "material point: the request is not understood: " + std::string(error.what())}};
    }
  };
  return or_error([&]() -> json {
    const json request = json::parse(text);
    json sets = json::array();
    for (const json& changes : request.value("sets", json::array({json::array()})))
      sets.push_back(or_error([&]() { return stresses(line, request, changes); }));
    return {{"stresses", sets}};
  });
}

} // namespace

void answer_material_tests(const CommandLine& line, std::istream& in, std::ostream& out)
{
  const SceneMaterials readable(line.file, line.overrides);
  for (std::string text; std::getline(in, text);)
    out << answer(line, text).dump() << std::endl;
}

} // namespace thelma
