#include "viz/gl/resources.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <sys/mman.h>

#include <latch>
#include <system_error>
#include <thread>
#include <vector>

namespace isect::viz {

bool has_room(std::size_t bytes) {
  void* room = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (room == MAP_FAILED) return false;
  ::munmap(room, bytes);
  return true;
}

void share_scarce_heap() {
#ifdef __GLIBC__
  if (!has_room(ample_room)) ::mallopt(M_ARENA_MAX, 1);
#endif
}

bool has_threads(int count) {
  std::latch counted(1);
  std::vector<std::thread> threads;
  try {
    while (static_cast<int>(threads.size()) < count) threads.emplace_back([&] { counted.wait(); });
  } catch (const std::system_error&) {
  }
  counted.count_down();
  for (std::thread& thread : threads) thread.join();
  return static_cast<int>(threads.size()) == count;
}

}  // namespace isect::viz
