#pragma once

#include <deal.II/base/parameter_handler.h>

#include <optional>
#include <string>
#include <vector>

namespace thelma
{

/// One stage of a run: a load goes to a level while the load factor goes from 0 to 1, or an
/// electrode changes.
struct Stage {
  enum class Kind { ramp, connect, disconnect };
  Kind kind = Kind::ramp;
  std::size_t load = 0;  ///< of a ramp, in the list of loads
  double level = 0.;     ///< at its end
  std::string electrode; ///< that changes
  bool is_ramp() const { return kind == Kind::ramp; }
};

/// The stages of a run, one after the other.
class Stages
{
public:
  static constexpr const char* place = "section Loading, entry 'Stages'";

  void declare(dealii::ParameterHandler& prm);

  /// @p loads are the names of all loads, empty for those that no stage drives; @p usual is the
  /// load of a scene without stages. Throws InputError.
  void read(const std::vector<std::string>& loads, const std::string& usual);

  const std::vector<Stage>& list() const { return stages; }

  bool drive(std::size_t load) const { return last_level(load).has_value(); }

  /// Where the stages leave a load that they drive.
  std::optional<double> last_level(std::size_t load) const;

  /// Whether a stage of this kind changes this electrode.
  bool change(Stage::Kind kind, const std::string& electrode) const;

  /// Ramps before the stage @p n.
  std::size_t ramps_before(std::size_t n) const;

private:
  Stage parse(const std::string& text, const std::vector<std::string>& loads) const;
  void check_that_they_go_anywhere(const std::string& voltage,
                                   const std::vector<std::string>& loads) const;

  std::vector<std::string> texts;
  std::vector<Stage> stages;
};

} // namespace thelma
