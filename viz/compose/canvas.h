#pragma once
// The canvas on which the items of a scene are drawn: layers in painter's order, and obstacles for labels. Each family
// of items has a file of its own beside this one.

#include <array>
#include <cmath>
#include <vector>

#include "viz/compose/compose.h"
#include "viz/compose/facet_tree.h"
#include "viz/compose/labels.h"
#include "viz/compose/visibility.h"

namespace isect::viz {

Colour mixed(const Colour& a, const Colour& b, double share);

// Two balls of one name and radius with a construction line of that name from middle to middle are a capsule, drawn as
// one body.

class Canvas {
 public:
  Canvas(const Scene&, const View&, const Theme&, bool handles);

  const Scene& scene;
  const View& view;
  const Theme& theme;
  const bool handles;              ///< the grips of the handles are drawn
  Occluders occluders;             ///< balls far to near, those of capsules left out
  std::vector<SortedMesh> meshes;  ///< they hide lines and arrows that have names, and lie under solids; else none
  std::vector<int> ball_items;     ///< the place of each of them among the scene's items
  std::vector<int> capsule_items;  ///< the place of each capsule's axis

  // Painter's order: floor, curved fills and rasters, hidden lines, what lies within solids, their front faces, visible
  // lines, markers.
  std::vector<Shape> ground, fills, hidden, contents, fronts, lines, marks;
  std::vector<Wanted> labels;
  std::vector<Obstacle> obstacles;
  std::vector<PlacedLabel> placed;  ///< texts with fixed places

  std::array<std::vector<Shape>*, 7> layers() { return {&ground, &fills, &hidden, &contents, &fronts, &lines, &marks}; }
  /// Calls `draw`, and assigns all that it draws to `object`.
  template <class Draw>
  void own(int object, const Draw& draw) {
    std::array<std::size_t, 7> before;
    for (std::size_t i = 0; i < before.size(); ++i) before[i] = layers()[i]->size();
    const std::size_t labels_before = labels.size();
    draw();
    for (std::size_t i = 0; i < before.size(); ++i) assign(*layers()[i], before[i], object);
    for (std::size_t i = labels_before; i < labels.size(); ++i) labels[i].object = object;
  }

  const Sizes& sizes() const { return theme.sizes; }
  Vec2 at(const Vec3& p) const { return view.project(p).at; }
  /// Returns the distance from the eye, rounded so finely that this only keeps equal depths equal on every machine.
  double depth(const Vec3& p) const { return std::round(view.project(p).depth / (1e-9 * view.camera().half_height)); }
  std::vector<Vec2> projected(const std::vector<Vec3>&) const;

  /// Returns the line's width on the picture.
  double width(Pen, Role) const;
  /// Makes labels keep off the chain of points.
  void block(const std::vector<Vec2>&, double radius, bool firm);
  /// Draws the parts of a curve, dashed and thinner where hidden.
  void curve(const std::vector<Stretch>&, const Colour&, double width, bool firm);
  /// Draws a line on the picture in a pen that is never hidden.
  void plain_line(const std::vector<Vec2>&, bool closed, Role, Pen);
  /// Whether a line in this pen is dashed where something hides it. `split_thick`: thick pens, too.
  static bool is_split(Pen pen, bool split_thick) {
    return pen == Pen::solid || (split_thick && (pen == Pen::thick || pen == Pen::highlight));
  }
  /// Returns what hides an object's lines between these points: not the bodies that contain them. Shared or bold lines
  /// belong to no object: every body hides them.
  Occluders around(const std::vector<Vec3>& points, Role, Pen) const;
  std::vector<Stretch> seen(const std::vector<Vec3>& points, bool closed, Role, Pen) const;
  /// Returns the radius that labels keep off the marker at `p`, 0 where there is none.
  double dot_radius(const Vec3& p) const;

 private:
  void find_capsules();
  void find_meshes();
};

/// Returns a flat area of this role, hatched where the theme says so.
Fill area(const Canvas&, const Path& outline, Role);

// One function for each kind of item. `draw` draws it whole, fill and lines.
void draw_floor(Canvas&);
void draw_ball(Canvas&, int index);           ///< into canvas.occluders.balls
void draw_capsule(Canvas&, int index, Role);  ///< into canvas.occluders.capsules
void draw(Canvas&, const Line&);
void draw(Canvas&, const Arrow&);
void draw(Canvas&, const Chain&);
void draw(Canvas&, const Circle&);
void draw(Canvas&, const Span&);
void draw(Canvas&, const RightAngle&);
void draw(Canvas&, const Region&);
void draw(Canvas&, const Raster&);
void draw_solids(Canvas&);  ///< all of them: the farther ones first
void draw(Canvas&, const Mesh&);
void draw(Canvas&, const Dot&);
void draw(Canvas&, const Label&);
void draw(Canvas&, const Heading&);
void draw(Canvas&, const Handle&);

}  // namespace isect::viz
