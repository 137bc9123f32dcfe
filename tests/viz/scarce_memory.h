#pragma once
// Memory that runs out when a test says so: scarce_memory.cpp replaces operator new.

namespace player_throws_test {

/// How many more allocations of this thread succeed; negative: all of them.
extern thread_local long allocations_left;

}  // namespace player_throws_test
