// Nearness within a tolerance: three ways to write it against the exact one.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <isect/point_point.h>
#include <isect/point_point_methods.h>
#include "lessons/points/picture.h"
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
        script_({"Note, N11 (with a tolerance)",
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
        "**q** is near to **p** if it lies in the ball of this radius around **p**. Whoever asks must name "
        "the "
        "radius.",
        {});
    const Point<C, 3> p = s_.tp.cast<C>(), q = s_.tq.cast<C>();
    const C t(s_.tested_within);
    by([&](auto& r) { near_by_squares(p, q, t, r); }, 0, "By squares", "*d*^2", "tolerance^2");
    by([&](auto& r) { near_by_distance(p, q, t, r); }, 1, "By the distance", "*d*", "tolerance");
    by([&](auto& r) { near_by_coordinates(p, q, t, r); }, 2, "By coordinates", "largest |*p*_i − *q*_i|", "tolerance");
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
    Step& step = add(s.slug, title, method, caption(method, s.near), method,
                     name + " = " + shown(left) + (s.near ? " ≤ " : " > ") + shown(right) + " = " + limit);
    if (std::isnan(left)) step.formula = name + " = NaN: no comparison holds";
    step.decides = true;
    if (std::isfinite(left) && std::isfinite(right) && left + right > 0)
      step.comparison = Comparison{name + " ≤ " + limit, left, right, s.near, "says " + word(s.near)};
    if (method == 0)
      step.question = Question{"Is **q** near to **p**, truly?",
                               {"near", "far"},
                               said_[0].near ? 0 : 1,
                               "The exact sign of the difference of the squares tells."};
  }

  std::string caption(int method, bool near) const {
    const bool right = near == said_[0].near;
    const std::string verdict = right ? "Here it is right." : "Here it says " + word(near) + ", and is wrong.";
    if (s_.is_nan) return "NaN makes the comparison fail, so the answer is FAR. " + verdict;
    if (method == 0 && s_.unit > 1)
      return "The squares overflow: both sides are infinite, and ∞ ≤ ∞ holds for all points.\n" + verdict;
    if (method == 0 && s_.unit < 1)
      return "The squares vanish: both sides are 0, and 0 ≤ 0 holds for all points.\n" + verdict;
    if (method == 1 && s_.unit > 1)
      return "The square under the root has overflowed before, so the distance is infinite.\n" + verdict;
    if (method == 1 && s_.unit < 1)
      return "The square under the root has vanished before, so the distance is 0.\n" + verdict;
    if (!right && method < 2)
      return "The two sides differ in the last bits only. Rounded, they come in the wrong order.\n" + verdict;
    if (method == 0) return "Both sides are positive, so their squares compare alike. No root is needed.\n" + verdict;
    if (method == 1)
      return "One square root more, and no better: the sum under it has been rounded before.\n" + verdict;
    return "Axis by axis the points of a cube are near: at its corners up to √3 times the tolerance.\n" + verdict;
  }

  void end() {
    const bool near = said_[0].near;
    script_.settle(near ? Verdict::Kind::yes : Verdict::Kind::no, word(near));
    const auto wrong = std::ranges::count_if(said_, [&](const Said& s) { return s.near != near; });
    const char* const counts[] = {"All four methods agree here.", "One of the three rounded methods is wrong here.",
                                  "Two of the three rounded methods are wrong here.",
                                  "All three rounded methods are wrong here."};
    std::string text = counts[wrong];
    if (s_.is_nan)
      text += " A point with NaN is near to none.";
    else if (s_.extreme())
      text += " The exact test takes wider numbers where squares leave the range.";
    else if (on_sphere())
      text += " **q** lies on the sphere: the ball is closed, so it counts as near.";
    text += "\nWhoever asks chooses the tolerance. The exact test keeps to it, to the last bit.";
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
    add_tolerance(scene, s_, s_.p);
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
