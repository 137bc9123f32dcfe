#include "app/scene/triangulated.h"

#include <algorithm>
#include <array>
#include <utility>

#include <isect/orient.h>

#include "app/scene/in_plane.h"
#include "lessons/shared/vertices.h"

namespace isect::program::scene {

namespace {

using Corner = Point<double, 2>;

/// The corners of a simple outline, counter-clockwise, of which ears are cut off.
class Ears {
 public:
  explicit Ears(std::vector<Corner> corners) : corners_(std::move(corners)) {
    for (int i = 0; i < static_cast<int>(corners_.size()); ++i) left_.push_back(i);
  }

  /// Three corners each.
  std::vector<std::array<int, 3>> cut() {
    std::vector<std::array<int, 3>> triangles;
    for (std::size_t at = 0, tried = 0; left_.size() > 2 && tried <= left_.size(); ++tried) {
      at %= left_.size();
      const std::array<int, 3> three = {left(at + left_.size() - 1), left(at), left(at + 1)};
      if (!is_ear(three)) {
        ++at;
        continue;
      }
      triangles.push_back(three);
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
      tried = 0;
    }
    return triangles;
  }

 private:
  int left(std::size_t i) const { return left_[i % left_.size()]; }
  const Corner& corner(int i) const { return corners_[static_cast<std::size_t>(i)]; }

  /// A triangle with an area that holds no other corner, not even on its boundary.
  bool is_ear(const std::array<int, 3>& three) const {
    const auto [a, b, c] = three;
    if (orient2d(corner(a), corner(b), corner(c)) <= 0) return false;
    return std::ranges::none_of(left_, [&, a = a, b = b, c = c](int i) {
      if (i == a || i == b || i == c) return false;
      const Corner& p = corner(i);
      return orient2d(corner(a), corner(b), p) >= 0 && orient2d(corner(b), corner(c), p) >= 0 &&
             orient2d(corner(c), corner(a), p) >= 0;
    });
  }

  std::vector<Corner> corners_;
  std::vector<int> left_;  ///< what is not cut off yet
};

/// An outline counter-clockwise as it is seen, each of its corners once.
struct Seen {
  Ring<double, 3> ring;
  Ring<double, 2> corners = {};

  explicit Seen(const Ring<double, 3>& outline) : ring(outline) {
    const auto [x, y, clockwise] = projection(outline);
    if (clockwise) std::ranges::reverse(ring);
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    for (const Point<double, 3>& p : ring) corners.emplace_back(p[x], p[y]);
  }
  bool simple() const { return lessons::is_simple(corners); }
};

}  // namespace

bool is_simple(const Ring<double, 3>& outline) { return Seen(outline).simple(); }

std::vector<Triangle<double, 3>> triangulated(const Ring<double, 3>& outline) {
  const Seen seen(outline);
  if (!seen.simple()) return {};
  const auto corner = [&](int i) { return seen.ring[static_cast<std::size_t>(i)]; };
  std::vector<Triangle<double, 3>> all;
  for (const auto& [a, b, c] : Ears(seen.corners).cut()) all.push_back({{corner(a), corner(b), corner(c)}});
  return all;
}

}  // namespace isect::program::scene
