#pragma once

#include <thelma/base/named_list.h>
#include <thelma/base/parameters.h>
#include <thelma/materials/maxwell_branch.h>

#include <string>
#include <variant>
#include <vector>

namespace thelma
{

/// The laws of branches with memory. A new one is a file and its class here.
using Branch = std::variant<MaxwellBranch>;

/// Branches beside the elastic law of a material, whose energies add up: a generalised Maxwell
/// element. Their internal variables follow one another.
class Branches
{
public:
  /// All laws, each with its meaning.
  static std::vector<Choice> laws();

  /// Of these laws (MaxwellBranch::name).
  explicit Branches(const std::vector<std::string>& laws = {});

  /// Declare each branch in a subsection `Branch 1`, ... of the section @p prm stands in.
  void declare(dealii::ParameterHandler& prm);

  /// How many numbers a point remembers: C_iso and theta, then those of every branch; and how many
  /// describe a step.
  unsigned int n_history() const { return n_remembered; }
  unsigned int n_step() const { return n_of_step; }

  /// Instantaneous less equilibrium shear modulus in MPa.
  double modulus(double theta) const;

  /// The entry, such as `Branch 1/Modulus`, that does not allow @p theta; empty if all is well.
  std::string defect(double theta) const;

  /// As TemperatureLaw has it, with the section of the branch.
  std::string table_defect(double theta) const;

  /// The step from the last accepted states, @p old (null: the body at rest, without time to flow)
  /// and @p older (null: there is none).
  void begin_step(const StepTimes& times, const double* old, const double* older,
                  double* step) const;

  /// The numbers at the end of the step.
  void update_history(const Tensor3<2>& F, double theta, const double* step, double* now) const;

  /// What the step has done wrong to the internal variables, which are @p now: norm over the
  /// branches.
  double step_error(const StepTimes& times, const double* old, const double* older,
                    const double* now) const;

  /// The sum of their incremental potentials, but for a constant.
  template <typename Number>
  Number W(const Tensor3<2, Number>& F, const Number& J, const Number& theta,
           const PointHistory<Given<Number>>& history) const
  {
    Number sum = 0.;
    while_flowing(F, J, history, [&](const auto& branch, const auto& strain, const auto* step) {
      sum += branch.W(strain, theta, step);
    });
    return sum;
  }

  /// Add what they store, and the derivatives of W.
  template <typename Number>
  void add_first(const Tensor3<2, Number>& F, const Kinematics<Number>& kin, const Number& theta,
                 const PointHistory<Given<Number>>& history, ElasticDerivatives<Number>& d) const
  {
    while_flowing(F, kin.J, history, [&](const auto& branch, const auto& strain, const auto* step) {
      branch.add_first(F, kin, strain, theta, step, d);
    });
  }

  /// The same and the second derivative.
  template <typename Number>
  void add_second(const Tensor3<2, Number>& F, const Kinematics<Number>& kin, const Number& theta,
                  const PointHistory<Given<Number>>& history, ElasticDerivatives<Number>& d,
                  Tensor3<4, Number>& W_FF) const
  {
    while_flowing(F, kin.J, history, [&](const auto& branch, const auto& strain, const auto* step) {
      branch.add_second(F, kin, strain, theta, step, d, W_FF);
    });
  }

  /// theta_0 times what they dissipate over a step since a point remembered @p before; likewise
  /// between two states of which it remembers @p before and @p now.
  template <typename Number>
  Dissipated<Number> dissipated(const Tensor3<2, Number>& F, const Number& J, const Number& theta,
                                const PointHistory<Given<Number>>& history,
                                const double* before) const
  {
    Dissipated<Number> sum;
    const double* of_branch = before + StrainHistory::n;
    while_flowing(F, J, history, [&](const auto& branch, const auto& strain, const auto* step) {
      branch.add_dissipated({before, of_branch}, branch.flowed(strain, theta, step), sum);
      of_branch += branch.n_history;
    });
    return sum;
  }
  Dissipated<> dissipated(const double* before, const double* now) const;

private:
  /// Unless all has relaxed, call @p visit(law, C_iso at F, numbers of its step) for every branch.
  template <typename Number, typename Visitor>
  void while_flowing(const Tensor3<2, Number>& F, const Number& J,
                     const PointHistory<Given<Number>>& history, const Visitor& visit) const
  {
    if (n_of_step == 0 || history.is_relaxed())
      return;
    const IsochoricStrain<Number> strain(F, J);
    const Given<Number>* step = history.step;
    for (const Branch& branch : list)
      std::visit(
          [&](const auto& law) {
            visit(law, strain, step);
            step += law.n_step;
          },
          branch);
  }

  std::vector<Branch> list;
  unsigned int n_remembered = 0, n_of_step = 0;
};

} // namespace thelma
