#pragma once
// The knobs that lessons have in common.

#include <string>
#include <utility>
#include <vector>

#include "viz/lesson.h"

namespace isect::lessons {

/// One of several named settings; at the start number `initial`.
inline viz::Parameter choice(std::string name, std::string label, std::string help,
                             std::vector<std::string> choices, std::size_t initial = 0) {
  viz::Parameter p{std::move(name), std::move(label), std::move(help), choices.at(initial)};
  p.choices = std::move(choices);
  return p;
}

}  // namespace isect::lessons
