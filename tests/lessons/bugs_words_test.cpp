// Programs with one wrong line: each is right where its exercise begins and wrong where the solution says, and on
// settings that nobody chose it errs exactly where the line that is named makes it err. Oracles say where that is.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <regex>
#include <set>
#include <vector>

#include "bench/aabb_aabb/oracle.h"
#include "bench/capsule_capsule/oracle.h"
#include "bench/clip_segment/oracle.h"
#include "bench/half_spaces/oracle.h"
#include "bench/orient2d/oracle.h"
#include "bench/ray_polygon/oracle.h"
#include "bench/ray_triangle/oracle.h"
#include "lessons/aabb_aabb/picture.h"
#include "lessons/capsule_capsule/picture.h"
#include "lessons/clipping/picture.h"
#include "lessons/convex_polygon/picture.h"
#include "lessons/crossings/telling.h"
#include "lessons/culling/picture.h"
#include "lessons/intervals/picture.h"
#include "lessons/obb_obb/picture.h"
#include "lessons/ray_sphere/picture.h"
#include "lessons/ray_triangle/setup.h"
#include "lessons/shared/parameters.h"
#include "lessons/sphere_aabb/picture.h"
#include "lessons/sphere_sphere/picture.h"
#include "lessons/triangle_triangle/picture.h"
#include "tests/lessons/asked_for.h"
#include "tests/lessons/words.h"
#include "viz/text/rich_text.h"
#include "viz/walk/exercise_text.h"

namespace bugs_words_test {
using namespace isect;
using namespace isect::viz;
using oracle::Rational;
using tests::lesson;

namespace {

/// The exercise with a program; null where the lesson has none.
const Exercise* wrong_program(const Lesson& of) {
  const auto found = std::ranges::find_if(of.closing->exercises, [](const Exercise& e) { return !e.program.empty(); });
  return found == of.closing->exercises.end() ? nullptr : &*found;
}

/// A random setting in eighths: in doubles, a program's sums and products are then exact.
Parameters in_eighths(const Lesson& of, bench::Random& random) {
  for (;;) {
    Parameters setting = tests::random_setting(of, random);
    for (auto& [name, value] : setting) {
      if (double* x = std::get_if<double>(&value)) *x = std::round(8 * *x) / 8;
      if (Vec3* v = std::get_if<Vec3>(&value)) *v = Vec3((8 * *v).array().round() / 8);
    }
    try {
      validate(of, setting);
      return setting;
    } catch (const BadInput&) {
    }
  }
}

/// Whether a lesson's program errs in a setting, exactly where `expected(setting)` holds; nothing: either is right.
template <class Expected>
void errs_where(const std::string& id, int how_many, const Expected& expected) {
  const Lesson& of = lesson(id);
  const Exercise& e = *wrong_program(of);
  bench::Random random(bench::stream(tests::seed(), id.c_str()));
  int errors = 0;
  for (int i = 0; i < tests::cases(how_many, 20 * how_many); ++i) {
    const Parameters p = in_eighths(of, random);
    const std::optional<bool> wrong = expected(p);
    if (!wrong) continue;
    std::string told = id;
    for (const auto& [name, value] : p) told += " --set " + name + "=" + to_text(value);
    INFO(told);
    CHECK(e.found(p) == *wrong);
    errors += *wrong;
  }
  CHECK(errors > 0);
}

double number(const Parameters& p, const char* name) { return std::get<double>(p.at(name)); }

using P3 = oracle::Coordinates<3>;
P3 exact(const Vec3& v) { return oracle::rational<double, 3>(v); }
Rational squared(const P3& v) { return oracle::dot(v, v); }

/// Whether a gap shows on some axis if the terms of b's reach may cancel; nothing where rounding may decide.
std::optional<bool> gap_if_terms_cancel(const Obb<double, 3>& a, const Obb<double, 3>& b) {
  using oracle::operator-;
  std::array<P3, 3> of_a, of_b;
  for (std::size_t i = 0; i < 3; ++i)
    of_a[i] = exact(a.axes.col(static_cast<int>(i))), of_b[i] = exact(b.axes.col(static_cast<int>(i)));
  std::vector<P3> axes(of_a.begin(), of_a.end());
  axes.insert(axes.end(), of_b.begin(), of_b.end());
  for (const P3& x : of_a)
    for (const P3& y : of_b) axes.push_back(oracle::cross(x, y));
  const P3 l = exact(b.center) - exact(a.center);
  bool near = false;
  for (const P3& n : axes) {
    const Rational length2 = squared(n);
    if (length2 < Rational(1e-13)) continue;  // of parallel edges
    Rational reach = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Rational along_a = oracle::dot(of_a[i], n), along_b = oracle::dot(of_b[i], n);
      reach += Rational(a.half[static_cast<int>(i)]) * abs(along_a);
      reach += Rational(b.half[static_cast<int>(i)]) * along_b;
    }
    const Rational way = oracle::dot(n, l), gap = abs(way) - reach;
    if (length2 < Rational(1e-11) || gap * gap < Rational(1e-12) * length2)
      near = true;
    else if (gap > 0)
      return true;
  }
  return near ? std::nullopt : std::optional(false);
}

}  // namespace

TEST_CASE("a program errs where its exercise says, is right where it begins, and its correction names a line",
          "[every lesson]") {
  static const std::regex named("^Line ([0-9]+) should read: (.+?)\\. [A-Z].*");
  int programs = 0;
  for (const Lesson* of : those_asked_for())
    for (const Exercise& e : of->closing->exercises) {
      INFO(of->id << ": " << e.prompt);
      CHECK(e.program.empty() == (e.verdicts == nullptr));
      if (e.program.empty()) continue;
      ++programs;
      REQUIRE((e.found && !e.preset.empty() && !e.by.empty()));
      CHECK(solution_head(e) == "Correction");

      Parameters setting = preset(*of, e.preset).parameters;
      const TwoVerdicts first = e.verdicts(setting);
      CHECK((first.program == first.exact && !first.exact.empty()));
      CHECK_FALSE(e.found(setting));
      for (const auto& [name, text] : e.by) set(*of, setting, name, text);
      const TwoVerdicts last = e.verdicts(setting);
      CHECK(e.found(setting));
      CHECK((last.program != last.exact && !last.program.empty() && !last.exact.empty()));
      const std::string told = found_text(e, setting);
      CHECK((tests::says(told, last.program) && tests::says(told, last.exact)));

      std::string lines;
      for (const std::string& line : e.program) lines += line + "\n";
      for (const std::string& verdict : {last.program, last.exact}) CHECK(tests::says(lines, verdict));
      const std::string solution = plain(e.solution);
      std::smatch parts;
      REQUIRE(std::regex_match(solution, parts, named));
      const auto line = static_cast<std::size_t>(std::stoi(parts[1].str()));
      REQUIRE((1 <= line && line <= e.program.size()));
      CHECK(unindented(e.program[line - 1]) != parts[2].str());
      CHECK_FALSE(tests::says(lines, parts[2].str()));
    }
  if (those_asked_for().size() == lessons::all_lessons().size()) CHECK(programs >= 13);
}

TEST_CASE("a program with a wrong line answers in every preset", "[every lesson]") {
  for (const Lesson* of : those_asked_for())
    if (const Exercise* e = wrong_program(*of))
      for (const Preset& p : of->presets) {
        INFO(of->id << ", " << p.id);
        CHECK_NOTHROW(e->found(p.parameters));
        const TwoVerdicts v = e->verdicts(p.parameters);
        CHECK(v.program.empty() == v.exact.empty());  // both where the program does not apply
      }
}

TEST_CASE("the program for two intervals errs where they share a single number", "[words]") {
  errs_where("intervals", 2000, [](const Parameters& p) {
    const double a_min = number(p, "a_min"), a_max = number(p, "a_max"), b_min = number(p, "b_min"),
                 b_max = number(p, "b_max");
    std::set<double> shared;  // the ends of what is shared are ends of a or of b
    for (const double x : {a_min, a_max, b_min, b_max})
      if (a_min <= x && x <= a_max && b_min <= x && x <= b_max) shared.insert(x);
    return shared.size() == 1;
  });
}

TEST_CASE("the program for two boxes errs where b lies beyond a, but a not beyond b", "[words]") {
  errs_where("aabb-aabb", 2000, [](const Parameters& p) {
    const auto s = lessons::aabb_aabb_lesson::setup(p);
    if (empty(s.a) || empty(s.b)) return false;
    return oracle::by_points(s.a, s.b) == Relation::disjoint && (s.a.lo.array() <= s.b.hi.array()).all();
  });
}

TEST_CASE("the program for two balls errs where 2 r_a r_b decides", "[words]") {
  errs_where("sphere-sphere", 2000, [](const Parameters& p) {
    using oracle::operator-;
    const auto s = lessons::sphere_sphere_lesson::setup(p);
    const Rational r_a = s.a.radius, r_b = s.b.radius, d2 = squared(exact(s.b.center) - exact(s.a.center));
    const Rational apart = d2 - r_a * r_a - r_b * r_b;
    return 0 < apart && apart <= 2 * r_a * r_b;
  });
}

TEST_CASE("the program for a ball and a box errs where a gap that is counted again decides", "[words]") {
  errs_where("sphere-aabb", 2000, [](const Parameters& p) {
    const auto s = lessons::sphere_aabb_lesson::setup(p);
    if (empty(s.box)) return false;
    Rational once = 0, again = 0, before = 0;
    for (int i = 0; i < 3; ++i) {
      const Rational c = s.ball.center[i], inside = std::clamp(s.ball.center[i], s.box.lo[i], s.box.hi[i]);
      const Rational gap = abs(Rational(c - inside));
      if (gap != 0) before = gap;
      once += gap * gap, again += before * before;
    }
    const Rational r2 = Rational(s.ball.radius) * Rational(s.ball.radius);
    return once <= r2 && r2 < again;
  });
}

TEST_CASE("the program for a ray and a sphere errs where the ray only leaves the ball", "[words]") {
  errs_where("ray-sphere", 2000, [](const Parameters& p) {
    using oracle::operator-;
    using oracle::operator+;
    using oracle::operator*;
    const auto s = lessons::ray_sphere_lesson::setup(p, false);
    const P3 f = exact(s.ray.origin) - exact(s.sphere.center), d = exact(s.ray.direction);
    const Rational r2 = Rational(s.sphere.radius) * Rational(s.sphere.radius), at_start = squared(f) - r2;
    const bool behind = at_start < 0 || (at_start == 0 && oracle::dot(f, d) > 0);  // the first root
    return behind && (!s.segment() || squared(f + Rational(s.ray.range.hi) * d) >= r2);
  });
}

TEST_CASE("the program for oriented boxes errs where they meet, and terms that cancel leave a gap", "[words]") {
  errs_where("obb-obb", 1000, [](const Parameters& p) -> std::optional<bool> {
    const auto s = lessons::obb_obb_lesson::setup(p);
    return s.truth == Relation::disjoint ? std::optional(false) : gap_if_terms_cancel(s.a, s.b);
  });
}

TEST_CASE("the program for capsules errs where b crosses the line of a beyond its ends", "[words]") {
  errs_where("capsule-capsule", 1000, [](const Parameters& p) -> std::optional<bool> {
    const auto s = lessons::capsule_capsule_lesson::setup(p);
    const Relation truth = oracle::relation(s.a, s.b);
    if (truth == Relation::touching || s.segments()) return {};  // a distance is rounded
    return truth == Relation::disjoint &&
           oracle::orientation(s.a.p, s.a.q, s.b.p) * oracle::orientation(s.a.p, s.a.q, s.b.q) < 0;
  });
}

TEST_CASE("the program that counts crossings errs where an edge's right end misleads it", "[words]") {
  errs_where("crossings", 1000, [](const Parameters& values) {
    const lessons::crossings_lesson::Setup s(values);
    std::vector<std::vector<oracle::P2>> rings;
    int count = 0;
    for (const Ring<double, 2>& ring : s.polygon.rings) {
      rings.emplace_back();
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const auto &a = ring[i], &b = ring[(i + 1) % ring.size()];
        rings.back().push_back(oracle::rational<double, 2>(a));
        const bool straddles = std::min(a.y(), b.y()) <= s.p.y() && s.p.y() < std::max(a.y(), b.y());
        count += straddles && (s.p.x() < a.x() || s.p.x() < b.x());
      }
    }
    const Location truth = oracle::locate(oracle::rational<double, 2>(s.p), rings);
    return truth != Location::on && (count % 2 == 1) != (truth == Location::in);
  });
}

TEST_CASE("the program for a convex polygon errs where the last edge alone rejects the point", "[words]") {
  errs_where("convex-polygon", 1000, [](const Parameters& values) -> std::optional<bool> {
    const int n = std::stoi(std::get<std::string>(values.at("n")));
    if (n > 64) return {};
    const lessons::convex_polygon_lesson::Setup s(n, lessons::flat_point(values, "p"));
    const auto right_of = [&](int i, int j) { return oracle::orientation(s.vertex(i), s.vertex(j), s.p) < 0; };
    bool out = false;
    for (int i = 0; i < n; ++i) out |= right_of(i, i + 1);
    int wedge = 1;  // the last whose first ray does not leave p to the right
    while (wedge + 2 < n && !right_of(0, wedge + 1)) ++wedge;
    return out && !right_of(0, 1) && !right_of(wedge, wedge + 1);
  });
}

TEST_CASE("the program that clips a segment errs where a later exit hides an earlier one", "[words]") {
  errs_where("clipping", 2000, [](const Parameters& p) {
    if (std::get<std::string>(p.at("shape")) == "polygon") return false;
    const Segment<double, 2> s = {lessons::flat_point(p, "p"), lessons::flat_point(p, "q")};
    const auto box = lessons::clipping_lesson::box_of(p);
    if (oracle::clipped(s, box)) return false;
    Rational in = 0, out = 1;
    for (int k = 0; k < 2; ++k)
      for (const int side : {1, -1}) {  // left, right, bottom, top
        const Rational bound = side > 0 ? box.lo[k] : box.hi[k];
        const Rational at_p = side * (Rational(s.p[k]) - bound), at_q = side * (Rational(s.q[k]) - bound);
        if (at_p == at_q && at_p < 0) return false;
        if (at_q > at_p) in = std::max<Rational>(in, at_p / (at_p - at_q));
        if (at_q < at_p) out = at_p / (at_p - at_q);
      }
    return in <= out;
  });
}

TEST_CASE("the program that culls a box errs where a plane leaves some corners outside, and none all", "[words]") {
  errs_where("culling", 1000, [](const Parameters& p) {
    if (std::get<std::string>(p.at("volume")) != "box") return false;
    const Vec3 center = std::get<Vec3>(p.at("p"));
    const double half = number(p, "size");
    const Frustum<double> view = lessons::culling_lesson::frustum(std::get<Vec3>(p.at("eye")));
    bool some = false;
    for (const Plane<double, 3>& plane : view.planes) {
      int outside = 0;
      for (int k = 0; k < 8; ++k) {
        const Vec3 corner = center + half * Vec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
        outside += oracle::height<double, 3>(plane, exact(corner)) < 0;
      }
      if (outside == 8) return false;
      some |= outside > 0;
    }
    return some;
  });
}

TEST_CASE("the program for a ray and a triangle errs in the other half of the parallelogram", "[words]") {
  errs_where("ray-triangle", 2000, [](const Parameters& p) {
    using oracle::operator-;
    const auto s = lessons::ray_triangle_lesson::setup(p);
    const P3 a = exact(s.vertex(0)), n = oracle::cross(exact(s.vertex(1)) - a, exact(s.vertex(2)) - a);
    if (s.seam() || oracle::dot(n, exact(s.ray.direction)) == 0) return false;
    const oracle::RayTriangle truth = oracle::ray_triangle(s.ray, s.triangle);
    return truth.u <= 1 && truth.v <= 1 && truth.u + truth.v > 1 && truth.u >= 0 && truth.v >= 0 &&
           oracle::holds(s.ray.range, truth.t);
  });
}

TEST_CASE("the program for two triangles errs where edges of b alone meet the other one", "[words]") {
  errs_where("triangle-triangle", 300, [](const Parameters& p) -> std::optional<bool> {
    const auto s = lessons::triangle_triangle_lesson::setup(p);
    if (!s.both_have_area()) return {};
    const auto some_edge_meets = [](const Triangle<double, 3>& x, const Triangle<double, 3>& y) {
      const oracle::Sides sides = oracle::sides(y);
      for (std::size_t i = 0; i < 3; ++i)
        if (oracle::part(exact(x.vertices[i]), exact(x.vertices[(i + 1) % 3]), sides)) return true;
      return false;
    };
    return !some_edge_meets(s.a(), s.b()) && some_edge_meets(s.b(), s.a());
  });
}

}  // namespace bugs_words_test
