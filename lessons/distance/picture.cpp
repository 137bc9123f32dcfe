#include "lessons/distance/picture.h"

#include <algorithm>

#include "viz/solids.h"

namespace isect::lessons::distance_lesson {

using namespace viz;

namespace {

constexpr Role roles[] = {Role::first, Role::second};
constexpr double too_near = 1e-9;  ///< points so near to each other are drawn as one

class Painter {
 public:
  Painter(const Setup& s, const Known& k) : s_(s), k_(k) {}

  Scene paint() {
    if (s_.is("boxes"))
      boxes();
    else
      segments();
    for (const Way& way : k_.earlier) draw(way, Role::construction, Pen::construction, false);
    for (const Way& way : k_.ways) draw(way, Role::highlight, Pen::highlight, true);
    if (k_.settled) settled();
    for (const auto& [p, text, role] : names_) add(Label{p, text, role});
    return std::move(scene_);
  }

 private:
  struct Name {
    Vec3 at;
    std::string text;
    Role role;
  };

  void add(Item item) { scene_.items.push_back(std::move(item)); }

  void draw(const Way& way, Role role, Pen pen, bool ends) {
    const auto& [from, to] = way;
    if ((from - to).norm() > too_near) add(Line{from, to, role, pen});
    if (!ends) return;
    for (const Vec3& p : {from, to}) add(Dot{p, Mark::ring, role});
  }

  /// One name for each place.
  void name(const Vec3& p, const std::string& text, Role role) {
    const auto found = std::ranges::find_if(names_, [&](const Name& known) { return known.at == p; });
    if (found == names_.end())
      names_.push_back({p, text, role});
    else
      found->text += " = " + text;
  }
  void handle(const char* parameter, const Vec3& p, Role role) {
    scene_.handles.push_back({parameter, Handle::Kind::point, p, Vec3::Zero(), role});
  }

  void segments() {
    segment(s_.a, 0, "p_a", "q_a");
    if (s_.is("point")) {
      add(Dot{s_.c(), Mark::disc, roles[1]});
      name(s_.c(), "**c**", roles[1]);
      handle("c", s_.c(), roles[1]);
    } else {
      segment(s_.b, 1, "p_b", "q_b");
    }
    if (k_.regions) regions();
    if (k_.lines) lines();
    if (s_.is("capsules")) capsule(0, "r_a"), capsule(1, "r_b");
  }

  void segment(const Segment3& x, int which, const char* p, const char* q) {
    const Role role = roles[which];
    if (x.p != x.q) add(Line{x.p, x.q, role, Pen::solid});
    const std::string of = std::string("_") + "ab"[which];
    for (const auto& [at, parameter, letter] : {std::tuple(x.p, p, "**p**"), std::tuple(x.q, q, "**q**")}) {
      add(Dot{at, Mark::disc, role});
      name(at, letter + of, role);
      handle(parameter, at, role);
    }
  }

  /// The planes across the segment at its ends part its three regions.
  void regions() {
    const Vec3 d = s_.a.q - s_.a.p;
    if (d.isZero(0)) return;
    for (const Vec3& end : {s_.a.p, s_.a.q})
      add(Circle{end, 1.25, Role::construction, Pen::construction, false, d.stableNormalized()});
  }

  void lines() {
    for (const int which : {0, 1}) {
      const Segment3& x = s_.segment(which);
      const Vec3 by = 0.75 * (x.q - x.p).stableNormalized();
      if (x.p == x.q) continue;
      add(Line{x.p, x.p - by, Role::construction, Pen::construction});
      add(Line{x.q, x.q + by, Role::construction, Pen::construction});
    }
  }

  void capsule(int which, const char* parameter) {
    const Capsule3 x = s_.capsule(which);
    const Role role = roles[which];
    if (x.radius > 0) {
      add(Ball{x.p, x.radius, role});
      if (x.p != x.q) {
        add(Ball{x.q, x.radius, role});
        add(solid(Cylinder<double>{x.p, x.q, x.radius}, role));
      }
    }
    const Vec3 d = x.q - x.p, out = x.p == x.q ? Vec3(-1, 0, 0) : Vec3(-d.stableNormalized()),
               rim = x.p + x.radius * out;
    if (k_.radii && x.radius > 0) {  // from the middle of the segment to its side
      const Vec3 across(-d.y(), d.x(), 0), side = across.isZero(0) ? Vec3(0, 1, 0) : Vec3(across.stableNormalized());
      const Vec3 from = (x.p + x.q) / 2, to = from + x.radius * side;
      add(Line{from, to, role, Pen::thick});
      add(Label{from, std::string("*r*_") + "ab"[which], role, to});
    }
    scene_.handles.push_back({parameter, Handle::Kind::length, rim, x.p, role});
  }

  void boxes() {
    add(solid(s_.boxes[0], roles[0]));
    add(solid(s_.boxes[1], roles[1]));
    name(s_.boxes[0].lo, "a", roles[0]);
    name(s_.boxes[1].hi, "b", roles[1]);
    handle("a_min", s_.boxes[0].lo, roles[0]);
    handle("a_max", s_.boxes[0].hi, roles[0]);
    handle("b_min", s_.boxes[1].lo, roles[1]);
    handle("b_max", s_.boxes[1].hi, roles[1]);
    if (k_.axes > 0) gaps();
    if (k_.parts && !s_.meet)
      for (const int which : {0, 1}) part(s_.nearest_part(which));
  }

  Vec3 middle(const Box3& x) const { return (x.lo + x.hi) / 2; }

  /// The way from a nearest point of a to one of b, one leg an axis; the last leg is the step's own.
  void gaps() {
    const Vec3 to = middle(s_.nearest_part(1));
    Vec3 at = middle(s_.nearest_part(0));
    for (int axis = 0; axis < k_.axes; ++axis) {
      Vec3 next = at;
      next[axis] = to[axis];
      const bool own = axis + 1 == k_.axes;
      if (at[axis] != to[axis])
        add(Line{at, next, own ? Role::highlight : Role::construction, own ? Pen::highlight : Pen::construction});
      at = next;
    }
  }

  /// A corner, a part of an edge, or a part of a face.
  void part(const Box3& x) {
    std::vector<int> wide;
    for (int axis = 0; axis < 3; ++axis)
      if (x.lo[axis] < x.hi[axis]) wide.push_back(axis);
    if (wide.empty()) return add(Dot{x.lo, Mark::disc, Role::highlight});
    if (wide.size() == 1) return add(Line{x.lo, x.hi, Role::highlight, Pen::highlight});
    Vec3 second = x.lo, fourth = x.lo;
    second[wide[0]] = x.hi[wide[0]], fourth[wide[1]] = x.hi[wide[1]];
    add(Region{.rings = {{x.lo, second, x.hi, fourth}}, .role = Role::highlight});
  }

  void settled() {
    if (s_.is("boxes")) return;
    std::vector<Way> ends;
    for (const Pair& pair : s_.pairs) ends.push_back(s_.points(pair));
    for (const auto& [on_a, on_b] : ends) {
      if ((on_a - on_b).norm() > too_near) {
        add(Line{on_a, on_b, Role::construction, Pen::construction});
        continue;
      }
      add(Dot{on_a, Mark::disc, Role::hit});
    }
    if (ends.size() < 2) return;
    add(Line{ends[0].first, ends[1].first, Role::highlight, Pen::highlight});
    if ((ends[0].first - ends[0].second).norm() > too_near)
      add(Line{ends[0].second, ends[1].second, Role::highlight, Pen::highlight});
  }

  const Setup& s_;
  const Known& k_;
  Scene scene_;
  std::vector<Name> names_;
};

}  // namespace

Camera camera() { return {.azimuth = 0.35, .elevation = 0.4}; }

Scene picture(const Setup& s, const Known& known) { return Painter(s, known).paint(); }

}  // namespace isect::lessons::distance_lesson
