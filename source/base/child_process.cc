#include <thelma/base/child_process.h>
#include <thelma/base/error.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <new>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace thelma
{
namespace
{

/// First letters of an answer; a failure is told beside the parent's complaint.
constexpr char result = 'r', error = 'e', failure = 'f';

/// What is told of a crash is the parent's to say, and a stop ends the child at once.
void forget_signals()
{
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTERM, SIGINT, SIGUSR1})
    std::signal(number, SIG_DFL);
}

void limit_memory([[maybe_unused]] const double bytes)
{
#ifndef __SANITIZE_ADDRESS__ // whose shadow is larger than any limit
  const auto most = static_cast<rlim_t>(bytes);
  const rlimit limit{most, most};
  setrlimit(RLIMIT_AS, &limit);
#endif
}

void write_all(const int descriptor, const std::string& text)
{
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t n = write(descriptor, text.data() + done, text.size() - done);
    if (n <= 0)
      return;
    done += static_cast<std::size_t>(n);
  }
}

std::string read_all(const int descriptor)
{
  std::string text;
  std::array<char, 1 << 16> buffer{};
  for (ssize_t n = 0; (n = read(descriptor, buffer.data(), buffer.size())) != 0;)
    if (n > 0)
      text.append(buffer.data(), static_cast<std::size_t>(n));
    else if (errno != EINTR)
      break;
  return text;
}

std::string answer(const std::function<std::string()>& action)
{
  try {
    return result + action();
  } catch (const InputError& complaint) {
    return error + std::string(complaint.what());
  } catch (const std::bad_alloc&) {
    return "";
  } catch (const std::exception& other) {
    return failure + std::string(other.what());
  } catch (...) { // what leaves here would run on as if it were the parent
    return failure + std::string("unknown error");
  }
}

std::string reason(const int status)
{
  return WIFSIGNALED(status) ? strsignal(WTERMSIG(status)) : "it exited or ran out of memory";
}

} // namespace

std::string in_child_process(const std::function<std::string()>& action, const double most_memory,
                             const std::string& complaint)
{
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0)
    throw InputError(complaint + " (" + std::strerror(errno) + ")");
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    prctl(PR_SET_PDEATHSIG, SIGKILL); // no one waits for it then
    forget_signals();
    limit_memory(most_memory);
    write_all(ends[1], answer(action));
    _exit(0);
  }
  close(ends[1]);
  const std::string text = read_all(ends[0]);
  close(ends[0]);
  int status = 0;
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR)
    ;
  if (child < 0 || status != 0 || text.empty())
    throw InputError(complaint + " (" + reason(status) + ")");
  if (text[0] == error)
    throw InputError(text.substr(1));
  if (text[0] == failure)
    throw InputError(complaint + " (" + text.substr(1) + ")");
  return text.substr(1);
}

} // namespace thelma
