// What the lessons on points in polygons say, on random settings: verdicts, counts and branches, against an exact
// count of crossings in rationals.

#include <algorithm>
#include <bit>

#include <isect/methods/point_convex_polygon.h>
#include <isect/methods/point_polygon.h>
#include "bench/rational.h"
#include "lessons/concave_polygon/map_picture.h"
#include "lessons/convex_polygon/picture.h"
#include "lessons/crossings/situations.h"
#include "tests/lessons/words.h"
#include "tests/viz/drawn.h"
#include "tests/viz/pixels.h"
#include "viz/compose/compose.h"
#include "viz/text/rich_text.h"

namespace polygon_words_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;
using isect::test::Contains;
using Rings = std::vector<Ring<double, 2>>;

namespace {

/// The sign of the turn a, b, p in rationals.
int turn(const Point<double, 2>& a, const Point<double, 2>& b, const Point<double, 2>& p) {
  const auto ra = oracle::rational(a), rb = oracle::rational(b), rp = oracle::rational(p);
  return oracle::sign((rb[0] - ra[0]) * (rp[1] - ra[1]) - (rb[1] - ra[1]) * (rp[0] - ra[0]));
}

struct Truth {
  Location location = Location::out;
  int crossings = 0;
  int closed = 0;  ///< edges with a point on the ray right of p, without horizontal ones
};

/// The truth edge by edge: which edges a ray just above the point crosses, and which hold the point.
Truth truth_of(const Point<double, 2>& p, const Rings& rings) {
  Truth truth;
  bool on = false;
  for (const Ring<double, 2>& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point<double, 2>&a = ring[i], &b = ring[(i + 1) % ring.size()];
      const auto [low, high] = a.y() <= b.y() ? std::pair(a, b) : std::pair(b, a);
      const int side = turn(low, high, p);  // 1: p is left of it
      const bool level = a.y() == b.y();
      on = on || (side == 0 && (p - a).dot(p - b) <= 0);
      truth.crossings += low.y() <= p.y() && p.y() < high.y() && side > 0;
      truth.closed += !level && low.y() <= p.y() && p.y() <= high.y() && side > 0;
    }
  truth.location = on ? Location::on : truth.crossings % 2 != 0 ? Location::in : Location::out;
  return truth;
}

/// Moves the corners that the setting moves, counted over all rings.
void move(const Parameters& setting, Rings& rings) {
  int i = 0;
  for (Ring<double, 2>& ring : rings)
    for (Point<double, 2>& corner : ring)
      if (const auto moved = setting.find("v" + std::to_string(i++)); moved != setting.end())
        corner = std::get<Vec3>(moved->second).head<2>();
}

/// Whether no two edges have more in common than the end where one leads on to the other, by turns in rationals.
bool is_simple(const Ring<double, 2>& ring) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const Point<double, 2>&a = ring[i], &b = ring[(i + 1) % n], &c = ring[j], &d = ring[(j + 1) % n];
      if (j == i + 1 || (i == 0 && j == n - 1)) {  // neighbours: does one run back on the other?
        const Point<double, 2>&tip = j == i + 1 ? b : a, &from = j == i + 1 ? a : b, &to = j == i + 1 ? d : c;
        if (turn(from, tip, to) == 0 && (from - tip).dot(to - tip) > 0) return false;
      } else if (turn(a, b, c) * turn(a, b, d) <= 0 && turn(c, d, a) * turn(c, d, b) <= 0) {
        return false;
      }
    }
  return true;
}

/// The polygon's area alone, filled as in the lesson's first step.
Picture area_of(const Scene& scene, const View& view) {
  Scene polygon;
  for (const Item& item : scene.items)  // the polygon comes first, before cells of what was prepared
    if (std::holds_alternative<Region>(item) && polygon.items.empty()) polygon.items.push_back(item);
  const Theme style = theme(ThemeName::screen, view.width(), view.height());
  Drawing drawing{view.width(), view.height(), style.background, {}};
  for (const Fill& fill : all<Fill>(compose(polygon, view, style).shapes))
    if (fill.colour == style.tint(Role::second)) drawing.shapes.emplace_back(fill);
  REQUIRE(drawing.shapes.size() == 1);
  return offscreen().render(drawing);
}

Verdict::Kind kind_of(Location l) {
  return l == Location::in ? Verdict::Kind::yes : l == Location::on ? Verdict::Kind::on : Verdict::Kind::no;
}

}  // namespace

TEST_CASE("crossings are counted as they are in rationals, by either rule", "[words]") {
  int wrong = 0;
  on_random_settings("crossings", 1000, [&](const Parameters& setting, const Walk& walk) {
    Rings rings = lessons::crossings_lesson::situation(text(setting, "polygon")).polygon.rings;
    move(setting, rings);
    const Truth truth = truth_of(point(setting), rings);
    CHECK(says(walk.steps[0].caption, "(Jordan curve theorem)") == (rings.size() == 1 && is_simple(rings[0])));
    const Step& last = ending(walk);
    const int counting = static_cast<int>(std::ranges::count_if(walk.steps, [&](const Step& step) {
      return step.slug.starts_with("edge-") && walk.pseudocode[step.line].find("count + 1") != std::string::npos;
    }));
    if (text(setting, "rule") == "half-open") {
      CHECK(last.verdict.kind == kind_of(truth.location));
      if (truth.location == Location::on) return;
      CHECK(value(last, "count") == truth.crossings);
      CHECK(counting == truth.crossings);
      const bool rules_agree = says(last.caption, "0, 1 or −1");
      CHECK(rules_agree == (rings.size() == 1 && is_simple(rings[0])));
      if (rules_agree) CHECK(std::abs(value(last, "winding number")) == truth.crossings % 2);
      CHECK_THAT(walk.pseudocode[last.line], Contains(truth.location == Location::in ? "IN" : "OUT"));
      return;
    }
    CHECK(value(last, "count") == truth.closed);
    CHECK(counting == truth.closed);
    CHECK_THAT(walk.pseudocode[last.line], Contains(truth.closed % 2 != 0 ? "IN" : "OUT"));
    const bool on = truth.location == Location::on, right = truth.closed % 2 == truth.crossings % 2;
    wrong += !on && !right;
    CHECK(says(last.verdict.text, "Wrong") == (!on && !right));
    CHECK(says(last.caption, "The answer is right: this count") == (!on && truth.closed == truth.crossings));
    CHECK(says(last.caption, "The answer is right, but not the count") ==
          (!on && right && truth.closed != truth.crossings));
    CHECK((last.verdict.kind == Verdict::Kind::on) == on);
  });
  CHECK(wrong > 10);
}

TEST_CASE("a polygon is filled where the verdict is IN, and nowhere else", "[words]") {
  for (const char* const id : {"crossings", "concave-polygon", "convex-polygon"})
    for (const Preset& preset : lesson(id).presets) {
      if (preset.id.ends_with("-closed")) continue;  // a rule that errs
      INFO(id << " " << preset.id);
      const Scene scene = lesson(id).walk(preset.parameters).steps.front().scene;
      const View view(frame(opening(lesson(id)), {&scene}, 1.6), 480, 300);
      const Picture picture = area_of(scene, view);
      int in = 0, out = 0;
      for (double y = 6.5; y < 300; y += 24)
        for (double x = 6.5; x < 480; x += 24) {
          const int column = static_cast<int>(x), row = static_cast<int>(y);
          const double here = ink(picture, column, row);
          bool plain = true;  // no edge is near
          for (int i = -2; i <= 2; ++i)
            for (int k = -2; k <= 2; ++k) plain = plain && ink(picture, column + i, row + k) == here;
          if (!plain) continue;
          Parameters setting = preset.parameters;
          setting["p"] = Vec3(view.on_facing_plane({x, y}, Vec3::Zero()));
          const Verdict::Kind kind = ending(lesson(id).walk(setting)).verdict.kind;
          INFO(to_text(setting["p"]));
          CHECK(kind == (here > 0 ? Verdict::Kind::yes : Verdict::Kind::no));
          ++(here > 0 ? in : out);
        }
      CHECK(in > 5);
      CHECK(out > 5);
    }
  // Where a pentagram winds twice round its middle, even-odd has a hole.
  const Scene scene = walk_of("crossings", "pentagram").steps.front().scene;
  const View view(frame(opening(lesson("crossings")), {&scene}, 1.6), 480, 300);
  const Vec2 p = view.project(Vec3(std::get<Vec3>(preset(lesson("crossings"), "pentagram").parameters.at("p")))).at;
  CHECK(ink(area_of(scene, view), static_cast<int>(p.x()), static_cast<int>(p.y())) == 0);
  CHECK(ending(walk_of("crossings", "pentagram")).verdict.kind == Verdict::Kind::no);
}

TEST_CASE("where a graze is counted twice, the closed rule is said to be right as the error is even", "[words]") {
  const Walk walk = walk_of("crossings", "grazed-none-closed");
  const Step& last = ending(walk);
  CHECK(value(last, "count") == 3);
  CHECK_THAT(last.caption, Contains("which should be 1") && Contains("Its error is even here"));
}

TEST_CASE("Jordan's theorem is cited for simple closed curves only", "[words]") {
  for (const auto& s : lessons::crossings_lesson::situations()) {
    INFO(s.id);
    const bool simple = s.polygon.rings.size() == 1 && is_simple(s.polygon.rings[0]);
    const Walk walk = walk_of("crossings", s.id);
    CHECK(says(walk.steps[0].caption, "(Jordan curve theorem)") == simple);
  }
}

TEST_CASE("the fan rejects, accepts and counts its orientations as said", "[words]") {
  on_random_settings("convex-polygon", 1000, [&](const Parameters& setting, const Walk& walk) {
    if (text(setting, "n").size() > 2) return;  // the presets have their own tests
    const lessons::convex_polygon_lesson::Setup s(std::stoi(text(setting, "n")), point(setting));
    const Location truth = truth_of(s.p, {s.polygon.vertices}).location;
    const Step& last = ending(walk);
    if (text(setting, "method") == "centroid") {
      const bool in = point_convex_polygon::wedge_naive(s.p, s.polygon);
      CHECK_THAT(walk.pseudocode[last.line], Contains(in ? "IN" : "OUT"));
      const bool wrong = truth != Location::on && in != (truth == Location::in);
      CHECK(says(last.verdict.text, "wrong") == wrong);
      return;
    }
    using namespace point_convex_polygon;
    Record<Event> record;
    locate(s.p, s.polygon, record);
    int turns = 0;
    for (const Event& e : record.events)
      turns += std::holds_alternative<Fan>(e) ? 2 : std::holds_alternative<Fallback>(e) ? 0 : 1;
    CHECK(value(last, "orientations") == turns);
    CHECK_THAT(last.caption, Contains("took " + std::to_string(turns) + " orientations"));
    const int bisections = static_cast<int>(std::ceil(std::log2(s.size() - 2.0)));
    CHECK(turns <= 3 + 3 * bisections);
    CHECK_THAT(last.formula, Contains("= " + std::to_string(3 + 3 * bisections)));
    CHECK(last.verdict.kind == kind_of(truth));
    CHECK(says(walk.pseudocode[last.line], "OUT") == (truth == Location::out));
    CHECK(says(last.caption, "exactly zero") == (truth == Location::on));
    for (const Step& step : walk.steps) {  // the side of a ray, as its title and its caption say
      if (!step.slug.starts_with("bisect-")) continue;
      const int mid = std::stoi(step.title.substr(step.title.find("_{") + 2));
      const bool after = step.title.find("after") != std::string::npos;
      CHECK(after == (turn(s.vertex(0), s.vertex(mid), s.p) >= 0));
    }
  });
}

TEST_CASE("slabs, trapezoids and triangles end with the exact location, and keep what is said", "[words]") {
  on_random_settings("concave-polygon", 300, [&](const Parameters& setting, const Walk& walk) {
    const lessons::concave_polygon_lesson::Setup s(setting);
    Parameters unmoved = setting;
    std::erase_if(unmoved, [](const auto& p) { return p.first[0] == 'v'; });
    Rings rings = {lessons::concave_polygon_lesson::Setup(unmoved).ring};
    move(setting, rings);
    CHECK(s.ring == rings[0]);
    const Location truth = truth_of(s.p, rings).location;
    const Step& last = ending(walk);
    CHECK(last.verdict.kind == kind_of(truth));
    CHECK(last.verdict.text == lessons::verdict_text(truth));
    const int n = s.size();
    if (const Step* store = find(walk, "store")) {
      CHECK(value(*store, "edges in slabs") <= n * n / 2);
      CHECK(answer(*store) == shown(value(*store, "edges in slabs")));
    }
    if (const Step* map = find(walk, "map")) {
      CHECK(value(*map, "trapezoids") == 2 * n + 1);
      CHECK(answer(*map) == std::to_string(2 * n + 1));
    }
    if (const Step* holes = find(walk, "holes")) {
      const Step* removed = find(walk, "removed");
      const double gone = std::stod(plain(removed->title));
      CHECK(value(*holes, "triangles") == value(*removed, "triangles") - 2 * gone);
    }
    if (const Step* slab = find(walk, "slab")) {
      const bool beyond = std::ranges::all_of(s.ring, [&](const auto& v) { return v.y() > s.p.y(); }) ||
                          std::ranges::all_of(s.ring, [&](const auto& v) { return v.y() < s.p.y(); });
      CHECK(says(slab->caption, "below or above all vertices") == beyond);
    }
  });
}

}  // namespace polygon_words_test
