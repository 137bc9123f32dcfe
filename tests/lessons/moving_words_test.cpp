// What the lesson of moving bodies says in the end, in words and numbers, is what rational arithmetic says.

#include <algorithm>
#include <set>

#include <isect/aabb_aabb.h>
#include <isect/sphere_sphere.h>
#include "tests/catch.h"
#include "tests/lessons/moving_oracle.h"
#include "viz/text/rich_text.h"

namespace moving_words_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;
using namespace isect::tests::moving;
using isect::test::Contains;

namespace {

/// The two bodies of a scene: what is filled.
struct Bodies {
  std::vector<Aabb<double, 2>> boxes;
  std::vector<Sphere<double, 2>> balls;

  explicit Bodies(const Scene& scene) {
    for (const Item& item : scene.items) {
      if (const Region* box = std::get_if<Region>(&item))
        boxes.push_back({box->rings[0][0].head<2>(), box->rings[0][2].head<2>()});
      if (const Circle* ball = std::get_if<Circle>(&item); ball && ball->filled)
        balls.push_back({ball->center.head<2>(), ball->radius});
    }
  }
  bool both() const { return boxes.size() == 2 || balls.size() == 2; }
  Relation relation() const { return boxes.size() == 2 ? relate(boxes[0], boxes[1]) : relate(balls[0], balls[1]); }
  /// How far apart they are, along an axis or the line of centres; < 0: they overlap.
  double gap() const {
    if (balls.size() == 2) return (balls[0].center - balls[1].center).norm() - balls[0].radius - balls[1].radius;
    return std::max((boxes[1].lo - boxes[0].hi).maxCoeff(), (boxes[0].lo - boxes[1].hi).maxCoeff());
  }
};

}  // namespace

TEST_CASE("two moving bodies meet, and first do so, when rationals say so", "[words]") {
  std::set<std::string> seen;
  over_settings("", 400, [&](const Parameters& p, const Walk& walk) {
    const bool met = meet(p, number(p, "duration")), later = meet(p, long_after);
    const Step& last = ending(walk);
    const std::string told = plain(last.verdict.text);
    CAPTURE(told, last.caption);
    if (says(told, "within ε, but they do not meet")) {
      CHECK_FALSE(met);
      CHECK(last.verdict.kind == Verdict::Kind::on);
      seen.insert("near");
      return;
    }
    CHECK((last.verdict.kind != Verdict::Kind::no) == met);
    CHECK(says(told, "do not meet") == !met);
    CHECK(says(told, "do not meet by t") == (!met && later));
    if (!met) seen.insert(later ? "late" : "no");
    if (!met) return;
    const double first = first_contact_of(p);
    CHECK(shows(told, first));
    CHECK(told.ends_with("at t = 0") == (first == 0));
    const bool grazing = are_balls(p) && first > 0 && Balls(p).discriminant() == 0;
    if (are_balls(p)) CHECK(says(told, "they touch at") == (grazing || Balls(p).c == 0));
    seen.insert(grazing ? "grazing" : first == 0 ? "at once" : "met");
  });
  for (const char* outcome : {"near", "late", "no", "grazing", "at once", "met"}) {
    INFO(outcome);
    CHECK(seen.contains(outcome));
  }
}

TEST_CASE("b moves with the difference of the velocities, and the question accepts no other", "[words]") {
  int asked = 0;
  over_settings("", 100, [&](const Parameters& p, const Walk& walk) {
    const Step& seen = *find(walk, "seen-from-a");
    Vec2 d;
    for (int i = 0; i < 2; ++i)
      d[i] = static_cast<double>(Rational(coordinate(p, "v_b", i)) - Rational(coordinate(p, "v_a", i)));
    const std::string right = "(" + shown(d.x()) + ", " + shown(d.y()) + ")";
    CHECK_THAT(seen.formula, Contains(right));
    CHECK(says(seen.caption, "b is at rest, too") == (d == Vec2::Zero()));
    if (!seen.question) return;
    ++asked;
    const std::string& prompt = seen.question->prompt;
    CHECK(says(prompt, "*x*-component") != says(prompt, "*y*-component"));
    CHECK(answer(seen) == shown(d[says(prompt, "*x*-component") ? 0 : 1]));
  });
  CHECK(asked > 50);
}

TEST_CASE("rounding misleads the plain methods at great speed, and the lesson says so", "[words]") {
  for (const char* preset_id : {"fast", "balls-fast"}) {
    INFO(preset_id);
    const Parameters& p = preset(lesson(id), preset_id).parameters;
    const std::vector<Opinion> said = lesson(id).opinions(p);
    CHECK((said[0].says == "they meet") == meet(p, number(p, "duration")));
    CHECK_FALSE(said[1].agrees);
    CHECK_THAT(ending(lesson(id).walk(p)).caption, Contains("Rounding has misled"));
  }
}

TEST_CASE("the map's branch is that of the place, whatever the method", "[words]") {
  const CaseMap& map = *lesson(id).map;
  std::set<std::string> seen;
  over_settings("", 300, [&](const Parameters& p, const Walk&) {
    const bool later = meet(p, long_after), met = meet(p, number(p, "duration"));
    const std::string branch = map.branches[static_cast<std::size_t>(map.branch(p))];
    CAPTURE(branch);
    CHECK((branch == "at once") == meet(p, 0));
    CHECK((branch == "later") == (!met && later));
    CHECK((branch == "no contact" || branch == "no relative motion") == !later);
    if (branch == "between tests") CHECK((met && text(p, "method") == "discrete"));
    seen.insert(branch);
  });
  CHECK(seen.size() == map.branches.size());
}

TEST_CASE("drawn at first contact the bodies touch, and at earlier times they are apart", "[words]") {
  int met = 0;
  over_settings("", 300, [&](const Parameters& p, const Walk& walk) {
    const double duration = number(p, "duration");
    if (!(duration > 0) || !meet(p, duration)) return;
    const double first = first_contact_of(p);
    double size = number(p, "r_a") + number(p, "r_b");
    for (const char* name : {"a", "b"}) size += std::get<Vec3>(p.at(name)).norm();
    for (const char* name : {"v_a", "v_b"}) size += first * std::get<Vec3>(p.at(name)).norm();
    for (const char* slug : {"two-bodies", "seen-from-a"}) {
      const Scene::Time& time = *find(walk, slug)->scene.time;
      CHECK((time.lo == 0 && time.now == 0 && time.hi == duration && !time.contact));
      const Bodies then(time.at(first)), start(time.at(0));
      if (!then.both() || !(start.gap() > 1e-6 * size)) continue;
      ++met;
      CAPTURE(slug, first);
      CHECK(std::abs(then.gap()) <= 1e-9 * size);
      for (const double share : {0.0, 0.3, 0.6, 0.9})
        CHECK(Bodies(time.at(share * first)).relation() == Relation::disjoint);
    }
  });
  CHECK(met > 30);
}

TEST_CASE("where nothing is rounded, the core says that bodies drawn at the contact touch", "[words]") {
  for (const char* preset_id : {"boxes-meet", "head-on", "tunnels", "seen", "caught"}) {
    const Walk walk = lesson(id).walk(preset(lesson(id), preset_id).parameters);
    const std::optional<double> contact = find(walk, "contact")->scene.time->contact;
    INFO(preset_id);
    REQUIRE(contact);
    const Scene::Time& time = *find(walk, "two-bodies")->scene.time;
    CHECK(Bodies(time.at(*contact)).relation() == Relation::touching);
    CHECK(Bodies(time.at(*contact - 0.0625)).relation() == Relation::disjoint);
  }
}

TEST_CASE("the time marks the contact that the core finds once a step tells it, and none before", "[words]") {
  int marked = 0;
  over_settings("", 200, [&](const Parameters& p, const Walk& walk) {
    const bool met = number(p, "duration") > 0 && meet(p, number(p, "duration"));
    bool known = false;
    for (const Step& step : walk.steps) {
      if (step.scene.chart) continue;
      REQUIRE((step.scene.time != nullptr) == (number(p, "duration") > 0));
      if (!step.scene.time) continue;
      const std::optional<double>& contact = step.scene.time->contact;
      CAPTURE(step.slug);
      if (known) CHECK(contact);  // it stays known
      if (contact) CHECK(std::abs(*contact - first_contact_of(p)) <= 1e-9 * number(p, "duration"));
      known = contact.has_value();
    }
    CHECK(known == met);
    marked += known;
  });
  CHECK(marked > 30);
}

TEST_CASE("the numbers of the exercises are right", "[words]") {
  const std::vector<Exercise>& all = lesson(id).closing->exercises;
  CHECK_THAT(all[1].solution, Contains("from 0.275 to 0.375"));
  Parameters p = preset(lesson(id), all[1].preset).parameters;
  for (const auto& [name, told] : all[1].by) set(lesson(id), p, name, told);
  const Times times = boxes(p, 0, number(p, "duration"));
  CHECK(static_cast<double>(times.in) == Approx(0.275));
  CHECK(static_cast<double>(times.out) == Approx(0.375));

  p = preset(lesson(id), "balls-meet").parameters;
  p["a"] = Vec3(0, 0, 0), p["b"] = Vec3(10, 0, 0), p["v_a"] = Vec3(2, 0, 0), p["v_b"] = Vec3(-3, 0, 0);
  p["r_a"] = p["r_b"] = 1.0;
  CHECK(Balls(p).first() == Approx(1.6));
  CHECK_THAT(all[2].solution, Contains("= 1.6"));
}

}  // namespace moving_words_test
