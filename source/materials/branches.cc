#include <thelma/materials/branches.h>

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
    n += std::visit([](const auto& law) { return law.n_history; }, branch);
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

void Branches::begin_step(const double* old, const double* older, const double q,
                          double* start) const
{
  for (const Branch& branch : list)
    std::visit(
        [&](const auto& law) {
          law.begin_step(old, older, q, start);
          old += law.n_history;
          older += law.n_history;
          start += law.n_history;
        },
        branch);
}

void Branches::update_history(const Tensor3<2>& F, const double theta,
                              const PointHistory<>& history, double* now) const
{
  const IsochoricStrain<double> strain(F, Kinematics<>(F).J);
  for_each(history, [&](const auto& law, const PointHistory<>& own) {
    law.update_history(strain, theta, own, now);
    now += law.n_history;
  });
}

} // namespace thelma
