// What the lessons of collision, clipping and culling say, in words, is what plain tests of their own say.

#include <algorithm>
#include <cmath>

#include <isect/orient.h>
#include "lessons/clipping/picture.h"
#include "lessons/collision/telling.h"
#include "lessons/culling/picture.h"
#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/lessons/random_settings.h"
#include "tests/lessons/words.h"
#include "tests/settings.h"
#include "viz/player/reader_state.h"
#include "viz/walk/closing.h"

namespace uses_words_test {
using namespace isect;
using namespace isect::viz;

namespace {

const Lesson& lesson(const char* id) { return lesson_named(lessons::all_lessons(), id); }
bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
std::string text_of(const Parameters& p, const char* name) { return std::get<std::string>(p.at(name)); }
Vec3 vector(const Parameters& p, const char* name) { return std::get<Vec3>(p.at(name)); }
Point<double, 2> at(const Parameters& p, const char* name) { return vector(p, name).head<2>(); }

const Step* step_of(const Walk& walk, const char* slug) {
  for (const Step& s : walk.steps)
    if (s.slug == slug) return &s;
  return nullptr;
}

template <class Look>
void over_settings(const Lesson& l, int how_many, const Look& look) {
  bench::Random random(bench::stream(tests::seed(), (l.id + " in words").c_str()));
  for (const Preset& p : l.presets) look(p.parameters);
  for (int i = 0; i < how_many; ++i) look(tests::random_setting(l, random));
}

/// Decides by separating axes: x, y and the segment's normal.
bool meets_box(const Aabb<double, 2>& box, const Point<double, 2>& p, const Point<double, 2>& q) {
  for (int i = 0; i < 2; ++i)
    if (std::max(p[i], q[i]) < box.lo[i] || std::min(p[i], q[i]) > box.hi[i]) return false;
  int least = 1, greatest = -1;
  for (const Point<double, 2>& c : {box.lo, {box.hi.x(), box.lo.y()}, box.hi, {box.lo.x(), box.hi.y()}}) {
    const int side = p == q ? 0 : orient2d(p, q, c);
    least = std::min(least, side), greatest = std::max(greatest, side);
  }
  return least <= 0 && greatest >= 0;
}

}  // namespace

TEST_CASE("a part is kept where segment or polygon and box share a point, and nowhere else", "[clipping lesson]") {
  int kept = 0, trivial = 0, corners = 0, polygons = 0;
  over_settings(lesson("clipping"), tests::cases(1000, 10000), [&](const Parameters& p) {
    const Walk walk = lesson("clipping").walk(p);
    const Aabb<double, 2> box = lessons::clipping_lesson::box_of(p);
    const Step& last = walk.steps[outcome(walk)];
    CAPTURE(last.verdict.text, last.caption, at(p, "p").transpose(), at(p, "q").transpose(), at(p, "r").transpose(),
            at(p, "s").transpose());
    CHECK(holds(last.verdict.text, "nothing is kept") == (last.verdict.kind == Verdict::Kind::no));
    if (text_of(p, "shape") != "polygon") {
      const bool meet = meets_box(box, at(p, "p"), at(p, "q"));
      CHECK((last.verdict.kind != Verdict::Kind::no) == meet);
      if (text_of(p, "shape") == "slabs") return;
      kept += meet;
      const bool beyond = tests::own_step(walk, 0).line == 2;
      trivial += beyond;
      bool one_side = false;
      for (int i = 0; i < 2; ++i)
        one_side = one_side || std::max(at(p, "p")[i], at(p, "q")[i]) < box.lo[i] ||
                   std::min(at(p, "p")[i], at(p, "q")[i]) > box.hi[i];
      CHECK(beyond == one_side);
      const bool corner = holds(last.caption, "passes a corner");
      if (corner) CHECK((!meet && !one_side));
      corners += corner;
      return;
    }
    const char* const names[] = {"p", "q", "r", "s"};
    bool meet = false, odd = false;
    for (int i = 0; i < 4; ++i) {
      const Point<double, 2> a = at(p, names[i]), b = at(p, names[(i + 1) % 4]);
      meet = meet || meets_box(box, a, b);
      if ((a.y() <= box.lo.y()) != (b.y() <= box.lo.y()))  // the edge passes the height of the box's corner
        odd = odd != ((orient2d(a, b, box.lo) > 0) == (b.y() > a.y()));
    }
    CHECK((last.verdict.kind != Verdict::Kind::no) == (meet || odd));
    ++polygons;
  });
  for (const int seen : {kept, trivial, corners, polygons}) CHECK(seen > 5);
}

TEST_CASE("pairs of boxes are counted as two loops count them", "[collision lesson]") {
  over_settings(lesson("collision"), tests::cases(300, 3000), [&](const Parameters& p) {
    if (text_of(p, "method") == "motion") return;
    const auto boxes = lessons::collision_lesson::few(p);
    int found = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i)
      for (std::size_t j = i + 1; j < boxes.size(); ++j)
        found += ((boxes[i].lo.array() <= boxes[j].hi.array()) && (boxes[j].lo.array() <= boxes[i].hi.array())).all();
    const Walk walk = lesson("collision").walk(p);
    CHECK(walk.steps[outcome(walk)].verdict.text.starts_with(std::to_string(found) +
                                                             (found == 1 ? " pair," : " pairs,")));
  });
}

TEST_CASE("a moving box tunnels only with a step longer than wall and box, and is told so", "[collision lesson]") {
  int tunnels = 0, never = 0, until_the_end = 0, seen_too = 0;
  over_settings(lesson("collision"), tests::cases(1000, 10000), [&](Parameters p) {
    p["method"] = std::string("motion");
    const double v = std::get<double>(p.at("speed")), x = vector(p, "p").x(), y = vector(p, "p").y();
    const Walk walk = lesson("collision").walk(p);
    const Step& last = walk.steps[outcome(walk)];
    CAPTURE(v, x, y, last.verdict.text, last.caption);
    // when the middle of the box is within half the box of the wall; beside a boundary rounding may decide
    const bool level = std::abs(y) <= 2;
    const double from = 0.15 - x, to = 0.85 - x;  // the way to the first and to the last contact
    const auto clear = [](double a, double b) { return std::abs(a - b) > 1e-9; };
    if (!clear(std::abs(y), 2) || !clear(from, 1.5 * v) || !clear(to, 0) || !clear(from, 0) || !clear(to, 1.5 * v))
      return;
    const bool meet = level && from <= 1.5 * v && to >= 0;
    REQUIRE((last.verdict.kind == Verdict::Kind::yes) == meet);
    bool seen = false;
    for (int k = 0; k <= 6; ++k) {
      if (!clear(0.25 * k * v, from) || !clear(0.25 * k * v, to)) return;
      seen = seen || (level && from <= 0.25 * k * v && 0.25 * k * v <= to);
    }
    CHECK(holds(last.caption, "tunnelled") == (meet && !seen));
    if (holds(last.caption, "tunnelled")) CHECK(0.25 * v > 0.7);
    if (clear(0.25 * v, 0.7)) CHECK(holds(tests::own_step(walk, 0).caption, "can jump") == (0.25 * v > 0.7));
    for (const Step& s : walk.steps) {
      if (!s.slug.starts_with("time-")) continue;
      const double now = v * s.values.back().value, before = from - now, after = now - to;
      if (!clear(before, 0) || !clear(after, 0)) continue;
      CHECK(holds(s.caption, "have common points") == (level && before < 0 && after < 0));
      CHECK(holds(s.caption, "before the wall") == (before > 0));
      CHECK(holds(s.caption, "beyond the wall") == (after > 0));
    }
    CHECK(holds(last.verdict.text, "until the motion ends") == (meet && to > 1.5 * v));
    CHECK((last.line == 4) == !meet);
    tunnels += meet && !seen, never += !meet, until_the_end += meet && to > 1.5 * v, seen_too += seen;
  });
  for (const int count : {tunnels, never, until_the_end, seen_too}) CHECK(count > 10);
}

TEST_CASE("the moving box is drawn at any time of its flight, and at its contact it touches the wall",
          "[collision lesson]") {
  const Walk walk = lesson("collision").walk(preset(lesson("collision"), "tunnelling").parameters);
  const Scene::Time& time = *step_of(walk, "motion")->scene.time;
  CHECK((time.lo == 0 && time.hi == 1.5 && !time.contact));
  const auto right_of_box = [&](double t) {
    double right = -1e9;
    for (const Item& item : time.at(t).items)
      if (const Region* box = std::get_if<Region>(&item); box && box->role == Role::first) right = box->rings[0][1].x();
    return right;
  };
  CHECK(right_of_box(0) == -2.25);
  CHECK(right_of_box(1) == 2.75);
  for (const Step& step : walk.steps) {
    if (step.scene.chart) continue;
    REQUIRE(step.scene.time);
    if (step.slug.starts_with("time-")) CHECK(step.scene.time->now == step.values.back().value);
    CHECK(step.scene.time->contact.has_value() == (step.slug == "ray"));
  }
  const double contact = *step_of(walk, "ray")->scene.time->contact;
  CHECK(right_of_box(contact) == Approx(0.4));
  CHECK(right_of_box(0.9 * contact) < 0.4);

  Parameters rests = preset(lesson("collision"), "tunnelling").parameters;
  rests["speed"] = 0.0;
  CHECK_FALSE(has_time(lesson("collision").walk(rests)));
  CHECK_FALSE(has_time(lesson("collision").walk(preset(lesson("collision"), "sweep").parameters)));
}

TEST_CASE("a false positive of culling is called one where box and frustum are apart, and nowhere else",
          "[culling lesson]") {
  namespace own = lessons::culling_lesson;
  int false_positives = 0;
  const auto look = [&](Parameters p) {
    p["volume"] = std::string("box");
    const Vec3 half = Vec3::Constant(std::get<double>(p.at("size"))), middle = vector(p, "p");
    const own::Box asked = {middle - half, middle + half};
    const auto view = own::frustum(vector(p, "eye"));
    const Culling truth = cull(asked, view);
    const bool apart = truth == Culling::crossing && !own::meet(asked, view);
    const Walk walk = lesson("culling").walk(p);
    const Step& last = walk.steps[outcome(walk)];
    CAPTURE(last.caption, middle.transpose(), half.x());
    CHECK(holds(last.caption, "False positive") == apart);
    CHECK(last.verdict.text.starts_with(truth == Culling::inside    ? "inside"
                                        : truth == Culling::outside ? "outside"
                                                                    : "crossing"));
    for (int i = 0; i < 6; ++i) {  // the corner that the signs of n choose is the furthest of all eight
      const Step* step = step_of(walk, (std::string("plane-") + own::plane_names[i]).c_str());
      if (!step) continue;
      double greatest = -1e300;
      for (int corner = 0; corner < 8; ++corner) {
        Vec3 x;
        for (int axis = 0; axis < 3; ++axis) x[axis] = (corner >> axis & 1 ? asked.hi : asked.lo)[axis];
        greatest = std::max(greatest, view.planes[i].normal.dot(x) + view.planes[i].d);
      }
      for (const Value& value : step->values)
        if (value.name == "**n** · p-vertex + *D*")
          CHECK(value.value == Approx(greatest / view.planes[i].normal.norm()).margin(1e-9));
    }
    false_positives += apart;
  };
  over_settings(lesson("culling"), tests::cases(500, 5000), look);
  bench::Random random(bench::stream(tests::seed(), "beside an edge"));
  for (int i = 0; i < tests::cases(500, 5000); ++i) {
    Parameters p = preset(lesson("culling"), "beyond-an-edge").parameters;
    for (int axis = 0; axis < 3; ++axis) std::get<Vec3>(p["p"])[axis] += random.uniform(-0.25, 0.25);
    look(p);
  }
  CHECK(false_positives > 20);
}

}  // namespace uses_words_test
