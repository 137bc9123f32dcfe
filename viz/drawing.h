#pragma once
// A scene seen through a camera in a theme: flat shapes in painter's order, ready for any back end.
//
// Both back ends (OpenGL and cairo) draw this value and nothing else, so that a PNG, an SVG and the window
// agree. Units: those of the drawing's size, x right, y down. Later shapes cover earlier ones.

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "viz/scene.h"
#include "viz/theme.h"

namespace isect::viz {

/// Lines and cubic Bezier curves. Each segment goes on from the end of the one before.
struct Path {
  struct Cubic {
    Vec2 control1, control2, to;
  };
  using Segment = std::variant<Vec2, Cubic>;
  Vec2 start = Vec2::Zero();
  std::vector<Segment> segments;
  bool closed = false;
};

/// An item of the scene or a part of the page, to which shapes belong. No two of a drawing have the same full_name.
struct Object {
  std::string kind;  ///< "ball", "label", "title"
  std::string name;  ///< plain: the text of its label; may be empty
  Role role = Role::text;
  int number = 1;  ///< among those of the same kind and name, and of the same role where they have no name
};
/// Returns "ball b", "line (construction) 2".
std::string full_name(const Object&);

/// The last member of every shape is the object it belongs to, as an index into the drawing's objects.
constexpr int no_object = -1;

/// A filled outline (non-zero winding), or one with `more` outlines (even-odd: holes, islands). `hatch` lines at 45
/// degrees (rising to the right) are drawn inside it.
struct Fill {
  Path path;
  Colour colour;
  double hatch_gap = 0, hatch_line = 0;  ///< 0: none
  Colour hatch_colour = {};
  std::vector<Path> more = {};
  int object = no_object;
};

/// A line of constant width with round joins. Dash: lengths on and off, {0, 0} for solid.
struct Stroke {
  Path path;
  Colour colour;
  double width = 1;
  std::array<double, 2> dash = {0, 0};
  bool round_cap = true;
  int object = no_object;
};

/// An ellipse filled with a radial gradient from `inner` at `focus` to `outer` at its rim.
struct Gradient {
  Vec2 center;
  Vec2 major, minor;  ///< half axes, perpendicular
  Vec2 focus;         ///< the brightest point, inside
  Colour inner, outer;
  int object = no_object;
};

/// One line of markup. `at` is its anchor on the baseline; `align` 0 left, 0.5 middle, 1 right.
struct Text {
  std::string markup;
  Vec2 at;
  double size = 10;
  Colour colour;
  double align = 0;
  bool bold = false;
  double halo = 0;  ///< width of the background-coloured rim, 0: none
  Colour halo_colour = {};
  int object = no_object;
};

/// Opaque triangles, the later over the earlier ones: one colour per triangle, three corners each.
struct Facets {
  std::vector<Vec2> corners = {};
  std::vector<Colour> colours = {};
  double seam = 0;  ///< width of the line round each that closes what smoothing leaves open between neighbours
  int object = no_object;
};

using Shape = std::variant<Fill, Stroke, Gradient, Text, Facets>;

struct Drawing {
  double width = 0, height = 0;
  Colour background;
  std::vector<Shape> shapes;
  std::vector<Object> objects = {};
};

/// Returns each facet as a fill and a stroke, for back ends without facets.
std::vector<Shape> expanded(const Facets&);
/// Returns all shapes, with facets expanded in their place.
std::vector<Shape> expanded(const std::vector<Shape>&);

int object_of(const Shape&);
/// Assigns to `object` the shapes from `first` on that belong to nothing yet.
void assign(std::vector<Shape>&, std::size_t first, int object);
/// Adds an object with its number and returns its index.
int add_object(std::vector<Object>&, Object);

/// The box that a text's ink covers, for layout and for the overlap check.
struct TextBox {
  double left, top, right, bottom;
};

Path polyline(const std::vector<Vec2>& points, bool closed = false);
/// Returns a closed ellipse of four cubic arcs (error below 3e-4 of the radius).
Path ellipse(Vec2 center, Vec2 major, Vec2 minor);
Path circle(Vec2 center, double radius);
/// Moves a shape; hatches are fixed to the drawing's origin and do not move along.
void move(Shape&, const Vec2& by);
/// Returns the path as points; the polyline through them stays within `tolerance` of the curve. No point follows its
/// equal, and a closed path's start is not repeated at the end.
std::vector<Vec2> flatten(const Path&, double tolerance = 0.05);

}  // namespace isect::viz
