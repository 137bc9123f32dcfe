#pragma once
// Three points as drawn and as tested; what the core reports of their orientation, and of each neighbour's.

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <isect/orient.h>
#include "lessons/shared/microscope.h"
#include "viz/lesson.h"

namespace isect::lessons::rounding_bound_lesson {

using Point2 = Point<double, 2>;

inline constexpr double u = 0x1p-53;  ///< the unit roundoff

/// What the parameters say. The points are tested in their unit: 1, 2^515 or 2^-530.
struct Setup {
  explicit Setup(const viz::Parameters&);

  viz::Vec3 a, b, c;            ///< as drawn
  double unit;                  ///< a power of two
  double factor;                ///< the filter takes its bound times this
  std::array<int, 2> selected;  ///< which neighbour of a is tested, in steps to the right and up
  Point2 tested_b, tested_c;

  Point2 tested_a() const;
};

/// What the core reports of one sign. The operations are those of its text, each with its error and its bound.
struct Run {
  explicit Run(const Setup&);

  /// The differences in the order of the text, a.x - c.x first; then the products and what is left of them.
  std::array<Operation, 4> differences;
  Operation left, right, det;
  std::vector<Stage> stages;  ///< those that ran; the last one decided
  int truth;

  double size() const { return det.size; }
  double bound() const { return det.bound; }
  const Stage& decided() const { return stages.back(); }
  bool overflows() const { return !std::isfinite(det.value) || !std::isfinite(det.bound); }
  /// Whether products may underflow; and whether one did, and lost more than one rounding takes.
  bool tiny() const { return size() < 0x1p-900; }
  /// Whether both products are exactly 0.
  bool vanish() const { return left.value == 0 && right.value == 0 && left.error == 0 && right.error == 0; }
  bool underflows() const { return std::abs(left.delta) > u || std::abs(right.delta) > u; }
};

/// Whether a filter lets the sign of det through, its bound taken times a factor. With the factor 1 this is what the
/// core asks.
inline bool passes(double det, double bound, double factor) { return std::abs(det) - factor * bound >= 0; }
inline int sign_of_double(double x) { return (x > 0) - (x < 0); }

/// What is known of one cell of the microscope.
struct Neighbour {
  double det, bound;    ///< in doubles
  Stage::Kind decided;  ///< by which stage
  int truth;

  bool passes(double factor) const { return rounding_bound_lesson::passes(det, bound, factor); }
  /// Whether a wrong sign gets through.
  bool wrong(double factor) const { return passes(factor) && sign_of_double(det) != truth; }
};
/// All neighbours, in the order of microscope::for_each_neighbour.
std::vector<Neighbour> neighbours(const Setup&);

/// "left of the line", "on the line", "right of the line"
std::string place(int sign);

/// A stage in words, and what core/isect/numbers/README.md says of it.
struct StageWords {
  const char* name;  ///< "two doubles"
  const char* slug;
  int bits;     ///< 0: as many as it takes, or none
  double cost;  ///< the time of orient3d's polynomial, divided by that in plain doubles
};
const StageWords& words_of(Stage::Kind);

/// (telling.cpp)
viz::Walk tell(const Setup&);
/// The text before the first step, and the card after the last one. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();

}  // namespace isect::lessons::rounding_bound_lesson
