// Seconds of assembly per cell and core, scatter included, on the bending actuator's mesh of the
// paper, charged and slightly deformed.
// Run alone on the machine: build/bin/benchmark_assembly

#include "scene.h"
#include "timing.h"

#include <thelma/materials/library.h>
#include <thelma/materials/neo_hookean.h>

#include <cstdio>

namespace
{

using namespace thelma_test;

struct Microseconds {
  double residual, tangent;
};

/// With an elastic law, and so many viscoelastic branches in all cells, which flow.
template <int dim>
Microseconds measure(const std::string& mesh, const std::string& supports,
                     const std::string& formulation, const int degree, const int n_branches,
                     const std::string& law = NeoHookean::name)
{
  std::string branches;
  for (int i = 0; i < n_branches; ++i)
    branches += i > 0 ? ", Maxwell" : "Maxwell";
  TestScene<dim> scene("subsection Mesh\n " + mesh +
                       "\nend\nsubsection Regions\n"
                       " set Materials = active: elastomer, passive: elastomer\n"
                       " set Passive = passive\nend\nsubsection Materials\n subsection elastomer\n"
                       "  set Elastic law = " +
                       law + "\n  set Branches = " + branches +
                       "\n end\nend\nsubsection Discretisation\n set Degree = " +
                       std::to_string(degree) + "\n set Formulation = " + formulation +
                       "\nend\nsubsection Supports\n set Fixed = " + supports +
                       "\nend\nsubsection Electrodes\n"
                       " set Potential = interface: 0, outer: 1\nend\n");
  add_noise(scene, {1e-3, 0.1}, scene.state.x);
  if (n_branches > 0) {
    scene.state.time = 0.1;
    scene.state.rates = backward_differences(scene.state.time, {0.}, 2);
  }
  const double n = scene.layout.cells().size();
  return {1e6 / n * shortest_seconds([&]() { scene.system.residual(); }),
          1e6 / n * shortest_seconds([&]() { scene.system.linear.assemble(); })};
}

template <int dim>
void compare(const std::string& mesh, const std::string& supports, const std::string& formulation,
             const int degree)
{
  const Microseconds elastic = measure<dim>(mesh, supports, formulation, degree, 0),
                     viscous = measure<dim>(mesh, supports, formulation, degree, 3);
  std::printf("%d-D  %-18s Q%d  residual %7.2f  tangent %7.2f   with 3 branches %7.2f (x %.2f) "
              "%7.2f (x %.2f)\n",
              dim, formulation.c_str(), degree, elastic.residual, elastic.tangent, viscous.residual,
              viscous.residual / elastic.residual, viscous.tangent,
              viscous.tangent / elastic.tangent);
}

/// Each law's price.
void compare_laws()
{
  const auto measured = [](const std::string& law) {
    return measure<3>("set File = meshes/bilayer.geo",
                      "x3_min: u3, x2_min: u2, x2_max: u2, pin: u1", "mean dilatation", 2, 0, law);
  };
  const Microseconds plain = measured(NeoHookean::name);
  std::printf(
      "elastic laws, Q2 with mean dilatation in 3-D, times neo-Hookean: residual, tangent\n");
  for (const Choice& law : elastic_laws()) {
    const Microseconds found = measured(law.name);
    std::printf("%-14s %6.2f %6.2f\n", law.name.c_str(), found.residual / plain.residual,
                found.tangent / plain.tangent);
  }
}

} // namespace

int main(int argc, char** argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::printf("microseconds per cell, scatter included\n");
  for (const int degree : {1, 2})
    for (const std::string& formulation : formulations<3>().names()) {
      if (degree == 2 && formulation == "enhanced strain")
        continue; // for linear elements only
      compare<2>("set File = meshes/bilayer_plane.geo", "x3_min: u3, pin: u1", formulation, degree);
      compare<3>("set File = meshes/bilayer.geo", "x3_min: u3, x2_min: u2, x2_max: u2, pin: u1",
                 formulation, degree);
    }
  compare_laws();
}
