// A lesson uses no idea before the course has taught it, and tells the numbers that its verdicts depend on.

#include <cmath>

#include "lessons/glossary.h"
#include "lessons/robustness/settings.h"
#include "tests/lessons/texts.h"
#include "tests/lessons/words.h"
#include "viz/text/rich_text.h"

namespace course_words_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;
using isect::test::Contains;

namespace {

std::size_t place(const std::string& id) {
  const auto& all = lessons::all_lessons();
  return static_cast<std::size_t>(std::ranges::find(all, id, &Lesson::id) - all.begin());
}

/// The lesson that the glossary names for this term.
const std::string& taught_in(const std::string& term) {
  const auto found = std::ranges::find(lessons::glossary(), term, &lessons::Term::name);
  REQUIRE(found != lessons::glossary().end());
  return found->lesson;
}

/// Whether a lesson builds on another, directly or through others.
bool builds_on(const Lesson& l, const std::string& other) {
  return std::ranges::any_of(l.after,
                             [&](const std::string& id) { return id == other || builds_on(lesson(id), other); });
}

bool needs_orientations(const Lesson& l) {
  return std::ranges::any_of(texts(l), [](const std::string& told) {
    return says(told, "orient2d") || says(told, "orientation") || says(told, "sign of an area");
  });
}

}  // namespace

TEST_CASE("orientations are taught before any lesson needs them", "[words]") {
  const std::string& teacher = taught_in("orientation");
  CHECK(teacher == "convex-hull");
  for (const Preset& p : lesson(teacher).presets) {
    INFO(p.id);
    int told = 0;
    for (const Step& s : lesson(teacher).walk(p.parameters).steps)
      told += says(s.caption, "The turn is the sign of an area") && says(s.caption, "orientation");
    CHECK(told == 1);
  }
  int needing = 0;
  for (const Lesson* l : lessons::all_lessons()) {
    if (!needs_orientations(*l)) continue;
    ++needing;
    INFO(l->id);
    CHECK(place(l->id) >= place(teacher));
    CHECK((l->id == teacher || builds_on(*l, teacher)));
  }
  CHECK(needing >= 5);
  const Lesson& capsules = lesson("capsule-capsule");
  CHECK(std::ranges::count(capsules.after, teacher) == 1);
  CHECK(std::ranges::count(capsules.ideas, "orientation") == 1);
}

TEST_CASE("the microscope tells all numbers that its verdicts depend on", "[words]") {
  const auto first = [](const std::string& preset_id) {
    const Walk walk = walk_of("robustness", preset_id);
    return plain(find(walk, "place")->caption);
  };
  CHECK_THAT(first("tangent"), Contains("direction is (2, 1)") && Contains("centre is (0.1, 0.2), its radius 1"));
  CHECK_THAT(first("orientation"), Contains("b = (1.5, 1.5)") && Contains("c = (3, 3)"));
  CHECK_THAT(first("crossings"), Contains("(−1.1, −0.9), (1.3, 0.7) and (−0.7, 1.3)"));
  CHECK_THAT(first("spheres"), Contains("centre is (0, 0), its radius 0.7") && Contains("the radius 0.3"));
  for (const Preset& p : lesson("robustness").presets) {
    INFO(p.id);
    CHECK(says(first(p.id), "rounded to float") == (text(p.parameters, "scalar") == "float"));
  }
}

TEST_CASE("a ray is a miss or a hit of the microscope's circle by the numbers in the text", "[words]") {
  namespace microscope = lessons::robustness_lesson;
  const Vec3 middle = microscope::standard_point("tangent");
  const microscope::Setting s = microscope::setting("tangent", "double", middle);
  const Point<long double, 2> center(0.1, 0.2);
  const Vector<long double, 2> d(2, 1);
  int told = 0;
  for (int i = -microscope::half; i <= microscope::half; i += 8)
    for (int j = -microscope::half; j <= microscope::half; j += 8) {
      Point<double, 2> o = middle.head<2>();
      for (int k = 0; k < std::abs(i); ++k) o.x() = std::nextafter(o.x(), i < 0 ? -INFINITY : INFINITY);
      for (int k = 0; k < std::abs(j); ++k) o.y() = std::nextafter(o.y(), j < 0 ? -INFINITY : INFINITY);
      const Vector<long double, 2> f = o.cast<long double>() - center;
      const long double area = f.x() * d.y() - f.y() * d.x(), beyond = area * area - d.dot(d);
      if (std::abs(beyond) < 1e-16L) continue;  // too near for this arithmetic
      ++told;
      CHECK(s.truth(i, j) == (beyond > 0 ? -1 : 1));
    }
  CHECK(told > 20);
}

}  // namespace course_words_test
