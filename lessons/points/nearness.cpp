// Nearness within a tolerance: three ways to write it against the exact one.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <isect/methods/point_point.h>
#include <isect/point_point.h>
#include "lessons/points/picture.h"
#include "lessons/shared/questions.h"
#include "lessons/shared/script.h"
#include "viz/solids.h"

namespace isect::lessons::points_lesson {

using namespace viz;

namespace {

using C = Counted<double>;

std::string word(bool near) { return near ? "NEAR" : "FAR"; }

class Nearness {
 public:
  explicit Nearness(const Setup& setup)
      : s_(setup),
        said_(said(setup)),
        script_({"Lecture note Intersection Detection, points; the tolerance is ours",
                 std::string("Two points in space and a ball of tolerance around the first: ") +
                     (said_[0].near ? "near." : "far."),
                 {"squares: |p − q|² ≤ tolerance²?",                // 0
                  "distance: |p − q| ≤ tolerance?",                 // 1
                  "coordinates: |p_i − q_i| ≤ tolerance for all?",  // 2
                  "exact: the true sign of |p − q|² − tolerance²",  // 3
                  "return NEAR or FAR"},                            // 4
                 "nearness"}) {}

  Walk tell() {
    using namespace point_point;
    script_.value("tolerance", s_.tested_within, "", Role::first);
    add("tolerance", "How near is near?", 3,
        "**q** is near **p** if it lies in the ball around **p** whose radius is the tolerance.\n"
        "The caller chooses the tolerance. *d* is the distance of the two points.",
        {});
    const Point<C, 3> p = s_.tp.cast<C>(), q = s_.tq.cast<C>();
    const C t(s_.tested_within);
    by([&](auto& r) { near_by_squares(p, q, t, r); }, 0, "By squares", "*d*^2", "tolerance^2");
    by([&](auto& r) { near_by_distance(p, q, t, r); }, 1, "By the distance", "*d*", "tolerance");
    by([&](auto& r) { near_by_coordinates(p, q, t, r); }, 2, "By coordinates", "largest |*p*_i − *q*_i|", "tolerance");
    if (!s_.is_nan) spacing();
    end();
    return std::move(script_.walk());
  }

 private:
  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption,
            const std::optional<int>& method, const std::string& formula = {}) {
    Step& step = script_.add(slug, title, line, caption, formula);
    step.scene = picture(method);
    return step;
  }

  template <class Run>
  void by(const Run& run, int method, const std::string& title, const std::string& name, const std::string& limit) {
    CountingRecord<point_point::MethodEvent<C>> record;
    tally() = {};
    run(record);
    const Tally now = tally();
    done_ = {done_.mul + now.mul, done_.add + now.add, done_.div + now.div, done_.sqrt + now.sqrt,
             done_.compare + now.compare};
    script_.count(done_);
    double left = 0, right = 0;
    for (const auto& [event, _] : record.events) {
      const auto& e = std::get<point_point::Compared<C>>(event);
      if (!(e.distance.value <= left)) left = e.distance.value;
      right = e.tolerance.value;
    }
    const Said& s = said_[static_cast<std::size_t>(method) + 1];
    script_.value(name, left, "", s.near == said_[0].near ? Role::muted : Role::miss);
    Step& step = add(s.slug, title, method, caption(method, s.near, left, right), method,
                     name + " = " + shown(left) + (s.near ? " ≤ " : " > ") + shown(right) + " = " + limit);
    if (std::isnan(left)) step.formula = name + " is not a number: no comparison holds";
    step.decides = true;
    if (std::isfinite(left) && std::isfinite(right) && left + right > 0)
      step.comparison = Comparison{name + " ≤ " + limit, left, right, s.near, "this test says " + word(s.near)};
    if (method == 0) {
      const auto says_near = std::ranges::count_if(said_, [](const Said& x) { return x.near; });
      step.question =
          which_count("Four methods, the exact one included. How many say NEAR?", static_cast<double>(says_near),
                      {{0, "At least one of them accepts it."},
                       {1, says_near == 0 ? "None of them accepts it." : "More than one of them accepts it."},
                       {4, "At least one of them rejects it."}},
                      says_near == 4 ? "All accept it: no rounding, and no corner of the cube, tells them apart here."
                      : says_near == 0 && s_.is_nan ? "All reject it: a comparison with what is not a number fails."
                      : says_near == 0 ? "All reject it: it lies outside the cube, and so outside the ball."
                                       : why_they_part());
    }
  }

  /// Why methods are wrong: the first two only by rounding, the third only as it tests a cube.
  std::string why_they_part() const {
    const auto wrong = [&](std::size_t method) { return said_[method].near != said_[0].near; };
    std::string reasons;
    if (wrong(1) || wrong(2))
      reasons = s_.extreme() ? "A square leaves the range of doubles."
                             : "The two sides differ in the last bits only, which rounding loses.";
    if (wrong(3)) reasons += std::string(reasons.empty() ? "" : " ") + "**q** lies in the cube, but not in the ball.";
    return reasons;
  }

  /// `left` and `right`: the two sides as computed.
  std::string caption(int method, bool near, double left, double right) const {
    const bool right_answer = near == said_[0].near;
    const std::string verdict =
        right_answer ? "Here it is right."
                     : (method == 2 ? "For the ball" : "Here") + (" it says " + word(near) + ", and is wrong.");
    if (s_.is_nan) return "Every comparison with such a value fails, so the answer is FAR. " + verdict;
    return what_happens(method, right_answer, left, right) + "\n" + verdict;
  }

  std::string what_happens(int method, bool right_answer, double left, double right) const {
    if (method == 2 && s_.tested_within == 0) return "With tolerance 0 the cube is one point, as the ball is.";
    if (method == 2)
      return "This test is exact for a cube (the maximum norm). Its corners are √3 times the tolerance away.";
    const bool apart = s_.tp != s_.tq;
    if (std::isinf(left) && std::isinf(right))
      return "Both squares overflow, and ∞ ≤ ∞ holds however far apart the points are.";
    if (std::isinf(left))
      return method == 0 ? "The squared distance overflows: it is infinite."
                         : "The square under the root has overflowed, so the distance is infinite.";
    if (method == 0 && left == 0 && right == 0 && apart && s_.tested_within > 0)
      return "Both squares underflow to 0, and 0 ≤ 0 holds. It holds for all points so close that *d*^2 underflows.";
    if (left == 0 && apart)
      return method == 0 ? "The squared distance underflows to 0: it is too small for a double."
                         : "The square under the root has underflowed to 0, so the distance is 0.";
    if (!right_answer)
      return left == right ? "The two sides differ in the last bits only. Rounded, they come out equal."
                           : "The two sides differ in the last bits only. Rounding has changed their order.";
    return method == 0 ? "Neither side is negative, so their squares compare alike. No square root is needed."
                       : "One square root more, and no better: the sum under it has been rounded before.";
  }

  /// How fine a tolerance can be, where the largest coordinate is as large as it is.
  void spacing() {
    const double largest = std::max(s_.tp.cwiseAbs().maxCoeff(), s_.tq.cwiseAbs().maxCoeff());
    const double infinity = std::numeric_limits<double>::infinity();
    const double above = std::nextafter(largest, infinity) - largest,
                 below = largest - std::nextafter(largest, -infinity);
    const bool power_of_two = below < above;
    add("spacing", "How small may a tolerance be?", -1,
        std::string("No other double is nearer to the largest coordinate than this. On that axis, any smaller "
                    "tolerance means equality.\n") +
            (power_of_two ? "It is a power of two: above it, doubles lie twice as far apart. " : "") +
            "Near 10^6 doubles are 1.2 · 10^{−10} apart, and floats 0.06. So scale the tolerance with the coordinates.",
        {},
        power_of_two ? fmt::format("next double before {}: − {}", shown(largest), shown(below))
                     : fmt::format("next double after {}: + {}", shown(largest), shown(above)));
  }

  void end() {
    const bool near = said_[0].near;
    script_.settle(near ? Verdict::Kind::yes : Verdict::Kind::no, word(near));
    const auto wrong = std::ranges::count_if(said_, [&](const Said& s) { return s.near != near; });
    const char* const counts[] = {"All four methods agree here.", "One of the other three methods is wrong here.",
                                  "Two of the other three methods are wrong here.",
                                  "All three other methods are wrong here."};
    std::string text = counts[wrong];
    if (s_.is_nan)
      text += " A point with such a coordinate is near to none.";
    else if (s_.extreme())
      text += " Where squares leave the range, the exact test takes wider numbers.";
    else if (on_sphere())
      text += s_.tested_within > 0 ? " **q** lies on the sphere. The ball is closed, so it counts as near."
                                   : " **q** equals **p**, and with tolerance 0 near means equal.";
    text += s_.is_nan ? "\nThe exact test takes the sign of |**p** − **q**|^2 − tolerance^2. Here that is not a number "
                        "and has no sign."
                      : "\nThe exact test takes the sign of |**p** − **q**|^2 − tolerance^2, without rounding: it is "
                        "an exact predicate.";
    Step& step = add("verdict", "The exact answer", 4, text, {});
    step.decides = true;
  }

  bool on_sphere() const {
    Record<point_point::Event<double>> record;
    nearly_equal(s_.tp, s_.tq, s_.tested_within, record);
    const auto zero = [](const auto& event) {
      const auto* e = std::get_if<point_point::Distance>(&event);
      return e != nullptr && e->sign == 0;
    };
    return std::ranges::any_of(record.events, zero);
  }

  Scene picture(const std::optional<int>& method) {
    Scene scene;
    if (method == 2)
      scene.items.emplace_back(
          solid(Aabb<double, 3>{s_.p - Vec3::Constant(s_.tolerance), s_.p + Vec3::Constant(s_.tolerance)},
                Role::construction));
    add_tolerance(scene, s_, s_.p, 1.5);  // above the cube, too
    const bool open = !method && script_.walk().steps.size() == 1;
    const bool near = said_[method ? static_cast<std::size_t>(*method) + 1 : 0].near;
    scene.items.emplace_back(Line{s_.p, s_.q,
                                  open   ? Role::construction
                                  : near ? Role::hit
                                         : Role::miss,
                                  open ? Pen::construction : Pen::thick});
    add_point(scene, "p", s_.p, "**p**", Role::first);
    add_point(scene, "q", s_.q, s_.is_nan ? "**q**, *z* = NaN" : "**q**", Role::second,
              s_.is_nan ? Mark::excluded : Mark::disc);
    if (s_.extreme() && (s_.p - s_.q).norm() > 0)
      add_range(scene, std::log2((s_.p - s_.q).norm()) + std::log2(s_.unit), method && *method < 2);
    return scene;
  }

  const Setup& s_;
  const std::vector<Said> said_;
  Script script_;
  Tally done_ = {};
};

}  // namespace

Walk nearness(const Setup& setup) { return Nearness(setup).tell(); }

}  // namespace isect::lessons::points_lesson
