#pragma once
// A scene says what is there and which part it plays; it holds no colour, no pixel and no font.
//
// Coordinates: right-handed, y up, world units. A flat lesson uses z = 0. Every text is markup for rich_text.h:
// `*t*` italic scalar, `**o**` bold vector, `_{1}` or `_1` subscript, `^2` superscript.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace isect::viz {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;

/// The part an item plays. A theme turns it into colour and into dash, hatch or marker, so that colour never
/// speaks alone.
enum class Role { first, second, hit, miss, construction, highlight, text, muted, grid };

/// The shape of a point's marker.
enum class Mark {
  disc,         ///< entry, first hit, a plain point
  ring,         ///< exit
  double_disc,  ///< a double root: disc in ring
  cross,        ///< a miss
  diamond,      ///< exactly on
  excluded,     ///< dashed ring: a root outside the ray's range
  uncounted     ///< small ring: seen, not counted
};

/// How a line is drawn. The part of a `solid` or `thick` line behind a solid is dashed and thinner by itself.
enum class Pen {
  solid,         ///< an object's own outline or the ray
  thick,         ///< the shared part, drawn thickest and never hidden
  highlight,     ///< as thick, widest: the one thing this step is about
  construction,  ///< dashed, never hidden
  hairline       ///< axes and drop lines
};

struct Dot {
  Vec3 at;
  Mark mark = Mark::disc;
  Role role = Role::text;
};
struct Line {
  Vec3 from, to;
  Role role = Role::text;
  Pen pen = Pen::solid;
};
/// A line with an arrow head at `to`.
struct Arrow {
  Vec3 from, to;
  Role role = Role::text;
  Pen pen = Pen::solid;
};
/// A ball with its silhouette and one equator.
struct Ball {
  Vec3 center;
  double radius = 1;
  Role role = Role::second;
};
/// The small square at `at` between the directions towards `a` and `b`.
struct RightAngle {
  Vec3 at, a, b;
};
/// Text beside `at`. With `until`, it belongs to the segment at..until and is set beside its middle.
struct Label {
  Vec3 at;
  std::string text;
  Role role = Role::text;
  std::optional<Vec3> until = {};
};

using Item = std::variant<Ball, Line, Arrow, RightAngle, Dot, Label>;

/// What a handle changes when it is dragged to the point p.
struct Handle {
  enum class Kind {
    point,   ///< parameter = p
    vector,  ///< parameter = p - anchor
    length   ///< parameter = |p - anchor|
  };
  std::string parameter;  ///< the parameter it changes
  Kind kind = Kind::point;
  Vec3 at;  ///< where it stands
  Vec3 anchor = Vec3::Zero();
  Role role = Role::first;
};

/// The same marks in one dimension: the ray's own t-axis under its picture. Positions are values of t.
struct Axis {
  struct Tick {
    double t;
    Mark mark;
    Role role;
    std::string label;
  };
  double lo = 0, hi = 1;                  ///< the ends drawn
  double range_lo = 0, range_hi = 1;      ///< the ray's closed range; infinite ends are drawn as arrows
  std::optional<Eigen::Vector2d> shared;  ///< [t_in, t_out] drawn thickest, if any
  std::vector<Tick> ticks;
};

struct Scene {
  std::vector<Item> items;
  std::vector<Handle> handles;
  std::optional<Axis> axis;
};

}  // namespace isect::viz
