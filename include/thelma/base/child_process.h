#pragma once

#include <functional>
#include <string>

namespace thelma
{

/// What @p action returns, found in a process of its own: a library that crashes, exits or takes
/// all memory there takes nothing else along. The child gets @p most_memory bytes. Throws
/// InputError: the action's own, or @p complaint with the reason after it, if the child ends
/// without an answer.
std::string in_child_process(const std::function<std::string()>& action, double most_memory,
                             const std::string& complaint);

} // namespace thelma
