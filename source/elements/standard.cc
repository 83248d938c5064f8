#include <thelma/elements/integrate.h>

#include <optional>

namespace thelma
{
namespace
{

/// Every energy at the full Gauss rule. Locks for nearly incompressible bodies at p = 1.
template <int dim>
class Standard final : public Formulation<dim>
{
public:
  void setup(const DofLayout<dim>& layout) override { full.emplace(layout, layout.degree() + 1); }

  void residual(const CellView<dim>& view, CellResult& result) const override
  {
    result.reset(view, full->basis().n_nodes, false);
    integrate(CellPoints<dim>(*full, view), view, WholeEnergy(), false, result);
  }

  void tangent(const CellView<dim>& view, CellResult& result) const override
  {
    result.reset(view, full->basis().n_nodes, true);
    integrate(CellPoints<dim>(*full, view), view, WholeEnergy(), true, result);
    result.blocks.write(result.tangent);
  }

  const dealii::Quadrature<dim>& law_points() const override { return full->quadrature(); }

  void update_memory(const CellView<dim>& view, double* now) const override
  {
    thelma::update_memory(CellPoints<dim>(*full, view), view, now);
  }

  double pressure(const CellView<dim>& view, const dealii::Point<dim>&,
                  const PointState<>& state) const override
  {
    return view.cell.material->thermal.volumetric(Kinematics<>(state.F).J, state.theta).p;
  }

  Energies energies(const CellView<dim>& view) const override
  {
    return integral(
        CellPoints<dim>(*full, view), view,
        [](const Material& material, const PointState<>& state) {
          const double J = Kinematics<>(state.F).J;
          Energies sum = material.energies(state);
          sum.add(1., thelma::energies(material.thermal.volumetric(J, state.theta), state.theta));
          return sum;
        });
  }

private:
  std::optional<Integration<dim>> full;
};

} // namespace

template <int dim>
std::unique_ptr<Formulation<dim>> make_standard()
{
  return std::make_unique<Standard<dim>>();
}

template std::unique_ptr<Formulation<2>> make_standard();
template std::unique_ptr<Formulation<3>> make_standard();

} // namespace thelma
