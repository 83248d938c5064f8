#include <thelma/elements/integrate.h>

#include <optional>

namespace thelma
{
namespace
{

/// The volumetric energy at the Gauss rule of one point less per direction, the rest at the full
/// one (theory.md, eq. 15): the paper's cure for volumetric locking.
template <int dim>
class SelectiveReduced final : public Formulation<dim>
{
public:
  void setup(const FieldLayout<dim>& layout) override
  {
    full.emplace(layout, layout.degree() + 1);
    reduced.emplace(layout, layout.degree());
  }

  void residual(const CellView<dim>& view, CellResult& result) const override
  {
    result.reset(view.cell.dofs.size(), false);
    integrate(CellPoints<dim>(*full, view), view, WithoutVolumetric(), false, result);
    integrate(CellPoints<dim>(*reduced, view), view, VolumetricOnly(), false, result);
  }

  void tangent(const CellView<dim>& view, CellResult& result) const override
  {
    result.reset(view.cell.dofs.size(), true);
    integrate(CellPoints<dim>(*full, view), view, WithoutVolumetric(), true, result);
    integrate(CellPoints<dim>(*reduced, view), view, VolumetricOnly(), true, result);
  }

  Energies energies(const CellView<dim>& view) const override
  {
    Energies sum;
    add_energies<WithoutVolumetric>(CellPoints<dim>(*full, view), view, sum);
    add_energies<VolumetricOnly>(CellPoints<dim>(*reduced, view), view, sum);
    return sum;
  }

private:
  std::optional<Integration<dim>> full, reduced;
};

} // namespace

template <int dim>
std::unique_ptr<Formulation<dim>> make_selective_reduced()
{
  return std::make_unique<SelectiveReduced<dim>>();
}

template std::unique_ptr<Formulation<2>> make_selective_reduced();
template std::unique_ptr<Formulation<3>> make_selective_reduced();

} // namespace thelma
