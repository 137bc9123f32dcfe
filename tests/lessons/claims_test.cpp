// Whatever a text compares ("cheapest", "nearest", "fewer", "on average") or says of all cases ("never", "always") is a
// claim. Each is listed here with what holds it: a new one fails until it is. Nothing happens by chance or by luck.

#include <regex>

#include "lessons/glossary.h"
#include "tests/lessons/asked_for.h"
#include "tests/lessons/texts.h"
#include "viz/text/rich_text.h"

namespace claims_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;

namespace {

struct Claim {
  const char* words;    ///< a part of a sentence, as a regular expression
  const char* held_by;  ///< the file of the test that recomputes it; else why it is so
};
struct Claims {
  const char* lesson;
  std::vector<Claim> all;
};

const std::vector<Claims>& claims() {
  static const std::vector<Claims> all = {
      {"aabb-aabb", {{"always that of the same box", "pairs_words_test: else one does not contain the other"}}},
      {"bounding-volumes",
       {{"Less void means fewer false positives", "a volume within another meets no more"},
        {"Finding the tightest axes takes a search", "the boxes of the lesson are fitted by one"},
        {"(never more|always less)", "volumes_words_test; the choices of a question"},
        {"the tightest at their cost", "what a Pareto front is"}}},
      {"capsule-capsule",
       {{"[Tt]he nearest point is (the end|between)", "rivals_test"},
        {"the nearest point lies between the ends", "rivals_test"},
        {"The nearest point of a segment", "a segment is convex"},
        {"nearest points( of the lines)?, (not )?clamped", "the name of a method"},
        {"they cross, or an end is nearest", "rivals_test"},
        {"a shortest connection", "rivals_test"},
        {"are nearest between their ends", "an example of space, where four ends are not enough"}}},
      {"collision",
       {{"900 never move", "given by the exercise"},
        {"Boxes that it never meets at the same time", "their intervals on that axis share no number"},
        {"[Tt]hey never meet", "uses_words_test"}}},
      {"concave-polygon",
       {{"fewer than 6n at the others", "rivals_test"},
        {"8 edges or fewer", "rivals_test"},
        {"fewer than 6 on average", "rivals_test"},
        {"so that no polygon is bad on average", "de Berg et al., over the orders of insertion"},
        {"on average over the orders", "de Berg et al."},
        {"On average two trapezoids begin at each vertex", "polygon_words_test counts 2 n + 1"}}},
      {"convex-hull",
       {{"Which is the tightest convex volume", "what a hull is"},
        {"the price of fewer numbers", "degenerate_words_test"}}},
      {"convex-polygon", {{"It never takes more than [0-9]+", "polygon_words_test"}}},
      {"crossings", {{"an edge along the line never counts", "edge_words_test"}}},
      {"culling", {{"what can be seen is never rejected", "culling_test"}}},
      {"distance", {{"[Nn]earest", "distance_words_test, by rationals"}}},
      {"hierarchy",
       {{"The cheapest is taken", "rivals_test"},
        {"[Nn]earest", "taught_polygons_words_test, by all objects"},
        {"Where boxes overlap little, most objects are never tested", "volumes_test, on the costs as n grows"}}},
      {"obb-obb", {{"or comes nearest to one", "rivals_test"}, {"The tightest one is drawn", "rivals_test"}}},
      {"picking", {{"The nearest object is the one that the eye sees", "what a ray from the eye is for"}}},
      {"ray-polygon", {{"Always dropping the same coordinate", "the bug that the card names"}}},
      {"ray-sphere",
       {{"nearest to the centre", "the foot of a perpendicular"}, {"The nearest root", "rays_words_test"}}},
      {"ray-tracing", {{"the nearest is not needed", "a shadow takes any object"}}},
      {"rays",
       {{"never, on this course", "rays_words_test; a choice of a question"}, {"may never be seen", "as it may"}}},
      {"robustness",
       {{"in fewer than a tenth", "a choice of a question"},
        {"The exact test is never wrong", "its verdict is exact; speed_against_error_test counts"}}},
      {"rounding-bound", {{"rounded to the nearest double", "what IEEE 754 asks for"}}},
      {"rules-of-thumb",
       {{"Fewer operations promise less time", "a promise, which the lesson's clock breaks"},
        {"steps on average instead of", "rules_of_thumb_test: the mean of the points drawn"}}},
      {"speed-against-error",
       {{"(was never wrong|always says no, by convention)", "speed_against_error_test; families_words_test"},
        {"The fastest is", "speed_against_error_test, over all methods"}}},
      {"sphere-aabb",
       {{"nearest point", "rivals_test"},
        {"point nearest to (c|the centre)", "rivals_test"},
        {"the face nearest to c", "asked_words_test"},
        {"Which point is nearest", "the exercise asks"}}},
      {"sphere-sphere", {{"nearest to each other along it", "the triangle inequality"}}}};
  return all;
}

const std::vector<Claim>& known(const std::string& lesson) {
  static const std::vector<Claim> none;
  for (const Claims& c : claims())
    if (c.lesson == lesson) return c.all;
  return none;
}

bool claims_something(const std::string& text) {
  static const std::regex word(
      "\\b(cheapest|costs? least|nearest|tightest|fastest|shortest|fewer|never|always|on average)\\b",
      std::regex::icase);
  return std::regex_search(text, word);
}

}  // namespace

TEST_CASE("each comparison and each word of all cases is listed, with what holds it", "[every lesson]") {
  for (const Lesson* lesson : those_asked_for()) {
    std::vector<std::pair<std::regex, bool>> parts;  // whether some text has it
    for (const Claim& c : known(lesson->id)) parts.emplace_back(c.words, false);
    for (const std::string& markup : texts(*lesson)) {
      std::string rest = plain(markup);
      if (!claims_something(rest)) continue;
      for (auto& [part, seen] : parts) {
        if (!std::regex_search(rest, part)) continue;
        seen = true;
        rest = std::regex_replace(rest, part, "…");
      }
      INFO(lesson->id << ": " << plain(markup));
      CHECK_FALSE(claims_something(rest));
    }
    const bool measured = lesson->id == "speed-against-error" || lesson->id == "rules-of-thumb";
    for (std::size_t i = 0; !measured && i < parts.size(); ++i) {  // what is measured may be said another time
      INFO(lesson->id << ": " << known(lesson->id)[i].words << " is said no more");
      CHECK(parts[i].second);
    }
  }
}

TEST_CASE("nothing is said to happen by chance or by luck", "[every lesson]") {
  static const std::regex luck("\\bby (chance|luck)\\b");
  for (const Lesson* lesson : those_asked_for())
    for (const std::string& text : texts(*lesson)) {
      INFO(lesson->id << ": " << text);
      CHECK_FALSE(std::regex_search(plain(text), luck));
    }
  for (const lessons::Term& term : lessons::glossary()) CHECK_FALSE(std::regex_search(plain(term.meaning), luck));
}

}  // namespace claims_test
