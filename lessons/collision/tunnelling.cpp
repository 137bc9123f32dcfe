#include "lessons/collision/telling.h"

#include <fmt/format.h>

#include <isect/motion.h>

namespace isect::lessons::collision_lesson {

using namespace viz;

namespace {

using Box = Aabb<double, 2>;
constexpr double duration = 1.5;
constexpr int times = 6;

Region region(const Box& b, Role role) {
  Region r;
  r.rings = {corners(b)};
  r.role = role;
  return r;
}

class Flight {
 public:
  Flight(const Vec3& p, double speed)
      : bullet_{{{p.x() - 0.25, p.y() - 0.25}, {p.x() + 0.25, p.y() + 0.25}}, {speed, 0}},
        wall_{{{0.4, -1.75}, {0.6, 1.75}}, {0, 0}},
        truth_(contact(bullet_, wall_, duration)),
        script_({"Note, N25, N16; Ericson (2005), 5.5",
                 std::string("A small box flies to the right; a thin wall stands in the middle. ") +
                     (truth_ ? "They meet on its way." : "They never meet."),
                 {"for each time t ← 0, dt, 2 dt, ...",                      // 0
                  "    move the box to its place at t",                      // 1
                  "    if box and wall overlap: return HIT",                 // 2
                  "sweep the box: a larger box that holds its way",          // 3
                  "if that misses the wall: return MISS",                    // 4
                  "grow the wall by the box; return where a ray meets it"},  // 5
                 "a moving box"}) {}

  Walk tell() {
    at_ = 0;
    add("motion", "A moving box", 0,
        "It moves to the right at a steady speed. The wall is thinner than one step of it.");
    Record<motion::Event<double, 2>> record;
    const std::vector<double> hits = discrete_hits(bullet_, wall_, duration, times, record);
    int number = 0;
    for (const auto& event : record.events)
      if (const auto* e = std::get_if<motion::At<double>>(&event)) say(*e, number++);
    at_ = -1;
    swept(hits);
    ray(hits);
    return std::move(script_.walk());
  }

 private:
  Scene picture() const {
    Scene scene;
    scene.items.emplace_back(region(wall_.shape, Role::second));
    if (swept_)
      scene.items.emplace_back(Chain{region(way(), Role::first).rings[0], true, Role::construction, Pen::construction});
    for (const double t : seen_)
      scene.items.emplace_back(Chain{region(place(t), Role::first).rings[0], true, Role::first, Pen::construction});
    if (grown_) {
      const Vector<double, 2> half = (bullet_.shape.hi - bullet_.shape.lo) / 2;
      const Box grown = {wall_.shape.lo - half, wall_.shape.hi + half};
      scene.items.emplace_back(Chain{region(grown, Role::second).rings[0], true, Role::second, Pen::construction});
      scene.items.emplace_back(Arrow{middle(place(0)), middle(place(duration)), Role::first, Pen::solid});
      if (truth_) {
        scene.items.emplace_back(Dot{middle(place(truth_->lo)), Mark::disc, Role::hit});
        scene.items.emplace_back(Dot{middle(place(truth_->hi)), Mark::ring, Role::hit});
        scene.items.emplace_back(Label{middle(place(truth_->lo)), "*t*_{in}", Role::hit});
        scene.items.emplace_back(Label{middle(place(truth_->hi)), "*t*_{out}", Role::hit});
      }
    }
    if (at_ >= 0) {
      scene.items.emplace_back(region(place(at_), Role::first));
      scene.items.emplace_back(
          Label{middle(place(at_)) + Vec3(0, 0.25, 0), fmt::format("*t* = {}", shown(at_)), Role::first});
    }
    scene.items.emplace_back(Dot{middle(place(0)), Mark::disc, Role::first});
    scene.items.emplace_back(Label{middle(place(0)), "**p**", Role::first});
    scene.handles.push_back({"p", Handle::Kind::point, middle(place(0)), Vec3::Zero(), Role::first});
    return scene;
  }

  Box place(double t) const { return motion::moved(bullet_.shape, Vector<double, 2>(t * bullet_.velocity)); }
  Box way() const { return swept_aabb(bullet_.shape, Vector<double, 2>(duration * bullet_.velocity)); }

  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption) {
    Step& step = script_.add(slug, title, line, caption);
    step.scene = picture();
    return step;
  }

  void say(const motion::At<double>& e, int number) {
    at_ = e.time;
    seen_.push_back(e.time);
    script_.value("*t*", e.time);
    add(fmt::format("time-{}", number), fmt::format("*t* = {}", shown(e.time)), e.meet ? 2 : 1,
        e.meet ? "At this time box and wall overlap." : "At this time box and wall are apart.")
        .decides = e.meet;
  }

  void swept(const std::vector<double>& hits) {
    swept_ = true;
    const bool may = may_collide(bullet_, wall_, duration);
    Step& step = add("swept", "All that the box sweeps", may ? 3 : 4,
                     may ? "A box around the whole way meets the wall: they may collide. It never says no wrongly."
                         : "A box around the whole way misses the wall: they cannot collide.");
    step.decides = true;
    step.question = Question{
        "Do they collide between the times?",
        {"yes", "no"},
        truth_ ? 0 : 1,
        hits.empty() && truth_ ? "Before the wall at one time, behind it at the next." : "The exact test tells."};
  }

  void ray(const std::vector<double>& hits) {
    swept_ = false, grown_ = true;
    const bool tunnels = truth_ && hits.empty();
    if (truth_) script_.value("*t*_{in}", truth_->lo, {}, Role::hit);
    script_.settle(
        truth_ ? Verdict::Kind::yes : Verdict::Kind::no,
        truth_ ? fmt::format("they meet from t = {} to {}", shown(truth_->lo), shown(truth_->hi)) : "they never meet");
    add("ray", "The box as a ray", 5,
        std::string("Grow the wall by the box, and the box becomes a point that moves along a ray.\n") +
            (tunnels  ? "The discrete times missed it: the box tunnelled through."
             : truth_ ? "The discrete times saw it too, but not when it began."
                      : "The ray misses the grown wall."));
  }

  Moving<Aabb, double, 2> bullet_, wall_;
  std::optional<Interval<double>> truth_;
  Script script_;
  std::vector<double> seen_;
  double at_ = -1;
  bool swept_ = false, grown_ = false;
};

}  // namespace

Walk tunnelling(const Vec3& p, double speed) { return Flight(p, speed).tell(); }

}  // namespace isect::lessons::collision_lesson
