// The command line as a whole: help, version, wrong words, streams, and the programs of single lessons.

#include <fmt/format.h>

#include <cmath>

#include "tests/app/shell.h"
#include "tests/catch.h"

namespace usage_test {
using Catch::Matchers::StartsWith;
using isect::test::Contains;
using isect::test::Ran;
using isect::test::Shell;

TEST_CASE("help names every subcommand, an example and the exit statuses", "[program]") {
  const Shell shell;
  const Ran r = shell("isect --help");
  CHECK(r.status == 0);
  CHECK(r.err.empty());
  for (const char* word : {"list", "show", "explain", "render", "strip", "handout", "quiz", "deck", "scene", "lang",
                           "theme", "check", "query", "grade", "bench", "doctor", "Example:", "77"})
    CHECK_THAT(r.out, Contains(word));
}

TEST_CASE("each subcommand has help with an example", "[program]") {
  const Shell shell;
  for (const std::string sub : {"list", "show", "explain", "render", "handout", "quiz", "deck", "lang", "theme",
                                "check", "query", "grade", "bench", "doctor"}) {
    INFO(sub);
    const Ran r = shell("isect " + sub + " --help");
    CHECK(r.status == 0);
    CHECK_THAT(r.out, Contains("Usage: isect " + sub) && Contains("Example") && Contains("isect " + sub));
  }
}

TEST_CASE("the version is one line", "[program]") {
  const Shell shell;
  const Ran r = shell("isect --version");
  CHECK(r.status == 0);
  CHECK(r.out == "isect " ISECT_VERSION "\n");
}

TEST_CASE("an unknown subcommand or option is refused with the nearest", "[program]") {
  const Shell shell;
  const Ran sub = shell("isect rendr ray-sphere");
  CHECK(sub.status == 2);
  CHECK(sub.out.empty());
  CHECK_THAT(sub.err, StartsWith("isect: subcommand") && Contains("\"rendr\"") && Contains("mean \"render\"") &&
                          Contains("list, "));

  const Ran option = shell("isect render ray-sphere --frmat png");
  CHECK(option.status == 2);
  CHECK_THAT(option.err, Contains("option") && Contains("mean \"--format\""));
  CHECK(shell("isect render ray-sphere --step").status == 2);
  CHECK(shell("isect --vresion").status == 2);
}

TEST_CASE("a closed or full standard output is a file that can't be written", "[program]") {
  const Shell shell;
  const Ran closed = shell("isect list >&-");
  CHECK(closed.status == 4);
  CHECK_THAT(closed.err, Contains("standard output"));
  CHECK(shell("isect list >/dev/full").status == 4);
  // With stdout closed, no file that is opened may take its place.
  CHECK(shell("isect render ray-sphere --step 1 --format svg --out f >&- 2>&-").status == 4);
  CHECK_THAT(isect::test::contents(shell.work() / "f/ray-sphere/two-roots/01-to-center.svg"), StartsWith("<?xml"));
}

TEST_CASE("there is no colour and no progress in a pipe", "[program]") {
  const Shell shell;
  const Ran r = shell("TERM=xterm isect list && isect render ray-sphere --format svg");
  CHECK_THAT(r.out, !Contains("\x1b"));
  CHECK(r.err.empty());
}

TEST_CASE("colours are for terminals, and not with NO_COLOR", "[program]") {
  const Shell shell;
  const auto in_terminal = [&](const std::string& settings) {
    return shell(settings + " script -qec 'isect list' /dev/null").out;
  };
  CHECK_THAT(in_terminal("TERM=xterm"), Contains("relations") && Contains("\x1b[1m"));
  CHECK_THAT(in_terminal("TERM=xterm NO_COLOR=1"), Contains("relations") && !Contains("\x1b"));
  CHECK_THAT(in_terminal("TERM=dumb"), Contains("relations") && !Contains("\x1b"));
}

TEST_CASE("a scene whose answers take long is said to be decided, where somebody looks, and ends when told",
          "[program]") {
  const Shell shell;
  std::string objects;  // 319,600 pairs of hulls of 40 points: minutes
  for (int i = 0; i < 800; ++i) {
    std::string points;
    for (int k = 0; k < 40; ++k)
      points += fmt::format("{}[{}, {}, {}]", k == 0 ? "" : ", ", 7 * i % 31 + 3 * std::cos(k + i),
                            5 * i % 23 + 3 * std::sin(2 * k + i), 3 * std::cos(3 * k - i));
    objects += fmt::format("{}{{\"hull\": \"h{}\", \"points\": [{}]}}", i == 0 ? "" : ",\n", i, points);
  }
  isect::test::write(shell.work() / "hulls.json", "{\"objects\": [" + objects + "], \"ask\": \"all pairs\"}");
  for (const std::string command : {"isect scene hulls.json", "isect show hulls.json"}) {
    INFO(command);
    const Ran seen = shell("script -qec 'timeout 10 " + command + "' /dev/null");
    CHECK_THAT(seen.out, Contains("hulls.json: what it asks is being decided"));
    const Ran piped = shell("timeout 3 " + command);
    CHECK(piped.status == 124);  // ended by SIGTERM
    CHECK(piped.err.empty());
  }
}

TEST_CASE("without a display the window says what to do instead", "[program]") {
  const Shell shell;
  for (const std::string command : {"isect", "isect show", "isect show ray-sphere --step 3", "ray-sphere"}) {
    INFO(command);
    const Ran r = shell(command);
    CHECK(r.status == 77);
    CHECK(r.out.empty());
    CHECK_THAT(r.err, Contains("display") && Contains("render"));
  }
}

TEST_CASE("a lesson is also a program of its own", "[program]") {
  const Shell shell;
  const Ran help = shell("ray-sphere --help");
  CHECK(help.status == 0);
  CHECK_THAT(help.out, Contains("ray-sphere") && Contains("render") && !Contains("doctor"));
  CHECK_THAT(shell("ray-sphere render --help").out, Contains("Usage: ray-sphere render") && !Contains("LESSON"));

  CHECK(shell("ray-sphere explain --step 2").out == shell("isect explain ray-sphere --step 2").out);
  CHECK(shell("ray-sphere render --step 2 --format svg --out -").out ==
        shell("isect render ray-sphere --step 2 --format svg --out -").out);
  const Ran check = shell("ray-sphere check --preset miss");
  CHECK(check.status == 3);
  CHECK_THAT(check.out, Contains("ray-sphere check --preset miss --update=missing"));
  CHECK_THAT(shell("ray-sphere --preset mis").err, Contains("mean \"miss\""));
}

TEST_CASE("a file or folder with an empty name is refused", "[usage]") {
  const Shell shell;
  const std::vector<std::pair<std::string, std::vector<std::string>>> options = {
      {"render ray-sphere --step 1", {"--out", "--preset"}},
      {"check ray-sphere", {"--dir", "--snapshots", "--report", "--junit", "--preset", "--accept"}},
      {"bench orient2d", {"--csv", "--json", "--plot", "--from", "--publish"}}};
  for (const auto& [command, names] : options)
    for (const std::string& name : names)
      for (const std::string empty : {" \"$UNSET\"", "=\"$UNSET\""}) {
        INFO(command << " " << name << empty);
        const Ran r = shell("isect " + command + " " + name + empty);
        CHECK(r.status == 2);
        CHECK_THAT(r.err, Contains(name));
        if (empty[0] == ' ') CHECK_THAT(r.err, Contains(name + ": empty"));
      }
  CHECK(shell("isect query \"\"").status == 2);
  CHECK(std::filesystem::is_empty(shell.work()));
}

}  // namespace usage_test
