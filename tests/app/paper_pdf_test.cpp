// Pages by LaTeX: as PDF, in a template of one's own, as dark slides and as overlays. A script stands in for LaTeX;
// tests/latex/compile.sh runs the real one.

#include <filesystem>

#include "app/pages/latex_run.h"
#include "app/pages/template.h"
#include "tests/app/shell.h"
#include "tests/catch.h"

namespace paper_pdf_test {
namespace fs = std::filesystem;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;
using isect::test::all_between;
using isect::test::Contains;
using isect::test::contents;
using isect::test::count;
using isect::test::files_in;
using isect::test::Ran;
using isect::test::Shell;
using isect::test::write;

namespace {

/// Puts a script in place of LaTeX. Returns what a command with it begins with.
std::string with_engine(const Shell& shell, const std::string& name, const std::string& script) {
  write(shell.work() / "bin" / name, "#!/bin/sh\n" + script);
  return "chmod +x bin/*; export FOLDER=\"$PWD\" PATH=\"$PWD/bin:$PATH\"; ";
}

constexpr const char* makes_pdf = "printf '%%PDF-1.7\\n%%%%EOF\\n' >handout.pdf\n";
constexpr const char* short_handout = "isect handout intervals --step 1-2 ";

/// Runs a handout in this template; returns what stderr says.
std::string complaint(const Shell& shell, const std::string& page_template) {
  write(shell.work() / "mine.tex", page_template);
  const Ran r = shell("isect handout intervals --step 1 --template mine.tex --out none");
  CHECK(r.status == 2);
  CHECK_FALSE(fs::exists(shell.work() / "none"));
  return r.err;
}

}  // namespace

TEST_CASE("LaTeX makes a page's PDF without a shell, beside its pictures, and only the PDF stays", "[paper_pdf]") {
  const Shell shell;
  const std::string latex =
      with_engine(shell, "lualatex",
                  std::string(makes_pdf) +
                      "echo 'isect: tagged' >handout.log\necho \"$*\" >>\"$FOLDER/said\"\nls >>\"$FOLDER/said\"\n");
  const Ran r = shell(latex + short_handout + "--format pdf --out out");
  CHECK(r.status == 0);
  CHECK(r.out == "out/intervals/overlapping/handout.pdf\n");
  CHECK(r.err.empty());
  const fs::path folder = shell.work() / "out/intervals/overlapping";
  CHECK(files_in(folder) == std::vector<std::string>{"handout.pdf"});
  CHECK(contents(folder / "handout.pdf") == "%PDF-1.7\n%%EOF\n% Made by isect handout.\n");
  const std::string said = contents(shell.work() / "said");
  CHECK_THAT(said, Contains("-no-shell-escape") && Contains("-halt-on-error") && Contains("01-opening.tikz"));
  CHECK(count(said, "-jobname=handout") == 2);  // for references

  // Over its own, but over no other's.
  CHECK(shell(latex + short_handout + "--format pdf,tex --out out").status == 0);
  CHECK(fs::exists(folder / "handout.tex"));
  CHECK_FALSE(fs::exists(folder / "handout.html"));
  write(folder / "handout.pdf", "%PDF-1.4 mine\n");
  CHECK(shell(latex + short_handout + "--format pdf --out out").status == 4);
  CHECK(contents(folder / "handout.pdf") == "%PDF-1.4 mine\n");
}

TEST_CASE("where LaTeX stops, its first error is told, and no PDF appears", "[paper_pdf]") {
  const Shell shell;
  const std::string latex =
      with_engine(shell, "lualatex",
                  std::string(makes_pdf) +
                      "printf 'This is it\\n./handout.tex:12: Undefined control sequence.\\nl.12 \\\\oops\\n' "
                      ">handout.log\nexit 1\n");
  const Ran r = shell(latex + short_handout + "--format pdf --out out");
  CHECK(r.status == 4);
  CHECK_THAT(r.err, Contains("cannot write 'handout.pdf': lualatex stopped: handout.tex, line 12: Undefined control "
                             "sequence."));
  CHECK_FALSE(fs::exists(shell.work() / "out/intervals/overlapping/handout.pdf"));
}

TEST_CASE("a page that LaTeX can't tag is made without tags, and that is told", "[paper_pdf]") {
  const Shell shell;
  const std::string latex = with_engine(
      shell, "lualatex",
      "case \"$*\" in\n*isectuntagged*) " + std::string(makes_pdf) +
          "echo fine >handout.log ;;\n*) echo './handout.tex:3: No tags today.' >handout.log; exit 1 ;;\nesac\n");
  const Ran r = shell(latex + short_handout + "--format pdf --out out");
  CHECK(r.status == 0);
  CHECK_THAT(r.err, Contains("no tags for screen readers") && Contains("line 3: No tags today."));
  CHECK(fs::exists(shell.work() / "out/intervals/overlapping/handout.pdf"));
}

TEST_CASE("a PDF without LaTeX is refused before anything is drawn, with what to install", "[paper_pdf]") {
  const Shell shell;
  const std::string alone = "mkdir -p alone; ln -sf \"$(command -v isect)\" alone/isect; PATH=\"$PWD/alone\" ";
  for (const std::string command : {"handout", "deck", "quiz"}) {
    INFO(command);
    const Ran r = shell(alone + "isect " + command + " ray-sphere --format pdf --out none");
    CHECK(r.status == 77);
    CHECK_THAT(r.err, Contains("LaTeX, which is not here") && Contains("apt-get install"));
    CHECK_FALSE(fs::exists(shell.work() / "none"));
  }
  const Ran wrong = shell("isect handout ray-sphere --format docx");
  CHECK(wrong.status == 2);
  CHECK_THAT(wrong.err, Contains("docx") && Contains("tex, html, pdf"));
}

TEST_CASE("LaTeX's first error is found in its log, with its place", "[paper_pdf]") {
  using isect::program::first_latex_error;
  CHECK(first_latex_error("This is LuaHBTeX\n(./a.tex\nLaTeX Font Info:  x on line 3.\n").empty());
  CHECK(first_latex_error("(./a.tex\n./sub/a.tikz:7: Missing $ inserted.\n./a.tex:9: More.\n") ==
        "sub/a.tikz, line 7: Missing $ inserted.");
  CHECK(first_latex_error("! Emergency stop.\n") == "Emergency stop.");
  CHECK_THAT(first_latex_error("./a.tex:2: LaTeX Error: File `tikz.sty' not found.\n"), Contains("apt-get install"));
}

TEST_CASE("a template gets the page's parts at its places, and the built-in one can be printed", "[paper_pdf]") {
  const Shell shell;
  for (const std::string command : {"handout", "deck", "quiz"}) {
    INFO(command);
    const Ran printed = shell("isect " + command + " --print-template");
    CHECK(printed.status == 0);
    write(shell.work() / "mine.tex", printed.out);
    const std::string run = "isect " + command + " ray-sphere --preset tangent --step 4-7 --out ";
    REQUIRE(shell(run + "usual").status == 0);
    REQUIRE(shell(run + "mine --template mine.tex").status == 0);
    const std::string page = "ray-sphere/tangent/" + command + ".tex";
    CHECK(contents(shell.work() / "usual" / page) == contents(shell.work() / "mine" / page));
    CHECK_THAT(contents(shell.work() / "usual" / page), !Contains("%%ISECT"));
  }
  write(shell.work() / "mine.tex",
        "\\documentclass{report}\n%%ISECT:preamble%%\n\\begin{document}\n\\chapter{%%ISECT:title%%}\n"
        "%%ISECT:body%%\n\\end{document}\n");
  REQUIRE(shell("isect handout ray-sphere --step 1 --template mine.tex --out report").status == 0);
  const std::string tex = contents(shell.work() / "report/ray-sphere/two-roots/handout.tex");
  CHECK_THAT(tex, StartsWith("% Made by isect handout.\n\\documentclass{report}\n\\usepackage{tikz}") &&
                      Contains("\\chapter{Ray and sphere}\n") && EndsWith("\\end{document}\n"));
}

TEST_CASE("a template with a wrong, missing or doubled place is refused, with the line", "[paper_pdf]") {
  const Shell shell;
  const std::string begin = "\\documentclass{article}\n%%ISECT:preamble%%\n", text = "\\begin{document}\n";
  const std::string body = "%%ISECT:body%%\n\\end{document}\n";
  CHECK_THAT(complaint(shell, begin + text + "%%ISECT:bodi%%\n" + body),
             Contains("mine.tex: line 4") && Contains("bodi") && Contains("\"body\""));
  CHECK_THAT(complaint(shell, begin + text), Contains("%%ISECT:body%% is missing") && Contains("(line 3)"));
  CHECK_THAT(complaint(shell, "\\documentclass{article}\n" + text + body),
             Contains("%%ISECT:preamble%% is missing") && Contains("before \\begin{document} (line 2)"));
  CHECK_THAT(complaint(shell, begin + text + "%%ISECT:body%%\n" + body), Contains("line 5") && Contains("line 4"));
  CHECK_THAT(complaint(shell, begin + "%%ISECT:body%%\n" + text + "\\end{document}\n"),
             Contains("line 3") && Contains("belongs after \\begin{document} (line 4)"));
  CHECK_THAT(complaint(shell, begin + text + "%%ISECT:body\n" + body), Contains("line 4") && Contains("no end"));
  CHECK_THAT(complaint(shell, body), Contains("\\documentclass"));
  CHECK(shell("isect handout intervals --template absent.tex").status == 4);
}

TEST_CASE("dark slides have dark pictures, and a theme of LaTeX's is named by letters", "[paper_pdf]") {
  const Shell shell;
  REQUIRE(shell("isect deck intervals --dark --beamer-theme Madrid --out dark").status == 0);
  const fs::path folder = shell.work() / "dark/intervals/overlapping";
  const std::string tex = contents(folder / "deck.tex"), html = contents(folder / "deck.html");
  const std::string ground = all_between(tex, "\\definecolor{isectground}{HTML}{", '}').at(0);
  CHECK_THAT(tex, Contains("\\usetheme{Madrid}\n") && Contains("bg=isectground"));
  CHECK_THAT(html, Contains("background: #" + ground));
  std::string upper = ground;
  for (char& c : upper) c = c >= 'a' && c <= 'f' ? static_cast<char>(c - 'a' + 'A') : c;
  CHECK_THAT(contents(folder / "01-opening.tikz"), Contains("{HTML}{" + upper + "}"));

  for (const std::string name : {"Madrid}", "../x", "a b"}) {
    const Ran r = shell("isect deck intervals --beamer-theme '" + name + "' --out none");
    CHECK(r.status == 2);
    CHECK_THAT(r.err, Contains("beamer-theme") && Contains("letters only"));
  }
  const Ran light = shell("isect deck intervals --dark --theme grey --out none");
  CHECK(light.status == 2);
  CHECK_THAT(light.err, Contains("grey") && Contains("dark"));
  CHECK_FALSE(fs::exists(shell.work() / "none"));
}

TEST_CASE("overlays show the steps of a preset in one frame, with pictures of one size", "[paper_pdf]") {
  const Shell shell;
  const std::string run = "isect deck ray-sphere --preset tangent ";
  REQUIRE(shell(run + "--overlays --out one").status == 0);
  REQUIRE(shell(run + "--out many").status == 0);
  const fs::path folder = shell.work() / "one/ray-sphere/tangent";
  const std::string tex = contents(folder / "deck.tex"),
                    many = contents(shell.work() / "many/ray-sphere/tangent/deck.tex");
  CHECK(count(tex, "\\begin{frame}") < count(many, "\\begin{frame}"));
  CHECK(count(tex, "\\begin{frame}") == count(tex, "\\end{frame}"));
  CHECK(count(tex, "\\input{") == count(many, "\\input{"));  // no picture is lost
  CHECK_THAT(tex, Contains("\\only<1>{") && Contains("\\uncover<"));

  // All pictures in that frame have one frame of their own.
  const std::size_t begin = tex.find("\\only<1>{");
  const std::string frame = tex.substr(begin, tex.find("\\end{frame}", begin) - begin);
  std::string box;
  const std::vector<std::string> pictures = all_between(frame, "\\input{", '}');
  CHECK(pictures.size() >= 8);
  for (const std::string& name : pictures) {
    INFO(name);
    const std::string own = all_between(contents(folder / name), "\\path[use as bounding box] ", ';').at(0);
    if (box.empty()) box = own;
    CHECK(own == box);
  }
  // An overlay's number is the next one, or the next but one after a question.
  int last = 0;
  for (const std::string& at : all_between(frame, "\\only<", '>')) {
    CHECK(std::stoi(at) == last + 1);
    last = std::stoi(at.substr(at.find('-') == at.npos ? 0 : at.find('-') + 1));
  }
  CHECK(last > static_cast<int>(pictures.size()));
}

TEST_CASE("the faces of a large mesh are a picture beside a TikZ figure, and both are written or neither",
          "[paper_pdf]") {
  const Shell shell;
  // A wavy sheet of 2 x 30 x 30 triangles, seen from above.
  std::string obj, faces;
  constexpr int side = 31;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      obj += "v " + std::to_string(0.1 * i) + " " + std::to_string(0.05 * ((i * j) % 3)) + " " +
             std::to_string(0.1 * j) + "\n";
      const int at = side * i + j + 1;
      if (i + 1 == side || j + 1 == side) continue;
      faces += "f " + std::to_string(at) + " " + std::to_string(at + 1) + " " + std::to_string(at + side + 1) + "\n";
      faces += "f " + std::to_string(at) + " " + std::to_string(at + side + 1) + " " + std::to_string(at + side) + "\n";
    }
  write(shell.work() / "sheet.obj", obj + faces);
  write(shell.work() / "sheet.json", R"({"objects": [{"mesh": "M", "file": "sheet.obj"},
    {"ray": "r", "origin": [1.5, 3, 1.5], "dir": [0, -1, 0]}], "ask": [["r", "M"]],
    "camera": {"azimuth": 20, "elevation": 70}})");
  const std::string render = "isect render sheet.json --format tikz --step 1 ";
  const Ran r = shell(render + "--out out");
  REQUIRE(r.status == 0);
  const fs::path figure = shell.work() / r.out.substr(0, r.out.size() - 1);
  const fs::path picture = figure.parent_path() / (figure.stem().string() + "-faces.pdf");
  REQUIRE(fs::exists(picture));
  CHECK_THAT(contents(figure), Contains("\\includegraphics[width=") && Contains(picture.filename().string()));
  CHECK(count(contents(figure), "\\fill") < 50);
  CHECK_THAT(contents(picture), StartsWith("%PDF-"));
  CHECK_THAT(contents(shell.work() / "out/manifest.json"), Contains("\"part_of\""));

  // Again, over its own; stdout has room for one file only.
  CHECK(shell(render + "--out out").err.empty());
  const Ran piped = shell(render + "--out -");
  CHECK_THAT(piped.out, !Contains("\\includegraphics"));
  CHECK(count(piped.out, "\\fill") > 1000);
  CHECK_THAT(piped.err, Contains("faces are paths here") && Contains("--out DIR"));

  // One that was edited keeps both, and somebody else's is never replaced.
  const std::string before = contents(figure);
  write(picture, contents(picture) + "% mine\n");
  CHECK_THAT(shell(render + "--theme grey --out out").err, Contains("-faces.pdf was edited"));
  CHECK(contents(figure) == before);
  fs::remove_all(shell.work() / "out");
  write(picture, "%PDF-1.4 mine\n");
  const Ran refused = shell(render + "--out out");
  CHECK(refused.status == 4);
  CHECK_THAT(refused.err, Contains("-faces.pdf") && Contains("not made by isect"));
  CHECK_FALSE(fs::exists(figure));
}

}  // namespace paper_pdf_test
