#pragma once
// The colours that the author of a scene may choose: a role of the theme, or a colour of one's own.

#include <optional>
#include <string>

#include "app/scene/source.h"

namespace isect::program::scene {

/// A colour as it is written: one of the two.
struct Chosen {
  std::optional<viz::Role> role = {};
  std::optional<unsigned> rgb = {};  ///< 0xrrggbb
};

/// Reads "second", "#1f77b4", "#abc" or a name of CSS such as "teal". Throws viz::BadInput with the nearest name.
Chosen read_colour(const Source&, const Json&, const Path&);

}  // namespace isect::program::scene
