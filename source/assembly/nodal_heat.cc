#include <thelma/assembly/nodal_heat.h>
#include <thelma/base/error.h>
#include <thelma/base/parameters.h>
#include <thelma/base/quantity.h>
#include <thelma/fields/outer_faces.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace thelma
{

template <int dim>
void NodalHeat<dim>::declare(dealii::ParameterHandler& prm)
{
  const Section section(prm, {"Heat"});
  add_quantity(prm, "Flux", fluxes,
               "Heat flux into the body through surfaces, per area of the undeformed surface, as "
               "`outer: 0.5`.",
               Quantity("mW/mm^2"));
  add_quantity(
      prm, "Convection", convections,
      "Coefficient h of the heat loss h (theta - theta_inf) of surfaces, as `outer: 0.02`.",
      Quantity("mW/(mm^2 K)", 0.));
  add_quantity(prm, "Surroundings", surroundings,
               "Temperature theta_inf around the surfaces with convection.",
               Quantity("K", 1., 1e4));
  add_quantity(prm, "Source", sources, "Heat source R of regions.", Quantity("mW/mm^3"));
}

template <int dim>
void NodalHeat<dim>::setup(const Mesh<dim>& mesh, const FieldLayout<dim>& layout,
                           const BoundaryConditions<dim>& conditions)
{
  exists = layout.has(Field::temperature);
  if (!exists) {
    for (const auto& [entry, values] : {std::pair("Flux", &fluxes),
                                        {"Convection", &convections},
                                        {"Surroundings", &surroundings},
                                        {"Source", &sources}})
      if (!values->empty())
        throw InputError("section Heat, entry '" + std::string(entry) +
                         "': there is no temperature field that heat could change; choose Model = "
                         "steady or transient in the section Temperature");
    return;
  }
  if (!layout.is_transient() && conditions.heated().empty() && convections.empty())
    throw InputError("section Temperature, entry 'Fixed': a steady temperature field needs a "
                     "surface of known temperature or with convection");
  block = layout.block(Field::temperature);
  for (BlockVector* v : {&capacities, &powers, &conductances, &ambient})
    *v = layout.new_vector();
  lump(
      layout, [](const Cell<dim>& cell) { return cell.material->thermal.c; }, capacities);
  collect_sources(mesh, layout);
  std::set<std::string> names;
  for (const auto* entries : {&fluxes, &convections, &surroundings})
    for (const auto& entry : *entries)
      names.insert(entry.first);
  for (const std::string& name : names)
    collect_surface(mesh, layout, name, properties(name));
  for (BlockVector* v : {&capacities, &powers, &conductances, &ambient})
    v->compress(dealii::VectorOperation::add);
  const auto begin = capacities.get_block_indices().block_start(block);
  const auto& nodes = *capacities.block(block).get_partitioner();
  walls.clear();
  for (const auto& entry : conditions.heated())
    if (nodes.in_local_range(entry.first - begin))
      walls.push_back(nodes.global_to_local(entry.first - begin));
}

template <int dim>
typename NodalHeat<dim>::Surface NodalHeat<dim>::properties(const std::string& name) const
{
  const bool convects = convections.count(name) > 0;
  if (convects != (surroundings.count(name) > 0))
    throw InputError("section Heat, entry '" +
                     std::string(convects ? "Convection" : "Surroundings") + "': surface '" + name +
                     "' needs a coefficient and a temperature around it; write the other one into "
                     "section Heat, entry '" +
                     std::string(convects ? "Surroundings" : "Convection") + "'");
  const auto value = [&](const std::map<std::string, double>& entries) {
    const auto found = entries.find(name);
    return found == entries.end() ? 0. : found->second;
  };
  return {value(fluxes), value(convections), value(surroundings)};
}

/// Add to the temperature's entries of @p nodal the integrals of @p density(cell) times their shape
/// functions, taken at the nodes.
template <int dim>
void NodalHeat<dim>::lump(const FieldLayout<dim>& layout,
                          const std::function<double(const Cell<dim>&)>& density,
                          BlockVector& nodal) const
{
  dealii::FEValues<dim> values(layout.mapping(), layout.scalar_element(),
                               dealii::QGaussLobatto<dim>(layout.degree() + 1),
                               dealii::update_values | dealii::update_JxW_values);
  for (const Cell<dim>& cell : layout.cells()) {
    values.reinit(typename dealii::Triangulation<dim>::active_cell_iterator(cell.iterator));
    const double amount = density(cell);
    for (unsigned int a = 0; a < values.dofs_per_cell; ++a)
      for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
        nodal(cell.dofs[(a + 1) * cell.n_components - 1]) +=
            amount * values.JxW(q) * values.shape_value(a, q);
  }
}

template <int dim>
void NodalHeat<dim>::collect_sources(const Mesh<dim>& mesh, const FieldLayout<dim>& layout)
{
  const std::string place = "section Heat, entry 'Source'";
  const auto& regions = mesh.regions();
  for (const auto& entry : sources)
    if (std::find(regions.begin(), regions.end(), entry.first) == regions.end())
      throw InputError(place + ": the mesh has no region '" + entry.first + "'" +
                       known_ones(entry.first, regions));
  const auto source = [&](const Cell<dim>& cell) {
    const auto found = sources.find(mesh.region_of(cell.iterator));
    return found == sources.end() ? 0. : found->second;
  };
  if (!sources.empty())
    lump(layout, source, powers);
}

template <int dim>
void NodalHeat<dim>::collect_surface(const Mesh<dim>& mesh, const FieldLayout<dim>& layout,
                                     const std::string& name, const Surface& surface)
{
  const unsigned int component = layout.first_component(Field::temperature);
  const bool outer = for_each_outer_face(
      mesh, layout, name, "section Heat", dealii::QGaussLobatto<dim - 1>(layout.degree() + 1),
      [&](const OuterFace<dim>& face) {
        for (unsigned int a = 0; a < face.values.dofs_per_cell; ++a) {
          double area = 0.;
          for (unsigned int q = 0; q < face.values.n_quadrature_points; ++q)
            area += face.values.JxW(q) * face.values.shape_value(a, q);
          const auto unknown = face.unknown(a, component);
          if (std::abs(area) > 0.) {
            powers(unknown) += area * surface.flux;
            conductances(unknown) += area * surface.convection;
            ambient(unknown) += area * surface.convection * surface.ambient;
          }
        }
      });
  if (!outer)
    throw InputError("section Heat: '" + name +
                     "' is no outer surface of the body; heat can flow only through these");
}

template <int dim>
void NodalHeat<dim>::apply(const double theta_start, const double part, const double multiple)
{
  start = theta_start;
  warming = part;
  power = multiple;
}

template <int dim>
void NodalHeat<dim>::add_residual(const State& state, BlockVector& residual) const
{
  if (!exists)
    return;
  auto& r = residual.block(block);
  for (unsigned int i = 0; i < r.locally_owned_size(); ++i)
    r.local_element(i) += given(state, i) + storage(state, i);
}

/// What leaves a node, by its local number, through the surface less what its sources make, in mW.
template <int dim>
double NodalHeat<dim>::given(const State& state, const unsigned int i) const
{
  const double above = state.x.block(block).local_element(i) - (1. - warming) * start;
  return conductances.block(block).local_element(i) * above -
         warming * ambient.block(block).local_element(i) -
         power * powers.block(block).local_element(i);
}

/// What a node stores, in mW.
template <int dim>
double NodalHeat<dim>::storage(const State& state, const unsigned int i) const
{
  if (!state.rates)
    return 0.;
  const auto& path = state.path();
  const auto past = [&](const std::size_t k) {
    return path[path.size() - 1 - k].x.block(block).local_element(i);
  };
  const double now = state.x.block(block).local_element(i);
  const double rate =
      state.rates->heat == StructuralHeat::entropy
          ? now * state.rates->of(
                      0., [&](const std::size_t k) { return std::log1p((past(k) - now) / now); })
          : state.rates->of(now, past);
  return capacities.block(block).local_element(i) * rate;
}

template <int dim>
void NodalHeat<dim>::add_tangent(const State& state, TangentMatrix<dim>& tangent) const
{
  if (!exists)
    return;
  const auto begin = capacities.get_block_indices().block_start(block);
  const auto& theta = state.x.block(block);
  const auto& path = state.path();
  for (const auto i : theta.locally_owned_elements()) {
    double slope = conductances.block(block)(i);
    if (state.rates) {
      double rate = state.rates->weights[0];
      if (state.rates->heat == StructuralHeat::entropy)
        rate += state.rates->of(0., [&](const std::size_t k) {
          return std::log(path[path.size() - 1 - k].x.block(block)(i) / theta(i));
        });
      slope += rate * capacities.block(block)(i);
    }
    tangent.add_diagonal(begin + i, slope);
  }
}

template <int dim>
double NodalHeat<dim>::storage_scale(const State& state) const
{
  return state.rates ? state.rates->weights[0] * capacities.block(block).l2_norm() : 0.;
}

template <int dim>
HeatInflow NodalHeat<dim>::inflow(const State& state) const
{
  const auto& theta = state.x.block(block);
  std::vector<double> own{0., 0.}, sum(2);
  const auto add = [&](const double heat, const unsigned int i) {
    own[0] += heat;
    own[1] += heat / theta.local_element(i);
  };
  for (unsigned int i = 0; i < theta.locally_owned_size(); ++i)
    add(-given(state, i), i);
  for (const unsigned int i : walls)
    add(-storage(state, i), i);
  dealii::Utilities::MPI::sum(own, theta.get_mpi_communicator(), sum);
  return {sum[0], sum[1]};
}

template <int dim>
Energies NodalHeat<dim>::stored(const State& state, const double theta_0) const
{
  Energies sum;
  for (unsigned int i = 0; i < state.x.block(block).locally_owned_size(); ++i)
    add_stored(state, theta_0, i, sum);
  return sum;
}

template <int dim>
Energies NodalHeat<dim>::stored_in_walls(const State& state, const double theta_0) const
{
  Energies sum;
  for (const unsigned int i : walls)
    add_stored(state, theta_0, i, sum);
  return sum;
}

template <int dim>
void NodalHeat<dim>::add_stored(const State& state, const double theta_0, const unsigned int i,
                                Energies& sum) const
{
  const double C = capacities.block(block).local_element(i);
  const double theta = state.x.block(block).local_element(i);
  sum.thermal += C * (theta - theta_0);
  sum.entropy += C * std::log(theta / theta_0);
}

template class NodalHeat<2>;
template class NodalHeat<3>;

} // namespace thelma
