// Rules 1 and 2, on turned boxes.

#include <fmt/format.h>

#include <cmath>

#include <isect/methods/obb_obb.h>
#include <isect/methods/sphere_sphere.h>
#include <isect/obb_obb.h>
#include "bench/random.h"
#include "lessons/rules_of_thumb/experiment.h"
#include "lessons/shared/plural.h"

namespace isect::lessons::rules_of_thumb_lesson {

using namespace viz;

namespace {

using C = Counted<double>;
using Box = Obb<double, 3>;

/// A box seen from above, turned about the vertical axis.
Box upright(const Flat& center, double degrees, double u, double v) {
  const double angle = degrees * 3.14159265358979323846 / 180, c = std::cos(angle), s = std::sin(angle);
  Box box = {{center.x(), center.y(), 0}, {}, {u, v, 0.25}};
  box.axes << c, -s, 0, s, c, 0, 0, 0, 1;
  return box;
}

Flat above(const Box& box) { return box.center.head<2>(); }
std::vector<Flat> corners(const Box& box) {
  const Flat u = box.half[0] * box.axes.col(0).head<2>(), v = box.half[1] * box.axes.col(1).head<2>(), c = above(box);
  return {c - u - v, c + u - v, c + u + v, c - u + v};
}
double outer(const Box& box) { return box.half.norm(); }
double inner(const Box& box) { return box.half.minCoeff(); }

Obb<C, 3> cast(const Box& b) { return {b.center.cast<C>(), b.axes.cast<C>(), b.half.cast<C>()}; }
Sphere<C, 3> ball(const Box& b, double radius) { return {b.center.cast<C>(), C(radius)}; }
bool fifteen_axes(const Box& a, const Box& b) { return obb_obb::gottschalk(cast(a), cast(b), C(0)); }
bool balls_meet(const Box& a, double r, const Box& b, double s) {
  return sphere_sphere::closed_squared_distance(ball(a, r), ball(b, s));
}

std::vector<Box> scattered() {
  bench::Random random(7);
  std::vector<Box> boxes;
  for (int i = 0; i < 14; ++i) {
    const double x = -2.9 + 0.95 * (i % 5), y = -1.5 + 1.45 * (i / 5);
    const double up = random.uniform(-0.2, 0.2), right = random.uniform(-0.2, 0.2);  // arguments have no order
    const Flat at(x + right, y + up);
    const double degrees = random.uniform(0, 90), u = random.uniform(0.25, 0.45), v = random.uniform(0.15, 0.3);
    boxes.push_back(upright(at, degrees, u, v));
  }
  return boxes;
}

}  // namespace

Experiment trivial(const Flat& p) {
  const Box a = upright(p, 30, 0.5, 0.3);
  const std::vector<Box> boxes = scattered();
  Experiment e = {
      .title = "1: trivial accept and reject",
      .source = "Lecture note, rules of thumb (1) and bounding volumes",
      .alt = "A turned box among fourteen others, with the balls around and within them.",
      .pseudocode = {"for each other box b", "    without: test the 15 axes of a and b",
                     "    with: outer balls apart: no; inner balls meet: yes", "    else: test the 15 axes"},
      .unit = "operations"};
  int rejected = 0, accepted = 0;
  for (Part& part : e.parts) part.items.emplace_back(region(corners(a), Role::first));
  e.parts[2].items.emplace_back(circle(above(a), outer(a), Role::first, Pen::construction));
  e.parts[2].items.emplace_back(circle(above(a), inner(a), Role::first, Pen::solid));
  for (const Box& b : boxes) {
    bool meet = false, apart = false, surely = false;
    e.before += total(counted([&] { meet = fifteen_axes(a, b); }));
    e.after += total(counted([&] {
      apart = !balls_meet(a, outer(a), b, outer(b));
      surely = !apart && balls_meet(a, inner(a), b, inner(b));
      if (!apart && !surely) fifteen_axes(a, b);
    }));
    rejected += apart, accepted += surely;
    const Role found = meet ? Role::hit : Role::second;
    e.parts[0].items.emplace_back(region(corners(b), Role::second));
    e.parts[1].items.emplace_back(region(corners(b), found));
    e.parts[1].items.emplace_back(line(p, above(b), Role::construction, Pen::construction));
    e.parts[2].items.emplace_back(region(corners(b), Role::second));
    e.parts[2].items.emplace_back(
        circle(above(b), outer(b), apart ? Role::construction : Role::second, Pen::construction));
    if (!apart) e.parts[2].items.emplace_back(circle(above(b), inner(b), Role::second, Pen::solid));
    if (apart)
      e.parts[3].items.emplace_back(outline(corners(b), Role::construction, Pen::hairline));
    else
      e.parts[3].items.emplace_back(region(corners(b), found));
    if (!apart && !surely) e.parts[3].items.emplace_back(line(p, above(b), Role::construction, Pen::construction));
  }
  const int others = static_cast<int>(boxes.size());
  e.details = {{"rejected by balls", rejected},
               {"accepted by balls", accepted},
               {"left to the axes", others - rejected - accepted}};
  e.parts[0].title = "Look for the trivial first";
  e.parts[0].caption = "Which boxes meet box a, around **p**? Boxes that lie far apart should not need a full test.";
  e.parts[1].title = "Every pair in full";
  e.parts[1].caption = fmt::format(
      "The separating axes are tested for all {} boxes. Far boxes cost as much to set up as near ones.", others);
  e.parts[2].title = "Two balls per box";
  e.parts[2].caption =
      "A dashed ball contains the box, a solid one lies in it; both are stored.\n"
      "Outer balls apart: surely disjoint. Inner balls meet: surely overlapping.";
  e.parts[3].title = "Full test only in doubt";
  const int left = others - rejected - accepted;
  e.parts[3].caption = fmt::format("The balls reject {} and accept {}. {} left to the axes.", plural(rejected, "box"),
                                   accepted, left == 1 ? "1 is" : fmt::format("{} are", left));
  e.saving = "Two squared distances are far cheaper than fifteen axes.";
  return e;
}

Experiment reuse(const Flat& p) {
  const Box b = upright({-1.05, -0.9}, 0, 1.9, 0.4);
  Experiment e = {
      .title = "2: reuse results",
      .source = "Lecture note, rules of thumb (2); Ericson, Real-Time Collision Detection (2005), 4.4",
      .alt = "A slender box glides past a flat one, shown at twelve moments.",
      .pseudocode = {"for each time", "    without: test axis after axis until one separates",
                     "    with: test the axis that separated before", "    only if it fails: test axis after axis"},
      .unit = "axes tested"};
  constexpr int frames = 12;
  std::optional<obb_obb::Axis> last;
  bool top_or_bottom = false;  // what separates is that face of b
  int kept = 0;
  for (Part& part : e.parts) part.items.emplace_back(region(corners(b), Role::second));
  for (int k = 0; k < frames; ++k) {
    const Box a = upright(p + Flat(0.21 * k, 0), 35 + 4 * k, 0.55, 0.12);
    Record<std::variant<obb_obb::Compared<double>>> record;
    const bool meet = obb_obb::gottschalk(a, b, 0., record);
    const auto tests = static_cast<double>(record.events.size());
    e.before += tests;
    bool still = false;
    if (last) {
      const obb_obb::Tested<3> t = obb_obb::tested(a, b, *last, {});
      still = t.distance > t.radius_a + t.radius_b;
      e.after += 1;
    }
    if (!still) e.after += tests;
    kept += still;
    top_or_bottom |= still && *last == obb_obb::Axis{obb_obb::Kind::face_of_b, 1};
    if (!still) last.reset();
    if (!still && !meet) last = std::get<0>(record.events.back()).axis;
    const bool ends = k == 0 || k + 1 == frames;
    const Role role = meet ? Role::hit : Role::first;
    for (std::size_t i = 0; i < 4; ++i) {
      if (ends || i == 1)
        e.parts[i].items.emplace_back(region(corners(a), role));
      else
        e.parts[i].items.emplace_back(outline(corners(a), role, Pen::construction));
    }
  }
  const double face = b.center.y() + (p.y() > b.center.y() ? b.half[1] : -b.half[1]);
  for (const std::size_t i : {std::size_t{2}, std::size_t{3}})
    if (top_or_bottom) e.parts[i].items.emplace_back(line({-3.2, face}, {1.1, face}, Role::highlight, Pen::highlight));
  e.details = {{"times", frames}, {"axis still separates", kept}};
  e.parts[0].title = "Reuse what was found";
  e.parts[0].caption =
      "A slender box starts at **p** and glides past the flat one. From one time to the next little "
      "changes.";
  e.parts[1].title = "From scratch each time";
  e.parts[1].caption =
      "At each time the axes are tried in the same order, until one separates the boxes or none is left.";
  e.parts[2].title = "Keep the last axis";
  e.parts[2].caption = "The axis that separated the boxes last time is tried first. Failed tests are results, too.";
  e.parts[3].title = kept > 0 ? "One axis is enough" : "No axis to keep";
  e.parts[3].caption =
      kept > 0 ? fmt::format("At {} of {} times the axis kept from before still separates: one test, and done.", kept,
                             frames)
               : "At no time did an axis kept from before separate the boxes.";
  e.saving = "Motion is coherent: what separated the boxes a moment ago usually still does.";
  return e;
}

}  // namespace isect::lessons::rules_of_thumb_lesson
