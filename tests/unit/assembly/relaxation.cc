// A film that is stretched at once and held: what every element makes of a law that remembers,
// against the ordinary differential equation of the homogeneous film; and what a State keeps.

#include "scene.h"

#include <thelma/base/error.h>
#include <thelma/solvers/newton.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace
{

using namespace thelma_test;

constexpr double mu = 0.05, K = 5., G = 0.1, tau = 2., stretch = 1.8; // MPa, s

/// One cell that is free to contract along x1 (in plane strain) or x1 and x2.
template <int dim>
std::string film(const std::string& formulation, const int degree)
{
  const std::string mesh =
      dim == 3 ? "meshes/box.geo\n set Parameters = L1: 1, L2: 1, L3: 1, n1: 1, n2: 1, n3: 2"
               : "meshes/bilayer_plane.geo\n set Parameters = L: 1, H: 1, n1: 2, n3: 1";
  return "subsection Mesh\n set File = " + mesh + "\nend\nsubsection Regions\n set Materials = " +
         (dim == 3 ? "film: rubber\n set Passive = film"
                   : "active: rubber, passive: rubber\n set Passive = active, passive") +
         "\nend\nsubsection Materials\n subsection rubber\n"
         " set Branches = Maxwell\n set Shear modulus = 0.05\n set Bulk modulus = 5\n"
         " subsection Branch 1\n set Modulus = 0.1\n set Relaxation time = 2\n end\n end\nend\n"
         "subsection Discretisation\n set Formulation = " +
         formulation + "\n set Degree = " + std::to_string(degree) +
         "\nend\nsubsection Supports\n set Fixed = " +
         (dim == 3 ? "x1_min: u1, x2_min: u2, bottom: u3, top: u3"
                   : "outer: u1, x3_min: u3, x3_max: u3") +
         "\nend\n";
}

/// The stretched film in time.
template <int dim>
class Film
{
public:
  Film(const std::string& formulation, const int degree, const unsigned int order = 1)
      : scene(film<dim>(formulation, degree)), order(order)
  {
  }

  /// Find the state @p dt later.
  void step(const double dt)
  {
    State& state = scene.state;
    state.time = state.accepted_load() + dt;
    state.rates = backward_differences(state.time, {state.accepted_load()}, order);
    const double across = state.path().size() == 1 ? std::pow(stretch, dim == 3 ? -0.5 : -1.) : 0.;
    visit([&](const unsigned int c, const double X, const auto dof) {
      if (c == dim - 1)
        state.x(dof) = (stretch - 1.) * X;
      else if (across > 0.)
        state.x(dof) = (across - 1.) * X;
    });
    state.x.update_ghost_values();
    EXPECT_TRUE(newton.solve(scene.system).converged);
  }
  void accept() { scene.state.accept(scene.state.time); }

  /// Nominal stress along x3, by the work of the nodal forces on a displacement u3 = X3.
  double stress()
  {
    scene.system.residual();
    BlockVector way = scene.layout.new_vector();
    visit([&](const unsigned int c, const double X, const auto dof) {
      if (c == dim - 1)
        way(dof) = X;
    });
    BlockVector forces = scene.system.reactions();
    forces.zero_out_ghost_values();
    way.zero_out_ghost_values();
    return forces * way;
  }

  TestScene<dim> scene;

private:
  template <typename Visitor>
  void visit(const Visitor& visit)
  {
    const auto owned = scene.layout.dof_handler().locally_owned_dofs();
    const auto& points = scene.layout.scalar_element().get_unit_support_points();
    scene.state.x.zero_out_ghost_values();
    for (const Cell<dim>& cell : scene.layout.cells())
      for (unsigned int a = 0; a < points.size(); ++a) {
        const auto X = scene.layout.mapping().transform_unit_to_real_cell(cell.iterator, points[a]);
        for (unsigned int c = 0; c < dim; ++c)
          if (const auto dof = cell.dofs[a * cell.n_components + c]; owned.is_element(dof))
            visit(c, X[c], dof);
      }
    scene.state.x.update_ghost_values();
  }

  Newton newton;
  unsigned int order;
};

/// The same film by a few formulas: with the stretches l_i, J and the branch's C_i = J^{-2/3}
/// l_i^2,
///   P_i l_i = mu (l_i^2 - 1) + K ln J + G (C_i/V_i - mean),   V_i' = (C_i - mean V_i)/tau,
/// mean = sum C_i/V_i / 3, integrated by the classical Runge-Kutta method.
class HomogeneousFilm
{
public:
  explicit HomogeneousFilm(const bool plane_strain) : plane_strain(plane_strain) {}

  double stress_after(const double time) const
  {
    constexpr unsigned int n = 400;
    const double h = time / n;
    Tensor3<1> V({1., 1., 1.});
    for (unsigned int k = 0; k < n; ++k) {
      const Tensor3<1> k1 = rate(V), k2 = rate(V + h / 2. * k1), k3 = rate(V + h / 2. * k2),
                       k4 = rate(V + h * k3);
      V += h / 6. * (k1 + 2. * k2 + 2. * k3 + k4);
    }
    return stress(stretches(V), V, 2);
  }

private:
  static Tensor3<1> ratios(const Tensor3<1>& l, const Tensor3<1>& V)
  {
    const double j = std::pow(l[0] * l[1] * l[2], -2. / 3.);
    return Tensor3<1>({j * l[0] * l[0] / V[0], j * l[1] * l[1] / V[1], j * l[2] * l[2] / V[2]});
  }

  static double stress(const Tensor3<1>& l, const Tensor3<1>& V, const unsigned int i)
  {
    const Tensor3<1> r = ratios(l, V);
    return (mu * (l[i] * l[i] - 1.) + K * std::log(l[0] * l[1] * l[2]) +
            G * (r[i] - (r[0] + r[1] + r[2]) / 3.)) /
           l[i];
  }

  Tensor3<1> with(const double across) const
  {
    return Tensor3<1>({across, plane_strain ? 1. : across, stretch});
  }

  /// No stress across, by bisection.
  Tensor3<1> stretches(const Tensor3<1>& V) const
  {
    double low = 0.3, high = 1.5;
    for (unsigned int k = 0; k < 60; ++k) {
      const double middle = (low + high) / 2.;
      (stress(with(middle), V, 0) < 0. ? low : high) = middle;
    }
    return with(low);
  }

  Tensor3<1> rate(const Tensor3<1>& V) const
  {
    const Tensor3<1> r = ratios(stretches(V), V);
    const double mean = (r[0] + r[1] + r[2]) / 3.;
    Tensor3<1> result;
    for (unsigned int i = 0; i < 3; ++i)
      result[i] = (r[i] - mean) * V[i] / tau;
    return result;
  }

  bool plane_strain;
};

template <int dim>
void expect_relaxation(const std::string& formulation, const int degree, const unsigned int order)
{
  const HomogeneousFilm exact(dim == 2);
  double last = 0.;
  for (const unsigned int n : {10u, 20u, 40u}) {
    Film<dim> film(formulation, degree, order);
    film.step(0.); // it is stretched at once
    film.accept();
    for (unsigned int k = 0; k < n; ++k) {
      film.step(tau / n);
      film.accept();
    }
    const double error = film.stress() / exact.stress_after(tau) - 1.;
    std::printf("%d-D, %s, degree %d, order %u, %2u steps: error of the stress %.2e", dim,
                formulation.c_str(), degree, order, n, error);
    if (last != 0.) {
      std::printf(", order %.2f", std::log2(std::abs(last / error)));
      EXPECT_GT(std::log2(std::abs(last / error)), order - 0.2);
    }
    std::printf("\n");
    last = error;
  }
}

TEST(Relaxation, FollowsTheEquationInEveryElement)
{
  for (const int degree : {1, 2})
    for (const std::string& formulation : formulations<3>().names())
      if (degree == 1 || formulation != "enhanced strain") {
        for (const unsigned int order : {1u, 2u}) {
          expect_relaxation<2>(formulation, degree, order);
          expect_relaxation<3>(formulation, degree, order);
        }
      }
}

/// At once the film is elastic; after a long time, and where nothing depends on time, too.
TEST(Relaxation, LimitsAreElastic)
{
  const HomogeneousFilm exact(false);
  Film<3> film("mean dilatation", 1);
  film.step(1e-10 * tau);
  EXPECT_NEAR(film.stress(), exact.stress_after(0.), 1e-8 * G);
  film.step(1e10 * tau);
  const double relaxed = exact.stress_after(60. * tau);
  EXPECT_NEAR(film.stress(), relaxed, 1e-8 * G);
  film.scene.state.rates.reset();
  EXPECT_NEAR(film.stress(), relaxed, 1e-8 * G);
  film.scene.state.holds_without_time = true;
  film.scene.state.x = film.scene.state.path()[0].x;
  film.step(0.);
  film.scene.state.rates.reset();
  EXPECT_NEAR(film.stress(), exact.stress_after(0.), 1e-8 * G);
}

/// Neither a step that is not accepted nor one that is forgotten leaves anything behind.
TEST(Relaxation, OnlyAcceptedStepsAreRemembered)
{
  Film<3> film("mean dilatation", 1);
  film.step(0.1);
  film.accept();
  film.step(0.2);
  const double wanted = film.stress();
  for (const bool accepts : {false, true}) {
    film.scene.state.restore();
    film.step(5.);
    if (accepts) {
      film.accept();
      film.scene.state.forget();
    }
    film.scene.state.restore();
    film.step(0.2);
    EXPECT_NEAR(film.stress(), wanted, 1e-10 * G);
  }
}

/// Once a step is accepted no time has passed, and the film is in balance as it was.
TEST(Relaxation, AcceptedStateIsInBalance)
{
  Film<3> film("mean dilatation", 1);
  film.step(1.);
  const double before = film.stress();
  film.accept();
  EXPECT_NEAR(film.stress(), before, 1e-12 * G);
  EXPECT_LT(film.scene.system.residual().norm, 1e-9);
}

/// What is remembered goes through the order of the mesh and comes back to whichever rank.
TEST(DealtOutHistory, ComesBack)
{
  Film<3> film("mean dilatation", 2);
  film.step(1.);
  film.accept();
  const std::vector<double>& history = film.scene.state.path().back().history;
  EXPECT_EQ(history.size(), film.scene.layout.cells().size() * 27 * 13);
  const PartitionIndependentOrder<3> order(film.scene.layout);
  std::vector<double> all = order.collect(history);
  all = dealii::Utilities::MPI::broadcast(MPI_COMM_WORLD, all);
  EXPECT_EQ(all.size(), 2u * 27 * 13);
  std::vector<double> again(history.size(), 0.);
  EXPECT_TRUE(order.distribute(all, again));
  EXPECT_EQ(again, history);
}

/// The power of the paper leaves out the heat of flow.
TEST(Relaxation, StructuralHeatByPowerIsRefused)
{
  const Film<3> film("mean dilatation", 1);
  film.scene.materials.check_heat(true, false);
  EXPECT_THROW(film.scene.materials.check_heat(true, true), InputError);
}

/// Scenes whose laws remember nothing keep nothing.
TEST(Relaxation, NothingIsKeptWithoutALawThatRemembers)
{
  TestScene<3> scene(bilayer("uniform", "mean dilatation", 1));
  scene.state.accept(1.);
  EXPECT_EQ(scene.state.path().back().history.capacity(), 0u);
}

} // namespace
