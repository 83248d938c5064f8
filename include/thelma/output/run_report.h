#pragma once

#include <thelma/output/outcome.h>

#include <optional>
#include <string>

namespace thelma
{

/// Write run.json, where programs look up what happened.
void write_run_report(const Outcome& outcome, const std::string& scene, const std::string& file);

/// How the run ended, what it cost and its final values as run.json tells them; nothing if there
/// is no such file or it cannot be read.
std::optional<Outcome> read_run_report(const std::string& file);

/// The path of the scene whose report @p file is; empty if it cannot be read.
std::string scene_of_report(const std::string& file);

} // namespace thelma
