// What the window copies, `render --preset FILE` shows: pixel by pixel the figure that the window saves itself.

#include <algorithm>
#include <fstream>

#include "lessons/lessons.h"
#include "tests/app/shell.h"
#include "tests/catch.h"
#include "tests/viz/window_driver.h"
#include "viz/compose/compose.h"
#include "viz/player/reader_state.h"

namespace copied_test {
namespace viz = isect::viz;
using namespace isect::test;

namespace {

/// A window on a lesson, whose saved figures lie below `folder`.
viz::WindowDriver window_on(const std::string& lesson, const std::string& format, const std::string& folder) {
  viz::ReaderState state;
  state.lesson = lesson;
  viz::Settings settings;
  settings.save_format = format;
  settings.save_theme = viz::ThemeName::screen;
  return {isect::lessons::all_lessons(), 1280, 800, state, settings, {.reduced_motion = true, .figures = folder}};
}

/// Turns, moves and draws the scene near, from a place beside all handles.
void look_elsewhere(viz::WindowDriver& window) {
  const viz::Rect scene = window.rect("scene");
  const float x = scene.left + 40, y = scene.top + 150;
  window.drag(x, y, x + 90, y + 35);
  window.drag(x, y, x + 25, y - 15, 1);
  window.wheel(3);
  window.type("p");
}

/// All of a figure without its metadata.
std::string drawn(const std::string& figure) {
  if (!figure.starts_with("<?xml")) {
    const std::vector<std::uint8_t> pixels = viz::read_png(figure).rgba;
    return {pixels.begin(), pixels.end()};
  }
  const std::size_t begin = figure.find("<rect");
  REQUIRE(begin != figure.npos);
  return figure.substr(begin);
}

/// A figure's metadata without the name of the file that it was first written to.
viz::Metadata place_in(const std::string& figure) {
  viz::Metadata data = figure.starts_with("<?xml") ? viz::svg_metadata(figure) : viz::png_metadata(figure);
  data.erase("file");
  return data;
}

}  // namespace

TEST_CASE("a view that was orbited, moved and zoomed in the window is rendered to the pixel", "[copied]") {
  const Shell shell;
  const std::string lesson = GENERATE("sphere-aabb", "rays", "ray-sphere");  // turned, flat, and with an axis
  const std::string format = GENERATE("png", "svg");
  INFO(lesson << " " << format);
  viz::WindowDriver window = window_on(lesson, format, (shell.work() / "saved").string());
  window.key(viz::key::right);
  look_elsewhere(window);
  REQUIRE(window.player().camera().now().half_height !=
          viz::Player(isect::lessons::all_lessons(), {lesson, {}, {}, {}, {}}).camera().now().half_height);

  window.key(viz::key::c, true);
  write(shell.work() / "view.json", ImGui::GetClipboardText());
  window.type("s");
  window.frames(2);
  window.key(viz::key::enter);
  window.frames(2);
  const std::string told = window.ui.message(), before = "Saved ";  // "Saved FILE, with its alt text"
  const std::string saved = told.substr(before.size(), told.find(", with") - before.size());

  const Ran r = shell("isect render --preset view.json --format " + format + " --out -");
  CHECK(r.status == 0);
  CHECK(r.err.empty());
  CHECK(drawn(r.out) == drawn(contents(saved)));
  CHECK(place_in(r.out) == place_in(contents(saved)));
}

TEST_CASE("a time within a step's motion is rendered as it was copied, and drawn again from its figure", "[copied]") {
  const Shell shell;
  const std::string lesson = GENERATE("moving-bodies", "collision");
  const std::string format = GENERATE("png", "svg");
  INFO(lesson << " " << format);
  viz::WindowDriver window = window_on(lesson, format, (shell.work() / "saved").string());
  viz::Player& player = window.player();
  if (lesson == "collision") player.load(viz::preset(player.lesson(), "tunnelling"));
  for (int i = 0; i < player.count() && !(player.time() && player.time()->contact); ++i) player.go_to(i);
  REQUIRE(player.time());
  const auto saved = [&] {
    window.frames(2);
    window.type("s");
    window.frames(2);
    window.key(viz::key::enter);
    window.frames(2);
    const std::string told = window.ui.message(), before = "Saved ";
    return told.substr(before.size(), told.find(", with") - before.size());
  };
  const std::string usual = saved();
  const double t = player.time()->lo + 0.375 * (player.time()->hi - player.time()->lo);
  player.set_time(t);
  const std::string figure = saved();
  CHECK(drawn(contents(figure)) != drawn(contents(usual)));
  CHECK(place_in(contents(figure)).contains("time"));
  CHECK_FALSE(place_in(contents(usual)).contains("time"));

  window.key(viz::key::c, true);
  write(shell.work() / "moment.json", ImGui::GetClipboardText());
  const Ran r = shell("isect render --preset moment.json --format " + format + " --out -");
  CHECK(r.err.empty());
  CHECK(drawn(r.out) == drawn(contents(figure)));
  CHECK(place_in(r.out) == place_in(contents(figure)));
  const Ran again = shell("isect render '" + figure + "' --format " + format + " --out -");
  CHECK(again.err.empty());
  CHECK(drawn(again.out) == drawn(contents(figure)));
  CHECK(place_in(again.out) == place_in(contents(figure)));
  std::string told = shell("isect explain moment.json").out;
  std::ranges::replace(told, '\n', ' ');
  CHECK_THAT(told, Contains("The picture shows t = "));
  CHECK(shell("isect show '" + figure + "'").status == 77);  // nothing is refused but the missing display
}

TEST_CASE("a preset's file tells its time's step and range where they are wrong", "[copied]") {
  const Shell shell;
  const auto refused = [&](const std::string& fields) {
    write(shell.work() / "wrong.json", "{\"lesson\": \"moving-bodies\", \"preset\": \"boxes-meet\"" + fields + "}");
    const Ran r = shell("isect render --preset wrong.json --format svg --out -");
    CHECK(r.status == 2);
    return r.err;
  };
  CHECK_THAT(refused(R"(, "step": 8, "time": 2.5)"), Contains("wrong.json: time: 2.5") && Contains("from 0 to 2"));
  CHECK_THAT(refused(R"(, "step": 10, "time": 1)"), Contains("nothing moves at step 10"));
  CHECK_THAT(refused(R"(, "time": 1)"), Contains("of which step"));

  // Another setting may have another motion: the time stays within it.
  write(shell.work() / "late.json", R"({"lesson": "moving-bodies", "preset": "boxes-meet", "step": 1, "time": 2})");
  const Ran r = shell("isect render --preset late.json --set duration=1 --format svg --out -");
  CHECK(r.status == 0);
  CHECK(place_in(r.out).at("time") == "1.0");
}

TEST_CASE("a figure shows from the middle to the top edge what the window showed", "[copied]") {
  const Shell shell;
  viz::WindowDriver window = window_on("sphere-aabb", "png", (shell.work() / "saved").string());
  look_elsewhere(window);
  const viz::Camera camera = *window.player().reader_state().camera;
  const viz::Rect rect = window.rect("scene");
  const viz::View scene(camera, rect.width(), rect.height());
  const viz::View picture = viz::figure(window.player().step(), camera, viz::ThemeName::screen, 960, 600).view;
  const double ratio = picture.height() / scene.height();
  for (const viz::Vec3& p : {viz::Vec3(0, 0, 0), viz::Vec3(1, 2, -1), viz::Vec3(-2, 0.5, 1)}) {
    const viz::Vec2 in_window = scene.project(p).at - viz::Vec2(scene.width(), scene.height()) / 2;
    const viz::Vec2 in_figure =
        picture.project(p).at - picture.corner() - viz::Vec2(picture.width(), picture.height()) / 2;
    CHECK((in_figure - ratio * in_window).norm() < 1e-9);
  }
}

}  // namespace copied_test
