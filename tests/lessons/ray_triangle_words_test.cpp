// What the lesson on rays and triangles says is what rational arithmetic says, of single rays and of all cells of a
// seam.

#include <array>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>

#include <isect/methods/ray_triangle.h>
#include "bench/rational.h"
#include "tests/lessons/words.h"
#include "viz/text/rich_text.h"

namespace ray_triangle_words_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;
using isect::test::Contains;
using oracle::Rational;
using oracle::operator+;
using oracle::operator-;
using oracle::operator*;

namespace {

using Space = oracle::Coordinates<3>;
const std::string id = "ray-triangle";

const Vec3& vector_of(const Parameters& p, const char* name) { return std::get<Vec3>(p.at(name)); }
Space exact(const Parameters& p, const char* name) { return oracle::rational<double, 3>(vector_of(p, name)); }
bool is_seam(const Parameters& p) { return text(p, "method") == "seam"; }
bool is_segment(const Parameters& p) { return text(p, "extent") == "segment"; }

/// A point of the plane by its projection along the normal; no term of it is the lesson's.
struct Truth {
  bool flat, parallel, coplanar = false, hit = false;
  Rational heading, t, u, v, w;

  explicit Truth(const Parameters& p) {
    const Space a = exact(p, "a"), e = exact(p, "b") - a, f = exact(p, "c") - a, d = exact(p, "d");
    const Space from = exact(p, "o") - a, n = oracle::cross(e, f);
    const Rational area = oracle::dot(n, n), height = oracle::dot(n, from);
    heading = oracle::dot(n, d);
    flat = area == 0, parallel = heading == 0;
    coplanar = !flat && parallel && height == 0;
    if (parallel) return;
    t = -height / heading;
    const Space at = from + t * d;
    u = oracle::dot(oracle::cross(at, f), n) / area, v = oracle::dot(oracle::cross(e, at), n) / area;
    w = 1 - u - v;
    hit = meets() && t >= 0 && (!is_segment(p) || t <= Rational(std::get<double>(p.at("t_max"))));
  }
  bool meets() const { return !parallel && u >= 0 && v >= 0 && w >= 0; }
  int zeros() const { return (u == 0) + (v == 0) + (w == 0); }
  /// Whether all numbers keep most of their digits in doubles.
  bool mild(const Parameters& p) const {
    const Vec3 &a = vector_of(p, "a"), &d = vector_of(p, "d");
    const double size = (vector_of(p, "b") - a).norm() * (vector_of(p, "c") - a).norm() * d.norm();
    return std::abs(static_cast<double>(heading)) > 1e-3 * size;
  }
};

std::string branch_of(const Truth& x) {
  if (x.parallel) return "no crossing";
  const bool a = x.w < 0, b = x.u < 0, c = x.v < 0;
  if (!a && !b && !c) return x.zeros() == 0 ? "inside" : x.zeros() == 1 ? "edge" : "vertex";
  if (a + b + c == 1) return a ? "beyond bc" : b ? "beyond ca" : "beyond ab";
  return !a ? "beyond a" : !b ? "beyond b" : "beyond c";
}

bool shows(const std::string& told, double x) {
  for (const double near : {x, x * (1 - 1e-12), x * (1 + 1e-12)})
    if (says(told, shown(near))) return true;
  return false;
}

/// Calls look(parameters, walk) on all presets and on random settings, at a seam or away from one.
template <class Look>
void over_settings(bool seams, int how_many, const Look& look) {
  for (const Preset& p : lesson(id).presets) {
    INFO(p.id);
    if (is_seam(p.parameters) == seams) look(p.parameters, lesson(id).walk(p.parameters));
  }
  on_random_settings(id, how_many, [&](const Parameters& p, const Walk& walk) {
    if (is_seam(p) == seams) look(p, walk);
  });
}

}  // namespace

TEST_CASE("a ray hits a triangle, or misses it for the reason that is told, when rationals say so", "[words]") {
  std::set<std::string> seen;
  over_settings(false, 600, [&](const Parameters& p, const Walk& walk) {
    const Truth truth(p);
    const Step& last = ending(walk);
    const std::string told = plain(last.verdict.text);
    CAPTURE(told, last.caption);
    CHECK((last.verdict.kind != Verdict::Kind::no) == truth.hit);
    CHECK(says(told, " at t = ") == truth.hit);
    if (truth.hit) CHECK(shows(told, static_cast<double>(truth.t)));
    if (truth.hit) CHECK((last.verdict.kind == Verdict::Kind::on) == (truth.zeros() > 0));
    const std::string why = truth.flat       ? "has no area"
                            : truth.coplanar ? "lies in the triangle's plane"
                            : truth.parallel ? "is parallel to"
                            : !truth.meets() ? "passes beside"
                            : truth.t > 0    ? "ends before"
                                             : "lies behind";
    if (!truth.hit) CHECK_THAT(told, Contains(why));
    if (find(walk, "miss") != nullptr && !says(last.caption, "Rounding")) {
      const std::string branch = branch_of(truth);
      CHECK(says(last.caption, "Two weights are negative") ==
            (branch == "beyond a" || branch == "beyond b" || branch == "beyond c"));
      CHECK(says(last.caption, "beyond the edge") ==
            (branch.ends_with("bc") || branch.ends_with("ca") || branch.ends_with("ab")));
    }
    seen.insert(truth.hit ? truth.zeros() > 0 ? "edge" : "inside" : why);
  });
  for (const char* outcome : {"edge", "inside", "has no area", "lies in the triangle's plane", "is parallel to",
                              "passes beside", "ends before", "lies behind"}) {
    INFO(outcome);
    CHECK(seen.contains(outcome));
  }
}

TEST_CASE("the map's branch is that of the weights in rationals", "[words]") {
  const CaseMap& map = *lesson(id).map;
  std::set<std::string> seen;
  over_settings(false, 300, [&](const Parameters& p, const Walk&) {
    const Truth truth(p);
    const std::string branch = map.branches[static_cast<std::size_t>(map.branch(p))];
    CHECK(branch == branch_of(truth));
    seen.insert(branch);
    if (const Vec2 place = map.place(p); !std::isnan(place.x()) && truth.mild(p)) {
      CHECK(place.x() == Approx(static_cast<double>(truth.u)).margin(1e-6));
      CHECK(place.y() == Approx(static_cast<double>(truth.v)).margin(1e-6));
    }
  });
  CHECK(seen.size() == map.branches.size());
}

TEST_CASE("weights, and the answers to what follows from them, are those of rationals", "[words]") {
  int faces = 0, followed = 0, mixed = 0;
  over_settings(false, 600, [&](const Parameters& p, const Walk& walk) {
    const Truth truth(p);
    if (!truth.flat && !truth.parallel && !truth.mild(p)) return;
    if (const Step* const face = find(walk, "determinant"); face && face->question) {
      CHECK(face->question->answer == (truth.heading < 0 ? 0 : truth.heading > 0 ? 1 : 2));
      ++faces;
    }
    if (truth.parallel) return;
    const double u = static_cast<double>(truth.u), v = static_cast<double>(truth.v);
    if (const Step* const told = find(walk, "weight-u")) CHECK(value(*told, "*u*") == Approx(u).margin(1e-6));
    if (const Step* const told = find(walk, "weight-v")) CHECK(value(*told, "*v*") == Approx(v).margin(1e-6));
    if (const Step* const told = find(walk, "range-v"); told && told->question) {
      if (const auto& number = told->question->number)
        CHECK(number->truth == Approx(static_cast<double>(truth.w)).margin(1e-6));
      else
        CHECK(shows(answer(*told), static_cast<double>(truth.w)));
      CHECK(says(told->question->because, "None of them is negative") == (truth.v >= 0 && truth.w >= 0));
      ++followed;
    }
    if (const Step* const told = find(walk, "weights"); told && told->question) {
      const double right = 1 + u + 4 * v;  // (1 - u - v) 1 + 2 u + 5 v
      CHECK(shows(answer(*told), right));
      ++mixed;
    }
  });
  CHECK((faces > 20 && followed > 10 && mixed > 10));
}

TEST_CASE("neighbours find the number of their common edge with opposite signs, to the last bit", "[words]") {
  int seen = 0;
  on_random_settings(id, 300, [&](const Parameters& p, const Walk&) {
    const Vec3 &a = vector_of(p, "a"), &b = vector_of(p, "b"), &c = vector_of(p, "c"), &q = vector_of(p, "q");
    const Ray<double, 3> ray = {vector_of(p, "o"), vector_of(p, "d")};
    const Triangle<double, 3> own = {{a, b, c}}, other = {{c, b, q}};
    using Listener = Record<ray_triangle::VolumesEvent<double>>;
    const auto volumes = [](const Listener& record) {
      for (const auto& event : record.events)
        if (const auto* e = std::get_if<ray_triangle::SignedVolumes<double>>(&event)) return *e;
      throw std::runtime_error("no volumes");
    };
    Listener first, second, third, fourth;
    ray_triangle::signed_volumes(ray, own, first);
    ray_triangle::signed_volumes(ray, other, second);
    ray_triangle::woop(ray, own, third);
    ray_triangle::woop(ray, other, fourth);
    CHECK(volumes(first).a == -volumes(second).c);
    CHECK(volumes(third).a == -volumes(fourth).c);
    ++seen;
  });
  CHECK(seen > 100);
}

namespace {

/// A triangle as a fixed origin sees it: three edges and the plane, in rationals.
struct Seen {
  std::array<Space, 3> edges;
  Space normal;
  Rational height;

  Seen(const Space& o, const Space& p, const Space& q, const Space& r)
      : edges{{oracle::cross(q - o, r - o), oracle::cross(r - o, p - o), oracle::cross(p - o, q - o)}},
        normal(oracle::cross(q - p, r - p)),
        height(oracle::dot(normal, p - o)) {}

  bool met(const Space& d, const Parameters& p) const {
    const Rational heading = oracle::dot(normal, d);
    if (heading == 0) return false;
    bool above = false, below = false;
    for (const Space& edge : edges) {
      const int side = oracle::sign(oracle::dot(edge, d));
      above = above || side > 0, below = below || side < 0;
    }
    if (above && below) return false;
    const Rational t = height / heading;
    return t >= 0 && (!is_segment(p) || t <= Rational(std::get<double>(p.at("t_max"))));
  }
};

double moved(double x, int steps) {
  for (int k = 0; k < std::abs(steps); ++k) x = std::nextafter(x, steps < 0 ? -INFINITY : INFINITY);
  return x;
}

struct Count {
  int holes[3] = {}, both = 0, cells = 0;

  explicit Count(const Parameters& p) {
    const Vec3 &a = vector_of(p, "a"), &b = vector_of(p, "b"), &c = vector_of(p, "c"), &q = vector_of(p, "q");
    const Vec3& d = vector_of(p, "d");
    const Triangle<double, 3> own = {{a, b, c}}, other = {{c, b, q}};
    const Space o = exact(p, "o");
    const Seen seen(o, exact(p, "a"), exact(p, "b"), exact(p, "c")),
        beside(o, exact(p, "c"), exact(p, "b"), exact(p, "q"));
    Ray<double, 3> ray = {vector_of(p, "o"), d};
    if (is_segment(p)) ray.range.hi = std::get<double>(p.at("t_max"));
    for (int i = -32; i <= 32; ++i)
      for (int j = -32; j <= 32; ++j) {
        ray.direction = {moved(d.x(), i), moved(d.y(), j), d.z()};
        const Space at = oracle::rational<double, 3>(ray.direction);
        const bool first = seen.met(at, p), second = beside.met(at, p);
        ++cells, both += first && second;
        if (!first && !second) continue;
        const auto none = [&](const auto& test) { return !test(own) && !test(other); };
        holes[0] += none([&](const auto& x) { return ray_triangle::moller_trumbore(ray, x).has_value(); });
        holes[1] += none([&](const auto& x) { return ray_triangle::signed_volumes(ray, x).has_value(); });
        holes[2] += none([&](const auto& x) { return ray_triangle::woop(ray, x).has_value(); });
      }
  }
};

}  // namespace

TEST_CASE("a seam has as many holes as rationals count", "[words]") {
  int open = 0, closed = 0;
  over_settings(true, 40, [&](const Parameters& p, const Walk& walk) {
    const Count count(p);
    const Step& last = ending(walk);
    CHECK(last.slug == "holes");
    CHECK(value(last, "cells") == count.cells);
    CHECK(value(last, "holes by Möller and Trumbore") == count.holes[0]);
    CHECK(value(last, "holes by signed volumes") == count.holes[1]);
    CHECK(value(last, "holes by shear") == count.holes[2]);
    CHECK((last.verdict.kind == Verdict::Kind::no) == (count.holes[0] + count.holes[1] + count.holes[2] > 0));
    const Step &truth = *find(walk, "truth"), &cells = *find(walk, "moller-trumbore");
    CHECK(says(truth.caption, "both triangles. A ray") == (count.both > 0));
    CHECK(says(truth.caption, "One ray meets") == (count.both == 1));
    CHECK(says(cells.caption, "No ray slips through") == (count.holes[0] == 0));
    REQUIRE(cells.question);
    CHECK(cells.question->answer == (count.holes[0] == 0 ? 0 : 10 * count.holes[0] < count.cells ? 1 : 2));
    (count.holes[0] > 0 ? open : closed) += 1;
  });
  CHECK((open >= 2 && closed >= 1));
}

TEST_CASE("the presets of the seam are what their names say", "[words]") {
  const auto said = [](const char* preset_id) { return lesson(id).opinions(preset(lesson(id), preset_id).parameters); };
  CHECK(said("seam-hole")[0].says == "meets both");
  CHECK(said("seam-hole")[1].says == "meets neither");
  CHECK_FALSE(said("seam-hole")[1].agrees);
  CHECK(said("seam-beside")[0].says == said("seam-beside")[1].says);
  CHECK(said("seam-watertight")[0].says == "meets both");
  CHECK(said("seam-watertight")[1].agrees);
  const auto holes = [](const char* preset_id) {
    return value(ending(walk_of(id, preset_id)), "holes by Möller and Trumbore");
  };
  CHECK(holes("seam-hole") > 100);
  CHECK(holes("seam-watertight") == 0);
  for (const char* test : {"holes by signed volumes", "holes by shear"})
    CHECK(value(ending(walk_of(id, "seam-hole")), test) == 0);
}

TEST_CASE("nearly parallel to the plane t loses digits, and the lesson says so", "[words]") {
  CHECK_FALSE(lesson(id).opinions(preset(lesson(id), "grazing").parameters)[1].agrees);
  CHECK_THAT(find(walk_of(id, "grazing"), "hit")->caption, Contains("Rounding has cost"));
  CHECK_FALSE(says(find(walk_of(id, "face"), "hit")->caption, "Rounding"));
  CHECK_THAT(find(walk_of(id, "grazing"), "hit")->caption, Contains("nearly parallel to the plane"));
  // A needle that the ray meets steeply: its two edges are nearly parallel, the ray and the plane are not.
  const Walk needle = with(id, "face",
                           {{"a", "-1.3,-0.7,0.1"},
                            {"b", "0.9,0.4,0.3"},
                            {"c", "2,0.950000000005,0.4"},
                            {"o", "-0.12500000000000006,0.58750000000125,-1.975"},
                            {"d", "0.1,-0.3,1.1"}});
  REQUIRE(find(needle, "hit"));
  CHECK_THAT(find(needle, "hit")->caption, Contains("Rounding has cost"));
  CHECK_FALSE(says(find(needle, "hit")->caption, "nearly parallel"));
}

TEST_CASE("lines of one weight are spoken of where they are drawn, and a ray is aimed where an edge parts answers",
          "[words]") {
  int drawn = 0, left_out = 0;
  over_settings(false, 300, [&](const Parameters&, const Walk& walk) {
    for (const auto& [slug, name, words] :
         {std::tuple("weight-u", "*u*", "The line drawn"), std::tuple("weight-v", "*v*", "The two lines cross")})
      if (const Step* const step = find(walk, slug)) {
        const bool near = std::abs(value(*step, name)) < 3;
        CHECK(says(step->caption, words) == near);
        (near ? drawn : left_out) += 1;
      }
  });
  CHECK((drawn > 10 && left_out > 0));
  CHECK_THAT(find(walk_of(id, "seam-hole"), "seam")->caption, Contains("is aimed at it"));
  CHECK_THAT(find(with(id, "seam-hole", {{"b", "-0.26,0.92,-0.28"}}), "seam")->caption,
             Contains("no edge between them"));
  const Walk folded = with(id, "seam-hole", {{"q", "-1,-1,-0.5"}});  // beyond bc it misses both
  CHECK_FALSE(says(find(folded, "seam")->caption, "is aimed at it"));
}

TEST_CASE("the numbers of the exercises on triangles are right", "[words]") {
  const std::vector<Exercise>& all = lesson(id).closing->exercises;
  CHECK(0.2 * 10 + 0.3 * 20 + 0.5 * 40 == Approx(28));
  CHECK_THAT(all[2].solution, Contains("= 28."));
  Parameters p = preset(lesson(id), all[0].preset).parameters;
  for (const auto& [name, told] : all[0].by) set(lesson(id), p, name, told);
  const Truth truth(p);
  CHECK((truth.u == Rational(1.375) && truth.v == Rational(-0.25)));
}

}  // namespace ray_triangle_words_test
