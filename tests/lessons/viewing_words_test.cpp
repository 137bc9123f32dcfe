// What the lessons on ray tracing and picking say, on random settings, against all objects asked one by one.

#include <algorithm>
#include <cmath>

#include "lessons/picking/picture.h"
#include "lessons/ray_tracing/picture.h"
#include "tests/lessons/words.h"

namespace viewing_words_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;
using namespace isect::lessons::viewing;
using isect::test::Contains;

namespace {

/// The object met at the least t, the first of several; -1: none.
int first_met(const World& world, const Ray3& ray) {
  int best = -1;
  double least = INFINITY;
  for (int i = 0; i < static_cast<int>(world.objects.size()); ++i)
    if (const auto t = first_hit(ray, world.object(i).shape); t && *t < least) least = *t, best = i;
  return best;
}

}  // namespace

TEST_CASE("a pixel is said to be lit, shaded, turned away or sky as all objects have it", "[words]") {
  int lit = 0, shaded = 0, away = 0, sky = 0, acne = 0;
  on_random_settings("ray-tracing", 250, [&](const Parameters& setting, const Walk& walk) {
    const auto s = lessons::ray_tracing_lesson::setup(setting);
    const std::string text = ending(walk).verdict.text;
    const int own = first_met(s.world, s.ray);
    int met = 0;
    for (const auto& o : s.world.objects) met += first_hit(s.ray, o.shape).has_value();
    const Step& closest = *find(walk, "closest");
    CHECK(value(closest, "objects met") == met);
    CHECK(says(closest.caption, "hits only one object") == (met == 1));
    CHECK(says(text, "sky") == (own < 0));
    sky += own < 0;
    if (own < 0) return;

    CHECK(says(text, s.world.object(own).name));
    const Vec3 point = s.ray.at(*first_hit(s.ray, s.world.object(own).shape));
    const Vec3 to_light = std::get<Vec3>(setting.at("lamp")) - point;
    const double cosine = normal_at(s.world.object(own).shape, point).dot(to_light.normalized());
    CHECK(says(text, "turned away") == !(cosine > 0));
    away += !(cosine > 0);
    if (!(cosine > 0)) return;

    std::vector<std::string> blockers;
    for (int i = 0; i < static_cast<int>(s.world.objects.size()); ++i)
      if (i != own && first_hit({point, to_light, {0, 1}}, s.world.object(i).shape))
        blockers.emplace_back(s.world.object(i).name);
    const bool itself = first_hit({point, to_light, {0, 1}}, s.world.object(own).shape).has_value();
    const bool naive = std::get<std::string>(setting.at("shadow")) == "naive";
    CHECK(says(text, "its own shadow: wrong") == (blockers.empty() && itself && naive));
    CHECK(says(text, ", lit") == (blockers.empty() && !(itself && naive)));
    CHECK(std::ranges::any_of(blockers, [&](const auto& b) { return says(text, "the shadow of " + b); }) ==
          !blockers.empty());
    const double brightness = value(ending(walk), "brightness");
    CHECK(brightness == Approx(says(text, ", lit") ? 0.2 + 0.8 * cosine : 0.2));
    acne += says(text, "its own shadow"), shaded += !blockers.empty(), lit += says(text, ", lit");
  });
  for (const int often : {lit, shaded, away, sky, acne}) CHECK(often > 5);
}

TEST_CASE("the ray of a pixel is the one that its field of view gives", "[words]") {
  const double tangent = 1.5 / 6;  // of half the field of view
  for (const Preset& p : lesson("ray-tracing").presets) {
    const auto s = lessons::ray_tracing_lesson::setup(p.parameters);
    const double u = ((s.column + 0.5) / 24 - 1) * 48 / 36 * tangent, v = (1 - (s.row + 0.5) / 18) * tangent;
    const Vec3 d = s.ray.direction / s.ray.direction.x();
    CHECK(d.z() == Approx(u).margin(1e-12));
    CHECK(d.y() == Approx(v).margin(1e-12));
    const Walk walk = lesson("ray-tracing").walk(p.parameters);
    const Step& ray = *find(walk, "ray");
    CHECK_THAT(ray.formula, Contains("= " + shown(d.z()) + ",") && Contains("= " + shown(d.y())));
  }
}

TEST_CASE("what is picked is the first of the nearest, and what is kept on the way, too", "[words]") {
  int picked = 0, background = 0;
  on_random_settings("picking", 1000, [&](const Parameters& setting, const Walk& walk) {
    const lessons::picking_lesson::Pointed s(std::get<Vec3>(setting.at("pointer")));
    const int truth = first_met(s.world, s.ray);
    const std::string text = ending(walk).verdict.text;
    CHECK(says(text, "nothing is picked") == (truth < 0));
    (truth < 0 ? background : picked) += 1;
    if (truth >= 0) CHECK(says(text, std::string("picked: ") + s.world.object(truth).name));

    int balls = 0, tests = s.size(), kept = -1;
    double least = INFINITY;
    for (int i = 0; i < s.size(); ++i) {
      const bool met = s.met(i);
      const Step* step = find(walk, "object-" + std::to_string(i));
      CHECK((step != nullptr) == met);
      if (!met) continue;
      ++balls;
      if (i < 2) tests += i == 0 ? 12 : 8;  // the triangles of crate and gem
      if (const auto t = first_hit(s.ray, s.world.object(i).shape); t && *t < least) least = *t, kept = i;
      if (step->question) CHECK(answer(*step) == (kept < 0 ? std::string("none yet") : s.world.object(kept).name));
    }
    const Step& volumes = *find(walk, "volumes");
    CHECK(answer(volumes) == std::to_string(balls));
    CHECK(value(volumes, "tests, balls first") == tests);

    // 0.75 of the picture plane's height, at a distance of 3, is 18 pixels
    const Vec3& p = s.pointer;
    const auto pixels = [](double x) { return std::round(24000 * x) / 1000 + 0.0; };
    const double right = pixels(p.z()), up = pixels(p.y() - 0.25);
    const std::string told = shown(std::abs(right)) + " pixels " + (right < 0 ? "left" : "right") +
                             " of the image's centre and " + shown(std::abs(up)) + (up < 0 ? " below" : " above");
    CHECK_THAT(find(walk, "viewing-ray")->caption, Contains(told));
  });
  CHECK((picked > 100 && background > 100));
}

}  // namespace viewing_words_test
