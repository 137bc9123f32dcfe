// Which presets, files and steps are meant: what a preset's file says, several at once, whole folders, and what a
// parameter's help forbids.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

#include "app/shell/option_values.h"
#include "lessons/lessons.h"
#include "tests/app/shell.h"
#include "tests/catch.h"
#include "viz/formats/files.h"
#include "viz/player/reader_state.h"

namespace select_test {
namespace fs = std::filesystem;
namespace viz = isect::viz;
using namespace isect::test;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

namespace {

const std::string tangent = R"({"lesson": "ray-sphere", "preset": "tangent"})";
const std::string from_above =
    R"({"lesson": "ray-sphere", "preset": "tangent", "step": 3,
        "camera": {"target": [0, 0, 0], "azimuth": 30, "elevation": 70, "half_height": 4}})";

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace

TEST_CASE("the step of a preset's file is what is rendered, explained and shown, unless another is asked for",
          "[select]") {
  const Shell shell;
  write(shell.work() / "p.json", from_above);
  CHECK(shell("isect render --preset p.json --format svg").out == "figures/ray-sphere/p/03-distance.svg\n");
  CHECK(shell("isect render --preset p.json --step 2 --format svg").out ==
        "figures/ray-sphere/p/02-along-the-ray.svg\n");
  CHECK(lines_of(shell("isect render --preset p.json --step all --format svg").out).size() > 5);

  const std::string told = shell("isect explain --preset p.json").out;
  CHECK_THAT(told, Contains("Step 3 of") && !Contains("Step 2 of") && !Contains("Step 4 of"));
  CHECK_THAT(shell("isect explain --preset p.json --step all").out, Contains("Step 2 of"));
  CHECK(shell("isect show --preset p.json").status == 77);  // nothing is refused but the missing display

  // A file without a step means all of them.
  write(shell.work() / "all.json", tangent);
  CHECK(lines_of(shell("isect render --preset all.json --format svg").out).size() > 5);
}

TEST_CASE("a scene or a preset comes through a pipe, with the files beside us that it names", "[select]") {
  const Shell shell;
  write(shell.work() / "some.csv", "x,y\n0,0\n4,0\n1,3\n");
  write(shell.work() / "beside/s.json",
        R"({"objects": [{"cloud": "C", "file": "some.csv"}], "ask": [{"fit": "C", "volume": "box"}]})");
  write(shell.work() / "p.json", from_above);
  const Ran drawn = shell("cat beside/s.json | isect render - --step 1 --format svg --out made");
  CHECK(drawn.status == 0);
  CHECK_THAT(drawn.out, StartsWith("made/scene/stdin/01-"));
  CHECK_THAT(shell("isect explain - < p.json").out, Contains("Step 3 of"));
  CHECK(shell("cat beside/s.json | isect show -").status == 77);  // nothing is refused but the missing display
  CHECK_THAT(shell("isect show beside/s.json").err, Contains("beside/some.csv"));
  CHECK(shell("isect scene - < beside/s.json").status == 0);
  CHECK(shell("echo '{\"objects\": 1}' | isect show -").status == 2);
}

TEST_CASE("a figure is taken as a preset's file is: with its lesson, step, numbers and camera", "[select]") {
  const Shell shell;
  write(shell.work() / "p.json", from_above);
  write(shell.work() / "s.json", R"({"objects": [{"sphere": "A", "center": [0, 0, 0], "radius": 1},
                                                 {"point": "P", "at": [1, 0, 0]}], "ask": [["P", "A"]]})");
  REQUIRE(shell("isect render --preset p.json --set radius=1.5 --format png --out made").status == 0);
  REQUIRE(shell("isect render s.json --step 2 --format svg,pdf --out made").status == 0);

  const std::string ball = "made/ray-sphere/p+radius=1.5/03-distance.png", scene = "made/scene/s/02-a-p.svg";
  const std::string points = fs::exists(shell.work() / scene) ? scene : "made/scene/s/02-p-a.svg";
  CHECK(shell("isect render " + ball + " --format png --out again").out ==
        "again/ray-sphere/p+radius=1.5/03-distance.png\n");
  CHECK(viz::compare(viz::read_png(contents(shell.work() / ball)),
                     viz::read_png(contents(shell.work() / "again/ray-sphere/p+radius=1.5/03-distance.png")))
            .over_1 == 0);
  CHECK(shell("isect render --preset " + points + " --format svg --out again").status == 0);
  CHECK_THAT(shell("isect explain " + ball).out, Contains("Step 3 of") && Contains("= 1.5"));
  CHECK_THAT(shell("isect explain " + points).out, Contains("Step 2 of") && Contains("P lies on the boundary of A"));
  CHECK(lines_of(shell("isect render " + ball + " --step all --format svg --out again").out).size() > 5);

  // Several at once, each with a name of its own; pictures that isect did not make, and other files, are refused.
  CHECK(lines_of(shell("isect render " + ball + " " + points + " --format svg --out both").out).size() == 2);
  write(shell.work() / "o.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"/>");
  CHECK_THAT(shell("isect render o.svg").err, Contains("o.svg: it carries no isect metadata"));
  write(shell.work() / "o.png", "text");
  CHECK(shell("isect render o.png").status == 4);
  CHECK(shell("isect render nowhere.png").status == 4);
}

TEST_CASE("a figure of any format is drawn again as it was, one of several steps with all of them", "[select]") {
  const Shell shell;
  write(shell.work() / "p.json", from_above);
  write(shell.work() / "s.json", R"({"objects": [{"polygon": "A", "points": [[0, 0], [4, 0], [0, 4]]},
                                                 {"point": "P", "at": [1, 1]}], "ask": [["P", "A"]]})");
  const std::string formats = " --format png,svg,pdf,tikz,gif,apng --size 320x200 --out made";
  for (const std::string& request :
       {std::string("--preset p.json --set radius=1.5 --step 3"), std::string("s.json --step 2"),
        std::string("crossings --scene s.json --step 3")}) {
    const std::vector<std::string> made = lines_of(shell("isect render " + request + formats).out);
    REQUIRE(made.size() == 6);
    const viz::Picture first = viz::read_png(contents(shell.work() / made[0]));
    for (const std::string& figure : made) {
      INFO(figure);
      const Ran again = shell("isect render --preset " + figure + " --format png --size 320x200 --out again");
      REQUIRE(again.status == 0);
      CHECK(viz::read_png(contents(shell.work() / again.out.substr(0, again.out.size() - 1))).rgba == first.rgba);
      CHECK(shell("isect show " + figure).status == 77);  // no display, and nothing else to complain of
      CHECK(shell("isect explain --brief " + figure).status == 0);
    }
  }

  for (const auto& [steps, name] : {std::pair{"2-4", "02-04"}, {"2,4", "02+04"}}) {
    const std::string of = "made/ray-sphere/tangent/steps-" + std::string(name);
    REQUIRE(shell("isect render ray-sphere --preset tangent --step " + std::string(steps) + formats).status == 0);
    CHECK_THAT(shell("isect render --preset " + of + ".gif --format apng --out again").out,
               Contains("/steps-" + std::string(name) + ".apng\n"));
  }
  REQUIRE(shell("isect strip ray-sphere --step 2-3 --format pdf --out made").status == 0);
  CHECK(shell("isect strip made/ray-sphere/two-roots/strip-02-03.pdf --out again").out ==
        "again/ray-sphere/two-roots/strip-02-03.png\n");
  CHECK_THAT(shell("isect show made/ray-sphere/two-roots/strip-02-03.pdf --step 99").err, Contains("step: \"99\""));
}

TEST_CASE("a figure drawn again keeps its width, its theme, its title and its folder, in any format", "[select]") {
  const Shell shell;
  const auto entry = [&](const std::string& words) {
    REQUIRE(shell(words + " --out made").status == 0);
    const auto manifest = nlohmann::json::parse(contents(shell.work() / "made/manifest.json"));
    return manifest["figures"].back();
  };
  const std::string figure = " obb-obb --preset edges --step 4 --theme print --width 8cm --text-size 8pt --no-title";
  for (const std::string from : {"svg", "png", "pdf", "tikz"})
    for (const std::string to : {"pdf", "svg", "tikz"}) {
      INFO(from << " as " << to);
      const Shell again;
      const std::string made = "f/obb-obb/edges/04-";
      REQUIRE(again("isect render" + figure + " --format " + from + "," + to + " --out f").status == 0);
      std::string file;
      for (const auto& f : fs::directory_iterator(again.work() / "f/obb-obb/edges"))
        if (f.path().extension() == "." + from) file = f.path().string();
      const std::string stem = fs::path(file).stem().string();
      const Ran r = again("isect render " + file + " --format " + to + " --out g");
      CHECK(r.out == "g/obb-obb/edges/" + stem + "." + to + "\n");
      CHECK(contents(again.work() / r.out.substr(0, r.out.size() - 1)) ==
            contents(again.work() / ("f/obb-obb/edges/" + stem + "." + to)));
    }

  // The options of the current command win over those of the figure.
  const Ran drawn = shell("isect render" + figure + " --format svg --out f");
  const std::string svg = drawn.out.substr(0, drawn.out.size() - 1);
  const auto now = entry("isect render " + svg + " --width 10cm --theme grey --format svg");
  CHECK(now["width_pt"].get<double>() == Approx(283.465));
  CHECK(now["theme"] == "grey");
  CHECK(now["text_pt"] == 8);
  CHECK(entry("isect render " + svg + " --size 480x300 --format svg")["size"] == "480x300");
  CHECK(entry("isect render " + svg + " --text-size 7pt --format svg")["text_pt"] == 7);

  // One figure in two formats is drawn once, and steps of one setting lie side by side.
  REQUIRE(shell("isect render ray-sphere --step 2-3 --format svg,pdf --width 8cm --out f").status == 0);
  CHECK(lines_of(shell("isect render f/ray-sphere/two-roots/*.svg f/ray-sphere/two-roots/*.pdf --format tikz").out)
            .size() == 2);

  // A strip is a strip again.
  const std::string strip = " --step 2-4 --columns 2 --captions --theme grey --width 12cm --format svg,pdf --out s";
  REQUIRE(shell("isect strip ray-sphere" + strip).status == 0);
  REQUIRE(shell("isect strip s/ray-sphere/two-roots/strip-02-04.pdf --format svg --out t").status == 0);
  CHECK(contents(shell.work() / "t/ray-sphere/two-roots/strip-02-04.svg") ==
        contents(shell.work() / "s/ray-sphere/two-roots/strip-02-04.svg"));

  // A folder that leads elsewhere is ignored.
  std::string evil = contents(shell.work() / svg);
  const std::string honest = "obb-obb/edges/04-";
  for (std::size_t at = evil.find(honest); at != evil.npos; at = evil.find(honest, at + 1))
    evil.replace(at, honest.size(), "obb-obb/../../04");
  write(shell.work() / "evil.svg", evil);
  CHECK_THAT(shell("isect render evil.svg --format svg --out made").out, StartsWith("made/obb-obb/evil/04-"));
}

TEST_CASE("a file's step that a changed parameter takes away is refused", "[select]") {
  const Shell shell;
  write(shell.work() / "p.json", R"({"lesson": "ray-sphere", "preset": "two-roots", "step": 12})");
  const Ran r = shell("isect render --preset p.json --set origin=-4,3,0");
  CHECK(r.status == 2);
  CHECK_THAT(r.err, Contains("step") && Contains("12"));
}

TEST_CASE("the camera of a preset's file is the one that is drawn with", "[select]") {
  const Shell shell;
  write(shell.work() / "above.json", from_above);
  write(shell.work() / "plain.json", R"({"lesson": "ray-sphere", "preset": "tangent", "step": 3})");
  const auto drawn = [&](const std::string& file, const std::string& format) {
    return shell("isect render --preset " + file + " --out - --format " + format).out;
  };
  CHECK(drawn("above.json", "svg") != drawn("plain.json", "svg"));
  const std::string png = drawn("above.json", "png");
  CHECK_FALSE(viz::compare(viz::read_png(png), viz::read_png(drawn("plain.json", "png"))).passes());
  // The figure carries it on, so that `show FIGURE.png` sees the same.
  const viz::ReaderState state = viz::reader_state_from_metadata(viz::png_metadata(png), isect::lessons::all_lessons());
  REQUIRE(state.camera);
  CHECK(state.camera->elevation == 70 * std::numbers::pi / 180);
  CHECK(state.camera->half_height == 4);
}

TEST_CASE("a file from before angles were degrees is drawn to the pixel as it was", "[select]") {
  const Shell shell;
  // What Ctrl+C copied then, and what a figure carried: all six numbers, the angles in radians.
  const auto with = [](const std::string& camera) {
    return R"({"lesson": "obb-obb", "preset": "edges", "step": 4, "camera": {)" + camera + "}}";
  };
  write(shell.work() / "old.json",
        with(R"("target":[0.25,0.5,0.0],"azimuth":1.1344640137963142,"elevation":0.4886921905584123,
                "half_height":2.5,"perspective":true,"field_of_view":0.6108652381980153)"));
  write(shell.work() / "new.json", with(R"("angles":"degrees","target":[0.25,0.5,0.0],"azimuth":65.0,"elevation":28.0,
                "half_height":2.5,"perspective":true,"field_of_view":35.0)"));
  const auto drawn = [&](const std::string& file) {
    const Ran r = shell("isect render --preset " + file + " --out - --format png");
    CHECK(r.err.empty());
    return viz::read_png(r.out).rgba;
  };
  CHECK(drawn("old.json") == drawn("new.json"));
  write(shell.work() / "small.json", with(R"("azimuth": 0.5, "elevation": 0.35)"));
  const Ran either = shell("isect render --preset small.json");
  CHECK(either.status == 2);
  CHECK_THAT(either.err, Contains("small.json: camera azimuth: 0.5 can be degrees, or radians"));
}

TEST_CASE("another direction is asked for in degrees, and all is in the frame", "[select]") {
  const Shell shell;
  const auto drawn = [&](const std::string& words) {
    const Ran r = shell("isect render " + words + " --step 4 --out - --format png");
    INFO(words << ": " << r.err);
    REQUIRE(r.status == 0);
    return r.out;
  };
  const auto pixels = [&](const std::string& png) { return viz::read_png(png).rgba; };
  const std::string turned = drawn("obb-obb --preset edges --camera 70,35");
  CHECK(pixels(turned) != pixels(drawn("obb-obb --preset edges")));
  CHECK(pixels(drawn("obb-obb --preset edges --camera -30,-35")) != pixels(turned));
  write(shell.work() / "p.json",
        R"({"lesson": "obb-obb", "preset": "edges", "camera": {"azimuth": 70, "elevation": 35}})");
  CHECK(pixels(drawn("--preset p.json")) == pixels(turned));
  write(shell.work() / "turned.png", turned);
  CHECK(pixels(drawn("turned.png")) == pixels(turned));  // a figure is drawn anew from where it was seen

  for (const std::string wrong : {"70", "70,95", "400,0", "a,b", "1,2,3", "nan,0", "''"})
    CHECK_THAT(shell("isect render obb-obb --camera " + wrong).err, Contains("camera"));
  CHECK(shell("isect render obb-obb --camera 70,95").status == 2);
  CHECK_THAT(shell("isect render rays --camera 70,35").err, Contains("camera: rays lies in one plane"));
}

TEST_CASE("a flat lesson is seen straight on, whatever a file says", "[select]") {
  const Shell shell;
  write(shell.work() / "tilted.json", R"({"lesson": "rays", "camera": {"azimuth": 1}})");
  const Ran r = shell("isect render --preset tilted.json");
  CHECK(r.status == 2);
  CHECK_THAT(r.err, Contains("tilted.json") && Contains("camera") && Contains("straight on"));
  write(shell.work() / "near.json", R"({"lesson": "rays", "camera": {"half_height": 1}})");
  CHECK(shell("isect render --preset near.json --step 1 --format svg").status == 0);
}

TEST_CASE("several presets are rendered at once, names and files as they come", "[select]") {
  const Shell shell;
  write(shell.work() / "a.json", tangent);
  write(shell.work() / "notes/b.json", R"({"lesson": "rays"})");
  const auto rendered = [&](const std::string& words) {
    const Ran r = shell("isect render " + words + " --step 1 --format svg --out o");
    INFO(words << ": " << r.err);
    CHECK(r.status == 0);
    std::vector<std::string> folders;
    for (const std::string& line : lines_of(r.out)) folders.push_back(fs::path(line).parent_path().string());
    return folders;
  };
  using Folders = std::vector<std::string>;
  const Folders both = {"o/ray-sphere/a", "o/rays/b"};
  CHECK(rendered("--preset a.json notes/b.json") == both);  // as a shell expands *.json
  CHECK(rendered("--preset a.json --preset notes/b.json") == both);
  CHECK(rendered("a.json notes/*.json") == both);
  CHECK(rendered("ray-sphere --preset tangent --preset miss") == Folders{"o/ray-sphere/tangent", "o/ray-sphere/miss"});
  CHECK(rendered("--preset a.json ray-sphere") == Folders{"o/ray-sphere/a"});
  CHECK(rendered("--preset tangent a.json ray-sphere") == Folders{"o/ray-sphere/tangent", "o/ray-sphere/a"});
  CHECK(rendered("--preset a.json a.json ./a.json") == Folders{"o/ray-sphere/a"});  // the same file once

  const Ran other = shell("isect render rays --preset a.json");
  CHECK(other.status == 2);
  CHECK_THAT(other.err, Contains("a.json is for ray-sphere, not for rays"));
}

TEST_CASE("files of one name are told apart by where they lie, and nothing is written over", "[select]") {
  const Shell shell;
  write(shell.work() / "week-1/x.json", tangent);
  write(shell.work() / "week-2/x.json", tangent);
  const Ran r = shell("isect render --preset week-1/x.json week-2/x.json --step 1 --format svg");
  CHECK(r.status == 0);
  CHECK(r.out == "figures/ray-sphere/week-1/x/01-to-center.svg\nfigures/ray-sphere/week-2/x/01-to-center.svg\n");

  write(shell.work() / "miss.json", tangent);
  const Ran same = shell("isect render ray-sphere --preset miss miss.json --out o");
  CHECK(same.status == 2);
  CHECK_THAT(same.err, Contains("ray-sphere/miss") && Contains("rename"));
  CHECK_FALSE(fs::exists(shell.work() / "o"));
}

TEST_CASE("a folder of presets is rendered with those below it, past what is broken or none", "[select]") {
  const Shell shell;
  write(shell.work() / "notes/a.json", tangent);
  write(shell.work() / "notes/week-2/a.json", tangent);
  write(shell.work() / "notes/package.json", R"({"name": "course"})");
  const std::string render = "isect render --dir notes --step 1 --format svg --out o";
  const Ran r = shell(render);
  CHECK(r.status == 0);
  CHECK(r.out == "o/ray-sphere/a/01-to-center.svg\no/ray-sphere/week-2/a/01-to-center.svg\n");
  CHECK(lines_of(r.err).size() == 1);
  CHECK_THAT(r.err, Contains("package.json"));

  write(shell.work() / "notes/broken.json", R"({"lesson": "ray-sphere", "parameters": {"radus": 1}})");
  const Ran broken = shell(render);
  CHECK(broken.status == 2);
  CHECK(lines_of(broken.out).size() == 2);  // the others are done
  CHECK_THAT(broken.err, Contains("broken.json") && Contains("mean \"radius\""));
  CHECK(shell("isect render --dir notes rays").status == 2);  // no preset is for that lesson
  CHECK(shell("isect render --dir absent").status == 4);
  CHECK_THAT(shell("isect render --dir notes --preset a.json").err, Contains("--dir") && Contains("not both"));
}

TEST_CASE("steps are given one by one, as ranges and as lists", "[select]") {
  const Shell shell;
  const auto steps = [&](const std::string& text) {
    const Ran r = shell("isect explain ray-sphere --step " + text);
    INFO(text << ": " << r.err);
    CHECK(r.status == 0);
    std::vector<int> found;
    for (const std::string& line : lines_of(r.out))
      if (line.starts_with("Step ")) found.push_back(std::stoi(line.substr(5)));
    return found;
  };
  using List = std::vector<int>;
  CHECK(steps("3") == List{3});
  CHECK(steps("3-6") == List{3, 4, 5, 6});
  CHECK(steps("3,5,7-9") == List{3, 5, 7, 8, 9});
  CHECK(steps("7-9,8,3") == List{3, 7, 8, 9});
  CHECK(steps("all").size() == 13);
  CHECK(steps("-1") == List{13});
  CHECK(steps("-13,-2,-2") == List{1, 12});
  CHECK(steps("intersect") == List{11});
  CHECK(steps("11-intersect") == List{11});
  CHECK(steps("verdict,2-3,closing") == List{2, 3, 11, 13});
  CHECK(lines_of(shell("isect render ray-sphere --step 3-6 --format svg").out).size() == 4);
  for (const std::string bad : {"6-3", "0-3", "3-", "-14", "-3-5", "3-14", "3,,5", "a-b", "1.5", "'3;5'", "99999999999",
                                "10-intersect", "verdicts", "0"}) {
    INFO(bad);
    const Ran r = shell("isect explain ray-sphere --step " + bad);
    CHECK(r.status == 2);
    CHECK_THAT(r.err, Contains("step") && Contains("1 to 13") && Contains("3-6") && Contains("verdict"));
  }
  CHECK_THAT(shell("isect explain ray-sphere --step itersect").err, Contains("did you mean \"intersect\"?"));
  CHECK(shell("isect show ray-sphere --step 3-6").status == 2);
  CHECK(shell("isect show ray-sphere --step verdict").status == 77);  // nothing is missing but a display
}

TEST_CASE("the verdict is the step that tells the answer, in every preset of every lesson", "[select]") {
  const Shell shell;
  const std::vector<std::string> figures =
      lines_of(shell("isect render ray-sphere --preset two-roots,tangent,miss --step verdict --format svg").out);
  REQUIRE(figures.size() == 3);
  for (const std::string& figure : figures) CHECK_THAT(figure, !Contains("cases") && !Contains("closing"));
  for (const viz::Lesson* lesson : isect::lessons::all_lessons())
    for (const viz::Preset& p : lesson->presets) {
      INFO(lesson->id << "/" << p.id);
      const viz::Walk walk = lesson->walk(p.parameters);
      const std::vector<int> found = isect::program::Steps::read("verdict")->of(walk);
      REQUIRE(found.size() == 1);
      CHECK(walk.steps[found.front()].verdict.kind != viz::Verdict::Kind::open);
      for (std::size_t i = 0; i < walk.steps.size(); ++i)  // where a step is called so, it is that one
        if (walk.steps[i].slug == "verdict") CHECK(static_cast<int>(i) == found.front());
    }
}

TEST_CASE("several presets are joined by commas, as formats are", "[select]") {
  const Shell shell;
  const std::string both = shell("isect render ray-sphere --preset tangent,two-roots --step 1 --format svg").out;
  CHECK(lines_of(both).size() == 2);
  CHECK(both == shell("isect render ray-sphere --preset tangent --preset two-roots --step 1 --format svg").out);
  write(shell.work() / "p.json", tangent);
  write(shell.work() / "a,b.json", tangent);
  CHECK(lines_of(shell("isect render ray-sphere --preset p.json,two-roots --step 1 --format svg").out).size() == 2);
  CHECK(shell("isect render --preset a,b.json --step 1 --format svg").out ==
        "figures/ray-sphere/a,b/01-to-center.svg\n");  // a file of that name

  const Ran apart = shell("isect render ray-sphere --preset tangent two-roots --step 1");
  CHECK(apart.status == 2);
  CHECK_THAT(apart.err,
             Contains("\"two-roots\" is none, but a preset of ray-sphere") && Contains("--preset tangent,two-roots"));
  const Ran unknown = shell("isect render ray-sphere --preset tangent,two-rots");
  CHECK(unknown.status == 2);
  CHECK_THAT(unknown.err, Contains("two-rots") && Contains("two-roots"));
  const Ran one = shell("isect explain ray-sphere --preset tangent,two-roots");
  CHECK(one.status == 2);
  CHECK_THAT(one.err, Contains("preset: \"tangent,two-roots\" names 2"));
  CHECK(shell("isect render ray-sphere --preset tangent, --step 1").status == 2);
}

TEST_CASE("what is asked for and not there is told once, in few words", "[select]") {
  const Shell shell;
  const Ran r = shell("isect render --all --step 20 --format svg");
  CHECK(r.status == 0);
  CHECK_FALSE(r.out.empty());
  CHECK(lines_of(r.err).size() == 1);
  CHECK_THAT(r.err, StartsWith("step 20: ") && Contains("not in these presets") && Contains("ray-sphere (all 33)"));
  CHECK(r.err.size() < 1500);
  CHECK(shell("isect render --all --step 1 --format svg").err.empty());
}

TEST_CASE("a setting that a parameter's help forbids is refused at every door", "[select]") {
  const Shell shell;
  struct Wrong {
    std::string lesson, set, hint;
  };
  for (const Wrong& w : {
           Wrong{"ray-sphere", "direction=0,0,0", "of any length but 0"},
           Wrong{"ray-sphere", "direction=-0,0,0", "of any length but 0"},
           Wrong{"ray-polygon", "d=0,0,0", "of any length but 0"},
           Wrong{"rays", "d=0,0,3", "not 0 in the plane"},
           Wrong{"rays", "made=unit d=0,0,0", "not 0 in the plane"},
           Wrong{"rays", "made=points o=1,1,0 q=1,1,5", "not the first one"},
           Wrong{"hierarchy", "walk=ray d=0,0,1", "not 0 in the plane"},
           Wrong{"obb-obb", "a_u=0,0,0", "of any length but 0"},
           Wrong{"obb-obb", "b_v=0,0,0", "along b_u"},
           Wrong{"obb-obb", "a_u=0,2,0", "along a_u"},
           Wrong{"obb-obb", "b_half=1,-1,1", "from 0"},
       }) {
    INFO(w.lesson << " " << w.set);
    std::string sets, fields;
    std::istringstream words(w.set);
    for (std::string word; words >> word;) {
      const std::size_t equals = word.find('=');
      const std::string value = word.substr(equals + 1);
      sets += " --set " + word;
      fields += fields.empty() ? "" : ", ";
      fields += "\"" + word.substr(0, equals) +
                "\": " + (value.find(',') == value.npos ? "\"" + value + "\"" : "[" + value + "]");
    }
    for (const std::string& command :
         {"isect explain " + w.lesson + sets, "isect render " + w.lesson + sets, "isect show " + w.lesson + sets,
          std::string("isect render --preset p.json"), std::string("isect check --dir .")}) {
      INFO(command);
      write(shell.work() / "p.json", "{\"lesson\": \"" + w.lesson + "\", \"parameters\": {" + fields + "}}");
      const Ran r = shell(command);
      CHECK((r.status == 2 || command == "isect check --dir ."));
      CHECK(r.status != 0);
      CHECK_THAT(r.err + r.out, Contains("is not allowed; give ") && Contains(w.hint));
    }
  }
  // Only all settings together must keep it.
  CHECK(shell("isect explain obb-obb --set a_u=0,1,0 --set a_v=1,0,0 --step 1").status == 0);
  CHECK(shell("isect explain rays --set made=motion --set d=0,0,0 --step 1").status == 0);  // a velocity may be 0
  // A length is not 0 because its square underflows
  for (const char* tiny :
       {"ray-sphere --set direction=1e-200,0,0", "ray-sphere --set direction=5e-324,0,0",
        "ray-polygon --set d=0,0,-1e-200", "rays --set d=0,1e-200,0", "obb-obb --set a_u=1e-200,0,0"}) {
    INFO(tiny);
    CHECK(shell(std::string("isect explain ") + tiny).status == 0);
  }
}

TEST_CASE("every lesson keeps its own conditions, at the start and in each preset", "[select]") {
  for (const viz::Lesson* lesson : isect::lessons::all_lessons()) {
    INFO(lesson->id);
    viz::Parameters start;
    std::set<std::string> all;
    for (const viz::Parameter& p : lesson->parameters) {
      all.insert(p.name);
      if (!p.optional) start.emplace(p.name, p.initial);
    }
    CHECK_NOTHROW(viz::validate(*lesson, start));
    for (const viz::Preset& p : lesson->presets) CHECK_NOTHROW(viz::validate(*lesson, p.parameters));
    for (const viz::Condition& c : lesson->conditions) CHECK(all.contains(c.parameter));
  }
}

TEST_CASE("widths are understood as people write them", "[select]") {
  const Shell shell;
  const std::string render = "isect render ray-sphere --step 3 --format svg --out - --width ";
  const std::string eight = shell(render + "8cm").out, eight_and_half = shell(render + "8.5cm").out;
  REQUIRE_THAT(eight, Contains("width=\"226.7"));
  for (const std::string width : {"8CM", "'8 cm'", "8Cm", "'8   cm'", "80mm", "'80 MM'", "8,0cm"})
    CHECK(shell(render + width).out == eight);
  for (const std::string width : {"8,5cm", "'8.5 cm'", "'8,5 CM'", "85mm"})
    CHECK(shell(render + width).out == eight_and_half);
  for (const std::string width : {"8", "'8 c m'", "8,5,1cm", "cm", "' 8cm'", "1e400cm", "-8cm", "'8 '"}) {
    INFO(width);
    const Ran r = shell(render + width);
    CHECK(r.status == 2);
    CHECK_THAT(r.err, Contains("width") && Contains("8cm"));
  }
}

}  // namespace select_test
