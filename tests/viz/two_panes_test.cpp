// Two panes: method against method, or preset against preset, at one step and through one camera.

#include <filesystem>

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/scratch.h"
#include "tests/viz/sample_lesson.h"
#include "tests/viz/window_driver.h"
#include "viz/walk/closing.h"
#include "viz/walk/renamed_lines.h"
#include "viz/walk/walk_difference.h"

namespace two_panes_test {
using namespace isect;
using namespace isect::viz;

namespace {

const Lesson disc = sample::lesson(), ball = sample::other_lesson();
const std::vector<const Lesson*> both = {&disc, &ball};

Vec3 center(WindowDriver& window) { return std::get<Vec3>(window.player().parameters().at("c")); }

/// Opens the menu of the second pane and chooses.
void choose(WindowDriver& window, const std::string& name) {
  window.click("against");
  window.frames(2);
  window.click(name);
  window.frames(2);
}

void check_alike(const WindowDriver& window) {
  const Rect a = window.rect("scene"), b = window.rect("other scene");
  CHECK(a.width() == Approx(b.width()).margin(1));
  CHECK(a.height() == b.height());
  CHECK(a.right <= b.left);
}

}  // namespace

TEST_CASE("V, a button and the method's menu set two methods side by side, and take one away", "[window]") {
  WindowDriver window(both);
  const Rect scene = window.rect("scene");
  const Camera camera = window.player().camera().goal();
  window.type("v");
  REQUIRE(window.has("other scene"));
  check_alike(window);
  CHECK((window.ui.settings().beside == Beside{"point-disc", "distance", ""}));
  window.type("v");
  CHECK_FALSE(window.has("other scene"));
  CHECK_FALSE(window.ui.settings().beside);
  CHECK(window.rect("scene").width() == scene.width());
  CHECK(window.player().camera().goal() == camera);

  window.click("two panes");
  CHECK(window.has("other scene"));
  window.click("one pane");
  window.frames();
  CHECK_FALSE(window.has("other scene"));

  window.click("method");
  window.frames(2);
  window.click("method against method");
  window.frames(2);
  CHECK(window.has("other scene"));
  window.type("]");
  window.frames(2);
  CHECK_FALSE(window.has("other scene"));
  window.type("[");
  window.frames(2);
  CHECK_FALSE(window.has("other scene"));  // it does not come back by itself
}

TEST_CASE("two panes are copied with the state and come back when it is pasted", "[window]") {
  WindowDriver window(both);
  window.type("v");
  window.frames();
  window.key(key::c, true);
  const std::string copied = ImGui::GetClipboardText();
  CHECK_THAT(copied, isect::test::Contains("\"beside\": {\"method\":\"distance\"}"));
  CHECK((reader_state_from_json(copied, both).beside == OtherSide{"distance", ""}));
  window.type("v");
  REQUIRE_FALSE(window.has("other scene"));
  window.key(key::v, true);
  window.frames(2);
  CHECK(window.has("other scene"));
  CHECK((window.ui.settings().beside == Beside{"point-disc", "distance", ""}));

  WindowDriver again(both, 1280, 800, reader_state_from_json(copied, both));
  CHECK(again.has("other scene"));
  again.type("v");
  again.key(key::c, true);
  CHECK_THAT(ImGui::GetClipboardText(), !isect::test::Contains("beside"));
  again.key(key::v, true);
  again.frames(2);
  CHECK_FALSE(again.has("other scene"));
}

TEST_CASE("beside what stands in a copied state is a method or a preset of its lesson", "[window]") {
  const auto refused = [&](const std::string& beside) {
    try {
      reader_state_from_json(R"({"lesson": "point-disc", "beside": )" + beside + "}", both);
    } catch (const BadInput& why) {
      return std::string(why.what());
    }
    return std::string();
  };
  CHECK_THAT(refused(R"({"method": "distanze"})"), isect::test::Contains("\"distance\""));
  CHECK_THAT(refused(R"({"preset": "nowhere"})"), isect::test::Contains("nowhere"));
  CHECK_THAT(refused("{}"), isect::test::Contains("either a method or a preset"));
  CHECK_THAT(refused("7"), isect::test::Contains("no JSON object"));
}

TEST_CASE("in a small window a question has the place of both codes, and covers no scene", "[window]") {
  const auto [width, height] = GENERATE(table<float, float>({{800, 600}, {1000, 700}, {1040, 900}}));
  CAPTURE(width, height);
  WindowDriver window(lessons::all_lessons(), width, height, place_at("ray-sphere", "two-roots"));
  window.type("v");
  window.frames(2);
  const Rect scene = window.rect("scene"), code = window.rect("code panel");
  for (int i = 0; i < 12 && !window.player().quiz().asked(); ++i) window.key(key::right);
  window.frames(3);
  REQUIRE(window.player().quiz().asked());
  REQUIRE(window.has("other scene"));
  const Rect asked = window.rect("lecture");
  CHECK((asked.top == code.top && asked.bottom == code.bottom && asked.right == width));
  CHECK((window.rect("scene").bottom == scene.bottom && window.rect("scene").bottom == asked.top));
  CHECK_FALSE((window.has("code panel") || window.has("other code panel")));
  window.player().answer(0);
  window.frames(2);
  CHECK(window.has("what came of it"));
  CHECK((window.has("line " + std::to_string(window.player().step().line + 1)) && window.has("told state")));
  for (int i = 0; i < 12 && window.has("lecture"); ++i) window.key(key::right);
  CHECK(window.has("code panel"));
}

TEST_CASE("a lecture with two panes has both scenes above its strip, which tells both lines", "[window]") {
  const auto [width, height] = GENERATE(table<float, float>({{800, 600}, {1280, 800}}));
  CAPTURE(width, height);
  WindowDriver window(both, width, height);
  window.key(key::tab);
  const Rect strip = window.rect("lecture");
  window.type("v");
  for (int i = 0; i < 4 && window.player().index() == 0; ++i) window.key(key::page_down);  // first the strip's rest
  window.frames(2);
  CHECK(window.rect("lecture").top == strip.top);
  CHECK((window.rect("scene").bottom == strip.top && window.rect("other scene").bottom == strip.top));
  CHECK(window.rect("scene").height() > 200);
  CHECK_FALSE((window.has("code panel") || window.has("other code panel")));
  REQUIRE((window.has("line 2") && window.has("other line 2")));
  CHECK(window.rect("line 2").bottom <= window.rect("other line 2").top);
}

TEST_CASE("in a lecture the second pane's line leads both panes to another step of that line", "[window]") {
  Settings settings;
  settings.beside = Beside{"aabb-aabb", "", "equal"};
  WindowDriver window(lessons::all_lessons(), 1600, 1200, place_at("aabb-aabb", "overlapping"), settings, layout_only);
  window.key(key::tab);
  const Walk& walk = window.player().walk();
  bool led = false;
  for (int i = 0; i < window.player().count() && !led; ++i) {
    window.player().go_to(i);
    window.frames(3);
    const std::string line = "other line " + std::to_string(walk.steps[i].line + 1);
    if (!window.has(line)) continue;
    window.click(line);
    window.frames(2);
    led = window.player().index() != i;
    CHECK(walk.steps[window.player().index()].line == walk.steps[i].line);
  }
  CHECK(led);
}

TEST_CASE("the first line and the first value that differ are marked in both panes", "[window]") {
  WindowDriver window(both);
  window.type("v");
  window.frames();
  // The texts differ in line 2: l² ← l · l against d ← |l|.
  CHECK(window.rect("parted line").top == window.rect("line 2").top);
  CHECK(window.rect("other parted line").top == window.rect("other line 2").top);
  CHECK_FALSE(window.has("parted value"));
  window.key(key::right);
  window.frames();
  CHECK(window.has("parted value"));
  CHECK(window.has("other parted value"));

  choose(window, "against squared-outside");
  CHECK((window.ui.settings().beside == Beside{"point-disc", "", "squared-outside"}));
  CHECK_FALSE(window.has("parted line"));  // one text, and so far they run alike
  CHECK(window.has("parted value"));
  window.key(key::end);
  for (int i = 0; i < 3 && window.player().step().slug != "in"; ++i) window.key(key::left);
  window.frames();
  CHECK(window.rect("parted line").top == window.rect("line 5").top);
  CHECK(window.rect("other parted line").top == window.rect("other line 4").top);
}

TEST_CASE("where the panes differ is brought into view by what tells of it", "[window]") {
  Settings settings;
  settings.beside = Beside{"ray-sphere", "quadratic", ""};
  WindowDriver window(isect::lessons::all_lessons(), 800, 600, place_at("ray-sphere", "two-roots"), settings);
  window.player().go_to(window.player().count() - 3);
  window.frames(3);
  for (const std::string side : {"", "other "}) {
    INFO(side);
    const auto seen = [&] {
      const Rect line = window.rect(side + "parted line"), all = window.rect(side + "code lines");
      return line.top >= all.top - 1 && line.bottom <= all.bottom + 1;
    };
    CHECK_FALSE(seen());
    window.click(side + "differs");
    window.frames(3);
    CHECK(seen());
  }
}

TEST_CASE("both panes keep one step and one camera, whichever is touched", "[window]") {
  WindowDriver window(both);
  window.type("v");
  window.frames();
  const Camera before = window.player().camera().goal();
  const Rect other = window.rect("other scene"), first = window.rect("scene");
  const Rect far = window.rect("handle c");
  window.drag(other.right - 30, other.top + 150, other.right - 90, other.top + 180, 1);
  CHECK(window.player().camera().goal() != before);
  window.frames(2);
  const Rect c = window.rect("handle c"), c_other = window.rect("other handle c");
  CHECK(c.left != far.left);
  CHECK(c.left - first.left == Approx(c_other.left - other.left).margin(1));
  CHECK(c.top == Approx(c_other.top).margin(1));
  window.key(key::z, true);
  window.frames(2);
  CHECK(window.player().camera().goal() == before);

  window.click("other line 3");
  CHECK(window.player().index() == 2);
  window.key(key::home);
  CHECK(window.player().index() == 0);
}

TEST_CASE("with two methods a handle of either pane moves both, and one undo takes it back", "[window]") {
  WindowDriver window(both);
  window.type("v");
  window.frames();
  const Vec3 before = center(window);
  const Rect c = window.rect("handle c");
  window.drag("other handle c", 40, 20);
  CHECK(center(window) != before);
  CHECK(window.player().played().method() == "squared");
  window.frames();
  CHECK(window.rect("handle c").middle_x() == Approx(c.middle_x() + 40).margin(1));
  window.key(key::z, true);
  CHECK(center(window) == before);
  window.drag("handle c", 30, 0);
  CHECK(center(window) != before);
  window.frames();
  CHECK(window.rect("other handle c").middle_x() - window.rect("other scene").left ==
        Approx(window.rect("handle c").middle_x() - window.rect("scene").left).margin(1));
}

TEST_CASE("a preset beside this one stays as it is", "[window]") {
  WindowDriver window(both);
  window.type("v");
  window.frames();
  choose(window, "against squared-on");
  CHECK_FALSE(window.has("other handle c"));
  const Vec3 before = center(window);
  window.drag("handle c", 40, 20);
  CHECK(center(window) != before);
  CHECK(window.has("other scene"));
  CHECK((window.ui.settings().beside == Beside{"point-disc", "", "squared-on"}));
}

TEST_CASE("a lesson without other methods sets the next preset beside this one, or the one it came from", "[window]") {
  ReaderState state;
  state.lesson = "sphere-sphere";
  WindowDriver window(lessons::all_lessons(), 1280, 800, state);
  const auto group = window.player().played().group();
  window.type("v");
  CHECK(window.ui.settings().beside->preset == group[1]->id);
  window.type("v");
  window.drag("handle " + window.player().scene().handles.front().parameter, 20, 10);
  window.type("v");
  CHECK(window.ui.settings().beside->preset == group[0]->id);
}

TEST_CASE("two panes are kept between runs, and what is no pane is not", "[window]") {
  const std::string file = isect::test::scratch("isect-two-panes.json").string();
  Settings settings;
  settings.beside = Beside{"point-disc", "distance", ""};
  ReaderState state;
  state.lesson = "point-disc";
  settings.reader_state = state;
  settings.reader_state->parameters = disc.presets.front().parameters;
  settings.reader_state->step = 0;
  write_settings(file, settings);
  const Settings kept = read_settings(file, both);
  CHECK((kept.beside == settings.beside));
  WindowDriver window(both, 1280, 800, *kept.reader_state, kept);
  CHECK(window.has("other scene"));

  Settings wrong = settings;
  wrong.beside->method = "guessing";
  WindowDriver other(both, 1280, 800, *kept.reader_state, wrong);
  CHECK_FALSE(other.has("other scene"));
  CHECK_FALSE(other.ui.message().empty());
  write_file(file, R"({"beside": {"lesson": "point-disc", "method": "", "preset": 3}})");
  CHECK_FALSE(read_settings(file, both).beside);
  std::filesystem::remove(file);
}

TEST_CASE("lines that differ by a name alone are no difference, and others stay one", "[walk_difference]") {
  const auto text = [](const std::string& way) {
    Walk walk = sample::walk(sample::parameters("squared", {0.5, 0.5, 0}, Vec3::Zero(), 1.5));
    if (way == "renamed")
      walk.pseudocode = {"m ← c − p", "m² ← m · m", "if m² > r²", "  return OUT", "return IN"};
    else if (way == "sign")
      walk.pseudocode = {"m ← c − p", "m² ← m · m", "if m² ≥ r²", "  return OUT", "return IN"};
    else if (way == "not kept to")
      walk.pseudocode = {"m ← c − p", "q ← m · m", "if m² > r²", "  return OUT", "return IN"};
    return walk;
  };
  const Walk usual = text(""), renamed = text("renamed"), sign = text("sign"), mixed = text("not kept to");
  CHECK(walk_difference(usual, 0, renamed, 0).renamed == std::vector{0, 1, 2});
  CHECK(walk_difference(usual, 0, renamed, 0).line_a == -1);
  CHECK(walk_difference(usual, 0, sign, 0).renamed == std::vector{0, 1});
  CHECK(walk_difference(usual, 0, sign, 0).line_b == 2);
  CHECK(walk_difference(usual, 0, mixed, 0).renamed == std::vector{0});
  CHECK(walk_difference(usual, 0, mixed, 0).line_a == 1);

  Walk told = renamed;
  told.steps[1].values[0].name = "*m*^2";
  CHECK(walk_difference(usual, 1, told, 1).value_a == -1);
  told.steps[1].values[0].value += 1;
  CHECK(walk_difference(usual, 1, told, 1).value_b == 0);
  told.steps[1].values[0] = usual.steps[1].values[0];
  told.steps[1].values[0].name = "*k*^2";
  CHECK(walk_difference(usual, 1, told, 1).value_b == 0);
}

TEST_CASE("only what a text gives a name itself may have another one", "[walk_difference]") {
  using Text = std::vector<std::string>;
  const auto alike = [](const Text& a, const Text& b) { return compared_texts(a, b).parted == -1; };
  CHECK(alike({"for each axis i of x, y, z", "  if p_i ≠ q_i"}, {"for each axis i of x, y, z", "  if p_i ≠ q_i"}));
  CHECK(alike({"for two nodes a, b", "  if a and b meet"}, {"for two nodes u, v", "  if u and v meet"}));
  CHECK(alike({"[t_in, t_out] ← [0, 1]", "return [t_in, t_out]"}, {"[begin, end] ← [0, 1]", "return [begin, end]"}));
  CHECK(alike({"cull(node): test its box", "  node is a leaf: stop", "cull(root)"},
              {"skip(part): test its box", "  part is a leaf: stop", "skip(root)"}));
  CHECK(alike({"a′ ← a − o", "return a′ · d"}, {"b ← a − o", "return b · d"}));
  CHECK_FALSE(alike({"f ← o − c"}, {"l ← c − o"}));  // what is given means something
  CHECK_FALSE(alike({"if a_min > b_max"}, {"if b_min > a_max"}));
  CHECK_FALSE(alike({"for each neighbour of a", "  test a"}, {"for each neighbour of b", "  test b"}));
  CHECK_FALSE(alike({"t₁ ← p; t₂ ← q", "return t₁"}, {"t₂ ← p; t₁ ← q", "return t₁"}));  // exchanged, and then not
  CHECK_FALSE(alike({"t ← p", "u ← q", "return t"}, {"t ← p", "t ← q", "return t"}));    // two names become one
  CHECK_FALSE(alike({"t ← p"}, {"t ← p", "return t"}));
  CHECK(compared_texts({"t ← p", "return t"}, {"s ← p", "return s"}).renamed == std::vector{0, 1});
  const ComparedTexts texts = compared_texts({"t ← p", "return t"}, {"s ← p", "return s"});
  CHECK((is_renamed(texts, "t²", "s²") && !is_renamed(texts, "t²", "t²") && !is_renamed(texts, "t²", "s") &&
         is_renamed(texts, "k", "k")));
}

TEST_CASE("no two methods of a lesson are told apart by names alone where they differ in more", "[walk_difference]") {
  const Lesson& lesson = lesson_named(lessons::all_lessons(), "ray-sphere");
  const auto walk = [&](const char* id) { return lesson.walk(preset(lesson, id).parameters); };
  const WalkDifference halves = walk_difference(walk("two-roots-quadratic"), 0, walk("two-roots-half-b"), 0);
  CHECK(halves.line_a == 2);  // B ← 2 f · d against B ← f · d
  CHECK(halves.renamed.empty());
  const WalkDifference signs = walk_difference(walk("two-roots"), 0, walk("two-roots-quadratic"), 0);
  CHECK(signs.line_a == 0);  // l ← c − o against f ← o − c: it points the other way
}

TEST_CASE("panes whose texts differ by names alone mark them weakly, and say so", "[window]") {
  Lesson lesson = disc;
  lesson.id = "names-differ";
  lesson.steps = [](const Parameters& values) {
    Parameters squared = values;
    squared["way"] = std::string("squared");
    Walk walk = sample::walk(squared);
    if (std::get<std::string>(values.at("way")) == "squared") return walk;
    walk.pseudocode[0] = "m ← c − p", walk.pseudocode[1] = "m² ← m · m", walk.pseudocode[2] = "if m² > r²";
    for (Step& step : walk.steps)
      for (Value& value : step.values)
        if (value.name == "*l*^2") value.name = "*m*^2";
    return walk;
  };
  WindowDriver window({&lesson});
  window.type("v");
  window.frames(2);
  for (const std::string side : {"", "other "}) {
    INFO(side);
    CHECK_FALSE((window.has(side + "parted line") || window.has(side + "parted value")));
    for (const char* line : {"1", "2", "3"})
      CHECK(window.rect(side + "renamed line " + line).top == window.rect(side + "line " + line).top);
    CHECK_FALSE(window.has(side + "renamed line 4"));
    CHECK(window.has(side + "differs"));  // "≈ same but for a name, line 1"
  }
  window.key(key::right);
  window.frames();
  CHECK_FALSE((window.has("parted value") || window.has("other parted value")));
}

TEST_CASE("where walks part is told up to the steps shown, and no further", "[walk_difference]") {
  const auto walk = [](const Vec3& p) { return sample::walk(sample::parameters("squared", p, Vec3::Zero(), 1.5)); };
  const Walk in = walk({0.5, 0.5, 0}), out = walk({2.5, 1, 0});
  CHECK((walk_difference(in, 2, in, 2) == WalkDifference{}));
  CHECK(walk_difference(in, 2, out, 2).line_a == -1);
  CHECK(walk_difference(in, 3, out, 3).line_a == 4);
  CHECK(walk_difference(in, 3, out, 3).line_b == 3);
  CHECK(walk_difference(in, 1, out, 1).value_a == 0);
  CHECK(walk_difference(in, 0, out, 0).value_a == -1);
  CHECK(walk_difference(in, 0, in, 1).value_b == 0);  // only the second has come to a value
  CHECK(walk_difference(in, 0, in, 1).value_a == -1);
}

}  // namespace two_panes_test
