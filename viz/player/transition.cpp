#include "viz/player/transition.h"

#include <algorithm>

#include "viz/compose/item_names.h"

namespace isect::viz {
namespace {

/// All points and lengths that tell where an item stands. Items of one shape have equally many, in the same order.
struct Numbers {
  std::vector<Vec3*> points;
  std::vector<double*> lengths;

  void operator()(Dot& it) { points = {&it.at}; }
  void operator()(Line& it) { points = {&it.from, &it.to}; }
  void operator()(Arrow& it) { points = {&it.from, &it.to}; }
  void operator()(Span& it) { points = {&it.from, &it.to}; }
  void operator()(Ball& it) { points = {&it.center}, lengths = {&it.radius}; }
  void operator()(Circle& it) { points = {&it.center, &it.normal}, lengths = {&it.radius}; }
  void operator()(Chain& it) { take(it.points); }
  void operator()(Region& it) {
    for (std::vector<Vec3>& ring : it.rings) take(ring);
  }
  void operator()(Solid& it) {
    take(it.vertices);
    if (it.round) points.insert(points.end(), {&it.round->from, &it.round->to}), lengths = {&it.round->radius};
  }
  void operator()(Mesh& it) { take(it.vertices); }
  void operator()(Raster&) {}
  void operator()(RightAngle& it) { points = {&it.at, &it.a, &it.b}; }
  void operator()(Label& it) {
    points = {&it.at};
    if (it.until) points.push_back(&*it.until);
  }
  void operator()(Heading& it) { points = {&it.at}; }

 private:
  void take(std::vector<Vec3>& from) {
    for (Vec3& v : from) points.push_back(&v);
  }
};

Numbers numbers_of(Item& item) {
  Numbers numbers;
  std::visit(numbers, item);
  return numbers;
}

bool same_name(const Object& a, const Object& b) {
  return a.kind == b.kind && a.name == b.name && a.number == b.number && (!a.name.empty() || a.role == b.role);
}

}  // namespace

bool may_move(const Scene& from, const Scene& to) { return !from.chart && !to.chart && !is_page(from) && !is_page(to); }

Scene between(const Scene& from, const Scene& to, double share) {
  Scene scene = to, old = from;
  if (share >= 1 || !may_move(from, to)) return scene;
  const std::vector<Object> names = objects_of(to), old_names = objects_of(from);
  for (std::size_t i = 0; i < scene.items.size(); ++i) {
    const auto found = std::ranges::find_if(old_names, [&](const Object& o) { return same_name(o, names[i]); });
    if (found == old_names.end()) continue;
    Item& before = old.items[static_cast<std::size_t>(found - old_names.begin())];
    if (before.index() != scene.items[i].index()) continue;
    const Numbers a = numbers_of(before), b = numbers_of(scene.items[i]);
    if (a.points.size() != b.points.size() || a.lengths.size() != b.lengths.size()) continue;
    for (std::size_t k = 0; k < a.points.size(); ++k) *b.points[k] = (1 - share) * *a.points[k] + share * *b.points[k];
    for (std::size_t k = 0; k < a.lengths.size(); ++k)
      *b.lengths[k] = (1 - share) * *a.lengths[k] + share * *b.lengths[k];
  }
  return scene;
}

double eased(double share) {
  const double t = std::clamp(share, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

}  // namespace isect::viz
