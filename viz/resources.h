#pragma once
// What the system grants this process. Mesa, GLib and Pango crash where they are refused memory or a thread, so they
// are asked for beforehand.

#include <cstddef>

namespace isect::viz {

/// Whether so many more bytes of addresses may be taken.
bool has_room(std::size_t bytes);
/// Up to the first picture, one thread takes 385 MB beyond what the program had. Sixteen take 1.6 GB, most of it for
/// heaps of their own.
inline constexpr std::size_t ample_room = std::size_t{3} << 30;
/// Before any thread begins: where room is not ample, all share one heap. One of its own takes 64 MB of addresses,
/// after which fontconfig, in Pango's thread, is refused the few bytes that it does not ask after.
void share_scarce_heap();
/// Whether so many more threads may run at once.
bool has_threads(int count);

}  // namespace isect::viz
