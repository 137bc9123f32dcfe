#pragma once
// Cases of `isect query`: the ways each is asked, and what is wrong with an answer.

#include <cmath>
#include <cstdio>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "bench/rational.h"
#include "tests/app/shell.h"
#include "tests/catch.h"
#include "tests/peer_cases.h"

namespace isect::tests {

using Json = nlohmann::json;
using oracle::Rational;

/// Whether every number of the case's inputs is a float.
inline bool floats(const Json& json) {
  if (json.is_number()) return static_cast<double>(static_cast<float>(json.get<double>())) == json.get<double>();
  if (!json.is_structured()) return true;
  return std::all_of(json.begin(), json.end(), floats);
}

inline Json inputs(const PeerCase& c) {
  Json in = c.content;
  for (const char* key : {"expected", "peer", "peer_differs", "note", "tags"}) in.erase(key);
  in["kind"] = c.kind;
  return in;
}

/// One way to ask the case, with its expected answer.
struct Question {
  const PeerCase* of;
  Json request, expected;
};

inline void ask(const PeerCase& c, std::vector<Question>& questions) {
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
  const auto by = [&](const char* variant, const Json& truth) {
    questions.push_back({&c, inputs(c), truth});
    questions.back().request["variant"] = variant;
  };
  if (c.kind == "pip")
    for (const char* variant : {"crossings", "winding", "slabs", "trapezoids"}) by(variant, expected);
  if (c.kind == "ray_sphere") by("robust", expected);
  if (c.kind == "ray_box" && expected.value("hit", false)) by("conservative", {{"hit", true}});
  if (c.kind == "bounding_volume_fit") {
    questions.pop_back();
    for (const char* volume : {"aabb", "sphere", "obb", "kdop"}) {
      Json in = inputs(c);
      in["volume"] = volume;
      questions.push_back({&c, in, expected});
    }
  }
}

inline std::vector<Json> answers(const std::vector<Question>& questions) {
  const test::Shell shell;
  std::ostringstream lines;
  for (std::size_t i = 0; i < questions.size(); ++i) {
    Json request = questions[i].of->content;  // as it stands in its file, with what is expected and the notes
    request.update(questions[i].request);
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

inline double ulps(const Json& answer, const Json& expected, bool f32) {
  const double x = peer_number(answer), truth = peer_number(expected);
  if (x == truth) return 0;
  if (!std::isfinite(truth)) return std::numeric_limits<double>::infinity();
  return f32 ? oracle::ulps(static_cast<float>(x), Rational(truth)) : oracle::ulps(x, Rational(truth));
}

inline bool is_t(const std::string& key) { return key[0] == 't'; }

inline int side(const Json& a, const Json& b, const Json& p, bool f32) {
  const auto x = [f32](const Json& v) { return Rational(peer_number(v[0], f32)); };
  const auto y = [f32](const Json& v) { return Rational(peer_number(v[1], f32)); };
  return oracle::sign((x(b) - x(a)) * (y(p) - y(a)) - (y(b) - y(a)) * (x(p) - x(a)));
}

/// Whether a map of a polygon was rightly refused: the two edges that the error names cross where there is no vertex.
inline bool refused(const Question& of, const Json& reply) {
  if (!of.request.contains("variant") || !reply.contains("error")) return false;
  int edge[2] = {}, ring[2] = {};
  if (std::sscanf(reply["error"].get<std::string>().c_str(),
                  "field \"rings\": edge %d of ring %d and edge %d of ring %d cross", &edge[0], &ring[0], &edge[1],
                  &ring[1]) != 4)
    return false;
  Json ends[4];
  for (int i = 0; i < 4; ++i) {
    const Json& vertices = of.request["rings"].at(static_cast<std::size_t>(ring[i / 2]));
    ends[i] = vertices.at((static_cast<std::size_t>(edge[i / 2]) + static_cast<std::size_t>(i % 2)) % vertices.size());
  }
  const auto part = [&](int a, int b, int p, int q) {
    const bool f32 = asks_for_floats(of.request);
    return side(ends[a], ends[b], ends[p], f32) * side(ends[a], ends[b], ends[q], f32) < 0;
  };
  return part(0, 1, 2, 3) && part(2, 3, 0, 1);
}

/// Whether the answer says that there is a common point, or that two points are equal.
inline bool says_yes(const Json& result) {
  for (const char* key : {"intersects", "hit", "ray_hit", "equal"})
    if (result.value(key, Json(false)) == true) return true;
  return false;
}

/// The expected fields that an answer holds under the same name, or what contradicts them.
inline std::string contradiction(const Question& q, const Json& result) {
  const bool f32 = asks_for_floats(q.request);
  const auto off = [f32](const Json& given, const Json& value) { return !(ulps(given, value, f32) <= 4); };
  for (const auto& [key, value] : q.expected.items()) {
    if (!result.contains(key)) {
      if (q.of->own && !q.request.contains("variant") && !q.request.contains("volume")) return key + " is missing";
      continue;
    }
    Json given = result[key];
    const bool contained = given == "a_contains_b" || given == "b_contains_a" || given == "equal";
    const bool knows_none = q.of->kind == "obb_obb"
                                ? value == "overlap"
                                : q.of->kind == "triangle_box" && (value == "overlap" || value == "touch");
    if (!q.of->own && key == "relation" && contained && knows_none) given = value;  // these suites know no containment
    if (value.is_null() || given.is_null()) {
      if (value != given) return key;
    } else if (is_t(key) || key == "area") {
      if (off(given, value)) return key + ", more than 4 ulp";
    } else if (key == "point" && q.expected["relation"] == "cross") {
      if (off(given[0], value[0]) || off(given[1], value[1])) return key + ", more than 4 ulp";
    } else if (key == "points") {
      if (given.size() != value.size()) return key;
      for (std::size_t i = 0; i < value.size(); ++i)
        for (std::size_t k = 0; k < value[i].size(); ++k)
          if (off(given[i][k], value[i][k])) return key + ", more than 4 ulp";
    } else if (key == "normal") {
      for (int i = 0; i < 3; ++i)
        if (!(std::abs(peer_number(given[i]) - peer_number(value[i])) <= (f32 ? 0x1p29 : 1) * 4e-16)) return key;
    } else if (given != value) {
      return key;
    }
  }
  return "";
}

/// Whether a naive method says yes where the truth is no, or the other way round; nothing where it gives no such
/// answer.
inline std::optional<bool> misjudged(const Json& expected, const Json& result) {
  if (expected.contains("policy")) return {};
  const auto meets = [](const Json& point) { return !point.is_null(); };
  if (result.contains("point")) {
    if (expected["relation"] == "overlap") return {};
    return meets(result["point"]) != (expected["relation"] != "disjoint");
  }
  if (result.contains("t_first_surface")) return meets(result["t_first_surface"]) != meets(expected["t_first_surface"]);
  for (const char* key : {"intersects", "hit", "ray_hit", "evenodd", "nonzero"}) {
    if (!result.contains(key)) continue;
    const bool other_question = expected[key] == "on" || expected[key].is_null() || expected.value("coplanar", false);
    return other_question ? std::nullopt : std::optional(result[key] != expected[key]);
  }
  return {};
}

}  // namespace isect::tests
