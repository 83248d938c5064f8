// Nodes and shapes of quadratic cells.

#include <thelma/mesh/cell_shapes.h>

#include <deal.II/fe/fe_q.h>

#include <gtest/gtest.h>

#include <random>

namespace
{

using namespace thelma;

/// A cell of the vertices 0, 1, 2, ... in deal.II's order.
template <int dim>
dealii::CellData<dim> one_cell()
{
  dealii::CellData<dim> cell;
  for (unsigned int v = 0; v < cell.vertices.size(); ++v)
    cell.vertices[v] = v;
  return cell;
}

/// x_c = the sum of all monomials of degree 2 at most in each coordinate with random factors,
/// without those with two squares, which serendipity elements lack.
template <int dim>
std::vector<dealii::Point<dim>> bent_box()
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> factor(-0.05, 0.05);
  std::vector<dealii::Point<dim>> nodes = dealii::FE_Q<dim>(2).get_unit_support_points();
  std::vector<dealii::Point<dim>> bent = nodes;
  for (unsigned int c = 0; c < dim; ++c)
    for (int i = 0; i < (dim == 2 ? 9 : 27); ++i) {
      const int power[] = {i % 3, i / 3 % 3, i / 9};
      const int squares = (power[0] == 2) + (power[1] == 2) + (power[2] == 2);
      const double a = factor(random);
      for (std::size_t n = 0; squares < 2 && n < nodes.size(); ++n) {
        double term = a;
        for (unsigned int d = 0; d < dim; ++d)
          term *= std::pow(nodes[n][d], power[d]);
        bent[n][c] += term;
      }
    }
  return bent;
}

template <int dim>
void expect_nodes_of_edges_alone()
{
  using Geometry = dealii::GeometryInfo<dim>;
  const std::vector<dealii::Point<dim>> wanted = bent_box<dim>();
  const std::vector<dealii::Point<dim>> vertices(wanted.begin(),
                                                 wanted.begin() + Geometry::vertices_per_cell);
  Middles<dealii::Point<dim>> edges;
  for (unsigned int l = 0; l < Geometry::lines_per_cell; ++l) {
    std::vector<unsigned int> ends{Geometry::line_to_cell_vertices(l, 0),
                                   Geometry::line_to_cell_vertices(l, 1)};
    std::sort(ends.begin(), ends.end());
    edges.emplace(ends, wanted[Geometry::vertices_per_cell + l]);
  }
  const auto found = quadratic_nodes(one_cell<dim>(), vertices, edges);
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t n = 0; n < wanted.size(); ++n)
    EXPECT_LT(found[n].distance(wanted[n]), 1e-14) << n;
}

TEST(QuadraticCells, LackingNodesAreThoseOfSerendipityElements)
{
  expect_nodes_of_edges_alone<2>();
  expect_nodes_of_edges_alone<3>();
}

TEST(QuadraticCells, AreBoxesWithTheShape1)
{
  EXPECT_NEAR(shape_of_nodes(dealii::FE_Q<2>(2).get_unit_support_points()), 1., 1e-14);
  EXPECT_NEAR(shape_of_nodes(dealii::FE_Q<3>(2).get_unit_support_points()), 1., 1e-14);
}

TEST(QuadraticCells, TurnInsideOutBetweenSoundCorners)
{
  std::vector<dealii::Point<2>> nodes = dealii::FE_Q<2>(2).get_unit_support_points();
  nodes[6][1] = 0.8; // the middle of the lower edge, beyond half the height
  nodes[8][1] = 0.6;
  EXPECT_LT(shape_of_nodes(nodes), 0.);
  EXPECT_GT(shape_of_corners<2>({nodes.begin(), nodes.begin() + 4}), 0.99);
}

} // namespace
