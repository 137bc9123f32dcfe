#include <fmt/format.h>

#include <algorithm>

#include <isect/convex_hull.h>
#include "lessons/convex_hull/picture.h"
#include "lessons/shared/script.h"

namespace isect::lessons::convex_hull_lesson {

using namespace viz;
using Removed = convex_hull_2d::Removed<double>;
using Added = convex_hull_2d::Added<double>;

namespace {

class Teller {
 public:
  explicit Teller(const Ring<double, 2>& points)
      : points_(points),
        hull_(isect::convex_hull(points)),
        script_({"Note, N05; Andrew (1979)",
                 fmt::format("{} points and their convex hull of {} vertices.", points.size(), hull_.size()),
                 {"sort the points by x, then y",                                      // 0
                  "for each p, there and back: drop the chain's end if no left turn",  // 1
                  "    append p to the chain",                                         // 2
                  "hull ← lower chain + upper chain"},                                 // 3
                 "monotone chain"}) {
    drawn_.points = points;
  }

  Walk tell() {
    script_.value("points", static_cast<double>(points_.size()));
    add("points", "Points", 0,
        "The hull is the smallest convex set that holds them: a rubber band around nails.\n"
        "Sorting by *x*, then *y*, takes the time: O(*n* lg *n*). The rest is one pass each way.");
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

  /// One more point of a chain, with those that it removed.
  void say(const Added& e) {
    if (drawn_.chain.empty()) drawn_.upper = started_++ > 0;
    for (const Removed& r : removed_) {
      drawn_.removed.push_back(r.p);
      drawn_.chain.pop_back();
    }
    drawn_.chain.push_back(e.p);
    const bool none = removed_.empty(), straight = !none && removed_.back().turn == 0;
    script_.value("chain", static_cast<double>(drawn_.chain.size()));
    Step& step = add(fmt::format("{}-{}", drawn_.upper ? "upper" : "lower", ++number_),
                     none ? "A left turn: append" : "Not left: remove, then append", none ? 2 : 1,
                     none       ? "The chain turns left, or is too short to turn: the point joins it."
                     : straight ? "The chain runs straight on: its last point lies within an edge and is no vertex."
                                : "The chain would turn right: its last point lies inside and is removed.");
    step.decides = !none;
    if (!none && !asked_) {
      asked_ = true;
      step.question = Question{"Does the chain turn left at its last point?",
                               {"yes", "no"},
                               1,
                               straight ? "The orientation is exactly zero." : "The orientation is negative."};
    }
    drawn_.removed.clear(), removed_.clear();
    const auto last = std::minmax_element(points_.begin(), points_.end(), before<double>);
    if (e.p == (drawn_.upper ? *last.first : *last.second) && drawn_.chain.size() > 1) {
      drawn_.done.push_back(std::exchange(drawn_.chain, {}));
      number_ = 0;
    }
  }

  void hull() {
    drawn_.chain.clear(), drawn_.done.clear();
    drawn_.hull = hull_;
    area_ = area(hull_);
    script_.value("vertices", static_cast<double>(hull_.size()));
    script_.value("hull", area_, "area", Role::hit);
    script_.settle(Verdict::Kind::yes, fmt::format("{} of {} points are vertices", hull_.size(), points_.size()));
    add("hull", "The hull", 3,
        "Every convex set that holds the points holds each segment between them, so all of this.\n"
        "No convex volume is tighter. It is strictly defined for point sets and polygonal objects.");
  }

  void against(Bounding what) {
    drawn_.bounding = what;
    const Measured m = measured(points_, what);
    const double empty = m.area - area_;
    script_.value(m.name, m.area, "area", Role::second);
    Step& step =
        add(m.slug, std::string("Against the ") + m.name, -1,
            fmt::format("The {} is kept in {} numbers, the hull in {}. It leaves more void: what it holds beyond "
                        "the hull.",
                        m.name, m.numbers, 2 * hull_.size()),
            area_ > 0 ? fmt::format("void {} = {} × the hull", shown(empty), shown(empty / area_)) : "");
    step.question = Question{"Can it be smaller than the hull?",
                             {"yes", "no"},
                             1,
                             "It is convex and holds the points, so it holds their hull."};
  }

  const Ring<double, 2>& points_;
  const Ring<double, 2> hull_;
  Script script_;
  Drawn drawn_;
  std::vector<Removed> removed_;
  double area_ = 0;
  int number_ = 0, started_ = 0;
  bool asked_ = false;
};

}  // namespace

Walk tell(const Ring<double, 2>& points) { return Teller(points).tell(); }

}  // namespace isect::lessons::convex_hull_lesson
