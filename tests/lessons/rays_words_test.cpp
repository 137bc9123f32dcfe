// What the lessons of rays say, in words, is what rational arithmetic says.

#include <cmath>
#include <map>

#include "bench/oracle.h"
#include "bench/ray_polygon/oracle.h"
#include "lessons/lessons.h"
#include "lessons/ray_polygon/telling.h"
#include "tests/catch.h"
#include "tests/lessons/random_settings.h"
#include "tests/settings.h"
#include "viz/player/reader_state.h"
#include "viz/walk/closing.h"

namespace rays_words_test {
using namespace isect;
using namespace isect::viz;

namespace {

const Lesson& lesson(const char* id) { return lesson_named(lessons::all_lessons(), id); }

bool holds(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

const Step* step_of(const Walk& walk, const char* slug) {
  for (const Step& s : walk.steps)
    if (s.slug == slug) return &s;
  return nullptr;
}

double value(const Step& step, const std::string& name) {
  for (const Value& v : step.values)
    if (v.name == name) return v.value;
  throw std::runtime_error("no value " + name);
}

/// Whether the text has the number as it is shown, with its unit; its fifth digit may depend on the last bit.
bool is_hit_at(const std::string& text, double t, const std::string& unit) {
  for (const double near : {t, t * (1 - 1e-14), t * (1 + 1e-14)})
    if (text == "hit at *t* = " + shown(near) + unit) return true;
  return false;
}

/// Runs over the presets, then over random settings.
template <class Look>
void over_settings(const Lesson& l, int how_many, const Look& look) {
  bench::Random random(bench::stream(tests::seed(), (l.id + " in words").c_str()));
  for (const Preset& p : l.presets) look(p.parameters);
  for (int i = 0; i < how_many; ++i) look(tests::random_setting(l, random));
}

/// Checks what a step says about a line with this number of roots.
void said_of_roots(const std::string& caption, int roots) {
  CHECK(holds(caption, "touches") == (roots == 1 && !holds(caption, "Rounding")));
  if (holds(caption, "nearer than *r*") || holds(caption, "meets the sphere twice")) CHECK(roots == 2);
  if (holds(caption, "misses")) CHECK(roots == 0);
  if (holds(caption, "shares no point")) CHECK(roots == 0);
  if (holds(caption, "shares one point")) CHECK(roots == 1);
  if (holds(caption, "shares two points")) CHECK(roots == 2);
}

/// Checks what the last step says about a miss. `ahead`: whether the centre is ahead.
void said_of_misses(const Step& last, const oracle::RaySphere& truth, bool ahead) {
  const bool miss = !truth.surface && !truth.enter;
  CHECK(holds(last.verdict.text, "the line passes by") == (miss && truth.line_roots == 0));
  CHECK(holds(last.verdict.text, "the segment ends before") == (miss && truth.line_roots > 0 && ahead));
  CHECK(holds(last.verdict.text, "the ball lies behind") == (miss && truth.line_roots > 0 && !ahead));
  if (holds(last.caption, "lies wholly inside")) CHECK((!truth.surface && truth.enter));
  if (holds(last.caption, "Rounding made this method wrong"))
    CHECK(holds(last.caption, "there is no hit") == !truth.surface);
}

}  // namespace

TEST_CASE("a ray and a sphere end with the oracle's verdict, and say why on its conditions only", "[ray-sphere]") {
  int before = 0, within = 0, cancelled = 0, on = 0, astray = 0, denied_wrongly = 0;
  int turn = 0;
  over_settings(lesson("ray-sphere"), tests::cases(1500, 10000), [&](Parameters p) {
    if (++turn % 3 == 0) p["method"] = std::string("haines"), p["extent"] = std::string("segment");
    if (turn % 3 == 1 && turn > 40) {  // from just before the surface
      p["method"] = std::string(turn % 2 == 0 ? "quadratic" : "half-b");
      const double before_it = 1 + std::pow(10, -1 - turn % 7);
      p["origin"] = Vec3(std::get<Vec3>(p["center"]) -
                         std::get<Vec3>(p["direction"]).normalized() * before_it * std::get<double>(p["radius"]));
    }
    if (turn % 7 == 2 && turn > 40)  // from so far away that rounding leads methods astray
      p["origin"] = Vec3(std::get<Vec3>(p["origin"]) - 1e5 * turn * std::get<Vec3>(p["direction"]));
    Ray<double, 3> ray = {std::get<Vec3>(p.at("origin")), std::get<Vec3>(p.at("direction"))};
    if (std::get<std::string>(p.at("extent")) == "segment") ray.range.hi = std::get<double>(p.at("t_max"));
    const Sphere<double, 3> ball = {std::get<Vec3>(p.at("center")), std::get<double>(p.at("radius"))};
    const oracle::RaySphere truth = oracle::ray_sphere<3>(ray, ball);
    const bool haines = std::get<std::string>(p.at("method")) == "haines";
    const Walk walk = lesson("ray-sphere").walk(p);
    const Step& last = walk.steps[outcome(walk)];
    CAPTURE(last.verdict.text, last.caption, ray.origin.transpose(), ray.direction.transpose(), ball.radius);

    REQUIRE(last.verdict.kind == (!truth.surface                 ? Verdict::Kind::no
                                  : truth.origin == Location::on ? Verdict::Kind::on
                                                                 : Verdict::Kind::yes));
    if (truth.surface)
      CHECK(is_hit_at(last.verdict.text, truth.surface->nearest * (haines ? ray.direction.norm() : 1),
                      haines ? " (a length)" : ", in lengths of **d**"));
    CHECK(holds(last.verdict.text, "inside the ball") == (!truth.surface && truth.enter.has_value()));
    CHECK(holds(last.caption, "For a solid ball") == (truth.surface && truth.origin == Location::in));
    on += truth.origin == Location::on;

    if (const Step* s = step_of(walk, "in-range")) {
      before += holds(s->caption, "before it reaches the ball");
      within += holds(s->caption, "ends inside the ball");
      if (holds(s->caption, "before it reaches the ball")) CHECK((!truth.surface && !truth.enter));
      if (holds(s->caption, "ends inside the ball")) CHECK((!truth.surface && truth.enter));
    }
    if (const Step* s = step_of(walk, "coefficient-c"))
      CHECK(holds(s->caption, "exactly on the surface") == (truth.origin == Location::on));
    if (const Step* s = step_of(walk, "first-root")) {
      const bool half = std::get<std::string>(p.at("method")) == "half-b";
      const double a = value(*s, "*A*"), b = value(*s, "*B*"), c = value(*s, "*C*"), four = half ? 1 : 4;
      if (holds(s->caption, "nearly cancel: ")) {
        CHECK((b < 0 && four * a * c <= 0.19 * b * b * (1 + 1e-9)));
        ++cancelled;
      }
      if (holds(s->caption, "point the same way")) CHECK(b > 0);
    }
    if (const Step* s = step_of(walk, "discriminant"))
      CHECK(s->question->choices[s->question->answer] == shown(value(*s, "*Δ*")));
    for (const char* slug : {"real-roots", "passes-by"})
      if (const Step* s = step_of(walk, slug)) {
        CHECK(s->question->answer == truth.line_roots);
        said_of_roots(s->caption, truth.line_roots);
        astray += holds(s->caption, "Rounding decides wrongly");
      }
    const std::string& returns = walk.pseudocode[last.line];
    const bool denied = holds(returns, "MISS") || holds(returns, "REJECT");
    if (last.line >= 0 && denied == truth.surface.has_value()) {
      CHECK(holds(last.caption, "Rounding made this method wrong here: "));
      ++denied_wrongly;
    }
    said_of_misses(last, truth, (ball.center - ray.origin).dot(ray.direction) > 0);
    if (const Step* s = step_of(walk, "coefficient-b")) {
      CHECK(holds(s->caption, "It is negative") == (value(*s, "*B*") < 0));
      CHECK(holds(s->caption, "It is positive") == (value(*s, "*B*") > 0));
    }
    if (const Step* s = step_of(walk, "coefficient-c")) {
      CHECK(s->caption.ends_with("outside.") == (truth.origin == Location::out));
      CHECK(s->caption.ends_with("inside.") == (truth.origin == Location::in));
    }
    for (const auto& [slug, root] : {std::pair{"first-in-range", "*t*_1"}, {"second-in-range", "*t*_2"}})
      if (const Step* s = step_of(walk, slug)) {
        const double t = value(*s, root);
        CHECK(holds(s->caption, "is negative") == (t < 0));
        CHECK(holds(s->caption, "lies beyond") == (t > ray.range.hi));
        CHECK((s->comparison->meaning == "on the ray") == (s->comparison->holds && t <= ray.range.hi));
      }
  });
  CHECK(astray > 5);
  CHECK(denied_wrongly > 5);
  CHECK(before > 5);
  CHECK(within > 0);
  CHECK(cancelled > 5);
  CHECK(on > 5);
}

TEST_CASE("a return of Haines' test tells what its own condition has found, wherever the map places the setting",
          "[ray-sphere]") {
  const Lesson& spheres = lesson("ray-sphere");
  const auto ends_at = [&](const Vec2& place) {
    const Parameters p = spheres.map->moved(preset(spheres, "two-roots").parameters, place);
    const Walk walk = spheres.walk(p);
    const Step& last = walk.steps[outcome(walk)];
    CAPTURE(place.transpose(), last.line, last.caption);
    CHECK(holds(last.caption, "leads away from the ball") == (last.line == 4));
    CHECK(holds(last.caption, "no point in common") == (last.line == 7));
    CHECK(holds(last.verdict.text, "the line passes by") ==
          holds(spheres.map->branches[spheres.map->branch(p)], "no real root"));
    if (last.line == 4 || last.line == 7) {
      CHECK(walk.pseudocode[last.line] == "    return REJECT");
      CHECK(last.verdict.kind == Verdict::Kind::no);
      // The condition above it has just been decided.
      const Step& before = walk.steps[static_cast<std::size_t>(outcome(walk)) - 1];
      CHECK(before.line == last.line - 1);
    }
    return last.line;
  };
  std::map<int, int> ends;
  for (double x = -3.3; x < 2.5; x += 0.37)
    for (double y = 0.03; y < 2.2; y += 0.23) ++ends[ends_at({x, y})];
  CHECK(ends[4] > 10);
  CHECK(ends[7] > 10);
  CHECK(ends_at({1.9, 1.4}) == 4);  // past the ball, and beside it: it was told to have no point in common
  CHECK(ends_at({-1.9, 1.4}) == 7);
}

TEST_CASE("half of B saves three products, as its step says", "[ray-sphere]") {
  const auto products = [](const char* id) {
    return lesson("ray-sphere").walk(preset(lesson("ray-sphere"), id).parameters).steps.back().counters.mul;
  };
  CHECK(products("two-roots-quadratic") - products("two-roots-half-b") == 3);
}

TEST_CASE("methods of ray and sphere that agree say one number, in the unit of the walk", "[ray-sphere]") {
  over_settings(lesson("ray-sphere"), tests::cases(300, 3000), [&](const Parameters& p) {
    const Walk walk = lesson("ray-sphere").walk(p);
    const std::string& verdict = walk.steps[outcome(walk)].verdict.text;
    const auto opinions = lesson("ray-sphere").opinions(p);
    const bool lengths = std::get<std::string>(p.at("method")) == "haines";
    const std::string exact = opinions.front().says, unit = lengths ? " (a length)" : ", in lengths of **d**";
    if (holds(verdict, "hit at ")) CHECK(verdict == "hit at " + exact);
    CHECK((exact == "no hit" || exact.ends_with(unit)));
    for (const Opinion& o : opinions)
      if (o.says == exact || o.says + unit == exact) CHECK(o.agrees);
  });
}

TEST_CASE("a ray and a polygon end with the oracle's verdict, on the line that the method takes", "[ray-polygon]") {
  int notches = 0, hits = 0, parallel = 0, behind = 0, coplanar = 0;
  over_settings(lesson("ray-polygon"), tests::cases(1000, 10000), [&](const Parameters& p) {
    const auto s = lessons::ray_polygon_lesson::setup(p);
    const oracle::RayPolygon truth = oracle::ray_polygon(s.ray, s.ring);
    const Walk walk = lesson("ray-polygon").walk(p);
    const Step& last = walk.steps[outcome(walk)];
    CAPTURE(last.verdict.text, last.caption, s.ray.origin.transpose(), s.ray.direction.transpose());
    REQUIRE(last.verdict.kind == (truth.coplanar                   ? Verdict::Kind::on
                                  : !truth.hit                     ? Verdict::Kind::no
                                  : truth.location == Location::on ? Verdict::Kind::on
                                                                   : Verdict::Kind::yes));
    const bool astray = holds(last.caption, "plain method wrong");
    CHECK(holds(last.caption, "parallel to the plane") == (!astray && truth.parallel && !truth.coplanar));
    const bool in_plane = truth.coplanar && !astray && !s.truth.flat;
    CHECK(holds(last.caption, "an answer of its own: the ray lies in the plane") == in_plane);
    for (const Opinion& o : lesson("ray-polygon").opinions(p))
      if (o.says.starts_with("MISS")) CHECK(holds(o.says, "by choice") == truth.coplanar);
    coplanar += in_plane;
    CHECK(holds(last.caption, "behind it does not count") == (!astray && !truth.parallel && truth.t < 0));
    if (!astray && last.line == 6) CHECK(truth.hit);
    if (!astray && last.line == 7) CHECK((!truth.hit || truth.location == Location::on));
    if (holds(last.caption, "in the notch")) {
      bool in_hull = false;  // in a triangle of corners
      for (std::size_t i = 0; i < s.ring.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          for (std::size_t k = 0; k < j; ++k)
            in_hull |= oracle::ray_polygon(s.ray, {s.ring[i], s.ring[j], s.ring[k]}).hit;
      CHECK((!truth.hit && in_hull));
      ++notches;
    }
    hits += truth.hit, parallel += truth.parallel, behind += !truth.parallel && truth.t < 0;
    if (const Step* plane = step_of(walk, "plane"); plane && !astray)
      CHECK(holds(plane->caption, "lies behind") == (truth.t < 0));
  });
  for (const int seen : {notches, hits, parallel, behind, coplanar}) CHECK(seen > 0);
}

}  // namespace rays_words_test
