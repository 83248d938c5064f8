#include <thelma/base/stop_signal.h>

#include <csignal>

namespace thelma
{
namespace
{

volatile std::sig_atomic_t requested = 0;

extern "C" void request_stop(int)
{
  requested = 1;
}

} // namespace

void listen_for_signals()
{
  struct sigaction stop = {};
  stop.sa_handler = request_stop;
  stop.sa_flags = SA_RESETHAND | SA_RESTART;
  sigaction(SIGINT, &stop, nullptr); // a second one ends at once
  sigaction(SIGTERM, &stop, nullptr);
  sigaction(SIGUSR1, &stop, nullptr);
  std::signal(SIGXFSZ, SIG_IGN);
}

bool stop_requested()
{
  return requested != 0;
}

} // namespace thelma
