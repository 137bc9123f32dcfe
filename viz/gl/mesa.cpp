#include "viz/gl/mesa.h"

#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "viz/gl/offscreen.h"
#include "viz/gl/resources.h"

namespace isect::viz {
namespace {

constexpr std::size_t megabyte = std::size_t{1} << 20;
constexpr std::size_t least_room = 448 * megabyte;  // see viz/gl/resources.h
/// At most sixteen threads draw; Mesa and Pango start a few more.
constexpr int ample_threads = 24;

void refuse_unless(const char* variable, const std::vector<std::string>& allowed, const char* why) {
  const char* value = std::getenv(variable);
  if (!value || !*value || std::ranges::count(allowed, value) > 0) return;
  throw NoBackend(
      fmt::format("{}={} is set: {}; unset it, or give {}", variable, value, why, fmt::join(allowed, " or ")));
}

}  // namespace

void prepare_mesa() {
  refuse_unless("LP_NATIVE_VECTOR_WIDTH", {"128", "256"}, "Mesa's compiler crashes on other widths");
  refuse_unless("GALLIUM_DRIVER", {"llvmpipe"}, "another driver draws other pixels, or crashes");
  if (has_room(ample_room) && has_threads(ample_threads)) return;
  ::setenv("LP_NUM_THREADS", "1", 1);
  ::mallopt(M_ARENA_MAX, 1);
  if (!has_room(least_room))
    throw NoBackend(
        fmt::format("too little memory: drawing takes {} MB of addresses, and this process may not have "
                    "so many more; raise the limit (ulimit -v)",
                    least_room / megabyte));
}

}  // namespace isect::viz
