// A reader's progress over the whole course: what is counted, its sheet, and its file.

#include "viz/window/progress.h"

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/scratch.h"
#include "tests/viz/window_driver.h"

namespace progress_test {
using namespace isect;
using namespace isect::viz;

namespace {

using Json = nlohmann::ordered_json;

const Lesson& ray_sphere() { return lesson_named(lessons::all_lessons(), "ray-sphere"); }

/// Somebody who has read one lesson: two questions right, one wrong, one skipped; one exercise solved; one review
/// taken.
Settings reader() {
  Settings s;
  Score& score = s.scores["ray-sphere"];
  for (const std::string question : {"/a", "/b", "/c"}) {
    score.answers[question] = question != "/c";
    s.record.keep("ray-sphere", question, question != "/c");
  }
  score.finished = true, score.seen = score.of = 9;
  score.skipped = {"d"}, score.solved = {ray_sphere().closing->exercises.front().prompt, "an exercise of old"};
  s.record.reviews[2] = {7, 8};
  return s;
}

}  // namespace

TEST_CASE("the file of progress has the shape that its header tells, and the record that pages read", "[window]") {
  const Settings settings = reader();
  const Json json = Json::parse(progress_json(lessons::all_lessons(), settings));
  CHECK(json.at("isect").get<std::string>() == "progress");
  CHECK(json.at("version").get<int>() == 1);
  std::vector<std::string> ids, course;
  for (const auto& lesson : json.at("lessons").items()) ids.push_back(lesson.key());
  for (const Lesson* lesson : lessons::all_lessons()) course.push_back(lesson->id);
  CHECK(ids == course);
  const Json own = json.at("lessons").at("ray-sphere");
  CHECK(own.at("finished").get<bool>());
  const auto number = [&](const char* name) { return own.at(name).get<int>(); };
  CHECK((number("seen") == 9 && number("of") == 9));
  CHECK((number("right") == 2 && number("answered") == 3 && number("skipped") == 1));
  CHECK(number("solved") == 1);
  CHECK(number("exercises") == static_cast<int>(ray_sphere().closing->exercises.size()));
  CHECK(own.size() == 8);
  CHECK_FALSE(json.at("lessons").at("rays").at("finished").get<bool>());
  CHECK(json.at("lessons").at("rays").at("of").get<int>() == 0);
  CHECK(json.at("reviews").at("2").at("right").get<int>() == 7);
  CHECK(answer_record_from(json.at("record").dump()) == settings.record);
}

TEST_CASE("pages are held to the same file of progress", "[window]") {
  std::ifstream sample(ISECT_PROGRESS_FILE);  // tests/book/progress_file.mjs has app/book/progress.js read and save it
  nlohmann::json file = nlohmann::json::parse(sample);
  const std::vector<const Lesson*> two = {&lesson_named(lessons::all_lessons(), "rays"), &ray_sphere()};
  nlohmann::json own = nlohmann::json::parse(progress_json(two, reader()));
  for (nlohmann::json* one : {&file, &own})
    for (const Lesson* lesson : two) one->at("lessons").at(lesson->id).at("exercises") = 0;  // lessons gain some
  CHECK(own == file);
}

TEST_CASE("H shows all lessons and reviews on one page, and each leads there", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, {}, reader(), layout_only);
  const auto open = [&] {
    window.type("h");
    window.frames(2);
    REQUIRE(window.has("progress sheet"));
  };
  open();
  CutWords cut;
  ImGui::GetIO().UserData = &cut;
  window.frames();
  ImGui::GetIO().UserData = nullptr;
  for (const std::string& words : cut) FAIL_CHECK("cut: " << words);
  const Rect sheet = window.rect("progress sheet");
  const auto on_page = [&](const std::string& name) {
    INFO(name);
    REQUIRE(window.has(name));
    const Rect r = window.rect(name);
    CHECK((r.left >= sheet.left && r.right <= sheet.right && r.top > sheet.top));
    CHECK(r.bottom <= window.rect("save progress").top);
  };
  for (const Lesson* lesson : lessons::all_lessons()) on_page("progress " + lesson->id);
  for (int i = 1; i <= review_count(lessons::all_lessons()); ++i) on_page("progress review " + std::to_string(i));

  window.click("progress ray-sphere");
  window.frames(2);
  CHECK(window.player().lesson().id == "ray-sphere");
  CHECK_FALSE(window.has("progress sheet"));
  open();
  window.click("progress review 1");
  window.frames(2);
  CHECK(window.has("review question"));
  window.key(key::escape);
  window.frames(2);
  window.key(key::o, true);
  window.frames(2);
  window.click("show progress");
  window.frames(2);
  CHECK(window.has("progress sheet"));
}

TEST_CASE("progress is saved as JSON, the same once, another under another name", "[window]") {
  const std::string folder = isect::test::scratch("isect-progress").string();
  std::filesystem::remove_all(folder);
  WindowOptions options = layout_only;
  options.figures = folder;
  WindowDriver window(lessons::all_lessons(), 1280, 800, {}, reader(), options);
  const auto save = [&] {
    window.type("h");
    window.frames(2);
    window.click("save progress");
    window.frames(2);
    return window.ui.message();
  };
  CHECK(save() == "Saved " + folder + "/progress.json");
  CHECK(read_file(folder + "/progress.json") == progress_json(lessons::all_lessons(), window.ui.settings()));
  CHECK(save() == "Saved " + folder + "/progress.json");
  window.key(key::end);
  CHECK(save() == "Saved " + folder + "/progress-2.json");
  std::filesystem::remove_all(folder);

  write_file(folder, "a file where a folder should be");
  save();
  REQUIRE(window.has("refused folder"));
  for (const char* of_figure : {"format png", "other width", "save as preset"}) CHECK_FALSE(window.has(of_figure));
  CHECK(window.rect("save").bottom < window.rect("save sheet").bottom);
  window.click("save folder");
  window.key(key::a, true);
  window.type(folder + "-other");
  window.click("save");
  window.frames(2);
  CHECK(window.ui.message() == "Saved " + folder + "-other/progress.json");
  std::filesystem::remove_all(folder);
  std::filesystem::remove_all(folder + "-other");
}

TEST_CASE("progress that failed to be saved gets the name that is typed, whatever the figure's width", "[window]") {
  const std::string folder = isect::test::scratch("isect-progress-named").string();
  std::filesystem::remove_all(folder);
  std::filesystem::remove_all(folder + "-other");
  write_file(folder, "a file where a folder should be");
  WindowOptions options = layout_only;
  options.figures = folder;
  WindowDriver window(lessons::all_lessons(), 1280, 800, {}, reader(), options);
  window.type("s");
  window.frames(2);
  window.click("other width");
  window.key(key::a, true);
  window.type("?");
  window.key(key::enter);
  window.frames(2);
  REQUIRE(window.has("refused width"));
  window.key(key::escape);
  window.frames(2);
  window.key(key::escape);
  window.frames(2);
  REQUIRE_FALSE(window.has("save sheet"));

  window.type("h");
  window.frames(2);
  window.click("save progress");
  window.frames(2);
  REQUIRE(window.has("refused folder"));
  CHECK_FALSE(window.has("refused width"));
  const auto give = [&](const char* field, const std::string& words) {
    window.click(field);
    window.key(key::a, true);
    window.type(words);
    window.frames(2);
  };
  give("save folder", folder + "-other");
  give("save name", "a/b");
  CHECK(window.has("refused name"));
  window.click("save");
  window.frames(2);
  REQUIRE(window.has("save sheet"));
  give("save name", "of mine.json");
  window.click("save");
  window.frames(2);
  CHECK(window.ui.message() == "Saved " + folder + "-other/of mine.json");
  std::filesystem::remove_all(folder);
  std::filesystem::remove_all(folder + "-other");
}

TEST_CASE("the furthest step that was shown is kept", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("ray-sphere", "two-roots"), {}, layout_only);
  const auto score = [&] { return window.ui.settings().scores.at("ray-sphere"); };
  CHECK(score().seen == 1);
  window.player().go_to(3);
  window.frames(2);
  CHECK(score().seen == 4);
  window.key(key::home);
  CHECK(score().seen == 4);
  CHECK(score().of == window.player().count());
  CHECK_FALSE(score().finished);
}

}  // namespace progress_test
