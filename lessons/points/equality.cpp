// Exact equality: one comparison a coordinate.

#include <cmath>

#include <isect/point_point.h>
#include "lessons/points/picture.h"
#include "lessons/shared/axis_names.h"
#include "lessons/shared/digits.h"
#include "lessons/shared/script.h"

namespace isect::lessons::points_lesson {

using namespace viz;

namespace {

using C = Counted<double>;

class Equality {
 public:
  explicit Equality(const Setup& setup)
      : s_(setup),
        truth_(equal(setup.tp, setup.tq)),
        script_({"Note, N11",
                 std::string("Two points in space, p and q, with their coordinates marked on three axes: ") +
                     (truth_ ? "equal." : "different."),
                 {"for each axis i of x, y, z",  // 0
                  "    if p_i ≠ q_i",            // 1
                  "        return DIFFERENT",    // 2
                  "return EQUAL"},               // 3
                 "equality"}) {}

  Walk tell() {
    add("points", "Three numbers each", 0,
        "Points are equal if their coordinates are. Marks on the axes show them: discs for **p**, rings for "
        "**q**.\nA disc in a ring: they look alike.",
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
    Step& step = add(std::string("axis-") + "xyz"[e.axis], "Equal on " + axis + "?", 1, caption(a, b, e.axis), e.axis,
                     "*p*" + i + " = " + digits(a, b) + (e.equal ? " = " : " ≠ ") + digits(b, a) + " = *q*" + i);
    step.decides = true;
    step.question = Question{"Are the coordinates on " + axis + " equal?",
                             {"yes", "no"},
                             e.equal ? 0 : 1,
                             "Numbers are compared as they are stored, to the last bit."};
    stopped_ = !e.equal;
  }
  void say(const point_point::Distance&) {}  // of nearly_equal
  void say(const Fallback&) {}

  static std::string caption(double a, double b, int axis) {
    if (std::isnan(b)) return "NaN is no number and equal to none, not even to itself.";
    if (a == b && std::signbit(a) != std::signbit(b))
      return "0 and −0 are stored differently, but compare as equal: they are the same number.";
    if (a == b) return axis < 2 ? "The same number. The next axis may still tell them apart." : "The same number.";
    if (std::abs(a - b) < 1e-9)
      return "Ten steps of 0.1 do not add up to 1: each sum was rounded. The marks look alike, the numbers "
             "are not.";
    return "Different: one coordinate is enough, and the other axes need not be tested.";
  }

  void end() {
    if (!stopped_) script_.refuse(1, {2});
    if (stopped_) script_.leave_early();
    script_.settle(truth_ ? Verdict::Kind::yes : Verdict::Kind::no, truth_ ? "EQUAL" : "DIFFERENT");
    add("verdict", truth_ ? "The same point" : "Different points", stopped_ ? 2 : 3, end_caption(), -1);
  }

  std::string end_caption() const {
    if (truth_)
      return "Exact equality is right where numbers are copied: a vertex that two triangles share, a point "
             "in a "
             "list.\nIt is transitive: equal points can be sorted, counted and merged.";
    if (s_.is_nan) return "A point with NaN is equal to none. So it is found in no list, and near to nothing.";
    if ((s_.tp - s_.tq).norm() < 1e-9)
      return "The test is right: these are two points. The error was made before, when **q** was computed.\n"
             "Whoever expects a computed number must say how near is near enough.";
    return "The answer is exact, as only given numbers are compared.";
  }

  Scene picture(int axis) const {
    Scene scene;
    const Vec3 corner(-0.75, -0.75, -0.75);
    for (int i = 0; i < 3; ++i) {
      Vec3 end = corner;
      end[i] += 2.25;
      const bool here = i == axis;
      scene.items.emplace_back(Arrow{corner, end, here ? Role::text : Role::muted, here ? Pen::solid : Pen::hairline});
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
