#include <thelma/base/error.h>
#include <thelma/mesh/gmsh_reader.h>

#include <gmsh.h>

#include <algorithm>
#include <filesystem>

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

void open(const std::string& file)
{
  std::string problem;
  try {
    gmsh::open(file);
    problem = Gmsh::errors();
  } catch (const std::exception& error) {
    problem = error.what();
  }
  if (!problem.empty())
    throw InputError("section Mesh, entry 'File': gmsh cannot read '" + file + "': " + problem);
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
  gmsh::clear();
  for (const auto& [name, value] : parameters) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw InputError("section Mesh, entry 'Parameters': '" + file + "' has no parameter '" +
                       name + "'" + known_ones(name, known));
    gmsh::onelab::setNumber(name, {value});
  }
}

void generate(const std::string& file, const unsigned int refinements, const int dim)
{
  std::vector<int> types;
  gmsh::model::mesh::getElementTypes(types);
  std::string problem;
  try {
    if (types.empty()) // a .msh brings its elements along
      gmsh::model::mesh::generate(dim);
    for (unsigned int i = 0; i < refinements; ++i)
      gmsh::model::mesh::refine();
    problem = Gmsh::errors();
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
                   const std::map<std::size_t, unsigned int>& index, const int dim)
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
                         (dim == 3 ? "hexahedra" : "quadrilaterals") +
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

} // namespace

CoarseMesh read_gmsh(const std::string& file, const std::map<std::string, double>& parameters,
                     const unsigned int refinements, const int dim)
{
  std::error_code unreachable;
  if (!std::filesystem::is_regular_file(file, unreachable))
    throw InputError("section Mesh, entry 'File': there is no file '" + file +
                     "'; give a path from the working directory or from the parameter file");
  const Gmsh gmsh_session;
  open(file);
  if (!parameters.empty()) {
    set_parameters(file, parameters);
    open(file);
  }
  generate(file, refinements, dim);

  CoarseMesh mesh;
  std::vector<std::size_t> tags;
  std::vector<double> coordinates, parametric;
  gmsh::model::mesh::getNodes(tags, coordinates, parametric);
  std::map<std::size_t, unsigned int> index;
  for (std::size_t i = 0; i < tags.size(); ++i) {
    index[tags[i]] = i;
    mesh.vertices.push_back({{coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]}});
  }

  gmsh::vectorpair groups;
  gmsh::model::getPhysicalGroups(groups);
  for (const auto& [dimension, tag] : groups) {
    PhysicalGroup group{"", dimension, {}};
    gmsh::model::getPhysicalName(dimension, tag, group.name);
    if (group.name.empty() || dimension > dim)
      continue;
    read_elements(group, tag, index, dim);
    mesh.groups.push_back(group);
  }
  const auto is_region = [&](const PhysicalGroup& g) { return g.dimension == dim; };
  if (std::none_of(mesh.groups.begin(), mesh.groups.end(), is_region))
    throw InputError("section Mesh, entry 'File': '" + file + "' has no named physical " +
                     (dim == 3 ? "volume" : "surface") + " to be a region");
  drop_unused_vertices(mesh, dim);
  return mesh;
}

} // namespace thelma
