// Further looks of a preset or a scene that are guarded: other themes, sizes and formats.

#include <algorithm>

#include "app/guard.h"
#include "tests/app/accepted.h"
#include "tests/app/refusals.h"

namespace check_guard_test {
namespace fs = std::filesystem;
using namespace isect::test;
using Catch::Matchers::StartsWith;
using isect::program::guards_in;

namespace {

std::string preset(const std::string& guard, const std::string& b_max = "4") {
  return R"({"lesson": "intervals", "preset": "touching", "parameters": {"b_max": )" + b_max + R"(}, "guard": )" +
         guard + "}";
}

const std::string four = R"([{"theme": "dark"}, {"size": "640x480"}, {"theme": "print", "format": "svg"},
                             {"theme": "print", "width": "80 mm", "format": "tikz"}])";

/// A folder with one preset that is guarded in four more looks.
class Guarded : public Shell {
 public:
  Guarded() {
    write(work() / "figs/a.json", preset(four));
    REQUIRE((*this)("isect check --dir figs --update=missing").status == 0);
  }
  fs::path file(const std::string& name) const { return work() / "figs/snapshots/intervals/a" / name; }
};

}  // namespace

TEST_CASE("the names of guarded looks follow from what is listed", "[guard]") {
  const auto name = [](const std::string& guard) {
    return guards_in("{\"guard\": [" + guard + "]}").at(0).file("03-foot");
  };
  CHECK(name(R"({"theme": "dark"})") == "03-foot.dark.png");
  CHECK(name(R"({"size": "640x480"})") == "03-foot.640x480.png");
  CHECK(name(R"({"size": "640x480", "theme": "dark"})") == "03-foot.dark-640x480.png");
  CHECK(name(R"({"format": "svg"})") == "03-foot.svg");
  CHECK(name(R"({"format": "tikz", "width": "80 mm", "theme": "grey"})") == "03-foot.grey-8cm.tikz");
  CHECK(name(R"({"format": "svg", "width": "8,5CM"})") == "03-foot.8.5cm.svg");
  CHECK(name(R"({"theme": "screen", "size": "320x200"})") == "03-foot.320x200.png");  // the theme is the usual one
  CHECK(guards_in(R"({"lesson": "intervals"})").empty());
  CHECK(guards_in(R"({"guard": []})").empty());
  CHECK(guards_in("no JSON").empty());
  CHECK(guards_in("{ // as in a scene\n\"guard\": [{\"theme\": \"dark\"}]}").size() == 1);
}

TEST_CASE("a look that can't be guarded is refused with its place", "[guard]") {
  const auto why = [](const std::string& list) { return refusal_of([&] { guards_in("{\"guard\": " + list + "}"); }); };
  CHECK_THAT(why("3"), StartsWith("guard: 3 is no list of looks"));
  CHECK_THAT(why(R"([{"theme": "dark"}, 3])"), StartsWith("guard 2: 3 is no look"));
  CHECK_THAT(why("[{}]"), StartsWith("guard 1: {} is no look"));
  CHECK_THAT(why(R"([{"theme": "drak"}])"), StartsWith("guard 1: ") && Contains("mean \"dark\""));
  CHECK_THAT(why(R"([{"them": "dark"}])"), StartsWith("guard 1: ") && Contains("mean \"theme\""));
  CHECK_THAT(why(R"([{"theme": 1}])"), StartsWith("guard 1: theme: 1 is no text"));
  CHECK_THAT(why(R"([{"size": "640"}])"), StartsWith("guard 1: size: "));
  CHECK_THAT(why(R"([{"format": "pdf"}])"), StartsWith("guard 1: format: \"pdf\" is unknown"));
  CHECK_THAT(why(R"([{"size": "640x480", "width": "8cm", "format": "svg"}])"), Contains("either size"));
  CHECK_THAT(why(R"([{"width": "8cm"}])"), StartsWith("guard 1: width: it is for svg and tikz"));
  CHECK_THAT(why(R"([{"width": "8 miles", "format": "svg"}])"), StartsWith("guard 1: width: "));
  CHECK_THAT(why(R"([{"theme": "screen", "size": "960x600"}])"), Contains("guarded anyway"));
  CHECK_THAT(why(R"([{"format": "svg", "width": "8cm"}, {"format": "svg", "width": "80mm"}])"),
             StartsWith("guard 2: ") && Contains("listed before"));
  std::string many = "[";
  for (int i = 0; i < 17; ++i) many += (i == 0 ? "" : ", ") + std::string(R"({"theme": "dark"})");
  CHECK_THAT(why(many + "]"), Contains("17 looks are listed, and 16 are the most"));
}

TEST_CASE("each step has a baseline of each look, beside that of the usual one", "[check][guard]") {
  const Guarded shell;
  const std::vector<std::string> files = files_in(shell.work() / "figs/snapshots/intervals/a");
  CHECK(files.size() == 1 + 5 * 5);
  for (const std::string name : {"04-relation.png", "04-relation.dark.png", "04-relation.640x480.png",
                                 "04-relation.print.svg", "04-relation.print-8cm.tikz", "trace.json"})
    CHECK(std::ranges::find(files, name) != files.end());
  CHECK_THAT(shell("isect check --dir figs").out, StartsWith("ok: 25 pictures of 1 preset\n"));
  CHECK(isect::viz::read_png(contents(shell.file("04-relation.640x480.png"))).width == 640);
  // The texts are those that render makes, but for what changes from version to version.
  REQUIRE(shell("isect render --preset figs/a.json --step 4 --format svg --theme print --out - >r.svg").status == 0);
  const std::string rendered = contents(shell.work() / "r.svg"), kept = contents(shell.file("04-relation.print.svg"));
  const auto paths = [](const std::string& svg) { return all_between(svg, " d=\""); };
  CHECK_FALSE(paths(kept).empty());
  CHECK(paths(rendered) == paths(kept));
  CHECK_THAT(kept, Contains("\"file\":\"intervals/a/04-relation.print\"") && !Contains("\"version\""));
}

TEST_CASE("a change of one look alone is told with that look, and a text with its line", "[check][guard]") {
  const Guarded shell;
  const std::string svg = contents(shell.file("04-relation.print.svg"));
  std::string other = svg;
  const std::size_t path = other.find(" d=\"M ") + 6;
  other[path] = other[path] == '1' ? '2' : '1';
  write(shell.file("04-relation.print.svg"), other);
  fs::copy_file(shell.file("02-a-beyond-b.dark.png"), shell.file("03-b-beyond-a.dark.png"),
                fs::copy_options::overwrite_existing);
  const Ran r = shell("isect check --dir figs");
  CHECK(r.status == 1);
  CHECK_THAT(r.out, Contains("FAILED intervals a, step 4 (relation), print.svg: text: line ") &&
                        Contains("figs/snapshots/intervals/a/04-relation.print.new.svg"));
  CHECK_THAT(r.out, Contains("a, step 3 (b-beyond-a), dark.png: "));
  CHECK(contents(shell.file("04-relation.print.new.svg")) == svg);
  const auto failures = nlohmann::json::parse(shell("isect check --dir figs --json --report r.html").out)["failures"];
  const auto text = std::ranges::find_if(failures, [](const auto& f) { return f["kind"] == "text"; });
  REQUIRE(text != failures.end());
  CHECK((*text)["look"] == "print.svg");
  CHECK((*text)["line"] == 1 + std::count(svg.begin(), svg.begin() + static_cast<std::ptrdiff_t>(path), '\n'));
  CHECK_THAT(contents(shell.work() / "r.html"),
             Contains("<img alt=\"New\" decoding=\"async\" src=\"data:image/svg+xml;"));

  CHECK(shell("isect check --dir figs --update").status == 0);
  CHECK(contents(shell.file("04-relation.print.svg")) == svg);
  CHECK_FALSE(fs::exists(shell.file("04-relation.print.new.svg")));
}

TEST_CASE("a change of the preset fails in all looks by one cause, and is accepted in all", "[check][guard]") {
  const Guarded shell;
  write(shell.work() / "figs/a.json", preset(four, "5"));
  const Ran r = shell("isect check --dir figs");
  CHECK(r.status == 1);
  CHECK_THAT(r.out, Contains("by cause:\n    25 pictures and 1 trace: parameter b_max was 4.0, is 5.0\n"));
  CHECK_THAT(r.out, Contains("a, step 4 (relation), 640x480.png: picture: ") &&
                        Contains("a, step 4 (relation), print-8cm.tikz: text: line "));
  CHECK(shell(accept_command(r.out)).status == 0);
  CHECK_THAT(shell("isect check --dir figs").out, StartsWith("ok: 25 pictures of 1 preset\n"));
}

TEST_CASE("baselines of a look that is no longer listed are left over, and of a new one missing", "[check][guard]") {
  const Guarded shell;
  write(shell.work() / "figs/a.json", preset(R"([{"theme": "grey"}, {"theme": "print", "format": "svg"}])"));
  const auto before = all_in(shell.work() / "figs/snapshots");
  const Ran r = shell("isect check --dir figs");
  CHECK(r.status == 1);
  CHECK_THAT(r.out, Contains("MISSING intervals a, step 4 (relation), grey.png: ") &&
                        Contains("04-relation.dark.png\n") && Contains("04-relation.print-8cm.tikz\n") &&
                        !Contains("04-relation.print.svg"));
  CHECK(all_in(shell.work() / "figs/snapshots") == before);
  CHECK(shell(accept_command(r.out)).status == 0);
  CHECK(files_in(shell.work() / "figs/snapshots/intervals/a").size() == 1 + 3 * 5);
  CHECK(shell("isect check --dir figs").status == 0);
}

TEST_CASE("a file of another's in the place of a guarded text stays", "[check][guard]") {
  const Guarded shell;
  for (const std::string name : {"04-relation.print.svg", "04-relation.print-8cm.tikz"}) {
    write(shell.file(name), "mine");
    const Ran r = shell("isect check --dir figs --update");
    CHECK(r.status == 1);
    CHECK_THAT(r.out, Contains("line 1 was “mine”") && Contains("was not made by isect"));
    CHECK(contents(shell.file(name)) == "mine");
    fs::remove(shell.file(name));
  }
}

TEST_CASE("scenes are guarded in further looks, and other commands take such files as before", "[check][guard]") {
  const Shell shell;
  write(shell.work() / "figs/s.json", R"({"objects": [{"sphere": "A", "center": [0, 0, 0], "radius": 1},
    {"point": "p", "at": [0.5, 0, 0]}], "ask": [["p", "A"]],  // and in the dark
    "guard": [{"theme": "dark", "size": "320x200"}]})");
  write(shell.work() / "figs/a.json", preset(R"([{"format": "svg"}])"));
  REQUIRE(shell("isect check --dir figs --update=missing").status == 0);
  CHECK(fs::exists(shell.work() / "figs/snapshots/scene/s/02-p-a.dark-320x200.png"));
  CHECK(shell("isect check --dir figs").status == 0);
  for (const std::string command :
       {"isect scene figs/s.json --json", "isect render figs/s.json --step 1 --out out",
        "isect render --preset figs/a.json --step 1 --out out", "isect explain --preset figs/a.json --step 1"}) {
    const Ran r = shell(command);
    INFO(command << r.err);
    CHECK(r.status == 0);
  }
}

TEST_CASE("a guard that is wrong makes its preset a broken one, and its baselines stay", "[check][guard]") {
  const Guarded shell;
  const auto before = all_in(shell.work() / "figs/snapshots");
  write(shell.work() / "figs/a.json", preset(R"([{"theme": "drak"}])"));
  const Ran r = shell("isect check --dir figs --update=all");
  CHECK(r.status == 2);
  CHECK_THAT(r.out, Contains("figs/a.json: guard 1: ") && Contains("mean \"dark\""));
  CHECK(all_in(shell.work() / "figs/snapshots") == before);
}

}  // namespace check_guard_test
