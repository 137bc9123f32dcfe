// Exact equality: one comparison a coordinate.

#include <cmath>

#include <isect/point_point.h>
#include "lessons/points/picture.h"
#include "lessons/shared/axis_names.h"
#include "lessons/shared/digits.h"
#include "lessons/shared/questions.h"
#include "lessons/shared/script.h"

namespace isect::lessons::points_lesson {

using namespace viz;

namespace {

using C = Counted<double>;

const std::vector<std::string> pseudocode = {
    "for each axis i of x, y, z",  // 0
    "    if p_i ≠ q_i",            // 1
    "        return DIFFERENT",    // 2
    "return EQUAL"                 // 3
};

/// Ten times 0.1, each sum rounded.
double ten_steps() {
  double sum = 0;
  for (int i = 0; i < 10; ++i) sum += 0.1;
  return sum;
}

class Equality {
 public:
  explicit Equality(const Setup& setup)
      : s_(setup),
        truth_(equal(setup.tp, setup.tq)),
        script_({"Lecture note Intersection Detection, points",
                 std::string("Two points in space, p and q, with their coordinates marked on three axes: ") +
                     (truth_ ? "equal." : "different."),
                 pseudocode, "equality"}) {}

  Walk tell() {
    add("points", "Three numbers each", 0,
        "Marks on the axes show the coordinates: discs for **p**, rings for **q**.\n"
        "A disc in a ring: here the eye sees no difference.",
        -1);
    script_.tell<point_point::Event<C>>(
        [&](auto& record) { equal(Point<C, 3>(s_.tp.cast<C>()), Point<C, 3>(s_.tq.cast<C>()), record); },
        [&](const auto& event) { say(event); });
    end();
    return std::move(script_.walk());
  }

 private:
  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption, int axis,
            const std::string& formula = {}) {
    Step& step = script_.add(slug, title, line, caption, formula);
    step.scene = picture(axis);
    return step;
  }

  void say(const point_point::Coordinate<C>& e) {
    const double a = e.p.value, b = e.q.value;
    const std::string axis = axis_names[e.axis], i = std::string("_{") + "xyz"[e.axis] + "}";
    script_.value("*p*" + i, a, "", Role::first);
    script_.value("*q*" + i, b, "", Role::second);
    told_ = e.axis + 1;
    Step& step = add(
        std::string("axis-") + "xyz"[e.axis], "Equal on " + axis + "?", 1, caption(a, b, e.axis), e.axis,
        "*p*" + i + " = " + digits(a, b) +
            (std::isnan(b) ? " ≠ *q*" + i + ", no number" : (e.equal ? " = " : " ≠ ") + digits(b, a) + " = *q*" + i));
    step.decides = !e.equal || e.axis == 2;  // the line would say yes otherwise: an equal coordinate settles nothing
    // EQUAL too early: that one equal coordinate is enough. DIFFERENT: that 0 and −0 are different numbers.
    step.question = Question{
        fmt::format("The coordinates on {} are compared: *p*{} = {}{}. What follows?", axis, i, digits(a, b),
                    std::isnan(b) ? ", and *q*" + i + " is not a number" : " and *q*" + i + " = " + digits(b, a)),
        {"DIFFERENT", "EQUAL", "nothing yet"},
        !e.equal     ? 0
        : e.axis < 2 ? 2
                     : 1,
        std::isnan(a) || std::isnan(b) ? "What is not a number is unequal to every number, and to itself."
        : e.equal ? "The coordinates are equal by value. Only after all three may EQUAL be returned."
                  : "The coordinates differ by value, however little."};
    stopped_ = !e.equal;
  }
  void say(const point_point::Distance&) {}  // of nearly_equal
  void say(const Fallback&) {}

  static std::string caption(double a, double b, int axis) {
    if (std::isnan(b))
      return "The third coordinate of **q** is not a number. Such a value equals nothing, not even itself.";
    if (a == b && std::signbit(a) != std::signbit(b))
      return "0 and −0 are stored differently, yet they are one number. Comparison is by value, not by bits.";
    if (a == b) return axis < 2 ? "The same number. The points may still differ on the next axis." : "The same number.";
    if (a == 1 && b == ten_steps()) return "**q** was computed: ten steps of 0.1, each sum rounded, do not give 1.";
    return axis < 2 ? "Different: one coordinate is enough. The later axes need not be tested."
                    : "Different on the last axis. One coordinate is enough.";
  }

  void end() {
    if (!stopped_) script_.refuse(1, {2});
    if (stopped_) script_.leave_early();
    script_.settle(truth_ ? Verdict::Kind::yes : Verdict::Kind::no, truth_ ? "EQUAL" : "DIFFERENT");
    add("verdict", truth_ ? "The same point" : "Different points", stopped_ ? 2 : 3, end_caption(), -1);
  }

  std::string end_caption() const {
    if (truth_)
      return "Exact equality is right where numbers are copied: a vertex that two triangles share, a key in a list.\n"
             "It is transitive: equal points can be sorted, counted and merged.";
    if (s_.is_nan)
      return "A point with such a coordinate equals no point. No search finds it.\n"
             "So refuse such input where it comes in: it is the one kind of value for which *x* ≠ *x*.";
    if (s_.tp.x() == 1 && s_.tq.x() == ten_steps())
      return "The test is right: these are two points. The error was made before, when **q** was computed.\n"
             "For computed numbers, the caller chooses a tolerance.";
    return "The answer is exact, as only given numbers are compared.";
  }

  Scene picture(int axis) const {
    Scene scene;
    const Vec3 corner(0, 0, 0);  // the axes meet where all coordinates are 0
    for (int i = 0; i < 3; ++i) {
      Vec3 start = corner, end = corner;
      start[i] -= 1, end[i] += 1.875;
      const bool here = i == axis;
      scene.items.emplace_back(Arrow{start, end, here ? Role::text : Role::muted, here ? Pen::solid : Pen::hairline});
      end[i] += 0.18;
      scene.items.emplace_back(viz::Heading{end, axis_names[i], here ? Role::text : Role::muted, 0, here});
    }
    for (int i = 0; i < 3; ++i) {
      if (axis >= 0 && i != axis) continue;
      const auto foot = [&](const Vec3& at) {
        Vec3 on_axis = corner;
        on_axis[i] = at[i];
        if (axis >= 0) scene.items.emplace_back(Line{at, on_axis, Role::construction, Pen::construction});
        return on_axis;
      };
      const Vec3 of_p = foot(s_.p), of_q = s_.is_nan && i == 2 ? of_p : foot(s_.q);
      const bool alike = !(s_.is_nan && i == 2) && std::abs(of_p[i] - of_q[i]) < 1e-9;
      if (alike) {
        scene.items.emplace_back(Dot{of_p, Mark::double_disc,
                                     i >= told_             ? Role::text
                                     : s_.tp[i] == s_.tq[i] ? Role::hit
                                                            : Role::miss});
      } else {
        scene.items.emplace_back(Dot{of_p, Mark::disc, Role::first});
        if (of_q != of_p) scene.items.emplace_back(Dot{of_q, Mark::ring, Role::second});
      }
    }
    const bool same = s_.p == s_.q && !s_.is_nan;
    if (same) {
      const Role role = told_ == 3 ? Role::hit : Role::text;
      scene.items.emplace_back(Dot{s_.p, Mark::double_disc, role});
      scene.items.emplace_back(Label{s_.p, told_ == 3 ? "**p** = **q**" : "**p**, **q**", role});
      scene.handles.push_back({"p", Handle::Kind::point, s_.p, Vec3::Zero(), Role::first});
      scene.handles.push_back({"q", Handle::Kind::point, s_.q, Vec3::Zero(), Role::second});
    } else {
      add_point(scene, "p", s_.p, "**p**", Role::first);
      add_point(scene, "q", s_.q, s_.is_nan ? "**q**, *z* = NaN" : "**q**", Role::second,
                s_.is_nan ? Mark::excluded : Mark::ring);
    }
    return scene;
  }

  const Setup& s_;
  const bool truth_;
  Script script_;
  bool stopped_ = false;
  int told_ = 0;  ///< axes compared so far
};

}  // namespace

Walk equality(const Setup& setup) { return Equality(setup).tell(); }

}  // namespace isect::lessons::points_lesson
