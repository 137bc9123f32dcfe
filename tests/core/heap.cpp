#include "tests/core/heap.h"

#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <new>

namespace heap {
std::size_t in_use = 0, most_in_use = 0, calls = 0;
}

void* operator new(std::size_t size) {
  void* p = std::malloc(size);
  if (!p) throw std::bad_alloc();
  ++heap::calls;
  heap::in_use += malloc_usable_size(p);
  heap::most_in_use = std::max(heap::most_in_use, heap::in_use);
  return p;
}
void operator delete(void* p) noexcept {
  heap::in_use -= malloc_usable_size(p);
  std::free(p);
}
void operator delete(void* p, std::size_t) noexcept { operator delete(p); }
