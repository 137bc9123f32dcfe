// Cameras that frame scenes: the whole of a walk, and all presets at one scale.

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "viz/compose/compose.h"

namespace isect::viz {
namespace {

/// A walk takes at least this share of what it takes when framed alone, or one scale for all would leave it lost.
constexpr double least_share = 0.9;

/// The box of a scene's items along the axes of a view.
class Extent {
 public:
  explicit Extent(const View& view) : view_(view) {}

  Vec3 lo = Vec3::Constant(INFINITY), hi = Vec3::Constant(-INFINITY);

  void operator()(const Ball& it) { grow(it.center, Vec3::Constant(it.radius)); }
  void operator()(const Line& it) { grow(it.from), grow(it.to); }
  void operator()(const Arrow& it) { grow(it.from), grow(it.to); }
  void operator()(const RightAngle& it) { grow(it.at); }
  void operator()(const Dot& it) { grow(it.at); }
  void operator()(const Label& it) { grow(it.at); }
  void operator()(const Chain& it) { grow(it.points); }
  void operator()(const Span& it) { grow(it.from), grow(it.to); }
  void operator()(const Solid& it) { grow(it.vertices); }
  void operator()(const Mesh& it) { grow(it.vertices); }
  void operator()(const Region& it) {
    for (const std::vector<Vec3>& ring : it.rings) grow(ring);
  }
  void operator()(const Raster& it) {
    grow({it.corner, it.corner + it.across, it.corner + it.down, it.corner + it.across + it.down});
  }
  void operator()(const Heading& it) { grow(it.at + (0.5 - it.lean) * it.room * view_.right(), {it.room / 2, 0, 0}); }
  /// In each direction the disc reaches as far as the sine of the angle between that direction and its normal says.
  void operator()(const Circle& it) {
    const Vec3 n = along(it.normal.normalized());
    grow(it.center, it.radius * (Vec3::Ones() - n.cwiseAbs2()).cwiseMax(0).cwiseSqrt());
  }

 private:
  Vec3 along(const Vec3& p) const { return {p.dot(view_.right()), p.dot(view_.up()), p.dot(view_.forward())}; }
  void grow(const Vec3& p, const Vec3& reach = Vec3::Zero()) {
    const Vec3 q = along(p);
    lo = lo.cwiseMin(q - reach);
    hi = hi.cwiseMax(q + reach);
  }
  void grow(const std::vector<Vec3>& points) {
    for (const Vec3& p : points) grow(p);
  }

  const View& view_;
};

/// Returns the least share of the frame's width or height, whichever is larger, that a scene must take. Small multiples
/// are made as large as the frame allows.
double least_taken(const Scene& scene) {
  const auto headed = std::ranges::count_if(scene.items, [](const Item& item) {
    const Heading* heading = std::get_if<Heading>(&item);
    return heading && heading->bold && heading->text.find_first_not_of("0123456789") != std::string::npos;
  });
  return headed > 2 ? 0.9 : 0.64;
}

}  // namespace

Box2 extent(const std::vector<Item>& items, const Camera& camera) {
  const View view(camera, 1, 1);
  Extent extent(view);
  for (const Item& item : items) std::visit(extent, item);
  return {extent.lo.head<2>(), extent.hi.head<2>()};
}

Camera frame(const Camera& camera, const std::vector<const Scene*>& scenes, double aspect, double margin) {
  const View view(camera, 1, 1);  // for its axes only
  Extent extent(view);
  for (const Scene* scene : scenes)
    for (const Item& item : scene->items) std::visit(extent, item);
  const Vec3 &lo = extent.lo, &hi = extent.hi;
  if (!(lo.x() <= hi.x())) return camera;

  Camera framed = camera;
  const Vec3 middle = (lo + hi) / 2;
  framed.target = middle.x() * view.right() + middle.y() * view.up() + middle.z() * view.forward();
  const double half = std::max({(hi.y() - lo.y()) / 2, (hi.x() - lo.x()) / 2 / aspect, 1e-6});
  framed.half_height = half / (1 - 2 * margin);
  if (camera.perspective)  // what stands nearer looks larger
    framed.half_height += (hi.z() - lo.z()) / 2 * std::tan(camera.field_of_view / 2);
  return framed;
}

Camera frame_alike(const Camera& camera, const Walk& walk, const std::vector<Walk>& all, double aspect) {
  const auto framed = [&](const Walk& w) {
    std::vector<const Scene*> scenes;
    for (const Step& s : w.steps) scenes.push_back(&s.scene);
    return frame(camera, scenes, aspect);
  };
  Camera result = framed(walk);
  const double largest = result.half_height / least_share;
  for (const Walk& other : all) result.half_height = std::max(result.half_height, framed(other).half_height);
  result.half_height = std::min(result.half_height, largest);
  return result;
}

Camera closer(const Camera& framed, const Scene& scene, double aspect) {
  const Camera alone = frame(framed, {&scene}, aspect, 0);  // the camera whose frame it would fill
  const double least = least_taken(scene);
  if (!(alone.half_height < least * framed.half_height)) return framed;
  Camera nearer = alone;
  nearer.half_height = alone.half_height / least;
  return nearer;
}

Camera placed(const std::optional<StepView>& view, Camera framed) {
  if (view && view->has_target) framed.target = view->camera.target;
  if (view && view->has_half_height) framed.half_height = view->camera.half_height;
  return framed;
}

Camera step_camera(const Lesson& lesson, const Walk& walk, const std::vector<Walk>& all,
                   const std::optional<StepView>& view, const Scene& scene, double aspect) {
  return placed(view, closer(frame_alike(opening(lesson, view), walk, all, aspect), scene, aspect));
}

}  // namespace isect::viz
