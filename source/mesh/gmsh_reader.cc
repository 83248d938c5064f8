#include <thelma/base/child_process.h>
#include <thelma/base/complaints.h>
#include <thelma/base/memory.h>
#include <thelma/mesh/gmsh_reader.h>
#include <thelma/mesh/halving.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/property_tree/json_parser.hpp>
#include <boost/serialization/array.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>
#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
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
                     (entry == "File" ? "': " : "' with these: ") + problem);
}

/// Numbers of cells and the like are declared with a whole Step: throws InputError unless @p value
/// is a multiple of it and between the Min and the Max of the parameter @p name. (To a parameter
/// without any of these gmsh gives limits of its own, which mean nothing, and no whole step.)
void require_allowed(const std::string& file, const std::string& name, const double value)
{
  std::string description;
  gmsh::onelab::get(description, name);
  std::istringstream json(description);
  boost::property_tree::ptree parameter;
  boost::property_tree::read_json(json, parameter);
  const auto refuse = [&](const std::string& remedy) {
    throw InputError("section Mesh, entry 'Parameters': '" + name + "' of '" + file + "' is " +
                     as_text(value) + " but must be " + remedy);
  };
  const double step = parameter.get("step", 0.);
  if (step < 1. || step != std::round(step))
    return;
  if (std::fmod(value, step) != 0.)
    refuse(step == 1. ? "a whole number" : "a multiple of " + as_text(step));
  if (const double least = parameter.get("min", value); value < least)
    refuse("at least " + as_text(least));
  if (const double most = parameter.get("max", value); value > most)
    refuse("at most " + as_text(most));
}

/// Parameters are the names a .geo declares with DefineConstant[ a = {1, Name "a"} ].
void set_parameters(const std::string& file, const std::map<std::string, double>& parameters)
{
  std::vector<std::string> known;
  gmsh::onelab::getNames(known);
  const auto belongs_to_gmsh = [](const std::string& n) {
    return n.find('/') != std::string::npos;
  };
  known.erase(std::remove_if(known.begin(), known.end(), belongs_to_gmsh), known.end());
  Complaints complaints;
  for (const auto& [name, value] : parameters)
    complaints.allow([&, &name = name, &value = value]() {
      if (std::find(known.begin(), known.end(), name) == known.end())
        throw InputError("section Mesh, entry 'Parameters': '" + file + "' has no parameter '" +
                         name + "'" + known_ones(name, known));
      require_allowed(file, name, value);
    });
  complaints.raise();
  gmsh::clear();
  for (const auto& [name, value] : parameters)
    gmsh::onelab::setNumber(name, {value});
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
    throw InputError("section Mesh, entry 'Refinements': " + as_text(n_coarse) + " cells halved " +
                     std::to_string(refinements) + " times are " + as_text(n_cells) +
                     ", too many for the memory of this machine (" +
                     as_text(std::round(machine_memory() / 1e9)) + " GB); refine less");
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

/// Vertices per element of the linear point, line, quadrilateral and hexahedron; 0 for any other.
unsigned int vertices_of_type(const int type)
{
  const std::map<int, unsigned int> linear{{15, 1}, {1, 2}, {3, 4}, {5, 8}};
  const auto found = linear.find(type);
  return found == linear.end() ? 0 : found->second;
}

void read_elements(PhysicalGroup& group, const int tag,
                   const std::map<std::size_t, unsigned int>& index)
{
  std::vector<int> entities;
  gmsh::model::getEntitiesForPhysicalGroup(group.dimension, tag, entities);
  for (const int entity : entities) {
    std::vector<int> types;
    std::vector<std::vector<std::size_t>> elements, nodes;
    gmsh::model::mesh::getElements(types, elements, nodes, group.dimension, entity);
    for (std::size_t t = 0; t < types.size(); ++t) {
      const unsigned int n = vertices_of_type(types[t]);
      if (n == 0)
        throw InputError("section Mesh, entry 'File': '" + group.name + "' has " +
                         std::to_string(elements[t].size()) + " elements that are not linear " +
                         (group.dimension == 3   ? "hexahedra"
                          : group.dimension == 2 ? "quadrilaterals"
                                                 : "lines") +
                         "; use transfinite or extruded meshes with Recombine");
      for (std::size_t i = 0; i < nodes[t].size(); i += n) {
        group.elements.emplace_back();
        for (std::size_t v = i; v < i + n; ++v)
          group.elements.back().push_back(index.at(nodes[t][v]));
      }
    }
  }
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
                     "' has volumes, but the scene is plane; write `set Dimension = 3`");
  gmsh::vectorpair groups;
  gmsh::model::getPhysicalGroups(groups, dim);
  const auto is_region = [](const std::pair<int, int>& group) {
    std::string name;
    gmsh::model::getPhysicalName(group.first, group.second, name);
    return !name.empty();
  };
  if (std::none_of(groups.begin(), groups.end(), is_region))
    throw InputError("section Mesh, entry 'File': '" + file + "' has no named physical " +
                     (dim == 2   ? "surface to be a region; name one"
                      : is_solid ? "volume to be a region; name one"
                                 : "volume to be a region, as it is plane; write `set Dimension = "
                                   "2` for plane strain, or extrude it"));
}

void require_cells(const std::string& file, const CoarseMesh& mesh, const int dim)
{
  for (const PhysicalGroup& group : mesh.groups)
    if (group.dimension == dim && group.elements.empty())
      throw InputError("section Mesh, entry 'File': the region '" + group.name + "' of '" + file +
                       "' has no cells; mesh it in " + (dim == 3 ? "three" : "two") +
                       " dimensions (in a .geo without `Mesh` commands that is done here)");
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
                     "' leaves the plane of x1 and x3, in which a scene of Dimension = 2 lies; "
                     "draw it with the second coordinate 0");
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

  CoarseMesh mesh;
  std::vector<std::size_t> tags;
  std::vector<double> coordinates, parametric;
  gmsh::model::mesh::getNodes(tags, coordinates, parametric);
  std::map<std::size_t, unsigned int> index;
  for (std::size_t i = 0; i < tags.size(); ++i) {
    index[tags[i]] = i;
    for (std::size_t d = 3 * i; d < 3 * i + 3; ++d)
      if (!std::isfinite(coordinates[d]))
        throw InputError("section Mesh, entry 'File': node " + std::to_string(tags[i]) + " of '" +
                         file + "' lies at x" + std::to_string(d % 3 + 1) + " = " +
                         as_text(coordinates[d]) + "; write a number there");
    mesh.vertices.push_back({{coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]}});
  }

  gmsh::vectorpair groups;
  gmsh::model::getPhysicalGroups(groups);
  for (const auto& [dimension, tag] : groups) {
    PhysicalGroup group{"", dimension, {}};
    gmsh::model::getPhysicalName(dimension, tag, group.name);
    if (group.name.empty() || dimension > dim)
      continue;
    read_elements(group, tag, index);
    mesh.groups.push_back(group);
  }
  require_cells(file, mesh, dim);
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
                     "'; give a path from the working directory or from the parameter file");
  const auto pack = [&]() {
    const CoarseMesh mesh = read_here(file, parameters, refinements, dim, around);
    std::ostringstream stream;
    boost::archive::binary_oarchive(stream) << mesh;
    return stream.str();
  };
  std::istringstream packed(
      in_child_process(pack, machine_memory() / 2.,
                       "section Mesh, entry 'File': gmsh fails on '" + file +
                           "'; mend the geometry or its parameters, or choose fewer cells"));
  CoarseMesh mesh;
  boost::archive::binary_iarchive(packed) >> mesh;
  return mesh;
}

} // namespace thelma
