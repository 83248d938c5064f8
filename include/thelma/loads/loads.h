#pragma once

#include <thelma/loads/amplitude.h>
#include <thelma/loads/load.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace thelma
{

/// All loads of a scene.
template <int dim>
class Loads
{
public:
  Loads();

  void declare(dealii::ParameterHandler& prm);

  /// Their names, empty for those that no stage drives.
  std::vector<std::string> stage_names() const;

  /// Set up every load; in a scene that evolves up to the time @p end (s) their amplitudes are
  /// known over all of it. Throws InputError.
  void setup(const LoadInput<dim>& input);
  void read_amplitudes(std::optional<double> end);

  /// Throws InputError where stages and loads do not fit together; both must stand.
  void check(const Stages& stages) const;

  /// Throws InputError for amplitudes that lead to impossible levels up to the time @p end (s).
  void check_levels(double end) const;

  std::size_t size() const { return items.size(); }
  const Load<dim>& operator[](const std::size_t index) const { return *items[index].load; }
  std::size_t index(const std::string& name) const;

  /// Write into the iterate what supports and loads prescribe.
  void prescribe(State& state) const;

  /// Write into a converged state what it tells of the loads.
  void observe(State& state) const;

  /// Add @p factor times the nodal forces (N, minus uC, mW) of the loads on those fields that
  /// @p counts, at the nodal values @p x, to @p nodal; compress(add) comes later.
  using Counts = std::function<bool(Field)>;
  void add_forces(double factor, const State& state, const BlockVector& x, const Counts& counts,
                  BlockVector& nodal) const;
  void add_tangent(const State& state, const Counts& counts, TangentEntries<dim>& tangent) const;

  /// What enters the body through loads.
  HeatInflow heat_inflow(const DofLayout<dim>& layout, const State& state) const;

  /// Work in mJ of forces and charges that are given, by the trapezoidal rule between two accepted
  /// states: levels, time in s and nodal values.
  struct Accepted {
    const std::vector<double>& levels;
    double time;
    const BlockVector& x;
  };
  double work(const DofLayout<dim>& layout, const State& state, const Accepted& before,
              const Accepted& now) const;

  std::vector<double> levels() const;
  void set_levels(const std::vector<double>& levels);

  /// The present levels with those that the heating drives at @p level.
  std::vector<double> heated_to(double level) const;

  /// Levels at the @p time (s): where the stages leave them, times the amplitude.
  std::vector<double> levels_at(double time) const;

  /// Of one load; 1 where it has none.
  double amplitude(std::size_t index, double time) const;

  /// Whether the scene gives an amplitude, and those that multiply nothing, each with the reason.
  bool has_amplitudes() const;
  std::map<std::string, std::string> unused_amplitudes() const;

  /// Times in s that steps must meet, and between which the amplitudes are nearly straight.
  const AmplitudeTimes& amplitude_times() const { return times; }

  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    std::vector<double> now = levels();
    archive& now;
    set_levels(now);
  }

private:
  struct Item {
    std::string name;
    std::unique_ptr<Load<dim>> load;
    double last = 1.; ///< level at the end of the stages
  };
  struct GivenAmplitude {
    std::string name, meaning, text;
    std::optional<Amplitude> amplitude;
    std::string entry() const { return name + " amplitude"; }
  };

  std::vector<Item> items;
  std::vector<GivenAmplitude> amplitudes;
  AmplitudeTimes times;
  const BoundaryConditions<dim>* conditions = nullptr;
};

/// Something that takes the iterate along as a load factor changes.
class LoadPath
{
public:
  virtual ~LoadPath() = default;

  /// Write into the iterate what belongs to the @p load factor.
  virtual void go_to(double load) = 0;
};

/// The straight way of the loads from some levels to others, while the load factor goes from 0
/// to 1.
template <int dim>
class Ramp final : public LoadPath
{
public:
  Ramp(Loads<dim>& loads, State& state) : loads(loads), state(state) {}

  /// From the present levels to those @p to.
  void start(std::vector<double> to)
  {
    from = loads.levels();
    end = std::move(to);
  }

  /// From the present levels on, one load to the level @p to.
  void start(const std::size_t index, const double to)
  {
    start(loads.levels());
    end[index] = to;
  }

  bool leads_anywhere() const { return from != end; }
  const std::vector<double>& target() const { return end; }
  double level(const std::size_t index, const double load) const
  {
    return from[index] + load * (end[index] - from[index]);
  }

  void go_to(double load) override;

  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive& from& end;
  }

private:
  Loads<dim>& loads;
  State& state;
  std::vector<double> from, end;
};

} // namespace thelma
