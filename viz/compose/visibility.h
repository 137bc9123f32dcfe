#pragma once
// The parts of a curve that a viewer sees: the core's own ray tests decide which part lies behind a solid.

#include <optional>
#include <vector>

#include <isect/shapes.h>
#include "viz/camera.h"
#include "viz/scene.h"

namespace isect::viz {

/// A stretch of a curve, wholly visible or wholly hidden.
struct Stretch {
  std::vector<Vec3> points;
  bool hidden;
};

/// A solid for viewing rays: its half-spaces n.x + d >= 0, moved inwards by a rounding, and its edges.
struct Shell {
  std::vector<Plane<double, 3>> inside;
  struct Edge {
    Vec3 from, to;
    std::vector<int> faces;  ///< the faces at this edge, by their index in `normals`
  };
  std::vector<Edge> edges;
  Vec3 middle = Vec3::Zero();  ///< of the vertices
  double size = 0;             ///< from the middle to the farthest vertex
  std::vector<Vec3> normals;   ///< unit, outwards; of each face of the solid, in order; 0 for one without area
};
Shell shell(const Solid&);

/// Points rounded on a surface may lie a little inside: for this test bodies are shrunk by this share of their size.
inline constexpr double drawn_in = 0x1p-30;

/// What hides lines: the balls, the solids, the regions with `hides`, and the capsules of one scene.
struct Occluders {
  std::vector<Ball> balls = {};
  std::vector<Shell> solids = {};
  std::vector<Polygon<double, 3>> screens = {};
  std::vector<Capsule<double, 3>> capsules = {};

  bool none() const { return balls.empty() && solids.empty() && screens.empty() && capsules.empty(); }
};

// Contents are seen through their container, whatever both are: what lies wholly in a ball, a solid or a capsule is
// drawn as if that were not there. What reaches out of it is hidden as far as it is inside.

/// Return what hides ball, solid or capsule number `index`: all except the bodies that contain it wholly. `itself`: the
/// solid itself counts, too, as it does for its far edges. `view`: what this sees apart from it is left out, too.
Occluders around_ball(const Occluders&, int index, const View* view = nullptr);
Occluders around_solid(const Occluders&, int index, const std::vector<Vec3>& vertices, bool itself = true,
                       const View* view = nullptr);
Occluders around_capsule(const Occluders&, int index, bool itself = true);
/// Returns what hides lines between these points, or the area between them: all except the bodies that contain them,
/// off their surface; a line on a surface is no content. Nothing if no body does: this is cheap.
std::optional<Occluders> around_contents(const Occluders&, const std::vector<Vec3>& points);

/// Whether the eye sees two balls apart, by more than the possible rounding: then neither hides any of the other.
bool seen_apart(const View&, const Vec3& center, double radius, const Vec3& other, double other_radius);

/// Whether all bodies, if there are any, stand before the screen's plane or on it: no part of any is behind it.
bool lies_behind(const Polygon<double, 3>& screen, const View&, const Occluders&);

/// Whether the viewing ray from `p` to the eye runs through the inside of a body, or through a screen. Ball
/// number `own` is left out.
bool hidden(const Vec3& p, const View&, const Occluders&, int own = -1);

/// Splits the segment where it passes behind an outline. Behind solids and screens no stretch is missed that
/// is longer than 1e-9 of it, behind balls and capsules none longer than 1/64.
std::vector<Stretch> stretches(const Vec3& from, const Vec3& to, const View&, const Occluders&);
/// Splits a chain of segments; stretches continue across the vertices.
std::vector<Stretch> stretches(const std::vector<Vec3>& points, bool closed, const View&, const Occluders&);
/// Splits a circle around `center`, spanned by two perpendicular radii. Points on ball number `own` are hidden where
/// its surface turns away from the eye.
std::vector<Stretch> stretches(const Vec3& center, const Vec3& u, const Vec3& v, const View&, const Occluders&,
                               int own);

}  // namespace isect::viz
