#pragma once
// The memory and threads that the system grants this process. Mesa, GLib and Pango crash where they are refused either,
// so it is checked beforehand.

#include <cstddef>

namespace isect::viz {

/// Whether so many more bytes of address space may be taken.
bool has_room(std::size_t bytes);
/// Enough room for all threads: up to the first picture, one thread takes 385 MB beyond what the program had. Sixteen
/// take 1.6 GB, most of it for heaps of their own.
inline constexpr std::size_t ample_room = std::size_t{3} << 30;
/// Call it before any thread begins: where room is not ample, all threads share one heap. A heap of its own takes 64 MB
/// of addresses, after which fontconfig, in Pango's thread, is refused the few bytes whose failure it does not check.
void share_scarce_heap();
/// Whether so many more threads may run at once.
bool has_threads(int count);

}  // namespace isect::viz
