#pragma once

#include <thelma/solvers/linear_solver.h>

#include <string>

namespace thelma
{

/// How a scene wants its fields to be discretised and its linear systems to be solved.
struct SystemSettings {
  std::string formulation = "selective reduced";
  LinearSettings linear;
  std::string counts_for; ///< entry that needs unstable directions to be counted; empty: none

  void declare(dealii::ParameterHandler& prm);
};

} // namespace thelma
