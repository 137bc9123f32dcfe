#include "lessons/ray_polygon/telling.h"

#include <fmt/format.h>

#include <algorithm>

#include <isect/convex_hull.h>
#include <isect/methods/ray_polygon.h>
#include "lessons/shared/axis_names.h"
#include "lessons/shared/plural.h"
#include "lessons/shared/questions.h"
#include "lessons/shared/script.h"

namespace isect::lessons::ray_polygon_lesson {

using namespace viz;
using C = Counted<double>;

namespace {

const std::vector<std::string> pseudocode = {
    "n ← Σ (p_i − p₀) × (p_{i+1} − p₀)",           // 0
    "if n · d = 0: return MISS",                   // 1
    "t ← n · (p₀ − o) / (n · d)",                  // 2
    "if t < 0: return MISS",                       // 3
    "drop the coordinate i of the largest |n_i|",  // 4
    "count the edges that r(t) has on its right",  // 5
    "if the count is odd: return HIT, t",          // 6
    "return MISS"                                  // 7
};

class Teller {
 public:
  explicit Teller(const Setup& setup)
      : s_(setup),
        script_({"Lecture note, ray and polygon; Sutherland, Sproull and Schumacker, ACM Computing Surveys 6 (1974)",
                 "A ray and a polygon with a notch, in space: " + plain(verdict_text(s_.truth)) +
                     (s_.truth.t ? ", in lengths of d." : "."),
                 pseudocode}) {}

  Walk tell() {
    script_.tell<ray_polygon::ProjectedEvent<C>>(
        [&](auto& record) {
          Ring<C, 3> ring;
          for (const Vec3& v : s_.ring) ring.push_back(v.cast<C>());
          found_ = ray_polygon::projected(cast<C>(s_.ray), ring, record).has_value();
        },
        [&](const auto& event) { say(event); });
    if (chosen_ >= 0) counted();
    verdict();
    return std::move(script_.walk());
  }

 private:
  static std::string plain(std::string text) {
    std::erase(text, '*');
    return text;
  }

  void say(const ray_polygon::Normal<C>& e) {
    for (int i = 0; i < 3; ++i) {
      normal_[i] = e.n[i].value;
      script_.value(std::string("*n*_") + "xyz"[i], normal_[i], "area");
    }
    known_.normal = true;
    Step& step = script_.add(
        "normal", "The polygon's plane", 0,
        "All vertices lie in one plane. The cross products of vectors from **p**_0 sum to its normal **n**.\n"
        "A single corner would do, unless its three points lie on one line: then **n** = 0.\n"
        "The ray is **o** + *t* **d**.");
    step.scene = picture(s_, known_, normal_);
    known_.normal = false;
  }

  void say(const ray_polygon::InPlane<C>& e) { point_ = {e.point[0].value, e.point[1].value, e.point[2].value}; }

  void say(const ray_polygon::InRange<C>& e) {
    const double t = e.t.value;
    known_.plane = ranged_ = true;
    script_.value("*t*", t, {}, e.holds ? Role::hit : Role::muted);
    Step& step =
        script_.add("plane", "Where the line meets the plane", 2,
                    std::string("The line meets the plane (dashed) in one point. ") +
                        (t > 0   ? "As *t* > 0, it lies ahead of **o**."
                         : t < 0 ? "As *t* < 0, it lies behind **o**."
                                 : "As *t* = 0, it is **o** itself.") +
                        "\nThe note writes the plane with *D* = −**n** · **p**_0, and −(**n** · **o** + *D*) in "
                        "the numerator: the same *t*.",
                    "*t* = **n** · (**p**_0 − **o**) / (**n** · **d**) = " + shown(t));
    step.scene = picture(s_, known_, normal_);
    Script::decide(step, {"*t* < 0", t, 0, !e.holds, e.holds ? "on the ray" : "behind the origin"});
    step.question = where_question();
    keep_picture(script_.walk());
    script_.refuse(1, {});
    if (e.holds) script_.refuse(3, {});
  }

  void say(const ray_polygon::Projected<C>& e) {
    chosen_ = e.dropped;
    Step& step = script_.add("drop", "Which coordinate to drop?", 4, drop_caption(),
                             fmt::format("|*n*_x| = {},  |*n*_y| = {},  |*n*_z| = {}", shown(std::abs(normal_.x())),
                                         shown(std::abs(normal_.y())), shown(std::abs(normal_.z()))));
    step.scene = projections(s_, point_, normal_, chosen_);
    step.question = {"Which coordinate is best dropped?",
                     {axis_names[0], axis_names[1], axis_names[2]},
                     chosen_,
                     "Its component of the normal is the largest, so the projection keeps most area."};
  }

  void say(const point_polygon::Straddles&) {}
  void say(const point_polygon::CrossesAt<C>& e) { passing_.push_back({e.index, e.x.value, e.holds}); }

  std::string drop_caption() const {
    const double least = normal_.cwiseAbs().minCoeff();
    return std::string(
               "|*n_i*| is twice the area of the projection without coordinate *i*. Where it is not 0, inside "
               "stays inside.\n") +
           (least == 0 ? "The coordinate with *n_i* = 0 must stay: without it, the polygon collapses to a segment."
                       : "The largest keeps most area. A thin projection lets rounding move the point over an edge.");
  }

  void counted() {
    const auto count = std::count_if(passing_.begin(), passing_.end(), [](const Passing& p) { return p.counted; });
    Step& step = script_.add(
        "crossings", "Inside the outline?", 5,
        fmt::format("What is left is a point **r**′ and a polygon in the plane.\n"
                    "Its ray to the right crosses {}: an {} number, so {}.",
                    plural(count, "edge"), count % 2 == 1 ? "odd" : "even", count % 2 == 1 ? "inside" : "outside"));
    const Flat flat = flattened(s_, point_, chosen_);
    step.formula = fmt::format("**r**′ = ({}, {})", shown(flat.point.x()), shown(flat.point.y()));
    step.scene = crossings(s_, flat, passing_);
    const auto both_sides = static_cast<double>(passing_.size()), on_right = static_cast<double>(count);
    step.question =
        which_count("How many edges does the point have on its right?", on_right,
                    {{both_sides, "That counts the edges at its level on both sides."},
                     {both_sides - on_right, "That counts the edges on its left."},
                     {static_cast<double>(flat.ring.size()), "That counts all edges, at its level or not."}},
                    "An odd number means inside; the lesson on crossings shows why.");
  }

  Question where_question() const {
    const int answer = !s_.truth.line ? 2 : *s_.truth.line < 0 ? 1 : 0;
    return {"Where does the line meet the plane?",
            {"ahead of the origin, or at it", "behind the origin", "in no single point"},
            answer,
            answer == 2 ? "**n** · **d** = 0: the line is parallel to the plane, or lies in it."
                        : "The sign of *t* decides."};
  }

  void verdict() {
    const RayPolygon<double>& truth = s_.truth;
    const Verdict::Kind met = truth.location == Location::on ? Verdict::Kind::on : Verdict::Kind::yes;
    script_.settle(truth.t ? met : truth.coplanar ? Verdict::Kind::on : Verdict::Kind::no, verdict_text(truth));
    if (chosen_ < 0) script_.leave_early();
    known_.plane = known_.settled = true;
    Step& step = script_.add("verdict", "Hit or miss?",
                             chosen_ < 0 ? (ranged_ ? 3 : 1)
                             : found_    ? 6
                                         : 7,
                             verdict_caption(), ranged_ ? "" : "**n** · **d** = 0");
    if (chosen_ >= 0 && !found_) script_.refuse(6, {});
    step.scene = picture(s_, known_, normal_);
    if (!ranged_) {
      step.question = where_question();
      keep_picture(script_.walk());
    }
  }

  std::string verdict_caption() const {
    const RayPolygon<double>& truth = s_.truth;
    const bool on = truth.t && truth.location == Location::on;
    if (ranged_ != truth.line.has_value() || (found_ != truth.t.has_value() && !(on && chosen_ >= 0)))
      return "Rounding makes the plain method wrong here. The exact test says: " + verdict_text(truth) + ".";
    if (truth.flat) return "The polygon has no area, and so no plane.";
    if (truth.coplanar)
      return "The whole line lies in the plane: no single *t*. The note's formula would divide 0 by 0.\n"
             "The note's form answers MISS, as most libraries choose; for a plane without outline the lesson on rays "
             "says "
             "HIT. "
             "The exact test gives an answer of its own: the ray lies in the plane.\n"
             "Whether it crosses the polygon there is a question in two dimensions: a ray against each edge.";
    if (!truth.line) return "The line is parallel to the plane. The note's formula would divide by 0.";
    if (*truth.line < 0) return "A ray starts at **o**. What lies behind it does not count, so no edge is tested.";
    if (on)
      return fmt::format(
          "The point lies on the outline, and closed sets include their boundary. The note's crossings say {}.\n"
          "The exact test reports ON, so that no ray slips between two polygons with a common edge.",
          found_ ? "HIT here, but MISS on other edges" : "MISS here");
    if (truth.t)
      return "The point lies inside the outline, so the ray hits. The whole test took one pass over the edges: O(*n*).";
    return std::string("The point lies in the plane, but outside the outline") +
           (in_notch() ? ", in the notch: a test of the convex hull would hit." : ".");
  }

  /// Whether the point lies in the polygon's hull, but not in the polygon.
  bool in_notch() const {
    const Flat flat = flattened(s_, point_, chosen_);
    return locate(flat.point, convex_hull(flat.ring)) == Location::in;
  }

  const Setup s_;
  Script script_;
  Shown known_;
  Vec3 normal_ = Vec3::Zero(), point_ = Vec3::Zero();
  int chosen_ = -1;
  bool ranged_ = false, found_ = false;  ///< by the note's method: it has a t, and hits
  std::vector<Passing> passing_;
};

}  // namespace

std::string verdict_text(const RayPolygon<double>& truth) {
  if (truth.coplanar) return "the ray lies in the polygon's plane";
  if (!truth.line) return "the ray is parallel to the polygon's plane";
  if (truth.t)
    return fmt::format("the ray {} the polygon at *t* = {}",
                       truth.location == Location::on ? "meets the outline of" : "hits", shown(*truth.t));
  return *truth.line < 0 ? "the polygon's plane lies behind the ray" : "the ray misses the polygon";
}

Walk tell(const Setup& setup) { return Teller(setup).tell(); }

}  // namespace isect::lessons::ray_polygon_lesson
