#include <thelma/base/error.h>
#include <thelma/materials/homogeneous_body.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace thelma
{
namespace
{

using Numbers = std::vector<double>;

Imposed between(const Imposed& a, const Imposed& b, const double s)
{
  const auto mean = [&](const double from, const double to) { return from + s * (to - from); };
  return {mean(a.time, b.time), mean(a.stretch, b.stretch), mean(a.theta, b.theta),
          mean(a.field, b.field)};
}

/// A body with what it remembers, followed in time by extrapolation of the branches' own steps: a
/// time is gone in 1, 2, 3, ... of them, and the error's powers of their length are eliminated one
/// after the other (Aitken and Neville), until the last elimination changes nothing any more.
class Follower
{
public:
  Follower(const Material& material, const MaterialTest::Mode mode)
      : material(material), body(material, mode), now(material.n_history()), step(material.n_step())
  {
  }

  /// What is imposed has been for ever.
  bool rest(const Imposed& imposed)
  {
    if (!body.find_balance(imposed, nullptr))
      return false;
    material.update_history(body.state(), now.data());
    return true;
  }

  /// From the last row to one that is later or, after a jump, at the same time.
  bool follow(const Imposed& from, const Imposed& to)
  {
    constexpr double shortest = 1e-9;
    const double time = to.time - from.time;
    if (!(time > 0.))
      return jump(to);
    for (double s = 0.; s < 1.;) {
      const double ds = std::min(length / time, 1. - s);
      const double end = ds > (1. - shortest) * (1. - s) ? 1. : s + ds;
      const std::optional<unsigned int> columns =
          extrapolate(between(from, to, s), between(from, to, end));
      if (columns) {
        s = end;
        length = std::max(length, (*columns < columns_at_ease ? 2. : 1.) * ds * time);
      } else if (ds < shortest)
        return false;
      else
        length = 0.5 * ds * time;
    }
    return true;
  }

  double stress() const { return body.stress(); }

private:
  static constexpr unsigned int max_columns = 7, columns_at_ease = 5;
  static constexpr double tolerance = 1e-10; ///< of the internal variables, which are 1 at rest

  /// Without time to flow.
  bool jump(const Imposed& to)
  {
    material.begin_step({}, now.data(), nullptr, step.data());
    if (!body.find_balance(to, step.data()))
      return false;
    material.update_history(body.state(), now.data());
    return true;
  }

  /// The numbers after @p n steps of one length.
  bool go(const Imposed& from, const Imposed& to, const unsigned int n, Numbers& numbers)
  {
    numbers = now;
    for (unsigned int i = 1; i <= n; ++i) {
      material.begin_step({(to.time - from.time) / n, 0.}, numbers.data(), nullptr, step.data());
      if (!body.find_balance(between(from, to, double(i) / n), step.data()))
        return false;
      material.update_history(body.state(), numbers.data());
    }
    return true;
  }

  /// The columns that it has needed, if it has come to an end.
  std::optional<unsigned int> extrapolate(const Imposed& from, const Imposed& to)
  {
    const HomogeneousBody start = body;
    std::vector<Numbers> row; // of the table, the last one
    for (unsigned int n = 1; n <= max_columns; ++n) {
      std::vector<Numbers> above = std::move(row);
      row.assign(n, Numbers());
      body = start;
      if (!go(from, to, n, row[0]))
        break;
      double change = 0.;
      for (unsigned int k = 1; k < n; ++k) {
        row[k] = row[k - 1];
        change = 0.;
        for (std::size_t i = 0; i < now.size(); ++i) {
          const double less = (row[k - 1][i] - above[k - 1][i]) * (n - k) / k;
          row[k][i] += less;
          change = std::max(change, std::abs(less) / std::max(1., std::abs(row[k][i])));
        }
      }
      if (n > 1 && change < tolerance) {
        now = row.back();
        return jump(to) ? std::optional(n) : std::nullopt;
      }
    }
    body = start;
    return std::nullopt;
  }

  const Material& material;
  HomogeneousBody body;
  Numbers now, step;
  double length = std::numeric_limits<double>::infinity(); ///< that an extrapolation can take, s
};

} // namespace

std::vector<double> MaterialTest::stresses(const Material& material) const
{
  Follower follower(material, mode);
  const bool flows = in_time && material.n_history() > 0;
  std::vector<double> result;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!(i > 0 && flows ? follower.follow(rows[i - 1], rows[i]) : follower.rest(rows[i])))
      throw InputError("test '" + name + "', row " + std::to_string(i + 1) +
                       ": no stable equilibrium is found at the stretch " +
                       as_text(rows[i].stretch) + " and the field " + as_text(rows[i].field) +
                       " kV/mm");
    result.push_back(follower.stress());
  }
  return result;
}

} // namespace thelma
