// Cases side by side: presets, files and scenes in one strip, and figures at one scale.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <variant>

#include "app/figures/cases.h"
#include "app/figures/figure_maker.h"
#include "app/figures/one_scale.h"
#include "app/shell/options.h"
#include "lessons/lessons.h"
#include "tests/app/shell.h"
#include "tests/catch.h"
#include "viz/formats/animation.h"
#include "viz/formats/files.h"

namespace strip_cases_test {
namespace fs = std::filesystem;
namespace program = isect::program;
namespace viz = isect::viz;
using namespace isect::test;
using Catch::Matchers::StartsWith;
using program::Excerpt;

namespace {

/// A ball of radius 1 at the origin with a point P in the given place.
std::string ball_and_point(const std::string& center, const std::string& p, const std::string& more = "") {
  return fmt::format(R"({{{} "objects": [{{"sphere": "S", "center": [{}], "radius": 1}},
                                         {{"point": "P", "at": [{}]}}], "ask": [["S", "P"]]}})",
                     more, center, p);
}

/// A ball of radius 1 between two points, seen in perspective.
std::string ball_between(double x) {
  return fmt::format(R"({{"camera": {{"perspective": true}},
                          "objects": [{{"sphere": "S", "center": [0, 0, 0], "radius": 1}},
                                      {{"point": "P", "at": [{0}, 0, 0]}}, {{"point": "Q", "at": [-{0}, 0, 0]}}],
                          "ask": [["S", "P"]]}})",
                     x);
}

/// The radii of the balls of a figure, which are drawn with a gradient each.
std::vector<double> radii(const std::string& svg) {
  std::vector<double> all;
  for (const std::string& number : all_between(svg, "gradientTransform=\"matrix(", ' '))
    all.push_back(std::stod(number));
  return all;
}

/// What the words of a command line mean.
std::vector<Excerpt> settings(program::Selection asked) {
  return program::excerpts({"isect", isect::lessons::all_lessons()}, asked);
}
std::vector<Excerpt> verdicts_of(const std::vector<std::string>& files) {
  program::Selection asked;
  asked.lessons = files, asked.step = "verdict";
  return settings(asked);
}

program::Style print_style(const std::string& width) {
  program::StyleOptions options;
  options.format = "svg", options.theme = "print", options.width = width;
  return program::style_of(options);
}

/// How large the balls and discs called S are drawn, by the widest of their shapes.
std::vector<double> radii_of_s(const viz::Drawing& drawing) {
  std::vector<double> all;
  for (std::size_t i = 0; i < drawing.objects.size(); ++i) {
    const viz::Object& object = drawing.objects[i];
    if (object.name != "S" || (object.kind != "ball" && object.kind != "circle")) continue;
    double left = INFINITY, right = -INFINITY;
    const auto grow = [&](const viz::Path& path) {
      for (const viz::Vec2& p : viz::flatten(path, 0.01)) left = std::min(left, p.x()), right = std::max(right, p.x());
    };
    for (const viz::Shape& shape : drawing.shapes) {
      if (viz::object_of(shape) != static_cast<int>(i)) continue;
      if (const auto* fill = std::get_if<viz::Fill>(&shape)) grow(fill->path);
      if (const auto* stroke = std::get_if<viz::Stroke>(&shape)) grow(stroke->path);
      if (const auto* g = std::get_if<viz::Gradient>(&shape)) grow(viz::ellipse(g->center, g->major, g->minor));
    }
    all.push_back((right - left) / 2);
  }
  return all;
}

nlohmann::json last_figure(const Shell& shell, const std::string& folder = "figures") {
  return nlohmann::json::parse(contents(shell.work() / folder / "manifest.json"))["figures"].back();
}

std::string line_of(const Ran& ran) { return ran.out.substr(0, ran.out.find('\n')); }

}  // namespace

TEST_CASE("presets stand side by side, each with its letter and title, and the figure names all", "[strip][cases]") {
  const Shell shell;
  const Ran r =
      shell("isect strip ray-sphere --preset two-roots,tangent,miss --step verdict --format svg,pdf,tikz,png");
  CHECK(r.status == 0);
  CHECK(r.err.empty());
  const std::string stem = "figures/ray-sphere/strip-two-roots+tangent+miss-11+11+07";
  CHECK(r.out == stem + ".svg\n" + stem + ".pdf\n" + stem + ".tikz\n" + stem + ".png\n");
  CHECK_THAT(contents(shell.work() / (stem + ".txt")),
             StartsWith("(a) two roots. Ray and sphere: ") && Contains("\n\n(b) tangent. Ray and sphere: ") &&
                 Contains("\n\n(c) miss. Ray and sphere: ") && Contains("passes a ball without touching it"));

  const nlohmann::json entry = last_figure(shell);
  CHECK(entry["caption"] == "(a) two roots. (b) tangent. (c) miss.");
  REQUIRE(entry["parts"].size() == 3);
  CHECK(entry["parts"][0]["preset"] == "two-roots");
  CHECK(entry["parts"][2]["lesson"] == "ray-sphere");
  CHECK(entry["parts"][2]["step"] == 7);
  CHECK(entry["parts"][2]["slug"] == "reject");
  CHECK(entry["parts"][1]["parameters"]["method"] == "haines");

  const std::string more = " --preset two-roots,tangent,miss --format svg --labels text --out -";
  const std::string svg = shell("isect strip ray-sphere" + more).out;  // the verdict of each, if no step is named
  const std::string drawn = svg.substr(svg.find("</desc>"));
  CHECK_THAT(drawn, Contains("(a) two roots") && Contains("(b) tangent") && Contains("(c) miss"));
  CHECK_THAT(svg, Contains("Ray and sphere: two roots, tangent, miss"));
  const std::string told = shell("isect strip ray-sphere --captions" + more).out;
  CHECK_THAT(told.substr(told.find("</desc>")), Contains("(c) miss.") && Contains("The line has"));
}

TEST_CASE("all parts of a strip have one scale", "[strip][cases]") {
  const Shell shell;
  const std::string cases =
      " ray-sphere --preset two-roots,tangent,miss,inside --step verdict --theme print --format svg";
  const std::vector<double> all = radii(shell("isect strip --columns 2" + cases + " --out -").out);
  REQUIRE(all.size() == 4);
  CHECK(all[0] > 10);
  for (const double radius : all) CHECK(radius == Approx(all[0]).margin(0.002));
  // Alone they fit each its own frame.
  std::vector<double> alone;
  for (const std::string preset : {"two-roots", "inside"})
    alone.push_back(radii(shell("isect render ray-sphere --step verdict --theme print --width 6cm --format svg --out - "
                                "--preset " +
                                preset)
                              .out)
                        .at(0));
  CHECK(alone[1] > 1.2 * alone[0]);
  // It does not depend on the steps: those of one case, of different heights, are drawn at the scale of all.
  const std::vector<double> steps = radii(
      shell("isect strip ray-sphere --preset two-roots,inside --step 3,verdict --theme print --format svg --out -")
          .out);
  REQUIRE(steps.size() == 4);
  for (const double radius : steps) CHECK(radius == Approx(steps[0]).margin(0.002));
}

TEST_CASE("scenes of the plane and of space have one scale, which is that of world units", "[strip][cases]") {
  const Shell shell;
  const auto file = [&](const std::string& name) { return (shell.work() / name).string(); };
  write(file("near.json"), ball_and_point("0, 0, 0", "0.5, 0, 0"));
  write(file("far.json"), ball_and_point("0, 0, 0", "6, 0, 0"));
  write(file("plane.json"), ball_and_point("0, 0", "0, 2.5"));
  const std::vector<Excerpt> cases = verdicts_of({file("near.json"), file("far.json"), file("plane.json")});
  const program::Style style = print_style("24cm");
  program::FigureMaker maker(style, "auto");
  const std::vector<double> all = radii_of_s(maker.draw_strip(cases, 3, false, false));
  REQUIRE(all.size() == 3);
  CHECK(all[0] > 8);
  for (const double radius : all) CHECK(radius == Approx(all[0]).epsilon(0.002));
  const double near = radii_of_s(maker.draw(cases[0], cases[0].steps.front())).at(0),
               far = radii_of_s(maker.draw(cases[1], cases[1].steps.front())).at(0);
  CHECK(near > 1.5 * far);  // alone
}

TEST_CASE("eyes in perspective have one distance, and one field of view", "[strip][cases]") {
  const Shell shell;
  const auto file = [&](const std::string& name) { return (shell.work() / name).string(); };
  write(file("wide.json"), ball_between(3));
  write(file("narrow.json"), ball_between(1.5));
  const std::vector<Excerpt> cases = verdicts_of({file("wide.json"), file("narrow.json")});
  const program::OneScale scale(cases);
  CHECK(scale.walk().steps.size() == 2);
  CHECK(scale.case_of(1) == 1);
  const auto distance = [](const viz::Camera& camera) {
    return (viz::View(camera, 1, 1).eye() - camera.target).norm();
  };
  for (const double aspect : {0.5, 1.6}) {
    const viz::Camera a = scale.camera(0, aspect), b = scale.camera(1, aspect);
    CHECK((a.perspective && b.perspective));
    CHECK(distance(a) == Approx(distance(b)));
    CHECK(a.half_height == b.half_height);
  }
  const program::Style style = print_style("16cm");
  program::FigureMaker maker(style, "auto");
  const std::vector<double> all = radii_of_s(maker.draw_strip(cases, 2, false, false));
  REQUIRE(all.size() == 2);
  CHECK(all[0] == Approx(all[1]).epsilon(0.002));

  const auto seen = [](double field) {
    return fmt::format(R"({{"lesson": "ray-sphere", "preset": "tangent", "step": 3, "camera": {{"angles": "degrees",
                            "target": [0, 0, 0], "azimuth": 30, "elevation": 20, "half_height": 4, "perspective": true,
                            "field_of_view": {}}}}})",
                       field);
  };
  write(file("a.json"), seen(35)), write(file("b.json"), seen(60)), write(file("c.json"), seen(35));
  const Ran other = shell("isect strip a.json b.json");
  CHECK(other.status == 2);
  CHECK_THAT(other.err, Contains("camera: ray-sphere/a has a field of view of 35 degrees, and ray-sphere/b of 60"));
  CHECK(shell("isect strip a.json c.json --format svg").status == 0);
}

TEST_CASE("the camera of a preset's file keeps its direction and its middle, at the scale of all", "[strip][cases]") {
  const Shell shell;
  const std::string file = (shell.work() / "p.json").string();
  write(file, R"({"lesson": "ray-sphere", "preset": "tangent", "step": 3, "camera": {"angles": "degrees",
                  "target": [1, 0.5, 0], "azimuth": 70, "elevation": 10, "half_height": 9}})");
  program::Selection asked;
  asked.lessons = {"ray-sphere", file}, asked.presets = {"miss"}, asked.step = "3";
  const std::vector<Excerpt> cases = settings(asked);
  REQUIRE(cases.size() == 2);
  CHECK(cases[0].folder == "miss");
  const program::OneScale scale(cases);
  CHECK(scale.camera(0, 1.5).half_height == 9);
  CHECK(scale.camera(1, 1.5) == *cases[1].camera);
  CHECK(scale.camera(0, 1.5).azimuth == viz::opening(*cases[0].lesson).azimuth);
}

TEST_CASE("files, scenes and presets stand in the order in which they are named", "[strip][cases]") {
  const Shell shell;
  write(shell.work() / "s.json", ball_and_point("0, 0, 0", "2, 0, 0", R"("title": "A ball and a point",)"));
  write(shell.work() / "t.json", ball_and_point("0, 0, 0", "2, 0, 0"));
  write(shell.work() / "p.json", R"({"lesson": "ray-sphere", "preset": "miss", "step": 3})");
  const auto made = [&](const std::string& words) {
    const Ran r = shell("isect strip " + words + " --format svg");
    INFO(words << ": " << r.err);
    CHECK(r.status == 0);
    return line_of(r);
  };
  CHECK(made("ray-sphere --preset tangent,p.json,miss --step 3") == "figures/ray-sphere/strip-tangent+p+miss-03.svg");
  CHECK(made("ray-sphere --preset miss --preset tangent --step 3") == "figures/ray-sphere/strip-miss+tangent-03.svg");
  CHECK(made("s.json ray-sphere --preset miss") == "figures/scene+ray-sphere/strip-s+miss-02+07.svg");
  CHECK(made("--preset miss s.json ray-sphere") == "figures/ray-sphere+scene/strip-miss+s-07+02.svg");
  CHECK(made("ray-sphere --preset miss s.json") == "figures/ray-sphere+scene/strip-miss+s-07+02.svg");
  CHECK(made("t.json p.json s.json") == "figures/scene+ray-sphere/strip-t+p+s-02+03+02.svg");
  CHECK(last_figure(shell)["caption"] == "(a) t. (b) miss. (c) A ball and a point.");
  // Each of several lessons has its title, and takes the presets that it has.
  const std::string both = "figures/ray-sphere+sphere-sphere/strip-";
  CHECK_THAT(made("ray-sphere sphere-sphere"), StartsWith(both + "two-roots+overlapping-"));
  CHECK_THAT(made("ray-sphere sphere-sphere --preset tangent,equal"), StartsWith(both + "tangent+equal-"));
  const auto manifest = nlohmann::json::parse(contents(shell.work() / "figures/manifest.json"));
  CHECK(std::ranges::any_of(manifest["figures"], [](const auto& f) {
    return f["caption"].template get<std::string>().starts_with("(a) Ray and sphere: tangent. (b) ") &&
           f["title"].template get<std::string>().starts_with("Ray and sphere; ");
  }));
  // A lesson's walks through scenes.
  write(shell.work() / "u.json", R"({"title": "House", "objects": [{"polygon": "A", "points": [[0, 0], [4, 0], [0, 4]]},
                                     {"point": "P", "at": [1, 1]}]})");
  write(shell.work() / "v.json", R"({"title": "Barn", "objects": [{"polygon": "A", "points": [[0, 0], [4, 0], [0, 4]]},
                                     {"point": "P", "at": [3, 3]}]})");
  CHECK_THAT(made("crossings --scene u.json,v.json"), StartsWith("figures/scene/strip-crossings-u+crossings-v-"));
  CHECK(last_figure(shell)["caption"] == "(a) House. (b) Barn.");
  CHECK(shell("isect strip crossings --scene u.json --scene v.json --format svg --out -").out ==
        contents(shell.work() / made("crossings --scene u.json,v.json")));
}

TEST_CASE("titles that are alike are told apart", "[strip][cases]") {
  program::Selection asked;
  asked.lessons = {"ray-sphere"}, asked.presets = {"two-roots,two-roots-quadratic,tangent"}, asked.step = "1";
  const std::vector<std::string> groups = program::case_titles(settings(asked));
  CHECK(groups == std::vector<std::string>{"two roots (haines)", "two roots (quadratic)", "tangent"});
  asked.presets = {"two-roots,tangent"}, asked.changes = {"radius=1"};
  const std::vector<std::string> changed = program::case_titles(settings(asked));
  CHECK(changed == std::vector<std::string>{"two roots (radius=1)", "tangent (radius=1)"});

  const Shell shell;
  const std::string a = (shell.work() / "a_1.json").string(), b = (shell.work() / "b.json").string();
  for (const std::string& file : {a, b}) write(file, R"({"lesson": "ray-polygon"})");
  const std::vector<std::string> names = program::case_titles(verdicts_of({a, b}));
  CHECK(names == std::vector<std::string>{"a\\_1", "b"});

  asked = {};
  asked.lessons = {"ray-sphere"}, asked.presets = {"two-roots,tangent"}, asked.step = "2,3";
  const std::vector<Excerpt> steps = settings(asked);
  const std::vector<std::string> parts = program::part_captions(steps, false);
  REQUIRE(parts.size() == 4);
  CHECK(parts[0] == "two roots: " + steps[0].walk.steps[1].title);
  CHECK(parts[3] == "tangent: " + steps[1].walk.steps[2].title);
}

TEST_CASE("nine cases make a grid for a poster", "[strip][cases]") {
  const Shell shell;
  const Ran r = shell(
      "isect strip crossings --preset inside,outside,grazed-none,grazed-two,edge-along-u,on-edge,on-vertex,spike,hole "
      "--step verdict --columns 3 --width 60cm --text-size 12pt --theme grey --format svg --labels text");
  CHECK(r.status == 0);
  CHECK(r.err.empty());
  const std::string file = line_of(r);
  CHECK(fs::path(file).stem().string().size() <= 100);
  CHECK_THAT(file, StartsWith("figures/crossings/strip-inside+outside+") && Contains("~"));
  const std::string svg = contents(shell.work() / file), drawn = svg.substr(svg.find("</desc>"));
  CHECK_THAT(svg, Contains("width=\"1700.787\""));
  std::vector<std::pair<double, double>> at;
  for (char letter = 'a'; letter <= 'i'; ++letter) {
    const std::size_t words = drawn.find(fmt::format("<tspan>({}) ", letter));
    REQUIRE(words != drawn.npos);
    const std::size_t text = drawn.rfind("<text x=\"", words), y = drawn.find(" y=\"", text);
    at.emplace_back(std::stod(drawn.substr(text + 9)), std::stod(drawn.substr(y + 4)));
  }
  for (std::size_t i = 3; i < 9; ++i) {
    CHECK(at[i].first == Approx(at[i - 3].first).margin(0.01));
    CHECK(at[i].second > at[i - 3].second + 100);
  }
  for (const std::size_t row : {0, 3, 6}) CHECK(at[row].second == Approx(at[row + 1].second).margin(0.01));
  CHECK_THAT(
      shell("isect strip crossings --preset inside,outside --crop --width 14cm --theme dark --format svg --out -").out,
      Contains("width=\"396.85"));
}

TEST_CASE("a strip of several cases is drawn again from its file, of any format", "[strip][cases]") {
  const Shell shell;
  write(shell.work() / "s.json", ball_and_point("0, 0, 0", "2, 0, 0"));
  write(shell.work() / "t.json", ball_and_point("0, 0", "2, 0", R"("title": "A disc",)"));
  write(shell.work() / "p.json", R"({"lesson": "ray-sphere", "preset": "miss", "step": 3,
                                     "camera": {"azimuth": 70, "elevation": 35}})");
  const Ran made = shell(
      "isect strip s.json t.json p.json --columns 2 --captions --theme grey --width 13cm --text-size 8pt "
      "--format svg,pdf,tikz,png --out s");
  REQUIRE(made.status == 0);
  const fs::path first = shell.work() / line_of(made);
  for (const std::string from : {"svg", "pdf", "tikz", "png"}) {
    INFO(from);
    const fs::path figure = fs::path(first).replace_extension(from);
    const Ran again = shell("isect strip " + figure.string() + " --format svg --out t-" + from);
    REQUIRE(again.status == 0);
    CHECK(line_of(again) == "t-" + from + line_of(made).substr(1));
    CHECK(contents(shell.work() / line_of(again)) == contents(first));
    CHECK(shell("isect show " + figure.string()).status == 77);  // the first of its cases, but there is no display
    const Ran told = shell("isect explain " + figure.string());
    CHECK(told.status == 2);
    CHECK_THAT(told.err, Contains("3 are given"));
  }
  // render draws the parts, one by one.
  const Ran parts = shell("isect render " + first.string() + " --format svg --out u");
  CHECK(parts.status == 0);
  CHECK(count(parts.out, "\n") == 3);
  CHECK_THAT(parts.out,
             Contains("u/scene/s/02-") && Contains("u/scene/t/02-") && Contains("u/ray-sphere/p/03-distance.svg"));
  // What is asked for now counts; and figures of several cases, of one setting, too, make a strip.
  CHECK_THAT(shell("isect strip " + first.string() + " --width 18cm --theme print --format svg --out -").out,
             Contains("width=\"510.23"));
  const Ran of_parts = shell("isect strip u/scene/s/02-*.svg u/ray-sphere/p/03-distance.svg --format svg --out v");
  CHECK_THAT(of_parts.out, StartsWith("v/scene+ray-sphere/strip-s+p-02+03.svg"));
  CHECK_THAT(contents(shell.work() / line_of(of_parts)), Contains("width=\"453.5433pt\""));
  REQUIRE(shell("isect render s.json --format svg --out w").status == 0);
  CHECK_THAT(shell("isect strip w/scene/s/*.svg --format svg --out v").out, StartsWith("v/scene/s/strip-01-02.svg"));
}

TEST_CASE("what a figure says of its cases is not trusted", "[strip][cases]") {
  const auto cases = [](const std::string& text, const std::string& own = "") {
    viz::Metadata data = {{"cases", text}};
    if (!own.empty()) data["case"] = own;
    return program::cases_of(data);
  };
  CHECK(program::cases_of({{"lesson", "rays"}}).cases.empty());
  CHECK(cases(R"([{"lesson": "rays"}, {}])").cases.size() == 2);
  CHECK(cases(R"([{"lesson": "rays"}, {}])", "2").own == 1);
  std::string many = "[{}";
  for (int i = 0; i < 100; ++i) many += ", {}";
  for (const std::string& text :
       {std::string("[1]"), std::string("{}"), std::string("[[[[{}]]]]"), std::string("[{\"a\": {\"b\": {}}}]"),
        std::string("[{\"a\": 1}]"), std::string("["), std::string("[]"), many + "]", std::string(100000, '[')}) {
    INFO(text.substr(0, 40));
    CHECK_THROWS_WITH(cases(text), StartsWith("cases: "));
  }
  for (const std::string own : {"0", "3", "-1", "1 ", "x", "99999999999999999999999"}) {
    INFO(own);
    CHECK_THROWS_WITH(cases("[{}, {}]", own), Contains("they are 1 to 2"));
  }
}

TEST_CASE("a strip of cases refuses what can't be, and names what is allowed", "[strip][cases]") {
  const Shell shell;
  write(shell.work() / "miss.json", R"({"lesson": "ray-sphere", "preset": "tangent"})");
  write(shell.work() / "small.json", ball_and_point("0, 0, 0", "0.5, 0, 0"));
  write(shell.work() / "large.json",
        R"({"objects": [{"sphere": "B", "center": [0, 0, 0], "radius": 1000}, {"point": "P", "at": [0, 0, 0]}],
            "ask": [["B", "P"]]})");
  const auto refused = [&](const std::string& words) {
    const Ran r = shell("isect strip " + words);
    INFO(words << ": " << r.err);
    CHECK(r.status == 2);
    CHECK(r.out.empty());
    CHECK_FALSE(fs::exists(shell.work() / "figures"));
    return r.err;
  };
  CHECK_THAT(refused("ray-sphere --preset two-roots,tangnt"),
             Contains("preset: \"tangnt\" is unknown") && Contains("mean \"tangent\""));
  CHECK_THAT(refused("ray-sphere --preset two-roots,"), Contains("preset: \"\"") && Contains("two-roots"));
  CHECK_THAT(refused("ray-sphere sphere-sphere --preset tangnt,equal"), Contains("\"tangnt\" is unknown"));
  CHECK_THAT(refused("ray-sphere sphere-sphere --preset tangent"),
             Contains("preset: sphere-sphere has none called tangent; allowed: overlapping, disjoint"));
  CHECK_THAT(refused("ray-sphere --preset all"),
             Contains("preset: a strip has 2 to 26 parts, and here are 33, of 33 cases"));
  CHECK_THAT(refused("ray-sphere --preset two-roots,tangent,miss --step 1-9"), Contains("here are 27, of 3 cases"));
  CHECK_THAT(refused("ray-sphere --preset tangent --step verdict"),
             Contains("step: a strip has 2 to 26 parts, and here is 1; ") && Contains("--preset a,b"));
  CHECK_THAT(refused("ray-sphere --preset two-roots,miss --step 11"),
             Contains("step: \"11\" is unknown") && Contains("miss has steps 1 to 9"));
  CHECK_THAT(refused("ray-sphere --preset miss,miss.json"), Contains("two are called miss"));
  CHECK_THAT(refused("rays --preset miss.json,all"), Contains("miss.json is for ray-sphere, not for rays"));
  CHECK_THAT(refused("small.json large.json"),
             Contains("preset: scene/large and scene/small have no common scale") && Contains("times as large"));
  CHECK_THAT(refused("crossings rays --scene small.json"), Contains("scene: one lesson"));
  CHECK_THAT(refused("ray-sphere --preset two-roots,tangent --format gif"), Contains("format: a strip does not move"));
  CHECK_THAT(refused("ray-sphere --preset two-roots,tangent --columns 13"), Contains("columns: \"13\""));
  CHECK_THAT(refused("--preset two-roots,tangent"), Contains("lesson: none given"));
  CHECK(shell("isect strip small.json absent.json").status == 4);
}

TEST_CASE("a lesson's own program makes strips of cases, too", "[strip][cases]") {
  const Shell shell;
  const Ran r = shell("ray-sphere strip --preset two-roots,tangent --format svg");
  CHECK(r.status == 0);
  CHECK(r.out == "figures/ray-sphere/strip-two-roots+tangent-11.svg\n");
  CHECK_THAT(shell("isect strip --help").out, Contains("--preset two-roots,tangent,miss --step verdict") &&
                                                  Contains("at one scale") && Contains("2 to 26 parts"));
}

TEST_CASE("render draws a set of figures at one scale and in one size", "[render][cases]") {
  const Shell shell;
  write(shell.work() / "s.json", ball_and_point("0, 0, 0", "12, 0, 0"));
  const std::string cases = "ray-sphere --preset two-roots,inside --step verdict --theme print --format svg ";
  for (const std::string more :
       {"--width 6cm", "--width 6cm --crop", "--height 5cm --no-title", "--size 480x300", "--size 480x300 --crop"}) {
    INFO(more);
    const Shell own;
    const Ran r = own("isect render " + cases + more + " --same-scale --out one");
    REQUIRE(r.status == 0);
    CHECK(r.out == "one/ray-sphere/two-roots/11-intersect.svg\none/ray-sphere/inside/11-intersect.svg\n");
    const std::string a = contents(own.work() / "one/ray-sphere/two-roots/11-intersect.svg"),
                      b = contents(own.work() / "one/ray-sphere/inside/11-intersect.svg");
    REQUIRE((radii(a).size() == 1 && radii(b).size() == 1));
    CHECK(radii(a)[0] == Approx(radii(b)[0]).margin(0.002));
    for (const std::string side : {" width=\"", " height=\""})
      CHECK(all_between(a, side).at(0) == all_between(b, side).at(0));
    const Ran apart = own("isect render " + cases + more + " --out two");
    REQUIRE(apart.status == 0);
    if (more.starts_with("--width"))  // as wide, each fits its own frame
      CHECK(radii(contents(own.work() / "two/ray-sphere/inside/11-intersect.svg")).at(0) >
            1.2 * radii(contents(own.work() / "two/ray-sphere/two-roots/11-intersect.svg")).at(0));
    // Each is drawn again as it was, at the scale of the others.
    const Ran again = own("isect render one/ray-sphere/inside/11-intersect.svg --format svg --out three");
    CHECK(again.out == "three/ray-sphere/inside/11-intersect.svg\n");
    CHECK(contents(own.work() / line_of(again)) == b);
    CHECK(own("isect show one/ray-sphere/inside/11-intersect.svg").status == 77);
    CHECK(own("isect explain --brief one/ray-sphere/inside/11-intersect.svg").status == 0);
  }
  // Presets and scenes: the radii are those of the world, 1 and 1.5234375.
  for (const std::string size : {"--size 480x300", "--width 9cm"}) {
    const Ran r = shell(
        "isect render ray-sphere s.json --preset miss --step verdict --theme print --format svg "
        "--same-scale --out world " +
        size);
    REQUIRE(count(r.out, "\n") == 2);
    const std::size_t end = r.out.find('\n');
    const double miss = radii(contents(shell.work() / r.out.substr(0, end))).at(0),
                 scene = radii(contents(shell.work() / r.out.substr(end + 1, r.out.size() - end - 2))).at(0);
    CHECK(miss / scene == Approx(1.5234375).epsilon(0.001));
  }
  // Other steps and numbers of a figure still have the scale of the others.
  REQUIRE(shell("isect render ray-sphere s.json --preset miss --step verdict --width 8cm --theme print --format svg "
                "--same-scale --out one")
              .status == 0);
  const std::string miss = "one/ray-sphere/miss/07-reject.svg";
  const double kept = radii(contents(shell.work() / miss)).at(0);
  const auto redrawn = [&](const std::string& words) {
    const Ran r = shell("isect render " + miss + words + " --format svg --out four");
    INFO(words << r.err);
    REQUIRE(r.status == 0);
    return radii(contents(shell.work() / line_of(r))).at(0);
  };
  CHECK(redrawn(" --step 3") == Approx(kept).epsilon(0.15));
  CHECK(redrawn(" --set radius=0.76171875") == Approx(0.5 * kept).epsilon(0.15));
  // An animation, and steps of one preset.
  CHECK(
      shell("isect render ray-sphere --preset miss,inside --step 2-3 --same-scale --format gif --size 320x200 --out g")
          .status == 0);
  const auto film = viz::gif_metadata(contents(shell.work() / "g/ray-sphere/miss/steps-02-03.gif"));
  CHECK(film.at("case") == "1");
  CHECK(shell("isect render g/ray-sphere/inside/steps-02-03.gif --format svg --out h").status == 0);

  const Ran many = shell("isect render --all --step 1 --format svg --same-scale");
  CHECK(many.status == 2);
  CHECK_THAT(many.err, Contains("100 are the most at one scale"));
  REQUIRE(shell("isect render ray-sphere --step 2 --theme grey --format svg --out x").status == 0);
  const Ran mixed = shell("isect render --same-scale x/ray-sphere/two-roots/*.svg " + miss);
  CHECK(mixed.status == 2);
  CHECK_THAT(mixed.err, Contains("same-scale: "));
}

}  // namespace strip_cases_test
