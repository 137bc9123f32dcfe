#include "app/scene/triangulated.h"

#include <algorithm>
#include <utility>

#include <isect/orient.h>
#include <isect/segment_segment.h>

#include "app/scene/in_plane.h"
#include "lessons/shared/vertices.h"

namespace isect::program::scene {

namespace {

using Corner = Point<double, 2>;
using Three = std::array<int, 3>;

/// The corners of an outline, counter-clockwise, of which ears are cut off. It may touch itself.
class Ears {
 public:
  explicit Ears(const Ring<double, 2>& corners) : corners_(corners) {
    for (int i = 0; i < static_cast<int>(corners_.size()); ++i) left_.push_back(i);
  }

  /// Three corners each, counter-clockwise, as the outline's edges are: so they cover what it winds around, each point
  /// as often as it does. None where no more ears are found although corners are left.
  std::vector<Three> cut() {
    std::vector<Three> triangles;
    for (std::size_t at = 0, tried = 0; left_.size() > 2 && tried <= left_.size(); ++tried) {
      at %= left_.size();
      const Three three = {left(at + left_.size() - 1), left(at), left(at + 1)};
      if (!is_ear(three)) {
        ++at;
        continue;
      }
      triangles.push_back(three);
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
      tried = 0;
    }
    return left_.size() > 2 ? std::vector<Three>() : triangles;
  }

 private:
  int left(std::size_t i) const { return left_[i % left_.size()]; }
  const Corner& corner(int i) const { return corners_[static_cast<std::size_t>(i)]; }

  /// A triangle with an area that holds no other corner, not even on its boundary, but where corners touch; and whose
  /// third side crosses no edge.
  bool is_ear(const Three& three) const {
    const auto [a, b, c] = three;
    if (orient2d(corner(a), corner(b), corner(c)) <= 0) return false;
    bool touched = false;
    for (const int i : left_) {
      if (i == a || i == b || i == c) continue;
      const Corner& p = corner(i);
      if (p == corner(a) || p == corner(b) || p == corner(c))
        touched = true;
      else if (orient2d(corner(a), corner(b), p) >= 0 && orient2d(corner(b), corner(c), p) >= 0 &&
               orient2d(corner(c), corner(a), p) >= 0)
        return false;
    }
    return !touched || !is_crossed({corner(a), corner(c)});
  }
  bool is_crossed(const Segment<double, 2>& side) const {
    for (std::size_t i = 0; i < left_.size(); ++i)
      if (const Segment<double, 2> own = {corner(left(i)), corner(left(i + 1))};
          intersect(side, own).relation == segment_segment::Meeting::cross)
        return true;
    return false;
  }

  const Ring<double, 2>& corners_;
  std::vector<int> left_;  ///< what is not cut off yet
};

/// An outline counter-clockwise as it is seen, each of its corners once.
struct Seen {
  std::vector<int> numbers = {};
  Ring<double, 2> corners = {};
  bool clockwise;

  explicit Seen(const Ring<double, 3>& outline) {
    const Projection along = projection(outline);
    clockwise = along.clockwise;
    const auto at = [&](int i) -> const Point<double, 3>& { return outline[static_cast<std::size_t>(i)]; };
    for (int i = 0; i < static_cast<int>(outline.size()); ++i)
      if (numbers.empty() || at(numbers.back()) != at(i)) numbers.push_back(i);
    if (numbers.size() > 1 && at(numbers.front()) == at(numbers.back())) numbers.pop_back();
    if (clockwise) std::ranges::reverse(numbers);
    for (const int i : numbers) corners.emplace_back(at(i)[along.x], at(i)[along.y]);
  }
  bool simple() const { return lessons::is_simple(corners); }

  /// By the numbers of the outline's corners, turning as it does.
  std::vector<Three> as_given(std::vector<Three> triangles) const {
    for (Three& three : triangles) {
      for (int& i : three) i = numbers[static_cast<std::size_t>(i)];
      if (clockwise) std::swap(three[0], three[2]);
    }
    return triangles;
  }
};

/// Of two triangles, both counter-clockwise: whether they have no common interior.
bool apart(const Ring<double, 2>& corners, const Three& a, const Three& b) {
  const auto corner = [&](int i) { return corners[static_cast<std::size_t>(i)]; };
  const auto parts = [&](const Three& s, const Three& t) {
    for (std::size_t i = 0; i < 3; ++i)
      if (std::ranges::all_of(t, [&](int k) { return orient2d(corner(s[i]), corner(s[(i + 1) % 3]), corner(k)) <= 0; }))
        return true;
    return false;
  };
  return parts(a, b) || parts(b, a);
}
bool all_apart(const Ring<double, 2>& corners, const std::vector<Three>& triangles) {
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!apart(corners, triangles[i], triangles[j])) return false;
  return true;
}

}  // namespace

bool is_simple(const Ring<double, 3>& outline) { return Seen(outline).simple(); }

std::vector<Three> ears(const Ring<double, 3>& outline) {
  const Seen seen(outline);
  std::vector<Three> triangles = Ears(seen.corners).cut();
  if (!seen.simple() && !all_apart(seen.corners, triangles)) return {};
  return seen.as_given(std::move(triangles));
}

std::vector<Triangle<double, 3>> triangulated(const Ring<double, 3>& outline) {
  if (!is_simple(outline)) return {};
  const auto corner = [&](int i) { return outline[static_cast<std::size_t>(i)]; };
  std::vector<Triangle<double, 3>> all;
  for (const auto& [a, b, c] : ears(outline)) all.push_back({{corner(a), corner(b), corner(c)}});
  return all;
}

}  // namespace isect::program::scene
