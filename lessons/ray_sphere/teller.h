#pragma once
// What the three walks share: running the core on counting scalars, and the questions and verdicts that come from the
// exact test.

#include "core/counted.h"
#include "lessons/ray_sphere/picture.h"
#include "lessons/script.h"

namespace isect::lessons::ray_sphere_lesson {

/// Runs `method(ray, sphere, record)` with every number counted; gives its events with the operations before each.
template <class Event, class Method>
std::vector<std::pair<Event, Tally>> run(const Setup& s, const Method& method) {
  using C = Counted<double>;
  const Ray<C, 3> ray = {s.ray.origin.cast<C>(), s.ray.direction.cast<C>(), {s.ray.range.lo, s.ray.range.hi}};
  const Sphere<C, 3> sphere = {s.sphere.center.cast<C>(), s.sphere.radius};
  CountingRecord<Event> record;
  tally() = {};
  method(ray, sphere, record);
  return record.events;
}

/// "How many points does the line share with the sphere?"
viz::Question roots_question(const Setup&);
/// "Which is the first hit?" with the names of the two roots.
viz::Question first_hit_question(const Setup&, const std::vector<std::string>& roots);
/// "Can the ball be rejected already?"
viz::Question behind_question(bool rejected);

std::string verdict_text(const Setup&);
std::string miss_caption(const Setup&);
/// What the solid ball adds to the answer for its surface.
std::string solid_caption(const Setup&);

}  // namespace isect::lessons::ray_sphere_lesson
