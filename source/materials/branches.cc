#include <thelma/materials/branches.h>

#include <cmath>
#include <optional>
#include <utility>

namespace thelma
{
namespace
{

/// Append the law of this name, one of the alternatives of Branch from @p i on.
template <std::size_t i = 0>
void append(const std::string& name, std::vector<Branch>& list)
{
  if constexpr (i < std::variant_size_v<Branch>) {
    if (name == std::variant_alternative_t<i, Branch>::name)
      list.emplace_back(std::in_place_index<i>);
    else
      append<i + 1>(name, list);
  }
}

template <std::size_t... i>
std::vector<Choice> choices(std::index_sequence<i...>)
{
  return {{std::variant_alternative_t<i, Branch>::name,
           std::variant_alternative_t<i, Branch>::meaning}...};
}

} // namespace

std::vector<Choice> Branches::laws()
{
  return choices(std::make_index_sequence<std::variant_size_v<Branch>>());
}

Branches::Branches(const std::vector<std::string>& laws)
{
  for (const std::string& name : laws)
    append(name, list);
  for (const Branch& branch : list)
    std::visit(
        [&](const auto& law) {
          n_remembered += law.n_history;
          n_of_step += law.n_step;
        },
        branch);
  if (!list.empty())
    n_remembered += StrainHistory::n;
}

void Branches::declare(dealii::ParameterHandler& prm)
{
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Section section(prm, {"Branch " + std::to_string(i + 1)});
    std::visit([&](auto& law) { law.declare(prm); }, list[i]);
  }
}

double Branches::modulus(const double theta) const
{
  double sum = 0.;
  for (const Branch& branch : list)
    sum += std::visit([&](const auto& law) { return law.modulus(theta); }, branch);
  return sum;
}

std::string Branches::defect(const double theta) const
{
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string entry =
        std::visit([&](const auto& law) { return law.defect(theta); }, list[i]);
    if (!entry.empty())
      return "Branch " + std::to_string(i + 1) + "/" + entry;
  }
  return "";
}

std::string Branches::table_defect(const double theta) const
{
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string defect =
        std::visit([&](const auto& law) { return law.table_defect(theta); }, list[i]);
    if (!defect.empty())
      return "/Branch " + std::to_string(i + 1) + defect;
  }
  return "";
}

void Branches::begin_step(const StepTimes& times, const double* old, const double* older,
                          double* step) const
{
  const double* of_branch = old ? old + StrainHistory::n : nullptr;
  std::optional<StrainHistory> strain;
  if (old && times.dt > 0.)
    strain.emplace(times, old, older);
  for (const Branch& branch : list)
    std::visit(
        [&](const auto& law) {
          if (strain)
            law.begin_step(*strain, of_branch, step);
          else
            law.stand_still(of_branch, step);
          step += law.n_step;
          if (of_branch)
            of_branch += law.n_history;
        },
        branch);
}

void Branches::update_history(const Tensor3<2>& F, const double theta, const double* step,
                              double* now) const
{
  if (list.empty())
    return;
  const IsochoricStrain<double> strain(F, Kinematics<>(F).J);
  put_symmetric(strain.C, now);
  now[n_symmetric] = theta;
  now += StrainHistory::n;
  for (const Branch& branch : list)
    std::visit(
        [&](const auto& law) {
          law.update_history(strain, step, now);
          now += law.n_history;
          if (step)
            step += law.n_step;
        },
        branch);
}

Dissipated<> Branches::dissipated(const double* before, const double* now) const
{
  Dissipated<> sum;
  std::size_t k = StrainHistory::n;
  for (const Branch& branch : list)
    std::visit(
        [&](const auto& law) {
          law.add_dissipated({before, before + k}, {now, now + k}, sum);
          k += law.n_history;
        },
        branch);
  return sum;
}

double Branches::step_error(const StepTimes& times, const double* old, const double* older,
                            const double* now) const
{
  if (list.empty())
    return 0.;
  StrainHistory strain(times, old, older);
  strain.arrive(now);
  old += StrainHistory::n;
  now += StrainHistory::n;
  double square = 0.;
  for (const Branch& branch : list)
    std::visit(
        [&](const auto& law) {
          square += std::pow(law.error(strain, old, now), 2);
          old += law.n_history;
          now += law.n_history;
        },
        branch);
  return std::sqrt(square);
}

} // namespace thelma
