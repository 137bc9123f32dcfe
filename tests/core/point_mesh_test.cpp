#include <isect/point_mesh.h>

#include <random>

#include "bench/rational.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace point_mesh_test {
using namespace isect;

namespace {

using Vec = Vector<double, 3>;

/// Boxes of whole numbers, each of twelve triangles; those that share a face have its triangles twice.
TriangleMesh<double> boxes_of(const std::vector<Aabb<double, 3>>& boxes) {
  TriangleMesh<double> mesh;
  for (const Aabb<double, 3>& box : boxes) {
    const int first = static_cast<int>(mesh.vertices.size());
    for (int i = 0; i < 8; ++i)
      mesh.vertices.emplace_back(i & 1 ? box.hi.x() : box.lo.x(), i & 2 ? box.hi.y() : box.lo.y(),
                                 i & 4 ? box.hi.z() : box.lo.z());
    constexpr int faces[6][4] = {{0, 2, 6, 4}, {1, 5, 7, 3}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 6, 7, 5}};
    for (const auto& f : faces) {
      mesh.triangles.push_back({first + f[0], first + f[1], first + f[2]});
      mesh.triangles.push_back({first + f[0], first + f[2], first + f[3]});
    }
  }
  return mesh;
}

}  // namespace

TEST_CASE("a point lies in boxes of triangles where it lies in an odd number of boxes", "[point_mesh]") {
  std::mt19937_64 random(tests::seed());
  const auto whole = [&](int lo, int hi) -> double { return std::uniform_int_distribution<int>(lo, hi)(random); };
  std::array<int, 3> seen = {};
  for (int round = 0; round < tests::cases(200, 5000); ++round) {
    std::vector<Aabb<double, 3>> boxes;
    for (int i = 0; i < 3; ++i) {
      const Vec lo(whole(0, 4), whole(0, 4), whole(0, 4));
      boxes.push_back({lo, lo + Vec(whole(1, 4), whole(1, 4), whole(1, 4))});
    }
    const TriangleMesh<double> mesh = boxes_of(boxes);
    REQUIRE(point_mesh::closed(mesh));
    for (int i = 0; i < 20; ++i) {
      const Vec p(whole(0, 16) / 2, whole(0, 16) / 2, whole(0, 16) / 2);
      int in = 0;
      bool on = false;
      for (const auto& box : boxes) {
        const bool within = (box.lo.array() < p.array() && p.array() < box.hi.array()).all();
        in += within, on |= !within && (box.lo.array() <= p.array() && p.array() <= box.hi.array()).all();
      }
      const Location truth = on ? Location::on : in % 2 == 1 ? Location::in : Location::out;
      CAPTURE(round, p.transpose());
      REQUIRE(locate(p, mesh) == truth);
      ++seen[static_cast<std::size_t>(truth)];
    }
  }
  for (const int count : seen) CHECK(count > 100);
}

TEST_CASE("an ulp decides at a mesh's face, edge and corner", "[point_mesh]") {
  const TriangleMesh<double> mesh = boxes_of({{{0, 0, 0}, {3, 3, 3}}});
  const double less = std::nextafter(3, 0), more = std::nextafter(3, 4);
  CHECK(locate<double>({3, 1, 2}, mesh) == Location::on);
  CHECK(locate<double>({3, 3, 3}, mesh) == Location::on);
  CHECK(locate<double>({3, 3, 1}, mesh) == Location::on);
  CHECK(locate<double>({less, less, less}, mesh) == Location::in);
  CHECK(locate<double>({more, 1, 2}, mesh) == Location::out);
  CHECK(locate<double>({1, 1, 1}, mesh) == Location::in);
}

TEST_CASE("a mesh is closed where each edge has an even number of triangles", "[point_mesh]") {
  TriangleMesh<double> mesh = boxes_of({{{0, 0, 0}, {3, 3, 3}}});
  CHECK(point_mesh::closed(mesh));
  TriangleMesh<double> apart;  // each triangle with vertices of its own, as STL has them
  for (const auto& t : mesh.triangles) {
    const int first = static_cast<int>(apart.vertices.size());
    for (const int i : t) apart.vertices.push_back(mesh.vertices[static_cast<std::size_t>(i)]);
    apart.triangles.push_back({first, first + 1, first + 2});
  }
  CHECK(point_mesh::closed(apart));
  CHECK(locate<double>({1, 1, 1}, apart) == Location::in);
  mesh.triangles.pop_back();
  CHECK_FALSE(point_mesh::closed(mesh));
}

TEST_CASE("no point lies in a mesh without triangles or with NaN", "[point_mesh]") {
  TriangleMesh<double> mesh = boxes_of({{{0, 0, 0}, {3, 3, 3}}});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(locate<double>({1, nan, 1}, mesh) == Location::out);
  mesh.vertices[0].x() = nan;
  CHECK(locate<double>({1, 1, 1}, mesh) == Location::out);
  CHECK(locate<double>({1, 1, 1}, TriangleMesh<double>{}) == Location::out);
}

}  // namespace point_mesh_test
