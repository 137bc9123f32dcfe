// What the window gives away and takes in: clipboard, figures, settings; and what it says without a display.

#include <cstdlib>
#include <filesystem>

#include "tests/catch.h"
#include "tests/scratch.h"
#include "tests/viz/sample_lesson.h"
#include "tests/viz/window_driver.h"
#include "viz/formats/formats.h"
#include "viz/window/window.h"

namespace window_state_test {
using namespace isect::viz;

namespace {

const Lesson disc = sample::lesson(), ball = sample::other_lesson();
const std::vector<const Lesson*> both = {&disc, &ball};

}  // namespace

TEST_CASE("the state goes through the clipboard and back", "[window]") {
  WindowDriver window(both);
  window.type("p2");
  window.key(key::end);
  window.key(key::c, true);
  const std::string copied = ImGui::GetClipboardText();
  const ReaderState before = window.player().reader_state();

  window.type("]1o");
  CHECK(window.player().lesson().id == "point-ball");
  ImGui::SetClipboardText(copied.c_str());
  window.key(key::v, true);
  CHECK(window.player().reader_state().lesson == "point-disc");
  CHECK(window.player().reader_state().preset == "squared-outside");
  CHECK(window.player().reader_state().step == before.step);
  CHECK(window.player().camera().now().perspective);
}

TEST_CASE("a pasted text that is no state is refused with its reason, and nothing is lost", "[window]") {
  WindowDriver window(both);
  window.type("2");
  window.key(key::right);
  const char* bad =
      GENERATE("", "Bring milk {", "{", "[1, 2]", R"({"lesson": "point-dis"})",
               R"({"lesson": "point-disc", "step": 99})", R"({"lesson": "point-disc", "parameters": {"r": -1}})");
  INFO(bad);
  ImGui::SetClipboardText(bad);
  window.key(key::v, true);
  CHECK_FALSE(window.ui.message().empty());
  if (*bad != '{') CHECK_THAT(window.ui.message(), !isect::test::Contains("parse error"));
  CHECK(window.has("message"));
  CHECK(window.player().played().preset_id() == "squared-outside");
  CHECK(window.player().index() == 1);
  window.wait(30);
  CHECK(window.ui.message().empty());
}

TEST_CASE("a figure is saved where its name says, and opens again at its place", "[window]") {
  const std::string folder = isect::test::scratch("isect-window-test").string();
  std::filesystem::remove_all(folder);
  WindowDriver window(both, 1280, 800, {}, {}, {.reduced_motion = true, .figures = folder});
  window.key(key::right);
  window.type("s");
  window.frames(2);
  REQUIRE(window.has("save sheet"));
  window.key(key::enter);
  window.frames(2);
  const std::string png_file = folder + "/point-disc/squared-inside/02-length.png";
  CHECK(window.ui.message() == "Saved " + png_file + ", with its alt text");
  CHECK(read_file(folder + "/point-disc/squared-inside/02-length.txt").find("point") != std::string::npos);
  const std::string bytes = read_file(png_file);
  const Picture saved = read_png(bytes);
  CHECK(saved.width == 960);
  CHECK(saved.height == 600);
  const ReaderState state = reader_state_from_metadata(png_metadata(bytes), both);
  CHECK(state.lesson == "point-disc");
  CHECK(state.step == 1);

  window.key(key::f12);
  window.click("format svg");
  window.click("save theme grey");
  window.click("save");
  window.frames(2);
  const std::string svg_file = folder + "/point-disc/squared-inside/02-length.svg";
  CHECK(window.ui.message() == "Saved " + svg_file + ", with its alt text");
  CHECK(read_file(svg_file).find("<svg") != std::string::npos);
  CHECK(window.ui.settings().save_format == "svg");
  CHECK(window.ui.settings().save_theme == ThemeName::grey);
  std::filesystem::remove_all(folder);
}

TEST_CASE("no figure and no text that was saved is lost to a later one", "[window]") {
  const std::string folder = isect::test::scratch("isect-window-keeps-test").string();
  std::filesystem::remove_all(folder);
  WindowDriver window(both, 1280, 800, {}, {}, {.reduced_motion = true, .figures = folder});
  const auto save = [&](const char* choice = nullptr) {
    window.type("s");
    window.frames(2);
    if (choice) window.click(choice);
    window.click("save");
    window.frames(2);
    return window.ui.message();
  };
  const std::string stem = folder + "/point-disc/squared-inside/01-" + window.player().step().slug;
  CHECK(save() == "Saved " + stem + ".png, with its alt text");
  const std::string first = read_file(stem + ".png"), text = read_file(stem + ".txt");
  CHECK(save() == "Saved " + stem + ".png, with its alt text");  // the same again
  CHECK_FALSE(std::filesystem::exists(stem + "-2.png"));
  CHECK(save("save theme grey") == "Saved " + stem + "-2.png, with its alt text");
  CHECK(save("format svg") == "Saved " + stem + ".svg, with its alt text");
  CHECK(read_file(stem + ".png") == first);
  CHECK(read_file(stem + "-2.png") != first);
  std::filesystem::create_directory(stem + "-3.png");  // not ours
  CHECK(save("format png") == "Saved " + stem + "-2.png, with its alt text");
  CHECK(save("save theme dark") == "Saved " + stem + "-4.png, with its alt text");
  write_file(stem + ".txt", "mine");
  CHECK(save("save theme print") == "Saved " + stem + "-5.png, with its alt text");
  CHECK(read_file(stem + ".txt") == "mine");
  CHECK(read_file(stem + "-5.txt") == text);
  std::filesystem::remove_all(folder);
}

TEST_CASE("a width that is refused is told in the sheet, and nothing is saved until it is mended", "[window]") {
  const std::string folder = isect::test::scratch("isect-window-width-test").string();
  std::filesystem::remove_all(folder);
  WindowDriver window(both, 1280, 800, {}, {}, {.reduced_motion = true, .figures = folder});
  for (const char* wrong : {"?", "0", "-3", "1e9"}) {
    CAPTURE(wrong);
    window.type("s");
    window.frames(2);
    window.click("other width");
    window.type(wrong);
    window.key(key::enter);
    window.frames(2);
    CHECK(window.has("refused width"));
    window.key(key::enter);
    window.click("save");
    window.frames(2);
    CHECK(window.has("save sheet"));
    CHECK_FALSE(std::filesystem::exists(folder));
    window.click("size 12");
    window.frames(2);
    CHECK_FALSE(window.has("refused width"));
    window.key(key::escape);
    window.frames(2);
  }
  std::filesystem::remove_all(folder);
}

TEST_CASE("the sheet shows the figure as it would be saved, in its theme and size", "[window]") {
  WindowDriver window(both);
  CHECK_FALSE(window.has("save preview"));
  window.type("s");
  window.frames(3);
  REQUIRE(window.has("save preview"));
  const auto middle = [&] {  // of the figure's ground, near its corner
    const Rect r = window.rect("save preview");
    const Picture p = window.picture();
    const std::size_t at = 4 * (static_cast<std::size_t>(r.top + 4) * p.width + static_cast<std::size_t>(r.left + 4));
    return static_cast<int>(p.rgba[at]) + p.rgba[at + 1] + p.rgba[at + 2];
  };
  const auto shape = [&] { return window.rect("save preview").width() / window.rect("save preview").height(); };
  window.click("save theme print");
  window.frames(3);
  CHECK(middle() > 3 * 240);
  CHECK(shape() == Approx(1.6).epsilon(0.01));
  window.click("save theme dark");
  window.frames(3);
  CHECK(middle() < 3 * 90);
  window.click("size 8");
  window.frames(3);
  CHECK(std::abs(shape() - 1.6) > 0.02);
  const Rect sheet = window.rect("save sheet"), preview = window.rect("save preview");
  CHECK((preview.left > window.rect("other width").right && preview.right <= sheet.right &&
         preview.bottom <= sheet.bottom));
  window.key(key::escape);
  window.frames(2);
  CHECK_FALSE(window.has("save preview"));
}

TEST_CASE("a figure is saved in every format, on paper as wide as asked", "[window]") {
  const std::string folder = (std::filesystem::temp_directory_path() / "isect-window-formats").string();
  std::filesystem::remove_all(folder);
  WindowDriver window(both, 1280, 800, {}, {}, {.reduced_motion = true, .figures = folder});
  for (const Format& format : formats()) {
    if (!format.write) continue;  // films
    INFO(format.name);
    window.type("s");
    window.frames(2);
    window.click("format " + format.name);
    window.click("size 8");
    window.click("save");
    window.frames(2);
    const std::string file = folder + "/point-disc/squared-inside/01-way." + format.name;
    CHECK(window.ui.message() == "Saved " + file + ", with its alt text");
    const std::string bytes = read_file(file);
    CHECK(reader_state_from_metadata(format.metadata(bytes), both).lesson == "point-disc");
    if (format.name == "png") CHECK(read_png(bytes).width >= static_cast<int>(8 / 2.54 * 300) - 1);
    if (format.name == "png") CHECK(read_png(bytes).width <= static_cast<int>(8 / 2.54 * 300 * 1.6));
  }
  CHECK(window.ui.settings().save_width_cm == 8);
  std::filesystem::remove_all(folder);
}

TEST_CASE("the width of a figure is typed in cm, and one that makes no sense is refused", "[window]") {
  WindowDriver window(both);
  window.type("s");
  window.frames(2);
  window.click("other width");
  window.frames(2);
  window.type("9,5");
  window.key(key::enter);
  window.frames(2);
  CHECK(window.ui.settings().save_width_cm == 9.5);
  REQUIRE(window.has("save sheet"));  // Enter was the field's
  window.click("other width");
  window.frames(2);
  window.type("900");
  window.key(key::enter);
  window.frames(2);
  CHECK(window.ui.settings().save_width_cm == 9.5);
  CHECK(window.ui.message().find("60") != std::string::npos);
}

TEST_CASE("Ctrl+S writes a scene back into its file, says what failed, and saves a figure of a lesson", "[window]") {
  Lesson scene = disc;
  scene.made_from = "{}";
  std::vector<Parameters> written;
  bool full = false;
  const auto write = [&](const Lesson&, const Parameters& p) {
    if (full) throw FileError("cannot write 's.json': no room");
    written.push_back(p);
    scene.presets.front().parameters = p;
  };
  const std::vector<const Lesson*> lessons = {&scene, &ball};
  WindowDriver window(lessons, 1280, 800, {}, {}, {.reduced_motion = true, .save_scene = write});
  window.drag("handle c", 60, 30);
  window.key(key::s, true);
  REQUIRE(written.size() == 1);
  CHECK(written.front() == window.player().parameters());
  CHECK(written.front() != disc.presets.front().parameters);
  CHECK(window.ui.message() == "Saved into the scene's file");
  CHECK(window.player().played().preset_id() == scene.presets.front().id);  // nothing is "changed" any more
  window.drag("handle c", 30, 30);
  CHECK(window.player().played().preset_id().empty());
  window.type("1");
  CHECK(window.player().parameters() == written.front());  // and not as it was once opened

  window.type("s");
  window.frames(2);
  CHECK_FALSE(window.has("save as preset"));
  window.click("save scene");
  window.frames(2);
  CHECK(written.size() == 2);
  CHECK_FALSE(window.has("save sheet"));
  full = true;
  window.key(key::s, true);
  CHECK(window.ui.message() == "cannot write 's.json': no room");
  CHECK(written.size() == 2);

  window.type("]");
  window.key(key::s, true);
  window.frames(2);
  CHECK(window.has("save sheet"));
  CHECK(window.has("save as preset"));
  CHECK_FALSE(window.has("save scene"));
  CHECK(written.size() == 2);
}

TEST_CASE("a scene that was changed and not saved is left at the second time only", "[window]") {
  Lesson scene = disc;
  scene.made_from = "{}";
  const auto write = [&](const Lesson&, const Parameters& p) { scene.presets.front().parameters = p; };
  const std::vector<const Lesson*> lessons = {&scene, &ball};
  WindowDriver window(lessons, 1280, 800, {}, {}, {.reduced_motion = true, .save_scene = write});
  CHECK(window.ui.may_close());
  window.drag("handle c", 60, 30);
  SECTION("by the key") {
    window.key(key::q, true);
    CHECK_FALSE(window.ui.wants_to_close());
    CHECK(window.ui.message().find("not saved") != std::string::npos);
    window.drag("handle c", 30, 30);  // another change is reported again
    window.key(key::q, true);
    CHECK_FALSE(window.ui.wants_to_close());
    window.key(key::q, true);
    CHECK(window.ui.wants_to_close());
  }
  SECTION("from outside") {
    CHECK_FALSE(window.ui.may_close());
    CHECK(window.ui.may_close());
  }
  SECTION("saved") {
    window.key(key::s, true);
    CHECK(window.ui.may_close());
  }
  SECTION("another lesson keeps no file") {
    window.type("]");
    CHECK(window.ui.may_close());
  }
}

TEST_CASE("a scene that has no file is saved under a name in a folder, and from then on into that file", "[window]") {
  Lesson scene = disc;
  scene.made_from = "{}";
  const std::string folder = isect::test::scratch("isect-window-scene").string();
  std::filesystem::remove_all(folder);
  int saved = 0;
  std::string taken, refused;
  const auto text_of = [](const Parameters& p) { return "{\"scene\": " + to_json(p) + "}\n"; };
  WindowOptions options = {.reduced_motion = true, .figures = folder};
  options.save_scene = [&](const Lesson&, const Parameters&) { ++saved; };
  options.new_scene_file.text = [&](const Lesson&, const Parameters& p, const std::string& to) {
    if (to.ends_with("elsewhere")) throw BadInput(refused = "What the scene names does not lie there");
    return text_of(p);
  };
  options.new_scene_file.take = [&](const Lesson&, const Parameters& p, const std::string& path) {
    taken = path;
    scene.presets.front().parameters = p;
  };
  const std::vector<const Lesson*> lessons = {&scene, &ball};
  WindowDriver window(lessons, 1280, 800, {}, {}, options);
  const auto give = [&](const char* field, const std::string& words) {
    window.click(field);
    window.key(key::a, true);
    window.type(words);
    window.frames(2);
  };
  CHECK(window.ui.may_close());
  window.drag("handle c", 60, 30);
  CHECK_FALSE(window.ui.may_close());
  CHECK_THAT(window.ui.message(), isect::test::Contains("leaves it as it came"));

  window.key(key::s, true);
  window.frames(2);
  REQUIRE((window.has("save sheet") && window.has("save name") && window.has("save folder")));
  CHECK_FALSE((window.has("format png") || window.has("save as preset") || window.has("save scene")));
  give("save folder", folder + "/elsewhere");
  window.click("save");
  window.frames(2);
  CHECK(window.ui.message() == refused);
  CHECK((taken.empty() && !std::filesystem::exists(folder)));

  window.key(key::s, true);
  window.frames(2);
  give("save name", "mine.json");
  give("save folder", folder + "/scenes");
  window.click("save");
  window.frames(2);
  const std::string file = folder + "/scenes/mine.json";
  CHECK(window.ui.message() == "Saved " + file);
  CHECK(taken == file);
  CHECK(read_file(file) == text_of(window.player().parameters()));
  CHECK(window.ui.may_close());
  CHECK(window.player().played().preset_id() == scene.presets.front().id);  // nothing is "changed" any more
  CHECK(saved == 0);

  window.drag("handle c", 30, 30);
  CHECK_FALSE(window.ui.may_close());
  window.key(key::s, true);
  CHECK(saved == 1);
  CHECK_FALSE(window.has("save sheet"));
  std::filesystem::remove_all(folder);
}

TEST_CASE("a scene without a file is saved from the sheet of figures, too, and loses no other file", "[window]") {
  Lesson scene = disc;
  scene.made_from = "{}";
  const std::string folder = isect::test::scratch("isect-window-scenes").string();
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  write_file(folder + "/scene.json", "somebody's");
  WindowOptions options = {.reduced_motion = true, .figures = folder};
  options.save_scene = [](const Lesson&, const Parameters&) {};
  options.new_scene_file = {[](const Lesson&, const Parameters&, const std::string&) { return std::string("{}"); },
                            [](const Lesson&, const Parameters&, const std::string&) {}};
  WindowDriver window({&scene, &ball}, 1280, 800, {}, {}, options);
  window.type("s");
  window.frames(2);
  REQUIRE((window.has("format png") && window.has("save scene")));
  window.click("save scene");
  window.frames(2);
  CHECK(window.ui.message() == "Saved " + folder + "/scene-2.json");
  CHECK(read_file(folder + "/scene.json") == "somebody's");
  window.type("]");
  window.key(key::s, true);
  window.frames(2);
  CHECK((window.has("format png") && window.has("save as preset") && !window.has("save scene")));
  std::filesystem::remove_all(folder);
}

TEST_CASE("a scene of a file leaves the reader's place among the lessons as it was", "[window]") {
  Lesson scene = disc;
  scene.id = "scene", scene.made_from = "{}";
  const std::vector<const Lesson*> lessons = {&ball, &scene};
  Settings kept;
  kept.reader_state = place_at(ball.id, ball.presets.front().id);
  kept.reader_state->step = 1;
  kept.recent = {ball.id};
  WindowDriver window(lessons, 1280, 800, place_at("scene", disc.presets.front().id), kept);
  window.key(key::right);
  window.drag("handle c", 30, 10);
  REQUIRE(window.player().lesson().id == "scene");
  REQUIRE(window.ui.settings().reader_state);
  CHECK(window.ui.settings().reader_state->lesson == ball.id);
  CHECK(window.ui.settings().reader_state->step == 1);
  CHECK(window.ui.settings().recent == std::vector<std::string>{ball.id});
  window.type("]");
  CHECK(window.ui.settings().reader_state->step == 0);
}

TEST_CASE("a setting is saved as a preset, which the picker lists and opens", "[window]") {
  const std::string folder = (std::filesystem::temp_directory_path() / "isect-window-presets").string();
  std::filesystem::remove_all(folder);
  WindowDriver window(both, 1280, 800, {}, {}, {.reduced_motion = true, .figures = folder});
  window.drag("handle c", 60, 30);
  const Parameters saved = window.player().parameters();
  window.type("s");
  window.frames(2);
  window.click("save as preset");
  window.frames(2);
  CHECK(window.ui.message() == "Saved " + folder + "/point-disc/setting-1.json");
  window.type("1]");
  REQUIRE(window.player().lesson().id == "point-ball");
  window.key(key::o, true);
  window.frames(2);
  window.click("saved point-disc, setting-1");
  CHECK(window.player().lesson().id == "point-disc");
  CHECK((window.player().parameters() == saved));

  write_file(folder + "/point-disc/setting-1.json", "{");
  window.key(key::o, true);
  window.frames(2);
  window.click("saved point-disc, setting-1");
  window.frames(2);
  CHECK(window.ui.message().find("setting-1.json") != std::string::npos);
  std::filesystem::remove_all(folder);
}

TEST_CASE("a saved preset is listed wherever the window is opened next, until it is gone", "[window]") {
  const std::string folder = (std::filesystem::temp_directory_path() / "isect-presets-elsewhere").string();
  std::filesystem::remove_all(folder);
  Settings settings;
  Parameters saved;
  {
    WindowDriver window(both, 1280, 800, {}, {}, {.reduced_motion = true, .figures = folder});
    window.drag("handle c", 60, 30);
    saved = window.player().parameters();
    window.type("s");
    window.frames(2);
    window.click("save as preset");
    window.frames(2);
    settings = window.ui.settings();
  }
  settings.reader_state.reset();
  WindowDriver elsewhere(both, 1280, 800, {}, settings, {.reduced_motion = true, .figures = "/nowhere"});
  REQUIRE_FALSE((elsewhere.player().parameters() == saved));
  const std::string name = "saved point-disc, setting-1, in " + folder;
  elsewhere.key(key::o, true);
  elsewhere.frames(2);
  elsewhere.click(name);
  CHECK((elsewhere.player().parameters() == saved));
  std::filesystem::remove_all(folder);
  elsewhere.key(key::o, true);
  elsewhere.frames(2);
  CHECK_FALSE(elsewhere.has(name));
}

TEST_CASE("a preset keeps its name, its step and the camera that the reader has moved", "[window]") {
  const std::string folder = isect::test::scratch("isect-window-named").string();
  std::filesystem::remove_all(folder);
  WindowDriver window(both, 1280, 800, {}, {}, {.reduced_motion = true, .figures = folder});
  const auto save_as = [&](const char* name) {
    window.type("s");
    window.frames(2);
    window.click("save name");
    window.type(name);
    window.click("save as preset");
    window.frames(2);
  };
  window.key(key::right);
  save_as("a step");
  CHECK(window.ui.message() == "Saved " + folder + "/point-disc/a step.json");
  CHECK_FALSE(reader_state_from_json(read_file(folder + "/point-disc/a step.json"), both).camera);
  window.type("p");
  const Camera seen = window.player().camera().goal();
  save_as("seen near");
  window.key(key::home);
  save_as("a step");  // another setting: the first one is kept
  CHECK(window.ui.message() == "Saved " + folder + "/point-disc/a step-2.json");

  window.type("2f");
  window.key(key::o, true);
  window.frames(2);
  window.click("saved point-disc, seen near");
  window.frames(2);
  CHECK(window.player().played().preset_id() == "squared-inside");
  CHECK(window.player().index() == 1);
  CHECK(window.player().camera().goal().perspective);
  CHECK(window.player().camera().goal().half_height == Approx(seen.half_height));
  window.key(key::o, true);
  window.frames(2);
  CHECK((window.has("saved point-disc, a step") && window.has("saved point-disc, a step-2")));

  for (const char* wrong : {"a/b", ".hidden", "what?"}) {
    CAPTURE(wrong);
    window.key(key::escape);
    window.frames(2);
    window.type("s");
    window.frames(2);
    window.click("save name");
    window.type(wrong);
    window.frames(2);
    REQUIRE(window.has("refused name"));
    window.click("save");
    window.click("save as preset");
    CHECK(window.has("save sheet"));
    window.key(key::escape);  // lets go of the field, or closes the sheet
    window.frames(2);
  }
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) files += entry.is_regular_file();
  CHECK(files == 3);
  std::filesystem::remove_all(folder);
}

TEST_CASE("a figure is saved under the name that was typed, with the format's ending once", "[window]") {
  const std::string folder = isect::test::scratch("isect-window-name").string();
  std::filesystem::remove_all(folder);
  WindowDriver window(both, 1280, 800, {}, {}, {.reduced_motion = true, .figures = folder});
  for (const char* typed : {"my disc", "my disc.png", "  my disc "}) {
    CAPTURE(typed);
    window.type("s");
    window.frames(2);
    window.click("save name");
    window.type(typed);  // its s is a letter of the name
    CHECK(window.has("save sheet"));
    window.click("save");
    window.frames(2);
    CHECK(window.ui.message() == "Saved " + folder + "/my disc.png, with its alt text");
  }
  std::filesystem::remove_all(folder);
}

TEST_CASE("a folder that can't be written is told in the sheet, and another one is taken and kept", "[window]") {
  const std::string file = isect::test::scratch("isect-window-no-folder").string(), other = file + "-other";
  std::filesystem::remove_all(other);
  write_file(file, "a file where a folder should be");
  Settings kept;
  {
    WindowDriver window(both, 1280, 800, {}, {}, {.reduced_motion = true, .figures = file});
    window.type("s");
    window.key(key::enter);
    window.frames(2);
    CHECK(window.ui.message().find(file) != std::string::npos);
    REQUIRE(window.has("save sheet"));
    REQUIRE((window.has("refused folder") && window.has("folder 1")));
    CHECK(window.rect("folder 1").bottom < window.rect("save").top);
    CHECK(window.rect("save").bottom < window.rect("save sheet").bottom);
    window.key(key::escape);
    window.frames(2);
    CHECK_FALSE(window.has("save sheet"));
    window.key(key::right);  // the window goes on
    CHECK(window.player().index() == 1);
    CHECK(window.ui.settings().save_folder.empty());

    window.type("s");
    window.frames(2);
    CHECK_FALSE(window.has("refused folder"));
    window.click("save as preset");
    window.frames(2);
    REQUIRE(window.has("refused folder"));
    window.click("save folder");
    window.key(key::a, true);
    window.type(other);
    window.frames(2);
    CHECK_FALSE(window.has("refused folder"));
    window.click("save as preset");
    window.frames(2);
    CHECK(window.ui.message() == "Saved " + other + "/point-disc/setting-1.json");
    kept = window.ui.settings();
    CHECK(kept.save_folder == other);
  }
  kept.reader_state.reset();
  WindowDriver window(both, 1280, 800, {}, kept, {.reduced_motion = true, .figures = file});
  window.type("s");
  window.key(key::enter);
  window.frames(2);
  CHECK(window.ui.message().starts_with("Saved " + other + "/"));
  std::filesystem::remove(file);
  std::filesystem::remove_all(other);
}

TEST_CASE("a folder is chosen from those that are offered, and ~ is the reader's own", "[window]") {
  const std::string file = isect::test::scratch("isect-window-offered").string(), home = file + "-home";
  std::filesystem::remove_all(home);
  write_file(file, "a file where a folder should be");
  const char* const old = std::getenv("HOME");
  const std::string before = old ? old : "";
  for (const bool typed : {false, true}) {
    CAPTURE(typed);
    WindowDriver window(both, 1280, 800, {}, {}, {.reduced_motion = true, .figures = file});
    setenv("HOME", home.c_str(), 1);  // its fonts have been found by now
    window.type("s");
    window.key(key::enter);
    window.frames(2);
    REQUIRE(window.has("folder 1"));
    if (typed) {
      window.click("save folder");
      window.key(key::a, true);
      window.type("~/isect");
    } else {
      window.click("folder 1");
    }
    window.frames(2);
    window.click("save");
    window.frames(2);
    CHECK(window.ui.message().starts_with("Saved " + home + "/isect/point-disc/"));
    CHECK(window.ui.settings().save_folder == home + "/isect");
    old ? setenv("HOME", before.c_str(), 1) : unsetenv("HOME");
  }
  std::filesystem::remove(file);
  std::filesystem::remove_all(home);
}

TEST_CASE("settings survive a run, and a spoilt file or field gives defaults", "[window]") {
  const std::string file = isect::test::scratch("isect-settings-test.json").string();
  Settings s;
  s.theme = ThemeName::grey;
  s.save_format = "svg";
  s.speed = 1.5;
  s.nonstop = true;
  s.width = 1600;
  s.reader_state = Player(both).reader_state();
  s.reader_state->step = 3;
  s.scores["point-disc"] = {{{"squared/compare", true}, {"squared/length", false}}, true};
  s.scores["point-disc"].skipped = {"distance/compare"}, s.scores["point-disc"].solved = {"Find a point."};
  s.scores["point-disc"].seen = 3, s.scores["point-disc"].of = 5;
  s.save_folder = "/a/folder";
  s.recent = {"point-ball", "point-disc"};
  s.saved = {"/b/point-disc/setting-1.json", "/a/point-disc/setting-2.json"};
  write_settings(file, s);
  const Settings read = read_settings(file, both);
  CHECK(read.theme == ThemeName::grey);
  CHECK(read.save_format == "svg");
  CHECK(read.speed == 1.5);
  CHECK(read.nonstop);
  CHECK(read.width == 1600);
  REQUIRE(read.reader_state);
  CHECK(read.reader_state->step == 3);
  CHECK(read.scores.at("point-disc").right() == 1);
  CHECK(read.scores.at("point-disc").answers.size() == 2);
  CHECK(read.scores.at("point-disc").finished);
  CHECK(read.scores.at("point-disc").skipped == s.scores.at("point-disc").skipped);
  CHECK(read.scores.at("point-disc").solved == s.scores.at("point-disc").solved);
  CHECK((read.scores.at("point-disc").seen == 3 && read.scores.at("point-disc").of == 5));
  CHECK(read.save_folder == "/a/folder");
  CHECK(read.recent == s.recent);
  CHECK(read.saved == s.saved);

  write_file(file, R"({"theme": 7, "width": "wide", "save_theme": "gray", "speed": 2, "place": {"lesson": "x"}})");
  const Settings half = read_settings(file, both);
  CHECK(half.theme == ThemeName::dark);
  CHECK(half.width == 1280);
  CHECK(half.save_theme == ThemeName::print);
  CHECK(half.speed == 2);
  CHECK_FALSE(half.reader_state);

  for (const char* wide : {"-2147483649", "40000", "799", "1e99", "-1"}) {  // what no screen has
    INFO(wide);
    write_file(file, std::string(R"({"scores": [1], "recent": ["no lesson", 4], "width": )") + wide + "}");
    CHECK(read_settings(file, both).width == 1280);
    CHECK(read_settings(file, both).scores.empty());
    CHECK(read_settings(file, both).recent.empty());
  }

  write_file(file, "\x01\x02 no JSON");
  CHECK(read_settings(file, both).width == 1280);
  write_file(file, R"({"width": 1600, "place": )" + std::string(300'000, '[') + std::string(300'000, ']') + "}");
  CHECK(read_settings(file, both).width == 1280);
  std::filesystem::remove(file);
  CHECK(read_settings(file, both).height == 800);
}

TEST_CASE("a spoilt file of settings is set aside, and none that was set aside before is lost", "[window]") {
  const std::string file = isect::test::scratch("isect-spoilt-test.json").string();
  const auto remove_all = [&] {
    for (const std::string end : {"", ".damaged", ".damaged-2"}) std::filesystem::remove(file + end);
  };
  remove_all();
  CHECK(set_spoilt_settings_aside("").empty());
  CHECK(set_spoilt_settings_aside(file).empty());  // no such file
  write_settings(file, {});
  CHECK(set_spoilt_settings_aside(file).empty());
  CHECK(std::filesystem::exists(file));

  write_file(file, R"({"theme": "grey", "pla)");
  CHECK(set_spoilt_settings_aside(file) ==
        file + " is damaged, and the window starts afresh. It is kept as " + file + ".damaged");
  CHECK_FALSE(std::filesystem::exists(file));
  write_file(file, "[]");
  CHECK(set_spoilt_settings_aside(file).ends_with(".damaged-2"));
  CHECK(read_file(file + ".damaged") == R"({"theme": "grey", "pla)");
  CHECK(read_file(file + ".damaged-2") == "[]");
  remove_all();
}

TEST_CASE("a file without a version is read, damaged marks of a lesson are left out, a newer file is copied",
          "[window]") {
  const std::string file = isect::test::scratch("isect-versions-test.json").string(), aside = file + ".newer";
  std::filesystem::remove(aside);
  write_file(file, R"({"theme": "grey", "scores": {"point-disc": {"finished": true, "answers": {"/compare": true}}}})");
  CHECK(set_spoilt_settings_aside(file).empty());
  const Settings old = read_settings(file, both);
  CHECK(old.theme == ThemeName::grey);
  CHECK(old.scores.at("point-disc").finished);
  CHECK(old.scores.at("point-disc").right() == 1);
  CHECK((old.scores.at("point-disc").skipped.empty() && old.scores.at("point-disc").of == 0));
  CHECK(text_of(old).find("\"version\": 2") != std::string::npos);

  write_file(file, R"({"version": 2, "save_folder": 5, "scores": {"point-disc": {"skipped": ["/compare", 7],
    "solved": "all", "seen": 9, "of": 4, "answers": {"/length": false, "/way": 3}}}})");
  const Score damaged = read_settings(file, both).scores.at("point-disc");
  CHECK(damaged.skipped == std::set<std::string>{"/compare"});
  CHECK((damaged.solved.empty() && damaged.seen == 0 && damaged.of == 0));
  CHECK(damaged.answers.size() == 1);
  CHECK(read_settings(file, both).save_folder.empty());

  const std::string newer = R"({"version": 3, "theme": "grey", "of tomorrow": {"a": 1}})";
  write_file(file, newer);
  const std::string told = file + " was written by a newer isect, of which this one keeps what it knows. ";
  CHECK(set_spoilt_settings_aside(file) == told + "A copy of the file is kept as " + aside);
  CHECK(read_file(aside) == newer);
  CHECK(read_settings(file, both).theme == ThemeName::grey);
  std::filesystem::remove(file);
  std::filesystem::remove(aside);
}

TEST_CASE("a camera that nobody has moved is not kept, so that presets go on framing themselves", "[window]") {
  WindowDriver window(both);
  CHECK_FALSE(window.ui.settings().reader_state->camera);
  window.key(key::right, false, true);
  CHECK(window.ui.settings().reader_state->camera);
}

TEST_CASE("without a display the window says so", "[window]") {
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  CHECK_THROWS_AS(show(both, {}, {}), NoDisplay);
}

}  // namespace window_state_test
