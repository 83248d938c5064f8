#include <thelma/base/error.h>
#include <thelma/base/version.h>
#include <thelma/fields/partition_independent_order.h>
#include <thelma/simulation/checkpoint.h>

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

template <int dim>
template <class Archive>
void Checkpoint<dim>::serialize(Archive& archive)
{
  archive& phases& outcome& model.state& model.loads& strategies& model.predictor& output;
  serialize_electrodes(archive);
}

template <int dim>
template <class Archive>
void Checkpoint<dim>::serialize_electrodes(Archive& archive)
{
  for (std::size_t e = 0; e < model.conditions.electrodes().size(); ++e) {
    const Electrode& electrode = model.conditions.electrodes()[e];
    bool floats = electrode.floats;
    double charge = electrode.kept_charge;
    archive& floats& charge;
    if (Archive::is_saving::value)
      continue;
    if (floats)
      model.conditions.disconnect(electrode.name, charge);
    else
      model.conditions.connect(electrode.name);
  }
}

template <int dim>
std::string Checkpoint<dim>::content()
{
  std::ostringstream content;
  {
    boost::archive::binary_oarchive archive(content);
    const std::string by = version;
    const std::uint32_t body = model.mesh.fingerprint();
    archive << by << scene << body;
    serialize(archive);
    const PartitionIndependentOrder<dim> order(model.layout);
    const std::size_t n = model.state.path().size();
    archive << n;
    for (const State::Accepted& accepted : model.state.path()) {
      const std::vector<double> x = order.collect(accepted.x),
                                internal = order.collect(accepted.internal),
                                history = order.collect(accepted.history);
      archive << accepted.load << x << internal << history;
    }
  }
  return content.str();
}

/// Why a checkpoint is not one of this run; empty if it is.
template <int dim>
std::string Checkpoint<dim>::mismatch(const std::string& by, const std::string& earlier_scene,
                                      const std::uint32_t body) const
{
  const std::string remedy = "; or start anew, without --restart";
  if (by != version)
    return "the checkpoint was written by Thelma " + by + ", not " + version +
           "; continue with that one" + remedy;
  if (scene != earlier_scene)
    return "the checkpoint belongs to another scene: `" + first_difference(earlier_scene, scene) +
           "` is now `" + first_difference(scene, earlier_scene) + "`; restore used.prm" + remedy;
  if (body != model.mesh.fingerprint())
    return "the checkpoint belongs to another mesh; restore " + mesh_file + remedy;
  return "";
}

template <int dim>
bool Checkpoint<dim>::restore(const std::string& content, const bool if_it_fits)
{
  std::istringstream stream(content);
  try {
    boost::archive::binary_iarchive archive(stream);
    std::string by, earlier_scene;
    std::uint32_t body = 0;
    archive >> by >> earlier_scene >> body;
    const std::string complaint = mismatch(by, earlier_scene, body);
    if (!complaint.empty() && if_it_fits)
      return false;
    if (!complaint.empty())
      throw InputError(complaint);
    serialize(archive);
    const PartitionIndependentOrder<dim> order(model.layout);
    std::size_t n = 0;
    archive >> n;
    std::vector<State::Accepted> path;
    for (std::size_t k = 0; k < n; ++k) {
      path.push_back(model.state.path().back());
      if (k + State::n_remembering < n)
        path[k].history.clear();
      std::vector<double> x, internal, history;
      archive >> path[k].load >> x >> internal >> history;
      if (!order.distribute(x, path[k].x) || !order.distribute(internal, path[k].internal) ||
          !order.distribute(history, path[k].history))
        throw InputError("the checkpoint belongs to another mesh; start anew, without --restart");
    }
    model.state.resume(std::move(path));
  } catch (const boost::archive::archive_exception&) {
    throw InputError("the checkpoint was written by another build of Thelma; continue with that "
                     "one, or start anew, without --restart");
  }
  return true;
}

template struct Checkpoint<2>;
template struct Checkpoint<3>;

} // namespace thelma
