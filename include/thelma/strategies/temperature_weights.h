#pragma once

#include <thelma/fields/state.h>

#include <vector>

namespace thelma
{

/// What a change of temperature foretells: the weights, of sum 1, with which the states of the
/// @p path come nearest to the temperature @p theta. Theirs is block @p b.
std::vector<double> temperature_weights(const std::vector<State::Accepted>& path,
                                        const BlockVector::BlockType& theta, unsigned int b);

} // namespace thelma
