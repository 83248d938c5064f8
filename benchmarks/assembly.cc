// Seconds of assembly per cell and core, scatter included, on the bending actuator's mesh of the
// paper, charged and slightly deformed.
// Run alone on the machine: build/bin/benchmark_assembly

#include "scene.h"
#include "timing.h"

#include <cstdio>

namespace
{

using namespace thelma_test;

template <int dim>
void measure(const std::string& mesh, const std::string& supports, const std::string& formulation,
             const int degree)
{
  TestScene<dim> scene("subsection Mesh\n " + mesh +
                       "\nend\nsubsection Regions\n"
                       " set Materials = active: elastomer, passive: elastomer\n"
                       " set Passive = passive\nend\nsubsection Discretisation\n set Degree = " +
                       std::to_string(degree) + "\n set Formulation = " + formulation +
                       "\nend\nsubsection Supports\n set Fixed = " + supports +
                       "\nend\nsubsection Electrodes\n"
                       " set Potential = interface: 0, outer: 1\nend\n");
  add_noise(scene, {1e-3, 0.1}, scene.state.x);
  const std::size_t n = scene.layout.cells().size();
  const double residual = 1e6 / n * shortest_seconds([&]() { scene.system.residual(); });
  const double tangent = 1e6 / n * shortest_seconds([&]() { scene.system.linear.assemble(); });
  std::printf("%d-D  %-18s Q%d  %5zu cells  residual %7.2f  tangent %7.2f\n", dim,
              formulation.c_str(), degree, n, residual, tangent);
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
      measure<2>("set File = meshes/bilayer_plane.geo", "x3_min: u3, pin: u1", formulation, degree);
      measure<3>("set File = meshes/bilayer.geo", "x3_min: u3, x2_min: u2, x2_max: u2, pin: u1",
                 formulation, degree);
    }
}
