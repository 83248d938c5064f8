#include <thelma/base/child_process.h>
#include <thelma/base/input_errors.h>
#include <thelma/base/memory.h>
#include <thelma/mesh/gmsh_parameters.h>
#include <thelma/mesh/gmsh_reader.h>
#include <thelma/mesh/halving.h>
#include <thelma/mesh/physical_groups.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/array.hpp>
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

/// Refining makes cells faster than anyone thinks.
void require_memory(const unsigned int refinements, const int dim)
{
  // To read 2.1 million hexahedra took 2.8 GB; the rest of the run takes at least as much.
  constexpr double bytes_per_cell = 2. * 1350.;
  double n_coarse = 0.;
  gmsh::option::getNumber(dim == 3 ? "Mesh.NbHexahedra" : "Mesh.NbQuadrangles", n_coarse);
  const double n_cells = n_coarse * std::pow(2., dim * static_cast<double>(refinements));
  if (n_cells * bytes_per_cell > machine_memory())
    throw InputError("section Mesh, entry 'Refinements': halving " + as_text(n_coarse) + " cells " +
                     std::to_string(refinements) + " times gives " + as_text(n_cells) +
                     ", too many for the memory of this machine (" +
                     as_text(std::round(machine_memory() / 1e9)) + " GB); refine less");
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

void generate(const std::string& file, const unsigned int refinements, const int dim,
              const bool has_arcs)
{
  std::vector<int> types;
  gmsh::model::mesh::getElementTypes(types);
  std::string problem;
  try {
    if (types.empty()) // a .msh brings its elements along
      gmsh::model::mesh::generate(dim);
    require_memory(refinements, dim);
    for (unsigned int i = 0; i < refinements && !has_arcs; ++i)
      gmsh::model::mesh::refine();
    problem = Gmsh::errors();
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    problem = error.what();
  }
  if (!problem.empty())
    throw InputError("section Mesh, entry 'File': gmsh cannot mesh '" + file + "': " + problem);
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
  mesh.vertices = kept;
}

void require_dimension(const std::string& file, const int dim)
{
  const bool is_solid = gmsh::model::getDimension() == 3;
  if (dim == 2 && is_solid)
    throw InputError("section Mesh, entry 'File': '" + file +
                     "' has volumes, but the scene is two-dimensional; write `set Dimension = 3`");
  std::vector<int> types;
  gmsh::model::mesh::getElementTypes(types);
  if (types.empty())
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
  for (const auto& X : mesh.vertices) {
    size = std::max(
        {size, std::abs(X[0] - mesh.vertices[0][0]), std::abs(X[2] - mesh.vertices[0][2])});
    depth = std::max(depth, std::abs(X[1] - mesh.vertices[0][1]));
  }
  if (depth > 1e-9 * size)
    throw InputError("section Mesh, entry 'File': '" + file +
                     "' leaves the plane of x1 and x3, to which Dimension = 2 is restricted; set "
                     "the second coordinate to 0");
}

CoarseMesh read_here(const std::string& file, const std::map<std::string, double>& parameters,
                     const unsigned int refinements, const int dim, const std::string& around)
{
  const Gmsh gmsh_session;
  open(file, "File");
  if (!parameters.empty()) {
    set_parameters(file, parameters);
    open(file, "Parameters"); // what is wrong now was not without them
  }
  generate(file, refinements, dim, !around.empty());
  require_dimension(file, dim);

  const double scale = scaling_factor(file);
  CoarseMesh mesh;
  std::vector<std::size_t> tags;
  std::vector<double> coordinates, parametric;
  gmsh::model::mesh::getNodes(tags, coordinates, parametric);
  std::map<std::size_t, unsigned int> index;
  for (std::size_t i = 0; i < tags.size(); ++i) {
    index[tags[i]] = i;
    for (std::size_t d = 3 * i; d < 3 * i + 3; ++d)
      if (!std::isfinite(coordinates[d] *= scale))
        throw InputError("section Mesh, entry 'File': node " + std::to_string(tags[i]) + " of '" +
                         file + "' has the coordinate x" + std::to_string(d % 3 + 1) + " = " +
                         as_text(coordinates[d]) + "; write a finite number");
    mesh.vertices.push_back({{coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]}});
  }
  mesh.groups = read_physical_groups(file, dim, index);
  drop_unused_vertices(mesh, dim);
  if (dim == 2)
    require_plane(file, mesh);
  for (unsigned int i = 0; i < refinements && !around.empty(); ++i)
    mesh = halved(mesh, around);
  return mesh;
}

} // namespace

CoarseMesh read_gmsh(const std::string& file, const std::map<std::string, double>& parameters,
                     const unsigned int refinements, const int dim, const std::string& around)
{
  std::error_code unreachable;
  if (!std::filesystem::is_regular_file(file, unreachable))
    throw InputError("section Mesh, entry 'File': there is no file '" + file +
                     "'; give a path relative to the working directory or the parameter file");
  const auto pack = [&]() {
    const CoarseMesh mesh = read_here(file, parameters, refinements, dim, around);
    std::ostringstream stream;
    boost::archive::binary_oarchive(stream) << mesh;
    return stream.str();
  };
  std::istringstream packed(
      in_child_process(pack, machine_memory() / 2.,
                       "section Mesh, entry 'File': gmsh fails on '" + file +
                           "'; correct the geometry or its parameters, or use fewer cells"));
  CoarseMesh mesh;
  boost::archive::binary_iarchive(packed) >> mesh;
  return mesh;
}

} // namespace thelma
