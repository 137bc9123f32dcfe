#pragma once
// The base of what tells the walks of a lesson, where each step shows one picture of what is known by then.

#include <string>
#include <utility>

#include "lessons/shared/script.h"

namespace isect::lessons {

/// `Setup` is what the lesson's parameters say, `Known` what a step may show; the lesson's picture(Setup, Known) draws.
template <class Setup, class Known>
class PictureTeller {
 protected:
  PictureTeller(const Setup& s, Opening opening) : s_(s), script_(std::move(opening)) {}

  /// Adds a step with the picture. The reference holds until the next one is added.
  viz::Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption,
                 const std::string& formula = {}) {
    viz::Step& step = script_.add(slug, title, line, caption, formula);
    step.scene = picture(s_, known_);
    return step;
  }

  const Setup& s_;
  Script script_;
  Known known_;
};

}  // namespace isect::lessons
