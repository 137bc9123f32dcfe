#pragma once
// Pages of many pairs: all relations of one kind, the same pose of all kinds, all of both.

#include "lessons/relations/picture.h"
#include "lessons/shared/plane.h"

namespace isect::lessons::relations_lesson {

extern const std::vector<std::string> note_pseudocode;
inline constexpr const char* all_kinds = "all kinds";  ///< a choice beside the kinds
inline const viz::Camera camera = {.azimuth = azimuth, .elevation = elevation};

/// The six relations of a kind, each pair with the answer of the yes or no test below it.
viz::Scene six(Kind);
/// A walk that shows the same pose for all kinds, then every relation of every kind.
viz::Walk page_of_all(const Pose&);

}  // namespace isect::lessons::relations_lesson
