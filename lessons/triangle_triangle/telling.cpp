#include "lessons/triangle_triangle/telling.h"

#include <fmt/format.h>

#include "lessons/shared/plural.h"
#include "lessons/shared/questions.h"
#include "lessons/shared/relation.h"
#include "viz/text/rich_text.h"

namespace isect::lessons::triangle_triangle_lesson {

using namespace viz;
using triangle_triangle::Signs;

std::string corner_name(int which, int i) { return fmt::format("**{}**_{}", triangle_name(which), i); }

Teller::Teller(const Setup& s, const std::string& title, const std::string& source, std::vector<std::string> pseudocode)
    : PictureTeller(s, {source, "Two triangles in space, a and b: " + relation_words(s.truth, "they") + ".",
                        std::move(pseudocode), title}) {}

void Teller::two_triangles(int line) {
  add("two-triangles", "Two triangles in space", line,
      "The triangle a has the corners **a**_0, **a**_1 and **a**_2. Those of the triangle b are **b**_0, **b**_1 and "
      "**b**_2.\n"
      "Triangles are closed sets: edges and corners belong to them. Do they have a common point?");
}

std::string Teller::told_sides(int which, const Signs& signs) const {
  const std::string own = triangle_name(which), other = triangle_name(1 - which);
  if (!s_.area[static_cast<std::size_t>(1 - which)])
    return fmt::format("Here {} has no area, and so no plane: no corner of {} has a side of it.", other, own);
  const auto count = [&](int sign) { return (signs[0] == sign) + (signs[1] == sign) + (signs[2] == sign); };
  if (count(1) == 3 || count(-1) == 3)
    return fmt::format(
        "All corners of {} lie strictly on one side of the plane of {}. So all of {} does, and {} lies in that plane.\n"
        "They have no common point.",
        own, other, own, other);
  if (count(0) == 3) return fmt::format("All corners of {} lie in the plane of {}.", own, other);
  if (count(1) > 0 && count(-1) > 0)
    return fmt::format(
        "The corners of {} lie on both sides of the plane of {}: {} crosses that plane.\n"
        "Whether it meets {} there is still to be seen.",
        own, other, own, other);
  if (count(0) == 2 && !s_.area[static_cast<std::size_t>(which)])
    return fmt::format("Two corners of {} lie in the plane of {}, the third on one side.\nOnly there {} may meet {}.",
                       own, other, own, other);
  return fmt::format("{} in the plane of {}, the rest of {} on one side.\nOnly there {} may meet {}.",
                     count(0) == 1 ? "One corner of " + own + " lies" : "An edge of " + own + " lies", other, own, own,
                     other);
}

Question Teller::sides_question(const Signs& signs, const std::string& given) const {
  const bool beside = signs[0] != 0 && signs[0] == signs[1] && signs[0] == signs[2];
  return {given + " What follows?",
          {"a and b are disjoint", "a and b meet", "a reaches the plane of b, and may meet b",
           "a lies in the plane of b, and may meet b"},
          beside                    ? 0
          : signs == Signs{0, 0, 0} ? 3
                                    : 2,
          "Only a point in the plane of b can belong to b. Which points of a lie there, the three signs tell."};
}

void Teller::in_plane(int line, const triangle_triangle::InPlane& last) {
  if (last.apart) known_.lit = {{last.of, last.side, (last.side + 1) % 3}};
  const std::string own = triangle_name(last.of), other = triangle_name(1 - last.of);
  // What the signs say is true where exact signs say the same; else rounding or a missing area has made them.
  Record<triangle_triangle::SignsEvent> exact;
  triangle_triangle::by_signs(s_.a(), s_.b(), exact);
  const auto* side = exact.events.empty() ? nullptr : std::get_if<triangle_triangle::InPlane>(&exact.events.back());
  const bool sure =
      s_.one_plane() && side && side->of == last.of && side->side == last.side && side->apart == last.apart;
  add("sides", last.apart ? "A side that parts them" : "No side parts them", line,
      std::string(s_.one_plane() ? "Seen along an axis, both are triangles in two dimensions. There the normals of the "
                                   "sides are all axes that may separate.\n"
                  : s_.both_have_area() ? "The method looks along an axis, as if one plane held both.\n"
                                        : "Seen along an axis, one of them is a segment or a point. Then the normals "
                                          "of the sides are not all axes that may separate.\n") +
          (last.apart
               ? fmt::format("{}he side of {} from {} to {} has all of {} beyond it{}", sure ? "T" : "By its signs, t",
                             own, corner_name(last.of, last.side), corner_name(last.of, (last.side + 1) % 3), other,
                             sure ? ": its normal is a separating axis." : ". The method takes them to be disjoint.")
               : std::string("No side has all of the other triangle strictly beyond it") +
                     (sure ? ": no axis separates." : ", by its signs. The method takes them to meet.")));
  known_.lit.clear();
}

Walk Teller::end() {
  if (last_side_) in_plane(7, *last_side_);
  if (!found_) script_.leave_early();
  known_.plane = -1, known_.heights = false, known_.settled = true;
  const bool line_is_shown = s_.part(0) && s_.part(1);
  known_.line = line_is_shown, known_.part = {line_is_shown, line_is_shown};
  script_.settle(verdict_kind(s_.truth), relation_words(s_.truth, "the triangles"));
  add("relation", "The exact relation", line_, reason());
  known_.part = {};
  Step& step = add("mesh", "In a mesh", line_, in_a_mesh());
  if (s_.meet() && s_.both_have_area())
    step.question = Question{
        "May a mesh that bounds a solid have these two triangles?",
        {"yes: all that they share is corners and edges of both",
         "no: they share what is no corner and no edge of both", "no: no two triangles of a mesh share a point"},
        s_.clash() ? 1 : 0,
        "Neighbours share a corner, or two corners and the edge between them. Anything else is a fault."};
  return std::move(script_.walk());
}

std::string Teller::reason() const {
  const std::string exactly = s_.meet() ? "they meet" : "they are disjoint";
  if (found_ != s_.meet() && !s_.both_have_area())
    return "A triangle without area has no plane, so this method fails, whatever the rounding. Exactly, " + exactly +
           ".\nThe exact test takes such a triangle for the segment or the point that it is.";
  if (found_ != s_.meet())
    return "Rounding has misled this method: exactly, " + exactly +
           ".\nThe exact test takes the true signs of determinants in the given numbers.";
  switch (s_.truth) {
    case Relation::disjoint:
      return "They have no common point, and the exact test says so, too.";
    case Relation::touching:
      return "They meet, but in no point that is interior to both: they touch.\n" + interior();
    case Relation::overlapping:
      return s_.one_plane() ? "Some points are interior to both: they overlap. In one plane they share a polygon."
                            : "Some points are interior to both: they overlap.\n" + interior();
    case Relation::equal:
      return "They are the same set of points.";
    case Relation::a_inside_b:
      return "All of a belongs to b.";
    case Relation::b_inside_a:
      break;
  }
  return "All of b belongs to a.";
}

std::string Teller::interior() const {
  return std::string("The interior of a triangle is what it has off its edges.") +
         (s_.both_have_area() ? "" : " Without area it is a segment: its interior is what it has off its two ends.");
}

std::string Teller::in_a_mesh() const {
  std::string neighbours =
      "Neighbours in a mesh share corners and edges. So “they meet” is true of all neighbours, and shows no fault.\n";
  if (found_ != s_.meet())
    neighbours += std::string("A check by ") + (s_.both_have_area() ? "rounded numbers" : "this method") +
                  " alone would be misled here.\n";
  if (!s_.both_have_area())
    return neighbours + "A triangle without area is a fault by itself: it has no normal, and so no side that is outer.";
  if (!s_.meet()) return neighbours + "These two have no common point: no fault.";
  const int shared = s_.shared_corners();
  const std::string corners = plural(shared, "corner");
  if (s_.clash())
    return neighbours +
           (shared == 0 ? "These two share no corner, and yet they meet"
                        : "These two share " + corners + ", and more than that") +
           ": a mesh with them intersects itself.\n"
           "“Touching” is not enough to tell, either: the test must know which corners are shared.";
  return neighbours + "These two share " + corners + (shared == 2 ? " and the edge between them" : "") +
         ", and nothing else: no fault.";
}

}  // namespace isect::lessons::triangle_triangle_lesson
