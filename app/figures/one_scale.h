#pragma once
// Pictures of several settings at one scale: what is one unit long in the world is equally long in all of them.

#include <cstddef>
#include <map>
#include <vector>

#include "app/excerpt.h"
#include "viz/camera.h"
#include "viz/lesson.h"

namespace isect::program {

/// Each setting is seen from its own direction, and its chosen steps lie in the middle of the picture; or where a
/// preset's file says, or a step that has a view of its own. What the largest of them needs decides the scale. Pictures
/// of one size then have one scale, and eyes in perspective one distance. Charts and cards of text have no scale and
/// are left out of account.
class OneScale {
 public:
  /// Throws viz::BadInput if the settings have fields of view that differ, or one of them would be too small to see.
  explicit OneScale(Excerpts);

  /// Returns the chosen steps of all settings, one after the other, as one walk: so that all pictures have the rows
  /// that any of them needs.
  const viz::Walk& walk() const { return walk_; }
  /// Returns the setting to which a step of that walk belongs.
  std::size_t case_of(int step) const;
  /// Returns width / height of a picture that holds the widest and the highest of them.
  double shape() const;
  /// Returns the camera of a step of that walk, for a picture of this aspect: width / height.
  const viz::Camera& camera(int step, double aspect) const;

 private:
  /// Steps of a setting that are seen from one place.
  struct Case {
    const Excerpt* e;
    std::size_t setting;
    std::vector<const viz::Scene*> scenes;  ///< all that has a scale
    viz::StepView seen;                     ///< its direction, and its place as far as it is known
    int end = 0;                            ///< its last step's number, from 1
  };
  std::size_t place_of(int step) const;
  std::vector<viz::Camera> cameras(double aspect) const;
  void require_all_visible(const std::vector<double>& half_heights, double common) const;

  std::vector<Case> cases_;
  viz::Walk walk_;
  mutable std::map<double, std::vector<viz::Camera>> known_;  ///< by aspect
};

}  // namespace isect::program
