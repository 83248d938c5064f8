// What decides how a run goes on, to a checkpoint and back. Between two steps that is little: the
// next one makes a tangent of its own and prescribes what belongs to its load.

#include <thelma/base/error.h>
#include <thelma/base/stop_signal.h>
#include <thelma/base/version.h>
#include <thelma/fields/mesh_order.h>
#include <thelma/problem.h>

#include <deal.II/base/mpi.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/array.hpp>
#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <sstream>

namespace thelma
{
namespace
{

/// The first line of @p now that is another one in @p before.
std::string first_difference(const std::string& now, const std::string& before)
{
  std::istringstream a(now), b(before);
  std::string line, other;
  while (std::getline(a, line)) {
    std::getline(b, other);
    if (line != other)
      break;
    line.clear();
  }
  const std::size_t start = line.find_first_not_of(' ');
  return start == std::string::npos ? "end" : line.substr(start, line.find(" #") - start);
}

} // namespace

/// Between two steps: leave a checkpoint if it is time for one. Whether the run was asked to stop.
template <int dim>
bool Problem<dim>::stops()
{
  const MPI_Comm comm = layout.communicator();
  // The clocks of the ranks differ.
  const bool is_due =
      dealii::Utilities::MPI::this_mpi_process(comm) == 0 && results.checkpoint_is_due();
  const int wish = dealii::Utilities::MPI::max(stop_requested() ? 2 : is_due ? 1 : 0, comm);
  if (wish > 0)
    save();
  if (wish == 2)
    outcome.end(EndReason::stopped, "; " + results.advice());
  return wish == 2;
}

template <int dim>
template <class Archive>
void Problem<dim>::keep(Archive& archive)
{
  archive& part& n_stages& on_arc& levels& present& first_load;
  archive& last_failure& last_unstable& outcome& state& heating& stepper& predictor;
  archive& path_following& transient& results;
  keep_electrodes(archive);
}

template <int dim>
template <class Archive>
void Problem<dim>::keep_electrodes(Archive& archive)
{
  for (std::size_t e = 0; e < conditions.electrodes().size(); ++e) {
    const Electrode& electrode = conditions.electrodes()[e];
    bool floats = electrode.floats;
    double charge = electrode.kept_charge;
    archive& floats& charge;
    if (Archive::is_saving::value)
      continue;
    if (floats)
      conditions.disconnect(electrode.name, charge);
    else
      conditions.connect(electrode.name);
  }
}

template <int dim>
void Problem<dim>::save()
{
  std::ostringstream content;
  {
    boost::archive::binary_oarchive archive(content);
    const std::string by = version, scene = parameters();
    const std::uint32_t body = mesh.fingerprint();
    archive << by << scene << body;
    keep(archive);
    const MeshOrder<dim> order(layout);
    const std::size_t n = state.path().size();
    archive << n;
    for (const State::Accepted& accepted : state.path()) {
      const std::vector<double> x = order.collect(accepted.x),
                                internal = order.collect(accepted.internal),
                                history = order.collect(accepted.history);
      archive << accepted.load << x << internal << history;
    }
  }
  results.write_checkpoint(content.str());
}

/// Why a checkpoint is not one of this run; empty if it is.
template <int dim>
std::string Problem<dim>::misfit(const std::string& by, const std::string& scene,
                                 const std::uint32_t body) const
{
  const std::string remedy = "; or start anew, without --restart";
  if (by != version)
    return "the checkpoint was written by Thelma " + by + ", not " + version +
           "; continue with that one" + remedy;
  if (scene != parameters())
    return "the checkpoint belongs to another scene: `" + first_difference(scene, parameters()) +
           "` is now `" + first_difference(parameters(), scene) + "`; restore used.prm" + remedy;
  if (body != mesh.fingerprint())
    return "the checkpoint belongs to another mesh; restore " + mesh.path(scene_folder) + remedy;
  return "";
}

template <int dim>
bool Problem<dim>::resume(const bool if_it_fits)
{
  const std::optional<std::string> content = results.read_checkpoint(
      if_it_fits ? std::vector<std::string>{"/proc/self/exe"} : std::vector<std::string>());
  if (!content)
    return false;
  std::istringstream stream(*content);
  try {
    boost::archive::binary_iarchive archive(stream);
    std::string by, scene;
    std::uint32_t body = 0;
    archive >> by >> scene >> body;
    const std::string complaint = misfit(by, scene, body);
    if (!complaint.empty() && if_it_fits)
      return false;
    if (!complaint.empty())
      throw InputError(complaint);
    keep(archive);
    const MeshOrder<dim> order(layout);
    std::size_t n = 0;
    archive >> n;
    std::vector<State::Accepted> path;
    for (std::size_t k = 0; k < n; ++k) {
      path.push_back(state.path().back());
      std::vector<double> x, internal, history;
      archive >> path[k].load >> x >> internal >> history;
      if (!order.distribute(x, path[k].x) || !order.distribute(internal, path[k].internal) ||
          !order.distribute(history, path[k].history))
        throw InputError("the checkpoint belongs to another mesh; start anew, without --restart");
    }
    state.resume(std::move(path));
  } catch (const boost::archive::archive_exception&) {
    throw InputError("the checkpoint was written by another build of Thelma; continue with that "
                     "one, or start anew, without --restart");
  }
  // What no later step prescribes.
  conditions.set_motion(levels.motion);
  if (dead_loads.exist())
    system.set_loads(levels.force, dead_loads.nodal());
  pressure.apply(levels.pressure);
  if (part == Part::loads)
    nodal_heat.apply(theta_start, 1., 1.);
  return resumes = true;
}

#define INSTANTIATE(dim)                                                                           \
  template bool Problem<dim>::stops();                                                             \
  template bool Problem<dim>::resume(bool);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

} // namespace thelma
