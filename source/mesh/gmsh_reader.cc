#include <thelma/base/child_process.h>
#include <thelma/base/input_errors.h>
#include <thelma/base/memory.h>
#include <thelma/mesh/gmsh_elements.h>
#include <thelma/mesh/gmsh_parameters.h>
#include <thelma/mesh/gmsh_reader.h>
#include <thelma/mesh/physical_groups.h>
#include <thelma/mesh/subdivision.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/array.hpp>
#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>
#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace thelma
{
namespace
{

/// gmsh's library state, alive for one reading.
struct Gmsh {
  Gmsh()
  {
    gmsh::initialize(0, nullptr, false); // without the user's own settings
    gmsh::onelab::clear();               // what an earlier file was told outlives finalize()
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.NumThreads", 1);
    gmsh::option::setNumber("General.AbortOnError", 0); // errors are read from the log
    gmsh::logger::start();
  }
  ~Gmsh() { gmsh::finalize(); }
  Gmsh(const Gmsh&) = delete;
  Gmsh& operator=(const Gmsh&) = delete;

  /// Errors that gmsh only logged, joined; the first three, the others mostly follow from them.
  static std::string errors()
  {
    std::vector<std::string> log;
    gmsh::logger::get(log);
    std::string result;
    unsigned int n_errors = 0;
    for (const std::string& line : log)
      if (line.rfind("Error", 0) == 0 && ++n_errors <= 3)
        result += (result.empty() ? "" : "; ") + line.substr(line.find(':') + 2);
    return result + (n_errors > 3 ? "; and " + std::to_string(n_errors - 3) + " more" : "");
  }
};

/// What an editor or a spreadsheet may have done to a mesh; empty if nothing is seen.
std::string damage(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::string start(3, '\0');
  stream.read(start.data(), 3);
  if (start == "\xEF\xBB\xBF" || start.substr(0, 2) == "\xFF\xFE" ||
      start.substr(0, 2) == "\xFE\xFF")
    return "; it begins with a byte order mark; save it as plain UTF-8 without one";
  if (std::filesystem::path(file).extension() == ".msh")
    return "; save it again from gmsh, with decimal points";
  return "";
}

void open(const std::string& file, const std::string& entry)
{
  std::string problem;
  try {
    gmsh::open(file);
    problem = Gmsh::errors();
  } catch (const std::exception& error) {
    problem = error.what();
  }
  if (!problem.empty())
    throw InputError("section Mesh, entry '" + entry + "': gmsh cannot read '" + file +
                     (entry == "File" ? "': " : "' with these parameters: ") + problem +
                     (entry == "File" ? damage(file) : ""));
}

/// What gmsh multiplies coordinates by where it saves a mesh (Mesh.ScalingFactor).
double scaling_factor(const std::string& file)
{
  double factor = 1.;
  gmsh::option::getNumber("Mesh.ScalingFactor", factor);
  if (!(factor > 0.) || !std::isfinite(factor))
    throw InputError("section Mesh, entry 'File': '" + file + "' sets Mesh.ScalingFactor to " +
                     as_text(factor) + "; write a positive number that converts lengths to mm");
  return factor;
}

void generate(const GmshRequest& request, const int dim)
{
  std::string problem;
  try {
    make_elements(request, dim);
    problem = Gmsh::errors();
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    problem = error.what();
  }
  if (!problem.empty())
    throw InputError("section Mesh, entry 'File': gmsh cannot mesh '" + request.file +
                     "': " + problem);
}

/// Keep only vertices that belong to cells and number them consecutively.
void drop_unused_vertices(CoarseMesh& mesh, const int dim)
{
  std::vector<int> used(mesh.vertices.size(), -1);
  for (const PhysicalGroup& group : mesh.groups)
    if (group.dimension == dim)
      for (const auto& element : group.elements)
        for (const unsigned int v : element)
          used[v] = 0;
  std::vector<std::array<double, 3>> kept;
  Middles<std::array<double, 3>> middles;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v] == 0) {
      used[v] = static_cast<int>(kept.size());
      kept.push_back(mesh.vertices[v]);
    }
  for (PhysicalGroup& group : mesh.groups)
    for (auto& element : group.elements)
      for (unsigned int& v : element) {
        if (used[v] < 0)
          throw InputError("section Mesh, entry 'File': the group '" + group.name +
                           "' has a vertex that belongs to no cell of a named region");
        v = used[v];
      }
  for (const auto& [corners, point] : mesh.middles) {
    std::vector<unsigned int> numbers;
    for (const unsigned int v : corners)
      numbers.push_back(used[v]); // as ordered as before
    middles.emplace(numbers, point);
  }
  mesh.vertices = kept;
  mesh.middles = middles;
}

void require_dimension(const std::string& file, const int dim)
{
  const bool is_solid = gmsh::model::getDimension() == 3;
  if (dim == 2 && is_solid)
    throw InputError("section Mesh, entry 'File': '" + file +
                     "' has volumes, but the scene is two-dimensional; write `set Dimension = 3`");
  if (element_order() == 0)
    throw InputError("section Mesh, entry 'File': '" + file +
                     "' has no cells; mesh it, or save the mesh again");
  gmsh::vectorpair groups;
  gmsh::model::getPhysicalGroups(groups, dim);
  const auto is_region = [](const std::pair<int, int>& group) {
    std::string name;
    gmsh::model::getPhysicalName(group.first, group.second, name);
    return !name.empty();
  };
  if (std::none_of(groups.begin(), groups.end(), is_region))
    throw InputError("section Mesh, entry 'File': '" + file + "' has no named physical " +
                     (dim == 2   ? "surface as a region; name one"
                      : is_solid ? "volume as a region; name one"
                                 : "volume as a region, because it is two-dimensional; write `set "
                                   "Dimension = 2` for plane strain, or extrude it"));
}

/// The plane is that of x1 and x3.
void require_plane(const std::string& file, const CoarseMesh& mesh)
{
  double size = 0., depth = 0.;
  const auto include = [&](const std::array<double, 3>& X) {
    size = std::max(
        {size, std::abs(X[0] - mesh.vertices[0][0]), std::abs(X[2] - mesh.vertices[0][2])});
    depth = std::max(depth, std::abs(X[1] - mesh.vertices[0][1]));
  };
  std::for_each(mesh.vertices.begin(), mesh.vertices.end(), include);
  for (const auto& middle : mesh.middles)
    include(middle.second);
  if (depth > 1e-9 * size)
    throw InputError("section Mesh, entry 'File': '" + file +
                     "' leaves the plane of x1 and x3, to which Dimension = 2 is restricted; set "
                     "the second coordinate to 0");
}

/// All nodes, of which @p index gives the numbers.
std::vector<std::array<double, 3>> read_nodes(const GmshRequest& request,
                                              std::map<std::size_t, unsigned int>& index)
{
  const double scale = scaling_factor(request.file) * request.unit;
  std::vector<std::array<double, 3>> nodes;
  std::vector<std::size_t> tags;
  std::vector<double> coordinates, parametric;
  gmsh::model::mesh::getNodes(tags, coordinates, parametric);
  for (std::size_t i = 0; i < tags.size(); ++i) {
    index[tags[i]] = i;
    for (std::size_t d = 3 * i; d < 3 * i + 3; ++d)
      if (!std::isfinite(coordinates[d] *= scale))
        throw InputError("section Mesh, entry 'File': node " + std::to_string(tags[i]) + " of '" +
                         request.file + "' has the coordinate x" + std::to_string(d % 3 + 1) +
                         " = " + as_text(coordinates[d]) + "; write a finite number");
    nodes.push_back({{coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]}});
  }
  return nodes;
}

CoarseMesh read_here(const GmshRequest& request, const int dim)
{
  const Gmsh gmsh_session;
  open(request.file, "File");
  if (!request.parameters.empty()) {
    set_parameters(request.file, request.parameters);
    open(request.file, "Parameters"); // what is wrong now was not without them
  }
  const bool is_mesh = element_order() > 0;
  generate(request, dim);
  require_dimension(request.file, dim);

  CoarseMesh mesh;
  std::map<std::size_t, unsigned int> index;
  mesh.vertices = read_nodes(request, index);
  read_physical_groups(request, dim, index, mesh);
  drop_unused_vertices(mesh, dim);
  if (dim == 2)
    require_plane(request.file, mesh);
  if (!request.around.empty() && !mesh.middles.empty())
    throw InputError("section Mesh, entry 'Curved': the cells of '" + request.file +
                     "' are quadratic and so curved already; write `as meshed`, or mesh it with "
                     "Mesh.ElementOrder = 1");
  const bool is_cut_here = is_mesh && request.is_subdivided;
  if (is_cut_here)
    mesh = subdivided(mesh, "");
  for (unsigned int i = 0; i < request.refinements && (is_cut_here || !request.around.empty()); ++i)
    mesh = subdivided(mesh, request.around);
  return mesh;
}

} // namespace

CoarseMesh read_gmsh(const GmshRequest& request, const int dim)
{
  std::error_code unreachable;
  if (!std::filesystem::is_regular_file(request.file, unreachable))
    throw InputError("section Mesh, entry 'File': there is no file '" + request.file +
                     "'; give a path relative to the working directory or the parameter file");
  const auto pack = [&]() {
    const CoarseMesh mesh = read_here(request, dim);
    std::ostringstream stream;
    boost::archive::binary_oarchive(stream) << mesh;
    return stream.str();
  };
  std::istringstream packed(
      in_child_process(pack, machine_memory() / 2.,
                       "section Mesh, entry 'File': gmsh fails on '" + request.file +
                           "'; correct the geometry or its parameters, or use fewer cells"));
  CoarseMesh mesh;
  boost::archive::binary_iarchive(packed) >> mesh;
  return mesh;
}

} // namespace thelma
