// Near the surface of a ball two differences cancel. What the lessons say of them, and of what cures which, is held to
// exact numbers.

#include <algorithm>
#include <cmath>

#include <isect/methods/ray_sphere_stable.h>
#include <isect/numbers/exact.h>
#include <isect/ray_sphere.h>
#include "bench/rows.h"
#include "lessons/glossary.h"
#include "lessons/ray_sphere/picture.h"
#include "lessons/ray_sphere/telling.h"
#include "lessons/speed_against_error/results.h"
#include "tests/lessons/words.h"
#include "viz/text/rich_text.h"

namespace cancellation_words_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;
using isect::test::Contains;
using lessons::ray_sphere_lesson::digits_right;

namespace {

const char* const rounded[] = {"near-rounded", "near-rounded-quadratic", "near-rounded-half-b"};
const char* const stable_sentence = "Stable roots take";

/// C of the numbers as given.
double exact_constant(const lessons::ray_sphere_lesson::Setup& s) {
  Exact c = Exact(0) - Exact(s.sphere.radius) * Exact(s.sphere.radius);
  for (int i = 0; i < 3; ++i) {
    const Exact f = Exact(s.ray.origin[i]) - Exact(s.sphere.center[i]);
    c = c + f * f;
  }
  return c.sign() == 0 ? 0 : c.rounded();
}

/// A setting whose origin lies just before the surface, at 10^-k radii.
Parameters just_before(Parameters p, int k, const char* method) {
  p["method"] = std::string(method);
  p["extent"] = std::string("ray");
  const Vec3 d = std::get<Vec3>(p["direction"]).normalized();
  p["origin"] = Vec3(std::get<Vec3>(p["center"]) - d * (1 + std::pow(10, -k)) * std::get<double>(p["radius"]));
  return p;
}

/// Checks what a walk by a quadratic says of C and of stable roots; returns whether it says that C is what they lack.
bool said_of_cures(const Parameters& p, const Walk& walk) {
  const auto s = lessons::ray_sphere_lesson::setup(p, false);
  const Step& constant = *find(walk, "coefficient-c");
  const double c = value(constant, "*C*"), exact = exact_constant(s);
  const bool told = says(constant.caption, "nearly cancel: ");
  INFO(constant.caption);
  if (told) CHECK(digits_right(c, exact) < 10);
  if (exact != 0 && std::abs(exact) < 1e-3 * s.sphere.radius * s.sphere.radius)
    CHECK(told == (digits_right(c, exact) < 10));

  const auto stable = ray_sphere::stable_roots(s.ray, s.sphere);
  const Step* const first = find(walk, "first-root");
  const bool hit_first = s.truth.surface && *s.truth.surface == s.truth.roots.lo && s.truth.line_roots == 2;
  if (first && hit_first && stable && says(first->caption, stable_sentence)) {
    const int kept = digits_right(*stable, *s.truth.surface);
    INFO(first->caption << " " << kept);
    if (says(first->caption, "that root keeps them, too")) CHECK((kept >= 10 && !told));
    if (says(first->caption, "do not bring back")) CHECK(kept < 10);
  }
  const Step* const lack = find(walk, "stable-root");
  if (!lack) return false;
  CHECK(told);
  CHECK(value(*lack, "*C*, exact") == exact);
  const bool of_first = says(lack->caption, "By stable roots *t*_1 = ");
  const double truth = of_first ? s.truth.roots.lo : s.truth.roots.hi;
  CHECK(digits_right(value(*lack, of_first ? "stable *t*_1" : "stable *t*_2"), truth) < 10);
  CHECK(digits_right(value(*lack, of_first ? "*t*_1, exact *C*" : "*t*_2, exact *C*"), truth) >= 10);
  return true;
}

}  // namespace

TEST_CASE("where C itself has cancelled, no method in doubles keeps the digits, and the exact answer does", "[words]") {
  for (const char* id : rounded) {
    INFO(id);
    const Parameters& p = preset(lesson("ray-sphere"), id).parameters;
    const std::vector<Opinion> all = lesson("ray-sphere").opinions(p);
    CHECK(all.front().method == "exact");
    CHECK(all.size() == 6);
    for (const Opinion& o : all) {
      CAPTURE(o.method, o.says);
      CHECK(o.agrees == (o.method == "exact"));
    }
    const auto s = lessons::ray_sphere_lesson::setup(p, false);
    const double a = s.ray.direction.squaredNorm(), b = (s.ray.origin - s.sphere.center).dot(s.ray.direction);
    const double t = *s.truth.surface;
    CHECK(digits_right(exact_constant(s) / (-b + std::sqrt(b * b - a * exact_constant(s))), t) >= 14);
  }
}

TEST_CASE("the walk names both cancellations, and which of them stable roots cure", "[words]") {
  for (const char* id : {"near-rounded-quadratic", "near-rounded-half-b"}) {
    INFO(id);
    const Walk walk = walk_of("ray-sphere", id);
    CHECK_THAT(plain(find(walk, "coefficient-c")->caption),
               Contains("f · f and r² nearly cancel: 4 digits of C are right."));
    CHECK_THAT(find(walk, "first-root")->caption, Contains("nearly cancel: ") && !Contains("that root keeps them"));
    REQUIRE(find(walk, "stable-root"));
    CHECK_THAT(plain(find(walk, "stable-root")->caption),
               Contains("so 4 digits are right. With the exact C the same quotient has 1"));
  }
  for (const char* id : {"near-surface-quadratic", "near-surface-half-b"}) {
    INFO(id);
    const Walk walk = walk_of("ray-sphere", id);
    CHECK_THAT(find(walk, "coefficient-c")->caption, !Contains("nearly cancel"));
    CHECK_THAT(find(walk, "first-root")->caption, Contains("*C* has kept its digits here"));
    CHECK(find(walk, "stable-root") == nullptr);
  }
}

TEST_CASE("what is said of C and of stable roots is true of their numbers, however near the surface", "[words]") {
  int lacking = 0, all = 0;
  const auto check = [&](const Parameters& p) {
    ++all;
    lacking += said_of_cures(p, lesson("ray-sphere").walk(p));
  };
  on_random_settings("ray-sphere", 150, [&](const Parameters& p, const Walk&) {
    if (!(std::get<double>(p.at("radius")) > 0.01)) return;
    for (const char* method : {"quadratic", "half-b"})
      for (const int k : {2, 5, 8, 11, 14}) check(just_before(p, k, method));
  });
  CHECK(lacking > 50);
  CHECK(lacking < all);
}

TEST_CASE(
    "the lesson's exercise and card, the glossary and the measurements do not promise what stable roots do not do",
    "[words]") {
  const Closing& card = *lesson("ray-sphere").closing;
  const auto exercise = std::ranges::find_if(
      card.exercises, [](const Exercise& e) { return e.prompt.starts_with("When does the entry root lose digits"); });
  REQUIRE(exercise != card.exercises.end());
  CHECK(exercise->preset == "near-rounded-quadratic");
  CHECK_THAT(exercise->solution, Contains("They do not cure *C*") && Contains("exactly"));
  CHECK_THAT(card.choose, Contains("Near the surface neither is better than *C*"));
  const auto term = std::ranges::find(lessons::glossary(), std::string("stable roots"), &lessons::Term::name);
  CHECK_THAT(term->meaning, Contains("as accurate as *C* is"));
  CHECK_THAT(lesson("speed-against-error").closing->choose, Contains("stable roots, unless rays start close"));
}

TEST_CASE("a family on which no rounded method does ten times better than the naive one is told as that", "[words]") {
  const bench::Report& report = lessons::speed_against_error_lesson::results();
  int hopeless = 0, mended = 0;
  for (const Step& s : walk_of("speed-against-error", "ray-sphere").steps)
    for (const char* family : {"near-tangent", "far-small", "planet"}) {
      if (s.slug != family) continue;
      double naive = 0, best = INFINITY;
      for (const bench::Row* r : bench::rows_of(report, "ray-sphere", "double", family)) {
        if (r->exact || !r->ulps) continue;
        if (r->standard) naive = r->ulps->p99;
        if (!r->standard) best = std::min(best, r->ulps->p99);
      }
      INFO(s.caption << " " << best << " of " << naive);
      const bool none = best >= naive / 10;
      CHECK(says(s.caption, "No other rounded method does ten times better") == none);
      if (none) CHECK_THAT(s.caption, Contains("the best, errs by " + shown(best) + " ulp."));
      CHECK(says(s.caption, "Stable roots cure one cancellation") == (std::string(family) == "planet"));
      ++(none ? hopeless : mended);
    }
  CHECK((hopeless > 0 && mended > 0));
}

}  // namespace cancellation_words_test
