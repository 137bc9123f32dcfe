#include "viz/compose/visibility.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <type_traits>

#include <isect/ray_polygon.h>
#include <isect/ray_sphere.h>
#include <isect/sphere_sphere.h>
#include "viz/compose/screens_along.h"
#include "viz/compose/viewing_ray.h"
#include "viz/memo.h"

namespace isect::viz {
namespace {

using SpaceCurve = std::function<Vec3(double)>;
using Test = std::function<bool(const Vec3&)>;

std::vector<double> even(int samples) {
  std::vector<double> places;
  for (int i = 0; i <= samples; ++i) places.push_back(static_cast<double>(i) / samples);
  return places;
}

/// Tests a curve over s in [0, 1] at the given places, finds each change between visible and hidden by bisection, and
/// cuts there. The results at the first and the last place hold up to the ends.
std::vector<Stretch> split(const SpaceCurve& at, const Test& is_hidden, const std::vector<double>& places) {
  std::vector<Stretch> result;
  double s = places.front();
  bool now = is_hidden(at(s));
  result.push_back({{at(0)}, now});
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double next_s = places[i];
    const bool next = is_hidden(at(next_s));
    if (next != now) {
      double lo = s, hi = next_s;
      for (int k = 0; k < 40; ++k) {
        const double middle = (lo + hi) / 2;
        (is_hidden(at(middle)) == now ? lo : hi) = middle;
      }
      result.back().points.push_back(at(lo));
      result.push_back({{at(lo)}, next});
    }
    if (i + 1 < places.size()) result.back().points.push_back(at(next_s));
    s = next_s, now = next;
  }
  result.back().points.push_back(at(1));
  return result;
}

Vec3 middle_of(const Capsule<double, 3>& c) { return (c.p + c.q) / 2; }
double reach_of(const Capsule<double, 3>& c) { return (c.q - c.p).norm() / 2 + c.radius; }

/// Returns the distance between the points o + s d, s in [0, end], |d| = 1, and the segment p q (Ericson, Real-Time
/// Collision Detection, 2005, 5.1.9).
double distance(const Vec3& o, const Vec3& d, double end, const Vec3& p, const Vec3& q) {
  const Vec3 axis = q - p, r = o - p;
  const double e = axis.squaredNorm(), f = axis.dot(r), c = d.dot(r), b = d.dot(axis), apart = e - b * b;
  double s = apart > 0 ? std::clamp((b * f - c * e) / apart, 0.0, end) : 0;
  const double t = e > 0 ? std::clamp((b * s + f) / e, 0.0, 1.0) : 0;
  s = std::clamp(b * t - c, 0.0, end);
  return (r + s * d - t * axis).norm();
}

/// Where the segment o + s d, s in [0, 1], may begin or cease to be hidden: where it passes before or behind an edge,
/// as the eye sees it, and where it enters or leaves a solid or crosses a screen.
class Cuts {
 public:
  Cuts(const Vec3& from, const Vec3& to, const View& view) : from_(from), d_(to - from), view_(view) {}

  void behind(const Shell& solid) {
    for (const Shell::Edge& edge : solid.edges) behind(edge.from, edge.to);
    double lo = 0, hi = 1;
    for (const Plane<double, 3>& p : solid.inside) {
      const double rate = p.normal.dot(d_), height = p.normal.dot(from_) + p.d;
      if (rate > 0) lo = std::max(lo, -height / rate);
      if (rate < 0) hi = std::min(hi, -height / rate);
    }
    if (lo < hi) add(lo), add(hi);
  }

  void behind(const Polygon<double, 3>& screen) {
    for (const Ring<double, 3>& ring : screen.rings)
      for (std::size_t i = 0; i < ring.size(); ++i) behind(ring[i], ring[(i + 1) % ring.size()]);
    if (screen.rings.empty() || screen.rings[0].empty()) return;
    const Vec3 n = doubled_area(screen.rings[0]);
    add(n.dot(screen.rings[0][0] - from_) / n.dot(d_));
  }

  /// Returns a place in each stretch between two cuts that are more than a rounding apart.
  std::vector<double> places() {
    std::sort(found_.begin(), found_.end());
    std::vector<double> middles;
    for (std::size_t i = 1; i < found_.size(); ++i)
      if (found_[i] > found_[i - 1] + 1e-9) middles.push_back((found_[i - 1] + found_[i]) / 2);
    return middles;
  }

 private:
  void add(double s) {
    if (s > 0 && s < 1) found_.push_back(s);
  }
  Vec3 sight(const Vec3& p) const { return view_.camera().perspective ? Vec3(p - view_.eye()) : view_.forward(); }
  void behind(const Vec3& a, const Vec3& b) {
    const Vec3 across_edge = (b - a).cross(sight(a)), across = d_.cross(sight(from_));
    const double s = -across_edge.dot(from_ - a) / across_edge.dot(d_);
    const double on_edge = -across.dot(a - from_) / across.dot(b - a);
    if (on_edge > -1e-6 && on_edge < 1 + 1e-6) add(s);  // an extra place does no harm
  }

  Vec3 from_, d_;
  const View& view_;
  std::vector<double> found_ = {0, 1};
};

/// Whether the eye sees the ball apart from the segment, by more than the possible rounding: then nothing in the ball
/// hides any of the segment. False in perspective, where this is not decided.
bool seen_apart(const Vec3& from, const Vec3& to, const View& view, const Vec3& center, double radius) {
  if (view.camera().perspective) return false;
  constexpr double more = 1.001;
  const Vec3 &right = view.right(), &up = view.up();
  const Vec2 a(right.dot(from - center), up.dot(from - center));
  const Vec2 d(right.dot(to - from), up.dot(to - from));
  const double t = d.squaredNorm() > 0 ? std::clamp(-a.dot(d) / d.squaredNorm(), 0.0, 1.0) : 0;
  return (a + t * d).norm() > more * radius + 1e-9 * (from.norm() + to.norm());
}

/// What may hide part of a segment, or of a circle of radius `reach` about a point. Ball number `own` is left out.
struct Near {
  Near(const Vec3& from, const Vec3& to, const View& view, const Occluders& all, double reach = 0, int own = -1)
      : screens(all.screens) {
    const auto apart = [&](const Vec3& center, double radius) {
      return seen_apart(from, to, view, center, radius + reach);
    };
    for (int i = 0; i < static_cast<int>(all.balls.size()); ++i)
      if (i != own && !apart(all.balls[i].center, all.balls[i].radius)) balls.push_back(all.balls[i]);
    for (const Shell& solid : all.solids)
      if (!apart(solid.middle, solid.size)) solids.push_back(&solid);
    for (const Capsule<double, 3>& capsule : all.capsules)
      if (!apart(middle_of(capsule), reach_of(capsule))) capsules.push_back(capsule);
  }

  bool round() const { return !balls.empty() || !capsules.empty(); }

  std::vector<Ball> balls;
  std::vector<Capsule<double, 3>> capsules;
  std::vector<const Shell*> solids;
  const std::vector<Polygon<double, 3>>& screens;
  std::optional<ScreensAlong> along = {};  ///< where it is a segment, with many screens
};

bool any_screen(const Occluders& all, const Vec3&, const auto& test) { return std::ranges::any_of(all.screens, test); }
bool any_screen(const Near& near, const Vec3& p, const auto& test) {
  return near.along ? near.along->any(p, test) : std::ranges::any_of(near.screens, test);
}

const Shell& of(const Shell& solid) { return solid; }
const Shell& of(const Shell* solid) { return *solid; }

/// Does what hidden() does; `among`: Occluders, or only those that are Near.
bool hidden_among(const Vec3& p, const View& view, const auto& among, int own) {
  const Vec3 direction = view.towards_eye(p);
  const double to_eye = view.camera().perspective ? (view.eye() - p).norm() : HUGE_VAL;
  const Ray<double, 3> sight = {p, direction, {0, to_eye}};
  for (int i = 0; i < static_cast<int>(among.balls.size()); ++i) {
    if (i == own) continue;
    const Ball& ball = among.balls[i];
    if (misses(sight, ball.center, ball.radius)) continue;
    const RaySphere<double> shared = intersect(sight, Sphere<double, 3>{ball.center, ball.radius * (1 - drawn_in)});
    if (shared && shared.solid->hi > shared.solid->lo) return true;
  }
  for (const auto& solid : among.solids)
    if (runs_through(sight, of(solid))) return true;
  for (const Capsule<double, 3>& capsule : among.capsules)
    if (!misses(sight, middle_of(capsule), reach_of(capsule)) &&
        distance(p, direction, to_eye, capsule.p, capsule.q) < (1 - drawn_in) * capsule.radius)
      return true;
  const double beyond = drawn_in * std::max(view.camera().half_height, p.norm());  // p may lie on the screen itself
  const Ray<double, 3> past_own = {p, direction, {beyond, to_eye}};
  return any_screen(among, p, [&](const Polygon<double, 3>& screen) {
    return !misses(past_own, screen) && intersect(past_own, screen).t.has_value();
  });
}

/// Adds what decides whether a point is hidden: where the eye is, and all that is near.
void add_to_key(const View& view, const Near& near, MemoKey& key) {
  const auto add = [&](const auto&... values) { (key.push_back(static_cast<double>(values)), ...); };
  const auto add_point = [&](const Vec3& p) { add(p.x(), p.y(), p.z()); };
  add(view.camera().perspective, view.camera().half_height);
  add(near.balls.size(), near.capsules.size(), near.solids.size(), near.screens.size());
  add_point(view.camera().perspective ? view.eye() : view.forward());
  for (const Ball& ball : near.balls) add_point(ball.center), add(ball.radius);
  for (const Capsule<double, 3>& c : near.capsules) add_point(c.p), add_point(c.q), add(c.radius);
  for (const Shell* solid : near.solids) {
    add(solid->inside.size(), solid->edges.size(), solid->size);
    for (const Plane<double, 3>& p : solid->inside) add_point(p.normal), add(p.d);
    for (const Shell::Edge& e : solid->edges) add_point(e.from), add_point(e.to);
    add_point(solid->middle);
  }
  for (const Polygon<double, 3>& screen : near.screens) {
    add(screen.rings.size());
    for (const Ring<double, 3>& ring : screen.rings) {
      add(ring.size());
      for (const Vec3& p : ring) add_point(p);
    }
  }
}

/// Keeps the stretches of the last curves: from one picture to the next, few are hidden by something else.
Memo<std::vector<Stretch>>& lately() {
  static thread_local Memo<std::vector<Stretch>> memo(1 << 20);
  return memo;
}

/// Returns the places to test on a segment.
std::vector<double> places(const Vec3& from, const Vec3& to, const View& view, const Near& near) {
  if (near.solids.empty() && near.screens.empty()) return even(near.round() ? 64 : 1);
  Cuts cuts(from, to, view);
  for (const Shell* solid : near.solids) cuts.behind(*solid);
  for (const Polygon<double, 3>& screen : near.screens) cuts.behind(screen);
  std::vector<double> all = cuts.places();
  if (near.round()) {
    for (int i = 0; i < 64; ++i) all.push_back((i + 0.5) / 64);
    std::sort(all.begin(), all.end());
  }
  return all.empty() ? even(1) : all;
}

std::vector<Vec3> corners(const Solid& solid, const std::vector<int>& face) {
  std::vector<Vec3> points;
  for (const int i : face) points.push_back(solid.vertices[i]);
  return points;
}

}  // namespace

Shell shell(const Solid& solid) {
  Shell result;
  if (solid.vertices.empty()) return result;
  Vec3& middle = result.middle;
  for (const Vec3& p : solid.vertices) middle += p / static_cast<double>(solid.vertices.size());
  for (const Vec3& p : solid.vertices) result.size = std::max(result.size, (p - middle).norm());

  std::map<std::pair<int, int>, std::vector<int>> faces_of;
  for (const std::vector<int>& face : solid.faces) {
    const int index = static_cast<int>(result.normals.size());
    result.normals.push_back(Vec3::Zero());
    if (face.size() < 3) continue;
    for (std::size_t i = 0; i < face.size(); ++i)
      faces_of[std::minmax(face[i], face[(i + 1) % face.size()])].push_back(index);
    Vec3 n = doubled_area(corners(solid, face));
    if (!(n.squaredNorm() > 0)) continue;
    n.normalize();
    const Vec3& on = solid.vertices[face.front()];
    if (n.dot(on - middle) < 0) n = -n;
    result.normals.back() = n;
    result.inside.push_back({-n, n.dot(on) - drawn_in * result.size});
  }
  for (const auto& [ends, faces] : faces_of)
    result.edges.push_back({solid.vertices[ends.first], solid.vertices[ends.second], faces});
  return result;
}

bool seen_apart(const View& view, const Vec3& center, double radius, const Vec3& other, double other_radius) {
  constexpr double more = 1.001;
  if (!view.camera().perspective) {
    const Vec3 between = other - center, across = between - between.dot(view.forward()) * view.forward();
    return across.norm() > more * (radius + other_radius) + 1e-9 * (center.norm() + other.norm());
  }
  const Vec3 a = center - view.eye(), b = other - view.eye();
  const double far_a = a.norm(), far_b = b.norm();
  if (!(far_a > more * radius) || !(far_b > more * other_radius)) return false;
  // The balls are seen in cones; of half the angles the sines are the radii by the distances.
  const double sine_a = more * radius / far_a, sine_b = more * other_radius / far_b;
  const double cosine_a = std::sqrt(1 - sine_a * sine_a), cosine_b = std::sqrt(1 - sine_b * sine_b);
  const double cosine_of_both = cosine_a * cosine_b - sine_a * sine_b;
  return cosine_of_both > 0 && a.dot(b) / (far_a * far_b) < cosine_of_both - 1e-9;
}

bool lies_behind(const Polygon<double, 3>& screen, const View& view, const Occluders& all) {
  if ((all.balls.empty() && all.solids.empty() && all.capsules.empty()) || screen.rings.empty() ||
      screen.rings[0].empty())
    return false;
  const Vec3 &on = screen.rings[0][0], towards = view.towards_eye(on);
  Vec3 n = doubled_area(screen.rings[0]).normalized();
  if (n.dot(towards) < 0) n = -n;
  const auto before = [&](const Vec3& p, double radius) {
    return n.dot(p - on) >= radius - 1e-9 * (radius + (p - on).norm());
  };
  return std::ranges::all_of(all.balls, [&](const Ball& ball) { return before(ball.center, ball.radius); }) &&
         std::ranges::all_of(
             all.capsules,
             [&](const Capsule<double, 3>& c) { return before(c.p, c.radius) && before(c.q, c.radius); }) &&
         std::ranges::all_of(all.solids, [&](const Shell& solid) {
           return std::ranges::all_of(solid.edges,
                                      [&](const Shell::Edge& e) { return before(e.from, 0) && before(e.to, 0); });
         });
}

bool hidden(const Vec3& p, const View& view, const Occluders& occluders, int own) {
  return hidden_among(p, view, occluders, own);
}

std::vector<Stretch> stretches(const Vec3& from, const Vec3& to, const View& view, const Occluders& occluders) {
  const auto at = [&](double s) -> Vec3 { return s == 1 ? to : Vec3(from + s * (to - from)); };
  constexpr std::size_t few = 64;
  Near near(from, to, view, occluders);
  if (near.screens.size() > few) near.along.emplace(from, to, view, near.screens);
  std::vector<Stretch> parts = split(
      at, [&](const Vec3& p) { return hidden_among(p, view, near, -1); }, places(from, to, view, near));
  for (Stretch& part : parts) part.points = {part.points.front(), part.points.back()};
  return parts;
}

std::vector<Stretch> stretches(const std::vector<Vec3>& points, bool closed, const View& view,
                               const Occluders& occluders) {
  std::vector<Stretch> all;
  const std::size_t n = points.size(), edges = closed ? n : n - std::min<std::size_t>(n, 1);
  for (std::size_t i = 0; i < edges; ++i) {
    for (Stretch& part : stretches(points[i], points[(i + 1) % n], view, occluders)) {
      if (all.empty() || all.back().hidden != part.hidden)
        all.push_back(std::move(part));
      else
        all.back().points.insert(all.back().points.end(), part.points.begin() + 1, part.points.end());
    }
  }
  const bool around = closed && all.size() > 1 && all.front().hidden == all.back().hidden;
  if (around) {  // a closed chain has no end
    all.back().points.insert(all.back().points.end(), all.front().points.begin() + 1, all.front().points.end());
    all.erase(all.begin());
  }
  return all;
}

std::vector<Stretch> stretches(const Vec3& center, const Vec3& u, const Vec3& v, const View& view,
                               const Occluders& occluders, int own) {
  const auto at = [&](double s) -> Vec3 {
    const double angle = 2 * std::numbers::pi * s;
    return center + std::cos(angle) * u + std::sin(angle) * v;
  };
  const Near near(center, center, view, occluders, std::max(u.norm(), v.norm()), own);
  const Vec3 ball = own >= 0 ? occluders.balls[own].center : Vec3::Zero();
  MemoKey key = {own >= 0 ? 1.0 : 0.0};
  for (const Vec3& p : {center, u, v, ball}) key.insert(key.end(), p.begin(), p.end());
  add_to_key(view, near, key);
  const auto is_hidden = [&](const Vec3& p) {
    if (own >= 0 && (p - ball).dot(view.towards_eye(p)) < 0) return true;
    return hidden_among(p, view, near, -1);
  };
  return lately()(std::move(key), [&] { return split(at, is_hidden, even(96)); });
}

}  // namespace isect::viz
