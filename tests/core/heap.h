#pragma once
// What a program has asked of operator new; heap.cpp counts it, for tests of one thread.

#include <cstddef>

namespace heap {
extern std::size_t in_use, most_in_use;  ///< bytes
extern std::size_t calls;                ///< of operator new
}  // namespace heap
