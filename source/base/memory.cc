#include <thelma/base/memory.h>

#include <cstdlib>
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

} // namespace thelma
