// Reviews in the window, by keyboard alone.

#include <algorithm>
#include <filesystem>
#include <set>

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/scratch.h"
#include "tests/viz/window_driver.h"
#include "viz/walk/closing.h"
#include "viz/walk/other_numbers.h"
#include "viz/walk/review.h"

namespace window_review_test {
using namespace isect;
using namespace isect::viz;

namespace {

/// Opens the list of reviews and takes the first by Down and Enter.
void take_first(WindowDriver& window) {
  window.type("t");
  window.frames(2);
  REQUIRE(window.has("reviews"));
  for (int i = 0; i < 20 && window.ui.focus() != "review 1"; ++i) window.key(key::down);
  REQUIRE(window.ui.focus() == "review 1");
  window.key(key::enter);
  window.frames(2);
  REQUIRE(window.has("review question"));
}

std::string question_of(const Player& player, int step) {
  return player.lesson().id + " " + question_name(player.lesson(), player.parameters(), player.walk().steps[step]);
}
std::string question_on_show(WindowDriver& window) { return question_of(window.player(), window.player().index() + 1); }

/// Gives the right answer, or a wrong one.
void answer(WindowDriver& window, bool right) {
  const Question* asked = window.player().quiz().asked();
  REQUIRE(asked);
  const int choices = static_cast<int>(asked->choices.size());
  window.answer(right ? asked->answer : (asked->answer + 1) % choices);
  window.frames(2);
}

}  // namespace

TEST_CASE("a review asks eight questions of its lessons, keeps the answers, and tells what was wrong", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("ray-sphere", "tangent"), {}, layout_only);
  window.key(key::right);
  const ReaderState before = window.player().reader_state();
  take_first(window);
  std::set<std::string> ids, asked;  // of lessons; of questions
  for (const Lesson* l : lessons_of_review(lessons::all_lessons(), 1)) ids.insert(l->id);
  for (int i = 0; i < questions_a_review; ++i) {
    INFO(i);
    REQUIRE(window.player().quiz().asked());
    CHECK(window.has("lesson words"));
    CHECK(window.has("scene"));
    CHECK_FALSE(window.has("scrubber"));
    CHECK(ids.contains(window.player().lesson().id));
    asked.insert(question_on_show(window));
    answer(window, i != 2);
    CHECK(window.has("what came of it"));  // as in the lesson
    CHECK(window.player().quiz().answered()->right() == (i != 2));
    window.key(key::right);
    window.frames(2);
  }
  CHECK(asked.size() == questions_a_review);
  CHECK(window.has("review score"));
  CHECK(window.has("to step 3"));
  CHECK_FALSE(window.has("to step 1"));
  const AnswerRecord record = window.ui.settings().record;
  CHECK(record.answers == questions_a_review);
  CHECK(record.reviews.at(1) == ReviewResult{7, 8});

  window.key(key::escape);
  window.frames(2);
  CHECK_FALSE(window.has("review score"));
  CHECK(window.has("scrubber"));
  const ReaderState after = window.player().reader_state();
  CHECK((after.lesson == before.lesson && after.preset == before.preset && after.step == before.step));
}

TEST_CASE("what was wrong in a review is asked first in the next one, and leads to its step", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, {}, {}, layout_only);
  take_first(window);
  std::string wrong;
  for (int i = 0; i < questions_a_review; ++i) {
    if (i == 5) wrong = question_on_show(window);
    answer(window, i != 5);
    window.key(key::enter);  // goes on, too
    window.frames(2);
  }
  for (int i = 0; i < 20 && window.ui.focus() != "review again"; ++i) window.key(key::down);
  window.key(key::enter);
  window.frames(2);
  REQUIRE(window.player().quiz().asked());
  CHECK(question_on_show(window) == wrong);
  for (int i = 0; i < questions_a_review; ++i) {  // all are skipped: none is kept
    window.key(key::right);
    window.frames(2);
  }
  CHECK(window.ui.settings().record.answers == questions_a_review);
  CHECK(window.ui.settings().record.reviews.at(1) == ReviewResult{0, 8});
  for (int i = 0; i < 20 && window.ui.focus() != "to step 1"; ++i) window.key(key::down);
  window.key(key::enter);
  window.frames(2);
  CHECK_FALSE(window.has("review score"));
  CHECK(question_of(window.player(), window.player().index()) == wrong);
}

TEST_CASE("nothing is lost when a review is left, and no key leads out of it by chance", "[window]") {
  Settings settings;
  settings.beside = Beside{"ray-sphere", "", "miss"};
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("ray-sphere", "tangent"), settings, layout_only);
  window.player().remember("radius");
  window.player().edit("radius", 1.25);
  window.key(key::right);
  const ReaderState before = window.player().reader_state();
  take_first(window);
  const std::string lesson = window.player().lesson().id;
  for (const char* nothing : {"[", "]", "v", "w", "r", "s", "g", "t", " ", "n"}) window.type(nothing);
  for (const key::Code code : {key::left, key::home, key::end, key::page_down, key::tab, key::f12}) window.key(code);
  window.key(key::o, true);
  window.key(key::z, true);
  window.frames(2);
  CHECK(window.player().lesson().id == lesson);
  CHECK(window.player().quiz().asked());
  CHECK(window.has("review question"));
  CHECK(window.ui.settings().reader_state->lesson == "ray-sphere");  // where the next run begins
  CHECK(window.ui.settings().beside == settings.beside);
  CHECK(window.ui.settings().recent == std::vector<std::string>{"ray-sphere"});
  window.key(key::escape);
  window.frames(2);
  const ReaderState after = window.player().reader_state();
  CHECK((after.lesson == before.lesson && after.parameters == before.parameters && after.step == before.step));
  CHECK(window.ui.settings().beside == settings.beside);
  window.key(key::z, true);
  CHECK(std::get<double>(window.player().parameters().at("radius")) != 1.25);
}

TEST_CASE("a drag does not take a review's question away", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, {}, {}, layout_only);
  take_first(window);
  for (const Parameter& p : window.player().lesson().parameters) {
    try {
      window.player().edit(p.name, p.initial);
    } catch (const BadInput&) {  // some are in order only together
      continue;
    }
    window.frames(2);
    CHECK(window.player().quiz().asked());
    CHECK(window.has("review question"));
  }
}

TEST_CASE("Y asks a question that was answered once more, with other numbers", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("ray-sphere", "two-roots"), {}, layout_only);
  window.type("y");  // nothing was answered yet
  CHECK_FALSE(window.player().quiz().asked());
  while (!window.player().quiz().asked()) window.key(key::right);
  const std::string first = question_on_show(window);
  answer(window, true);
  const Parameters before = window.player().parameters();
  const std::string numbers = numbers_of_question(window.player().walk(), window.player().index());
  CHECK(window.has("numbers again"));
  window.type("y");
  window.frames(2);
  REQUIRE(window.player().quiz().asked());
  CHECK(question_on_show(window) == first);
  CHECK(numbers_of_question(window.player().walk(), window.player().index() + 1) != numbers);
  window.key(key::z, true);
  CHECK(window.player().parameters() == before);
}

TEST_CASE("every fifth lesson offers its review on its card", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 4000, {}, {}, layout_only);
  const auto& all = lessons::all_lessons();
  for (const Lesson* lesson : {all[3], all[4], all.back()}) {
    INFO(lesson->id);
    window.player().open(*lesson);
    window.player().last();
    window.frames(2);
    REQUIRE(window.player().step().slug == closing_slug);
    const int number = review_after(all, *lesson);
    CHECK((number > 0) == (lesson != all[3]));
    if (number == 0) continue;
    window.click("take review " + std::to_string(number));
    window.frames(2);
    CHECK(window.has("review question"));
    window.click("leave review");
    window.frames(2);
    CHECK(window.player().lesson().id == lesson->id);
    CHECK(window.player().step().slug == closing_slug);
  }
}

TEST_CASE("answers of lessons are kept once each, and a damaged record is set aside", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("ray-sphere", "two-roots"), {}, layout_only);
  int answers = 0;
  while (!window.player().at_end()) {
    window.key(key::right);
    if (!window.player().quiz().asked()) continue;
    answer(window, false);
    window.frames(5);
    ++answers;
  }
  const Settings kept = window.ui.settings();
  CHECK(kept.record.answers == answers);
  CHECK(kept.record.lessons.at("ray-sphere").size() == kept.scores.at("ray-sphere").answers.size());

  const std::string file = test::scratch("isect-record-test.json").string(), aside = file + ".damaged";
  std::filesystem::remove(aside);
  write_settings(file, kept);
  CHECK(set_spoilt_settings_aside(file).empty());
  CHECK(read_settings(file, lessons::all_lessons()).record == kept.record);
  std::string text = read_file(file);
  const std::string version = "\"version\": 1";
  REQUIRE(text.find(version) != text.npos);
  text.replace(text.find(version), version.size(), "\"version\": 7");
  write_file(file, text);
  CHECK(read_settings(file, lessons::all_lessons()).record == AnswerRecord());
  CHECK(read_settings(file, lessons::all_lessons()).scores.size() == kept.scores.size());
  CHECK_THAT(set_spoilt_settings_aside(file), test::Contains("record version") && test::Contains(aside));
  CHECK(read_file(aside) == text);

  write_file(file, R"({"scores": {"rays": {"finished": true, "answers": {"/foot": false, "/root": true}}}})");
  const AnswerRecord older = read_settings(file, lessons::all_lessons()).record;
  CHECK_FALSE(older.find("rays", "/foot")->right);
  CHECK(older.find("rays", "/root")->right);
  for (const std::string& made : {file, aside}) std::filesystem::remove(made);
}

}  // namespace window_review_test
