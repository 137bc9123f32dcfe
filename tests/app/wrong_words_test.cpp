// Sixty command lines that are wrong: each is refused in our words, which name the option or field, what was given and
// what is allowed, with exit status 2 and nothing on stdout.

#include "tests/app/shell.h"
#include "tests/catch.h"

namespace wrong_words_test {
using isect::test::Contains;
using isect::test::Ran;
using isect::test::Shell;

TEST_CASE("a wrong command line is refused in our own words", "[program]") {
  const Shell shell;
  struct Wrong {
    const char *line, *field, *hint;
  };
  const std::initializer_list<Wrong> all = {
      // Subcommands and the program itself.
      {"rendr ray-sphere", "subcommand: \"rendr\"", "mean \"render\""},
      {"Render ray-sphere", "subcommand: \"Render\"", "mean \"render\""},
      {"chek", "subcommand: \"chek\"", "mean \"check\""},
      {"--vresion", "option: \"--vresion\"", "mean \"--version\""},
      {"--prset tangent", "option: \"--prset\"", "mean \"--preset\""},
      {"\"\"", "subcommand", "list, "},
      // Options nobody knows.
      {"render ray-sphere --frmat png", "option: \"--frmat\"", "mean \"--format\""},
      {"render ray-sphere --frmat=png", "option: \"--frmat\"", "mean \"--format\""},
      {"render ray-sphere -step 3", "option: \"-step\"", "mean \"--step\""},
      {"render ray-sphere -x", "option: \"-x\"", "llowed: "},
      {"explain ray-sphere --stp 3", "option: \"--stp\"", "mean \"--step\""},
      {"quiz ray-sphere --answers", "option: \"--answers\"", "llowed: "},
      {"list --jsn", "option: \"--jsn\"", "mean \"--json\""},
      {"check --updat", "option: \"--updat\"", "mean \"--update\""},
      {"query --file x", "option: \"--file\"", "llowed: "},
      {"doctor --all", "option: \"--all\"", "llowed: "},
      {"bench --quik", "option: \"--quik\"", "mean \"--quick\""},
      {"show --set=radius=2 --stp 3", "option: \"--stp\"", "mean \"--step\""},
      // Values that are missing.
      {"render ray-sphere --step", "--step: no value is given", "write --step N|A-B|NAME|all"},
      {"render ray-sphere --out", "--out: no value is given", "write --out DIR|-"},
      {"render ray-sphere --out --step 1", "--out: no value is given", "write --out DIR|-"},
      {"render --out= ray-sphere", "--out: no value is given", "write --out DIR|-"},
      {"render ray-sphere --preset", "--preset: no value is given", "NAME|FILE"},
      {"render ray-sphere --set", "--set: no value is given", "NAME=VALUE"},
      {"explain ray-sphere --preset", "--preset: no value is given", "NAME|FILE"},
      {"show ray-sphere --step", "--step: no value is given", "write --step N"},
      {"check --report", "--report: no value is given", "FILE.html"},
      {"check --dir", "--dir: no value is given", "DIR"},
      {"book --playlist", "--playlist: no value is given", "write --playlist FILE"},
      {"bench --seed", "--seed: no value is given", "write --seed N"},
      {"bench --csv --quick", "--csv: no value is given", "write --csv FILE"},
      // Values that are one too many.
      {"render ray-sphere --out a --out b", "--out: given 2 times (\"a\", \"b\")", "give it once"},
      {"render ray-sphere --theme print --theme=grey", "--theme: given 2 times", "give it once"},
      {"render ray-sphere --step 1 --step 2 --step 3", "--step: given 3 times", "give it once"},
      {"explain ray-sphere --preset miss --preset tangent", "--preset: given 2 times", "give it once"},
      {"bench --seed 1 --seed 2", "--seed: given 2 times", "give it once"},
      {"list --json=yes", "--json: \"yes\"", "takes none"},
      {"render --all=ray-sphere", "--all: \"ray-sphere\"", "takes none"},
      {"check --json=", "--json: \"\"", "takes none"},
      {"list ray-sphere rays", "list: \"rays\" is one argument too many", "list --help"},
      {"explain ray-sphere rays", "explain: \"rays\" is one argument too many", "explain --help"},
      // The name of another subcommand, where a lesson is meant.
      {"render list", "lesson: \"list\"", "llowed: "},
      {"render ray-sphere scene --preset x.json", "lesson: \"scene\"", "llowed: "},
      {"explain query", "lesson: \"query\"", "llowed: "},
      {"show ray-sphere rays", "show: \"rays\" is one argument too many", "show --help"},
      {"query a.jsonl b.jsonl", "query: \"b.jsonl\" is one argument too many", "query --help"},
      {"doctor now", "doctor: \"now\" is one argument too many", "doctor --help"},
      // Options that exclude each other.
      {"check --dir a --snapshots b", "--dir", "not both"},
      {"render ray-sphere --all", "lesson: give either names or --all", "not both"},
      {"render ray-sphere --format svg --width 8cm --size 100x100", "size: give either", "not both"},
      {"bench --peers --native", "--peers", "not both"},
      {"bench --from rows.json --quick", "--from", "not both"},
      {"theme print --json --out s.png", "--out: give either --out or --json", "not both"},
      // Values of the wrong kind.
      {"bench --seed abc", "--seed: \"abc\"", "whole number"},
      {"bench --seed 1.5", "--seed: \"1.5\"", "whole number"},
      {"bench --seed=-1", "--seed: \"-1\"", "whole number"},
      {"render ray-sphere --step one", "step: \"one\"", "1 to 13"},
      {"render ray-sphere --step -99", "step: \"-99\"", "1 to 13"},
      {"render ray-sphere --size 960", "size: \"960\"", "960x600"},
      {"render ray-sphere --format svg --width 8", "width: \"8\"", "cm, mm, pt, in"},
      {"render ray-sphere --theme \"\"", "--theme: empty", "write --theme THEME"},
      {"render ray-sphere --out \"\"", "--out: empty", "write --out DIR|-"},
      {"render ray-sphere --format svgz", "format: \"svgz\"", "mean \"svg\""},
      {"render ray-sphere --backend gpu", "\"gpu\"", "osmesa"},
      {"check ray-sphere --update=fialed", "update: \"fialed\"", "mean \"failed\""},
      {"render ray-sphere --set radius", "set: \"radius\" has no '='", "name=value"},
      {"render ray-sphere --set radius=1 center=0,0,0", "lesson: \"center=0,0,0\"", "--set center=0,0,0"},
      {"render ray-sphere --set radius 2", "set: \"radius\" has no '='", "name=value"},
      {"render ray-sphere --format latex", "format: \"latex\"", "mean \"tikz\""},
      {"render ray-sphere --format jpg", "format: \"jpg\"", "mean \"png\""},
      {"render ray-sphere --theme greyscale", "theme: \"greyscale\"", "mean \"grey\""},
      {"render ray-sphere --set radius=big", "radius: \"big\"", "a number from 0"},
      {"theme", "theme: none given", "one of screen, print"},
      {"theme prnt", "theme: \"prnt\"", "mean \"print\""},
      {"theme print --out swatch", "out: \"swatch\"", "png, svg"},
      {"theme print dark", "theme: \"dark\" is one argument too many", "theme --help"},
      // Names nobody knows.
      {"render ray-spere", "lesson: \"ray-spere\"", "mean \"ray-sphere\""},
      {"list ray-spere", "lesson: \"ray-spere\"", "mean \"ray-sphere\""},
      {"explain", "lesson: none given", "ray-sphere"},
      {"quiz", "lesson: none given", "ray-sphere"},
      {"quiz ray-spere", "lesson: \"ray-spere\"", "mean \"ray-sphere\""},
      {"explain ray-sphere --preset all", "preset: \"all\"", "name one"},
      {"show ray-sphere --preset tangnt", "preset: \"tangnt\"", "mean \"tangent\""},
      {"check ray-sphere --preset tangnt", "preset: \"tangnt\"", "mean \"tangent\""},
      {"bench ray-spere", "\"ray-spere\"", "mean \"ray-sphere\""},
  };
  CHECK(all.size() >= 60);
  for (const Wrong& w : all) {
    INFO("isect " << w.line);
    const Ran r = shell(std::string("isect ") + w.line);
    CHECK(r.status == 2);
    CHECK(r.out.empty());
    CHECK_THAT(r.err, Catch::Matchers::StartsWith("isect: ") && Contains(w.field) && Contains(w.hint));
    for (const char* raw : {"required", "requires", "Could not convert", "excludes", "not expected", "At Most"})
      CHECK_THAT(r.err, !Contains(raw));
    CHECK(std::count(r.err.begin(), r.err.end(), '\n') == 1);
  }
}

TEST_CASE("a file or a folder in the place of a name is told as one, with what takes it", "[program]") {
  const Shell shell;
  isect::test::write(shell.work() / "in/mine.json", R"({"objects": [{"point": "p", "at": [0, 0]}]})");
  const auto refused = [&](const std::string& words) {
    const Ran r = shell("isect " + words);
    CHECK(r.status == 2);
    return r.err;
  };
  CHECK_THAT(refused("in/mine.json"), Contains("isect show in/mine.json") && Contains("isect scene in/mine.json"));
  CHECK_THAT(refused("list in/mine.json"), Contains("isect explain in/mine.json"));
  CHECK_THAT(refused("check in/mine.json"), Contains("check --dir"));
  const Ran folder = shell("isect render ./in");
  CHECK(folder.status == 4);
  CHECK_THAT(folder.err, Contains("render --dir ./in"));
  CHECK_THAT(refused("render ray-sphere --step 3 --font \"DejaVu San\""), Contains("mean \"DejaVu Sans\"? `fc-list"));
}

TEST_CASE("a name is offered only where it is near", "[program]") {
  const Shell shell;
  for (const char* line : {"render list", "render ray-sphere --theme purple", "explain query", "doctor --all",
                           "render ray-sphere --set weight=3", "bench everything"}) {
    INFO("isect " << line);
    CHECK_THAT(shell(std::string("isect ") + line).err, Contains("llowed: ") && !Contains("did you mean"));
  }
}

}  // namespace wrong_words_test
