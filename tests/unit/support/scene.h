#pragma once

#include <thelma/assembly/system.h>
#include <thelma/fields/partition_independent_order.h>
#include <thelma/loads/prescribed.h>

#include <random>
#include <string>

namespace thelma_test
{

using namespace thelma;

/// A scene built from the text of a parameter file, up to the assembled system.
template <int dim>
struct TestScene {
  explicit TestScene(const std::string& text, const double theta = 293.)
      : file(ParameterFile::from_text(text)), materials(file), mesh(MPI_COMM_WORLD),
        system(layout, conditions, loads, storage, state, timings)
  {
    dealii::ParameterHandler prm;
    materials.declare(prm);
    mesh.declare(prm);
    layout.declare(prm);
    conditions.declare(prm);
    loads.declare(prm);
    system.declare(prm);
    file.read(prm);
    mesh.read(THELMA_SOURCE_DIR);
    layout.setup(mesh, materials);
    conditions.setup(mesh, layout);
    loads.setup({mesh, layout, &conditions, nullptr, 0., theta});
    storage.setup(layout, conditions);
    std::vector<double> levels = loads.levels();
    for (std::size_t i = 0; i < loads.size(); ++i)
      if (loads[i].acts_on() == Field::temperature)
        levels[i] = 1.;
    loads.set_levels(levels);
    state.theta = theta;
    state.x = layout.new_vector();
    if (layout.has(Field::temperature))
      state.x.block(layout.block(Field::temperature)) = theta;
    system.choose();
    system.setup();
    state.start();
  }

  /// Supports and walls at their values, electrodes at this voltage in kV.
  void apply_voltage(const double voltage)
  {
    conditions.hold_supports(state.x);
    prescribe_values(conditions.driven(), 0., voltage, state.x);
    prescribe_values(conditions.heated(), 0., 1., state.x);
    state.x.update_ghost_values();
  }

  ParameterFile file;
  MaterialLibrary materials;
  Mesh<dim> mesh;
  DofLayout<dim> layout;
  BoundaryConditions<dim> conditions;
  Loads<dim> loads;
  HeatStorage<dim> storage;
  State state;
  Timings timings;
  System<dim> system;
};

/// Add noise to the owned free unknowns of every block, the same on any number of ranks.
template <int dim>
void add_noise(const TestScene<dim>& scene, const std::vector<double>& amplitude, BlockVector& x)
{
  std::mt19937 random(42);
  std::uniform_real_distribution<double> noise(-1., 1.);
  std::size_t n = 0;
  for (const Field field : scene.layout.fields())
    n += scene.layout.n_dofs(field);
  std::vector<double> all(n);
  for (double& value : all)
    value = noise(random);
  BlockVector change = scene.layout.new_vector();
  PartitionIndependentOrder<dim>(scene.layout).distribute(all, change);
  x.zero_out_ghost_values();
  change.zero_out_ghost_values();
  for (unsigned int b = 0; b < x.n_blocks(); ++b)
    x.block(b).add(amplitude[b], change.block(b));
  scene.conditions.constraints().set_zero(x);
  x.update_ghost_values();
}

/// The two-layer bending actuator, small: potential in one layer, a uniform temperature or a field
/// of the @p model steady or transient.
inline std::string bilayer(const std::string& model, const std::string& formulation,
                           const int degree)
{
  return "subsection Mesh\n set File = meshes/bilayer.geo\n"
         " set Parameters = L: 6, W: 2, n1: 4, n2: 1, n3: 4\nend\n"
         "subsection Regions\n set Materials = active: elastomer, passive: elastomer\n"
         " set Passive = passive\nend\n"
         "subsection Materials\n subsection elastomer\n set Thermal expansion = 1.8e-4\n"
         " set Permittivity = 1e-5, 0.873e-5\n end\nend\n"
         "subsection Discretisation\n set Degree = " +
         std::to_string(degree) + "\n set Formulation = " + formulation +
         "\nend\n"
         "subsection Supports\n set Fixed = x3_min: u3, x2_min: u2, x2_max: u2, pin: u1\nend\n"
         "subsection Electrodes\n set Potential = interface: 0, outer: 1\nend\n" +
         (model == "uniform" ? ""
                             : "subsection Temperature\n set Model = " + model +
                                   "\n set Fixed = outer: 353, back: 293\nend\n"
                                   "subsection Heat\n set Convection = x3_max: 0.3\n"
                                   " set Surroundings = x3_max: 300\nend\n");
}

} // namespace thelma_test
