#pragma once

#include <thelma/simulation/model.h>

#include <string>
#include <vector>

namespace thelma
{

/// Sentences about the settings of @p prm that have no effect on the model, whose path may be
/// followed (@p follows): they may stand in a file for other cases of a sweep. Loads that nothing
/// applies are bad input.
template <int dim>
std::vector<std::string> unused_entries(const dealii::ParameterHandler& prm,
                                        const Model<dim>& model, bool follows);

} // namespace thelma
