#pragma once
// A microscope: the floating-point neighbours of a point as a grid of cells, and two grips that select one of them.

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "viz/lesson.h"

namespace isect::lessons::microscope {

inline constexpr int half = 32;  ///< cells on either side of the middle one
inline constexpr int columns = 2 * half + 1;

/// The representable number of S that lies `steps` beyond x.
template <class S>
S neighbour(double x, int steps) {
  S y = static_cast<S>(x);
  const S end = steps < 0 ? -std::numeric_limits<S>::infinity() : std::numeric_limits<S>::infinity();
  for (int k = 0; k < std::abs(steps); ++k) y = std::nextafter(y, end);
  return y;
}

/// Calls see(i, j) for the neighbour i steps to the right and j up: row by row from the top.
template <class See>
void for_each_neighbour(const See& see) {
  for (int j = half; j >= -half; --j)
    for (int i = -half; i <= half; ++i) see(i, j);
}
/// The place of a neighbour, steps to the right and up, in that order.
inline std::size_t place_of(const std::array<int, 2>& steps) {
  return static_cast<std::size_t>((half - steps[1]) * columns + half + steps[0]);
}

/// The parameter, "right" or "up", that says how many steps away the selected neighbour is.
viz::Parameter steps_towards(const std::string& direction);
std::array<int, 2> selected_of(const viz::Parameters&);

/// Adds the cells in the order of for_each_neighbour, two lines that meet in the selected one, each with a grip at the
/// rim, and how many steps away the border is.
void add_cells(viz::Scene&, std::vector<viz::Cell>, const std::array<int, 2>& selected);

/// Keys beside the cells, from the top, in the cells' own colours.
class Keys {
 public:
  explicit Keys(viz::Scene&);
  void add(viz::Role, const std::string& text);

 private:
  viz::Scene& scene_;
  double y_;
};

}  // namespace isect::lessons::microscope
