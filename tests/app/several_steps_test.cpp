// Several steps in one file: strips, animations and decks.

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/app/shell.h"
#include "tests/catch.h"
#include "viz/formats/animation.h"
#include "viz/formats/files.h"

namespace several_steps_test {
namespace fs = std::filesystem;
namespace viz = isect::viz;
using namespace isect::test;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

TEST_CASE("a strip is one figure of several steps, with letters, captions and metadata", "[strip]") {
  const Shell shell;
  const Ran r = shell("isect strip ray-sphere --preset tangent --step 2-4 --format svg,pdf,tikz,png --labels text");
  CHECK(r.status == 2);  // the labels of tikz are LaTeX's
  const Ran made = shell("isect strip ray-sphere --preset tangent --step 2-4 --format svg,pdf,png");
  CHECK(made.status == 0);
  CHECK(made.err.empty());
  const std::string stem = "figures/ray-sphere/tangent/strip-02-04";
  CHECK(made.out == stem + ".svg\n" + stem + ".pdf\n" + stem + ".png\n");
  const std::string svg =
      shell("isect strip ray-sphere --preset tangent --step 2-4 --format svg --labels text --out -").out;
  CHECK_THAT(svg, Contains("width=\"453.5433pt\""));  // 16 cm
  CHECK(count(svg, "inkscape:label=\"page caption") == 3);
  CHECK(viz::svg_metadata(svg).at("step") == "2");
  CHECK(viz::pdf_metadata(contents(shell.work() / (stem + ".pdf"))).at("steps") == "02-04");
  const std::string alt = contents(shell.work() / (stem + ".txt"));
  CHECK_THAT(alt, StartsWith("(a) Ray and sphere: ") && Contains("\n\n(c) Ray and sphere: "));

  const auto manifest = nlohmann::json::parse(contents(shell.work() / "figures/manifest.json"));
  REQUIRE(manifest["figures"].size() == 3);
  CHECK(manifest["figures"][0]["steps"] == std::vector<int>{2, 3, 4});
  CHECK_THAT(manifest["figures"][0]["caption"].get<std::string>(),
             StartsWith("(a) ") && Contains("(c) ") && Contains("? (") && !Contains("?."));
}

TEST_CASE("a strip goes up to the verdict, unless other steps are asked for", "[strip]") {
  const Shell shell;
  const std::string strip = "isect strip relations --format svg";
  const std::string stem = "figures/relations/polygon-overlapping/strip-";
  const Ran r = shell(strip);
  CHECK(r.out == stem + "01-05.svg\n");  // map and card are steps 6 and 7
  CHECK(r.err.empty());                  // two a row: with three, headings would run together
  CHECK_THAT(contents(shell.work() / (stem + "01-05.svg")), Contains("width=\"453.5433pt\""));
  CHECK(shell(strip + " --step all").out == stem + "01-07.svg\n");
  CHECK(shell(strip + " --step 2-verdict").status == 2);
  CHECK(shell(strip + " --step 2,verdict").out == stem + "02+05.svg\n");
  CHECK_THAT(shell(strip + " --columns 4").err, Contains("wider"));
  // A strip of a scene goes without the card of all answers.
  write(shell.work() / "s.json", R"({"objects": [{"polygon": "A", "points": [[0, 0], [4, 0], [0, 4]]},
                                                 {"point": "P", "at": [1, 1]}, {"point": "Q", "at": [3, 3]}],
                                     "ask": [["P", "A"], ["Q", "A"]]})");
  CHECK(shell("isect strip s.json --format svg").out == "figures/scene/s/strip-01-03.svg\n");
  CHECK_THAT(shell("isect render s.json --step verdict --format svg").out, Contains("/03-") && !Contains("answers"));
}

TEST_CASE("figures of a strip are equally large: their letters stand in rows and columns, at any width", "[strip]") {
  const Shell shell;
  for (const std::string lesson : {"ray-sphere", "concave-polygon", "hierarchy", "capsule-capsule"})
    for (const std::string width : {"8cm", "16cm"}) {
      const std::string svg = shell("isect strip " + lesson + " --step 1-6 --columns 3 --width " + width +
                                    " --format svg --labels text --out -")
                                  .out;
      std::vector<std::pair<double, double>> at;
      for (char letter = 'a'; letter <= 'f'; ++letter) {
        const std::size_t words = svg.find(std::string("<tspan>(") + letter + ") ");
        REQUIRE(words != svg.npos);
        const std::size_t text = svg.rfind("<text x=\"", words), y = svg.find(" y=\"", text);
        at.emplace_back(std::stod(svg.substr(text + 9)), std::stod(svg.substr(y + 4)));
      }
      CAPTURE(lesson, width);
      const double column = at[1].first - at[0].first, row = at[3].second - at[0].second;
      CHECK(column > 70);
      CHECK(row > 0.5 * column);
      for (int i = 0; i < 6; ++i) {
        CHECK(at[i].first == Approx(at[0].first + i % 3 * column).margin(0.01));
        CHECK(at[i].second == Approx(at[i < 3 ? 0 : 3].second).margin(0.01));
      }
      CHECK(at[0].first < column);  // the first stands at the left edge, the last at the right one
      const std::size_t wide = svg.find("width=\"");
      CHECK(std::stod(svg.substr(wide + 7)) - at[2].first == Approx(at[0].first).margin(0.01));
    }
}

TEST_CASE("numbers at the ends of their lines take no column from a strip", "[strip]") {
  const Shell shell;
  const std::string svg = shell("isect strip concave-polygon --format svg --labels text --out -").out;
  const std::size_t height = svg.find(" height=\"");
  REQUIRE(height != svg.npos);
  CHECK(std::stod(svg.substr(height + 9)) < 29.7 / 2.54 * 72);  // of a page
}

TEST_CASE("strips and animations stay when the steps beside them are rendered again", "[strip]") {
  const Shell shell;
  REQUIRE(shell("isect strip ray-sphere --step 2-3").status == 0);
  REQUIRE(shell("isect render ray-sphere --step 2-3 --format gif --size 320x200").status == 0);
  const std::vector<std::string> before = files_in(shell.work() / "figures/ray-sphere");
  CHECK(before.size() == 4);
  REQUIRE(shell("isect render ray-sphere").status == 0);
  const std::vector<std::string> after = files_in(shell.work() / "figures/ray-sphere");
  for (const std::string& file : before) CHECK(std::ranges::find(after, file) != after.end());
}

TEST_CASE("a strip that someone has edited is left alone", "[strip]") {
  const Shell shell;
  const std::string strip = "isect strip ray-sphere --step 2-3 --format svg";
  const Ran first = shell(strip);
  REQUIRE(first.status == 0);
  const auto file = shell.work() / first.out.substr(0, first.out.size() - 1);
  write(file, "<svg>mine</svg>");
  const Ran r = shell(strip + " --theme grey");
  CHECK(r.status == 0);
  CHECK(r.out.empty());
  CHECK_THAT(r.err, Contains("left alone: ") && Contains(".svg was edited; remove it"));
  CHECK(contents(file) == "<svg>mine</svg>");
}

TEST_CASE("captions of a strip stand below the titles, without the lesson's opening", "[strip]") {
  const Shell shell;
  const std::string request = "isect strip ray-sphere --step 1-2 --format svg --labels text --out - ";
  const std::string with = shell(request + "--captions").out, without = shell(request).out;
  CHECK(with.size() > without.size() + 500);
  CHECK_THAT(with, Contains("Let "));
  CHECK_THAT(with.substr(with.find("</desc>")), !Contains("Ray tracers"));
}

TEST_CASE("captions of a strip begin with the title as a sentence, which may be a question", "[strip]") {
  const Shell shell;
  for (const char* of : {"capsule-capsule --preset touching", "obb-obb --preset edges"}) {
    INFO(of);
    const std::string svg =
        shell(std::string("isect strip ") + of + " --captions --format svg --labels text --out -").out;
    CHECK_THAT(svg, Contains("? "));
    CHECK_THAT(svg, !Contains("?."));
  }
}

TEST_CASE("an exercise of a deck or a handout tells the preset that it starts from", "[deck][handout]") {
  const Shell shell;
  for (const std::string kind : {"deck", "handout"}) {
    INFO(kind);
    REQUIRE(shell("isect " + kind + " clipping --preset concave --out out").status == 0);
    for (const char* suffix : {".tex", ".html"})
      CHECK_THAT(contents(shell.work() / "out/clipping/concave" / (kind + suffix)),
                 Contains("but the outcodes do not show it. (Preset both-ends-cut.)"));
  }
}

TEST_CASE("a deck and a handout have the lines of a program with a wrong line, and correct it behind all exercises",
          "[deck][handout]") {
  const Shell shell;
  for (const std::string kind : {"deck", "handout"}) {
    INFO(kind);
    REQUIRE(shell("isect " + kind + " intervals --preset touching --out out").status == 0);
    for (const char* suffix : {".tex", ".html"}) {
      const std::string page = contents(shell.work() / "out/intervals/touching" / (kind + suffix));
      const std::size_t asked = page.find("One of its lines is wrong."), shown = page.find("return DISJOINT", asked),
                        corrected = page.find("Line 3 should read");
      CHECK((asked != page.npos && asked < shown && shown < corrected && corrected != page.npos));
      if (kind == "deck") CHECK_THAT(page, Contains("Correction of exercise 5"));
    }
  }
}

TEST_CASE("a strip refuses what it can't do, by name", "[strip]") {
  const Shell shell;
  const auto refused = [&](const std::string& words) {
    const Ran r = shell("isect strip ray-sphere " + words);
    CHECK(r.status == 2);
    return r.err;
  };
  CHECK_THAT(refused("--step 3"), Contains("step: a strip has 2 to 26 parts, and here is 1"));
  CHECK_THAT(refused("--step 2-3 --columns 0"), Contains("columns: \"0\"") && Contains("1 to 12"));
  CHECK_THAT(refused("--step 2-3 --size 300x200"), Contains("size: ") && Contains("--width"));
  CHECK_THAT(refused("--step 2-3 --height 5cm"), Contains("height: "));
  CHECK_THAT(refused("--step 2-3 --format gif"), Contains("format: ") && Contains("render"));
  write(shell.work() / "figures/ray-sphere/two-roots/strip-02-03.png", "mine");
  const Ran r = shell("isect strip ray-sphere --step 2-3");
  CHECK(r.status == 4);
  CHECK(contents(shell.work() / "figures/ray-sphere/two-roots/strip-02-03.png") == "mine");
}

TEST_CASE("gif and apng show the steps in turn, one file a preset", "[animation]") {
  const Shell shell;
  const Ran r =
      shell("isect render ray-sphere --preset tangent --step 2-4 --format gif,apng,png --size 320x200 --seconds 1");
  CHECK(r.status == 0);
  const std::string folder = "figures/ray-sphere/tangent/";
  CHECK_THAT(r.out, EndsWith(folder + "steps-02-04.gif\n" + folder + "steps-02-04.apng\n"));
  CHECK(count(r.out, "\n") == 5);
  const std::string apng = contents(shell.work() / (folder + "steps-02-04.apng"));
  CHECK(viz::read_png(apng).rgba == viz::read_png(contents(shell.work() / (folder + "02-along-the-ray.png"))).rgba);
  CHECK(count(apng, "fcTL") == 3);
  CHECK(viz::gif_metadata(contents(shell.work() / (folder + "steps-02-04.gif"))).at("lesson") == "ray-sphere");
  const auto manifest = nlohmann::json::parse(contents(shell.work() / "figures/manifest.json"));
  CHECK(manifest["figures"][3]["file"] == "ray-sphere/tangent/steps-02-04.apng");
  CHECK(manifest["figures"][3]["seconds"] == 1);
  // A card of text stays four times as long.
  const std::string card =
      shell("isect render ray-sphere --step verdict,closing --format apng --size 320x200 --out -").out;
  CHECK(count(card, "fcTL") == 1 + 4);

  const std::string again = "isect render ray-sphere --preset tangent --step 2-4 --format gif --size 320x200 --out ";
  CHECK(shell(again + "-").out == shell("TZ=Asia/Tokyo LP_NUM_THREADS=1 " + again + "-").out);
  const Ran opened = shell("isect show " + folder + "steps-02-04.gif");  // no display here, but the place is known
  CHECK(opened.status == 77);
  CHECK_THAT(opened.err, Contains("isect render ray-sphere"));
  for (const auto& [words, why] : {std::pair{"--seconds 0", "seconds: \"0\""}, {"--transparent", "apng"}})
    CHECK_THAT(shell("isect render ray-sphere --format gif " + std::string(words)).err, Contains(why));
  CHECK_THAT(shell("isect render ray-sphere --format eps").err, Contains("transparency") && Contains("pdf"));
}

TEST_CASE("mp4 is made by ffmpeg, and where there is none that is said before anything is drawn", "[animation]") {
  const Shell shell;
  write(shell.work() / "bin/ffmpeg",
        "#!/bin/sh\nfor word; do :; done\nwc -c >/dev/null\nprintf '\\0\\0\\0\\030ftypisom' >\"$word\"\n");
  const std::string film = "isect render ray-sphere --preset tangent --step 2-4 --format mp4 --size 320x200";
  const Ran made = shell("chmod +x bin/ffmpeg; PATH=\"$PWD/bin:$PATH\" " + film);
  CHECK(made.status == 0);
  CHECK(made.out == "figures/ray-sphere/tangent/steps-02-04.mp4\n");
  CHECK_THAT(shell("PATH=\"$PWD/bin:$PATH\" isect doctor").out, Contains("ok  ffmpeg"));

  const std::string alone = "mkdir -p alone; ln -sf \"$(command -v isect)\" alone/isect; PATH=\"$PWD/alone\" ";
  const Ran none = shell(alone + film + " --out none");
  CHECK(none.status == 77);
  CHECK_THAT(none.err, Contains("mp4 is written by ffmpeg") && Contains("gif"));
  CHECK_FALSE(std::filesystem::exists(shell.work() / "none"));
  CHECK_THAT(shell(alone + "isect doctor").out, Contains("--  ffmpeg") && Contains("no mp4"));
  CHECK_THAT(shell("PATH=\"$PWD/bin:$PATH\" " + film + " --transparent").err, Contains("apng"));
}

TEST_CASE("a deck has a slide a step, its question before it, the answer behind a pause", "[deck]") {
  const Shell shell;
  const Ran r = shell("isect deck ray-sphere --preset tangent");
  CHECK(r.status == 0);
  CHECK(r.out == "decks/ray-sphere/tangent/deck.tex\ndecks/ray-sphere/tangent/deck.html\n");
  const fs::path folder = shell.work() / "decks/ray-sphere/tangent";
  const std::string tex = contents(folder / "deck.tex"), html = contents(folder / "deck.html");
  CHECK_THAT(tex, StartsWith("% Made by isect deck.\n\\documentclass[aspectratio=169"));
  CHECK(std::ranges::all_of(tex, [](char c) { return static_cast<unsigned char>(c) < 128; }));
  CHECK(count(tex, "\\begin{frame}") == count(html, "<section>"));
  CHECK(count(tex, "\\begin{frame}") == count(tex, "\\end{frame}"));
  CHECK(count(tex, "\\pause") == count(html, "class=\"later\""));
  CHECK(tex.find("Question 1") < tex.find("\\pause"));
  CHECK(count(html, "src=\"data:image/svg+xml;base64,") >= 10);
  CHECK(count(html, "src=\"") == count(html, "src=\"data:"));  // it needs nothing else
  CHECK(count(html, "http") == 0);
  CHECK(fs::exists(folder / "03-distance.tikz"));

  REQUIRE(shell("isect deck ray-sphere --preset tangent").status == 0);
  CHECK(contents(folder / "deck.html") == html);
  write(folder / "deck.tex", "\\documentclass{beamer}\n");
  CHECK(shell("isect deck ray-sphere --preset tangent").status == 4);
  CHECK(contents(folder / "deck.tex") == "\\documentclass{beamer}\n");
  CHECK_THAT(shell("isect deck ray-sphere --theme dark").err, Contains("theme: \"dark\"") && Contains("print"));
}

TEST_CASE("a question of a deck stands beside the picture and the numbers of its own step", "[deck]") {
  const Shell shell;
  const auto slide_of = [](const std::string& tex, const std::string& title) {
    const std::size_t from = tex.find("\\frametitle{" + title + "}");
    REQUIRE(from != tex.npos);
    return tex.substr(from, tex.find("\\end{frame}", from) - from);
  };
  REQUIRE(shell("isect deck obb-obb --preset normal-of-b").status == 0);
  const fs::path folder = shell.work() / "decks/obb-obb/normal-of-b";
  const std::string tex = contents(folder / "deck.tex");
  CHECK_THAT(slide_of(tex, "Question 2"), Contains("\\input{03-normals-b-question.tikz}"));
  CHECK_THAT(slide_of(tex, "The normals of b"), Contains("\\input{03-normals-b.tikz}"));
  const std::string asked = contents(folder / "03-normals-b-question.tikz");
  const std::string told = contents(folder / "03-normals-b.tikz"), before = contents(folder / "02-normals-a.tikz");
  CHECK_THAT(told, Contains("1.2879"));  // the formula is the answer
  CHECK_THAT(asked, !Contains("1.2879"));
  CHECK_THAT(before, Contains("0.75"));  // ... and this one is of the step before
  CHECK_THAT(asked, !Contains("1.0543"));
  CHECK_THAT(contents(folder / "03-normals-b-question.txt"), StartsWith("Drawn: ") && !Contains("disjoint"));
  const auto manifest = nlohmann::json::parse(contents(shell.work() / "decks/manifest.json"));
  CHECK(std::ranges::any_of(manifest["figures"], [](const auto& figure) {
    return figure["file"] == "obb-obb/normal-of-b/03-normals-b-question.tikz" && figure["title"] == "Question 2";
  }));

  // It is not removed like a figure of a step that the walk no longer has.
  REQUIRE(shell("isect render obb-obb --preset normal-of-b --format tikz --out decks").status == 0);
  CHECK(contents(folder / "03-normals-b-question.tikz") == asked);

  // The values known then stand in the question's words; a question without a picture stands alone.
  REQUIRE(shell("isect deck ray-sphere --step 5").status == 0);
  const std::string ray = contents(shell.work() / "decks/ray-sphere/two-roots/deck.tex");
  CHECK_THAT(slide_of(ray, "Question 2"), Contains("= 4.472") && Contains("= 21.146") && !Contains("= 1.1465"));
  CHECK_THAT(slide_of(ray, "What is given"), Contains("1.5234375"));
  REQUIRE(shell("isect deck speed-against-error --step 9-10").status == 0);
  const std::string chart = contents(shell.work() / "decks/speed-against-error/ray-sphere/deck.tex");
  CHECK_THAT(slide_of(chart, "Question 2"), !Contains("input{"));
}

}  // namespace several_steps_test
