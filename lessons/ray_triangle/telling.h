#pragma once
// The four walks, and what three of them share: the range, the verdict, and what the weights are for.

#include <optional>
#include <string>
#include <vector>

#include <isect/methods/ray_triangle.h>
#include "lessons/ray_triangle/picture.h"
#include "lessons/shared/teller.h"

namespace isect::lessons::ray_triangle_lesson {

viz::Walk moller_trumbore(const Setup&);
viz::Walk volumes(const Setup&);  ///< by three signed volumes
viz::Walk shear(const Setup&);    ///< by three areas, after a shear
viz::Walk seam(const Setup&);     ///< two triangles, and all neighbours of a ray

/// "the ray hits the triangle at *t* = 2"
std::string verdict_text(const Setup&);

class Teller : protected PictureTeller<Setup, Known> {
 protected:
  using C = Counted<double>;

  Teller(const Setup&, const std::string& title, const std::string& source, std::vector<std::string> pseudocode);

  /// Runs `method(ray, triangle, record)` with every operation counted, and says each event.
  template <class Event, class Method, class Say>
  void run(const Method& method, const Say& say) {
    const Ray<C, 3> ray = cast<C>(s_.ray);
    const Triangle<C, 3> triangle = cast<C>(s_.triangle);
    script_.tell<Event>([&](auto& record) { found_ = method(ray, triangle, record); }, say);
  }

  /// Asks on `line` whether n . d, or what stands for it, is 0.
  void parallel(int line, const std::string& name, double value);
  /// Asks on `line` whether t lies in the range.
  void range(int line, double t, bool holds);
  /// Adds the last step: a miss on the line below the step before, or a hit on `line`, and what its weights mix.
  void end(int line);
  /// "\nRounding decides wrongly here: exactly, ...", unless the method decides as the exact test does.
  std::string unless(bool as_exactly, const std::string& truth) const;

  std::optional<ray_triangle::Hit<C>> found_;

 private:
  void interpolate(int line);
  std::string reason() const;
};

}  // namespace isect::lessons::ray_triangle_lesson
