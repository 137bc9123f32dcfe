// On which side of the line each edge passes: three signed volumes.

#include "lessons/ray_triangle/signs.h"

namespace isect::lessons::ray_triangle_lesson {
namespace {

using namespace viz;
using namespace isect::ray_triangle;

class VolumesTeller : SignsTeller {
 public:
  explicit VolumesTeller(const Setup& s)
      : SignsTeller(s, "signed volumes",
                    "Ericson, Real-Time Collision Detection (2005), section 5.3.4; Amanatides and Choi, Ray tracing "
                    "triangular meshes (1997)",
                    {
                        "a′ ← a − o, b′ ← b − o, c′ ← c − o",      // 0
                        "w_a ← d · (b′ × c′)",                     // 1
                        "w_b ← d · (c′ × a′)",                     // 2
                        "w_c ← d · (a′ × b′)",                     // 3
                        "if two of them have opposite signs",      // 4
                        "    return MISS",                         // 5
                        "n ← (b − a) × (c − a)",                   // 6
                        "if n · d = 0",                            // 7
                        "    return MISS",                         // 8
                        "t ← n · a′ / (n · d)",                    // 9
                        "if t < 0 or t > t_max",                   // 10
                        "    return MISS",                         // 11
                        "w ← w_a + w_b + w_c",                     // 12
                        "return HIT, t, u = w_b / w, v = w_c / w"  // 13
                    }) {}

  Walk tell() {
    add("from-o", "Seen from the origin", 0,
        "The ray is **o** + *t* **d**. We measure from **o**: **a**′, **b**′ and **c**′ lead from it to the vertices "
        "**a**, **b** and **c**.",
        "**a**′ = **a** − **o**,  **b**′ = **b** − **o**,  **c**′ = **c** − **o**");
    run<VolumesEvent<C>>([](const auto& ray, const auto& triangle,
                            auto& record) { return ray_triangle::signed_volumes(ray, triangle, record); },
                         [this](const auto& event) { say(event); });
    if (found_) sum();
    end(13);
    return std::move(script_.walk());
  }

 private:
  void say(const SignedVolumes<C>& e) {
    const double w[] = {e.a.value, e.b.value, e.c.value};
    static const char* const formulas[] = {"**d** · (**b**′ × **c**′)", "**d** · (**c**′ × **a**′)",
                                           "**d** · (**a**′ × **b**′)"};
    static const char* const slugs[] = {"edge-bc", "edge-ca", "edge-ab"};
    for (int i = 0; i < 3; ++i) {
      const std::string name = fmt::format("*w*_{}", "abc"[i]);
      known_.edge = i;
      script_.value(name, w[i], "volume");
      add(slugs[i], fmt::format("The edge {}", edge_names[i]), 1 + i, edge_caption(i, w[i]),
          fmt::format("{} = {} = {}", name, formulas[i], shown(w[i])));
      if (i == 0) neighbour(w[0]);
    }
    known_.edge = -1;
    signs(4, w[0], w[1], w[2], e.holds);
  }

  std::string edge_caption(int i, double w) const {
    const std::string side =
        ((w > 0) - (w < 0)) != s_.side[i]
            ? "\nRounding has changed this sign."
            : (w == 0 ? fmt::format("\nHere it is 0: one plane holds the line of the ray, {} and {}.",
                                    vertex_names[(i + 1) % 3], vertex_names[(i + 2) % 3])
                      : std::string());
    if (i == 0)
      return "The plane through **o** and the edge bc, if there is one, has the normal **b**′ × **c**′. The sign of "
             "*w*_a tells on which side **d** points.\n"
             "It is a signed volume: six times that of the tetrahedron **o**, **o** + **d**, **b**, **c**." +
             side;
    return fmt::format("The same for the edge {}. Its number *w*_{} belongs to {}, the vertex opposite.", edge_names[i],
                       "abc"[i], vertex_names[i]) +
           side;
  }

  void neighbour(double w) {
    known_.neighbour = true;
    Step& step =
        add("neighbour", "The neighbour at this edge", 1,
            "A second triangle **c**, **b**, **q** has this edge the other way round, from **c** to **b**. It computes "
            "**d** · (**c**′ × **b**′).\n"
            "That is −*w*_a to the last bit, as rounding treats both signs alike. At this edge the two agree.\n"
            "A fused multiply-add can break this: it rounds one of two products, and not the other.");
    const std::string asked = "A neighbour **c**, **b**, **q** has it from **c** to **b**. What does it compute there?";
    const std::string because =
        "Each product is the same, and each difference has the other sign. Rounding treats both alike.";
    step.question = Question{"The edge leads from **b** to **c**. " + asked,
                             {"*w*_a", "−*w*_a", "another number, as it rounds otherwise"},
                             1,
                             because};
    if (w != 0)
      step.question = which_value(fmt::format("For the edge from **b** to **c**, *w*_a is {}. ", shown(w)) + asked, -w,
                                  {{w, "That goes from **b** to **c**. The other way round the sign changes."},
                                   {0, "The two numbers sum to 0, but this one is not 0."},
                                   {2 * w, "That adds the numbers of both, as if their signs were the same."}},
                                  because);
    known_.neighbour = false;
  }

  void say(const Determinant<C>& e) {
    const double heading = e.value.value;
    script_.value("**n** · **d**", heading, "volume");
    add("normal", "The sum of the three", 6,
        "The vector **n** is normal to the plane. Without rounding *w*_a + *w*_b + *w*_c is **n** · **d**.\n"
        "*w*_a divided by this sum is the weight of **a**: 1 at **a**, and 0 on the edge bc.",
        "**n** · **d** = " + shown(heading));
    parallel(7, "**n** · **d**", heading);
  }

  void say(const InRange<C>& e) {
    const double t = e.t.value;
    script_.value("*t*", t, {}, e.holds ? Role::hit : Role::muted);
    known_.crossing = true;
    add("parameter", "Where on the ray", 9,
        "The line meets the plane where its height above it, along **n**, is 0. That is the *t* of ray and plane.",
        "*t* = **n** · **a**′ / (**n** · **d**) = " + shown(t));
    range(10, t, e.holds);
  }

  void say(const Sheared<C>&) {}
  void say(const Corner<C>&) {}

  void sum() {
    script_.value("*u*", found_->u.value), script_.value("*v*", found_->v.value);
    add("sum", "From volumes to weights", 12,
        "*w* is the sum of the three. Divided by it they are weights that sum to 1: *u* for **b**, and *v* for **c**.",
        "*u* = *w*_b / *w*,  *v* = *w*_c / *w*");
  }
};

}  // namespace

Walk volumes(const Setup& s) { return VolumesTeller(s).tell(); }

}  // namespace isect::lessons::ray_triangle_lesson
