#include <thelma/base/error.h>
#include <thelma/elements/enhanced_modes.h>
#include <thelma/elements/pressure_dilatation.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace thelma
{
namespace
{

/// Enhanced strain and field (theory.md, eq. 31): linear elements whose gradients have in each cell
/// dim more modes per component, those of quadratic bubbles across it. They let the cell bend
/// without shear, and the field in it vary. Pressure and dilatation are linear as well. To the
/// point loop the modes are further nodes.
///
/// Internal unknowns: p, t, then the modes alpha [k][c]. What elimination keeps after p and t's: of
/// each row of the modes the pivot, then the row and the column divided by it.
template <int dim>
class EnhancedStrain final : public PressureDilatation<dim>
{
public:
  void setup(const DofLayout<dim>& layout) override
  {
    if (layout.degree() != 1)
      throw InputError("section Discretisation, entry 'Formulation': 'enhanced strain' improves "
                       "linear elements; set Degree = 1, or Formulation = mean dilatation");
    this->use(layout, 2, DilatationModes<dim>::polynomials(2, dim + 1), dim + 1, dim);
    n_components = layout.n_components();
    modes.emplace(layout);
  }

  unsigned int n_internal() const override { return Base::n_internal() + dim * n_components; }

  /// The modes are condensed after the pressures.
  unsigned int n_kept_pressures() const override { return 0; }

  unsigned int n_elimination() const override
  {
    return Base::n_elimination() + dim * n_components * (1 + 2 * n_nodes * n_components);
  }

  void residual(const CellView<dim>& view, CellResult& result) const override
  {
    Base::residual(Enhanced(view).view, result);
    const auto own = result.residual.begin() + view.cell.dofs.size();
    result.internal.insert(result.internal.end(), own, result.residual.end());
    result.residual.erase(own, result.residual.end());
    if (!(result.min_det_F > 0.))
      return;
    result.internal.resize(n_internal(), 0.);
    result.internal_error += mode_error(view, result.internal.data() + Base::n_internal());
  }

  void tangent(const CellView<dim>& view, CellResult& result) const override
  {
    Base::tangent(Enhanced(view).view, result);
    const int n_c = view.cell.n_components;
    const std::size_t n_outer = view.cell.dofs.size(), n = std::size_t(n_nodes) * n_c;
    for (std::size_t k = n_outer; k < n; ++k) {
      const bool heat = view.has_temperature && static_cast<int>(k % n_c) == n_c - 1;
      const bool is_free = heat ? view.solves_temperature() && view.cell.material->thermal.k > 0.
                                : view.solves_deformation();
      if (!is_free)
        result.tangent[k * n + k] = std::numeric_limits<double>::infinity(); // it does not move
    }
    result.elimination.resize(n_elimination(), 0.);
    const unsigned int n_negative = eliminate_modes(
        n_outer, n, result.tangent.data(), Pivots(*this, n_outer, n, result.elimination.data()));
    for (std::size_t i = 0; i < n_outer; ++i)
      std::copy_n(result.tangent.begin() + i * n, n_outer, result.tangent.begin() + i * n_outer);
    result.tangent.resize(n_outer * n_outer);
    // One for each mode of the potential belongs to a stable cell, as in eq. (60).
    result.unstable_inside = static_cast<int>(n_negative) - (view.cell.has_potential ? dim : 0);
  }

  void eliminate(const Elimination<dim>& cell, double* residual) const override
  {
    const std::vector<double> R = reduced_residual(cell, 0);
    std::copy_n(R.begin(), R.size() - dim * cell.n_components, residual);
  }

  void recover(const Elimination<dim>& cell, const double* dx, double* correction) const override
  {
    const std::size_t n = n_nodes * cell.n_components, n_outer = n - dim * cell.n_components;
    const std::vector<double> R = reduced_residual(cell, n_outer);
    const Pivots<const double> pivots(*this, n_outer, n, cell.kept);
    std::vector<double> change(dx, dx + n_outer);
    for (std::size_t k = n_outer; k < n; ++k) {
      double sum = R[k] / pivots.pivot(k);
      for (std::size_t j = 0; j < k; ++j)
        sum += pivots.row(k)[j] * change[j];
      change.push_back(-sum);
    }
    Base::recover(cell, change.data(), correction);
    std::fill(correction + Base::n_internal(), correction + n_internal(), 0.);
    std::copy(change.begin() + n_outer, change.end(), correction + Base::n_internal());
  }

  double stabilisation(const CellView<dim>& view) const override
  {
    return Base::stabilisation(Enhanced(view).view);
  }

  Energies energies(const CellView<dim>& view) const override
  {
    return Base::energies(Enhanced(view).view);
  }

  void update_memory(const CellView<dim>& view, double* now) const override
  {
    Base::update_memory(Enhanced(view).view, now);
  }

  void pull_back(const CellView<dim>& view, double* values) const override
  {
    modes->pull_back(view, values + Base::n_internal());
  }

  void push_forward(const CellView<dim>& view, double* values) const override
  {
    modes->push_forward(view, values + Base::n_internal());
  }

protected:
  void enhance(const std::size_t cell, const unsigned int q,
               Gradients<dim>& gradients) const override
  {
    modes->set_gradients(cell, q, gradients);
  }

private:
  using Base = PressureDilatation<dim>;
  static constexpr unsigned int n_nodes = EnhancedModes<dim>::n_nodes + dim;

  /// Where elimination keeps what belongs to the rows n_outer to n - 1.
  template <typename Number>
  struct Pivots {
    Pivots(const EnhancedStrain& f, const std::size_t n_outer, const std::size_t n, Number* kept)
        : n_outer(n_outer), n(n), start(kept + f.Base::n_elimination())
    {
    }
    Number& pivot(const std::size_t k) const { return start[(k - n_outer) * (1 + 2 * n)]; }
    Number* row(const std::size_t k) const { return &pivot(k) + 1; }
    Number* column(const std::size_t k) const { return &pivot(k) + 1 + n; }

    std::size_t n_outer, n;
    Number* start;
  };
  template <typename Number>
  Pivots(const EnhancedStrain&, std::size_t, std::size_t, Number*) -> Pivots<Number>;

  /// Gaussian elimination of the modes, the last one first. Returns the number of negative pivots,
  /// which is that of the negative eigenvalues of a symmetric block.
  static unsigned int eliminate_modes(const std::size_t n_outer, const std::size_t n, double* K,
                                      const Pivots<double>& pivots)
  {
    unsigned int n_negative = 0;
    for (std::size_t k = n; k-- > n_outer;) {
      const double pivot = pivots.pivot(k) = K[k * n + k];
      n_negative += pivot < 0. ? 1 : 0;
      for (std::size_t i = 0; i < k; ++i) {
        pivots.row(k)[i] = K[k * n + i] / pivot;
        pivots.column(k)[i] = K[i * n + k] / pivot;
      }
      for (std::size_t i = 0; i < k; ++i)
        for (std::size_t j = 0; j < k; ++j)
          K[i * n + j] -= K[i * n + k] * pivots.row(k)[j];
    }
    return n_negative;
  }

  /// What p, t and the modes add to the nodal residual, and the residual of the modes on the way;
  /// only from @p first on.
  std::vector<double> reduced_residual(const Elimination<dim>& cell, const std::size_t first) const
  {
    const std::size_t n = n_nodes * cell.n_components, n_outer = n - dim * cell.n_components;
    std::vector<double> R(n, 0.);
    Base::eliminate(cell, R.data());
    for (std::size_t k = n_outer; k < n; ++k)
      R[k] += cell.residual[Base::n_internal() + k - n_outer];
    const Pivots<const double> pivots(*this, n_outer, n, cell.kept);
    for (std::size_t k = n; k-- > n_outer;)
      for (std::size_t i = first; i < k; ++i)
        R[i] -= pivots.column(k)[i] * R[k];
    return R;
  }

  /// Squared residual @p R of the modes in the units of eq. (82).
  double mode_error(const CellView<dim>& view, const double* R) const
  {
    const Material& material = *view.cell.material;
    const auto units = flux_units(material, view.theta);
    const int n_c = view.cell.n_components;
    double sum = 0.;
    for (int k = 0; k < dim; ++k) {
      const double size = modes->squared_norm(view.index, k);
      for (int c = 0; c < n_c; ++c) {
        const double unit = units[static_cast<std::size_t>(view.cell.field_of(c))];
        if (unit > 0.) // without conduction a mode of the temperature does nothing
          sum += std::pow(R[k * n_c + c] / unit, 2) / size;
      }
    }
    return sum;
  }

  /// The cell with its modes as further nodes, now and in the past.
  struct Enhanced {
    explicit Enhanced(const CellView<dim>& plain)
        : x(with_modes(plain, plain.x, plain.internal)), view(plain)
    {
      view.x = x.data();
      if (!plain.history)
        return;
      history = *plain.history;
      for (std::size_t k = 0; k < history.rates.n_past; ++k) {
        past[k] = with_modes(plain, history.x[k], history.internal[k]);
        history.x[k] = past[k].data();
      }
      view.history = &history;
    }
    Enhanced(const Enhanced&) = delete;
    Enhanced& operator=(const Enhanced&) = delete;

    std::vector<double> x;
    std::array<std::vector<double>, 2> past;
    CellHistory history;
    CellView<dim> view;

  private:
    static std::vector<double> with_modes(const CellView<dim>& plain, const double* x,
                                          const double* internal)
    {
      constexpr unsigned int n_before = 2 * (dim + 1); // p and t
      const double* alpha = internal + n_before;
      std::vector<double> all(x, x + plain.cell.dofs.size());
      all.insert(all.end(), alpha, alpha + dim * plain.cell.n_components);
      return all;
    }
  };

  std::optional<EnhancedModes<dim>> modes;
  unsigned int n_components = 0; ///< of the cell that has most
};

} // namespace

template <int dim>
std::unique_ptr<Formulation<dim>> make_enhanced_strain()
{
  return std::make_unique<EnhancedStrain<dim>>();
}

template std::unique_ptr<Formulation<2>> make_enhanced_strain();
template std::unique_ptr<Formulation<3>> make_enhanced_strain();

} // namespace thelma
