// After a shear that makes the ray an axis, three areas in the plane have the signs in question.

#include <array>

#include "lessons/ray_triangle/signs.h"

namespace isect::lessons::ray_triangle_lesson {
namespace {

using namespace viz;
using namespace isect::ray_triangle;

class ShearTeller : SignsTeller {
 public:
  explicit ShearTeller(const Setup& s)
      : SignsTeller(s, "shear", "Woop, Benthin and Wald, Watertight ray/triangle intersection (2013)",
                    {
                        "choose as axis z that of the largest |d_i|; x, y: the others",  // 0
                        "shear ← (d_x / d_z, d_y / d_z, 1 / d_z)",                       // 1
                        "for each vertex: subtract o, shear x and y, scale z",           // 2
                        "w_a ← c_x b_y − c_y b_x; w_b and w_c likewise",                 // 3
                        "if two of them have opposite signs",                            // 4
                        "    return MISS",                                               // 5
                        "w ← w_a + w_b + w_c",                                           // 6
                        "if w = 0",                                                      // 7
                        "    return MISS",                                               // 8
                        "t ← (w_a a_z + w_b b_z + w_c c_z) / w",                         // 9
                        "if t < 0 or t > t_max",                                         // 10
                        "    return MISS",                                               // 11
                        "return HIT, t, u = w_b / w, v = w_c / w"                        // 12
                    }) {}

  Walk tell() {
    run<VolumesEvent<C>>(
        [](const auto& ray, const auto& triangle, auto& record) { return ray_triangle::woop(ray, triangle, record); },
        [this](const auto& event) { say(event); });
    end(12);
    return std::move(script_.walk());
  }

 private:
  void say(const Sheared<C>& e) {
    const char* const axes = "xyz";
    add("axis", "Along which axis", 0,
        fmt::format("The ray is **o** + *t* **d**. No coordinate of **d** is larger in size than that on *{}*.\nThat "
                    "axis becomes *z*. If **d** points against it, *x* and *y* are swapped, so that the "
                    "triangle keeps its winding.",
                    axes[e.z]),
        fmt::format("**d** = ({}, {}, {})", shown(s_.ray.direction.x()), shown(s_.ray.direction.y()),
                    shown(s_.ray.direction.z())));
    script_.value("shear in *x*", e.shear[0].value), script_.value("shear in *y*", e.shear[1].value);
    add("shear", "The shear", 1,
        "A shear moves each point in *x* and *y* by a multiple of its *z*. This one turns the ray into the *z*-axis.\n"
        "The numbers depend on the ray alone. A renderer finds them once a ray, for all triangles.");
  }

  void say(const Corner<C>& e) {
    corners_[e.index] = {e.x.value, e.y.value};
    if (e.index < 2) return;
    Step& step =
        script_.add("corners", "Where the vertices go", 2,
                    "After the shear only *x* and *y* count: we look along the ray, which is the point "
                    "(0, 0).\n"
                    "In this projection **a**′, **b**′ and **c**′ are the vertices. A vertex of several triangles "
                    "has one place for all of them.");
    step.scene = sheared(s_, corners_, false);
    step.question = {"After the shear, which point must be tested against the triangle in the plane?",
                     {"(0, 0), whatever *t* is", "the origin **o**, as given", "one that depends on *t*"},
                     0,
                     "**o** was subtracted, and the shear moves all points of the ray onto the *z*-axis."};
    keep_picture(script_.walk());
  }

  void say(const SignedVolumes<C>& e) {
    const double w[] = {e.a.value, e.b.value, e.c.value};
    for (int i = 0; i < 3; ++i) script_.value(fmt::format("*w*_{}", "abc"[i]), w[i], "area");
    Step& areas = script_.add("areas", "Three areas", 3,
                              "*w*_a is the cross product of **c**′ and **b**′: twice the area of a triangle of these "
                              "two and (0, 0).\n"
                              "Its sign tells on which side of the edge bc the ray passes. A neighbour at this edge "
                              "finds −*w*_a.");
    areas.scene = sheared(s_, corners_, true);
    signs(4, w[0], w[1], w[2], e.holds);
    script_.walk().steps.back().scene = sheared(s_, corners_, true);
  }

  void say(const Determinant<C>& e) {
    const double w = e.value.value;
    script_.value("*w*", w, "area");
    add("sum", "The sum of the three", 6,
        "*w* is the sum of *w*_a, *w*_b and *w*_c. In size it is twice the area of the sheared triangle in *x* and "
        "*y*.",
        "*w* = " + shown(w));
    parallel(7, "*w*", w);
  }

  void say(const InRange<C>& e) {
    const double t = e.t.value;
    script_.value("*t*", t, {}, e.holds ? Role::hit : Role::muted);
    known_.crossing = true;
    add("parameter", "Where on the ray", 9,
        "The third coordinates, scaled, are the *t* at which the ray is level with the vertices.\n"
        "The same weights mix them: that is *t* at the point.",
        "*t* = " + shown(t));
    range(10, t, e.holds);
  }

  std::array<Vec2, 3> corners_ = {Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};
};

}  // namespace

Walk shear(const Setup& s) { return ShearTeller(s).tell(); }

}  // namespace isect::lessons::ray_triangle_lesson
