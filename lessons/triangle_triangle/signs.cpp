// Two triangles by the signs of volumes alone: the test of Guigue and Devillers, by the core's exact predicates.

#include <fmt/format.h>

#include "lessons/shared/questions.h"
#include "lessons/triangle_triangle/telling.h"

namespace isect::lessons::triangle_triangle_lesson {

using namespace viz;
using triangle_triangle::Alone;
using triangle_triangle::Ends;
using triangle_triangle::InPlane;
using triangle_triangle::Signs;

namespace {

std::string sign_name(int sign) { return sign > 0 ? "+" : sign < 0 ? "−" : "0"; }

class SignsTeller : Teller {
 public:
  explicit SignsTeller(const Setup& s)
      : Teller(s, "signs of volumes", "Guigue and Devillers, Fast and robust triangle-triangle overlap test (2003)",
               {"side(a_i) ← +, − or 0: above, below or in the plane of b",        // 0
                "if all side(a_i) are +, or all −",                                // 1
                "    return DISJOINT",                                             // 2
                "side(b_i) ← +, − or 0: above, below or in the plane of a",        // 3
                "if all side(b_i) are +, or all −",                                // 4
                "    return DISJOINT",                                             // 5
                "if all side(a_i) are 0",                                          // 6
                "    return whether no side of a or b parts them in the plane",    // 7
                "begin a and b with the corner that lies alone, above the other",  // 8
                "if the volume of b₁, b₀, a₀, a₁ is positive",                     // 9
                "    return DISJOINT",                                             // 10
                "if the volume of b₂, b₀, a₂, a₀ is positive",                     // 11
                "    return DISJOINT",                                             // 12
                "return INTERSECT"}) {}                                            // 13

  Walk tell() {
    two_triangles(0);
    script_.tell<triangle_triangle::SignsEvent>(
        [&](auto& record) { found_ = triangle_triangle::by_signs(s_.a(), s_.b(), record); },
        [&](const auto& event) { say(event); });
    return end();
  }

 private:
  void say(const triangle_triangle::Sides& e) {
    const int which = e.of;
    const std::string own = triangle_name(which), other = triangle_name(1 - which);
    std::string all;
    for (int i = 0; i < 3; ++i)
      all += (i == 0 ? "" : ", ") + corner_name(which, i) + " " + sign_name(e.signs[static_cast<std::size_t>(i)]);
    known_.plane = 1 - which, known_.heights = true;
    add("volumes-" + own, "Signs instead of heights", which == 0 ? 0 : 3,
        which == 0 ? "The corners of b and one of a span a volume. Its sign says on which side of the plane of b that "
                     "corner lies.\n"
                     "It is an orientation in space (orient3d). An exact predicate finds it, without a height."
                   : "The same with a and b exchanged.",
        all);
    Step& step = add("sides-" + own, "On which side is " + own + "?", which == 0 ? 1 : 4, told_sides(which, e.signs));
    step.decides = true;
    if (which == 0 && s_.area[1])
      step.question =
          sides_question(e.signs, fmt::format("The signs of the corners of a are {}, {} and {}.", sign_name(e.signs[0]),
                                              sign_name(e.signs[1]), sign_name(e.signs[2])));
    if (e.beside)
      line_ = which == 0 ? 2 : 5;
    else
      script_.refuse(which == 0 ? 1 : 4, {which == 0 ? 2 : 5});
  }

  void say(const InPlane& e) {
    if (!last_side_) {
      known_.plane = -1, known_.heights = false;
      add("one-plane", "One plane?", 6,
          s_.one_plane()
              ? "All signs of a are 0: one plane holds both triangles.\n"
                "What is left is a test in two dimensions, by signs of areas (orient2d)."
              : "All signs of a are 0. The test takes that for one plane of two triangles, but one has no area.")
          .decides = true;
    }
    last_side_ = e;
    line_ = 7;
  }

  void say(const Alone& e) {
    alone_[static_cast<std::size_t>(e.of)] = e;
    if (e.of == 0) return;
    known_.plane = -1, known_.heights = false, known_.line = true;
    script_.refuse(6, {7});
    for (std::size_t of = 0; of < 2; ++of) {
      const int i = alone_[of].corner;
      order_[of] = {i, (i + 1) % 3, (i + 2) % 3};
      if (alone_[1 - of].turned) std::swap(order_[of][1], order_[of][2]);
      for (const std::size_t k : {1U, 2U}) known_.lit.push_back({static_cast<int>(of), order_[of][0], order_[of][k]});
    }
    Step& step =
        add("order", "Two edges of each", 8,
            s_.both_have_area() ? fmt::format("Both planes meet in a line (dashed). The edges of a at {} reach the "
                                              "plane of b, those of b at {} that of a (lit).\n"
                                              "Where such a corner lies lower than its neighbours, the test exchanges "
                                              "two corners of the other triangle: then it lies higher.",
                                              corner_name(0, alone_[0].corner), corner_name(1, alone_[1].corner))
                                : "A triangle without area has no plane, and so there is no line of both planes.\n"
                                  "The test cannot know that. It takes two edges of each (lit), as if there were one.",
            fmt::format("a: {}, {}, {};  b: {}, {}, {}", name(0, 0), name(0, 1), name(0, 2), name(1, 0), name(1, 1),
                        name(1, 2)));
    known_.lit.clear();
    if (!s_.both_have_area()) return;
    step.question = which_count(
        "Two edges of a and two of b meet the line of both planes. How many further signs tell whether the parts of "
        "the line share a point?",
        2,
        {{1, "One sign tells that one part does not end before the other begins. The other way round is open."},
         {4, "That pairs each of the two edges of a with each of those of b. Two pairs decide."},
         {9, "That pairs all edges of a with all of b. Edges that do not meet the line tell nothing here."}},
        "Two parts of a line share no point if one ends before the other begins, or the other way round. Each takes "
        "one sign.");
  }

  void say(const Ends& e) {
    const bool first = e.number == 0;
    // The edges whose places on the line are compared.
    known_.lit = first ? std::vector<Edge>{edge(0, 1), edge(1, 1)} : std::vector<Edge>{edge(0, 2), edge(1, 2)};
    const std::string one = first ? name(0, 0) + name(0, 1) : name(0, 0) + name(0, 2),
                      other = first ? name(1, 0) + name(1, 1) : name(1, 0) + name(1, 2);
    Step& step =
        add(first ? "first-end" : "second-end", first ? "Does one part end first?" : "Or the other?", first ? 9 : 11,
            !s_.both_have_area()
                ? fmt::format("The test asks the sign of the volume that the edges {} and {} span. Without a line of "
                              "both planes, that sign does not settle it.",
                              one, other)
                : fmt::format(
                      "The edges {} and {} each meet the line in an end of a part. These four corners span a volume.\n",
                      one, other) +
                      (e.sign > 0   ? "Its sign is +: there one part ends before the other begins. They share no point."
                       : e.sign < 0 ? "Its sign is −: these ends leave room for a common point."
                                    : "It is 0: the two edges lie in one plane. That parts nothing."));
    step.decides = true;
    known_.lit.clear();
    if (e.apart)
      line_ = first ? 10 : 12;
    else
      script_.refuse(first ? 9 : 11, {first ? 10 : 12});
  }

  std::string name(int of, std::size_t k) const { return corner_name(of, order_[static_cast<std::size_t>(of)][k]); }
  Edge edge(int of, std::size_t k) const {
    const auto& order = order_[static_cast<std::size_t>(of)];
    return {of, order[0], order[k]};
  }

  std::array<Alone, 2> alone_ = {};
  std::array<std::array<int, 3>, 2> order_ = {};
};

}  // namespace

Walk signs(const Setup& s) { return SignsTeller(s).tell(); }

}  // namespace isect::lessons::triangle_triangle_lesson
