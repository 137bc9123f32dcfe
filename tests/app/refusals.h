#pragma once
// Why input is refused: what a reader says of it, and what that is for a scene's text.

#include <string>

#include "app/scene/file.h"
#include "viz/lesson.h"

namespace isect::test {

/// Returns what the call says as it refuses its input, nothing if it takes it. Other exceptions pass through.
template <class Call>
std::string refusal_of(const Call& call) {
  try {
    call();
  } catch (const viz::BadInput& e) {
    return e.what();
  }
  return "";
}

/// Returns why a scene's text is refused; nothing if it is read.
inline std::string refused(const std::string& scene) {
  return refusal_of([&] { program::scene::read_scene(scene, ""); });
}

}  // namespace isect::test
