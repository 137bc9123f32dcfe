// One volume against the six planes.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <isect/numbers/predicate.h>
#include "lessons/culling/picture.h"
#include "lessons/shared/digits.h"
#include "lessons/shared/script.h"
#include "viz/solids.h"

namespace isect::lessons::culling_lesson {

using namespace viz;
using C = Counted<double>;

namespace {

const std::vector<std::string> pseudocode = {
    "result ← INSIDE",                                       // 0
    "for each plane n · x + D ≥ 0 of the frustum",           // 1
    "    if the volume lies beyond it: return OUTSIDE",      // 2
    "    if the plane meets the volume: result ← CROSSING",  // 3
    "return result"                                          // 4
};

class OneVolume {
 public:
  OneVolume(const Frustum<double>& view, const Vec3& eye, const Volume& asked)
      : view_(view),
        eye_(eye),
        asked_(asked),
        ball_(std::holds_alternative<Ball>(asked)),
        truth_(ask(asked, view)),
        they_(ball_ ? "ball" : "box"),
        script_({"Lecture note, view-volume culling; Assarsson and Möller, Optimized View Frustum Culling Algorithms "
                 "(2000)",
                 fmt::format("A view frustum with its eye, and a {} that is {}{}.", they_, word(truth_.culling),
                             truth_.culling == Culling::outside
                                 ? fmt::format(": beyond the {} plane", plane_names[truth_.rejecting_plane()])
                                 : ""),
                 pseudocode, std::string("one ") + they_}) {}

  Walk tell() {
    Step& first = script_.add(
        "view-volume", "What the eye can see", 0,
        "The eye sees what lies in the frustum: the intersection of six half-spaces, **n** · **x** + *D* ≥ 0. Each "
        "normal **n** points inwards.\n" +
            std::string(ball_ ? "The centre **c** of the ball and its radius are compared with each plane.\n"
                              : "The p-vertex is the box's corner farthest along **n**, the n-vertex the opposite one. "
                                "Their coordinates are ends of the box, *b*_{min} or *b*_{max}.\n") +
            "A renderer extracts the six planes from its projection matrix: the last row plus or minus another row.\n"
            "That holds for −*w* ≤ *z* ≤ *w*, as in OpenGL. With 0 ≤ *z* ≤ *w* (Direct3D, Metal, Vulkan) the near "
            "plane is the third row alone.");
    first.scene = picture(-1, Role::second);
    tally() = {};
    for (const frustum_planes::Tested& event : truth_.tested) say(event);
    answer();
    return std::move(script_.walk());
  }

 private:
  Scene picture(int plane, Role role) const {
    Scene scene;
    add_view(view_, eye_, scene);
    add(asked_, role, scene);
    if (plane >= 0) add_plane(view_, plane, scene);
    const Vec3 at = middle(asked_);
    scene.handles = {{"p", Handle::Kind::point, at, Vec3::Zero(), Role::second},
                     {"eye", Handle::Kind::point, eye_, Vec3::Zero(), Role::first}};
    return scene;
  }

  const Plane<double, 3>& plane_at(int i) const { return view_.planes[i]; }

  void say(const frustum_planes::Tested& event) {
    const auto [plane, side] = event;
    const std::string name = plane_names[plane];
    Scene scene = picture(plane, side == Culling::outside ? Role::miss : Role::second);
    Comparison comparison = ball_ ? ask_ball(plane, side, scene) : ask_box(plane, side, scene);
    comparison.meaning = side == Culling::outside    ? "all of the " + they_ + " lies beyond"
                         : side == Culling::crossing ? "some of the " + they_ + " lies beyond"
                                                     : "none of the " + they_ + " lies beyond";
    if (side == Culling::outside) script_.leave_early();
    Step& step = script_.add("plane-" + name, fmt::format("The {} plane", name),
                             side == Culling::outside    ? 2
                             : side == Culling::crossing ? 3
                                                         : 1,
                             caption(side), formula(plane));
    step.scene = std::move(scene);
    Script::decide(step, comparison);
    step.question = {where(plane),
                     {"wholly on its inner side", "wholly beyond it", "neither"},
                     side == Culling::inside    ? 0
                     : side == Culling::outside ? 1
                                                : 2,
                     ball_ ? "Compare the distance of the centre with the radius."
                           : "Two opposite corners of the box decide: the p-vertex and the n-vertex."};
    if (ball_)
      step.question->given = {{"**n** · **c** + *D*", height_, "length", Role::second},
                              {"*r*", std::get<Ball>(asked_).radius, "length", Role::second}};
  }

  /// The question, with numbers that suffice to answer it.
  std::string where(int plane) const {
    const char* const name = plane_names[plane];
    if (ball_) return fmt::format("Where does the ball lie, relative to the {} plane, whose **n** has length 1?", name);
    const Box& box = std::get<Box>(asked_);
    return fmt::format("The box reaches from {} to {}. Where does it lie, relative to the {} plane, {}?",
                       coordinates(box.lo), coordinates(box.hi), name, inner_side(plane_at(plane)));
  }

  Comparison ask_box(int i, Culling side, Scene& scene) {
    // Counts what isect/aabb_frustum.h tests: the n-vertex only where the p-vertex is not beyond.
    const Plane<C, 3> plane = cast<C>(plane_at(i));
    const Aabb<C, 3> box = cast<C>(std::get<Box>(asked_));
    const auto at = [](const Point<C, 3>& p) -> Vec3 { return {p[0].value, p[1].value, p[2].value}; };
    const auto asked = [&](bool far) {
      const Point<C, 3> corner = plane_aabb::detail::corner(plane.normal, box, far);
      const C height = plane.normal.dot(corner) + plane.d;
      static_cast<void>(height < C(0));
      return std::pair(at(corner), height.value);
    };
    const auto [p_vertex, greatest] = asked(true);
    const auto [n_vertex, least] = side == Culling::outside ? std::pair(Vec3(Vec3::Zero()), 0.0) : asked(false);
    script_.count(tally());
    const double length = plane_at(i).normal.norm();
    script_.value("**n** · p-vertex + *D*", greatest / length, "length", greatest < 0 ? Role::miss : Role::hit);
    if (side != Culling::outside)
      script_.value("**n** · n-vertex + *D*", least / length, "length", least < 0 ? Role::miss : Role::hit);
    const auto corner = [&](const Vec3& p, double height, const char* name) {
      scene.items.emplace_back(Dot{p,
                                   height < 0   ? Mark::no
                                   : height > 0 ? Mark::disc
                                                : Mark::diamond,
                                   height < 0   ? Role::miss
                                   : height > 0 ? Role::hit
                                                : Role::highlight});
      scene.items.emplace_back(Label{p, name, Role::text});
    };
    corner(p_vertex, greatest, "p-vertex");
    if (side != Culling::outside) corner(n_vertex, least, "n-vertex");
    reaches_ = greatest / length;
    sharing_ = static_cast<int>(
        std::ranges::count(std::array{plane_at(i).normal.x(), plane_at(i).normal.y(), plane_at(i).normal.z()}, 0.0));
    if (side == Culling::outside) return {"**n** · p-vertex + *D* < 0", reaches_, 0, greatest < 0, ""};
    return {"**n** · n-vertex + *D* < 0", least / length, 0, least < 0, ""};
  }

  Comparison ask_ball(int i, Culling side, Scene& scene) {
    const Ball& ball = std::get<Ball>(asked_);
    const Plane<double, 3>& plane = plane_at(i);
    const double length = plane.normal.norm(), height = (plane.normal.dot(ball.center) + plane.d) / length;
    script_.value("distance", height, "length", height < 0 ? Role::miss : Role::hit);
    script_.value("*r*", ball.radius, "length", Role::second);
    reaches_ = height + ball.radius, height_ = height, least_ = std::min(least_, height);
    const Vec3 foot = ball.center - height / length * plane.normal;
    scene.items.emplace_back(Line{ball.center, foot, Role::construction, Pen::construction});
    scene.items.emplace_back(Dot{ball.center, Mark::disc, Role::second});
    scene.items.emplace_back(Label{ball.center, "**c**", Role::second});
    if (side == Culling::outside) return {"**n** · **c** + *D* < −*r*", height, -ball.radius, true, ""};
    return {"**n** · **c** + *D* < *r*", height, ball.radius, side == Culling::crossing, ""};
  }

  /// The box's corner farthest along **n**, which follows from the signs of **n**; of a ball the height of its centre.
  std::string formula(int i) const {
    if (ball_) return "**n** · **c** + *D* = " + shown(reaches_ - std::get<Ball>(asked_).radius) + ", with |**n**| = 1";
    std::string corner;
    for (int axis = 0; axis < 3; ++axis)
      corner += std::string(axis > 0 ? ", " : "") + (plane_at(i).normal[axis] >= 0 ? "*b*_{max," : "*b*_{min,") +
                "xyz"[axis] + "}";
    const Vec3& n = plane_at(i).normal;
    return fmt::format("**n** ∥ ({}, {}, {}):  p-vertex = ({})", shown(n.x()), shown(n.y()), shown(n.z()), corner);
  }

  std::string caption(Culling side) const {
    if (side == Culling::outside)
      return ball_ ? "The centre lies beyond the plane by more than *r*: no point of the ball is on the inner side.\n"
                     "One plane is enough to reject it, and no other is tested."
                   : "Even the p-vertex, the corner farthest along **n**, lies beyond. So all of the box does.\n"
                     "One plane is enough to reject it, and no other is tested.";
    static const char* const sharing[] = {"The p-vertex", "An edge with the p-vertex", "A face with the p-vertex"};
    if (side == Culling::crossing)
      return ball_ ? "The centre is no farther than *r* from the plane: the ball may be visible."
             : reaches_ == 0
                 ? sharing[sharing_] +
                       std::string(" lies in the plane, and the rest beyond it: the box touches the plane.")
                 : "The p-vertex lies on the inner side and the n-vertex beyond: the plane cuts the box." +
                       std::string(sharing_ > 0 ? "\nWhere *n_i* = 0, either of its coordinates will do." : "");
    return ball_ ? "The whole ball lies on the inner side. That alone says nothing yet: each plane must agree."
                 : "Even the n-vertex, the opposite corner, is not beyond. So the whole box is on the inner "
                   "side.";
  }

  bool false_positive() const {
    return truth_.culling == Culling::crossing && !ball_ && !meet(std::get<Box>(asked_), view_);
  }

  /// Whether the box has points in one of the planes, and none on its inner side.
  bool touches() const {
    if (ball_) return false;
    bool found = false;
    for (const Plane<double, 3>& plane : view_.planes)
      relate(plane, std::get<Box>(asked_), [&](const auto& event) {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(event)>, plane_aabb::Decision>)
          found |= event.greatest == 0;
      });
    return found;
  }

  /// Whether the volume is a ball whose centre lies beyond none of the planes.
  bool centre_inside() const {
    if (!ball_) return false;
    const Point<double, 3>& centre = std::get<Ball>(asked_).center;
    return std::ranges::all_of(view_.planes, [&](const Plane<double, 3>& plane) {
      return sign_of([&]<class W>() -> W { return dot(exactly<W>(plane.normal), exactly<W>(centre)) + W(plane.d); }) >=
             0;
    });
  }

  void answer() {
    const Culling culling = truth_.culling;
    using Kind = Verdict::Kind;
    script_.settle(culling == Culling::inside    ? Kind::yes
                   : culling == Culling::outside ? Kind::no
                                                 : Kind::on,
                   culling == Culling::inside ? "inside: drawn, and nothing in it is tested again"
                   : culling == Culling::outside
                       ? fmt::format("outside: beyond the {} plane", plane_names[truth_.rejecting_plane()])
                   : false_positive() ? "crossing: drawn, though it is not visible"
                                      : "crossing: drawn, as it may be visible");
    script_.value("planes asked", static_cast<double>(truth_.tested.size()));
    Step& step = script_.add("answer",
                             fmt::format("The {} {}", they_,
                                         culling == Culling::crossing ? "crosses"
                                         : culling == Culling::inside ? "is inside"
                                                                      : "is outside"),
                             culling == Culling::outside ? 2 : 4, answer_caption());
    step.scene = Scene{};
    add_view(view_, eye_, step.scene);
    add(asked_, truth_, step.scene);
    if (culling == Culling::crossing && !ball_)
      for (const Ring<double, 3>& part : faces_inside(std::get<Box>(asked_), view_))
        step.scene.items.emplace_back(Region{.rings = {part}, .role = Role::hit});
    if (culling == Culling::crossing)
      step.question = {fmt::format("What do the six planes say about the {}?", they_),
                       {"some of it is visible", "some of it may be visible", "none of it is visible"},
                       centre_inside() ? 0 : 1,
                       centre_inside()
                           ? "The centre lies on the inner side of all six."
                           : "Each plane alone leaves something. What is left may differ from plane to plane."};
    if (culling == Culling::crossing && ball_)
      step.question->given = {{"least **n** · **c** + *D*", least_, "length", Role::second}};
  }

  std::string answer_caption() const {
    if (truth_.culling == Culling::inside)
      return "All six planes agree, so the frustum contains it. Its contents need no test and no clipping.";
    if (truth_.culling == Culling::outside)
      return fmt::format(
          "The {} is not drawn. The signs are exact, so what can be seen is never rejected.\n"
          "Rounded, **n** · **x** + *D* may reject what just touches a plane.",
          they_);
    if (false_positive())
      return "False positive: no plane rejects the box, yet it misses the frustum, beyond one of its edges.\n"
             "The test is conservative. Drawing too much costs time and leaves the picture right; drawing too little "
             "spoils it.";
    if (touches())
      return "The box touches a plane from outside, and the sets are closed: only a box beyond is rejected.\n"
             "What the two share, marked here, has no volume.";
    if (centre_inside())
      return "Crossing only means perhaps. Here the centre lies on the inner side of all planes, so some of the ball "
             "is visible.";
    if (ball_) return "Crossing only means perhaps. Beyond an edge a ball may cut two planes and miss the frustum.";
    return "Crossing only means perhaps. Here a part is inside; it is marked, and found by clipping the faces.";
  }

  const Frustum<double> view_;
  const Vec3 eye_;
  const Volume asked_;
  const bool ball_;
  const Answer truth_;
  const std::string they_;
  Script script_;
  int sharing_ = 0;          ///< axes along the plane: what reaches farthest is a vertex, an edge or a face
  double height_ = 0;        ///< of a ball's centre over the plane in turn
  double least_ = INFINITY;  ///< of these heights so far
  double reaches_ = 0;       ///< how far the volume reaches over the plane in turn
};

}  // namespace

Walk one_volume(const Frustum<double>& view, const Vec3& eye, const Volume& asked) {
  return OneVolume(view, eye, asked).tell();
}

}  // namespace isect::lessons::culling_lesson
