#pragma once
// The pointer's viewing ray among the objects, seen from outside, and what the eye sees.

#include "lessons/picking/objects.h"

namespace isect::lessons::picking_lesson {

struct Pointed {
  explicit Pointed(const viz::Vec3& pointer);  ///< its x is not used

  viewing::World world;
  std::vector<Sphere<double, 3>> balls;  ///< one around each object
  viewing::Eye eye;
  viz::Vec3 pointer;
  viewing::Ray3 ray;
  std::optional<BvhHit<double>> truth;  ///< the closest hit

  int size() const { return static_cast<int>(world.objects.size()); }
  /// Whether the ray meets the object's bounding ball.
  bool met(int i) const { return viewing::first_hit(ray, balls[i]).has_value(); }
};

/// What is known so far.
struct Known {
  bool ray = false, volumes = false;
  std::vector<std::pair<int, double>> hits;  ///< object and t
  int kept = -1;
  double kept_t = 0;

  bool tied() const { return hits.size() == 2 && hits[0].second == hits[1].second; }
  viz::Mark mark_of(int i) const;
};

viz::Scene picture(const Pointed&, const Known&);
viz::Scene seen(const Pointed&, const Known&);  ///< as the eye sees it, what is picked highlighted

viz::Walk tell(const viz::Vec3& pointer);  // telling.cpp
/// The text before the first step, and the card after the last one. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();

}  // namespace isect::lessons::picking_lesson
