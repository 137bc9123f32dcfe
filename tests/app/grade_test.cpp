// `isect grade`: the tasks and their pages, the cases, the starters, and what is said of a program's answers.

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "app/grade/mistakes.h"
#include "app/grade/page.h"
#include "app/grade/starters.h"
#include "app/query/query.h"
#include "lessons/lessons.h"
#include "tests/app/shell.h"
#include "tests/catch.h"
#include "viz/player/reader_state.h"

namespace grade_test {
using isect::test::Contains;
using isect::test::Ran;
using isect::test::Shell;
using Json = nlohmann::json;
namespace grade = isect::grade;

namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string fault(const std::string& task, const grade::Truth& truth, const std::string& line) {
  const grade::Mark mark = grade::marked(grade::task_named(task), truth, line);
  return mark.readable ? mark.fault : "unreadable";
}

}  // namespace

TEST_CASE("every task has a page, a lesson, families and cases to which the core has an answer", "[grade]") {
  CHECK(grade::tasks().size() == 17);
  std::set<std::string> ids;
  for (const grade::Task& task : grade::tasks()) {
    INFO(task.id);
    CHECK(ids.insert(task.id).second);
    CHECK_NOTHROW(isect::viz::lesson_named(isect::lessons::all_lessons(), task.lesson));
    const std::string page = grade::text_page(task, 80), md = grade::markdown_page(task);
    for (const grade::Field& field : task.fields) {
      CHECK_THAT(page, Contains(field.name + ": " + field.what.substr(0, 12)));
      CHECK_THAT(md, Contains("| `" + field.name + "` |"));
    }
    const std::vector<grade::Family> families = grade::families(task);
    REQUIRE(families.size() >= 9);
    CHECK(families[0].name == "ordinary");
    std::set<std::string> names;
    for (const grade::Family& family : families) {
      CHECK(names.insert(family.name).second);
      CHECK_THAT(page, Contains(family.name + ": "));
    }
    const std::vector<grade::Case> cases = grade::cases(task, 1, 2);
    CHECK(cases.size() == 2 * families.size());
    for (const grade::Case& one : cases) {
      for (const double x : one.numbers) CHECK(std::abs(x) <= grade::largest);
      const auto truth = grade::truth(task, one.numbers);
      REQUIRE(truth);
      CHECK(grade::marked(task, *truth, grade::answer_line(task, *truth)).fault.empty());
      if (task.kind.empty()) continue;
      CHECK_FALSE(isect::query::answer(grade::json_line(task, one.numbers), 0, task.id != "ray-triangle").error);
    }
  }
}

TEST_CASE("a seed gives the same cases again, and another one gives others", "[grade]") {
  const grade::Task& task = grade::task_named("ray-triangle");
  const auto lines = [&](std::uint64_t seed) {
    std::string all;
    for (const grade::Case& one : grade::cases(task, seed, 3)) all += grade::plain_line(one.numbers) + '\n';
    return all;
  };
  CHECK(lines(1) == lines(1));
  CHECK(lines(1) != lines(2));
}

TEST_CASE("families are what their names say", "[grade]") {
  const auto yes_of = [](const char* task, const std::string& family) {
    int yes = 0, all = 0;
    for (const grade::Case& one : grade::cases(grade::task_named(task), 5, 20))
      if (one.family == family) ++all, yes += grade::truth(grade::task_named(task), one.numbers)->yes;
    REQUIRE(all == 20);
    return yes;
  };
  CHECK(yes_of("aabb", "touching faces") == 20);
  CHECK(yes_of("aabb", "a gap along one axis") == 0);
  CHECK(yes_of("sphere-sphere", "touching") == 20);
  CHECK(yes_of("sphere-aabb", "touching") == 20);
  CHECK(yes_of("ray-sphere", "tangent") == 20);
  CHECK(yes_of("ray-sphere", "behind") == 0);
  CHECK(yes_of("ray-aabb", "through a corner") == 20);
  CHECK(yes_of("ray-triangle", "behind") == 0);
  for (const char* task : {"aabb", "sphere-sphere", "sphere-aabb", "obb-obb", "interval"})
    CHECK(yes_of(task, "ordinary") == 10);  // yes and no take turns
}

TEST_CASE("plain numbers are read as the same numbers, in the order of the query", "[grade]") {
  const grade::Task& task = grade::task_named("obb-obb");
  for (const grade::Case& one : grade::cases(task, 3, 2)) {
    std::istringstream in(grade::plain_line(one.numbers));
    std::vector<double> read;
    for (std::string word; in >> word;) read.push_back(std::strtod(word.c_str(), nullptr));
    CHECK(read == one.numbers);
    const Json line = Json::parse(grade::json_line(task, one.numbers, 4));
    CHECK(line["id"] == 4);
    CHECK(line["b"]["u"][2][1].get<double>() == one.numbers[15 + 3 + 7]);
  }
  const grade::Numbers polygon = {3, 0, 0, 4, 0, 0, 4, 1, 1};
  CHECK(grade::json_line(grade::task_named("crossings"), polygon) ==
        R"({"kind":"pip","rings":[[[0.0,0.0],[4.0,0.0],[0.0,4.0]]],"point":[1.0,1.0]})");
}

TEST_CASE("the note's spheres do not touch", "[grade]") {
  const grade::Task& balls = grade::task_named("sphere-sphere");
  const auto both = [&](const grade::Task& task, const grade::Numbers& x) {
    return std::pair(grade::truth(task, x)->yes, grade::truth(task, x, grade::Convention::note)->yes);
  };
  CHECK(both(balls, {0, 0, 0, 2, 3, 0, 0, 1}) == std::pair(true, false));
  CHECK(both(balls, {0, 0, 0, 2, 2, 0, 0, 0}) == std::pair(true, false));
  CHECK(both(balls, {0, 0, 0, 2, 1, 0, 0, 1}) == std::pair(true, true));
  CHECK(both(balls, {0, 0, 0, 0, 0, 0, 0, 0}) == std::pair(true, false));
  CHECK(both(grade::task_named("sphere-aabb"), {2, 0, 0, 1, -1, -1, -1, 1, 1, 1}) == std::pair(true, false));
  CHECK(both(grade::task_named("aabb"), {0, 0, 0, 1, 1, 1, 1, 0, 0, 2, 1, 1}) == std::pair(true, true));
}

TEST_CASE("answers are held against the truth, and a fault has a name", "[grade]") {
  const grade::Truth yes = {true}, no = {false};
  CHECK(fault("aabb", yes, "1").empty());
  CHECK(fault("aabb", yes, " True\r").empty());
  CHECK(fault("aabb", yes, "no") == "false no");
  CHECK(fault("aabb", no, "1") == "false yes");
  for (const char* bad : {"", "2", "1 1", "yes please", "nan"}) CHECK(fault("aabb", yes, bad) == "unreadable");
  const grade::Truth t = {true, "", {5}};
  CHECK(fault("ray-aabb", t, "5").empty());
  CHECK(fault("ray-aabb", t, "5.00000000000001").empty());  // 11 ulps
  CHECK(fault("ray-aabb", t, "5.000001") == "wrong value");
  CHECK(fault("ray-aabb", t, "inf") == "wrong value");
  CHECK(fault("ray-aabb", t, "nan") == "wrong value");
  CHECK(fault("ray-aabb", t, "Miss") == "false miss");
  CHECK(fault("ray-aabb", no, "5") == "false hit");
  CHECK(fault("ray-aabb", no, "miss").empty());
  CHECK(fault("ray-aabb", t, "5 5") == "unreadable");
  CHECK(fault("crossings", {true, "on"}, "in") == "in for on");
  CHECK(fault("crossings", {true, "on"}, "on").empty());
  const grade::Truth triangle = {true, "", {0, 0, 1, 0, 0, 1}};
  CHECK(fault("hull", triangle, "3 1 0 0 1 0 0").empty());  // from another corner on
  CHECK(fault("hull", triangle, "3 0 0 0 1 1 0") == "other corners, or another order");
  CHECK(fault("hull", triangle, "2 0 0 1 0") == "too few corners");
  CHECK(fault("hull", triangle, "3 0 0 1 0") == "unreadable");
  const grade::Truth pairs = {true, "", {0, 1, 1, 2}};
  CHECK(fault("all-pairs", pairs, "2 2 1 1 0").empty());
  CHECK(fault("all-pairs", pairs, "1 0 1") == "missing pairs");
  CHECK(fault("all-pairs", pairs, "3 0 1 1 2 0 2") == "pairs too many");
  CHECK(fault("all-pairs", pairs, "4 0 1 1 2 0 1 1 2") == "pairs too many");
  const grade::Truth nearest = {true, "", {NAN, 3, 2, 2}};
  CHECK(fault("closest-hit", nearest, "2 2").empty());
  CHECK(fault("closest-hit", nearest, "3 2").empty());
  CHECK(fault("closest-hit", nearest, "1 3") == "wrong sphere");
  CHECK(fault("closest-hit", nearest, "0 2") == "wrong sphere");
  CHECK(fault("closest-hit", nearest, "2 4") == "wrong value");
  CHECK(fault("closest-hit", nearest, "7 2") == "unreadable");
  CHECK(fault("clip-segment", {true, "", {0, 0.5}}, "0 0.5").empty());
  CHECK(fault("clip-segment", {true, "", {0, 0.5}}, "0.5 0") == "wrong value");
}

TEST_CASE("ulps are those of the true value, or of 1", "[grade]") {
  const double next = std::nextafter(8.0, 9.0);
  CHECK(grade::ulps_off(next, 8) == 1);
  CHECK(grade::ulps_off(8, 8) == 0);
  CHECK(grade::ulps_off(0x1p-52, 0) == 1);
  CHECK(std::isinf(grade::ulps_off(NAN, 1)));
  CHECK(grade::ulps_off(1e300, -1e300) > 1e15);
}

TEST_CASE("a program's text is harmless when it is shown", "[grade]") {
  CHECK(grade::harmless("\033[31m<b>&\\\xe2\x80\xae") == "\\x1b[31m\\x3cb\\x3e\\x26\\x5c\\xe2\\x80\\xae");
  CHECK(grade::harmless(std::string(1000, 'x')).size() == 63);
}

TEST_CASE("a program that makes a mistake is told its name, and a right one none", "[grade]") {
  std::set<std::string> with_mistakes;
  for (const grade::Mistake& mistake : grade::mistakes()) {
    INFO(mistake.task << ": " << mistake.name);
    const grade::Task& task = grade::task_named(mistake.task);
    with_mistakes.insert(mistake.task);
    const std::vector<grade::Case> cases = grade::cases(task, 3, 20);
    std::vector<std::string> said, true_lines;
    std::vector<bool> right;
    for (const grade::Case& one : cases) {
      const grade::Truth truth = grade::truth(task, one.numbers).value();
      said.push_back(grade::answer_line(task, mistake.answer(one.numbers)));
      true_lines.push_back(grade::answer_line(task, truth));
      right.push_back(grade::marked(task, truth, said.back()).fault.empty());
    }
    CHECK(std::count(right.begin(), right.end(), false) > 0);
    const std::vector<grade::Fit> found = grade::fits(task, cases, {said.begin(), said.end()}, right);
    CHECK(std::any_of(found.begin(), found.end(), [&](const grade::Fit& fit) { return fit.name == mistake.name; }));
    CHECK(grade::fits(task, cases, {true_lines.begin(), true_lines.end()}, std::vector<bool>(cases.size(), true))
              .empty());
  }
  CHECK(with_mistakes.size() == 9);
}

TEST_CASE("the examples are what --start writes", "[grade]") {
  for (const char* task : {"aabb", "sphere-sphere", "ray-sphere", "ray-triangle"})
    for (const grade::Language& language : grade::languages()) {
      const grade::Task& of = grade::task_named(task);
      const std::string file = grade::starter_file(of, language), text = grade::starter(of, language);
      INFO(file);
      CHECK(isect::test::contents(std::string(ISECT_EXAMPLE_SCENES) + "/grade/" + file) == text);
      CHECK(isect::test::count(text, "\n") < 30);
    }
  for (const grade::Task& task : grade::tasks())
    for (const grade::Language& language : grade::languages()) {
      INFO(task.id << ' ' << language.name);
      CHECK_THAT(grade::starter(task, language), !Contains("{name}") && !Contains("{width}") && !Contains("{answer}"));
    }
}

TEST_CASE("isect grade lists tasks, prints pages, cases and answers, and writes starters", "[grade]") {
  const Shell shell;
  CHECK(lines_of(shell("isect grade --list").out).size() == 17);
  CHECK(Json::parse(shell("isect grade --list --json").out).size() == 17);
  CHECK_THAT(shell("isect grade aabb").out, Contains("blo: the least corner of b"));
  CHECK_THAT(shell("isect grade aabb --format md").out, Contains("# aabb: Box and box"));
  const Ran plain = shell("isect grade aabb --cases --plain --count 2 --seed 9");
  CHECK(plain.status == 0);
  CHECK(lines_of(plain.out).size() == 22);
  const Ran answered = shell("isect grade aabb --cases --count 2 --seed 9 | isect query");
  const std::vector<std::string> right = lines_of(shell("isect grade aabb --answers --count 2 --seed 9").out);
  const std::vector<std::string> results = lines_of(answered.out);
  REQUIRE(results.size() == right.size());
  for (std::size_t i = 0; i < right.size(); ++i)
    CHECK((Json::parse(results[i])["result"]["intersects"] == true) == (right[i] == "1"));
  const Ran start = shell("isect grade --start hull --language rust && isect grade --start hull --language rust");
  CHECK(start.status == 4);
  CHECK_THAT(start.err, Contains("isect grade hull --plain ./hull") && Contains("hull.rs: it is there already"));
}

TEST_CASE("isect grade says what is wrong with a command", "[grade]") {
  const Shell shell;
  const std::pair<const char*, const char*> wrong[] = {
      {"isect grade", "TASK: none is given"},
      {"isect grade abb ./x", "did you mean \"aabb\"?"},
      {"isect grade aabb --plian ./x", "\"--plian\" is unknown"},
      {"isect grade --start aabb --language cobol", "--language: \"cobol\" is unknown"},
      {"isect grade aabb --format html", "--format: \"html\" is unknown"},
      {"isect grade aabb --convention open", "allowed: closed, note"},
      {"isect grade aabb --count 0 ./x", "--count: 0 is given; allowed: 1 to 1000"}};
  for (const auto& [command, says] : wrong) {
    INFO(command);
    const Ran ran = shell(command);
    CHECK(ran.status == 2);
    CHECK_THAT(ran.err, Contains(says));
    CHECK(ran.out.empty());
  }
  CHECK(shell("isect grade aabb ./none").status == 4);
  CHECK_THAT(shell("echo >there; isect grade aabb there").err, Contains("the file beside you is ./there"));
}

}  // namespace grade_test
