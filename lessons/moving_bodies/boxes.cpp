// Two boxes that move: on each axis the times at which their extents share points, and what these have in common.

#include <algorithm>
#include <array>
#include <cmath>

#include "lessons/moving_bodies/telling.h"
#include "lessons/shared/axis_names.h"
#include "lessons/shared/questions.h"

namespace isect::lessons::moving_bodies_lesson {

using namespace viz;
using C = Counted<double>;

namespace {

class BoxesTeller : Teller {
 public:
  explicit BoxesTeller(const Setup& s)
      : Teller(s, "two boxes", "Lecture note, rays; Ericson, Real-Time Collision Detection (2005), 5.5.8",
               {"begin, end ← 0, duration",                          // 0
                "d ← v_b − v_a",                                     // 1
                "for each axis i of x, y",                           // 2
                "    if d_i = 0 and the extents are apart",          // 3
                "        return MISS",                               // 4
                "    t₁, t₂ ← when the extents on i meet and part",  // 5
                "    begin, end ← max(begin, t₁), min(end, t₂)",     // 6
                "    if begin > end",                                // 7
                "        return MISS",                               // 8
                "return HIT, begin"}) {}                             // 9

  Walk tell() {
    two_bodies(0);
    seen_from_a(1);
    known_.clock = true;
    add("each-axis", "An interval of times for each axis", 2,
        "A box is a product of extents. Boxes share a point when their extents do on both axes at once.\n"
        "On each axis the extents share points for an interval of times. The boxes meet at the times that both "
        "intervals share.");
    script_.tell<motion::AxesEvent<C, 2>>(
        [&](auto& record) {
          const Moving<Aabb, double, 2> a = s_.box_a(), b = s_.box_b();
          const auto times =
              contact_by_axes(Moving<Aabb, C, 2>{cast<C>(a.shape), a.velocity.cast<C>()},
                              Moving<Aabb, C, 2>{cast<C>(b.shape), b.velocity.cast<C>()}, C(s_.duration), record);
          found_ = times.has_value();
        },
        [&](const auto& event) { say(event); });
    if (!found_) script_.leave_early();
    end("contact", found_ ? "First contact" : "No contact", line_, found_, told());
    return std::move(script_.walk());
  }

 private:
  void say(const motion::Relative<C, 2>&) {}  // told before

  void say(const motion::Level& e) {
    const std::string axis = axis_names[e.axis];
    Step& step = add(std::string("level-") + "xy"[e.axis], "No motion on " + axis, 3,
                     e.apart ? "On " + axis + " b does not move, seen from a, and the extents are apart. So they stay."
                             : "On " + axis +
                                   " b does not move, seen from a, and the extents share points. So they do "
                                   "all the time: this axis rules out no time.");
    step.decides = e.apart;
    if (e.apart) line_ = 4;
  }

  void say(const motion::AxisTimes<C>& e) {
    const int i = e.axis;
    const std::string axis = axis_names[i], on = " on " + axis;
    const Interval<double> times = {e.begin.value, e.end.value};
    const Interval<double> a = s_.box_a().shape.along(i), b = s_.box_b().shape.along(i);
    axis_ = i;
    times_[i] = times;
    script_.value("*t*_1" + on, times.lo);
    script_.value("*t*_2" + on, times.hi);
    known_.rows.push_back({axis, times, Role::text});
    Step& step = add(std::string("times-") + "xy"[i], "The times" + on, 5,
                     "Divide the lengths between sides" + on +
                         " by the speed there. At *t*_1 the sides that face each other meet, at "
                         "*t*_2 the far ones part." +
                         std::string(times.lo < 0 ? "\nA negative time is one before the motion began." : ""),
                     "*t*_1 = " + shown(times.lo) + ", *t*_2 = " + shown(times.hi));
    if (!(times.lo > 0)) return;
    const double d = s_.d()[i], gap = std::max(b.lo - a.hi, a.lo - b.hi);
    std::vector<WrongNumber> wrong = {{std::abs((s_.b - s_.a)[i] / d), "That is from centre to centre."},
                                      {times.hi, "That is when the far sides part."}};
    if (gap < 100 * times.lo) wrong.push_back({gap, "That is the gap itself, not divided by the speed."});
    step.question = which_value(
        fmt::format("On {} a reaches from {} to {}, b from {} to {}. Seen from a, b moves there by {} a second. When "
                    "do these extents meet?",
                    axis, shown(a.lo), shown(a.hi), shown(b.lo), shown(b.hi), shown(d)),
        times.lo, wrong, "The gap between the sides that face each other, divided by the speed.");
    keep_picture(script_.walk());
  }

  void say(const motion::Left<C>& e) {
    const Interval<double> times = {e.begin.value, e.end.value};
    const bool last = axis_ == 1;
    script_.value("begin", times.lo);
    script_.value("end", times.hi);
    const std::vector<Row> rows = known_.rows;
    if (e.holds) known_.rows.push_back({"", times, Role::hit});
    if (e.holds && !last) {
      add("left", "The times that are left", 6,
          "What is left are the times of the motion at which the extents on *x* share points. The other axis may rule "
          "out more.");
      known_.rows = rows;
      return;
    }
    known_.found = e.holds;
    Step& step = add("decision", "Is a time left?", 7, left_caption(e.holds));
    Script::decide(step,
                   {"begin > end", times.lo, times.hi, !e.holds, e.holds ? "some time is left" : "no time is left"});
    if (rows.size() == 2 && e.holds == s_.first.has_value()) ask_when(times.lo);
    if (e.holds)
      script_.refuse(7, {});
    else
      line_ = 8;
  }

  std::string left_caption(bool holds) const {
    if (holds != s_.first.has_value()) return "The two times are so close that rounding has changed their order.";
    return holds ? "The latest begin is not after the earliest end: from one to the other the boxes share points."
                 : "The latest begin is after the earliest end. So no time is left.";
  }

  /// Asks for first contact: the latest begin, not the earliest one.
  void ask_when(double begin) {
    Question q = {fmt::format("Extents share points on *x* from *t* = {} to {}, on *y* from {} to {}. The motion lasts "
                              "from 0 to {}. When do the boxes first meet?",
                              shown(times_[0].lo), shown(times_[0].hi), shown(times_[1].lo), shown(times_[1].hi),
                              shown(s_.duration)),
                  {},
                  0,
                  "They meet when both axes allow it: first at the latest begin, if that is not after the earliest "
                  "end."};
    std::vector<double> offered = {times_[0].lo, times_[1].lo, begin};
    std::ranges::sort(offered);
    for (const double t : offered)
      if (q.choices.empty() || q.choices.back() != shown(t)) q.choices.push_back(shown(t));
    q.choices.emplace_back("not within the motion");
    q.answer = s_.first ? static_cast<int>(std::ranges::find(q.choices, shown(begin)) - q.choices.begin())
                        : static_cast<int>(q.choices.size()) - 1;
    if (s_.first) ask_for_number(q, begin, 3, wrong_times());
    script_.walk().steps.back().question = q;
  }

  /// Times that are taken for first contact.
  std::vector<WrongNumber> wrong_times() const {
    std::vector<WrongNumber> all;
    for (const std::size_t i : {0U, 1U})
      all.push_back({times_[i].lo, times_[i].lo < 0
                                       ? std::string("At that time the motion has not begun.")
                                       : fmt::format("By then the extents share points on {}, but not yet on {}.",
                                                     axis_names[i], axis_names[1 - i])});
    all.push_back({std::min(times_[0].hi, times_[1].hi), "Then they part on one axis. First contact comes before."});
    return all;
  }

  std::string told() const {
    if (s_.truth != Meeting::met) return reason();
    return fmt::format("The latest begin is that of {}: there the last gap closes. {}", axis_names[entered()],
                       reason());
  }

  /// The axis whose extents are the last to meet, as the core finds.
  int entered() const {
    Record<motion::Event<double, 2>> record;
    first_contact(s_.box_a(), s_.box_b(), s_.duration, record);
    for (const auto& event : record.events)
      if (const auto* e = std::get_if<slabs::Stretch>(&event)) return e->entered;
    return 0;
  }

  std::array<Interval<double>, 2> times_ = {};
  bool found_ = false;
  int axis_ = 0;  ///< of the times told last
  int line_ = 9;  ///< that returns
};

}  // namespace

Walk boxes(const Setup& s) { return BoxesTeller(s).tell(); }

}  // namespace isect::lessons::moving_bodies_lesson
