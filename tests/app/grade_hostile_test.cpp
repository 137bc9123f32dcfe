// `isect grade` judges programs: right ones, wrong ones, and those that would harm it.

#include <unistd.h>

#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "tests/app/shell.h"
#include "tests/catch.h"

namespace grade_hostile_test {
using isect::test::Contains;
using isect::test::Ran;
using isect::test::Shell;
using Json = nlohmann::json;

namespace {

/// A folder with a program in sh, and the way it is judged.
class Judged {
 public:
  explicit Judged(const std::string& program, const std::string& options = "--seconds 2") : options_(options) {
    isect::test::write(shell_.work() / "program", "#!/bin/sh\n" + program);
    shell_("chmod +x program");
  }
  Ran words() const {
    return shell_("isect grade aabb --plain --no-speed --no-reduce --count 4 " + options_ + " ./program");
  }
  Json json() const {
    const Ran ran =
        shell_("isect grade aabb --plain --no-speed --no-reduce --count 4 --json " + options_ + " ./program");
    INFO(ran.err);
    Json all = Json::parse(ran.out);
    CHECK(ran.status == (all["passes"] == true ? 0 : 1));
    return all;
  }
  const Shell& shell() const { return shell_; }

 private:
  Shell shell_;
  std::string options_;
};

void skipped(const std::string& why) { std::cout << "skipped: " << why << '\n'; }

const std::string says_one = "while read -r line; do echo 1; done\n";

}  // namespace

TEST_CASE("a right program gets full marks, and its speed", "[grade]") {
  const Shell shell;
  isect::test::write(
      shell.work() / "boxes.awk",
      "{ yes = 1; for (i = 1; i <= 3; ++i) if ($i > $(9 + i) || $(6 + i) > $(3 + i)) yes = 0; print yes }");
  const Ran ran = shell("isect grade aabb --plain awk -f boxes.awk");
  INFO(ran.out << ran.err);
  CHECK(ran.status == 0);
  CHECK_THAT(ran.out, Contains("aabb: 440 of 440 right") && Contains("touching faces: all 40 right") &&
                          Contains("cases a second"));
}

TEST_CASE("the true answers get full marks in every task, also by the note's convention", "[grade]") {
  const Shell shell;
  for (const std::string task : {"ray-sphere", "crossings", "hull", "clip-segment", "all-pairs", "closest-hit",
                                 "sphere-sphere --convention note"}) {
    INFO(task);
    shell("isect grade " + task + " --answers --count 2 >right");
    const Ran ran = shell("isect grade " + task +
                          " --count 2 --no-speed --no-reduce sh -c 'read -r x; cat \"$0\"; cat >/dev/null' right");
    INFO(ran.out << ran.err);
    CHECK(ran.status == 0);
  }
  CHECK(shell("isect grade sphere-sphere --no-speed --no-reduce sh -c 'read -r x; cat \"$0\"; cat >/dev/null' right")
            .status == 1);
}

TEST_CASE("a wrong program is told its faults by family", "[grade]") {
  const Judged judged(says_one);
  const Ran ran = judged.words();
  CHECK(ran.status == 1);
  CHECK_THAT(ran.out, Contains("aabb: 2") && Contains("touching faces: all 4 right") &&
                          Contains("a gap along one axis: 4 of 4 wrong, each a false yes") &&
                          Contains("| isect query"));
  const Json all = judged.json();
  CHECK(all["end"]["how"] == "exited");
  CHECK(all["first"].size() == 1);
  CHECK(all["first"][0]["case"]["kind"] == "box_box");
  CHECK(judged.json()["families"] == all["families"]);
}

TEST_CASE("a wrong program is told its mistake and the simplest case on which it is wrong", "[grade]") {
  const Shell shell;
  isect::test::write(
      shell.work() / "boxes.awk",
      "{ yes = 1; for (i = 1; i <= 3; ++i) if ($i >= $(9 + i) || $(6 + i) >= $(3 + i)) yes = 0; print yes }");
  const Ran ran = shell("isect grade aabb --plain --no-speed --json awk -f boxes.awk");
  CHECK(ran.status == 1);
  const Json all = Json::parse(ran.out);
  REQUIRE(all["mistakes"].size() == 1);
  CHECK_THAT(all["mistakes"][0]["mistake"].get<std::string>(), Contains("< for <="));
  CHECK(all["mistakes"][0]["same"] == all["cases"]);
  REQUIRE(all["first"].size() == 1);
  const Json simplest = all["first"][0]["simplest"];
  for (const char* corner : {"alo", "ahi", "blo", "bhi"})
    for (const Json& x : simplest[corner]) CHECK(x.get<double>() == std::round(x.get<double>()));
  isect::test::write(shell.work() / "case", simplest.dump() + "\n");
  CHECK(Json::parse(shell("isect query case").out)["result"]["relation"] == "touch");
}

TEST_CASE("a crash, a failure and a program that ends too soon are told apart", "[grade]") {
  CHECK_THAT(Judged("read -r x; echo 1; kill -SEGV $$\n").words().out,
             Contains("The program crashed: SIGSEGV") && Contains("after 1 of 44 answers"));
  CHECK_THAT(Judged(says_one + "echo why >&2; exit 3\n").words().out,
             Contains("exit status 3 after 44 of 44 answers") && Contains("It wrote to stderr: why"));
  CHECK_THAT(Judged("exit 0\n").words().out, Contains("The program ended after 0 of 44 answers."));
  CHECK_THAT(Judged(says_one + "echo 1\n").words().out, Contains("45 lines for 44 cases"));
}

TEST_CASE("a program that hangs, with work or without, is ended", "[grade]") {
  for (const char* program : {"sleep 100\n", "while :; do :; done\n", "trap '' TERM HUP INT; sleep 100; sleep 100\n"}) {
    INFO(program);
    CHECK(Judged(program, "--seconds 0.5").json()["end"]["how"] == "too slow");
  }
}

TEST_CASE("endless output is cut off", "[grade]") {
  CHECK(Judged("read -r x; exec yes 1\n").json()["end"]["how"] == "too much output");
  CHECK(Judged("read -r x; exec tr '\\0' x </dev/zero\n").json()["end"]["how"] == "too much output");
  const Json all = Judged("yes >&2 & " + says_one + "kill $!\n").json();
  CHECK(all["end"]["stderr"].get<std::string>().size() <= 403);
}

TEST_CASE("a fork bomb is contained", "[grade]") {
  // without namespaces of processes the system limits no processes of root: a bomb might disturb others
  if (::geteuid() == 0 && Judged("exit 0\n").json()["contained"]["sees_others"] == true)
    return skipped("there is no process namespace");
  const Judged judged("read -r x; b() { b | b & b; }; b\n", "--seconds 3 --processes 16");
  const std::string how = judged.json()["end"]["how"];
  INFO(how);
  CHECK((how == "too many processes" || how == "exited" || how == "too slow"));  // or fork failed
  CHECK_THAT(judged.shell()("ps ax -o args | grep -c \"[p]rogram'*$\" || true").out, !Contains("1"));
}

TEST_CASE("a child does not outlive its program", "[grade]") {
  const std::string name = "1234.567";
  const Judged judged("for i in 1 2 3; do setsid sh -c \"trap '' TERM HUP; sleep " + name + "\" & done\n" + says_one);
  CHECK(judged.json()["answers"] == 44);
  CHECK_THAT(judged.shell()("ps ax -o args").out, !Contains("sleep " + name));
}

TEST_CASE("a program's bytes reach no terminal and no page", "[grade]") {
  const Judged judged("while read -r x; do printf '\\033]0;t\\007<script>\\n'; printf '\\033[2J<b>' >&2; done\n");
  for (const std::string& text : {judged.words().out, judged.json().dump()}) {
    CHECK_THAT(text, !Contains("\033") && !Contains("<script>") && !Contains("<b>"));
    CHECK_THAT(text, Contains("x1b]0;t"));
  }
  CHECK(judged.json()["families"][0]["unreadable"] == 4);
}

TEST_CASE("answers before any input do not count", "[grade]") {
  const Judged judged("for i in 1 2 3 4 5 6 7 8 9; do echo 1; done; cat >/dev/null\n");
  const Json all = judged.json();
  CHECK(all["end"]["before_input"] == true);
  CHECK(all["answers"] == 0);
  CHECK_THAT(judged.words().out, Contains("before there was any input"));
}

TEST_CASE("the true answers, isect and other processes are out of a program's reach", "[grade]") {
  const std::string look =
      "{ ls -A; echo \"of env: $(env | wc -l)\"; isect --version; cat /proc/[0-9]*/environ; } >&2\n";
  const Judged judged("read -r x\n" + look + "echo 1\n" + says_one);
  judged.shell()("touch secret");
  const Json all = judged.json();
  const std::string told = all["end"]["stderr"];
  INFO(told);
  CHECK_THAT(told, !Contains("secret") && !Contains("ISECT"));
  if (all["contained"]["sees_others"] == true) return skipped("there is no process namespace");
  CHECK_THAT(told, !Contains("isect 1."));
}

TEST_CASE("a program writes into its own folder only, which is gone afterwards", "[grade]") {
  const Judged judged(
      "read -r x; cd \"$(dirname \"$0\")\" && echo stolen >here; echo 1; cd \"$HOME\"; mkdir -p a/b; "
      "echo >a/b/c; chmod 0 a/b; pwd >&2\n" +
      says_one);
  const Json all = judged.json();
  CHECK(all["answers"] == 44);
  std::string folder = all["end"]["stderr"].get<std::string>();
  folder = folder.substr(folder.rfind("/isect-grade-"), 19);
  CHECK_FALSE(std::filesystem::exists(std::filesystem::temp_directory_path() / folder.substr(1)));
  if (all["contained"]["writes_elsewhere"] == false)
    CHECK_FALSE(std::filesystem::exists(judged.shell().work() / "here"));
}

TEST_CASE("memory and files have limits", "[grade]") {
  CHECK_THAT(Judged("read -r x; yes >big; echo \"$(wc -c <big)\" >&2\n").json()["end"]["stderr"].get<std::string>(),
             Contains("16777216") || Contains("limit"));
  const Shell shell;
  if (shell("python3 --version").status != 0) return skipped("there is no python3");
  isect::test::write(shell.work() / "much.py", "input()\nx = bytearray(3 << 30)\n");
  CHECK_THAT(shell("isect grade aabb --plain --no-speed --no-reduce --count 1 --memory 1024 python3 much.py").out,
             Contains("MemoryError"));
}

}  // namespace grade_hostile_test
