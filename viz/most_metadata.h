#pragma once

#include <cstddef>
#include <string_view>

namespace isect::viz {

/// What a file claims to carry beyond this is hostile: no figure's comes near.
inline constexpr std::size_t most_metadata = std::size_t{1} << 20;

/// Before our own among what a file carries.
inline constexpr std::string_view metadata_mark = "isect:";

}  // namespace isect::viz
