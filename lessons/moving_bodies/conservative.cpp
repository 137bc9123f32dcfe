// Two balls that move, by conservative advancement: steps in time that are too short for a contact.

#include "lessons/moving_bodies/telling.h"
#include "lessons/shared/plural.h"
#include "lessons/shared/questions.h"

namespace isect::lessons::moving_bodies_lesson {

using namespace viz;
using C = Counted<double>;

namespace {

constexpr int told_alone = 3;           ///< so many advances have a step of their own, the others one together
constexpr std::size_t most_drawn = 40;  ///< places of b

class ConservativeTeller : Teller {
 public:
  explicit ConservativeTeller(const Setup& s)
      : Teller(s, s.bound == motion::Bound::speed ? "conservative steps" : "conservative steps, along the centres",
               "Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems (1996); Ericson, Real-Time Collision "
               "Detection (2005), 5.5",
               {"t ← 0; d ← v_b − v_a",                            // 0
                "while t ≤ duration",                              // 1
                "    distance ← |b + t d − a| − r_a − r_b",        // 2
                "    if distance ≤ ε",                             // 3
                "        return NEAR, t",                          // 4
                "    speed ← |d|, or its part along the centres",  // 5
                "    if speed ≤ 0",                                // 6
                "        return MISS",                             // 7
                "    t ← t + distance / speed",                    // 8
                "return MISS"}) {}                                 // 9

  Walk tell() {
    two_bodies(0);
    seen_from_a(0);
    script_.value("*ε*", s_.tolerance, "length");
    script_.tell<motion::AdvancementEvent<C>>(
        [&](auto& record) {
          const Moving<Sphere, double, 2> a = s_.ball_a(), b = s_.ball_b();
          const auto found = advance_conservatively(Moving<Sphere, C, 2>{cast<C>(a.shape), a.velocity.cast<C>()},
                                                    Moving<Sphere, C, 2>{cast<C>(b.shape), b.velocity.cast<C>()},
                                                    C(s_.duration), C(s_.tolerance), s_.bound, most_steps, record);
          ending_ = found.ending;
          steps_ = found.steps;
        },
        [&](const auto& event) { say(event); });
    finish();
    return std::move(script_.walk());
  }

 private:
  void say(const motion::Gap<C>& e) {
    if (advances_ > 0) last_closed_ = distance_ - e.distance.value;
    if (advances_ == 1) first_closed_ = last_closed_;
    time_ = e.time.value, fallen_ = e.distance.value < distance_, distance_ = e.distance.value;
    known_.gap = time_;
    if (known_.ticks.size() < most_drawn) {
      known_.ticks.push_back({time_, Mark::ring, Role::first, ""});
      if (time_ > 0) known_.at.push_back(time_);
    }
    if (!e.near && advances_ >= told_alone) return;  // told together with others
    if (advances_ > told_alone) together();
    script_.value("distance", distance_, "length");
    if (advances_ == 0)
      add("distance", "The distance at first", 2,
          s_.signs.apart > 0
              ? "The balls are as far apart as their centres, less both radii. The lesson on distances has segments, "
                "boxes and capsules.\nFor other convex bodies an algorithm such as GJK finds the distance.\n"
                "Bodies that turn need a higher bound: their angular speed times their reach is added."
              : "The centres are no farther apart than both radii reach: the balls share a point already.");
    if (e.near)
      decide(
          "near", "Within the tolerance?", 3,
          std::string("The distance is within the tolerance *ε*: here the method stops.") +
              (s_.first && advances_ > 0 && distance_ > 0
                   ? "\nUnless b heads straight for a, each step leaves a part of the distance: 0 is approached, and "
                     "not reached.\nHence *ε*. A smaller one may take more steps."
                   : ""),
          {"distance ≤ *ε*", distance_, s_.tolerance, true, "near enough"});
  }

  void say(const motion::Pace<C>& e) {
    const bool all = s_.bound == motion::Bound::speed;
    speed_ = e.speed.value;
    if (speed_ > 0 && advances_ >= told_alone) return;
    if (advances_ > told_alone) together();
    script_.value("speed", speed_);
    if (advances_ == 0)
      add("speed", "How fast may it fall?", 5,
          all ? "The distance of any two points falls in each second by the relative speed at most.\n"
                "So does that of the balls."
              : "Let **n** point from **a** to **b**, of length 1. Along **n** the gap closes at −**d** · **n**.\n"
                "That stays so, and until it has closed along **n** the balls cannot touch.");
    if (!(speed_ > 0))
      decide("receding", "It does not fall", 6,
             s_.first ? "Rounded, the distance does not fall."
             : all    ? "The relative speed is 0: the distance stays as it is."
                      : "Along **n** the gap does not close, now or later. So no contact can follow.",
             {"speed ≤ 0", speed_, 0, true, "no approach"});
  }

  void say(const motion::Advance<C>& e) {
    const double before = time_;
    time_ = e.time.value;
    ++advances_;
    if (advances_ > told_alone) {
      if (e.late) together();
    } else {
      advance(before);
    }
    if (!e.late) return;
    decide("late", "Is the motion over?", 1,
           s_.first ? "Rounded, this time lies after the end of the motion."
                    : "Before this time the balls cannot touch, and the motion has ended by then.",
           {"*t* ≤ duration", time_, s_.duration, false, "the motion is over"});
    script_.refuse(1, {});
  }

  void advance(double before) {
    script_.value("*t*", time_);
    const std::string caption =
        advances_ == 1
            ? "It takes at least distance / speed to close the distance. A step of that length, to *t*, is safe."
            : fmt::format("The distance {} {}. At a speed of {} or less, a further step is safe.",
                          fallen_ ? "has fallen to" : "has not fallen: it is", shown(distance_), shown(speed_));
    Step& step =
        add(fmt::format("advance-{}", advances_), fmt::format("Advance {}", advances_), 8, caption,
            fmt::format("*t* = {} + {} / {} = {}", shown(before), shown(distance_), shown(speed_), shown(time_)));
    if (advances_ > 1) return;
    step.question = which_value(fmt::format("The distance is {}, and it falls by at most {} a second. What is the "
                                            "longest step that surely passes no contact?",
                                            shown(distance_), shown(speed_)),
                                time_,
                                {{distance_ * speed_, "That multiplies. Divide the distance by the speed."},
                                 {distance_, "That is the distance, not divided by the speed."},
                                 {time_ / 2, "That is safe, but half of the longest step."}},
                                "Before distance / speed has passed, the distance cannot close.");
  }

  /// Adds one step for the advances that have none of their own.
  void together() {
    const int more = advances_ - told_alone;
    script_.value("*t*", time_);
    script_.value("distance", distance_, "length");
    add("advances",
        more == 1 ? fmt::format("Advance {}", advances_) : fmt::format("Advances {} to {}", told_alone + 1, advances_),
        8,
        more == 1 ? "One more step follows in the same way."
                  : fmt::format("{} more steps follow in the same way.", counted(more)));
  }

  void decide(const std::string& slug, const std::string& title, int line, const std::string& caption,
              const Comparison& comparison) {
    Script::decide(add(slug, title, line, caption), comparison);
  }

  void finish() {
    const bool near = ending_ == motion::Ending::near, open = ending_ == motion::Ending::open;
    if (open) together();
    known_.gap.reset();
    if (near && !s_.first) return near_miss();
    if (near) script_.value("first contact − *t*", *s_.first - time_);
    const int line = near ? 4 : open ? 1 : speed_ > 0 ? 9 : 7;
    const std::string told = near ? told_near() : open ? told_open() : reason();
    end("contact", near ? "Near a contact" : open ? "Stopped" : "No contact", line, near || (open && s_.first), told);
  }

  /// Adds the end for balls that come within the tolerance, but do not meet in the motion.
  void near_miss() {
    end("contact", "Near, but no contact", 4, false,
        fmt::format("At *t* = {} they are within *ε*, so the method returns it. Yet they do not meet in the motion.\n"
                    "So NEAR does not prove a contact. MISS proves that there is none, but for rounding.",
                    shown(time_)));
    script_.walk().steps.back().verdict = {Verdict::Kind::on, "within *ε*, but they do not meet"};
  }

  std::string told_near() const {
    if (steps_ == 0) return s_.truth == Meeting::at_first ? reason() : "They are within *ε* from the start.";
    const char* const way = s_.bound == motion::Bound::speed
                                ? "With the whole relative speed as bound no step passes the contact."
                                : "Each step is one of Newton's method: the distance is a convex function of *t*, so "
                                  "none passes the contact.";
    return fmt::format("{} led from *t* = 0 to {}; first contact is at {}.\n{}{}", plural(steps_, "step"), shown(time_),
                       shown(*s_.first), told_grazing(),
                       time_ <= *s_.first ? way : "Rounding has put the last step just past it.");
  }

  /// Why balls that graze take many steps.
  std::string told_grazing() const {
    if (s_.truth != Meeting::grazing || steps_ < 2 || !(last_closed_ < first_closed_)) return {};
    return fmt::format(
        "The balls graze: as they pass, the distance shrinks ever more slowly, so the steps get small.\n"
        "The first closed {} of it, the last {}.\n",
        shown(first_closed_), shown(last_closed_));
  }

  std::string told_open() const {
    const std::string told = fmt::format(
        "After {} steps the balls are not within *ε*, and the motion is not over. A larger *ε* ends it sooner.\n",
        counted(most_steps));
    return told + (s_.first ? "The exact test finds first contact at once." : "The exact test finds no contact.");
  }

  motion::Ending ending_ = motion::Ending::open;
  int steps_ = 0, advances_ = 0;
  double time_ = 0, distance_ = 0, speed_ = 0;
  double first_closed_ = 0, last_closed_ = 0;  ///< how much of the distance the first and the last advance closed
  bool fallen_ = false;                        ///< since the last step
};

}  // namespace

Walk conservative(const Setup& s) { return ConservativeTeller(s).tell(); }

}  // namespace isect::lessons::moving_bodies_lesson
