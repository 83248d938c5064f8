// A mesh as a VTU file, with what the parameter file can name.

#include <thelma/mesh/whole_mesh.h>

#include <functional>
#include <set>
#include <sstream>

namespace thelma
{
namespace
{

struct VtuCell {
  std::vector<unsigned int> vertices; ///< in VTK's order
  int region, body;                   ///< -1: none
  double quality;
  std::string group;
};

std::string escaped(const std::string& name)
{
  const std::map<char, std::string> entities{
      {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}};
  std::string result;
  for (const char c : name)
    result += entities.count(c) > 0 ? entities.at(c) : std::string(1, c);
  return result;
}

/// VTK goes around faces, deal.II row by row.
std::vector<unsigned int> around(std::vector<unsigned int> vertices)
{
  for (std::size_t v = 2; v < vertices.size(); v += 4)
    std::swap(vertices[v], vertices[v + 1]);
  return vertices;
}

int vtk_type(const VtuCell& cell, const int dim)
{
  switch (cell.vertices.size()) {
  case 1:
    return 1;
  case 2:
    return 3;
  case 4:
    return 9;
  default:
    return dim == 3 ? 12 : 9;
  }
}

template <int dim>
std::vector<VtuCell> cells_and_groups(const WholeMesh<dim>& mesh, const MeshTable& table)
{
  std::vector<VtuCell> result;
  for (const dealii::CellData<dim>& cell : mesh.cells) {
    const MeshTable::Part& part = table.parts[cell.material_id];
    result.push_back({around(cell.vertices), static_cast<int>(part.region),
                      static_cast<int>(part.body), mesh.shape_of(cell), ""});
  }
  for (const auto& [name, places] : table.surfaces) {
    std::set<std::set<unsigned int>> drawn; // a surface inside is that of two cells
    for (const MeshTable::Place& place : places) {
      std::vector<unsigned int> vertices;
      const auto& all = mesh.cells[place.cell].vertices;
      for (unsigned int v = 0; v < all.size(); ++v)
        if (place.vertices & (1u << v))
          vertices.push_back(all[v]);
      if (drawn.insert({vertices.begin(), vertices.end()}).second)
        result.push_back({around(vertices), -1, -1, 1., name});
    }
  }
  return result;
}

void write_array(std::ostream& out, const std::string& attributes,
                 const std::vector<VtuCell>& cells,
                 const std::function<double(const VtuCell&)>& value)
{
  out << "<DataArray " << attributes << " format=\"ascii\">\n";
  for (const VtuCell& cell : cells)
    out << value(cell) << '\n';
  out << "</DataArray>\n";
}

std::string named(const std::string& type, const std::string& name)
{
  return "type=\"" + type + "\" Name=\"" + escaped(name) + "\"";
}

void write_cells(std::ostream& out, const std::vector<VtuCell>& cells, const int dim)
{
  out << "<Cells>\n<DataArray " << named("Int64", "connectivity") << " format=\"ascii\">\n";
  for (const VtuCell& cell : cells) {
    for (const unsigned int v : cell.vertices)
      out << v << ' ';
    out << '\n';
  }
  out << "</DataArray>\n";
  std::size_t end = 0;
  out.precision(15);
  write_array(out, named("Int64", "offsets"), cells,
              [&](const VtuCell& cell) { return double(end += cell.vertices.size()); });
  write_array(out, named("UInt8", "types"), cells,
              [&](const VtuCell& cell) { return vtk_type(cell, dim); });
  out << "</Cells>\n";
}

} // namespace

template <int dim>
std::string picture(const WholeMesh<dim>& mesh)
{
  const MeshTable table = mesh.table();
  const std::vector<VtuCell> cells = cells_and_groups(mesh, table);
  std::ostringstream out;
  out.precision(10);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\">\n"
      << "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" << mesh.vertices.size()
      << "\" NumberOfCells=\"" << cells.size() << "\">\n<Points>\n"
      << "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n";
  for (const dealii::Point<dim>& vertex : mesh.vertices)
    out << vertex << (dim == 2 ? " 0\n" : "\n");
  out << "</DataArray>\n</Points>\n";
  write_cells(out, cells, dim);
  out << "<CellData>\n";
  write_array(out, named("Int32", "region"), cells, [](const VtuCell& c) { return c.region; });
  write_array(out, named("Int32", "body"), cells, [](const VtuCell& c) { return c.body; });
  write_array(out, named("Float64", "quality"), cells, [](const VtuCell& c) { return c.quality; });
  for (std::size_t r = 0; r < table.regions.size(); ++r)
    write_array(out, named("UInt8", "region " + table.regions[r]), cells,
                [r](const VtuCell& c) { return c.region == static_cast<int>(r); });
  for (const auto& entry : table.surfaces)
    write_array(out, named("UInt8", "surface " + entry.first), cells,
                [&name = entry.first](const VtuCell& c) { return c.group == name; });
  out << "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  return out.str();
}

template std::string picture(const WholeMesh<2>&);
template std::string picture(const WholeMesh<3>&);

} // namespace thelma
