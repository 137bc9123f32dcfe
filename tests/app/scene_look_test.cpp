// How the objects of a scene look where its author says so: colours.

#include <algorithm>

#include "app/scene/lesson.h"
#include "tests/app/refusals.h"
#include "tests/app/shell.h"
#include "tests/catch.h"

namespace scene_look_test {
namespace scene = isect::program::scene;
namespace viz = isect::viz;
using namespace isect::test;
using viz::Role;

namespace {

std::string scene_of(const std::string& color_of_a, const std::string& color_of_b) {
  return R"({"objects": [{"circle": "A", "center": [0, 0], "radius": 1)" + color_of_a + "},\n" +
         R"({"circle": "B", "center": [1, 0], "radius": 1)" + color_of_b + R"(}], "ask": [["A", "B"], ["B", "A"]]})";
}
std::string color(const std::string& name) { return ", \"color\": \"" + name + "\""; }

/// Returns the roles of a scene's circles.
std::vector<Role> roles(const viz::Scene& of) {
  std::vector<Role> all;
  for (const viz::Item& item : of.items)
    if (const viz::Circle* circle = std::get_if<viz::Circle>(&item)) all.push_back(circle->role);
  return all;
}

}  // namespace

TEST_CASE("an object has the role or the colour that its author chose, in all steps", "[scene]") {
  const viz::Lesson by_role = scene::lesson_of(scene_of(color("second"), color("text")), "");
  const viz::Walk roled = by_role.walk(by_role.presets.front().parameters);
  for (int i = 0; i < 3; ++i) CHECK(roles(roled.steps[i].scene) == std::vector{Role::second, Role::text});
  CHECK(roled.steps[0].scene.colours.empty());

  const viz::Lesson lesson = scene::lesson_of(scene_of(color("teal"), color("#abc")), "");
  const viz::Walk walk = lesson.walk(lesson.presets.front().parameters);
  for (int i = 0; i < 3; ++i) {
    INFO(i);
    const viz::Scene& shown = walk.steps[i].scene;
    CHECK(shown.colours == walk.steps[0].scene.colours);
    const std::vector<Role> own = roles(shown);
    REQUIRE(own.size() == 2);
    const auto colour = [&](Role role) { return shown.colours.at(static_cast<std::size_t>(role) - viz::role_count); };
    CHECK(colour(own[0]).rgb == 0x008080);
    CHECK(colour(own[1]).rgb == 0xAABBCC);
    CHECK(colour(own[0]).like == (i == 2 ? Role::second : Role::first));  // in grey print they differ as others do
    CHECK(colour(own[1]).like == (i == 2 ? Role::first : Role::second));
    for (const viz::Handle& handle : shown.handles) CHECK(handle.role < viz::own_role(0));
  }
}

TEST_CASE("own colours are drawn in every theme, and grey print keeps its hatch", "[scene]") {
  const Shell shell;
  write(shell.work() / "own.json", scene_of("", color("#1f77b4")));
  write(shell.work() / "usual.json", scene_of("", ""));
  const auto drawn = [&](const std::string& name, const std::string& theme) {
    const auto ran = shell("isect render " + name + ".json --step 2 --format svg --theme " + theme + " --out " + theme);
    INFO(ran.err);
    CHECK(ran.status == 0);
    std::string svg = contents(shell.work() / (theme + "/scene/" + name + "/02-a-b.svg"));
    return svg.substr(svg.find("</desc>"));  // the metadata before it differ
  };
  CHECK_THAT(drawn("own", "print"), Contains("#1f77b4"));
  CHECK_THAT(drawn("usual", "print"), !Contains("#1f77b4"));
  CHECK_THAT(drawn("own", "grey"), !Contains("#1f77b4"));
  CHECK(drawn("own", "dark") != drawn("usual", "dark"));
  for (const std::string format : {"png", "pdf", "tikz"})
    CHECK(shell("isect render own.json --step 2 --theme screen --format " + format).status == 0);
}

TEST_CASE("a colour that is none is told with the nearest name, and seven are too many", "[scene]") {
  CHECK_THAT(refused(scene_of("", color("tael"))),
             Contains("line 2: objects[1].color: ") && Contains("did you mean \"teal\"?"));
  CHECK_THAT(refused(scene_of(color("#12345"), "")), Contains("#rrggbb"));
  CHECK_THAT(refused(scene_of(color("hit"), "")), Contains("no colour is called \"hit\""));
  CHECK_THAT(refused(scene_of(", \"color\": 3", "")), Contains("a text is expected"));
  std::string many;
  for (int i = 0; i < 7; ++i)
    many += std::string(i == 0 ? "" : ", ") + R"({"point": "p)" + std::to_string(i) + R"(", "at": [)" +
            std::to_string(i) + R"(, 0], "color": "#00000)" + std::to_string(i) + "\"}";
  CHECK_THAT(refused("{\"objects\": [" + many + "]}"), Contains("objects[6].color: one more colour than the 6"));
}

}  // namespace scene_look_test
