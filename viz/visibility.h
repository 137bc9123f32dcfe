#pragma once
// What a viewer sees of a curve: the core's own ray tests decide which part lies behind a solid.

#include <vector>

#include "viz/camera.h"
#include "viz/scene.h"

namespace isect::viz {

/// A stretch of a curve, wholly visible or wholly hidden.
struct Stretch {
  std::vector<Vec3> points;
  bool hidden;
};

/// Whether the sight line from `p` to the eye runs through the inside of a ball. Ball number `own` is left out.
bool hidden(const Vec3& p, const View&, const std::vector<Ball>&, int own = -1);

/// Splits the segment where it passes behind a ball's silhouette.
std::vector<Stretch> stretches(const Vec3& from, const Vec3& to, const View&, const std::vector<Ball>&);
/// Splits a circle around `center`, spanned by two perpendicular radii. Points on ball number `own` are hidden where
/// its surface turns away from the eye.
std::vector<Stretch> stretches(const Vec3& center, const Vec3& u, const Vec3& v, const View&,
                               const std::vector<Ball>&, int own);

/// A ball's outline: the circle on its surface where sight lines touch it, as an exact ellipse on the picture.
struct Outline {
  Vec2 center, major, minor;
};
Outline outline(const Ball&, const View&);

}  // namespace isect::viz
