#pragma once

#include <thelma/materials/branches.h>
#include <thelma/materials/material.h>

#include <utility>

namespace thelma
{

/// The free energy of theory.md, eq. 4, from an elastic and a dielectric law:
///   psi = (theta/theta_0) [W(F_EM, theta) + U(J_EM)] + psi_dielectric(F, E, theta) + psi_t(theta).
/// Branches with memory add their incremental potential to W (theory.md, eq. 49), of which P and
/// its derivatives follow; energies and entropy count what they store, and their derivatives here
/// leave the flow out. Number-generic, so that Sacado can differentiate each function and the tests
/// compare.
template <class Elastic, class Dielectric>
class ComposedMaterial final : public Material
{
public:
  void declare(dealii::ParameterHandler& prm) override
  {
    elastic.declare(prm);
    dielectric.declare(prm);
    thermal.declare(prm);
    branches.declare(prm);
  }

  void set_branches(Branches chosen) override { branches = std::move(chosen); }

  /// psi without the volumetric energy.
  template <typename Number>
  Number psi(const PointState<Number>& state) const
  {
    const Kinematics<Number> kin(state.F);
    const Strain<Number> em(thermal, state, kin.J);
    const Number W =
        elastic.W(em.F, em.J, state.theta) + branches.W(em.F, em.J, state.theta, state.history);
    return state.theta / thermal.theta_0 * W + dielectric.psi(state, kin) +
           thermal.psi(state.theta);
  }

  template <typename Number>
  FirstDerivatives<Number> first_derivatives(const PointState<Number>& state) const
  {
    const Kinematics<Number> kin(state.F);
    Split<Number> em(*this, state, kin);
    branches.add_first(em.F, em.kin, state.theta, state.history, em.d);
    const Number f = state.theta / thermal.theta_0;
    FirstDerivatives<Number> out;
    out.P = f * em.s * em.d.W_F;
    out.eta = thermal.eta(state.theta) - em.d.W / thermal.theta_0 -
              f * (em.d.W_theta - thermal.alpha * contract(em.d.W_F, em.F));
    dielectric.add_first(state, kin, out);
    return out;
  }

  template <typename Number>
  SecondDerivatives<Number> second_derivatives(const PointState<Number>& state) const
  {
    SecondDerivatives<Number> out{};
    set_second_derivatives(state, out);
    return out;
  }

  /// The same into @p out, which is zero before: of many points at once it is too large to copy.
  template <typename Number>
  void set_second_derivatives(const PointState<Number>& state, SecondDerivatives<Number>& out) const
  {
    const Kinematics<Number> kin(state.F);
    Split<Number> em(*this, state, kin);
    const Number f = state.theta / thermal.theta_0;
    const double alpha = thermal.alpha;
    out.dP_dF = elastic.second(em.F, em.kin, state.theta);
    branches.add_second(em.F, em.kin, state.theta, state.history, em.d, out.dP_dF);
    const Tensor3<2, Number> W_FF_F = apply(out.dP_dF, em.F);
    out.dP_dF *= f * em.s * em.s;
    out.dP_dtheta = em.s * ((1. / thermal.theta_0 - alpha * f) * em.d.W_F +
                            f * (em.d.W_Ftheta - alpha * W_FF_F));
    out.deta_dtheta = thermal.deta_dtheta(state.theta) -
                      2. / thermal.theta_0 * (em.d.W_theta - alpha * contract(em.d.W_F, em.F)) -
                      f * (em.d.W_thetatheta - 2. * alpha * contract(em.d.W_Ftheta, em.F) +
                           alpha * alpha * (contract(W_FF_F, em.F) + contract(em.d.W_F, em.F)));
    dielectric.add_second(state, kin, out);
  }

  Energies energies(const PointState<>& state) const override
  {
    const Kinematics<> kin(state.F);
    Split<double> em(*this, state, kin);
    branches.add_first(em.F, em.kin, state.theta, state.history, em.d);
    const double theta = state.theta;
    const FirstDerivatives<> first = first_derivatives(state);
    const double entropy = thermal.coupling_entropy(theta, first.eta);
    return {theta / thermal.theta_0 * em.d.W, dielectric.psi(state, kin) + state.E * first.D,
            thermal.coupling_psi(theta) + theta * entropy, entropy};
  }

  Dissipated<> dissipated(const double* before, const double* now) const override
  {
    const Dissipated<> sum = branches.dissipated(before, now);
    return {sum.energy / thermal.theta_0, sum.entropy / thermal.theta_0};
  }

  FlowHeat flow_heat(const PointState<>& state, const double* before) const override
  {
    const PointState<OfStrain> varied = of_strain(state);
    const Strain<OfStrain> em(thermal, varied, Kinematics<OfStrain>(varied.F).J);
    const Dissipated<OfStrain> sum =
        branches.dissipated(em.F, em.J, varied.theta, varied.history, before);
    return thelma::flow_heat(first_derivatives(varied).eta, sum.energy / thermal.theta_0);
  }

  void evaluate(const PointState<>& state, FirstDerivatives<>& out) const override
  {
    out = first_derivatives(state);
  }

  void evaluate(const PointState<>& state, SecondDerivatives<>& out) const override
  {
    set_second_derivatives(state, out);
  }

  void evaluate(const PointState<Lanes>& state, FirstDerivatives<Lanes>& out) const override
  {
    out = first_derivatives(state);
  }

  void evaluate(const PointState<Lanes>& state, SecondDerivatives<Lanes>& out) const override
  {
    set_second_derivatives(state, out);
  }

  void add_entropy_rate(const PointState<>& state, const PointRates& rates,
                        EntropyRate& out) const override
  {
    thelma::add_entropy_rate(second_derivatives(along(state, rates)), rates, out);
  }

  unsigned int n_history() const override { return branches.n_history(); }

  unsigned int n_step() const override { return branches.n_step(); }

  void begin_step(const StepTimes& times, const double* old, const double* older,
                  double* step) const override
  {
    branches.begin_step(times, old, older, step);
  }

  void update_history(const PointState<>& state, double* now) const override
  {
    branches.update_history(thermal.split(state.theta) * state.F, state.theta, state.history.step,
                            now);
  }

  double step_error(const StepTimes& times, const double* old, const double* older,
                    const double* now) const override
  {
    return branches.step_error(times, old, older, now);
  }

  std::string table_defect(const double theta) const override
  {
    for (const std::string& defect : {elastic.table_defect(theta), dielectric.table_defect(theta),
                                      branches.table_defect(theta)})
      if (!defect.empty())
        return "section Materials/" + name + defect;
    return "";
  }

  double branch_modulus(const double theta) const override { return branches.modulus(theta); }
  std::string branch_defect(const double theta) const override { return branches.defect(theta); }

  double shear_modulus(const double theta) const override { return elastic.shear_modulus(theta); }
  double permittivity(const double theta) const override { return dielectric.permittivity(theta); }

private:
  /// The electro-mechanical part of the deformation.
  template <typename Number>
  struct Strain {
    Strain(const Thermal& thermal, const PointState<Number>& state, const Number& det_F)
        : s(thermal.split(state.theta)), F(s * state.F), J(det_F * s * s * s)
    {
    }

    Number s;
    Tensor3<2, Number> F;
    Number J;
  };

  /// The same and the elastic law at it, without branches.
  template <typename Number>
  struct Split : Strain<Number> {
    Split(const ComposedMaterial& m, const PointState<Number>& state,
          const Kinematics<Number>& total)
        : Strain<Number>(m.thermal, state, total.J), kin(total)
    {
      kin.J = this->J;
      kin.G = total.G / this->s;
      d = m.elastic.first(this->F, kin, state.theta);
    }

    Kinematics<Number> kin;
    ElasticDerivatives<Number> d;
  };

  Elastic elastic;
  Dielectric dielectric;
  Branches branches;
};

} // namespace thelma
