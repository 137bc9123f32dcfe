// Figures as files: what is written where, the same every time, and how wrong requests are refused.

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/scene/lesson.h"
#include "tests/app/shell.h"
#include "tests/catch.h"
#include "viz/formats/files.h"
#include "viz/formats/tikz.h"
#include "viz/text/rich_text.h"

namespace render_test {
namespace fs = std::filesystem;
namespace program = isect::program;
namespace viz = isect::viz;
using namespace isect::test;
using Catch::Matchers::StartsWith;

TEST_CASE("render writes figures, alt text and a manifest, and prints the figures", "[render]") {
  const Shell shell;
  const Ran r = shell("isect render ray-sphere --preset tangent --step 2 --format png,svg");
  CHECK(r.status == 0);
  CHECK(r.err.empty());
  CHECK(r.out ==
        "figures/ray-sphere/tangent/02-along-the-ray.png\n"
        "figures/ray-sphere/tangent/02-along-the-ray.svg\n");
  CHECK(files_in(shell.work() / "figures") ==
        std::vector<std::string>{"manifest.json", "ray-sphere/tangent/02-along-the-ray.png",
                                 "ray-sphere/tangent/02-along-the-ray.svg", "ray-sphere/tangent/02-along-the-ray.txt"});
  CHECK_THAT(contents(shell.work() / "figures/ray-sphere/tangent/02-along-the-ray.txt"),
             StartsWith("Ray and sphere: "));

  const auto manifest = nlohmann::json::parse(contents(shell.work() / "figures/manifest.json"));
  CHECK(manifest["version"] == ISECT_VERSION);
  REQUIRE(manifest["figures"].size() == 2);
  const auto& svg = manifest["figures"][1];
  CHECK(svg["file"] == "ray-sphere/tangent/02-along-the-ray.svg");
  CHECK(svg["lesson"] == "ray-sphere");
  CHECK(svg["preset"] == "tangent");
  CHECK(svg["step"] == 2);
  CHECK(svg["renderer"] == "cairo");
  CHECK(svg["theme"] == "screen");
  CHECK(svg["parameters"].size() == 7);
  CHECK_FALSE(svg["caption"].get<std::string>().empty());
  CHECK_THAT(manifest["figures"][0]["renderer"].get<std::string>(), StartsWith("llvmpipe"));
}

TEST_CASE("a figure carries lesson, preset, step and parameters inside", "[render]") {
  const Shell shell;
  shell("isect render ray-sphere --preset miss --step 3 --format png,svg,pdf,tikz --set radius=0.5");
  const std::string stem = (shell.work() / "figures/ray-sphere/miss+radius=0.5/03-distance").string();
  for (const viz::Metadata& data :
       {viz::png_metadata(contents(stem + ".png")), viz::svg_metadata(contents(stem + ".svg")),
        viz::pdf_metadata(contents(stem + ".pdf")), viz::tikz_metadata(contents(stem + ".tikz"))}) {
    CHECK(data.at("lesson") == "ray-sphere");
    CHECK(data.at("step") == "3");
    CHECK_FALSE(data.contains("preset"));  // a parameter was changed by hand
    CHECK_THAT(data.at("parameters"), Contains("\"radius\":0.5"));
    CHECK(data.at("version") == ISECT_VERSION);
  }
}

TEST_CASE("a figure on paper has the size asked for in every format, and texts of their own size", "[render]") {
  const Shell shell;
  const std::string request =
      "isect render ray-sphere --preset two-roots --step 3 --format png,svg,pdf,tikz --width 8cm --height 6cm ";
  REQUIRE(shell(request + "--dpi 254").status == 0);
  const std::string stem = (shell.work() / "figures/ray-sphere/two-roots/03-distance").string();
  const std::string svg = contents(stem + ".svg");
  CHECK_THAT(svg, Contains("width=\"226.7717pt\" height=\"170.0787pt\" viewBox=\"0 0 226.7717 170.0787\""));
  CHECK_THAT(contents(stem + ".pdf"), Contains("/MediaBox [ 0 0 226.771"));
  CHECK_THAT(contents(stem + ".tikz"), Contains("\\clip (0,0) rectangle (226.772,170.079);"));
  const viz::Picture png = viz::read_png(contents(stem + ".png"));
  CHECK(png.width == 800);
  CHECK(png.height == 600);
  const auto manifest = nlohmann::json::parse(contents(shell.work() / "figures/manifest.json"));
  CHECK(manifest["figures"][0]["text_pt"] == 9);

  const Ran large = shell(request + "--labels text --out -");  // one figure, several formats
  CHECK(large.status == 2);
  const auto text_size = [&](const std::string& more) {
    const Ran r = shell("isect render ray-sphere --step 3 --format svg --labels text --out - " + more);
    CHECK(r.status == 0);
    return r.out.substr(r.out.find("font-size:", r.out.find("label-o")), 14);
  };
  CHECK(text_size("--width 8cm") == "font-size:9;fi");
  CHECK(text_size("--width 16cm") == "font-size:9;fi");
  CHECK(text_size("--width 60cm --text-size 24pt") == "font-size:24;f");
}

TEST_CASE("a figure too narrow for its labels is honestly wider, and that is told", "[render]") {
  const Shell shell;
  const Ran r = shell("isect render ray-sphere --preset two-roots --step 12 --format svg --width 3cm");
  CHECK(r.status == 0);
  CHECK_THAT(r.err, StartsWith("width: ") && Contains("ray-sphere/two-roots/12-cases: ") && Contains("--text-size"));
  const auto manifest = nlohmann::json::parse(contents(shell.work() / "figures/manifest.json"));
  CHECK(manifest["figures"][0]["width_pt"].get<double>() > 86);
  CHECK(shell("isect render ray-sphere --preset two-roots --step 3 --format svg --width 3cm").err.empty());
}

TEST_CASE("a figure loses its title, its ground and its empty rim where that is asked for", "[render]") {
  const Shell shell;
  const auto drawn = [&](const std::string& more) {
    return shell("isect render ray-sphere --step 3 --format svg --out - " + more).out;
  };
  CHECK_THAT(drawn(""), Contains("<g id=\"page-title\"") || Contains("inkscape:label=\"page title\""));
  CHECK_THAT(drawn("--no-title"), !Contains("inkscape:label=\"page title\""));
  CHECK_THAT(drawn("--transparent"), !Contains("<rect"));
  const viz::Picture png = viz::read_png(shell("isect render ray-sphere --step 3 --transparent --out -").out);
  CHECK(png.rgba[3] == 0);
  CHECK(std::ranges::any_of(png.rgba, [](int byte) { return byte == 255; }));
}

TEST_CASE("a cropped figure has the size on paper that was asked for, with a margin all round", "[render]") {
  const Shell shell;
  const auto cropped = [&](const std::string& more) {
    const Ran r = shell("isect render --theme print --transparent --crop --format png --out - --dpi 144 " + more);
    INFO(more << r.err);
    REQUIRE(r.status == 0);
    CHECK(r.err.empty());
    return viz::read_png(r.out);
  };
  const auto rim = [](const viz::Picture& p) {  // of empty pixels: left and right, above and below
    int left = p.width, top = p.height, right = p.width, bottom = p.height;
    for (int y = 0; y < p.height; ++y)
      for (int x = 0; x < p.width; ++x)
        if (p.rgba[4 * (static_cast<std::size_t>(y) * p.width + x) + 3] > 0) {
          left = std::min(left, x), right = std::min(right, p.width - 1 - x);
          top = std::min(top, y), bottom = std::min(bottom, p.height - 1 - y);
        }
    return std::array{left, right, top, bottom};
  };
  constexpr int least = 2 * 1.5, most = 2 * 3.5;  // pixels of half a point: about 2 points
  for (const std::string figure :
       {"relations --preset polygon-overlapping --step 3", "ray-sphere --step 3", "ray-sphere --step 11 --no-title",
        "obb-obb --preset edges --step 4", "crossings --step 5", "bounding-volumes --step 2"})
    for (const auto& [width, pixels] : {std::pair{"8cm", 454}, {"12cm", 681}}) {
      const viz::Picture p = cropped(figure + " --width " + width);
      CHECK(p.width == pixels);
      const auto [left, right, top, bottom] = rim(p);
      INFO(figure << ": " << left << " " << right << " " << top << " " << bottom);
      CHECK((least <= left && left <= most && least <= right && right <= most));
      CHECK((least <= top && top <= most && least <= bottom && bottom <= most));
    }
  CHECK(cropped("ray-sphere --step 3 --height 5cm").height == 284);
  const viz::Picture both = cropped("ray-sphere --step 3 --width 9cm --height 6cm");
  CHECK((both.width == 511 && both.height == 341));

  const auto manifest = [&](const std::string& words) {
    REQUIRE(shell("isect " + words).status == 0);
    return nlohmann::json::parse(contents(shell.work() / "figures/manifest.json"))["figures"].back();
  };
  CHECK(manifest("strip ray-sphere --step 2-4 --crop --width 14cm --format svg")["width_pt"].get<double>() ==
        Approx(14 * 72 / 2.54));
}

TEST_CASE("figures are set in the family asked for, if it is installed", "[render]") {
  const Shell shell;
  const std::string command = "isect render ray-sphere --step 4 --labels text --format svg --font ";
  REQUIRE(shell(command + "'dejavu sans'").status == 0);
  const std::string svg = contents(shell.work() / "figures/ray-sphere/two-roots/04-early-reject.svg");
  CHECK_THAT(svg, Contains("font-family:'DejaVu Sans'") && !Contains("STIXGeneral"));
  const Ran wrong = shell(command + "'DejaVu Sant' --out other");
  CHECK(wrong.status == 2);
  CHECK_THAT(wrong.err, Contains("font: ") && Contains("did you mean \"DejaVu Sans\"?"));
  CHECK_THAT(shell("isect render ray-sphere --format tikz --font 'DejaVu Sans'").err, Contains("font: LaTeX sets"));
  // Any of the names that fc-list has for a font will do: "Latin Modern Roman,LM Roman 10".
  std::istringstream families(shell("fc-list : family").out);
  for (std::string line; std::getline(families, line);) {
    const std::size_t comma = line.find(',');
    const std::string second = comma == line.npos ? "" : line.substr(comma + 1, line.find(',', comma + 1) - comma - 1);
    if (second.empty() ||
        second.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789 ") != second.npos)
      continue;
    INFO(second);
    CHECK(shell(command + "'" + second + "' --out named").status == 0);
    break;
  }
}

namespace {

/// The first picture of a scene.
viz::Scene first_picture(const std::string& scene) {
  const viz::Lesson& lesson = program::scene::kept_lesson_of(scene, ISECT_EXAMPLE_SCENES);
  return lesson.steps(lesson.presets.front().parameters).steps.front().scene;
}

const viz::Label& name(const viz::Scene& scene, const std::string& of) {
  for (const viz::Item& item : scene.items)
    if (const viz::Label* label = std::get_if<viz::Label>(&item); label && viz::plain(label->text) == of) return *label;
  throw std::logic_error("no name " + of);
}

}  // namespace

TEST_CASE("bodies of a scene of one's own do not all have one colour, and those asked about together never",
          "[render]") {
  const Shell shell;
  write(shell.work() / "s.json", R"({"objects": [{"sphere": "S", "center": [0, 0, 0], "radius": 1},
                                                 {"box": "T", "lo": [1, -1, -1], "hi": [3, 0, 1]}]})");
  const std::string svg = shell("isect render s.json --step 1 --theme print --format svg --out -").out;
  CHECK_THAT(svg, Contains("#0b60c8") && Contains("#a34e00"));

  const viz::Scene scene = first_picture(viz::read_file(ISECT_EXAMPLE_SCENES "/triangle-and-box.json"));
  CHECK(name(scene, "A").role == viz::Role::first);
  CHECK(name(scene, "s").role == viz::Role::second);
  CHECK(name(scene, "t").role == viz::Role::second);
}

TEST_CASE("the name of a mesh or a frustum keeps off a name that stands at its top", "[render]") {
  const std::string body[] = {
      R"({"mesh": "T", "points": [[0,1,0],[2,0,0],[0,0,2],[-2,0,-1]], "triangles": [[0,2,1],[0,3,2],[0,1,3],[1,2,3]]})",
      R"({"frustum": "T", "eye": [0,-2,0], "forward": [0,1,0], "up": [0,0,1], "angle": 60, "near": 1, "far": 3})"};
  for (const std::string& b : body) {
    const viz::Vec3 top = name(first_picture(R"({"objects": [)" + b + "]}"), "T").at;
    const std::string ball =
        fmt::format(R"({{"sphere": "S", "center": [{}, {}, {}], "radius": 0.5}})", top.x(), top.y() + 0.1, top.z());
    const viz::Scene both = first_picture(R"({"objects": [)" + b + ", " + ball + "]}");
    CHECK((name(both, "T").at - name(both, "S").at).norm() > 1);
    CHECK((top - name(both, "S").at).norm() < 0.2);
  }
}

TEST_CASE("captions in the manifest are LaTeX, too", "[render]") {
  const Shell shell;
  REQUIRE(shell("isect render --all --preset all --step 1-2 --format tikz").status == 0);
  const auto manifest = nlohmann::json::parse(contents(shell.work() / "figures/manifest.json"));
  for (const auto& figure : manifest["figures"]) {
    const std::string caption = figure["caption_tex"];
    INFO(figure["file"] << ": " << caption);
    CHECK(std::ranges::all_of(caption, [](char c) { return static_cast<unsigned char>(c) < 128; }));
    CHECK(std::ranges::count(caption, '$') % 2 == 0);
  }
}

TEST_CASE("the same request gives the same bytes", "[render]") {
  const Shell shell;
  const std::string request = "isect render ray-sphere --preset two-roots --step 8 --format png,svg,pdf,tikz --out ";
  REQUIRE(shell(request + "a").status == 0);
  REQUIRE(shell("LC_ALL=C.UTF-8 TZ=Asia/Tokyo LP_NUM_THREADS=1 " + request + "b").status == 0);
  const std::vector<std::string> files = files_in(shell.work() / "a");
  REQUIRE(files.size() == 6);
  CHECK(files == files_in(shell.work() / "b"));
  for (const std::string& file : files)
    CHECK(contents(shell.work() / "a" / file) == contents(shell.work() / "b" / file));
}

TEST_CASE("both back ends draw the same picture", "[render]") {
  const Shell shell;
  const std::string request = "isect render ray-sphere --step 8 --out - --backend ";
  REQUIRE(shell(request + "osmesa >o.png").status == 0);
  REQUIRE(shell(request + "egl >e.png").status == 0);
  const viz::Picture a = viz::read_png(contents(shell.work() / "o.png"));
  const viz::Picture b = viz::read_png(contents(shell.work() / "e.png"));
  CHECK(viz::compare(a, b).over_1 == 0);
}

TEST_CASE("step all is every step of the lesson's first preset", "[render]") {
  const Shell shell;
  CHECK(shell("isect render ray-sphere --step all --format svg").status == 0);
  CHECK(files_in(shell.work() / "figures/ray-sphere").size() == 2 * 13);
}

TEST_CASE("all is every preset of every lesson", "[render]") {
  const Shell shell;
  CHECK(shell("isect render --all --step 1 --format svg").status == 0);
  CHECK(files_in(shell.work() / "figures/ray-sphere").size() == 2 * 33);
  // A step that only some presets have is rendered for those.
  CHECK(shell("isect render --all --step 11 --format svg --out last").status == 0);
  CHECK(files_in(shell.work() / "last/ray-sphere").size() < 2 * 30);
}

TEST_CASE("what a figure on paper shows takes its share of the width", "[render]") {
  const Shell shell;
  const auto share_of_width = [&](const std::string& figure) {
    const viz::Picture p = viz::read_png(
        shell("isect render " + figure + " --theme print --width 8cm --dpi 100 --format png --out -").out);
    int left = p.width, right = 0;
    for (int i = 0; i < p.width * p.height; ++i) {
      const auto [least, most] = std::minmax({p.rgba[4 * i], p.rgba[4 * i + 1], p.rgba[4 * i + 2]});
      if (most - least > 60) left = std::min(left, i % p.width), right = std::max(right, i % p.width);
    }
    return static_cast<double>(right - left) / p.width;
  };
  CHECK(share_of_width("bounding-volumes --preset tilted --step 1") > 0.36);  // a pin, higher than wide
  CHECK(share_of_width("bounding-volumes --preset tilted --step 2") > 0.4);
  CHECK(share_of_width("obb-obb --preset edges --step 1") > 0.55);
  CHECK(share_of_width("obb-obb --preset edges --step 4") > 0.7);
}

TEST_CASE("size, width and theme reach the figure", "[render]") {
  const Shell shell;
  REQUIRE(shell("isect render ray-sphere --step 3 --size 320x200 --theme grey --out - >g.png").status == 0);
  const viz::Picture grey = viz::read_png(contents(shell.work() / "g.png"));
  CHECK(grey.width == 320);
  CHECK(grey.height == 200);
  bool coloured = false;
  for (std::size_t i = 0; i < grey.rgba.size(); i += 4)
    coloured |= grey.rgba[i] != grey.rgba[i + 1] || grey.rgba[i] != grey.rgba[i + 2];
  CHECK_FALSE(coloured);

  const std::string svg = shell("isect render ray-sphere --step 3 --format svg --width 8cm --out -").out;
  CHECK_THAT(svg, Contains("width=\"226.77"));
  CHECK(svg == shell("isect render ray-sphere --step 3 --format svg --width 80mm --out -").out);
}

TEST_CASE("a preset comes from a file, which names its folder", "[render]") {
  const Shell shell;
  write(shell.work() / "wide.json", R"({"lesson": "ray-sphere", "parameters": {"radius": 2}})");
  const Ran r = shell("isect render --preset wide.json --step 1 --format svg");
  CHECK(r.status == 0);
  CHECK(r.out == "figures/ray-sphere/wide/01-to-center.svg\n");
}

TEST_CASE("a preset's file that is wrong is refused by field, one that can't be read by name", "[render]") {
  const Shell shell;
  const auto refused = [&](const std::string& json) {
    write(shell.work() / "p.json", json);
    const Ran r = shell("isect render --preset p.json");
    CHECK(r.status == 2);
    CHECK_THAT(r.err, Contains("p.json"));
    return r.err;
  };
  CHECK_THAT(refused("{"), Contains("not JSON"));
  CHECK_THAT(refused(R"({"lesson": "ray-spere"})"), Contains("mean \"ray-sphere\""));
  CHECK_THAT(refused(R"({"lesson": "ray-sphere", "parameters": {"radus": 1}})"), Contains("mean \"radius\""));
  CHECK_THAT(refused(R"({"lesson": "ray-sphere", "parameters": {"radius": "big"}})"), Contains("radius"));
  CHECK_THAT(refused(std::string(100000, '[')), Contains("nested more than 16 levels deep"));
  CHECK(shell("isect render --preset absent.json").status == 4);
  CHECK(shell("mkdir d.json && isect render --preset d.json").status == 4);
  CHECK_FALSE(fs::exists(shell.work() / "figures"));
}

TEST_CASE("wrong names and values are refused by field, and nothing is written", "[render]") {
  const Shell shell;
  struct Wrong {
    const char *arguments, *field, *hint;
  };
  for (const Wrong& w : {
           Wrong{"ray-spere", "lesson", "mean \"ray-sphere\""},
           Wrong{"", "lesson", "ray-sphere"},
           Wrong{"ray-sphere --all", "lesson", "--all"},
           Wrong{"ray-sphere --preset tangnt", "preset", "mean \"tangent\""},
           Wrong{"ray-sphere --theme gray", "theme", "mean \"grey\""},
           Wrong{"ray-sphere --format pgn", "format", "mean \"png\""},
           Wrong{"ray-sphere --format png,", "format", "png, svg"},
           Wrong{"ray-sphere --backend mesa", "back", "mean \"osmesa\""},
           Wrong{"ray-sphere --set radius", "set", "name=value"},
           Wrong{"ray-sphere --set radus=1", "parameter", "mean \"radius\""},
           Wrong{"ray-sphere --set radius=x", "radius", "a number"},
           Wrong{"ray-sphere --set radius=-1", "radius", "from 0"},
           Wrong{"ray-sphere --set origin=1,2", "origin", "three numbers"},
           Wrong{"ray-sphere --set method=hains", "method", "mean \"haines\""},
           Wrong{"ray-sphere --step 14", "step", "1 to 13"},
           Wrong{"ray-sphere --step al", "step", "all"},
           Wrong{"ray-sphere --size 15x600", "size", "16 to 8192"},
           Wrong{"ray-sphere --size 960x8193", "size", "16 to 8192"},
           Wrong{"ray-sphere --size 960", "size", "960x600"},
           Wrong{"ray-sphere --size 9.5x600", "size", "960x600"},
           Wrong{"ray-sphere --format svg --width 8", "width", "cm, mm, pt, in"},
           Wrong{"ray-sphere --format svg --width nancm", "width", "8cm"},
           Wrong{"ray-sphere --format svg --width 9pt", "width", "10pt"},
           Wrong{"ray-sphere --height 8", "height", "cm, mm, pt, in"},
           Wrong{"ray-sphere --width 8cm --text-size 3pt", "text-size", "4pt"},
           Wrong{"ray-sphere --text-size 9pt", "text-size", "--width"},
           Wrong{"ray-sphere --dpi 300", "dpi", "--width"},
           Wrong{"ray-sphere --width 8cm --dpi 5", "dpi", "30 to 2400"},
           Wrong{"ray-sphere --width 4m", "width", "cm, mm, pt, in"},
           Wrong{"ray-sphere --step 1 --width 200cm --dpi 600", "dpi", "million"},
           Wrong{"ray-sphere --step 1 --width 1cm --text-size 200pt --format svg", "width", "--text-size"},
           Wrong{"ray-sphere --labels txt", "labels", "mean \"text\""},
           Wrong{"ray-sphere --format svg --labels tex", "labels", "tikz"},
           Wrong{"ray-sphere --format tikz --labels outline", "labels", "LaTeX"},
           Wrong{"ray-sphere --format svg --width 8cm --size 100x100", "size", "not both"},
           Wrong{"ray-sphere --out -", "out", "exactly one"},
           Wrong{"ray-sphere --step 1 --format png,svg --out -", "out", "exactly one"},
       }) {
    INFO(w.arguments);
    const Ran r = shell(std::string("isect render ") + w.arguments);
    CHECK(r.status == 2);
    CHECK(r.out.empty());
    CHECK_THAT(r.err, Contains(w.field) && Contains(w.hint));
  }
  CHECK(fs::is_empty(shell.work()));
}

TEST_CASE("a direction of zero length is drawn or refused, never a crash", "[render]") {
  const Shell shell;
  for (const std::string set : {"direction=0,0,0", "radius=0", "origin=1e6,-1e6,1e6", "t_max=0"}) {
    INFO(set);
    const Ran r = shell("isect render ray-sphere --step all --format svg --set " + set);
    CHECK((r.status == 0 || r.status == 2));
  }
}

TEST_CASE("a figure that can't be written is named, and what was there stays whole", "[render]") {
  const Shell shell;
  const std::string render = "isect render ray-sphere --step 1 --format svg --out ";
  const Ran file = shell("touch taken && " + render + "taken");
  CHECK(file.status == 4);
  CHECK_THAT(file.err, Contains("taken"));
  CHECK(shell(render + "/proc/nowhere").status == 4);

  // A file size limit stops the second, larger writing midway.
  REQUIRE(shell(render + "f").status == 0);
  const fs::path figure = shell.work() / "f/ray-sphere/two-roots/01-to-center.svg";
  const std::string before = contents(figure);
  const Ran cut = shell("trap '' XFSZ; ulimit -f 4; " + render + "f");
  CHECK(cut.status == 4);
  CHECK_THAT(cut.err, Contains("01-to-center.svg"));
  CHECK(contents(figure) == before);
  CHECK(files_in(shell.work() / "f").size() == 3);  // no leftovers
}

TEST_CASE("svg needs no rendering back end, png says what is missing", "[render]") {
  const Shell shell;
  // softpipe is a driver that the back ends refuse.
  const std::string broken = "GALLIUM_DRIVER=softpipe ";
  CHECK(shell(broken + "isect render ray-sphere --step 1 --format svg").status == 0);
  const Ran r = shell(broken + "isect render ray-sphere --step 1");
  CHECK(r.status == 77);
  CHECK_THAT(r.err, Contains("softpipe"));
  CHECK(shell(broken + "isect check ray-sphere --preset miss --update").status == 77);
  CHECK(shell(broken + "isect doctor").status == 77);
}

}  // namespace render_test
