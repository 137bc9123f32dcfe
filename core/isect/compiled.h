#pragma once
// Any two shapes, asked through a compiled library: link isect::core_compiled.
//
//   using isect::compiled::Shape3;
//   const Shape3 ball = Shape3::sphere({0, 0, 0}, 1), box = Shape3::aabb({0.5, 0, 0}, {2, 1, 1});
//   const bool meet = ask(ball, box)->meet;  // an optional: some pairs in space have no test
//
// A file that includes this header compiles in half a second: Eigen and all tests stay in the library. A call also
// looks up the pair, which the pair's own header does when it is compiled. The shapes are those of isect/shapes.h in
// doubles, with the same fields in the same order, and floats are doubles, too; the answers are those of `ask`
// (isect/ask.h), bit for bit.

#include <array>
#include <optional>
#include <vector>

#include <isect/answer.h>

namespace isect::compiled {

/// A shape of any type in the plane (N = 2) or in space (N = 3). It never changes, so several threads may ask about
/// one. A shape that was moved from may only be assigned to.
template <int N>
class Shape {
 public:
  using Point = std::array<double, N>;
  using Ring = std::vector<Point>;
  struct Plane {
    Point normal;
    double d;
  };
  struct Slab {
    Point normal;
    Interval<double> range;
  };

  static Shape point(const Point&);
  static Shape segment(const Point& p, const Point& q);
  static Shape ray(const Point& origin, const Point& direction, Interval<double> range = semi_infinite<double>);
  /// normal.x + d = 0
  static Shape plane(const Point& normal, double d);
  static Shape sphere(const Point& center, double radius);
  static Shape capsule(const Point& p, const Point& q, double radius);
  static Shape aabb(const Point& lo, const Point& hi);
  /// The axes may have any length, and are independent.
  static Shape obb(const Point& center, const std::array<Point, N>& axes, const Point& half);
  static Shape kdop(const std::vector<Slab>&);
  static Shape triangle(const Point& a, const Point& b, const Point& c);

  /// Rings with holes and islands, by the even-odd rule.
  static Shape polygon(const std::vector<Ring>& rings) requires(N == 2);

  /// Has no point if the outline crosses or touches itself.
  static Shape polygon(const Ring& outline) requires(N == 3);
  /// The points with normal.x + d >= 0 for all six.
  static Shape frustum(const std::array<Plane, 6>& planes) requires(N == 3);
  /// The convex hull of the points. Throws std::invalid_argument where they have no volume, or one is not finite.
  static Shape hull(const std::vector<Point>& points) requires(N == 3);
  /// Triangles of indices of vertices, counter-clockwise seen from outside. Throws std::invalid_argument for an index
  /// of no vertex.
  static Shape mesh(const std::vector<Point>& vertices,
                    const std::vector<std::array<int, 3>>& triangles) requires(N == 3);
  static Shape cylinder(const Point& p, const Point& q, double radius) requires(N == 3);
  static Shape cone(const Point& apex, const Point& base, double radius) requires(N == 3);

  Shape(const Shape&);
  Shape(Shape&& other) noexcept : held_(other.held_) { other.held_ = nullptr; }
  Shape& operator=(Shape other) noexcept {
    Held* const mine = held_;
    held_ = other.held_, other.held_ = mine;
    return *this;
  }
  ~Shape();

  struct Held;  ///< an AnyShape (isect/any_shape.h), known to the library alone
  const Held& held() const { return *held_; }

 private:
  explicit Shape(Held&&);
  Held* held_;
};

using Shape2 = Shape<2>;
using Shape3 = Shape<3>;

/// Returns how they lie; see isect/answer.h. Exact; what is empty, NaN or infinite meets nothing.
Answer ask(const Shape2&, const Shape2&);
/// Empty for a pair that no test decides, such as two cylinders.
std::optional<Answer> ask(const Shape3&, const Shape3&);

}  // namespace isect::compiled
