#pragma once
// The screens that a line may lie behind, point by point.

#include <algorithm>
#include <cmath>
#include <vector>

#include <isect/shapes.h>
#include "viz/camera.h"

namespace isect::viz {

/// Screens by where the eye sees them along a segment: of the many facets of a mesh that cross it, few lie at each
/// point of it.
class ScreensAlong {
 public:
  ScreensAlong(const Vec3& from, const Vec3& to, const View& view, const std::vector<Polygon<double, 3>>& screens)
      : view_(view), from_(view.project(from).at), way_(view.project(to).at - from_), parts_(screens.size()) {
    const bool seen = is_before_the_eye(from) && is_before_the_eye(to) && way_.squaredNorm() > 1;  // pixels
    for (const Polygon<double, 3>& screen : screens) {
      double lo = HUGE_VAL, hi = -HUGE_VAL;
      bool known = seen;
      for (const Ring<double, 3>& ring : screen.rings)
        for (const Vec3& p : ring)
          lo = std::min(lo, share(p)), hi = std::max(hi, share(p)), known = known && is_before_the_eye(p);
      constexpr double doubt = 1e-6;
      if (!known || !(lo <= hi))
        anywhere_.push_back(&screen);
      else if (hi > -doubt && lo < 1 + doubt)
        for (std::size_t i = part(lo - doubt); i <= part(hi + doubt); ++i) parts_[i].push_back(&screen);
    }
  }

  /// Whether `test` is true of a screen that the eye may see at the segment's point p.
  bool any(const Vec3& p, const auto& test) const {
    const auto holds = [&](const Polygon<double, 3>* screen) { return test(*screen); };
    return std::ranges::any_of(anywhere_, holds) || std::ranges::any_of(parts_[part(share(p))], holds);
  }

 private:
  bool is_before_the_eye(const Vec3& p) const {
    return !view_.camera().perspective || view_.project(p).depth > 1e-4 * (p - view_.eye()).norm();
  }
  /// Returns which share of the way from the segment's begin to its end has been gone beside p, as the eye sees it.
  double share(const Vec3& p) const { return (view_.project(p).at - from_).dot(way_) / way_.squaredNorm(); }
  std::size_t part(double gone) const {
    const double parts = static_cast<double>(parts_.size());
    return gone > 0 ? static_cast<std::size_t>(std::min(gone * parts, parts - 1)) : 0;
  }

  const View& view_;
  Vec2 from_, way_;
  std::vector<std::vector<const Polygon<double, 3>*>> parts_;
  std::vector<const Polygon<double, 3>*> anywhere_;
};

}  // namespace isect::viz
