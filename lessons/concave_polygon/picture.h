#pragma once
// What the three methods share: the polygons, the point, the frame they are drawn in, and their walks.

#include <string>
#include <vector>

#include <isect/point_polygon.h>
#include "lessons/shared/flat.h"
#include "lessons/shared/location.h"
#include "viz/lesson.h"

namespace isect::lessons::concave_polygon_lesson {

/// The part of the plane that is drawn; the table of what is stored stands to its right.
struct Frame {
  double left = -3.3, right = 1.15, low = -2, high = 2;
  double unit = 1;  ///< of lengths in the table

  double table(double right_of = 0) const {
    return right + unit * (0.45 + right_of);
  }  ///< where the stored cells stand
  double below_top(double by) const { return high - unit * by; }
};
inline constexpr double table_width = 2.6;

struct Setup {
  explicit Setup(const viz::Parameters&);
  /// For any simple polygon, counter-clockwise, with a frame that fits it.
  Setup(const Ring<double, 2>& ring, const Point<double, 2>& p);

  Frame frame;
  bool spiky;
  bool sorted = false;  ///< the map's edges are added from left to right, not at random
  Ring<double, 2> ring;
  Point<double, 2> p;
  Location truth;

  int size() const { return static_cast<int>(ring.size()); }
};

/// Whether the polygon of the setting is simple, counter-clockwise and within the frame, as the three ways require.
bool can_be_prepared(const viz::Parameters&);
/// The largest number of corners of any polygon here.
int most_corners();

/// A polygon with this many long spikes, side by side: n = 2 spikes + 1, no two vertices at one height or abscissa.
Ring<double, 2> spiky_polygon(int spikes);

viz::Walk slabs(const Setup&);
viz::Walk trapezoids(const Setup&);
viz::Walk hierarchy(const Setup&);

/// What the slabs and the map of a polygon with this many spikes keep.
struct Kept {
  int n;
  double slab_entries;  ///< edges, over all slabs
  double map_nodes;     ///< questions and trapezoids
};
const Kept& kept(int spikes);
/// The chart of both counts as n grows, and the caption of its step.
inline constexpr int fewest_spikes = 8, most_spikes = 512;
viz::Chart growth();
std::string growth_caption();
// Pictures.

viz::Region polygon(const Setup&, bool outlined = true);
viz::Region filled(const std::vector<viz::Vec3>& ring, viz::Role role);
/// Adds one stored item: a small square around the point `at`.
void add_cell(viz::Scene&, double x, double y, double size, viz::Role role, bool thick = false);
/// The heading above the cells.
viz::Heading table_heading(const Frame&, const std::string&);
/// Adds the point with its name and its handle.
void add_point(viz::Scene&, const Setup&, bool on = false);

std::string alt_text(const Setup&, const std::string& prepared);

/// The text before the first step, and the card after the last one. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();

}  // namespace isect::lessons::concave_polygon_lesson
