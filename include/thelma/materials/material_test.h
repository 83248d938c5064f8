#pragma once

#include <thelma/materials/material.h>

#include <string>
#include <vector>

namespace thelma
{

/// What is imposed on a homogeneous body at an instant. The field is nominal and goes through the
/// thickness, the third axis.
struct Imposed {
  double time = 0.; ///< s
  double stretch = 1.;
  double theta = 293.; ///< K
  double field = 0.;   ///< kV/mm
};

/// The test of a homogeneous body of which the stretch along the first axis is given: the second
/// axis is free of force (uniaxial), keeps its length (pure shear) or is stretched alike
/// (equibiaxial), the third is free of force.
struct MaterialTest {
  enum class Mode { uniaxial, pure_shear, equibiaxial };

  std::string name;
  Mode mode = Mode::uniaxial;
  bool in_time = false;      ///< else every row is a state of equilibrium, which has relaxed
  std::vector<Imposed> rows; ///< linear in time between them; relaxed in the first

  /// Nominal stress along the first axis in every row, in MPa. Follows the branches' own steps in
  /// time, extrapolated until their error is negligible. Throws InputError, with a sentence that
  /// begins with the test and the row, where there is no stable equilibrium.
  std::vector<double> stresses(const Material& material) const;
};

} // namespace thelma
