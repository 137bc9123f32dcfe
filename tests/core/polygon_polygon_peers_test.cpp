// Points, lines and polygons of the JTS Topology Suite's validation tests, with the answers that are published with
// them, where they are at hand: beside the repository, in shared/peer-relate, or where ISECT_PEER_RELATE says.
//
// Every geometry is a polygon of the core: a line's pieces are rings of two corners, a point is a ring of one. So their
// sets are asked: disjoint, intersects, equalsTopo, covers, coveredBy, of all pairs. Where one of the two is an area,
// its interior is that of the core, and the other answers follow: a line, or points, touch it where they meet its
// boundary alone, cross it where they reach into it and out of it, lie `within` where they reach into it and not out.
// Two lines, a line and points, or points, are left out of touches, crosses, overlaps, within and contains: OGC takes
// from a line's interior the points in which an odd number of its parts end, wherever else the line passes through
// them, and the core has no such sets. Of the matrix, the entries are asked that say whether interiors meet, and
// whether one leaves the other.

#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <isect/polygon_polygon.h>
#include "tests/catch.h"
#include "tests/peer_cases.h"

namespace polygon_polygon_peers_test {
using namespace isect;
using Json = nlohmann::json;

namespace {

std::filesystem::path answers_file() {
  if (const char* given = std::getenv("ISECT_PEER_RELATE")) return std::filesystem::path(given) / "relate.jsonl";
  return tests::own_cases().parent_path().parent_path().parent_path() / "shared" / "peer-relate" / "relate.jsonl";
}

struct Geometry {
  int dimension;
  Polygon<double, 2> set;
};

/// The lists of points that the text has, each in the innermost parentheses.
std::vector<Ring<double, 2>> lists(const std::string& text) {
  std::vector<Ring<double, 2>> all;
  const char* at = text.c_str();
  bool open = false;
  while (*at != 0) {
    char* end = nullptr;
    const double x = std::strtod(at, &end);
    if (end != at) {
      at = end;
      const double y = std::strtod(at, &end);
      REQUIRE(end != at);
      at = end;
      if (!open) all.emplace_back();
      open = true;
      all.back().push_back({x, y});
      continue;
    }
    open &= *at != '(' && *at != ')';
    ++at;
  }
  return all;
}

Geometry geometry(const std::string& text) {
  const std::string type = text.substr(0, text.find_first_of(" ("));
  const std::vector<Ring<double, 2>> parts = lists(text.substr(text.find('(')));
  if (type == "POLYGON" || type == "MULTIPOLYGON") return {2, {parts}};
  Geometry result = {type == "LINESTRING" || type == "MULTILINESTRING" ? 1 : 0, {}};
  if (result.dimension == 0) REQUIRE((type == "POINT" || type == "MULTIPOINT"));
  for (const Ring<double, 2>& part : parts)
    for (std::size_t i = 0; i < part.size(); ++i) {
      if (result.dimension == 0) result.set.rings.push_back({part[i]});
      if (result.dimension == 1 && i > 0) result.set.rings.push_back({part[i - 1], part[i]});
    }
  return result;
}

/// The rings' edges, without what they go round.
Polygon<double, 2> boundary(const Polygon<double, 2>& area) {
  Polygon<double, 2> edges;
  for (const Ring<double, 2>& ring : area.rings)
    for (std::size_t i = 0; i < ring.size(); ++i) edges.rings.push_back({ring[i], ring[(i + 1) % ring.size()]});
  return edges;
}

bool inside(Relation r) { return r == Relation::a_inside_b || r == Relation::equal; }

/// Whether a line, or points, have a point in the interior of an area.
bool reaches_into(const Geometry& thin, const Polygon<double, 2>& area) {
  const Polygon<double, 2> edges = boundary(area);
  for (const Ring<double, 2>& part : thin.set.rings) {
    if (thin.dimension == 0) {
      if (locate(part[0], area) == Location::in) return true;
      continue;
    }
    const Segment<double, 2> segment = {part[0], part[1]};
    const Relation r = relate(segment, area);
    if (r == Relation::overlapping || (inside(r) && !inside(relate(segment, edges)))) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("points, lines and polygons of a public test suite lie as it says", "[polygon_polygon][peer]") {
  std::ifstream file(answers_file());
  if (!file) {
    std::printf("skipped: there is no %s\n", answers_file().c_str());
    return;
  }
  int pairs = 0, asked = 0, left_out = 0, matrices = 0;
  for (std::string line; std::getline(file, line);) {
    const Json given = Json::parse(line);
    INFO(line);
    const Geometry a = geometry(given["a"]), b = geometry(given["b"]);
    ++pairs;
    const Relation r = relate(a.set, b.set);
    CHECK(relate(b.set, a.set) == reversed(r));
    CHECK(intersects(a.set, b.set) == (r != Relation::disjoint));
    const bool covered = inside(r), covers = inside(reversed(r));

    std::optional<bool> interiors;
    if (a.dimension == 2 && b.dimension == 2)
      interiors = r != Relation::disjoint && r != Relation::touching;
    else if (b.dimension == 2)
      interiors = reaches_into(a, b.set);
    else if (a.dimension == 2)
      interiors = reaches_into(b, a.set);
    const auto told = [&](const std::string& predicate) -> std::optional<bool> {
      if (predicate == "disjoint") return r == Relation::disjoint;
      if (predicate == "intersects") return r != Relation::disjoint;
      if (predicate == "equalsTopo") return r == Relation::equal;
      if (predicate == "covers") return covers;
      if (predicate == "coveredBy") return covered;
      if (!interiors) return {};
      const bool areas = a.dimension == b.dimension;
      if (predicate == "touches") return r != Relation::disjoint && !*interiors;
      if (predicate == "within") return covered && *interiors;
      if (predicate == "contains") return covers && *interiors;
      if (predicate == "overlaps") return areas && r == Relation::overlapping;
      if (predicate == "crosses") return !areas && *interiors && !(a.dimension < b.dimension ? covered : covers);
      FAIL("an unknown predicate " << predicate);
      return {};
    };
    for (const auto& [predicate, truth] : given["predicates"].items()) {
      INFO(predicate);
      const std::optional<bool> answer = told(predicate);
      ++(answer ? asked : left_out);
      if (answer) CHECK(*answer == truth.get<bool>());
    }

    const std::string matrix = given["relate"];  // interior, boundary, exterior of A by those of B
    ++matrices;
    if (interiors) CHECK((matrix[0] != 'F') == *interiors);
    CHECK((matrix[2] == 'F' && matrix[5] == 'F') == covered);
    CHECK((matrix[6] == 'F' && matrix[7] == 'F') == covers);
  }
  std::printf("%d pairs: %d predicates asked, %d left out; %d matrices\n", pairs, asked, left_out, matrices);
  CHECK(pairs == 245);
  CHECK(asked == 1800);
  CHECK(left_out == 650);
}

}  // namespace polygon_polygon_peers_test
