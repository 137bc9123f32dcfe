#pragma once
// A scene says what is there and which part it plays; it holds no colour, no pixel and no font.
//
// Coordinates: right-handed, y up, world units. A flat lesson uses z = 0. Every text is markup for
// viz/text/rich_text.h: `*t*` italic scalar, `**o**` bold vector, `_{1}` or `_1` subscript, `^2` superscript.

#include <Eigen/Core>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace isect::viz {

struct Chart;

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;

/// The part an item plays. A theme turns it into colour and into dash, hatch or marker, so that colour never
/// speaks alone.
enum class Role { first, second, hit, miss, construction, highlight, text, muted, grid };

constexpr std::size_t role_count = 9;

/// A colour that an author chose for items of a scene, which play a part as others do: in grey print they look like it.
/// On each ground it is made darker or lighter until it stands out (see with_colours in viz/compose/own_colours.h).
struct OwnColour {
  unsigned rgb = 0;  ///< 0xrrggbb
  Role like = Role::first;
  bool operator==(const OwnColour&) const = default;
};
constexpr std::size_t most_own_colours = 12;
/// Returns the role of items in own colour number `i` of their scene, from 0.
constexpr Role own_role(std::size_t i) { return static_cast<Role>(role_count + i); }

/// The shape of a point's marker.
enum class Mark {
  disc,         ///< entry, first hit, a plain point
  ring,         ///< exit
  double_disc,  ///< a double root: disc in ring
  cross,        ///< wrong
  no,           ///< large empty ring, as before a verdict: outside, missed, ruled out
  diamond,      ///< exactly on
  excluded,     ///< dashed ring: a root outside the ray's range
  uncounted     ///< small ring: seen, not counted
};

/// How a line is drawn. Where a `solid` line lies behind something, it is dashed and thinner automatically; the lines
/// of a chain, a circle or a region's outline also where they are `thick`.
enum class Pen {
  solid,         ///< an object's own outline or the ray
  thick,         ///< the shared part, drawn thickest; never hidden as a line or an arrow
  highlight,     ///< as thick, widest: the one thing this step is about
  construction,  ///< dashed, never hidden
  excluded,      ///< thick and dashed: seen, but left out
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
  std::string name = {};
};
/// A line with an arrow head at `to`.
struct Arrow {
  Vec3 from, to;
  Role role = Role::text;
  Pen pen = Pen::solid;
  std::string name = {};
};
/// A ball with its silhouette and one equator.
struct Ball {
  Vec3 center;
  double radius = 1;
  Role role = Role::second;
  std::string name = {};  ///< of the object that it belongs to, as markup; here and below: if no label says it
};
/// Lines from point to point, in the plane or in space: the chain of a hull, the curve where two surfaces meet.
struct Chain {
  std::vector<Vec3> points;
  bool closed = false;
  Role role = Role::first;
  Pen pen = Pen::solid;
};
/// A circle, in the plane z = 0 unless it has another normal (of any length but 0). `filled`: the disc.
struct Circle {
  Vec3 center;
  double radius = 1;
  Role role = Role::second;
  Pen pen = Pen::solid;
  bool filled = false;
  Vec3 normal = Vec3::UnitZ();
};
/// An interval on a number line: a dot at an end that belongs to it, an arrow head where it is unbounded.
struct Span {
  Vec3 from, to;
  Role role = Role::first;
  Pen pen = Pen::thick;
  bool open_from = false, open_to = false;  ///< unbounded
};
/// A filled polygon in one plane, by the even-odd rule: an outline, or several with holes.
struct Region {
  std::vector<std::vector<Vec3>> rings;
  Role role = Role::second;
  Pen pen = Pen::solid;  ///< of the outline
  bool outlined = true;
  bool corners = false;  ///< a small disc on each vertex
  bool hides = false;    ///< what lies behind is dashed, as behind a solid: a plane, a polygon in space
  std::string name = {};
};
/// A cylinder, or a cone with its apex at `from`.
struct RoundSolid {
  Vec3 from, to;
  double radius = 1;
  bool pointed = false;
};
/// A convex polyhedron: a box, a k-DOP, a hull, a frustum, a wedge. A face lists its vertices in order, in either
/// orientation; edges between coplanar faces are not drawn. viz/solids.h makes one from the core's shapes.
struct Solid {
  std::vector<Vec3> vertices;
  std::vector<std::vector<int>> faces;
  Role role = Role::second;
  std::string name = {};
  std::optional<RoundSolid> round = {};  ///< the shape it stands for: no edge is drawn where its side bends
};
/// A surface of triangles, counter-clockwise seen from outside; opaque, so it need not be convex: what a bounding
/// volume contains.
struct Mesh {
  std::vector<Vec3> vertices;
  std::vector<std::array<int, 3>> triangles;
  Role role = Role::first;
  std::string name = {};
};
/// One cell of a raster. An object's cell is a light tint of its colour, any other has the full ink, unless `light`
/// says how brightly it is lit, from 0 to 1. Grey print adds a hatch where colours would look alike.
struct Cell {
  Role role = Role::first;
  std::optional<double> light = {};
};
/// A picture of few cells with sharp edges, laid out in the plane: the first cell lies at `corner`, `columns` of them
/// make a row along `across`, the rows follow each other along `down`.
struct Raster {
  Vec3 corner = Vec3::Zero(), across = Vec3::UnitX(), down = -Vec3::UnitY();
  int columns = 1;
  std::vector<Cell> cells;
  bool framed = true;
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
  bool at_handle = false;  ///< it keeps off the ring that a handle has there
};

/// A heading, bold or not, with its middle at `at` in any case: labels keep off it. It shrinks to `room` world
/// units.
struct Heading {
  Vec3 at;
  std::string text;
  Role role = Role::text;
  double room = 0;  ///< 0: its natural width
  bool bold = true;
  double lean = 0.5;  ///< the share of it that stands left of `at`; 0 beside a mark that it explains
};

using Item =
    std::variant<Ball, Line, Arrow, RightAngle, Dot, Label, Chain, Circle, Span, Region, Solid, Mesh, Raster, Heading>;

/// What a handle changes when it is dragged to the point p.
struct Handle {
  enum class Kind {
    point,     ///< parameter = p
    vector,    ///< parameter = (p - anchor) / scale
    length,    ///< parameter = |p - anchor|
    along,     ///< parameter = (p - anchor) . direction
    on_plane,  ///< parameter = p, which stays on the plane through it that `direction` and `across` span
    plane,     ///< parameter = (a, b, 0), the point of the plane anchor + a direction + b across that is nearest to p
    on_line,   ///< (p - anchor) . direction, from `lo` to `hi`, is the parameter, or coordinate `axis` of a vector
    shift,     ///< parameter = p - anchor, and the vectors of `with` move as far
    /// The parameter, a vector, turns until it points from the anchor to p, and those of `with` turn as it does. A
    /// number of `with` is d of the plane n . x + d = 0 whose normal n the parameter is: the plane stays on the anchor.
    turn,
    angle  ///< parameter = scale times the angle from `direction` towards `across` to p - anchor, in degrees
  };
  std::string parameter;  ///< the parameter it changes
  Kind kind = Kind::point;
  Vec3 at;  ///< where it stands
  Vec3 anchor = Vec3::Zero();
  Role role = Role::first;
  Vec3 direction = Vec3::UnitX();      ///< for `along`, `on_line`, `angle` and both planes
  std::string one_of = {};             ///< its name if there are many alike: "a corner"
  Vec3 across = Vec3::UnitY();         ///< for both planes: not along `direction`; for `angle`: at a right angle to it
  double scale = 1;                    ///< for `vector`: how large the parameter is drawn; for `angle`
  std::vector<std::string> with = {};  ///< for `shift` and `turn`: the parameters that move, too
  int axis = 0;                        ///< for `on_line`
  double lo = -1e300, hi = 1e300;      ///< for `on_line`: it stops there
  std::string name = {};               ///< what it is known by where several change one parameter: "A.lo.x"

  /// Returns what tells it from all other handles of its kind in a scene.
  const std::string& id() const { return name.empty() ? parameter : name; }
};

/// The ray's own t-axis under its picture, with the same marks in one dimension. Positions are values of t.
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
  std::shared_ptr<const Chart> chart = {};  ///< drawn in place of the items, flat, whatever the camera

  struct Time;
  std::shared_ptr<const Time> time = {};  ///< of a scene whose shapes move; null: nothing does

  std::vector<OwnColour> colours = {};  ///< most_own_colours at most; items name one by own_role
  std::string said = {};                ///< markup: what marks in it say, for readers who can't see them; may be empty

  struct Grid;
  std::shared_ptr<const Grid> grid = {};  ///< of small multiples that may stand in other columns; null: they may not
};

/// Small multiples in rows. The scene's own items stand in the lesson's number of columns, as figures show them;
/// viz/compose/small_multiples.h finds the number for a window.
struct Scene::Grid {
  int count = 1, columns = 1;                                ///< of the small drawings; the lesson's own
  std::function<std::vector<Item>(int columns)> items = {};  ///< all of them, in any number of columns from 1
};

/// The time in which the shapes of a scene move. The scene itself is a still; viz/player/scene_time.h lets time run.
struct Scene::Time {
  double lo = 0, hi = 1;                   ///< the motion's begin and end
  double now = 0;                          ///< what the still shows, within these
  std::optional<double> contact = {};      ///< first contact, as the core found it; none: not known at this step
  std::function<Scene(double t)> at = {};  ///< the lesson's own drawing at a time from lo to hi; it has no time itself
};

}  // namespace isect::viz
