#pragma once

namespace thelma
{

/// From now on SIGTERM and SIGINT (Ctrl-C) ask the run to stop between two steps, and so does
/// SIGUSR1, which mpirun passes on to all ranks. A second one has the system's effect. A file that
/// grows too large is a write that fails.
void listen_for_signals();

/// Whether this process has been asked to stop.
bool stop_requested();

} // namespace thelma
