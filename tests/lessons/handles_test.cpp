// Handles of all lessons: each stands on something that the picture shows.

#include <algorithm>
#include <cmath>

#include "tests/catch.h"
#include "tests/lessons/asked_for.h"
#include "tests/viz/drawn.h"
#include "viz/compose/compose.h"

namespace handles_test {
using namespace isect;
using namespace isect::viz;

namespace {

/// The distance from a point to what an item shows: to its points, its lines, a ball's surface or middle.
class Distance {
 public:
  explicit Distance(const Vec3& p) : p_(p) {}

  double operator()(const Ball& it) const { return round(it.center, it.radius); }
  double operator()(const Circle& it) const { return round(it.center, it.radius); }
  double operator()(const Line& it) const { return to(it.from, it.to); }
  double operator()(const Arrow& it) const { return to(it.from, it.to); }
  double operator()(const Span& it) const { return to(it.from, it.to); }
  double operator()(const RightAngle& it) const { return (p_ - it.at).norm(); }
  double operator()(const Dot& it) const { return (p_ - it.at).norm(); }
  double operator()(const Label& it) const { return (p_ - it.at).norm(); }
  double operator()(const Heading&) const { return INFINITY; }
  double operator()(const Chain& it) const { return to(it.points, it.closed); }
  double operator()(const Region& it) const {
    double least = INFINITY;
    for (const std::vector<Vec3>& ring : it.rings) least = std::min(least, to(ring, true));
    return least;
  }
  double operator()(const Solid& it) const { return to(it.vertices, true); }
  double operator()(const Mesh& it) const { return to(it.vertices, true); }
  double operator()(const Raster& it) const {
    const Vec3 q = p_ - it.corner;
    const double u = q.dot(it.across) / it.across.squaredNorm(), v = q.dot(it.down) / it.down.squaredNorm();
    return std::min({u, v, 1 - u, 1 - v}) >= 0 ? 0 : INFINITY;
  }

 private:
  double round(const Vec3& center, double radius) const {
    const double d = (p_ - center).norm();
    return std::min(d, std::abs(d - radius));
  }
  double to(const Vec3& a, const Vec3& b) const {
    const Vec3 d = b - a;
    const double t = d.squaredNorm() > 0 ? std::clamp((p_ - a).dot(d) / d.squaredNorm(), 0.0, 1.0) : 0;
    return (p_ - a - t * d).norm();
  }
  /// The distance to the chain, or to the box of its points if it is closed: a shape may be dragged by its middle.
  double to(const std::vector<Vec3>& points, bool closed) const {
    if (points.empty()) return INFINITY;
    Vec3 lo = points.front(), hi = lo;
    double least = INFINITY;
    for (std::size_t i = 0; i < points.size(); ++i) {
      lo = lo.cwiseMin(points[i]), hi = hi.cwiseMax(points[i]);
      if (i > 0 || closed) least = std::min(least, to(points[(i + points.size() - 1) % points.size()], points[i]));
    }
    return closed ? std::min(least, (p_ - p_.cwiseMax(lo).cwiseMin(hi)).norm()) : least;
  }

  Vec3 p_;
};

}  // namespace

TEST_CASE("every handle stands on something that its picture shows", "[every lesson]") {
  for (const Lesson* lesson : those_asked_for())
    for (const Preset& preset : lesson->presets)
      for (const Step& step : lesson->walk(preset.parameters).steps) {
        INFO(lesson->id << ' ' << preset.id << ", " << step.slug);
        CHECK((!step.scene.chart || step.scene.handles.empty()));
        const auto is_shown = [&](const Vec3& p) {
          return std::ranges::any_of(step.scene.items, [&](const Item& item) {
            return std::visit(Distance(p), item) < 1e-6 * (1 + p.norm());
          });
        };
        for (const Handle& handle : step.scene.handles) {
          const bool hangs = handle.kind != Handle::Kind::point;  // by a line, on what it measures from
          const bool shown = is_shown(handle.at) || (hangs && is_shown(handle.anchor));
          INFO(handle.parameter << " at " << handle.at.transpose());
          CHECK(shown);
        }
      }
}

TEST_CASE("in a small window the name of a grip beside a raster lies beside it, too", "[every lesson]") {
  constexpr double width = 496, height = 260;  // the scene of a window of 800 x 600
  for (const Lesson* lesson : those_asked_for())
    for (const Preset& preset : lesson->presets)
      for (const Step& step : lesson->walk(preset.parameters).steps) {
        Scene scene = step.scene;
        const auto raster = std::ranges::find_if(scene.items, [](const Item& item) {
          const Raster* it = std::get_if<Raster>(&item);
          return it && it->framed;
        });
        if (raster == scene.items.end()) continue;
        const Raster picture = std::get<Raster>(*raster);
        for (const Handle& h : scene.handles) scene.items.emplace_back(Label{h.at, h.parameter, h.role, {}, true});
        const View view(frame(lesson->camera, {&scene}, width / height), width, height);
        const Vec2 corner = view.project(picture.corner).at,
                   opposite = view.project(picture.corner + picture.across + picture.down).at;
        const TextBox all = {std::min(corner.x(), opposite.x()), std::min(corner.y(), opposite.y()),
                             std::max(corner.x(), opposite.x()), std::max(corner.y(), opposite.y())};
        const Composed drawn = compose(scene, view, window_theme(ThemeName::dark), true);
        for (const Handle& h : scene.handles) {
          const auto name = std::ranges::find(drawn.labels, h.parameter, &PlacedLabel::text);
          REQUIRE(name != drawn.labels.end());
          INFO(lesson->id << ' ' << preset.id << ", " << step.slug << ": " << h.parameter);
          CHECK_FALSE(meet(name->box, all));
        }
      }
}

}  // namespace handles_test
