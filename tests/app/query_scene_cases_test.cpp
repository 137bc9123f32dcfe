// The hard cases of every pair of a scene's objects, as lines of `isect query`; and that they are what their judge
// says.

#include <fstream>
#include <map>
#include <set>

#include "tests/app/query_questions.h"
#include "tests/cases/scenes.h"
#include "tests/proof/words.h"

namespace query_scene_cases_test {
using isect::cases::SceneJson;
using isect::tests::is_t;
using isect::tests::ulps;

namespace {

struct Cases {
  std::string file;
  bool flat;
  std::vector<SceneJson> lines = {};
};

const std::vector<Cases>& all_cases() {
  static const std::vector<Cases> all = [] {
    std::vector<Cases> both = {{"plane.jsonl", true}, {"space.jsonl", false}};
    for (Cases& cases : both) {
      std::ifstream file(isect::tests::own_cases() / "scenes" / cases.file);
      for (std::string line; std::getline(file, line);) cases.lines.push_back(SceneJson::parse(line));
      REQUIRE(!cases.lines.empty());
    }
    return both;
  }();
  return all;
}

/// The part of the result that contradicts the truth.
std::string contradiction(const SceneJson& truth, const SceneJson& result) {
  for (const auto& [key, value] : truth.items()) {
    if (!result.contains(key)) return key + " is missing";
    const SceneJson& given = result[key];
    const bool number = is_t(key) && key != "triangles_met" && !value.is_null() && !given.is_null();
    if (number ? !(ulps(given, value, false) <= 4) : given != value) return key;
  }
  return "";
}

std::string types(const SceneJson& line) {
  std::string a = line["objects"][0].begin().key(), b = line["objects"][1].begin().key();
  return a < b ? a + ", " + b : b + ", " + a;
}

}  // namespace

TEST_CASE("every case of two objects of a scene gets the true answer", "[query][scene]") {
  for (const Cases& cases : all_cases()) {
    const isect::test::Shell shell;
    const isect::test::Ran ran =
        shell("isect query '" + (isect::tests::own_cases() / "scenes" / cases.file).string() + "'");
    CHECK(ran.status == 0);
    std::istringstream replies(ran.out);
    std::string text;
    for (const SceneJson& line : cases.lines) {
      REQUIRE(std::getline(replies, text));
      const SceneJson reply = SceneJson::parse(text);
      INFO(line.dump() << "\n  answered " << text);
      REQUIRE(reply["id"] == line["id"]);
      REQUIRE(reply.contains("result"));
      REQUIRE(reply["result"].size() == 1);
      CHECK(contradiction(line["expected"][0]["result"], reply["result"][0]["result"]) == "");

      const auto both = isect::cases::posed(line["objects"], cases.flat);
      REQUIRE(both);
      const isect::proof::Named a = {"A", (*both)[0].thing}, b = {"B", (*both)[1].thing};
      CHECK(isect::proof::judge(reply["result"][0]["verdict"], a, b) == isect::proof::Judged::right);
    }
    CHECK_FALSE(std::getline(replies, text));
  }
}

TEST_CASE("the truth of each case of a scene is what rationals say", "[query][scene]") {
  for (const Cases& cases : all_cases())
    for (const SceneJson& line : cases.lines) {
      INFO(line.dump());
      const auto both = isect::cases::posed(line["objects"], cases.flat);
      REQUIRE(both);
      CHECK(isect::cases::expected(*both) == line["expected"]);
    }
}

TEST_CASE("there are cases of every pair of objects, and of every answer that it can have", "[query][scene]") {
  std::map<std::string, int> of_pair;
  std::map<std::string, std::set<std::string>> relations, notes;
  for (const Cases& cases : all_cases())
    for (const SceneJson& line : cases.lines) {
      const std::string pair = cases.file + " " + types(line);
      ++of_pair[pair];
      notes[pair].insert(line["note"]);
      const SceneJson& truth = line["expected"][0]["result"];
      if (truth.contains("relation")) relations[pair].insert(truth["relation"]);
    }
  CHECK(of_pair.size() == 105 + 166);
  for (const auto& [pair, count] : of_pair) {
    INFO(pair);
    CHECK(count >= 9);
    CHECK(notes[pair].size() >= 8);
    if (relations.contains(pair)) CHECK(relations[pair].size() >= 3);
  }
}

}  // namespace query_scene_cases_test
