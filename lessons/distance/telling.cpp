#include "lessons/distance/telling.h"

#include <fmt/format.h>

#include "viz/text/rich_text.h"

namespace isect::lessons::distance_lesson {

using namespace viz;

namespace {

std::string shapes(const Setup& s) {
  if (s.is("point")) return "A point and a segment";
  return s.is("segments") ? "Two segments, a and b" : s.is("boxes") ? "Two boxes, a and b" : "Two capsules, a and b";
}

}  // namespace

std::string told_distance(const Setup& s) {
  if (s.is("capsules"))
    return s.beyond > 0   ? "farther apart than the clearance"
           : s.beyond < 0 ? "nearer than the clearance"
                          : "exactly the clearance apart";
  if (s.meet) return s.is("point") ? "the point lies on the segment" : "they meet";
  return fmt::format("the distance is {}", shown(s.distance()));
}

Teller::Teller(const Setup& s, const std::string& title, const std::string& source, std::vector<std::string> pseudocode)
    : PictureTeller(s, {source, fmt::format("{}: {}.", shapes(s), told_distance(s)), std::move(pseudocode), title}) {}

void Teller::settle() {
  if (s_.is("capsules"))
    script_.settle(s_.beyond > 0   ? Verdict::Kind::no
                   : s_.beyond < 0 ? Verdict::Kind::yes
                                   : Verdict::Kind::on,
                   told_distance(s_));
  else
    script_.settle(s_.meet ? Verdict::Kind::yes : Verdict::Kind::no, told_distance(s_));
}

Question Teller::pairs_question() const {
  const Kind kind = s_.kind();
  const int answer = kind == Kind::rectangle ? 2 : kind == Kind::interval ? 1 : 0;
  return {"How many pairs of points, one of a and one of b, are *d* apart?",
          {"one alone", "one for each number of an interval", "one for each point of a rectangle"},
          answer,
          s_.is("boxes")
              ? "On an axis with a gap both coordinates are fixed. On any other axis each shared number will do."
              : "Segments that are not parallel have one pair. Parallel ones may have a whole interval of pairs."};
}

std::string feature_name(int which, Nearest feature) {
  const char of = "ab"[which];
  if (feature == Nearest::between) return fmt::format("the interior of {}", of);
  return fmt::format("the end **{}**_{}", feature == Nearest::p ? "p" : "q", of);
}

std::string told_features(const Setup& s) {
  const Pair& pair = s.pairs.front();
  const std::string on_a = feature_name(0, pair.on_a), on_b = feature_name(1, pair.on_b);
  if (s.pairs.size() > 1)
    return fmt::format(
        "The segments are parallel. A whole interval of pairs has the least distance.\n"
        "It ends at two pairs: {} with {}, and {} with {}.",
        on_a, on_b, feature_name(0, s.pairs[1].on_a), feature_name(1, s.pairs[1].on_b));
  const std::string which = fmt::format("The nearest features are {} and {}.", on_a, on_b);
  if (pair.on_a == Nearest::between && pair.on_b == Nearest::between && s.distance2() > 0)
    return which + " The way between the nearest points is perpendicular to both segments.\nNo other pair is as near.";
  return which + "\nNo other pair is as near.";
}

}  // namespace isect::lessons::distance_lesson
