#include <thelma/elements/element_pressure.h>

#include <optional>

namespace thelma
{
namespace
{

/// Mean dilatation (theory.md, eq. 21): pressure and dilatation of degree p - 1 in each cell
/// (Q1/P0, Q2/P1).
template <int dim>
class MeanDilatation final : public Formulation<dim>
{
public:
  void setup(const FieldLayout<dim>& layout) override
  {
    rule.emplace(layout, layout.degree() + 1);
    pressure.setup(layout, *rule, layout.degree() == 1 ? 1 : dim + 1);
  }

  unsigned int n_internal() const override { return pressure.n_internal(); }
  void start_internal(double* values) const override { pressure.start_internal(values); }

  void residual(const CellView<dim>& view, CellResult& result) const override
  {
    result.reset(view.cell.dofs.size(), false);
    pressure.residual(view, CellPoints<dim>(*rule, view), result);
  }

  void tangent(const CellView<dim>& view, CellResult& result) const override
  {
    result.reset(view.cell.dofs.size(), true);
    pressure.tangent(view, CellPoints<dim>(*rule, view), result);
  }

  void recover(const CellView<dim>& view, const double* dx, double* correction) const override
  {
    const NodalValues<dim> change(dx, rule->basis().n_nodes, view.cell.n_components);
    pressure.recover(view, CellPoints<dim>(*rule, view), change, correction);
  }

  Energies energies(const CellView<dim>& view) const override
  {
    const CellPoints<dim> points(*rule, view);
    Energies sum;
    add_energies<WithoutVolumetric>(points, view, sum);
    sum.elastic += pressure.volumetric_energy(view, points);
    return sum;
  }

private:
  std::optional<Integration<dim>> rule;
  ElementPressure<dim> pressure;
};

} // namespace

template <int dim>
std::unique_ptr<Formulation<dim>> make_mean_dilatation()
{
  return std::make_unique<MeanDilatation<dim>>();
}

template std::unique_ptr<Formulation<2>> make_mean_dilatation();
template std::unique_ptr<Formulation<3>> make_mean_dilatation();

} // namespace thelma
