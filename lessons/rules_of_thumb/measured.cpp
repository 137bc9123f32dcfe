// Rule 7: time and profile. Operations are counted here, times are those of bench/results.json.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <isect/methods/sphere_aabb.h>
#include "bench/ordinary_shapes.h"
#include "bench/prose.h"
#include "bench/rows.h"
#include "lessons/rules_of_thumb/experiment.h"
#include "lessons/shared/order_question.h"
#include "lessons/shared/script.h"
#include "lessons/speed_against_error/results.h"
#include "viz/chart/chart.h"

namespace isect::lessons::rules_of_thumb_lesson {

using namespace viz;

namespace {

using C = Counted<double>;

struct Method {
  std::string name;
  double operations, ns;
};

/// The methods with their operations per call, averaged over ordinary cases like those that were timed.
std::vector<Method> methods() {
  bool (*const all_of_them[])(const Sphere<C, 3>&, const Aabb<C, 3>&) = {
      [](const Sphere<C, 3>& a, const Aabb<C, 3>& b) { return sphere_aabb::accumulate_naive(a, b); },
      [](const Sphere<C, 3>& a, const Aabb<C, 3>& b) { return sphere_aabb::with_rejections(a, b); },
      [](const Sphere<C, 3>& a, const Aabb<C, 3>& b) { return sphere_aabb::clamped(a, b); }};
  const char* const names[] = {"if, else (<)", "rejections", "clamp"};
  std::vector<Method> all;
  for (std::size_t m = 0; m < 3; ++m) {
    bench::Random random(1);
    int sum = 0;
    constexpr int many = 1000;
    for (int k = 0; k < many; ++k) {
      const Sphere<C, 3> sphere = isect::cast<C>(bench::ordinary_sphere<double>(random));
      const Aabb<C, 3> box = isect::cast<C>(bench::ordinary_box<double>(random));
      sum += total(counted([&] { all_of_them[m](sphere, box); }));
    }
    Method method = {names[m], static_cast<double>(sum) / many, 0};
    for (const bench::Row* r :
         bench::rows_of(speed_against_error_lesson::results(), "sphere-aabb", "double", "ordinary"))
      if (r->library == "isect" && r->method == names[m]) method.ns = r->ns;
    all.push_back(method);
  }
  return all;
}

class Measuring {
 public:
  Measuring()
      : methods_(methods()),
        script_({source(),
                 "Bars of counted operations and of measured times of three methods for ball and box.",
                 {"count the operations of each method", "time each method on the same cases",
                  "compare: which counts foretell the times?", "time on your own cases, too"},
                 "7: time and profile"}) {}

  Walk tell() {
    for (const Method& m : methods_) script_.value(m.name + ", operations", m.operations, "operations");
    show("rule", "What the counts promise", 0,
         "Operations of three methods for ball and box, as shares of the first. Fewer operations promise "
         "less time.",
         bars(false));
    for (const Method& m : methods_) script_.value(m.name + ", time", m.ns, "ns", Role::first);
    Step& step =
        show("before", "What the clock says", 1,
             fmt::format("Times as measured on {}, as shares of the first.\nThere the same loop takes up to {} longer "
                         "than its least.",
                         speed_against_error_lesson::results().machine.cpu,
                         bench::share(speed_against_error_lesson::results().machine.noise, 1)),
             bars(true));
    step.question = question();
    show("how", "Counts are not times", 2, farthest(), bars(true));
    families();
    return std::move(script_.walk());
  }

 private:
  static std::string source() {
    const bench::Machine& m = speed_against_error_lesson::results().machine;
    return fmt::format("Lecture note, rules of thumb (7); measured on {}, {}, {}, {}", m.cpu, m.compiler, m.flags,
                       m.date);
  }

  Step& show(const std::string& slug, const std::string& title, int line, const std::string& caption, Bars chart) {
    Step& step = script_.add(slug, title, line, caption);
    step.scene.chart = std::make_shared<const Chart>(Chart{std::move(chart)});
    return step;
  }

  static std::string percent(double share) { return shown(std::round(100 * share)); }
  double operations(const Method& m) const { return m.operations / methods_.front().operations; }
  double time(const Method& m) const { return m.ns / methods_.front().ns; }

  Bars bars(bool times) const {
    Bars all = {
        {Scale::Kind::linear, 0, 1.25, "share of the first method"}, {{"operations", Glyph::disc, Role::second}}, {}};
    if (times) all.series.push_back({"time", Glyph::star, Role::first});
    for (const Method& m : methods_) {
      Bar bar = {m.name, {{0, operations(m)}}};
      bar.text = fmt::format("{:.1f} operations", m.operations);
      if (times) bar.dots.emplace_back(1, time(m)), bar.text = fmt::format("{} ns", shown(m.ns));
      for (const auto& [_, x] : bar.dots) all.x.hi = std::max(all.x.hi, 1.1 * x);
      all.bars.push_back(bar);
    }
    return all;
  }

  /// Whether two times differ by more than the noise of the machine that took them.
  static bool differ(double a, double b) {
    return std::max(a, b) / std::min(a, b) > 1 + speed_against_error_lesson::results().machine.noise;
  }

  /// Asks for the order of the methods by time; those that differ by no more than the noise come in any order.
  std::optional<Question> question() const {
    std::vector<Method> sorted = methods_;
    std::ranges::sort(sorted, {}, &Method::ns);
    std::vector<InOrder> things;
    std::vector<double> counts;
    double place = 0;
    std::string times;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      if (i > 0 && differ(sorted[i - 1].ns, sorted[i].ns)) ++place;
      things.push_back({sorted[i].name, place});
      counts.push_back(sorted[i].operations);
      times += fmt::format("{}{} ns", i == 0 ? "" : i + 1 < sorted.size() ? ", " : " and ", shown(sorted[i].ns));
    }
    return which_order(
        "Sort these methods by the time measured on ordinary cases, from less to more. Times that differ "
        "by less than the noise count as equal.",
        things, {{counts, "That is the order of their operations."}}, fmt::format("The times are {}.", times));
  }

  /// A sentence on the method whose time differs most from its predicted time, and on the tweak that the note warns of.
  std::string farthest() const {
    const auto off = [&](const Method& m) { return std::abs(std::log(time(m) / operations(m))); };
    const Method& m = *std::ranges::max_element(methods_, {}, off);
    std::string told = "Within the noise the counts predict these times.";
    if (differ(time(m), operations(m)))
      told = fmt::format("Predicted worst is {}: {} % of the operations, but {} % of the time.", m.name,
                         percent(operations(m)), percent(time(m)));
    if (differ(time(m), operations(m)) && m.name == "clamp")
      told += " It has no branch that a processor could guess wrongly.";
    return told + half_b();
  }

  static std::string half_b() {
    const bench::Row *quadratic = nullptr, *half = nullptr;
    for (const bench::Row* r :
         bench::rows_of(speed_against_error_lesson::results(), "ray-sphere", "double", "ordinary")) {
      if (r->library == "isect" && r->method == "quadratic") quadratic = r;
      if (r->library == "isect" && r->method == "half-B") half = r;
    }
    if (quadratic == nullptr || half == nullptr) return "";
    return fmt::format("\nThe note warns of tweaks such as half-B for rays: {} ns against {} ns{}.", shown(half->ns),
                       shown(quadratic->ns), differ(half->ns, quadratic->ns) ? "" : ", no difference beyond the noise");
  }

  /// Adds the step that times the same call on other families of cases.
  void families() {
    const auto rows = bench::rows_of(speed_against_error_lesson::results(), "sphere-aabb", "double");
    Bars all = {{Scale::Kind::log, 1, 50, "time per call (ns), " + speed_against_error_lesson::results().machine.cpu},
                {{methods_.back().name, Glyph::disc, Role::second}, {"exact", Glyph::star, Role::hit}},
                {}};
    double least = INFINITY, most = 0;
    for (const std::string& family : bench::families_of(rows)) {
      Bar bar = {bench::words(family), {}};
      for (const bench::Row* r : rows) {
        if (r->family != family || r->library != "isect") continue;
        if (r->method == methods_.back().name) bar.dots.emplace_back(0, r->ns);
        if (r->exact) bar.dots.emplace_back(1, r->ns), least = std::min(least, r->ns), most = std::max(most, r->ns);
      }
      for (const auto& [_, ns] : bar.dots)
        all.x.lo = std::min(all.x.lo, ns / 1.3), all.x.hi = std::max(all.x.hi, 1.3 * ns);
      all.bars.push_back(bar);
    }
    script_.settle(Verdict::Kind::yes, "counts guide, the clock decides");
    show("after", "The cases matter", 3,
         fmt::format("The exact call takes {} to {} ns, by the family of cases. Time on cases like your own.",
                     shown(least), shown(most)),
         all)
        .decides = true;
  }

  const std::vector<Method> methods_;
  Script script_;
};

}  // namespace

Walk measure() { return Measuring().tell(); }

}  // namespace isect::lessons::rules_of_thumb_lesson
