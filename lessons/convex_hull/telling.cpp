#include <fmt/format.h>

#include <algorithm>

#include <isect/convex_hull.h>
#include "lessons/convex_hull/picture.h"
#include "lessons/shared/digits.h"
#include "lessons/shared/flat.h"
#include "lessons/shared/line_question.h"
#include "lessons/shared/plural.h"
#include "lessons/shared/questions.h"
#include "lessons/shared/script.h"

namespace isect::lessons::convex_hull_lesson {

using namespace viz;
using Removed = convex_hull_2d::Removed<double>;
using Added = convex_hull_2d::Added<double>;

namespace {

const char* const what_a_turn_is =
    "\nThe turn is the sign of an area, of the triangle of the last two points and **q**: their orientation.";

class Teller {
 public:
  explicit Teller(const Ring<double, 2>& points)
      : points_(points),
        hull_(isect::convex_hull(points)),
        script_({"Lecture note, bounding volumes; Andrew, Information Processing Letters 9 (1979)",
                 fmt::format("{} points and their convex hull of {}.", points.size(), vertices()),
                 {"sort the points by x, then y; for each q, there and back:",       // 0
                  "    while the chain makes no left turn towards q: drop its end",  // 1
                  "    append q to the chain",                                       // 2
                  "hull ← lower chain + upper chain, each without its last point"},  // 3
                 "monotone chain"}) {
    drawn_.points = points;
  }

  Walk tell() {
    script_.value("points", static_cast<double>(points_.size()));
    Ring<double, 2> different = points_;
    std::ranges::sort(different, before<double>);
    different.erase(std::unique(different.begin(), different.end()), different.end());
    const bool twice = different.size() < points_.size();
    if (twice) script_.value("different points", static_cast<double>(different.size()));
    const std::string kept = twice ? fmt::format("Equal points are kept once: {} {} left.\n", different.size(),
                                                 different.size() == 1 ? "is" : "are")
                                   : std::string();
    add("points", "Points", 0,
        kept +
            "Think of a rubber band around nails. Sorting by *x*, then *y*, dominates the time: O(*n* lg *n*).\n"
            "The scan is linear: a chain takes each point once, and drops it at most once. **q** is the next point.");
    Record<convex_hull_2d::Event<double>> record;
    isect::convex_hull(points_, record);
    for (const auto& event : record.events) {
      if (const Removed* e = std::get_if<Removed>(&event)) removed_.push_back(*e);
      if (const Added* e = std::get_if<Added>(&event)) say(*e);
    }
    hull();
    for (const Bounding what : {Bounding::ball, Bounding::aabb, Bounding::obb}) against(what);
    return std::move(script_.walk());
  }

 private:
  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption,
            const std::string& formula = {}) {
    Step& step = script_.add(slug, title, line, caption, formula);
    step.scene = picture(drawn_);
    return step;
  }

  /// The last points of the chain, as many as may matter.
  std::string end_of_chain() const {
    constexpr std::size_t enough = 5;
    const std::size_t n = drawn_.chain.size(), first = n > enough ? n - enough : 0;
    std::string all;
    for (std::size_t i = first; i < n; ++i) all += (i > first ? ", " : "") + coordinates(drawn_.chain[i]);
    return fmt::format("The chain {} {}.", first > 0 ? "ends with" : "is", all);
  }

  /// A point joins a chain, and those in `removed_` leave it.
  void say(const Added& e) {
    if (drawn_.chain.empty()) drawn_.upper = started_++ > 0;
    const std::string chain = end_of_chain();
    for (const Removed& r : removed_) {
      drawn_.removed.push_back(r.p);
      drawn_.chain.pop_back();
    }
    drawn_.chain.push_back(e.p);
    const bool none = removed_.empty(), turns = drawn_.chain.size() + removed_.size() > 2;
    script_.value("chain", static_cast<double>(drawn_.chain.size()));
    Step& step = add(fmt::format("{}-{}", drawn_.upper ? "upper" : "lower", ++number_), title(e.p), none ? 2 : 1,
                     caption() + (turns && !turned_ ? what_a_turn_is : ""));
    turned_ = turned_ || turns;
    step.decides = !none;
    if (!none && asked_ < removed_.size()) {
      asked_ = removed_.size();
      const auto all = static_cast<double>(drawn_.chain.size() + removed_.size() - 1);
      step.question =
          which_count(fmt::format("{} Next is **q** = {}. How many points leave the chain?", chain, coordinates(e.p)),
                      static_cast<double>(removed_.size()),
                      {{0, "That keeps every point. The last one makes no left turn towards **q**."},
                       {1, "That drops one point and stops. The one before it makes no left turn either."},
                       {all, "That drops the whole chain."}},
                      "Each point at which the chain makes no left turn towards **q** is dropped.");
      step.question->over = pointing_at(e.p);
      give_before(script_.walk(), {"chain"});
    } else if (turns && !line_asked_) {
      ask_line(chain, e.p, none);
    }
    drawn_.removed.clear(), removed_.clear();
    const auto last = std::minmax_element(points_.begin(), points_.end(), before<double>);
    if (e.p == (drawn_.upper ? *last.first : *last.second) && drawn_.chain.size() > 1) {
      drawn_.done.push_back(std::exchange(drawn_.chain, {}));
      number_ = 0;
    }
  }

  /// Asks what happens to the chain at its first turn.
  void ask_line(const std::string& chain, const Point<double, 2>& q, bool left) {
    line_asked_ = true;
    ask_for_line(script_.walk(),
                 fmt::format("{} Next is **q** = {}. Which line changes the chain first?", chain, coordinates(q)),
                 {{0, "The points have been sorted before, and that changes no chain."},
                  {1, "The chain makes a left turn towards **q**, so its end stays."},
                  {2, "The chain makes no left turn towards **q**, so its end is dropped before."},
                  {3, "The chains are joined at the end, once both are done."}},
                 left ? "The chain makes a left turn towards **q**: no point is dropped."
                      : "The chain makes no left turn towards **q**: its end is dropped.");
    script_.walk().steps.back().question->over = pointing_at(q);
    give_before(script_.walk(), {"chain"});
  }

  /// The picture before the last step, in which **q** is this point.
  Scene pointing_at(const Point<double, 2>& p) {
    const std::vector<Step>& steps = script_.walk().steps;
    Scene scene = steps[steps.size() - 2].scene;
    std::erase_if(scene.items, [](const Item& item) {
      const Label* label = std::get_if<Label>(&item);
      const Line* line = std::get_if<Line>(&item);
      return (label && label->text.starts_with("**q**")) || (line && line->pen == Pen::highlight);
    });
    scene.items.emplace_back(Dot{flat(p), Mark::disc, Role::first});
    scene.items.emplace_back(Label{flat(p), "**q**", Role::first});
    return scene;
  }

  /// "(2, −1.25): drop one, then append"
  std::string title(const Point<double, 2>& q) const {
    const std::size_t points = drawn_.chain.size();
    const std::string done = removed_.size() == 1 ? "drop one, then append"
                             : !removed_.empty()  ? fmt::format("drop {}, then append", removed_.size())
                             : points == 1        ? (drawn_.upper ? "the upper chain begins" : "the lower chain begins")
                             : points == 2        ? "no turn yet, append"
                                                  : "a left turn, append";
    return fmt::format("({}, {}): {}", shown(q.x()), shown(q.y()), done);
  }

  std::string caption() const {
    if (removed_.empty())
      return drawn_.chain.size() == 1
                 ? "The chain begins with the first point in this order, which is a vertex for certain."
             : drawn_.chain.size() == 2 ? "A chain of one point makes no turn yet: **q** joins it."
                                        : "The chain turns left on its way to **q**: **q** joins it.";
    const char* const chain = drawn_.upper ? "upper" : "lower";
    const auto straight = std::ranges::count(removed_, 0, &Removed::turn);
    const auto right = static_cast<std::ptrdiff_t>(removed_.size()) - straight;
    std::string told;
    if (right > 0)
      told = fmt::format(
          "Towards **q** the chain would turn right at {}: {} not on the {} chain.{}",
          right == 1 ? "its last point" : fmt::format("{} of its points", right), right == 1 ? "it is" : "they are",
          chain, drawn_.upper ? "" : " The upper chain may still take " + std::string(right == 1 ? "it." : "them."));
    if (straight > 0)
      told += fmt::format("{}At {} it runs straight on: {} within an edge, so {} no vertex.", right > 0 ? "\n" : "",
                          straight == 1 ? "one point" : fmt::format("{} points", straight),
                          straight == 1 ? "that point lies" : "these points lie", straight == 1 ? "it is" : "they are");
    return told;
  }

  void hull() {
    drawn_.chain.clear(), drawn_.done.clear();
    drawn_.hull = hull_;
    area_ = area(hull_);
    script_.value("vertices", static_cast<double>(hull_.size()));
    script_.value("hull", area_, "area", Role::hit);
    script_.settle(Verdict::Kind::yes, "a hull of " + vertices());
    add("hull", "The hull", 3,
        std::string("Every convex set that contains the points contains each segment between them, and so the hull.") +
            (hull_.size() == 1   ? " Here it is a point, of area 0.\n"
             : hull_.size() == 2 ? " Here it is a segment, of area 0.\n"
                                 : "\n") +
            "The note defines it for point sets and polygonal objects only. Every set has a convex hull.");
  }

  void against(Bounding what) {
    drawn_.bounding = what;
    const Measured m = measured(points_, what);
    const bool same = m.area - area_ <= 1e-12 * m.area;  // the areas are rounded
    const double empty = same ? 0 : m.area - area_;
    script_.value(m.name, m.area, "area", Role::second);
    Step& step = add(
        m.slug, std::string("Against the ") + m.name, -1,
        fmt::format("The {} is kept in {} numbers, the hull in {}.\n", m.name, m.numbers, 2 * hull_.size()) +
            (same ? "Both have the same area, so it leaves no void beyond the hull."
             : m.numbers < 2 * hull_.size()
                 ? "Its area outside the hull is void, the hull taken as the object: the price of fewer numbers and a "
                   "simpler test."
                 : "Its area outside the hull is void, the hull taken as the object: the price of a simpler test.") +
            (what == Bounding::obb && area_ > 0
                 ? "\nOne of its sides lies along an edge of the hull; rotating calipers find it in O(*n*)."
                 : ""),
        area_ > 0 ? fmt::format("void = {} = {} × the hull", shown(empty), shown(empty / area_)) : "");
    step.question =
        Question{fmt::format("How large is the {}, compared with the hull?", m.name),
                 {"just as large", "up to twice as large", "more than twice as large"},
                 same                  ? 0
                 : m.area <= 2 * area_ ? 1
                                       : 2,
                 same        ? "It contains the hull, and leaves no void beside it."
                 : area_ > 0 ? fmt::format("It contains the hull, and is {} times as large.", shown(m.area / area_))
                             : "It contains the hull, which has no area here."};
    if (what == Bounding::ball) {  // offered once: a set that contains the hull is never smaller
      step.question->choices.insert(step.question->choices.begin(), "smaller");
      ++step.question->answer;
    }
  }

  std::string vertices() const { return plural(static_cast<long long>(hull_.size()), "vertex"); }

  const Ring<double, 2>& points_;
  const Ring<double, 2> hull_;
  Script script_;
  Drawn drawn_;
  std::vector<Removed> removed_;
  double area_ = 0;
  int number_ = 0, started_ = 0;
  bool turned_ = false, line_asked_ = false;  ///< a turn was told, or asked for, already
  std::size_t asked_ = 0;                     ///< the most removed points that were asked for
};

}  // namespace

Walk tell(const Ring<double, 2>& points) { return Teller(points).tell(); }

}  // namespace isect::lessons::convex_hull_lesson
