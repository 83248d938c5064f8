#pragma once

#include <string>

namespace thelma
{

/// Keeps other processes from writing into a folder as long as it lives; the system lets go of it
/// for a process that dies.
class FolderLock
{
public:
  /// Waits a little for a run that is about to end. Throws InputError if another one goes on in
  /// @p folder.
  explicit FolderLock(const std::string& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

private:
  int descriptor;
};

} // namespace thelma
