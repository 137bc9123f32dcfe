#include "lessons/collision/telling.h"

#include <fmt/format.h>

#include <isect/methods/motion.h>
#include "lessons/collision/flight.h"

namespace isect::lessons::collision_lesson {

using namespace viz;

namespace {

constexpr int times = 6;

/// Whether a box that moves along x passes the wall's end so closely that they share boundary points only.
bool grazes(const Moving<Aabb, double, 2>& bullet, const Moving<Aabb, double, 2>& wall) {
  return relate(bullet.shape.along(1), wall.shape.along(1)) == Relation::touching;
}

class Flight : FlightPicture {
 public:
  Flight(const Vec3& p, double speed)
      : FlightPicture(p, speed),
        script_({"Lecture note, rays and collision detection; Ericson, Real-Time Collision Detection (2005), section "
                 "5.5",
                 std::string(speed > 0 ? "A small box flies to the right; a thin wall stands in the middle. "
                                       : "A small box rests; a thin wall stands in the middle. ") +
                     (!truth_     ? "They never meet."
                      : speed > 0 ? "They meet along its path."
                                  : "They meet."),
                 {"for each time t ← 0, dt, 2 dt, ...",                       // 0
                  "    move the box to its place at t",                       // 1
                  "    if box and wall overlap: record t",                    // 2
                  "if the volume that the box sweeps misses the wall",        // 3
                  "    return MISS",                                          // 4
                  "return where a ray meets the wall, expanded by the box"},  // 5
                 "a moving box"}) {}

  Walk tell() {
    at_ = 0;
    const double step = bullet_.velocity.x() * duration / times, reach = this->reach();
    script_.value("step", step, "length", Role::first);
    script_.value("wall + box", reach, "length", Role::second);
    Step& first =
        add("motion", step > 0 ? "A moving box" : "A box at rest", 0,
            fmt::format("{} it is tested every {} s.\n",
                        step > 0 ? "It moves to the right at constant speed;" : "Its speed is 0;", duration / times) +
                (step > reach ? "One step is longer than wall and box together, so it can jump the wall unseen."
                              : "One step is no longer than wall and box together: it cannot jump the wall."));
    first.formula = fmt::format("step = {} {} {} = wall + box", shown(step), step > reach ? ">" : "≤", shown(reach));
    first.question =
        which_value(fmt::format("The wall is {} wide, the box {}. How long may one step be, so that no hit "
                                "is missed?",
                                shown(width(wall_.shape)), shown(width(bullet_.shape))),
                    reach,
                    {{width(wall_.shape), "That is the width of the wall alone."},
                     {width(bullet_.shape), "That is the width of the box alone."},
                     {2 * reach, "That is twice the sum of both widths."}},
                    "The box touches the wall while it moves by the sum of both lengths.");
    Record<motion::Event<double, 2>> record;
    const std::vector<double> hits = discrete_hits(bullet_, wall_, duration, times, record);
    int number = 0;
    for (const auto& event : record.events)
      if (const auto* e = std::get_if<motion::At<double>>(&event)) say(*e, number++);
    at_ = -1;
    if (swept()) ray(hits);
    return std::move(script_.walk());
  }

 private:
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
        e.meet ? "Box and wall have common points." : apart(place(e.time)))
        .decides = e.meet;
  }

  std::string apart(const Aabb<double, 2>& box) const {
    const double before = wall_.shape.lo.x() - box.hi.x(), after = box.lo.x() - wall_.shape.hi.x();
    return before > 0  ? "The box is still " + shown(before) + " before the wall."
           : after > 0 ? "The box is " + shown(after) + " beyond the wall."
                       : "The box passes beside the wall.";
  }

  /// Adds the step about the swept volume. Returns whether more is left to test.
  bool swept() {
    swept_ = true;
    const bool may = may_collide(bullet_, wall_, duration), meet = truth_.has_value();
    Step& step =
        add("swept", "The swept volume", 3,
            !may ? "A box around the whole path misses the wall: they cannot collide."
            : rests() && meet
                ? "The box stays where it is, so it sweeps no more than itself. It meets the wall: they do meet."
            : meet ? "A box around the whole path meets the wall. The box moves along an axis, so it sweeps just "
                     "that box: they do meet.\n"
                     "On a slanted path the box around it is larger than what is swept, and they might not."
                   : "A box around the whole path, rounded outwards, meets the wall: they may collide.");
    step.decides = true;
    // 2: that it is so on a slanted path
    if (!rests())  // else the first test has shown it
      step.question = Question{"The discrete times are over. What does a box around the whole path show?",
                               {"they never meet", "they meet, though not when", "nothing for certain"},
                               !may   ? 0
                               : meet ? 1
                                      : 2,
                               "It is one box from the first place to the last one. Along an axis it is just what the "
                               "moving box sweeps."};
    if (may) {
      script_.refuse(3, {4});
      return true;
    }
    script_.settle(Verdict::Kind::no, "they never meet");
    script_.leave_early();
    add("never", "No collision", 4,
        rests() ? "The box stays where it is, so one test of two boxes has settled all of it: a trivial reject."
                : "One test of two boxes has settled the whole flight: a trivial reject.");
    return false;
  }

  void ray(const std::vector<double>& hits) {
    swept_ = false, grown_ = true;
    const bool tunnels = truth_ && hits.empty();
    if (truth_) script_.value("*t*_{in}", truth_->lo, {}, Role::hit);
    const bool lasts = truth_ && truth_->hi == duration;
    script_.settle(truth_ ? Verdict::Kind::yes : Verdict::Kind::no,
                   !truth_ ? "they never meet"
                   : lasts ? fmt::format("they meet from *t* = {} until the motion ends", shown(truth_->lo))
                           : fmt::format("they meet from *t* = {} to {}", shown(truth_->lo), shown(truth_->hi)));
    Step& step =
        add("ray", "The box as a ray", 5,
            std::string("Expand the wall by the box (their Minkowski sum), and the box becomes a point") +
                (rests() ? ": a ray of direction 0.\n" : " on a ray.\n") +
                (tunnels && grazes(bullet_, wall_)
                     ? "The discrete times missed it: the box grazes the end of the wall, and passes beside it."
                 : tunnels               ? "The discrete times missed it: the box tunnelled through."
                 : !truth_               ? "The ray misses the expanded wall."
                 : truth_->lo == hits[0] ? "The discrete times saw its first moment, too."
                                         : "The discrete times saw it too, but later than it began."));
    if (!truth_ || truth_->lo <= 0) return;
    const double gap = wall_.shape.lo.x() - bullet_.shape.hi.x(), v = bullet_.velocity.x();
    step.question = which_value(fmt::format("The gap between box and wall is {} at *t* = 0, the speed {}. At what time "
                                            "do they first meet?",
                                            shown(gap), shown(v)),
                                truth_->lo,
                                {{hits.empty() ? truth_->hi : hits[0],
                                  hits.empty() ? "That is the end of the contact, and not its beginning."
                                               : "That is the first discrete time that sees it. It began before."},
                                 {(gap + reach() / 2) / v, "That is when their centres meet."},
                                 {truth_->hi, "That is the end of the contact, and not its beginning."}},
                                "The gap between box and wall, divided by the speed.");
  }

  static double width(const Aabb<double, 2>& b) { return b.hi.x() - b.lo.x(); }
  double reach() const { return width(bullet_.shape) + width(wall_.shape); }

  Script script_;
};

}  // namespace

Encounter encounter(const Vec3& p, double speed) {
  const Moving<Aabb, double, 2> bullet = bullet_at(p, speed), wall = the_wall();
  return {contact(bullet, wall, duration), !discrete_hits(bullet, wall, duration, times).empty(), grazes(bullet, wall)};
}

Walk tunnelling(const Vec3& p, double speed) { return Flight(p, speed).tell(); }

}  // namespace isect::lessons::collision_lesson
