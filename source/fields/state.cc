#include <thelma/fields/state.h>

#include <cmath>
#include <limits>

namespace thelma
{

void State::start(const double load)
{
  x.update_ghost_values();
  past = {accepted(load)};
  ++n_changes;
}

State::Accepted State::accepted(const double load) const
{
  return {load, x, internal, history()};
}

void State::resume(std::vector<Accepted> path)
{
  past = std::move(path);
  ++n_changes;
  restore();
}

void State::go_to(const Accepted& accepted)
{
  x = accepted.x;
  internal = accepted.internal;
}

void State::forget()
{
  past.pop_back();
  ++n_changes;
  restore();
}

void State::accept(const double load)
{
  if (past.size() == memory)
    past.erase(past.begin());
  past.push_back(accepted(load));
  ++n_changes;
  if (past.size() > n_remembering)
    std::vector<double>().swap(past[past.size() - n_remembering - 1].history);
}

double State::estimated_limit() const
{
  const double never = std::numeric_limits<double>::infinity();
  if (past.size() < 3)
    return never;
  const Accepted* last = past.data() + past.size() - 3;
  double arc[3] = {0., 0., 0.};
  for (int i = 1; i < 3; ++i) {
    auto step = last[i].x.block(0);
    step -= last[i - 1].x.block(0);
    arc[i] = arc[i - 1] + step.l2_norm();
  }
  // Newton's divided differences of load^2, to which displacements are proportional at first,
  // over arc length.
  double load[3];
  for (int i = 0; i < 3; ++i)
    load[i] = last[i].load * last[i].load;
  const double first = (load[1] - load[0]) / (arc[1] - arc[0]);
  const double second = ((load[2] - load[1]) / (arc[2] - arc[1]) - first) / (arc[2] - arc[0]);
  if (!(second < 0.))
    return never;
  const double vertex = (arc[0] + arc[1]) / 2. - first / (2. * second);
  return std::sqrt(load[0] + first * (vertex - arc[0]) +
                   second * (vertex - arc[0]) * (vertex - arc[1]));
}

} // namespace thelma
