#pragma once
// Where each label goes: beside what it names, off every line, clear of every other label, inside the picture.

#include <vector>

#include "viz/compose/compose.h"
#include "viz/drawing.h"

namespace isect::viz {

/// Something a label should keep off. Crossing a `firm` one (an outline, the ray) costs more than a dashed one.
struct Obstacle {
  Vec2 from, to;  ///< equal for a marker's middle
  double radius;  ///< half the line's width, or the marker's radius
  bool firm;
};

/// A label looking for its place: beside the segment from..to, or beside a point when they are equal.
struct Wanted {
  std::string markup;
  Vec2 from, to;
  double keep_off;  ///< radius of the marker beside which it stands
  Colour colour;
  int object = no_object;
  std::vector<Vec2> others = {};  ///< points that it must not seem to name: it goes near its own, or gets a leader
  bool at_place = false;          ///< it stands on its point, or else has a leader to it, however near it is
};

struct Bounds {
  double left, top, right, bottom;
};

TextBox box_around(const Vec2& middle, const Vec2& half);
TextBox grown(const TextBox&, double by);
Vec2 nearest_in(const TextBox&, const Vec2&);
/// Returns the length of a segment's part inside a box, at least 1 if it has a point there.
double length_inside(const Vec2& from, const Vec2& to, const TextBox&);
/// Whether the segments a b and c d cross.
bool cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);

/// Places the labels in order, tries the compass points near first and then further out, and takes the place that
/// disturbs least. A label that had to go far gets a leader; one that crosses a line gets a halo. The labels in `there`
/// keep their places; all are returned.
std::vector<PlacedLabel> place_labels(const std::vector<Wanted>&, const std::vector<Obstacle>&, const Bounds&,
                                      const Theme&, std::vector<Shape>& out, std::vector<PlacedLabel> there = {});

}  // namespace isect::viz
