// Conformance: every hard case of the project and of the public test suites through `isect query`, in double, and in
// float where its numbers are floats.

#include <map>

#include "tests/app/query_fits.h"

namespace query_peers_test {
using namespace isect::tests;
using isect::test::Shell;

namespace {

/// A description of what is wrong with the reply; empty if it is right.
std::string wrong(const Question& q, const Json& reply) {
  const bool may_refuse = q.expected.contains("policy") || q.expected.contains("degenerate");
  if (reply.contains("error")) return may_refuse ? "" : "an error";
  const Json& result = reply.at("result");
  if (may_refuse) return says_yes(result) ? "a yes" : "";
  return q.of->kind == "bounding_volume_fit" ? contradiction_of_fit(q, result) : contradiction(q, result);
}

/// Asks all questions about the cases, and prints how many were answered rightly.
void score(const char* set, const std::vector<PeerCase>& cases) {
  std::vector<Question> questions;
  for (const PeerCase& c : cases) ask(c, questions);
  const std::size_t as_given = questions.size();
  for (std::size_t i = 0; i < as_given; ++i)
    if (!questions[i].request.contains("scalar") && floats(questions[i].request)) {
      questions.push_back(questions[i]);
      questions.back().request["scalar"] = "f32";
    }

  const std::vector<Json> replies = answers(questions);
  REQUIRE(replies.size() == questions.size());
  int refusals = 0;
  std::map<std::string, std::pair<int, int>> counts;  // right, asked
  for (std::size_t i = 0; i < questions.size(); ++i) {
    const Question& q = questions[i];
    const Json& reply = replies[i];
    INFO(q.of->name << "\n  asked    " << q.request.dump() << "\n  expected " << q.expected.dump() << "\n  answered "
                    << reply.dump());
    REQUIRE(reply.at("id") == i);
    if (refused(q, reply)) {
      ++refusals;
      continue;
    }
    auto& [right, asked] = counts[q.of->kind];
    ++asked;
    const std::string complaint = wrong(q, reply);
    CHECK(complaint == "");
    right += complaint.empty();
  }
  std::printf("%s: %zu cases\n%-20s %5d polygons with crossing edges refused by slabs and trapezoids\n", set,
              cases.size(), "pip", refusals);
  for (const auto& [kind, count] : counts)
    std::printf("%-20s %5d of %5d questions right\n", kind.c_str(), count.first, count.second);
}

}  // namespace

TEST_CASE("every case of every set gets the true answer", "[query][peer]") {
  score("the project's own", cases_in(own_cases(), ""));
  const std::filesystem::path folder = public_cases();
  if (folder.empty()) return;
  const std::vector<PeerCase> cases = cases_in(folder, "");
  CHECK(cases.size() == 3033);
  score("public test suites", cases);
}

TEST_CASE("there are own cases of every kind, and naive methods fail on a good share of them", "[query][peer]") {
  const std::vector<PeerCase> cases = cases_in(own_cases(), "");
  std::map<std::string, int> of_kind;
  for (const PeerCase& c : cases) ++of_kind[c.kind];
  std::istringstream help(Shell()("isect query --help").out);
  int kinds = 0;
  for (std::string line; std::getline(help, line);) {
    std::istringstream words(line);
    std::string kind, variant;
    words >> kind >> variant;
    if (!line.starts_with("  ") || variant != "exact") continue;
    INFO(kind);
    CHECK(of_kind[kind] >= 30);
    ++kinds;
  }
  CHECK(kinds == 51);

  const std::map<std::string, std::vector<const char*>> naive = {{"capsule_capsule", {"clamped"}},
                                                                 {"pip", {"crossings_naive", "winding_naive"}},
                                                                 {"ray_box", {"slabs"}},
                                                                 {"ray_obb", {"projections"}},
                                                                 {"ray_plane", {"textbook"}},
                                                                 {"ray_polygon", {"projected"}},
                                                                 {"ray_sphere", {"quadratic", "half_b", "haines"}},
                                                                 {"segment_box", {"liang_barsky"}},
                                                                 {"segment_segment", {"parametric"}},
                                                                 {"sphere_box", {"accumulate"}},
                                                                 {"sphere_capsule", {"clamped", "by_pythagoras"}},
                                                                 {"sphere_sphere", {"squared_distance"}}};
  std::vector<Question> questions;
  for (const PeerCase& c : cases)
    if (const auto found = naive.find(c.kind); found != naive.end())
      for (const char* variant : found->second) {
        questions.push_back({&c, inputs(c), c.content.at("expected")});
        questions.back().request["variant"] = variant;
      }
  const std::vector<Json> replies = answers(questions);
  std::map<std::string, std::pair<int, int>> counts;  // wrong, judged
  for (std::size_t i = 0; i < questions.size(); ++i) {
    if (!replies[i].contains("result")) continue;
    const std::optional<bool> failed = misjudged(questions[i].expected, replies[i]["result"]);
    if (!failed) continue;
    auto& [failures, judged] = counts[questions[i].of->kind + " " + questions[i].request["variant"].get<std::string>()];
    failures += *failed, ++judged;
  }
  for (const auto& [method, count] : counts) {
    std::printf("%-30s wrong about %3d of %3d\n", method.c_str(), count.first, count.second);
    INFO(method);
    CHECK(count.first * 10 >= count.second);
  }
}

}  // namespace query_peers_test
