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

  unsigned int n_history() const { return n; }

  /// Instantaneous less equilibrium shear modulus in MPa.
  double modulus(double theta) const;

  /// The entry, such as `Branch 1/Modulus`, that does not allow @p theta; empty if all is well.
  std::string defect(double theta) const;

  /// PointHistory::old, of all branches, for differences of second order with the weight @p q of
  /// old - older.
  void begin_step(const double* old, const double* older, double q, double* start) const;

  /// The values at the end of a step.
  void update_history(const Tensor3<2>& F, double theta, const PointHistory<>& history,
                      double* now) const;

  /// The sum of their incremental potentials, but for a constant.
  template <typename Number>
  Number W(const Tensor3<2, Number>& F, const Number& J, const Number& theta,
           const PointHistory<Given<Number>>& history) const
  {
    Number sum = 0.;
    if (acts(history)) {
      const IsochoricStrain<Number> strain(F, J);
      for_each(history,
               [&](const auto& branch, const auto& own) { sum += branch.W(strain, theta, own); });
    }
    return sum;
  }

  /// Add what they store, and the derivatives of W.
  template <typename Number>
  void add_first(const Tensor3<2, Number>& F, const Kinematics<Number>& kin, const Number& theta,
                 const PointHistory<Given<Number>>& history, ElasticDerivatives<Number>& d) const
  {
    if (!acts(history))
      return;
    const IsochoricStrain<Number> strain(F, kin.J);
    for_each(history, [&](const auto& branch, const auto& own) {
      branch.add_first(F, kin, strain, theta, own, d);
    });
  }

  template <typename Number>
  void add_second(const Tensor3<2, Number>& F, const Kinematics<Number>& kin, const Number& theta,
                  const PointHistory<Given<Number>>& history, Tensor3<4, Number>& W_FF) const
  {
    if (!acts(history))
      return;
    const IsochoricStrain<Number> strain(F, kin.J);
    for_each(history, [&](const auto& branch, const auto& own) {
      branch.add_second(F, kin, strain, theta, own, W_FF);
    });
  }

private:
  template <typename Value>
  bool acts(const PointHistory<Value>& history) const
  {
    return n > 0 && !history.is_relaxed();
  }

  /// Call @p visit(law of a branch, its part of the history).
  template <typename Value, typename Visitor>
  void for_each(PointHistory<Value> history, const Visitor& visit) const
  {
    for (const Branch& branch : list)
      std::visit(
          [&](const auto& law) {
            visit(law, history);
            if (history.old)
              history.old += std::decay_t<decltype(law)>::n_history;
          },
          branch);
  }

  std::vector<Branch> list;
  unsigned int n = 0;
};

} // namespace thelma
