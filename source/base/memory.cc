#include <thelma/base/memory.h>

#include <cstdlib>
#include <unistd.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace thelma
{

void release_memory()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

double machine_memory()
{
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

} // namespace thelma
