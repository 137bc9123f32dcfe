// Lessons that somebody has translated: nothing of them stays English, in any setting.

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/lessons/random_settings.h"
#include "viz/lang/language.h"
#include "viz/lang/lesson_texts.h"
#include "viz/player/reader_state.h"
#include "viz/text/rich_text.h"

namespace translated_test {

using namespace isect;
using isect::test::Contains;

TEST_CASE("a translated lesson has all of its texts in that language, in presets and in random settings", "[lang]") {
  int translated = 0;
  for (const viz::Lesson* lesson : lessons::all_lessons())
    for (const viz::Language& language : viz::languages()) {
      if (&viz::lesson_in(*lesson, language.code) == lesson) continue;
      ++translated;
      std::vector<viz::Parameters> settings;
      for (const viz::Preset& preset : lesson->presets) settings.push_back(preset.parameters);
      bench::Random random(tests::seed());
      for (int i = 0; i < tests::cases(300, 20'000); ++i) settings.push_back(tests::random_setting(*lesson, random));
      for (const std::string& text : viz::untranslated(*lesson, language.code, settings))
        FAIL_CHECK(lesson->id << ", " << language.code << ": " << text);
    }
  CHECK(translated >= 1);
}

TEST_CASE("a lesson in German says what the English one says, with the same numbers", "[lang]") {
  const viz::Lesson& english = viz::lesson_named(lessons::all_lessons(), "sphere-sphere");
  const viz::Lesson& german = viz::lesson_in(english, "de");
  CHECK(german.title == "Kugel und Kugel");
  CHECK(&viz::lesson_in(english, "de") == &german);
  CHECK(&viz::lesson_in(english, "en") == &english);
  for (const viz::Preset& preset : english.presets) {
    const viz::Walk here = english.walk(preset.parameters), there = german.walk(preset.parameters);
    REQUIRE(here.steps.size() == there.steps.size());
    for (std::size_t i = 0; i < here.steps.size(); ++i) {
      INFO(preset.id << ", step " << i + 1);
      CHECK(here.steps[i].slug == there.steps[i].slug);
      CHECK(here.steps[i].title != there.steps[i].title);
      REQUIRE(here.steps[i].values.size() == there.steps[i].values.size());
      for (std::size_t k = 0; k < here.steps[i].values.size(); ++k)
        CHECK(here.steps[i].values[k].value == there.steps[i].values[k].value);
    }
  }
  const viz::Walk touching = german.walk(viz::preset(german, "touching").parameters);
  CHECK_THAT(touching.alt, Contains("ihre Mittelpunkte 2.5391 voneinander entfernt") && Contains("berühren sich"));
  CHECK(viz::spoken() == "en");
}

TEST_CASE("numbers of any form take the places of a translated text", "[lang]") {
  const viz::Lesson& english = viz::lesson_named(lessons::all_lessons(), "sphere-sphere");
  viz::Parameters far = english.presets.front().parameters;
  far["r_a"] = 123456.0, far["r_b"] = 1e-9;
  const viz::Walk walk = viz::lesson_in(english, "de").walk(far);
  CHECK_THAT(walk.alt, Contains("Zwei Kugeln, a vom Radius " + viz::shown(123456.0) + " und b vom Radius " +
                                viz::shown(1e-9) + ", ihre"));
}

}  // namespace translated_test
