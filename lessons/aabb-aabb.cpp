// Axis-aligned boxes (N13): one interval test an axis, and the first gap ends it.

#include "core/aabb_aabb_methods.h"

#include <algorithm>

#include "lessons/case_map.h"
#include "lessons/opinions.h"
#include "lessons/relation.h"
#include "lessons/script.h"
#include "viz/solids.h"

namespace isect::lessons {

const viz::Lesson& aabb_aabb();

namespace {

using namespace viz;
using C = Counted<double>;
using Box = Aabb<double, 3>;

const std::vector<std::string> pseudocode = {
    "for each axis i of x, y, z",                     // 0
    "    if a.min_i > b.max_i or b.min_i > a.max_i",  // 1
    "        return DISJOINT",                        // 2
    "return OVERLAP"                                  // 3
};
const char* const names[] = {"*x*", "*y*", "*z*"};

struct Setup {
  Box a, b;
  Relation truth;

  Box all() const { return {a.lo.cwiseMin(b.lo), a.hi.cwiseMax(b.hi)}; }
};

Setup setup(const Parameters& p) {
  const auto vector = [&](const char* name) { return std::get<Vec3>(p.at(name)); };
  Setup s = {{vector("a_min"), vector("a_max")}, {vector("b_min"), vector("b_max")}, {}};
  s.truth = relate(s.a, s.b);
  return s;
}

/// The boxes' intervals on one axis, set out before them like a ruler: where on the other two axes it lies.
Vec3 ruler(const Setup& s, int axis, double t, int row) {
  const Box all = s.all();
  const Vec3 size = all.hi - all.lo;
  const double off = (0.1 + 0.09 * row) * size.maxCoeff();
  Vec3 p = {all.lo.x() - off, all.lo.y(), all.hi.z() + off};  // y: beside the front left edge
  if (axis == 0) p = {0, all.lo.y() - 0.4 * off, all.hi.z() + off};
  if (axis == 2) p = {all.hi.x() + off, all.lo.y() - 0.4 * off, 0};
  p[axis] = t;
  return p;
}

void rulers(Scene& scene, const Setup& s, int axis) {
  const Interval<double> a = s.a.along(axis), b = s.b.along(axis);
  const auto span = [&](const Interval<double>& i, int row, Role role) {
    scene.items.push_back(Span{ruler(s, axis, i.lo, row), ruler(s, axis, i.hi, row), role, Pen::thick});
  };
  span(a, 0, Role::first);
  span(b, 1, Role::second);
  const Interval<double> common = {std::max(a.lo, b.lo), std::min(a.hi, b.hi)};
  const auto both = [&](double t) {
    return Line{ruler(s, axis, t, 0), ruler(s, axis, t, 1), Role::construction, Pen::construction};
  };
  scene.items.push_back(both(common.lo));
  scene.items.push_back(both(common.hi));
  scene.items.push_back(Label{ruler(s, axis, std::max(a.hi, b.hi), 1), names[axis], Role::text});
}

/// What the boxes share: a box, a face, an edge or a corner.
void shared(Scene& scene, const Setup& s) {
  const Box c = aabb_aabb::common(s.a, s.b);
  if (s.truth == Relation::overlapping) scene.items.push_back(solid(c, Role::hit));
  if (s.truth != Relation::touching) return;
  std::vector<int> flat, long_axes;
  for (int axis = 0; axis < 3; ++axis) (c.lo[axis] == c.hi[axis] ? flat : long_axes).push_back(axis);
  if (flat.size() == 1) {
    Region side = face(c, flat[0], c.lo[flat[0]], Role::hit);
    side.pen = Pen::thick;
    scene.items.push_back(side);
  } else if (flat.size() == 2) {
    scene.items.push_back(Chain{{c.lo, c.hi}, false, Role::hit, Pen::thick});
  } else {
    scene.items.push_back(Dot{c.lo, Mark::disc, Role::hit});
  }
}

/// `axis` -1: none looked at; `settled`: with what the boxes share.
Scene picture(const Setup& s, int axis, bool settled) {
  Scene scene;
  scene.items = {solid(s.a, Role::first), solid(s.b, Role::second)};
  if (axis >= 0) rulers(scene, s, axis);
  if (settled) shared(scene, s);
  if (s.truth !=
      Relation::equal) {  // at corners of the silhouette: low, left and in front; high, right and behind
    scene.items.push_back(Label{{s.a.lo.x(), s.a.lo.y(), s.a.hi.z()}, "a", Role::first});
    scene.items.push_back(Label{{s.b.hi.x(), s.b.hi.y(), s.b.lo.z()}, "b", Role::second});
  } else {
    scene.items.push_back(Label{{s.a.lo.x(), s.a.lo.y(), s.a.hi.z()}, "a = b", Role::first});
  }
  scene.handles = {{"a_min", Handle::Kind::point, s.a.lo, Vec3::Zero(), Role::first},
                   {"a_max", Handle::Kind::point, s.a.hi, Vec3::Zero(), Role::first},
                   {"b_min", Handle::Kind::point, s.b.lo, Vec3::Zero(), Role::second},
                   {"b_max", Handle::Kind::point, s.b.hi, Vec3::Zero(), Role::second}};
  return scene;
}

class Telling {
 public:
  explicit Telling(const Setup& setup)
      : s_(setup),
        script_({"Note, N13", "Two axis-aligned boxes, a and b: " + words(s_.truth, "the boxes") + ".",
                 pseudocode}) {}

  Walk walk() {
    add("three-questions", "Three questions of one dimension", 0,
        "A box is a product of intervals, one an axis. Boxes share a point if their intervals do, on every "
        "axis.\n"
        "The note says \"in x or y or z\". It must be \"and\".",
        -1);
    script_.tell<aabb_aabb::Event<C, 3>>(
        [&](auto& record) { aabb_aabb::by_axis(cast<C>(s_.a), cast<C>(s_.b), record); },
        [&](const auto& event) { say(event); });
    end();
    return std::move(script_.walk());
  }

 private:
  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption, int axis,
            const std::string& formula = {}) {
    Step& step = script_.add(slug, title, line, caption, formula);
    step.scene = picture(s_, axis, false);
    return step;
  }

  void say(const aabb_aabb::Axis<C>& e) {
    const std::string axis = names[e.axis];
    const double a_lo = e.a.lo.value, a_hi = e.a.hi.value, b_lo = e.b.lo.value, b_hi = e.b.hi.value;
    const bool a_first = a_hi < b_lo;
    const double left = a_first ? b_lo : std::max(a_lo, b_lo), right = a_first ? a_hi : std::min(a_hi, b_hi);
    script_.value("common " + axis, right - left, "length", e.disjoint ? Role::miss : Role::hit);
    const std::string formula = e.disjoint ? "gap on " + axis + ": " + shown(std::abs(right - left))
                                           : "common on " + axis + ": " + shown(left) + " to " + shown(right);
    Step& step = add(std::string("axis-") + "xyz"[e.axis], "Do the intervals on " + axis + " overlap?", 1,
                     axis_caption(e.axis, e.disjoint, left == right), e.axis, formula);
    Script::decide(step, {"max(min) ≤ min(max)", std::max(a_lo, b_lo), std::min(a_hi, b_hi), !e.disjoint,
                          e.disjoint ? "a gap on " + axis : "no gap on " + axis});
    step.question = {
        "Is there a gap between the boxes on " + axis + "?",
        {"yes", "no"},
        e.disjoint ? 0 : 1,
        e.disjoint ? "One interval ends before the other begins." : "The intervals have a common number."};
    disjoint_ = e.disjoint;
  }
  void say(const aabb_aabb::Common<C, 3>&) {}  // of relate, which is not told

  static std::string axis_caption(int axis, bool disjoint, bool touch) {
    if (disjoint)
      return axis < 2 ? "One gap is enough: the boxes are disjoint, and the other axes need no look."
                      : "Only the last axis has a gap. One is enough: the boxes are disjoint.";
    if (touch) return "One interval ends exactly where the other begins. They share that number: no gap.";
    return axis < 2 ? "No gap here. That alone says nothing yet: the next axis may have one."
                    : "No gap on any of the three axes.";
  }

  void end() {
    if (disjoint_) script_.leave_early();
    if (!disjoint_) script_.refuse(1, {2});
    script_.settle(verdict_kind(s_.truth), words(s_.truth, "the boxes"));
    Step& step = script_.add("relation", "How they lie", disjoint_ ? 2 : 3, end_caption());
    step.scene = picture(s_, -1, true);
    step.question = relation_question(s_.truth, "the two boxes", words(s_.truth, "the boxes") + ".");
  }

  std::string end_caption() const {
    if (empty(s_.a) || empty(s_.b))
      return "A box with exchanged corners has no point in it, so it meets nothing.\n"
             "The note's comparisons do not see that: they take it for one.";
    switch (s_.truth) {
      case Relation::disjoint:
        return "Comparisons of the given numbers are exact, so this answer is too.";
      case Relation::touching:
        return "They share points, but none inside both. The sets are closed, so touching counts as OVERLAP.";
      case Relation::equal:
        return "All six numbers agree: the boxes are the same set.";
      case Relation::overlapping:
        return "Only now may OVERLAP be returned. The note's figure returns it after the first axis.\n"
               "What they share is again a box, with the common interval on each axis.";
      default:
        return "What they share is one of the two boxes itself: it lies inside the other.";
    }
  }

  const Setup s_;
  Script script_;
  bool disjoint_ = false;
};

Walk walk(const Parameters& p) {
  return with_case_map(Telling(setup(p)).walk(), aabb_aabb(), p,
                       "The second box is shifted along *x* and *y*; its size and its place on *z* stay.\n"
                       "A gap on *x* ends the test first, so *y* is asked only between those bands.");
}

std::vector<Opinion> opinions(const Parameters& p) {
  const Setup s = setup(p);
  const auto says = [](bool meet) { return meet ? "they meet" : "disjoint"; };
  Opinions all(says(s.truth != Relation::disjoint));
  all.add("axis by axis, the note's", says(aabb_aabb::by_axis(s.a, s.b)));
  all.add("largest low, smallest high corner", says(aabb_aabb::min_max(s.a, s.b)));
  all.add("middles and half-sizes", says(aabb_aabb::by_centers(s.a, s.b)));
  return all.take();
}

enum Case { z_gap, x_gap, y_gap, overlapping, touching, inside, equal };

int branch(const Parameters& p) {
  const Setup s = setup(p);
  for (int axis = 0; axis < 3; ++axis)
    if (!intersects(s.a.along(axis), s.b.along(axis)))
      return std::array{x_gap, y_gap, z_gap}[static_cast<std::size_t>(axis)];
  return s.truth == Relation::overlapping ? overlapping
         : s.truth == Relation::touching  ? touching
         : s.truth == Relation::equal     ? equal
                                          : inside;
}
/// From the middle of a to the middle of b.
Vec2 place(const Parameters& p) {
  const Setup s = setup(p);
  return ((s.b.lo + s.b.hi) / 2 - (s.a.lo + s.a.hi) / 2).head<2>();
}
Parameters moved(const Parameters& p, const Vec2& to) {
  const Setup s = setup(p);
  const Vec2 by = to - place(p);
  Parameters there = p;
  there["b_min"] = Vec3(s.b.lo + Vec3(by.x(), by.y(), 0));
  there["b_max"] = Vec3(s.b.hi + Vec3(by.x(), by.y(), 0));
  return there;
}

const CaseMap cases = {
    "*x* from the middle of a to the middle of b",
    "*y* from the middle of a to the middle of b",
    {-4, -3},
    {4, 3},
    {"gap on *z*", "gap on *x*", "gap on *y*", "overlapping", "touching", "one inside the other", "equal"},
    branch,
    place,
    moved};

Preset preset_of(const char* id, const char* title, const Vec3& b_min, const Vec3& b_max, double grow = 0) {
  const Vec3 more = Vec3::Constant(grow);
  return {id,
          title,
          "",
          {{"a_min", Vec3(Vec3(-2, -1, -1) - more)},
           {"a_max", Vec3(Vec3(0, 1, 1) + more)},
           {"b_min", b_min},
           {"b_max", b_max}}};
}

Parameter corner(const char* name, const char* label, const char* help, const Vec3& initial) {
  return {name, label, help, initial, -1e6, 1e6, -4, 4};
}

}  // namespace

const Lesson& aabb_aabb() {
  static const Lesson lesson = {
      .id = "aabb-aabb",
      .title = "Box and box",
      .rows = "N13, N12",
      .summary = "Whether two axis-aligned boxes meet: an interval test an axis, ended by the first gap.",
      .parameters =
          {corner("a_min", "a_{min}", "Lower corner of the first box, in world units.", {-2, -1, -1}),
           corner("a_max", "a_{max}", "Upper corner of the first box, in world units.", {0, 1, 1}),
           corner("b_min", "b_{min}", "Lower corner of the second box, in world units.", {-0.75, -0.5, 0}),
           corner("b_max", "b_{max}", "Upper corner of the second box, in world units.", {1, 1.5, 1.5})},
      .group_by = "",
      .presets = {preset_of("overlapping", "overlapping", {-0.75, -0.5, 0}, {1, 1.5, 1.5}),
                  preset_of("gap-x", "a gap on x", {0.75, -0.5, -0.5}, {2, 1, 1}),
                  preset_of("gap-y", "a gap on y", {-1.5, 1.5, -0.5}, {0.5, 2.5, 1}),
                  preset_of("gap-z", "a gap on z", {-0.5, -0.75, -3}, {1, 0.75, -1.5}),
                  preset_of("touching-face", "touching: a face", {0, -0.75, -0.75}, {1.5, 0.75, 0.75}),
                  preset_of("touching-edge", "touching: an edge", {-3.5, 1, -0.75}, {-2, 2, 0.75}),
                  preset_of("touching-corner", "touching: a corner", {0, 1, 1}, {1.25, 2, 2}),
                  preset_of("b-inside-a", "b inside a", {-1.5, -0.5, -0.5}, {-0.5, 0.5, 0.5}),
                  preset_of("a-inside-b", "a inside b", {-2.5, -1.5, -1.5}, {0.5, 1.5, 1.5}, -0.25),
                  preset_of("equal", "equal", {-2, -1, -1}, {0, 1, 1})},
      .camera = {},
      .walk = walk,
      .opinions = opinions,
      .map = &cases,
  };
  return lesson;
}

}  // namespace isect::lessons
