#include <thelma/elements/pressure_dilatation.h>

namespace thelma
{
namespace
{

/// Pressure and dilatation are discontinuous polynomials of degree p - 1 (Q1/P0, Q2/P1) and
/// everything is taken by the full rule.
template <int dim>
class MeanDilatation final : public PressureDilatation<dim>
{
public:
  void setup(const DofLayout<dim>& layout) override
  {
    const unsigned int n_points = layout.degree() + 1, n_modes = layout.degree() == 1 ? 1 : dim + 1;
    this->use(layout, n_points, this->polynomials(n_points, n_modes), n_modes);
  }
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
