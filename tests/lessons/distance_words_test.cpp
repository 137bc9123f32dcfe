// What the lesson on distances says of regions, features, squares and bounds is what rational arithmetic says.

#include <cmath>
#include <set>

#include "tests/catch.h"
#include "tests/lessons/words.h"
#include "tests/nearest_pairs.h"
#include "viz/text/rich_text.h"

namespace distance_words_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;
using isect::test::Contains;
using nearest_features::Pair;
using point_segment::Nearest;

namespace {

const std::string id = "distance";

Vec3 at(const Parameters& p, const char* name) { return std::get<Vec3>(p.at(name)); }
Stretch3 segment(const Parameters& p, const char* from, const char* to) {
  return tests::stretch(Segment<double, 3>{at(p, from), at(p, to)});
}
Stretch3 a_of(const Parameters& p) { return segment(p, "p_a", "q_a"); }
Stretch3 b_of(const Parameters& p) {
  return text(p, "objects") == "point" ? segment(p, "c", "c") : segment(p, "p_b", "q_b");
}
double near_value(const Rational& x) { return oracle::real(x).nearest; }

/// The least squared distance of two boxes, by trying all numbers that an axis may need.
Rational boxes_distance2(const Parameters& p) {
  Rational sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double a[] = {at(p, "a_min")[i], at(p, "a_max")[i]}, b[] = {at(p, "b_min")[i], at(p, "b_max")[i]};
    Rational least = abs(Rational(a[0]) - Rational(b[0]));
    for (const double x : a)
      for (const double y : b) {
        if ((b[0] <= x && x <= b[1]) || (a[0] <= y && y <= a[1])) least = 0;
        least = std::min<Rational>(least, abs(Rational(x) - Rational(y)));
      }
    sum += least * least;
  }
  return sum;
}
Rational distance2(const Parameters& p) {
  return text(p, "objects") == "boxes" ? boxes_distance2(p) : oracle::distance2<3>(a_of(p), b_of(p));
}

std::string name_of(int which, Nearest feature) {
  const std::string of = which == 0 ? "a" : "b";
  return feature == Nearest::between ? "the interior of " + of
                                     : std::string("the end ") + (feature == Nearest::p ? "p_" : "q_") + of;
}

/// Calls check(setting, walk) on all presets and on random settings with these objects.
template <class Check>
void over_settings(const std::string& objects, int how_many, const Check& check) {
  for (const Preset& p : lesson(id).presets) {
    INFO(p.id);
    if (p.group == objects) check(p.parameters, lesson(id).walk(p.parameters));
  }
  on_random_settings(id, how_many, [&](const Parameters& p, const Walk& walk) {
    if (text(p, "objects") == objects) check(p, walk);
  });
}

}  // namespace

TEST_CASE("the distance told is that of rationals", "[words]") {
  int meet = 0, apart = 0;
  const auto check = [&](const Parameters& p, const Walk& walk) {
    const Rational truth = distance2(p);
    const Verdict& verdict = ending(walk).verdict;
    INFO(verdict.text);
    CHECK((verdict.kind == Verdict::Kind::yes) == (truth == 0));
    if (truth != 0) CHECK(plain(verdict.text) == "the distance is " + shown(std::sqrt(near_value(truth))));
    meet += truth == 0, apart += truth != 0;
    for (const Step& step : walk.steps)
      if (step.slug == "distance" || step.slug == "closest")
        CHECK(value(step, "*d*^2") == Approx(near_value(truth)).epsilon(1e-9).margin(1e-9));
  };
  for (const char* objects : {"point", "segments", "boxes"}) over_settings(objects, 150, check);
  CHECK((meet > 3 && apart > 50));
}

TEST_CASE("the region of a point is that of its exact dot products", "[words]") {
  std::set<int> seen;
  over_settings("point", 200, [&](const Parameters& p, const Walk& walk) {
    const Stretch3 a = a_of(p);
    const Rational t = place(b_of(p).p, a);
    const Nearest exact = feature(a, t);
    const Step& first = *find(walk, "first-end");
    CHECK(first.question.has_value() == (at(p, "p_a") != at(p, "q_a")));
    if (!first.question) return;
    const bool misled = says(ending(walk).caption, "Rounding has moved");
    const int region = exact == Nearest::p ? 0 : exact == Nearest::q ? 1 : 2;
    if (!misled) CHECK(first.question->answer == region);
    seen.insert(region);
    CHECK((find(walk, "foot") != nullptr) == (first.question->answer == 2));
    CHECK(value(ending(walk), "*t*") == Approx(std::clamp(near_value(t), 0.0, 1.0)).margin(1e-9));
    if (misled || distance2(p) == 0) return;
    CHECK(says(ending(walk).caption, "The interior contains") == (region == 2));
    CHECK(says(plain(ending(walk).caption), "The end p_a is nearest") == (region == 0));
    CHECK(says(plain(ending(walk).caption), "The end q_a is nearest") == (region == 1));
  });
  CHECK(seen.size() == 3);
}

TEST_CASE("the nearest features of two segments are those of rationals, and so is the number of pairs", "[words]") {
  int one = 0, many = 0, interiors = 0;
  over_settings("segments", 300, [&](const Parameters& p, const Walk& walk) {
    const std::vector<Pair> truth = pairs_in_rationals(a_of(p), b_of(p));
    const Step& step = *find(walk, "features");
    const std::string told = plain(step.caption);
    INFO(told);
    CHECK(says(told, "A whole interval of pairs") == (truth.size() == 2));
    CHECK(says(told, "No other pair is as near") == (truth.size() == 1));
    for (const Pair& pair : truth) {
      CHECK_THAT(told, Contains(name_of(0, pair.on_a)));
      CHECK_THAT(told, Contains(name_of(1, pair.on_b)));
    }
    if (truth.size() == 1)
      CHECK_THAT(told, Contains("are " + name_of(0, truth[0].on_a) + " and " + name_of(1, truth[0].on_b) + "."));
    CHECK(step.question.has_value() == (distance2(p) != 0));
    if (step.question) CHECK(step.question->answer == (truth.size() == 2 ? 1 : 0));
    one += truth.size() == 1, many += truth.size() == 2;
    interiors += truth[0] == Pair{Nearest::between, Nearest::between};
  });
  CHECK((one > 20 && many > 0 && interiors > 3));
}

TEST_CASE("a place that the method finds for two segments is where rationals have it", "[words]") {
  int asked = 0;
  over_settings("segments", 200, [&](const Parameters& p, const Walk& walk) {
    const Stretch3 a = a_of(p), b = b_of(p);
    const LinePlaces lines = places_of_lines(a, b);
    const Step* on_a = find(walk, "on-a");
    const Rational size = oracle::dot(a.d, a.d) * oracle::dot(b.d, b.d);
    if (size == 0 || near_value(lines.determinant) < 1e-3 * near_value(size)) return;
    REQUIRE(on_a);
    const double s = std::clamp(near_value(lines.on_a), 0.0, 1.0);
    CHECK(value(*on_a, "*t*_a") == Approx(s).margin(1e-9));
    const Step& on_b = *find(walk, "on-b");
    const Rational t = place(a.at(lines.on_a), b);
    CHECK(value(on_b, "*t*_b") == Approx(near_value(t)).epsilon(1e-9).margin(1e-9));
    const bool beyond = find(walk, "again") != nullptr;
    if (std::abs(near_value(t)) > 1e-9 && std::abs(near_value(t) - 1) > 1e-9) CHECK(beyond == (t <= 0 || t >= 1));
    ++asked;
  });
  CHECK(asked > 20);
}

TEST_CASE("capsules without thickness are segments that meet, and do not touch", "[words]") {
  const Changes equal = {{"p_b", "-2.5,-0.5,0"}, {"q_b", "0.5,-0.5,0"}, {"r_a", "0"}, {"r_b", "0"}, {"clearance", "0"}};
  CHECK_THAT(find(with(id, "near", equal), "root")->caption, Contains("the capsules are their segments"));
  const Changes far_enough = {{"r_a", "1"}, {"r_b", "0.25"}, {"clearance", "0"}};  // the segments are 1.25 apart
  CHECK_THAT(find(with(id, "near", far_enough), "root")->caption, Contains("The capsules touch."));
}

TEST_CASE("lines are called parallel where they are, and rounding where it makes them so, or not so", "[words]") {
  int parallel = 0, by_rounding = 0;
  const auto check = [&](const Parameters& p, const Walk& walk) {
    const Stretch3 a = a_of(p), b = b_of(p);
    const bool a_point = oracle::dot(a.d, a.d) == 0 || oracle::dot(b.d, b.d) == 0;
    const bool exactly = places_of_lines(a, b).determinant == 0;
    if (const Step* step = find(walk, "parallel"); step && !a_point) {
      CHECK(says(step->caption, "Parallel lines are equally far") == exactly);
      CHECK(says(step->caption, "Rounding has made det 0") == !exactly);
      (exactly ? parallel : by_rounding) += 1;
    }
    if (const Step* step = find(walk, "on-a")) CHECK(says(step->caption, "The segments are parallel") == exactly);
    if (exactly) CHECK((!find(walk, "once") && !find(walk, "tilted")));
    const std::string& told = find(walk, "features")->caption;
    if (says(told, "The segments meet: exactly")) CHECK(distance2(p) == 0);
  };
  over_settings("segments", 200, check);
  CHECK((parallel > 0 && by_rounding > 0));
  // d_b is 3 d_a, exactly; rounding leaves det above 0
  const Walk walk = with(id, "parallel",
                         {{"p_a", "0,0,0"},
                          {"q_a", "1.263999999999612,0,1.4390000000000214"},
                          {"p_b", "0,1,0"},
                          {"q_b", "3.7919999999988363,1,4.317000000000064"}});
  REQUIRE(find(walk, "on-a"));
  CHECK_THAT(find(walk, "on-a")->caption, Contains("The segments are parallel"));
  CHECK_THAT(find(walk, "features")->caption, Contains("A whole interval of pairs"));
}

TEST_CASE("clamping once is told where it returns too large a distance, and only there", "[words]") {
  int shown_bug = 0;
  over_settings("segments", 300, [&](const Parameters& p, const Walk& walk) {
    const Stretch3 a = a_of(p), b = b_of(p);
    const LinePlaces lines = places_of_lines(a, b);
    const Step* once = find(walk, "once");
    if (lines.determinant == 0) {
      CHECK_FALSE(once);
      return;
    }
    const double truth = near_value(oracle::distance2<3>(a, b)),
                 bug = near_value(oracle::distance2(a.at(lines.on_a), b.at(lines.on_b)));
    if (once) {
      CHECK(value(*once, "*d*^2, clamped once") > truth);
      ++shown_bug;
    }
    const Rational size = oracle::dot(a.d, a.d) * oracle::dot(b.d, b.d);
    if (near_value(lines.determinant) < 1e-3 * near_value(size)) return;
    if (once) {
      const auto outside = [](const Rational& x) { return x < 0 || x > 1; };
      CHECK(value(*once, "*d*^2, clamped once") == Approx(bug).epsilon(1e-9));
      CHECK(says(once->caption, "a corner region") == (outside(lines.on_a) && outside(lines.on_b)));
    }
    if (bug > truth + 1e-3 * (1 + truth)) CHECK(once);
  });
  CHECK(shown_bug > 5);
}

TEST_CASE("of nearly parallel segments the nearest point jumps, and the distance does not", "[words]") {
  const Walk walk = walk_of(id, "nearly-parallel");
  const Step& step = *find(walk, "tilted");
  const double moves = value(step, "the end moves by"), jumps = value(step, "the nearest point moves by"),
               change = value(step, "*d* changes by");
  const Parameters& p = preset(lesson(id), "nearly-parallel").parameters;
  Parameters turned = p;
  turned["q_b"] = Vec3(1, 0.96875, 0);
  CHECK(moves == Approx((at(p, "q_b") - at(turned, "q_b")).norm()));
  CHECK(jumps == Approx(3));
  CHECK(change ==
        Approx(std::abs(std::sqrt(near_value(distance2(p))) - std::sqrt(near_value(distance2(turned))))).margin(1e-12));
  CHECK(pairs_in_rationals(a_of(p), b_of(p))[0].on_b == Nearest::p);
  CHECK(pairs_in_rationals(a_of(turned), b_of(turned))[0].on_b == Nearest::q);
  CHECK((jumps > 20 * moves && change <= moves));
  CHECK_FALSE(find(walk_of(id, "ends"), "tilted"));
}

TEST_CASE("what is said of boxes is true of their intervals", "[words]") {
  std::set<int> answers;
  over_settings("boxes", 200, [&](const Parameters& p, const Walk& walk) {
    int gaps = 0, stretches = 0;
    for (int i = 0; i < 3; ++i) {
      const double lo = std::max(at(p, "a_min")[i], at(p, "b_min")[i]),
                   hi = std::min(at(p, "a_max")[i], at(p, "b_max")[i]);
      gaps += lo > hi, stretches += lo < hi;
      const Step& axis = *find(walk, std::string("axis-") + "xyz"[i]);
      CHECK(says(axis.caption, "so there is a gap") == (lo > hi));
      CHECK(says(axis.caption, "share one number") == (lo == hi));
      CHECK(says(axis.caption, "may have any of them") == (lo < hi));
    }
    const Step& step = *find(walk, "features");
    CHECK(step.question.has_value() == (gaps > 0));
    CHECK(says(step.caption, "No axis has a gap") == (gaps == 0));
    if (!step.question) return;
    CHECK(step.question->answer == stretches);
    answers.insert(stretches);
  });
  CHECK(answers.size() == 3);
}

TEST_CASE("capsules are near if the distance of their segments is at most the bound, as rationals say", "[words]") {
  int below = 0, misled = 0, near = 0, far = 0;
  over_settings("capsules", 300, [&](const Parameters& p, const Walk& walk) {
    const auto number = [&](const char* name) { return Rational(std::get<double>(p.at(name))); };
    const Rational sum = number("r_a") + number("r_b"), bound = sum + number("clearance");
    const Rational d2 = distance2(p);
    const int truth = bound < 0 ? 1 : oracle::sign(Rational(d2 - bound * bound));
    const Verdict::Kind kind = ending(walk).verdict.kind;
    CHECK(kind == (truth > 0 ? Verdict::Kind::no : truth < 0 ? Verdict::Kind::yes : Verdict::Kind::on));
    const bool rounded = says(ending(walk).caption, "Rounding has misled");
    const bool said_near = says(walk.pseudocode[static_cast<std::size_t>(ending(walk).line)], "NEAR");
    CHECK(rounded == (said_near != (truth <= 0)));
    const bool touch = d2 == sum * sum, share = d2 <= sum * sum;
    CHECK(says(ending(walk).caption, "The capsules touch") == (touch && sum > 0));
    CHECK(says(ending(walk).caption, "share points") == (share && !touch));
    near += truth <= 0, far += truth > 0, below += bound < 0;
    if (const Step* squares = find(walk, "squares")) {
      const bool yes = says(squares->caption, "would say yes here");
      if (std::abs(near_value(Rational(d2 - bound * bound))) > 1e-9) CHECK(yes == (d2 <= bound * bound));
      misled += yes;
    }
  });
  for (const int seen : {below, misled, near, far}) CHECK(seen > 0);
}

TEST_CASE("presets of distances are what their names say", "[words]") {
  const auto features = [](const char* preset_id) { return plain(find(walk_of(id, preset_id), "features")->caption); };
  CHECK_THAT(features("interiors"), Contains("the interior of a and the interior of b"));
  CHECK_THAT(features("end-and-interior"), Contains("the interior of a and the end p_b"));
  CHECK_THAT(features("ends"), Contains("the end q_a and the end p_b"));
  CHECK_THAT(features("parallel"), Contains("whole interval"));
  CHECK_THAT(features("parallel-ends"), Contains("the end q_a and the end p_b"));
  CHECK_THAT(features("rounding"), Contains("Rounding has led the method to other features"));
  CHECK(find(walk_of(id, "clamped-once"), "once"));
  for (const char* meet : {"crossing", "touching", "boxes-touching", "boxes-overlapping", "on-segment"})
    CHECK(ending(walk_of(id, meet)).verdict.kind == Verdict::Kind::yes);
  CHECK_THAT(features("faces"), Contains("rectangle"));
  CHECK_THAT(features("edges"), Contains("edge"));
  CHECK_THAT(features("corners"), Contains("two corners"));
  CHECK_THAT(features("level"), Contains("interval"));
  const auto kind = [](const char* preset_id) { return ending(walk_of(id, preset_id)).verdict.kind; };
  CHECK((kind("near") == Verdict::Kind::yes && kind("far") == Verdict::Kind::no));
  CHECK((kind("exact") == Verdict::Kind::on && kind("overlapping") == Verdict::Kind::yes));
  CHECK(kind("below-zero") == Verdict::Kind::no);
  CHECK(says(find(walk_of(id, "below-zero"), "squares")->caption, "would say yes here"));
}

}  // namespace distance_words_test
