// Conformance: every case of the public test suites through `isect query`, in double, and in float where its numbers
// are floats.

#include <cmath>
#include <map>
#include <sstream>

#include "bench/rational.h"
#include "tests/catch.h"
#include "tests/peer_cases.h"
#include "tests/program/shell.h"

namespace query_peers_test {
using namespace isect;
using Json = nlohmann::json;
using oracle::cross, oracle::dot, oracle::operator-;
using oracle::Rational;
using tests::peer_number;
using tests::PeerCase;

namespace {

/// Whether every number of the case's inputs is a float.
bool floats(const Json& json) {
  if (json.is_number())
    return static_cast<double>(static_cast<float>(json.get<double>())) == json.get<double>();
  if (!json.is_structured()) return true;
  return std::all_of(json.begin(), json.end(), floats);
}

Json inputs(const PeerCase& c) {
  Json in = c.content;
  for (const char* key : {"expected", "peer", "peer_differs", "note", "tags"}) in.erase(key);
  in["kind"] = c.kind;
  return in;
}

/// The case in the ways it is asked, each with what is expected of it.
struct Question {
  const PeerCase* of;
  Json request, expected;
};

void ask(const PeerCase& c, std::vector<Question>& questions) {
  const Json& expected = c.content.at("expected");
  questions.push_back({&c, inputs(c), expected});
  if (c.kind == "orient2d") {
    const char* orders[] = {"bca", "cab", "acb", "cba", "bac"};
    for (int i = 0; i < 5; ++i) {
      Json in = inputs(c);
      for (int k = 0; k < 3; ++k) in[std::string(1, "abc"[k])] = c.content.at(std::string(1, orders[i][k]));
      questions.push_back({&c, in, {{"sign", expected["sign"].get<int>() * (i < 2 ? 1 : -1)}}});
    }
  }
  if (c.kind == "ray_sphere" && expected.contains("segment_hit_0_1")) {
    Json in = inputs(c);
    in["tmin"] = 0, in["tmax"] = 1;
    questions.push_back({&c, in, {{"ray_hit", expected["segment_hit_0_1"]}}});
  }
  if (c.kind == "pip")
    for (const char* variant : {"slabs", "trapezoids"}) {
      questions.push_back({&c, inputs(c), expected});
      questions.back().request["variant"] = variant;
    }
  if (c.kind == "bounding_volume_fit") {
    questions.pop_back();
    for (const char* volume : {"aabb", "sphere", "obb"}) {
      Json in = inputs(c);
      in["volume"] = volume;
      questions.push_back({&c, in, expected});
    }
  }
}

std::vector<Json> answers(const std::vector<Question>& questions) {
  const test::Shell shell;
  std::ostringstream lines;
  for (std::size_t i = 0; i < questions.size(); ++i) {
    Json request = questions[i].request;
    request["id"] = i;
    lines << request.dump() << '\n';
  }
  test::write(shell.work() / "cases", lines.str());
  const test::Ran ran = shell("isect query cases");
  CHECK(ran.err.empty());
  std::vector<Json> all;
  std::istringstream out(ran.out);
  for (std::string line; std::getline(out, line);) all.push_back(Json::parse(line));
  return all;
}

double ulps(const Json& answer, const Json& expected, bool f32) {
  const double x = peer_number(answer), truth = peer_number(expected);
  if (x == truth) return 0;
  if (!std::isfinite(truth)) return std::numeric_limits<double>::infinity();
  return f32 ? oracle::ulps(static_cast<float>(x), Rational(truth)) : oracle::ulps(x, Rational(truth));
}

bool is_t(const std::string& key) { return key[0] == 't'; }

int side(const Json& a, const Json& b, const Json& p) {
  const auto x = [](const Json& v) { return Rational(v[0].get<double>()); };
  const auto y = [](const Json& v) { return Rational(v[1].get<double>()); };
  return oracle::sign((x(b) - x(a)) * (y(p) - y(a)) - (y(b) - y(a)) * (x(p) - x(a)));
}

/// Whether a map of a polygon was rightly refused: the two edges that the error names cross where there is no vertex.
bool refused(const Question& q, const Json& reply) {
  if (!q.request.contains("variant") || !reply.contains("error")) return false;
  int edge[2] = {}, ring[2] = {};
  if (std::sscanf(reply["error"].get<std::string>().c_str(),
                  "edge %d of ring %d and edge %d of ring %d cross", &edge[0], &ring[0], &edge[1],
                  &ring[1]) != 4)
    return false;
  Json ends[4];
  for (int i = 0; i < 4; ++i) {
    const Json& vertices = q.request["rings"].at(static_cast<std::size_t>(ring[i / 2]));
    ends[i] = vertices.at((static_cast<std::size_t>(edge[i / 2]) + static_cast<std::size_t>(i % 2)) %
                          vertices.size());
  }
  return side(ends[0], ends[1], ends[2]) * side(ends[0], ends[1], ends[3]) < 0 &&
         side(ends[2], ends[3], ends[0]) * side(ends[2], ends[3], ends[1]) < 0;
}

/// The expected fields that an answer holds under the same name, or what contradicts them.
std::string contradiction(const Question& q, const Json& result) {
  for (const auto& [key, value] : q.expected.items()) {
    if (!result.contains(key)) continue;
    Json given = result[key];
    if (q.of->kind == "obb_obb" && key == "relation" && value == "overlap" && given.is_string() &&
        (given == "a_contains_b" || given == "b_contains_a" || given == "equal"))
      given = "overlap";  // these suites know no containment
    if (value.is_null() || given.is_null()) {
      if (value != given) return key;
    } else if (is_t(key)) {
      if (!(ulps(given, value, q.request.value("scalar", "f64") == "f32") <= 4))
        return key + ", more than 4 ulp";
    } else if (key == "area") {
      if (!(ulps(given, value, false) <= 4)) return key;
    } else if (key == "normal") {
      for (int i = 0; i < 3; ++i)
        if (!(std::abs(peer_number(given[i]) - peer_number(value[i])) <= 4e-16)) return key;
    } else if (given != value) {
      return key;
    }
  }
  return "";
}

oracle::Coordinates<3> point(const Json& json) {
  return {Rational(json[0].get<double>()), Rational(json[1].get<double>()), Rational(json[2].get<double>())};
}

/// Whether the volume of the answer contains every point, in rational arithmetic, and is not too large.
std::string contradiction_of_fit(const Question& q, const Json& r) {
  const std::string volume = q.request["volume"];
  double size = 0;
  for (const Json& given : q.request["points"]) {
    const oracle::Coordinates<3> p = point(given);
    bool inside = true;
    if (volume == "aabb") {
      const auto lo = point(r["lo"]), hi = point(r["hi"]);
      for (int i = 0; i < 3; ++i) inside = inside && lo[i] <= p[i] && p[i] <= hi[i];
    } else if (volume == "sphere") {
      const auto f = p - point(r["center"]);
      const Rational radius(r["radius"].get<double>());
      inside = dot(f, f) <= radius * radius;
    } else {
      const auto f = p - point(r["c"]);
      const auto u = point(r["u"][0]), v = point(r["u"][1]), w = point(r["u"][2]);
      const Rational volume6 = abs(dot(u, cross(v, w)));
      const oracle::Coordinates<3> faces[] = {cross(v, w), cross(w, u), cross(u, v)};
      for (int i = 0; i < 3; ++i)
        inside = inside && abs(dot(f, faces[i])) <= Rational(r["e"][i].get<double>()) * volume6;
    }
    if (!inside) return "a point lies outside";
  }
  if (volume == "obb") size = 8 * r["e"][0].get<double>() * r["e"][1].get<double>() * r["e"][2].get<double>();
  if (volume == "obb" && q.expected.contains("volume_upper_bound") &&
      !(size <= 2.0 * q.expected["volume_upper_bound"].get<double>()))
    WARN(q.of->name << ": the box of the principal axes has " << size << ", the best known "
                    << q.expected["volume_upper_bound"]);
  if (volume == "sphere" && q.expected.contains("three_sphere_radius") &&
      !(r["radius"].get<double>() <= q.expected["three_sphere_radius"].get<double>()))
    return "the sphere is larger than three.js's";
  return "";
}

}  // namespace

TEST_CASE("every case of the public test suites gets the true answer", "[query][peer]") {
  const std::vector<PeerCase> cases = tests::peer_cases();
  if (cases.empty()) {
    WARN(tests::no_peer_cases());
    return;
  }
  CHECK(cases.size() == 3033);

  std::vector<Question> questions;
  for (const PeerCase& c : cases) ask(c, questions);
  const std::size_t in_double = questions.size();
  for (std::size_t i = 0; i < in_double; ++i)
    if (floats(questions[i].request) && questions[i].of->kind != "bounding_volume_fit") {
      questions.push_back(questions[i]);
      questions.back().request["scalar"] = "f32";
    }

  const std::vector<Json> replies = answers(questions);
  REQUIRE(replies.size() == questions.size());
  int refusals = 0;
  std::map<std::string, std::pair<int, int>> score;  // right, asked
  for (std::size_t i = 0; i < questions.size(); ++i) {
    const Question& q = questions[i];
    const Json& reply = replies[i];
    INFO(q.of->name << "\n  asked    " << q.request.dump() << "\n  expected " << q.expected.dump()
                    << "\n  answered " << reply.dump());
    REQUIRE(reply.at("id") == i);
    if (refused(q, reply)) {
      ++refusals;
      continue;
    }
    auto& [right, asked] = score[q.of->kind];
    ++asked;
    const bool may_refuse = q.expected.contains("policy") || q.expected.contains("degenerate");
    std::string wrong = reply.contains("error") ? (may_refuse ? "" : "an error") : "";
    if (reply.contains("result") && !may_refuse)
      wrong = q.of->kind == "bounding_volume_fit" ? contradiction_of_fit(q, reply["result"])
                                                  : contradiction(q, reply["result"]);
    CHECK(wrong == "");
    right += wrong.empty();
  }
  std::printf("%-20s %5d polygons with crossing edges refused by slabs and trapezoids\n", "pip", refusals);
  for (const auto& [kind, counts] : score)
    std::printf("%-20s %5d of %5d questions right\n", kind.c_str(), counts.first, counts.second);
}

}  // namespace query_peers_test
