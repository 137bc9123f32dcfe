#pragma once
// A drawing as one list of triangles and the passes that draw them. Knows no OpenGL, only what a stencil
// does.

#include <vector>

#include "viz/drawing.h"
#include "viz/gl/tessellate.h"

namespace isect::viz {

/// A corner of a triangle: place in the drawing, place in the gradient or image, straight colour.
struct Vertex {
  float x, y, u, v, r, g, b, a;
};

/// How a run of triangles is drawn. Every shape leaves the stencil at 0, as it found it, except for `once`, whose marks
/// are wiped by the next passes that need a 0.
enum class Pass {
  paint,     ///< colour
  opaque,    ///< the same where nothing shows through, which is quicker
  gradient,  ///< colour by RadialColours; (u, v) is the place in the unit circle
  image,     ///< colour from the image at (u, v)
  winding,   ///< no colour; the stencil counts up under triangles of one orientation, down under the other
  parity,    ///< no colour; the stencil turns over under every triangle: even-odd
  inside,    ///< colour where the stencil is not 0
  finish,    ///< as inside, and the stencil becomes 0
  once,      ///< colour where the stencil has not this shape's own mark, and mark: overlapping triangles blend once
  wipe       ///< no colour; the stencil becomes 0
};

/// From `inner` at the focus to `outer` on the unit circle: t such that the point lies on the circle of
/// radius t round (1 - t) focus, cairo's and SVG's rule.
struct RadialColours {
  Vec2 focus = Vec2::Zero();
  Colour inner, outer;
};

struct Call {
  Pass pass;
  int first = 0, count = 0;   ///< vertices
  unsigned image = 0;         ///< for Pass::image
  RadialColours radial = {};  ///< for Pass::gradient
};

class TriangleBatch {
 public:
  /// Draws at `scale` pixels per unit: curves are flattened to a twelfth of a pixel or better.
  explicit TriangleBatch(double scale) : scale_(scale) {}

  void add(const Fill&);
  void add(const Stroke&);
  void add(const Gradient&);
  void add(const Facets&);  ///< without seams: samples leave none
  /// An image in a box, its first row on top.
  void add_image(unsigned image, const Box&);

  const std::vector<Vertex>& vertices() const { return vertices_; }
  const std::vector<Call>& calls() const { return calls_; }

 private:
  void add(Pass, const Triangles&, const Colour&);
  /// Returns the call that the next vertices belong to: the last one if they can join it.
  Call& call(Pass);

  double scale_;
  std::vector<Vertex> vertices_;
  std::vector<Call> calls_;
};

}  // namespace isect::viz
