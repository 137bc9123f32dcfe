#include "tests/viz/scarce_memory.h"

#include <cstdlib>
#include <new>

namespace isect::tests {
thread_local long allocations_left = -1;
}

void* operator new(std::size_t size) {
  using isect::tests::allocations_left;
  if (allocations_left == 0) throw std::bad_alloc();
  if (allocations_left > 0) --allocations_left;
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
