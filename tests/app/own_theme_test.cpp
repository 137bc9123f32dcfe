// Themes of one's own: how their files are read, what is refused and with what cure, and figures that carry them.

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/figures/theme_text.h"
#include "tests/app/refusals.h"
#include "tests/app/shell.h"
#include "tests/catch.h"
#include "viz/colour/theme_check.h"
#include "viz/formats/files.h"
#include "viz/lesson.h"

namespace own_theme_test {
namespace fs = std::filesystem;
namespace viz = isect::viz;
using namespace isect::test;
using Catch::Matchers::StartsWith;
using isect::program::read_theme;
using isect::program::ReadTheme;
using isect::program::theme_text;

namespace {

/// A theme that every reader can read, and whose colours no built-in one has.
constexpr const char* coast = R"({"name": "Coast", "based on": "print", "hatch": true,
  "roles": {"first": "#0b3c6f", "second": "#A8480B", "miss": "#9d3d98", "highlight": "#fc6"},
  "lines": {"outline": 0.8}})";
/// A theme whose second object some can't read.
constexpr const char* pale = R"({
  "name": "Pale",
  "roles": {"second": "#f6a800"}
})";

viz::Colour of(const viz::OwnTheme& theme, viz::Role role) { return theme.colours[static_cast<std::size_t>(role)]; }

std::string refusal(const std::string& text) {
  return refusal_of([&] { read_theme(text, "file"); });
}

}  // namespace

TEST_CASE("a theme's file says what is other than in the theme it is based on", "[own theme]") {
  const ReadTheme read = read_theme(coast, "file");
  CHECK(read.faults.empty());
  CHECK(read.notes.empty());
  CHECK(read.theme.name == "Coast");
  CHECK(read.theme.based_on == viz::ThemeName::print);
  CHECK(of(read.theme, viz::Role::first) == viz::hex(0x0B3C6F));
  CHECK(of(read.theme, viz::Role::second) == viz::hex(0xA8480B));
  CHECK(of(read.theme, viz::Role::highlight) == viz::hex(0xFFCC66));
  CHECK(read.theme.hatch);
  const viz::OwnTheme print = viz::values_of(viz::ThemeName::print);
  CHECK(of(read.theme, viz::Role::hit) == of(print, viz::Role::hit));
  CHECK(read.theme.lines[0] == 0.8);
  CHECK(read.theme.lines[1] == print.lines[1]);

  viz::OwnTheme empty = read_theme("{}", "week 3").theme;
  CHECK(empty.name == "week 3");
  empty.name = print.name;
  CHECK(empty == print);
  CHECK(read_theme("{}", "two\nlines").theme.name == "own");
  CHECK(read_theme("{}", "\xff").theme.name == "own");
  CHECK(read_theme(R"({"lines": 2})", "").theme.lines[0] == 2 * print.lines[0]);
  CHECK(read_theme("// mine\n{\"based on\": \"dark\"}", "").theme.based_on == viz::ThemeName::dark);
}

TEST_CASE("what is written of a theme is read as the same one, and passes as it did", "[own theme]") {
  for (const std::string text : {coast, pale, R"({"colors": ["#00549f", "#f6a800"]})", R"({"based on": "grey"})",
                                 R"({"based on": "dark", "lines": 1.3, "font": "DejaVu Sans", "name": "ü \"_*\""})"}) {
    INFO(text);
    const ReadTheme once = read_theme(text, "file");
    const ReadTheme twice = read_theme(theme_text(once.theme), "other");
    CHECK(twice.theme == once.theme);
    CHECK(twice.faults.size() == once.faults.size());
    CHECK(read_theme(isect::program::theme_text_by_lines(once.theme), "other").theme == once.theme);
  }
}

TEST_CASE("a field, a role or a value that is no theme's is refused with its line and what is allowed", "[own theme]") {
  CHECK_THAT(refusal("{\n\"roles\": {\n\"secnd\": \"#000000\"}}"), StartsWith("line 3: roles.secnd: unknown") &&
                                                                       Contains("mean \"second\"") &&
                                                                       Contains("background, panel"));
  CHECK_THAT(refusal(R"({"rolls": {}})"), Contains("rolls: unknown") && Contains("mean \"roles\""));
  CHECK_THAT(refusal(R"({"first": "#000000"})"), Contains("\"roles\": {\"first\""));
  CHECK_THAT(refusal(R"({"based on": "prnt"})"), Contains("based on: \"prnt\"") && Contains("mean \"print\""));
  CHECK_THAT(refusal(R"({"based on": 1})"), Contains("one of screen, print, grey, dark"));
  for (const std::string colour :
       {"\"red\"", "\"#12345\"", "\"00549f\"", "\"#00549g\"", "\"#00549fff\"", "5", "null"}) {
    INFO(colour);
    CHECK_THAT(refusal("{\"roles\": {\"first\": " + colour + "}}"),
               Contains("roles.first: " + colour + " is no colour; write \"#rrggbb\""));
  }
  CHECK_THAT(refusal(R"({"roles": []})"), Contains("an object in braces"));
  CHECK_THAT(refusal(R"({"roles": {"first": "#000000", "first": "#111111"}})"), Contains("given twice"));
  CHECK_THAT(refusal(R"({"name": "print"})"), Contains("\"print\" is built in"));
  CHECK_THAT(refusal(R"({"name": " "})"), Contains("name") && Contains("give a text"));
  CHECK_THAT(refusal("{\"name\": \"" + std::string(81, 'n') + "\"}"), Contains("at most 80 bytes"));
  CHECK_THAT(refusal(R"({"hatch": 1})"), Contains("hatch: true or false"));
  CHECK_THAT(refusal(R"({"font": ""})"), Contains("fc-list"));
  CHECK_THAT(refusal(R"({"lines": {"outlin": 1}})"), Contains("lines.outlin") && Contains("mean \"outline\""));
  CHECK_THAT(refusal(R"({"lines": {"ray": 7}})"), Contains("lines.ray: 7 is not allowed; give 0.1 to 6 points"));
  CHECK_THAT(refusal(R"({"lines": {"ray": "thick"}})"), Contains("lines.ray: a finite number"));
  CHECK_THAT(refusal(R"({"lines": 9})"), Contains("give 0.25 to 2.5"));
  CHECK_THAT(refusal(R"({"lines": "thick"})"), Contains("or a factor for all lines"));
  CHECK_THAT(refusal(R"({"colors": ["#00549f"]})"), Contains("2 colours"));
  CHECK_THAT(refusal(R"({"colors": {"first": "#00549f"}})"), Contains("2 colours"));
  CHECK_THAT(refusal(R"({"colors": ["#00549f", "gold"]})"), Contains("colors[1]: \"gold\" is no colour"));
  CHECK_THAT(refusal(R"({"colors": ["#00549f", "#00549f"]})"), Contains("colors: ") && Contains("look alike"));
  CHECK_THAT(refusal(R"({"colors": ["#00549f", "#f6a800"], "roles": {"hit": "#006000"}})"),
             Contains("roles.hit: \"colors\" gives it"));
  CHECK_THAT(refusal(R"({"colors": [], "colours": []})"), Contains("give one of them"));
  CHECK_THAT(refusal(R"({"colors": ["#00549f", "#f6a800"], "based on": "grey"})"), Contains("based on grey"));
  CHECK_THAT(refusal(R"({"name": "a",})"), Contains("comma"));
  CHECK_THAT(refusal("[]"), Contains("an object in braces"));
  CHECK_THAT(refusal(""), Contains("empty"));
}

TEST_CASE("two colours make a theme, on the grounds that the file gives", "[own theme]") {
  for (const char* field : {"colors", "colours"}) {
    const ReadTheme read = read_theme(std::string("{\"") + field + R"(": ["#00549f", "#f6a800"]})", "file");
    CHECK(read.faults.empty());
    REQUIRE(read.notes.size() == 2);
    CHECK_THAT(read.notes[1], StartsWith("second: #") && Contains("for #f6a800"));
  }
  const ReadTheme dark = read_theme(R"({"colors": ["#00549f", "#f6a800"], "based on": "dark",
    "roles": {"background": "#000000", "panel": "#101010"}})",
                                    "file");
  CHECK(dark.faults.empty());
  CHECK(of(dark.theme, viz::Role::second) == viz::hex(0xF6A800));  // light enough as it is
  CHECK(dark.notes[1] == "second: #f6a800, as given");
  const ReadTheme grey_ground =
      read_theme(R"({"colors": ["#00549f", "#f6a800"], "roles": {"background": "#777777"}})", "");
  REQUIRE_FALSE(grey_ground.faults.empty());
  CHECK_THAT(grey_ground.faults.front(), Contains("roles.background: ") && Contains("against black"));
}

TEST_CASE("a theme that some can't read is refused, and what is suggested passes", "[own theme]") {
  const ReadTheme read = read_theme(pale, "file");
  REQUIRE(read.faults.size() == 1);
  CHECK_THAT(read.faults[0], StartsWith("line 3: roles.second: ") && Contains("to 1 against background #ffffff") &&
                                 Contains("and 4.5 is wanted") && Contains(" would do, the nearest of that hue"));
  const Shell shell;
  write(shell.work() / "pale.json", pale);
  const Ran checked = shell("isect theme pale.json");
  CHECK(checked.status == 2);
  CHECK(checked.out.empty());
  CHECK(checked.err == "isect: theme: pale.json: " + read.faults[0] + "\n");
  for (const std::string command : {"render ray-sphere --step 1", "strip ray-sphere", "handout ray-sphere",
                                    "quiz ray-sphere", "deck ray-sphere", "theme --out s.png"}) {
    INFO(command);
    const Ran r = shell("isect " + command + (command.starts_with("theme") ? " pale.json" : " --theme pale.json"));
    CHECK(r.status == 2);
    CHECK(r.err == checked.err);
    CHECK(files_in(shell.work()) == std::vector<std::string>{"pale.json"});  // nothing is written
  }

  const std::string cure = read.faults[0].substr(read.faults[0].rfind("; #") + 3, 6);
  std::string mended = pale;
  write(shell.work() / "pale.json", mended.replace(mended.find("f6a800"), 6, cure));
  CHECK(shell("isect theme pale.json").status == 0);
}

TEST_CASE("of several faults theme lists each, and render the first", "[own theme]") {
  const Shell shell;
  write(shell.work() / "t.json", R"({"roles": {"text": "#808080", "muted": "#c0c0c0"}, "lines": {"ray": 0.2}})");
  const Ran listed = shell("isect theme t.json"), drawn = shell("isect render ray-sphere --theme t.json");
  CHECK(listed.status == 2);
  CHECK(count(listed.err, "\n") >= 3);
  for (const char* name : {"roles.text: ", "roles.muted: ", "lines.ray: 0.2 pt"})
    CHECK_THAT(listed.err, Contains(name));
  CHECK(drawn.status == 2);
  CHECK(count(drawn.err, "\n") == 1);
  CHECK_THAT(drawn.err, Contains("roles.text: ") && Contains("more, which `isect theme` lists"));
}

TEST_CASE("theme tells the numbers of a theme, writes it as a file to begin with, and draws a swatch", "[own theme]") {
  const Shell shell;
  write(shell.work() / "coast.json", coast);
  const Ran told = shell("isect theme coast.json");
  CHECK(told.status == 0);
  CHECK(told.err.empty());
  CHECK_THAT(told.out, StartsWith("Coast, based on print\n") && Contains("second        #a8480b  ") &&
                           Contains("to own tint") && Contains("to the text on it") && Contains("tritanopia"));
  for (const std::string name : {"screen", "print", "grey", "dark"}) {
    INFO(name);
    CHECK_THAT(shell("isect theme " + name).out, StartsWith(name + ", based on " + name));
    write(shell.work() / "begin.json", shell("isect theme " + name + " --json").out);
    CHECK(shell("isect theme begin.json").status == 0);
    viz::OwnTheme same = read_theme(contents(shell.work() / "begin.json"), "file").theme;
    CHECK(same.name == "my " + name);
    same.name = name;
    CHECK(same == viz::values_of(viz::theme_named(name)));
  }

  for (const std::string format : {"png", "svg", "pdf", "tikz"}) {
    INFO(format);
    const std::string command = "isect theme coast.json --out out/s." + format;
    const Ran r = shell(command);
    CHECK(r.status == 0);
    CHECK(r.out == "out/s." + format + "\n");
    const std::string once = contents(shell.work() / "out" / ("s." + format));
    CHECK(shell(command).status == 0);  // over its own
    CHECK(contents(shell.work() / "out" / ("s." + format)) == once);
  }
  const std::string svg = contents(shell.work() / "out/s.svg");
  for (const char* part : {"#0b3c6f", "#a8480b", "role second", "deuteranopia"}) CHECK_THAT(svg, Contains(part));
  CHECK_THAT(svg, Contains(viz::hex_of(seen_by(viz::Vision::deutan, viz::hex(0x0B3C6F)))));

  write(shell.work() / "mine.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"/>");
  CHECK(shell("isect theme coast.json --out mine.svg").status == 4);
  CHECK(contents(shell.work() / "mine.svg") == "<svg xmlns=\"http://www.w3.org/2000/svg\"/>");
  REQUIRE(shell("isect render ray-sphere --step 1 --format svg --out - >figure.svg").status == 0);
  CHECK(shell("isect theme coast.json --out figure.svg").status == 4);  // a figure is no swatch
  CHECK_THAT(shell("isect theme coast.json --out s.bmp").err, Contains("out: \"s.bmp\"") && Contains("png, svg"));
  CHECK(shell("isect theme absent.json").status == 4);
}

TEST_CASE("figures are drawn in a theme of one's own, and drawn again without its file", "[own theme]") {
  const Shell shell;
  write(shell.work() / "week/coast.json", coast);
  const std::string render =
      "isect render ray-sphere --preset tangent --step 4 --width 8cm --text-size 9pt --format svg,png,pdf,tikz";
  REQUIRE(shell(render + " --theme week/coast.json --out f").status == 0);
  const fs::path folder = shell.work() / "f/ray-sphere/tangent";
  const auto manifest = nlohmann::json::parse(contents(shell.work() / "f/manifest.json"));
  for (const auto& figure : manifest["figures"]) CHECK(figure["theme"] == "Coast");
  std::string stem;
  for (const auto& entry : fs::directory_iterator(folder)) stem = entry.path().stem().string();
  const std::string svg = contents(folder / (stem + ".svg")), tikz = contents(folder / (stem + ".tikz"));
  CHECK_THAT(svg,
             Contains("stroke:#0b3c6f") && Contains("stroke:#a8480b") && !Contains("#0b60c8") && !Contains("#a34e00"));
  CHECK_THAT(tikz, Contains("{HTML}{0B3C6F}") && Contains("{HTML}{A8480B}") && !Contains("{HTML}{0B60C8}"));

  fs::remove_all(shell.work() / "week");
  for (const std::string from : {"svg", "png", "pdf", "tikz"})
    for (const std::string to : {"svg", "tikz"}) {
      INFO(from << " as " << to);
      const std::string file = "f/ray-sphere/tangent/" + stem + "." + from;
      REQUIRE(shell("isect render " + file + " --format " + to + " --out g").status == 0);
      CHECK(contents(shell.work() / "g/ray-sphere/tangent" / (stem + "." + to)) ==
            contents(folder / (stem + "." + to)));
    }
  // The theme of the current command wins.
  REQUIRE(shell("isect render f/ray-sphere/tangent/" + stem + ".svg --theme print --format svg --out h").status == 0);
  CHECK_THAT(contents(shell.work() / "h/ray-sphere/tangent" / (stem + ".svg")),
             Contains("stroke:#0b60c8") && !Contains("#0b3c6f"));
}

TEST_CASE("strips, handouts, quizzes and slides take a theme of one's own, through a pipe, too", "[own theme]") {
  const Shell shell;
  write(shell.work() / "coast.json", coast);
  REQUIRE(shell("isect strip ray-sphere --step 2-3 --format svg --theme coast.json").status == 0);
  const auto strips = nlohmann::json::parse(contents(shell.work() / "figures/manifest.json"));
  CHECK(strips["figures"][0]["theme"] == "Coast");
  for (const std::string what : {"handout", "quiz", "deck"}) {
    INFO(what);
    const std::string folder = what == "quiz" ? "quizzes" : what + "s";
    REQUIRE(shell("mkfifo p.json; cat coast.json >p.json & isect " + what +
                  " ray-sphere --preset tangent --theme ./p.json; s=$?; rm p.json; exit $s")
                .status == 0);
    const auto manifest = nlohmann::json::parse(contents(shell.work() / folder / "manifest.json"));
    REQUIRE_FALSE(manifest["figures"].empty());
    for (const auto& figure : manifest["figures"]) CHECK(figure["theme"] == "Coast");
    std::string tikz;
    for (const auto& entry : fs::recursive_directory_iterator(shell.work() / folder))
      if (entry.path().extension() == ".tikz") tikz += contents(entry.path());
    CHECK_THAT(tikz, Contains("{HTML}{0B3C6F}") && !Contains("{HTML}{0B60C8}"));
  }
  write(shell.work() / "night.json", R"({"name": "Night", "based on": "dark"})");
  const Ran night = shell("isect deck ray-sphere --theme night.json");
  CHECK(night.status == 2);
  CHECK_THAT(night.err, Contains("theme: \"Night\"") && Contains("based on dark") && Contains("white pages"));
}

TEST_CASE("a theme's font sets a figure's letters, and --font wins", "[own theme]") {
  const Shell shell;
  write(shell.work() / "sans.json", R"({"font": "DejaVu Sans"})");
  const std::string render = "isect render ray-sphere --step 3 --format svg --width 8cm --out - ";
  const std::string sans = shell(render + "--theme sans.json").out, print = shell(render + "--theme print").out;
  REQUIRE_FALSE(sans.empty());
  const auto letters = [](const std::string& svg) { return all_between(svg, " d=\""); };
  CHECK(letters(sans) == letters(shell(render + "--theme print --font 'DejaVu Sans'").out));
  CHECK(letters(sans) != letters(print));
  CHECK(letters(shell(render + "--theme sans.json --font STIXGeneral").out) == letters(print));
  CHECK(shell("isect render ray-sphere --step 3 --format tikz --theme sans.json --out -").status == 0);
  write(shell.work() / "none.json", R"({"font": "DejaVu San"})");
  const Ran r = shell(render + "--theme none.json");
  CHECK(r.status == 2);
  CHECK_THAT(r.err, Contains("font: ") && Contains("mean \"DejaVu Sans\""));
}

TEST_CASE("the example themes pass and can be drawn", "[own theme]") {
  const Shell shell;
  int themes = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(ISECT_EXAMPLE_SCENES) / "themes")) {
    INFO(entry.path());
    const std::string file = "'" + entry.path().string() + "'";
    CHECK(shell("isect theme " + file + " --out swatch.svg").status == 0);
    CHECK(shell("isect render ray-sphere --step 3 --format svg --out - --theme " + file).status == 0);
    ++themes;
  }
  CHECK(themes >= 2);
}

}  // namespace own_theme_test
