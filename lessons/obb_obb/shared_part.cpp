#include "lessons/obb_obb/shared_part.h"

#include <algorithm>

#include <isect/clip_polygon.h>
#include "viz/solids.h"

namespace isect::lessons::obb_obb_lesson {

using namespace viz;
using Box = Obb<double, 3>;

namespace {

constexpr double same = 1e-9;  ///< vertices of one corner, met from several faces

/// The part of the ring in the box, which is grown a little, so that what touches is kept.
Ring<double, 3> clipped(Ring<double, 3> ring, const Box& box) {
  for (int i = 0; i < 3; ++i)
    for (const double side : {-1.0, 1.0}) {
      const Vec3 n = side * box.axes.col(i);
      ring = clip(ring, Plane<double, 3>{-n, n.dot(box.center) + box.half[i] + same});
    }
  return ring;
}

/// The body that the clipped faces bound, each corner once.
class Body {
 public:
  void add(const Ring<double, 3>& ring) {
    std::vector<int> face;
    for (const Vec3& p : ring) {
      const int i = index(p);
      if (std::find(face.begin(), face.end(), i) == face.end()) face.push_back(i);
    }
    if (face.size() >= 3) solid_.faces.push_back(face);
  }
  Solid take() { return std::move(solid_); }
  const std::vector<Vec3>& vertices() const { return solid_.vertices; }

 private:
  int index(const Vec3& p) {
    for (std::size_t i = 0; i < solid_.vertices.size(); ++i)
      if ((solid_.vertices[i] - p).norm() < 100 * same) return static_cast<int>(i);
    solid_.vertices.push_back(p);
    return static_cast<int>(solid_.vertices.size()) - 1;
  }

  Solid solid_ = {{}, {}, Role::hit};
};

void add_faces(Body& body, const Box& of, const Box& in) {
  const Solid whole = solid(of, Role::hit);
  for (const std::vector<int>& face : whole.faces) {
    Ring<double, 3> ring;
    for (const int i : face) ring.push_back(whole.vertices[i]);
    body.add(clipped(ring, in));
  }
}

}  // namespace

void shared_part(Scene& scene, const Box& a, const Box& b, Relation truth) {
  if (truth != Relation::overlapping && truth != Relation::touching) return;
  Body body;
  add_faces(body, a, b);
  add_faces(body, b, a);
  const std::vector<Vec3>& corners = body.vertices();
  if (truth == Relation::overlapping) {
    scene.items.push_back(body.take());
  } else if (corners.size() == 1) {
    scene.items.push_back(Dot{corners[0], Mark::disc, Role::hit});
  } else if (corners.size() == 2) {
    scene.items.push_back(Line{corners[0], corners[1], Role::hit, Pen::thick});
  } else if (corners.size() > 2) {
    const Solid flat = body.take();
    const auto largest = std::max_element(flat.faces.begin(), flat.faces.end(),
                                          [](const auto& x, const auto& y) { return x.size() < y.size(); });
    Region face;
    face.rings.emplace_back(), face.role = Role::hit, face.pen = Pen::thick;
    for (const int i : *largest) face.rings[0].push_back(flat.vertices[i]);
    scene.items.push_back(face);
  }
}

}  // namespace isect::lessons::obb_obb_lesson
