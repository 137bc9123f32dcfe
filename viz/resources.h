#pragma once
// What the system grants this process. Mesa, GLib and Pango crash where they are refused memory or a thread, so they
// are asked for beforehand.

#include <cstddef>

namespace isect::viz {

/// Whether so many more bytes of addresses may be taken.
bool has_room(std::size_t bytes);
/// Whether so many more threads may run at once.
bool has_threads(int count);

}  // namespace isect::viz
