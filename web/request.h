#pragma once
// What a page's requests and links say: places, values as they were typed, cameras, bytes of files.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "viz/lesson.h"

namespace isect::web {

viz::Vec2 point_in(const nlohmann::ordered_json& request);
/// Returns which way an arrow key goes.
viz::Vec2 way_in(const nlohmann::ordered_json& request);

/// Works as `set` of viz/lesson.h, for what people type: "1,5" is a number, and "1, 5, 2" or "(1, 5, 2)" a point.
void set_typed(const viz::Lesson&, viz::Parameters& to, const std::string& name, const std::string& text);

/// Returns the camera as a link has it: seven numbers.
std::string camera_text(const viz::Camera&);
/// Throws viz::BadInput.
viz::Camera camera_from(const std::string& text, const viz::Lesson&);

/// Returns the bytes that a text in base64 stands for. Throws viz::BadInput.
std::string bytes_of(const std::string& base64);

}  // namespace isect::web
