#include "lessons/ray_sphere/cancellation.h"

#include <fmt/format.h>

#include <cmath>
#include <type_traits>

#include <isect/methods/ray_sphere_stable.h>
#include <isect/numbers/exact.h>
#include "lessons/ray_sphere/telling.h"
#include "lessons/shared/plural.h"

namespace isect::lessons::ray_sphere_lesson {

namespace {

constexpr int many = 10;  ///< of 16 digits: fewer right ones are told of

}  // namespace

int Constant::digits() const { return digits_right(computed, exact); }

bool Constant::cancelled() const { return exact != 0 && digits() < many; }

Constant constant(const Setup& s, double computed) {
  const Exact r(s.sphere.radius);
  Exact c = Exact() - r * r;
  for (int i = 0; i < 3; ++i) {
    const Exact f = Exact(s.ray.origin[i]) - Exact(s.sphere.center[i]);
    c = c + f * f;
  }
  const double exact = c.sign() == 0 ? 0 : c.rounded();
  // Numbers too small to be squared lose digits, too, but not by cancelling.
  const bool large = std::abs(exact) > 1e-3 * s.sphere.radius * s.sphere.radius;
  return {large ? exact : computed, exact};
}

std::optional<double> stable_root(const Setup& s, bool first) {
  std::optional<double> found;
  ray_sphere::stable_roots(s.ray, s.sphere, [&](const auto& event) {
    if constexpr (std::is_same_v<std::decay_t<decltype(event)>, ray_sphere::Root<double>>)
      if ((event.index == 0) == first) found = event.t;
  });
  return found;
}

bool Cure::works() const { return digits_right(root, truth) >= many; }

bool Cure::takes_exact_c() const { return !works() && digits_right(with_exact, truth) >= many; }

std::optional<Cure> cure(const Setup& s, bool first, const Constant& c) {
  if (s.truth.line_roots != 2) return {};
  const std::optional<double> root = stable_root(s, first), other = stable_root(s, !first);
  const double truth = first ? s.truth.roots.lo : s.truth.roots.hi;
  if (!root || !other || truth == 0) return {};
  return Cure{*root, truth, c.exact / (s.ray.direction.squaredNorm() * *other)};
}

std::string lost_in(const Constant& c) {
  if (!c.cancelled()) return {};
  return fmt::format("\n**f** · **f** and *r*^2 nearly cancel: {} of *C* {} right.", digits_in_words(c.digits()),
                     c.digits() < 2 ? "is" : "are");
}

std::string digits_in_words(int count) { return count == 0 ? "no digit" : plural(count, "digit"); }

}  // namespace isect::lessons::ray_sphere_lesson
