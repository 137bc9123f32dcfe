#pragma once

#include <cstddef>
#include <string_view>

namespace isect::viz {

/// A file that claims to carry more than this is hostile: no figure's metadata comes near.
inline constexpr std::size_t metadata_limit = std::size_t{1} << 20;

/// The prefix of our own metadata in a file.
inline constexpr std::string_view metadata_mark = "isect:";

}  // namespace isect::viz
