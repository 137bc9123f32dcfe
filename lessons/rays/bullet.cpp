// A small moving object as a ray: its way from one frame to the next is a segment.

#include <fmt/format.h>

#include <isect/many/motion.h>
#include <isect/methods/motion.h>
#include "lessons/rays/picture.h"
#include "lessons/shared/questions.h"
#include "lessons/shared/script.h"

namespace isect::lessons::rays_lesson {

using namespace viz;
using C = Counted<double>;

namespace {

constexpr double frame = 1;  ///< from one picture to the next, in units of time
const Interval<double> wall_x = {0.25, 0.5};

const Aabb<double, 2> wall_box = {{wall_x.lo, -1.5}, {wall_x.hi, 1.75}};

class Flight {
 public:
  Flight(const Vec3& p, const Vec3& velocity)
      : bullet_{{p.head<2>(), p.head<2>()}, velocity.head<2>()},
        wall_{wall_box, {0, 0}},
        ray_{p.head<2>(), velocity.head<2>(), {0, frame}},
        truth_(contact(bullet_, wall_, frame)),
        script_({"Lecture note Intersection Detection, rays; Ericson, Real-Time Collision Detection (2005), 5.5",
                 std::string("A bullet, and a thin wall from *x* = 0.25 to 0.5: ") +
                     (truth_ ? "it is in the wall within the frame." : "it does not reach the wall within the frame."),
                 {"o ← position; d ← velocity",                 // 0
                  "test at t = 0 and at t = Δt",                // 1
                  "t_min, t_max ← 0, Δt",                       // 2
                  "return the part of the range in the wall"},  // 3
                 "a bullet"}) {}

  Walk tell() {
    add("bullet", "A bullet", 0,
        "Rays stand in for moving objects: a cheap, approximate test. A bullet is so small that a point will do.\n"
        "Its position is **o**, its velocity **d**, and *t* is the time.",
        "**r**(*t*) = **o** + *t* **d**");
    frames();
    segment();
    hit();
    return std::move(script_.walk());
  }

 private:
  Vec3 at(double t) const { return flat(ray_.at(t)); }

  Scene picture() const {
    Scene scene;
    Region wall;
    wall.rings = {corners(wall_box)};
    scene.items.emplace_back(wall);
    scene.items.emplace_back(Label{Vec3(wall_x.hi, -1.25, 0), "wall", Role::second});
    if (!segment_ && !frames_) {
      scene.items.emplace_back(Arrow{at(0), at(frame), Role::first, Pen::solid});
      scene.items.emplace_back(Label{at(0), "**d**", Role::first, at(frame)});
    }
    if (segment_) scene.items.emplace_back(Line{at(0), at(frame), Role::first, Pen::thick});
    if (settled_ && truth_) {
      scene.items.emplace_back(Dot{at(truth_->lo), Mark::disc, Role::hit});
      scene.items.emplace_back(Dot{at(truth_->hi), Mark::ring, Role::hit});
      scene.items.emplace_back(Label{at(truth_->lo), "*t*_{in}", Role::hit});
      scene.items.emplace_back(Label{at(truth_->hi), "*t*_{out}", Role::hit});
    }
    scene.items.emplace_back(Dot{at(0), Mark::disc, Role::first});
    scene.items.emplace_back(Label{at(0), frames_ ? "*t* = 0" : "**o**", Role::first});
    if (frames_) {
      scene.items.emplace_back(Dot{at(frame), Mark::disc, Role::first});
      scene.items.emplace_back(Label{at(frame), "*t* = Δ*t*", Role::first});
    }
    scene.handles = {{"o", Handle::Kind::point, at(0), Vec3::Zero(), Role::first},
                     {"d", Handle::Kind::vector, at(1), at(0), Role::first}};
    scene.axis = axis();
    return scene;
  }

  Axis axis() const {
    Axis axis;
    axis.lo = -0.25, axis.hi = frame + 0.25;
    axis.range_lo = 0, axis.range_hi = segment_ ? frame : infinite<double>.hi;
    if (settled_ && truth_) {
      axis.shared = Vec2(truth_->lo, truth_->hi);
      axis.ticks = {{truth_->lo, Mark::disc, Role::hit, "*t*_{in}"}, {truth_->hi, Mark::ring, Role::hit, "*t*_{out}"}};
    }
    return axis;
  }

  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption,
            const std::string& formula = {}) {
    Step& step = script_.add(slug, title, line, caption, formula);
    step.scene = picture();
    return step;
  }

  void frames() {
    frames_ = true;
    const auto seen = discrete_hits(bullet_, wall_, frame, 1).size();
    Step& step =
        add("frames", "Two frames", 1,
            seen == 0   ? "A program that tests frame by frame sees the bullet twice, each time outside the wall."
            : seen == 1 ? "A program that tests frame by frame sees the bullet in the wall, at one of the two times."
                        : "A program that tests frame by frame sees the bullet in the wall, both times.");
    step.decides = true;
    step.question = which_count(
        "How many of the two tests, at *t* = 0 and *t* = Δ*t*, find the bullet in the wall?", static_cast<double>(seen),
        {{0, "At least one of the two tests finds it."},
         {1, seen == 0 ? "Both tests look at a point outside the wall." : "Both tests find it."},
         {2, "At least one of the two tests looks at a point outside the wall."}},
        "Each test looks at one point of the way, and at no other.");
  }

  void segment() {
    segment_ = true;
    add("segment", "The path in between", 2,
        "From one frame to the next, in the time Δ*t*, the bullet covers a segment: a ray with a finite range.\n"
        "So one intersection test with a ray covers all the times in between.",
        "0 ≤ *t* ≤ Δ*t* = " + shown(frame));
  }

  void hit() {
    settled_ = true;
    Ray<double, 2> course = ray_;
    course.range.hi = infinite<double>.hi;
    const bool later = !truth_ && intersects(course, wall_.shape);
    if (truth_) script_.value("*t*_{in}", truth_->lo, "time", Role::hit);
    script_.settle(truth_ ? Verdict::Kind::yes : Verdict::Kind::no,
                   truth_ ? "the bullet hits the wall at *t* = " + shown(truth_->lo)
                          : "the bullet does not hit the wall within the frame");
    Step& step =
        add("hit", "The ray's answer", 3,
            truth_  ? "The segment meets the wall, and *t* gives the time: continuous collision detection.\n"
                      "For a larger object expand the wall by it (their Minkowski sum), and follow the object's centre."
            : later ? "The segment ends before the wall. On the same course a later frame will hit."
                    : "The bullet's course does not meet the wall at any later time.");
    step.question = {"When does the bullet hit the wall?",
                     {"within this frame", "in a later frame, on this course", "never, on this course"},
                     truth_  ? 0
                     : later ? 1
                             : 2,
                     "The segment from **o** to **o** + Δ*t* **d** covers this frame; its ray covers all later ones."};
  }

  const Moving<Aabb, double, 2> bullet_, wall_;
  Ray<double, 2> ray_;
  std::optional<Interval<double>> truth_;
  Script script_;
  bool frames_ = false, segment_ = false, settled_ = false;
};

}  // namespace

bool tunnels(const Vec3& p, const Vec3& velocity) {
  const Moving<Aabb, double, 2> bullet = {{p.head<2>(), p.head<2>()}, velocity.head<2>()}, wall = {wall_box, {0, 0}};
  return contact(bullet, wall, frame) && discrete_hits(bullet, wall, frame, 1).empty();
}

Walk bullet(const Vec3& p, const Vec3& velocity) { return Flight(p, velocity).tell(); }

}  // namespace isect::lessons::rays_lesson
