#include <thelma/base/error.h>
#include <thelma/base/parameters.h>
#include <thelma/loads/stages.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace thelma
{
namespace
{

/// "a, b or c" of those that are not empty.
std::string alternatives(std::vector<std::string> words)
{
  words.erase(std::remove(words.begin(), words.end(), ""), words.end());
  const std::string last = words.back();
  words.pop_back();
  return comma_separated(words) + " or " + last;
}

} // namespace

void Stages::declare(dealii::ParameterHandler& prm)
{
  using namespace dealii::Patterns;
  prm.add_parameter("Stages", texts,
                    "What happens one after the other: `voltage 1` or `charge 1` goes to this "
                    "multiple of Target, `force 1`, `pressure 1` or another load to this "
                    "multiple of what the section Loads gives, `move 1` takes Supports/Moved along "
                    "this part of their way, `disconnect NAME` lets an electrode float with its "
                    "charge and `connect NAME` drives it from its potential. Empty: `voltage 1`, "
                    "or `charge 1`.",
                    List(Anything(), 0, 100));
}

void Stages::read(const std::vector<std::string>& loads, const std::string& usual)
{
  stages.clear();
  if (texts.empty()) {
    stages.push_back(parse(usual + " 1", loads));
    return;
  }
  for (const std::string& text : texts)
    stages.push_back(parse(text, loads));
  check_that_they_go_anywhere("voltage", loads);
}

Stage Stages::parse(const std::string& text, const std::vector<std::string>& loads) const
{
  const std::size_t blank = std::min(text.rfind(' '), text.size());
  const std::string name = dealii::Utilities::trim(text.substr(0, blank)),
                    rest = text.substr(blank);
  std::istringstream words(rest);
  const auto found = std::find(loads.begin(), loads.end(), name);
  Stage stage;
  bool is_read = false;
  if (name == "connect" || name == "disconnect") {
    stage.kind = name == "connect" ? Stage::Kind::connect : Stage::Kind::disconnect;
    is_read = static_cast<bool>(words >> stage.electrode);
  } else if (!name.empty() && found != loads.end()) {
    stage.load = found - loads.begin();
    is_read = static_cast<bool>(words >> stage.level);
  }
  if (!is_read || !(words >> std::ws).eof())
    throw InputError(std::string(place) + ": '" + text + "' is no stage; write " +
                     alternatives(loads) +
                     " with a number, or connect or disconnect with an electrode");
  return stage;
}

/// Throws InputError for a stage that is where it goes to.
void Stages::check_that_they_go_anywhere(const std::string& voltage,
                                         const std::vector<std::string>& loads) const
{
  const std::size_t electric = std::find(loads.begin(), loads.end(), voltage) - loads.begin();
  std::map<std::size_t, double> levels;
  for (std::size_t load = 0; load < loads.size(); ++load)
    levels[load] = 0.;
  for (std::size_t n = 0; n < stages.size(); ++n) {
    const Stage& stage = stages[n];
    if (stage.kind == Stage::Kind::connect)
      levels.erase(electric); // it becomes what the electrode has
    if (!stage.is_ramp())
      continue;
    const auto now = levels.find(stage.load);
    if (now != levels.end() && now->second == stage.level)
      throw InputError(std::string(place) + ": '" + texts[n] +
                       "' changes nothing, as it is there already; remove it or write another "
                       "number");
    levels[stage.load] = stage.level;
  }
}

std::optional<double> Stages::last_level(const std::size_t load) const
{
  std::optional<double> level;
  for (const Stage& stage : stages)
    if (stage.is_ramp() && stage.load == load)
      level = stage.level;
  return level;
}

bool Stages::change(const Stage::Kind kind, const std::string& electrode) const
{
  return std::any_of(stages.begin(), stages.end(), [&](const Stage& stage) {
    return stage.kind == kind && stage.electrode == electrode;
  });
}

std::size_t Stages::ramps_before(const std::size_t n) const
{
  return std::count_if(stages.begin(), stages.begin() + static_cast<std::ptrdiff_t>(n),
                       [](const Stage& stage) { return stage.is_ramp(); });
}

} // namespace thelma
