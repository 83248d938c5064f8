#include <thelma/base/error.h>
#include <thelma/output/folder_lock.h>

#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <sys/file.h>
#include <thread>
#include <unistd.h>

namespace thelma
{

FolderLock::FolderLock(const std::string& folder)
    : descriptor(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC))
{
  constexpr unsigned int tries = 50;
  constexpr std::chrono::milliseconds pause(100);
  for (unsigned int i = 0; flock(descriptor, LOCK_EX | LOCK_NB) != 0; ++i) {
    if (errno != EWOULDBLOCK) // not all network file systems know locks
      return;
    if (i == tries) {
      close(descriptor);
      throw InputError("command line, --output: another run writes into '" + folder +
                       "'; wait until it ends, or choose another folder");
    }
    std::this_thread::sleep_for(pause);
  }
}

FolderLock::~FolderLock()
{
  close(descriptor);
}

} // namespace thelma
