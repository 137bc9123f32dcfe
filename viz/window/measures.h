#pragma once
// The number of a lit name, drawn at the line, the arrow or the arc that it measures.

#include <optional>
#include <string>

#include "viz/window/window_session.h"

namespace isect::viz {

/// A number that the step on show gives, or a knob: both as plain text. `name` may be a power of the name asked for.
struct Measure {
  std::string name, number;
};

/// Returns what is known of a name (viz/text/names.h) at the step on show. While a question is open, that is what the
/// question gives.
std::optional<Measure> measure_of(const Player&, const std::string& key);

/// Returns the words beside a thing whose label is `label`, plain: "= 4.472" where the label is the name itself, else
/// "m² = 21.15".
std::string words_beside(const Measure&, const std::string& label);

/// Draws such words, near-black on the highlight, right of `at` or left of it, within the scene.
void measure_chip(Ui&, const std::string& key, const std::string& words, const Rect& at, const Rect& scene,
                  double strength);

}  // namespace isect::viz
