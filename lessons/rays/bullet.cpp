// A small moving object as a ray: its way from one frame to the next is a segment.

#include <fmt/format.h>

#include <isect/motion.h>
#include "lessons/rays/picture.h"
#include "lessons/shared/script.h"

namespace isect::lessons::rays_lesson {

using namespace viz;
using C = Counted<double>;

namespace {

constexpr double frame = 1;  ///< from one picture to the next, in units of time
const Interval<double> wall_x = {0.25, 0.5};

class Flight {
 public:
  Flight(const Vec3& p, const Vec3& velocity)
      : bullet_{{p.head<2>(), p.head<2>()}, velocity.head<2>()},
        wall_{{{wall_x.lo, -1.5}, {wall_x.hi, 1.75}}, {0, 0}},
        ray_{p.head<2>(), velocity.head<2>(), {0, frame}},
        truth_(contact(bullet_, wall_, frame)),
        script_({"Note, N16, N25; Ericson (2005), 5.5",
                 std::string("A bullet flies towards a thin wall: ") +
                     (truth_ ? "it hits the wall between two frames." : "it does not reach the wall."),
                 {"o ← position; d ← velocity",                 // 0
                  "test at t = 0 and at t = Δt",                // 1
                  "t_min, t_max ← 0, Δt",                       // 2
                  "return the part of the range in the wall"},  // 3
                 "a bullet"}) {}

  Walk tell() {
    add("bullet", "A bullet", 0,
        "A bullet is so small that a point will do. Its position is **o**, its velocity **d**.\n"
        "Then *t* is the time: **r**(*t*) is where the bullet is.",
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
    draw_wall(scene, wall_x);
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
    const bool seen = !discrete_hits(bullet_, wall_, frame, 1).empty();
    Step& step = add("frames", "Two frames", 1,
                     seen ? "A program that tests frame by frame sees the bullet in the wall."
                          : "A program that tests frame by frame sees the bullet twice, each time outside the wall.");
    step.decides = true;
    step.question = {
        "Does one of the two tests see the bullet in the wall?",
        {"yes", "no"},
        seen ? 0 : 1,
        seen ? "At one of the two times it is there." : "It is in the wall for a shorter time, if at all."};
  }

  void segment() {
    segment_ = true;
    add("segment", "The way in between", 2,
        "From one frame to the next the bullet covers a segment: a ray with a finite range.\n"
        "So one intersection test with a ray stands for all the times in between.",
        "0 ≤ *t* ≤ Δ*t* = " + shown(frame));
  }

  void hit() {
    settled_ = true;
    if (truth_) script_.value("*t*_{in}", truth_->lo, "time", Role::hit);
    script_.settle(truth_ ? Verdict::Kind::yes : Verdict::Kind::no,
                   truth_ ? "the bullet hits the wall at *t* = " + shown(truth_->lo) : "the bullet misses the wall");
    Step& step = add("hit", "The ray tells", 3,
                     truth_ ? "The segment meets the wall, and *t* tells when. No frame rate is needed for that.\n"
                              "A larger object works the same: grow the wall by it, and follow its centre."
                            : "The segment ends before the wall or passes it, so the bullet does not hit.");
    step.question = {"Does the bullet hit the wall within the frame?",
                     {"yes", "no"},
                     truth_ ? 0 : 1,
                     "The segment from **o** to **o** + Δ*t* **d** tells."};
  }

  Moving<Aabb, double, 2> bullet_, wall_;
  Ray<double, 2> ray_;
  std::optional<Interval<double>> truth_;
  Script script_;
  bool frames_ = false, segment_ = false, settled_ = false;
};

}  // namespace

Walk bullet(const Vec3& p, const Vec3& velocity) { return Flight(p, velocity).tell(); }

}  // namespace isect::lessons::rays_lesson
