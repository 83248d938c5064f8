#include <thelma/base/input_errors.h>
#include <thelma/base/wording.h>
#include <thelma/mesh/gmsh_elements.h>
#include <thelma/mesh/physical_groups.h>

#include <gmsh.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

namespace thelma
{
namespace
{

const std::string place = "section Mesh, entry 'File': ";

/// As gmsh calls an entity of this dimension.
std::string kind_name(const int dimension)
{
  return dimension == 3   ? "volume"
         : dimension == 2 ? "surface"
         : dimension == 1 ? "curve"
                          : "point";
}

using Groups = std::vector<std::pair<int, int>>; ///< dimension and tag

/// The names that the file itself gives, with every group that has each: gmsh keeps one name of
/// each. In a .msh they are text, also if the rest is not.
std::map<std::string, Groups> names_of_msh(const std::string& file)
{
  std::map<std::string, Groups> result;
  std::ifstream stream(file, std::ios::binary);
  std::string line;
  while (std::getline(stream, line) && line.rfind("$PhysicalNames", 0) != 0)
    if (line.rfind("$Nodes", 0) == 0)
      return result;
  std::getline(stream, line); // how many
  while (std::getline(stream, line) && line.rfind("$End", 0) != 0) {
    std::istringstream words(line);
    int dimension = 0, tag = 0;
    const std::size_t begin = line.find('"'), end = line.rfind('"');
    if (words >> dimension >> tag && begin < end)
      result[line.substr(begin + 1, end - begin - 1)].emplace_back(dimension, tag);
  }
  return result;
}

std::map<std::string, Groups> names_of_model()
{
  std::map<std::string, Groups> result;
  gmsh::vectorpair groups;
  gmsh::model::getPhysicalGroups(groups);
  for (const auto& [dimension, tag] : groups) {
    std::string name;
    gmsh::model::getPhysicalName(dimension, tag, name);
    if (!name.empty())
      result[writable(name)].emplace_back(dimension, tag);
  }
  return result;
}

/// `surface 21 and surface 22`
std::string listed(const Groups& groups)
{
  std::string text;
  for (const auto& [dimension, tag] : groups)
    text += (text.empty() ? "" : " and ") + kind_name(dimension) + " " + std::to_string(tag);
  return text;
}

void require_one_group_a_name(const std::string& file)
{
  InputErrors errors;
  for (const auto& names : {names_of_msh(file), names_of_model()})
    for (const auto& [name, groups] : names)
      if (groups.size() > 1)
        errors.add(place + "'" + file + "' gives the same name, '" + name + "', to the physical " +
                   listed(groups) + "; give each its own name, or merge them into one group");
  errors.raise();
}

/// A partitioned mesh gives what lies between its parts to groups of the number of the whole.
bool is_end_of_partition(const int dimension, const int tag)
{
  std::vector<int> entities;
  gmsh::model::getEntitiesForPhysicalGroup(dimension, tag, entities);
  return std::all_of(entities.begin(), entities.end(), [&](const int entity) {
    std::vector<int> partitions;
    gmsh::model::getPartitions(dimension, entity, partitions);
    return partitions.size() > 1;
  });
}

void require_names(const std::string& file, const int dim)
{
  gmsh::vectorpair groups;
  gmsh::model::getPhysicalGroups(groups);
  InputErrors errors;
  for (const auto& [dimension, tag] : groups) {
    std::string name;
    gmsh::model::getPhysicalName(dimension, tag, name);
    if (name.empty() && dimension <= dim && !is_end_of_partition(dimension, tag))
      errors.add(place + "the physical " + kind_name(dimension) + " " + std::to_string(tag) +
                 " of '" + file + "' has no name; give it one, or remove it");
  }
  errors.raise();
}

std::size_t n_elements(const int dimension, const int entity)
{
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> elements, nodes;
  gmsh::model::mesh::getElements(types, elements, nodes, dimension, entity);
  std::size_t n = 0;
  for (const auto& of_type : elements)
    n += of_type.size();
  return n;
}

void require_regions_of_all_cells(const std::string& file, const int dim)
{
  gmsh::vectorpair entities;
  gmsh::model::getEntities(entities, dim);
  std::size_t n = 0;
  for (const auto& entity : entities) {
    std::vector<int> groups;
    gmsh::model::getPhysicalGroupsForEntity(dim, entity.second, groups);
    if (groups.empty())
      n += n_elements(dim, entity.second);
  }
  if (n > 0)
    throw InputError(place + std::to_string(n) + " cells of '" + file + "' belong to no physical " +
                     kind_name(dim) + "; name every " + kind_name(dim) +
                     ", or remove what is not part of the body");
}

/// How to mesh @p group without elements of this order.
std::string remedy(const PhysicalGroup& group, const int order, const bool is_subdivided)
{
  if (order > (is_subdivided ? 1 : 2))
    return "mesh it with order 1 (Mesh.ElementOrder = 1; gmsh -order 1)";
  if (is_subdivided)
    return "pyramids cannot be subdivided, mesh it with tetrahedra alone";
  return std::string("write `set Cells = subdivided`, or mesh it with ") +
         (group.dimension == 3 ? "transfinite or extruded volumes and Recombine"
                               : "Recombine Surface or Mesh.RecombineAll = 1");
}

/// The nodes of one type of element.
struct ElementType {
  ElementType(const int type, const bool is_subdivided)
  {
    const ElementProperties properties(type);
    const std::vector<double>& at = properties.at;
    const int dimension = properties.dimension, n_corners = properties.n_corners;
    order = properties.order;
    n_nodes = properties.n_nodes;
    static const std::set<std::string> boxes{"Point", "Line", "Quadrilateral", "Hexahedron"};
    static const std::set<std::string> others{"Triangle", "Tetrahedron", "Prism"};
    is_known = (order <= 2 && boxes.count(properties.shape) == 1) ||
               (order == 1 && is_subdivided && others.count(properties.shape) == 1);
    for (int node = 0; node < n_nodes; ++node) {
      corners.emplace_back();
      if (node < n_corners)
        corners.back().push_back(node);
      for (int corner = 0; node >= n_corners && corner < n_corners; ++corner) {
        bool is_end = true;
        for (int d = 0; d < dimension; ++d)
          is_end = is_end && (at[node * dimension + d] == 0. ||
                              at[node * dimension + d] == at[corner * dimension + d]);
        if (is_end)
          corners.back().push_back(corner);
      }
    }
  }

  bool is_known = false;
  int order = 1, n_nodes = 1;
  std::vector<std::vector<unsigned int>> corners; ///< that each node lies in the middle of
};

unsigned int number_of(const std::size_t node, const PhysicalGroup& group,
                       const std::map<std::size_t, unsigned int>& index)
{
  const auto found = index.find(node);
  if (found == index.end())
    throw InputError(place + "an element of '" + group.name + "' has the node " +
                     std::to_string(node) + ", which is missing in the file; save the mesh again");
  return found->second;
}

/// Add the elements of @p group, and those of their @p nodes that are no vertices to @p middles.
void add_elements(PhysicalGroup& group, const ElementType& type,
                  const std::vector<unsigned int>& nodes,
                  const std::vector<std::array<double, 3>>& points,
                  Middles<std::array<double, 3>>& middles)
{
  for (std::size_t first = 0; first < nodes.size(); first += type.n_nodes) {
    group.elements.emplace_back();
    for (int i = 0; i < type.n_nodes; ++i) {
      std::vector<unsigned int> corners;
      for (const unsigned int corner : type.corners[i])
        corners.push_back(nodes[first + corner]);
      if (corners.size() == 1)
        group.elements.back().push_back(nodes[first + i]);
      else {
        std::sort(corners.begin(), corners.end());
        middles.emplace(corners, points[nodes[first + i]]);
      }
    }
  }
}

void read_elements(PhysicalGroup& group, const int tag, const bool is_subdivided,
                   const std::map<std::size_t, unsigned int>& index, CoarseMesh& mesh)
{
  std::vector<int> entities;
  gmsh::model::getEntitiesForPhysicalGroup(group.dimension, tag, entities);
  for (const int entity : entities) {
    std::vector<int> types;
    std::vector<std::vector<std::size_t>> elements, nodes;
    gmsh::model::mesh::getElements(types, elements, nodes, group.dimension, entity);
    for (std::size_t t = 0; t < types.size(); ++t) {
      const ElementType type(types[t], is_subdivided);
      if (!type.is_known)
        throw InputError(place + "'" + group.name + "' has " + std::to_string(elements[t].size()) +
                         " elements that are not linear or quadratic " +
                         (group.dimension == 3   ? "hexahedra"
                          : group.dimension == 2 ? "quadrilaterals"
                                                 : "lines") +
                         "; " + remedy(group, type.order, is_subdivided));
      std::vector<unsigned int> numbers;
      for (const std::size_t node : nodes[t])
        numbers.push_back(number_of(node, group, index));
      add_elements(group, type, numbers, mesh.vertices, mesh.middles);
    }
  }
}

void require_cells(const std::string& file, const PhysicalGroup& region)
{
  if (region.elements.empty())
    throw InputError(place + "the region '" + region.name + "' of '" + file +
                     "' has no cells; mesh it in " + (region.dimension == 3 ? "three" : "two") +
                     " dimensions (this is automatic for a .geo without `Mesh` commands)");
}

} // namespace

void read_physical_groups(const GmshRequest& request, const int dim,
                          const std::map<std::size_t, unsigned int>& index, CoarseMesh& mesh)
{
  const std::string& file = request.file;
  require_one_group_a_name(file);
  require_names(file, dim);
  gmsh::vectorpair groups;
  gmsh::model::getPhysicalGroups(groups);
  for (const auto& [dimension, tag] : groups)
    if (dimension <= dim) {
      PhysicalGroup group{"", dimension, {}};
      gmsh::model::getPhysicalName(dimension, tag, group.name);
      if (group.name.empty())
        continue;
      group.name = writable(group.name);
      read_elements(group, tag, request.is_subdivided, index, mesh);
      if (dimension == dim)
        require_cells(file, group);
      mesh.groups.push_back(group);
    }
  require_regions_of_all_cells(file, dim);
}

} // namespace thelma
