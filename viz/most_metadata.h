#pragma once

#include <cstddef>

namespace isect::viz {

/// What a file claims to carry beyond this is hostile: no figure's comes near.
inline constexpr std::size_t most_metadata = std::size_t{1} << 20;

}  // namespace isect::viz
