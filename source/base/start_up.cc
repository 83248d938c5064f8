#include <thelma/base/start_up.h>

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <iostream>

/// There if the BLAS happens to be OpenBLAS.
extern "C" void openblas_set_num_threads(int) __attribute__((weak));

namespace thelma
{
namespace
{

/// By what mpirun or a batch system leaves for the processes that it starts.
bool launched()
{
  const auto names = {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"};
  return std::any_of(names.begin(), names.end(), [](auto name) { return std::getenv(name); });
}

/// A process that nothing launched: 0.4 s in place of 0.8 s until it begins.
void leave_out_of_open_mpi_what_one_process_does_without()
{
  // The daemon to spawn others with: 0.2 s.
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  // Without the daemon all such processes have the same name, and one that ends removes the folder
  // that another has just found or is about to make.
  setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
  // The libraries of networks: one of them measures the processor's clock for 0.2 s.
  setenv("OMPI_MCA_pml", "ob1", 0);
}

/// Whether all ranks are on this computer, as far as mpirun says so.
bool share_a_computer()
{
  const char *all = std::getenv("OMPI_COMM_WORLD_SIZE"),
             *here = std::getenv("OMPI_COMM_WORLD_LOCAL_SIZE");
  return all != nullptr && here != nullptr && std::strcmp(all, here) == 0;
}

/// The value of @p name; getenv() does not know the environment yet.
const char* value_in(char** environment, const char* name)
{
  const std::size_t n = std::strlen(name);
  for (char** entry = environment; *entry != nullptr; ++entry)
    if (std::strncmp(*entry, name, n) == 0 && (*entry)[n] == '=')
      return *entry + n + 1;
  return nullptr;
}

/// For rank 0 to tell.
[[noreturn]] void refuse(char** environment, const char* sentence)
{
  const char* rank = value_in(environment, "OMPI_COMM_WORLD_RANK");
  const bool tells = rank == nullptr || std::strcmp(rank, "0") == 0;
  const ssize_t written = tells ? write(STDERR_FILENO, sentence, std::strlen(sentence)) : 0;
  _exit(written < 0 ? 70 : 1);
}

/// What makes libraries throw while they are loaded, where nothing can catch it: deal.II reads this
/// variable, and others ask for the working folder.
void check_surroundings(int, char**, char** environment)
{
  if (const char* threads = value_in(environment, "DEAL_II_NUM_THREADS")) {
    const std::size_t n = std::strlen(threads);
    if (n == 0 || n > 6 || std::strspn(threads, "0123456789") != n || std::atoi(threads) == 0)
      refuse(environment,
             "thelma: the environment variable DEAL_II_NUM_THREADS is not a number of threads; set "
             "it to 1, or unset it\n");
  }
  char folder[65536];
  if (getcwd(folder, sizeof(folder)) == nullptr)
    refuse(environment,
           "thelma: the working directory cannot be found, perhaps because it was deleted; change "
           "to another one\n");
}

/// Before any library's own.
__attribute__((section(".preinit_array"), used)) void (*const first)(int, char**,
                                                                     char**) = check_surroundings;

void prepare_process()
{
  // More threads than ranks only compete; in the bending scene they spent 41 % of all CPU time in
  // the kernel.
  if (openblas_set_num_threads != nullptr)
    openblas_set_num_threads(1);
  if (!launched())
    leave_out_of_open_mpi_what_one_process_does_without();
  else if (share_a_computer())
    // Ranks that meet in memory need no network; some cannot be paired, which Open MPI 5 complains
    // about.
    setenv("OMPI_MCA_btl", "^tcp", 0);
}

volatile std::sig_atomic_t last_code = 0;

void leave(int)
{
  _exit(last_code);
}

} // namespace

Process::Process(char* name)
    : alone(!launched()), names{{name, nullptr}}, mpi((prepare_process(), argc), argv, 1)
{
}

/// Open MPI 4 tells a thread of its own to end in a way that the thread misses, once in some
/// thousand runs, if it is about to wait for events; MPI_Finalize then never returns.
int Process::end(const int code) const
{
  constexpr unsigned int enough = 5; // seconds
  if (alone) {
    std::cout.flush();
    last_code = code;
    std::signal(SIGALRM, leave);
    alarm(enough);
  }
  return code;
}

} // namespace thelma
