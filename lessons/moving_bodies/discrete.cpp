// Two boxes tested time after time: what lies between two tests is missed, and how close tests would have to follow.

#include <cmath>

#include "lessons/moving_bodies/telling.h"
#include "lessons/shared/plural.h"
#include "lessons/shared/questions.h"

namespace isect::lessons::moving_bodies_lesson {

using namespace viz;

namespace {

class DiscreteTeller : Teller {
 public:
  explicit DiscreteTeller(const Setup& s)
      : Teller(s, "discrete times",
               "Lecture note, collision detection; Ericson, Real-Time Collision Detection (2005), 5.5",
               {"d ← v_b − v_a; dt ← duration / n",                      // 0
                "for i ← 0 to n",                                        // 1
                "    move both boxes to their places at t = i dt",       // 2
                "    if they share a point: record t",                   // 3
                "t_in, t_out ← when the boxes meet and part",            // 4
                "if dt ≤ t_out − t_in: one of the tests must see them",  // 5
                "compare t_in with the first t recorded"}),              // 6
        dt_(s.duration / s.tests) {}

  Walk tell() {
    two_bodies(0);
    seen_from_a(0);
    between_tests();
    Record<motion::Event<double, 2>> record;
    hits_ = discrete_hits(s_.box_a(), s_.box_b(), s_.duration, s_.tests, record);
    std::vector<motion::At<double>> tests;
    for (const auto& event : record.events)
      if (const auto* e = std::get_if<motion::At<double>>(&event)) tests.push_back(*e);
    for (std::size_t i = 0, next = 0; i < tests.size(); i = next) {
      while (next < tests.size() && tests[next].meet == tests[i].meet) ++next;
      const auto from = tests.begin() + static_cast<std::ptrdiff_t>(i);
      say(std::vector(from, from + static_cast<std::ptrdiff_t>(next - i)), i);
    }
    truth();
    end("contact", s_.first ? "First contact" : "No contact", 6, s_.first.has_value(), told());
    return std::move(script_.walk());
  }

 private:
  void between_tests() {
    const double d = s_.d().norm();
    script_.value("dt", dt_);
    add("between-tests", "From one test to the next", 1,
        fmt::format("{} are made, one every {} s. From one to the next a moves by {}, and b by {}.\n"
                    "Seen from a, b moves by {}: that is the length which may jump over the boxes.",
                    plural(s_.tests + 1, "test"), shown(dt_), shown(s_.v_a.norm() * dt_), shown(s_.v_b.norm() * dt_),
                    shown(d * dt_)),
        "|**d**| dt = " + shown(d * dt_));
  }

  /// Tests in a row that found the same; `number`: of the first.
  void say(const std::vector<motion::At<double>>& tests, std::size_t number) {
    const bool one = tests.front().time == tests.back().time, meet = tests.front().meet;
    for (const motion::At<double>& test : tests) {
      known_.at.push_back(test.time);
      known_.ticks.push_back({test.time, meet ? Mark::disc : Mark::ring, meet ? Role::hit : Role::first, ""});
    }
    const std::string at =
        one ? "The test at *t* = " + shown(tests.front().time)
            : fmt::format("The tests at *t* = {} to {}", shown(tests.front().time), shown(tests.back().time));
    add(fmt::format("tests-{}", number), at, meet ? 3 : 2,
        std::string(one ? "This test finds" : "Each of these tests finds") +
            (meet ? " that the boxes share a point." : " the boxes apart."))
        .decides = meet;
  }

  /// Adds the steps about the exact times, and about how long dt may be.
  void truth() {
    const std::optional<Interval<double>> times = contact(s_.box_a(), s_.box_b(), s_.duration);
    if (!times) {
      add("truth", "All times at once", 4,
          "The times on each axis share no time of the motion: the boxes do not meet.");
      return;
    }
    known_.shared = *times;
    known_.settled = true;
    script_.value("*t*_{in}", times->lo, {}, Role::hit);
    script_.value("*t*_{out}", times->hi, {}, Role::hit);
    const bool inside = times->lo > 0 && times->hi < s_.duration;
    Step& step = add("truth", "All times at once", 4,
                     fmt::format("The times on each axis give all times of contact, without a gap: from {} to {}.",
                                 shown(times->lo), shown(times->hi)));
    if (inside) ask_how_long(step, times->hi - times->lo);
    how_close(times->hi - times->lo, inside);
  }

  /// Asks for how long boxes meet that move along one axis.
  void ask_how_long(Step& step, double length) {
    const Vector<double, 2> d = s_.d();
    if ((d[0] == 0) == (d[1] == 0)) return;
    const double speed = std::abs(d[0] + d[1]), a = 2 * s_.r_a, b = 2 * s_.r_b;
    const double v_b = s_.v_b.norm(), other = v_b > 0 ? v_b : 2 * speed;
    step.question = which_value(
        fmt::format("Box a is {} wide, box b {}. Seen from a, b moves by {} a second along an axis. For how long do "
                    "they share points?",
                    shown(a), shown(b), shown(speed)),
        length,
        {{a / speed, "That takes box b for a point."},
         {(a + b) / other, v_b > 0 ? "That divides by the speed of b alone." : "That divides by twice the speed."},
         {2 * length, "That is twice as long."}},
        "From the first contact to the last, b moves by both widths together.");
    keep_picture(script_.walk());
  }

  /// `inside`: they meet after the first test, and part before the last one.
  void how_close(double length, bool inside) {
    const bool seen = !hits_.empty(), close = dt_ <= length;
    rounded_ = !seen && (close || !inside);
    const char* const when = s_.truth == Meeting::at_first ? "start" : "end";
    script_.value("*t*_{out} − *t*_{in}", length, {}, Role::hit);
    Step& step = add(
        "how-close", "How close must tests follow?", 5,
        rounded_  ? "Rounding moves the boxes apart at each test: none sees the contact."
        : close   ? "The contact lasts at least as long as dt. So some test falls into it."
        : !inside ? fmt::format("The contact is shorter than dt. Yet it holds at the {} of the motion, and so does a "
                                "test.",
                                when)
        : seen    ? "The contact is shorter than dt: it might lie between two tests. Here one falls into it."
               : "The contact is shorter than dt, and lies between two tests. So the boxes tunnel through each other.");
    Script::decide(step, {"dt ≤ *t*_{out} − *t*_{in}", dt_, length, close,
                          close ? "no contact of this length is missed" : "such a contact may be missed"});
    if (!close) script_.refuse(5, {});
  }

  std::string told() const {
    if (!s_.first && !hits_.empty()) return "Rounding has moved a test into contact: exactly, they do not meet.";
    if (!s_.first) return "The tests find nothing, either. " + reason();
    if (rounded_) return "Rounding has moved the boxes apart at each test: exactly, they meet.";
    if (hits_.empty())
      return "The tests report nothing: this is tunnelling. On a slanted course, contact at a corner may be very "
             "short.\n"
             "So no dt is short enough for all courses. Compute the times instead.";
    if (shown(hits_[0]) != shown(*s_.first))
      return fmt::format("The first test that sees them is at *t* = {}, later than first contact.", shown(hits_[0]));
    return "A test sees them at first contact. " + reason();
  }

  const double dt_;
  std::vector<double> hits_;
  bool rounded_ = false;  ///< rounding alone hides the contact from the tests
};

}  // namespace

Walk discrete(const Setup& s) { return DiscreteTeller(s).tell(); }

}  // namespace isect::lessons::moving_bodies_lesson
