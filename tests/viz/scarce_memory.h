#pragma once
// Memory that runs out when a test says so, and is counted until then: scarce_memory.cpp replaces operator new.

namespace isect::tests {

/// How many more allocations of this thread succeed; negative: all of them.
extern thread_local long allocations_left;

}  // namespace isect::tests
