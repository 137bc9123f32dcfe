// Many against one: the batches against the scalar exact tests and the naive ones, in the second-level cache and from
// memory. Every row asks one question of all entries; "read" adds the columns up and answers nothing.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <isect/batch.h>
#include <isect/batch_aabb.h>
#include <isect/batch_point_polygon.h>
#include <isect/batch_ray_sphere.h>
#include "bench/measure.h"
#include "bench/pair_cases.h"

using namespace isect;
using namespace isect::bench;

namespace {

template <class S>
struct Store {
  std::array<std::vector<S>, 6> columns;
  std::size_t size;

  SphereBatch<S, 3> spheres() const { return {points(0), columns[3]}; }
  BoxBatch<S, 3> boxes() const { return {points(0), points(3)}; }
  PointBatch<S, 3> points(std::size_t first) const {
    return {{columns[first], columns[first + 1], columns[first + 2]}};
  }
};

const char* name(InstructionSet set) {
  return set == InstructionSet::avx512 ? "AVX-512" : set == InstructionSet::avx2 ? "AVX2" : "any";
}
std::vector<InstructionSet> sets() {
  std::vector<InstructionSet> all = {InstructionSet::any};
  if (widest() != InstructionSet::any) all.push_back(InstructionSet::avx2);
  if (widest() == InstructionSet::avx512) all.push_back(InstructionSet::avx512);
  return all;
}

/// What reading costs: the sum of all columns, of which nothing comes.
template <class S, std::size_t K>
struct Read {
  template <class V>
  [[gnu::always_inline]] void operator()(const std::array<V, K>& x, batch::Filtered<V>& f) const {
    f.no = x[0];
    for (std::size_t k = 1; k < K; ++k) f.no += x[k];
    f.sure = f.no;
  }
};
template <class S, std::size_t K>
std::size_t read(const batch::Columns<S, K>& columns, std::size_t size) {
  std::size_t sum = 0;
  batch::each_block<S>(columns, size, widest(), Read<S, K>{},
                       [&](std::size_t, const batch::Bits& bits) { sum += bits.yes & 1; });
  return sum;
}

/// Each ray, or box, once a pass against all entries: ns an entry.
template <class One, class Count>
Timing each(const std::vector<One>& ones, std::size_t entries, int passes, const Count& count) {
  Timing t = timed(ones, passes, count);
  t.least /= static_cast<double>(entries), t.median /= static_cast<double>(entries);
  return t;
}

template <class S>
bool naive_hit(const Ray<S, 3>& ray, const Sphere<S, 3>& sphere) {
  const Vector<S, 3> f = ray.origin - sphere.center;
  const S a = ray.direction.dot(ray.direction), b = 2 * f.dot(ray.direction);
  const S c = f.dot(f) - sphere.radius * sphere.radius, discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return false;
  const S root = std::sqrt(discriminant);
  return ray.range.contains((-b - root) / (2 * a)) || ray.range.contains((-b + root) / (2 * a));
}

template <class S>
void ray_rows(std::size_t entries, const char* where, int passes) {
  Random random(stream(1, "batch"));
  Store<S> store = {{}, entries};
  std::vector<Sphere<S, 3>> scattered;
  for (std::size_t i = 0; i < entries; ++i) {
    scattered.push_back(ordinary_sphere<S>(random));
    for (std::size_t k = 0; k < 3; ++k) store.columns[k].push_back(scattered[i].center[static_cast<int>(k)]);
    store.columns[3].push_back(scattered[i].radius);
  }
  std::vector<Ray<S, 3>> rays;
  for (std::size_t i = 0; i < 4; ++i) rays.push_back(ordinary_ray<S>(random));
  const SphereBatch<S, 3> spheres = store.spheres();

  Table table(std::string("ray, spheres, ") + (sizeof(S) == 4 ? "float, " : "double, ") + where);
  const auto count = [&](const auto& hit) {
    return [&scattered, hit](const Ray<S, 3>& ray) {
      std::size_t sum = 0;
      for (const Sphere<S, 3>& s : scattered) sum += hit(ray, s);
      return sum;
    };
  };
  table.row("naive, one by one", each(rays, entries, passes, count(naive_hit<S>)));
  table.row("exact, one by one", each(rays, entries, passes, count([](const auto& ray, const auto& sphere) {
                                        return intersect(ray, sphere).surface.has_value();
                                      })));
  table.row("read",
            each(rays, entries, passes, [&](const auto&) { return read<S>(batch::columns(spheres), entries); }));
  for (const InstructionSet set : sets())
    table.row((std::string("hits, ") + name(set)).c_str(),
              each(rays, entries, passes, [&](const auto& ray) { return hits(ray, spheres, set).count(); }));
  table.row("first_hit",
            each(rays, entries, passes, [&](const auto& ray) { return first_hit(ray, spheres).has_value(); }));
}

template <class S>
void box_rows(std::size_t entries, const char* where, int passes) {
  Random random(stream(1, "batch"));
  Store<S> store = {{}, entries};
  std::vector<Aabb<S, 3>> scattered;
  for (std::size_t i = 0; i < entries; ++i) {
    scattered.push_back(ordinary_box<S>(random));
    for (int k = 0; k < 3; ++k) {
      store.columns[k].push_back(scattered[i].lo[k]);
      store.columns[static_cast<std::size_t>(k) + 3].push_back(scattered[i].hi[k]);
    }
  }
  std::vector<Aabb<S, 3>> boxes;
  for (std::size_t i = 0; i < 4; ++i) boxes.push_back(ordinary_box<S>(random));
  const BoxBatch<S, 3> batch = store.boxes();

  Table table(std::string("box, boxes, ") + (sizeof(S) == 4 ? "float, " : "double, ") + where);
  using Eigens = Eigen::AlignedBox<S, 3>;
  std::vector<Eigens> theirs;
  for (const Aabb<S, 3>& b : scattered) theirs.emplace_back(b.lo, b.hi);
  table.row("Eigen AlignedBox", each(boxes, entries, passes, [&](const Aabb<S, 3>& box) {
              const Eigens one(box.lo, box.hi);
              std::size_t sum = 0;
              for (const Eigens& b : theirs) sum += one.intersects(b);
              return sum;
            }));
  table.row("exact, one by one", each(boxes, entries, passes, [&](const Aabb<S, 3>& box) {
              std::size_t sum = 0;
              for (const Aabb<S, 3>& b : scattered) sum += intersects(box, b);
              return sum;
            }));
  table.row("read", each(boxes, entries, passes, [&](const auto&) { return read<S>(batch::columns(batch), entries); }));
  for (const InstructionSet set : sets())
    table.row((std::string("intersects, ") + name(set)).c_str(),
              each(boxes, entries, passes, [&](const auto& box) { return intersects(box, batch, set).count(); }));
}

void polygon_rows(std::size_t vertices, int passes) {
  const Ring<double, 2> ring = star(vertices), points = query_points(4096, 1);
  std::vector<double> x, y;
  for (const Point<double, 2>& p : points) x.push_back(p[0]), y.push_back(p[1]);
  const PointBatch<double, 2> batch = {{x, y}};
  const std::vector<int> once = {0};

  Table table("polygon of " + std::to_string(vertices) + ", points");
  const auto inside = [](const std::vector<Location>& all) { return std::count(all.begin(), all.end(), Location::in); };
  table.row("naive, one by one", each(once, points.size(), passes, [&](int) {
              std::size_t sum = 0;
              for (const Point<double, 2>& p : points) sum += point_polygon::crossings_naive(p, ring);
              return sum;
            }));
  table.row("exact, one by one", each(once, points.size(), passes, [&](int) {
              std::size_t sum = 0;
              for (const Point<double, 2>& p : points) sum += locate(p, ring) == Location::in;
              return sum;
            }));
  for (const InstructionSet set : sets())
    table.row((std::string("locate, ") + name(set)).c_str(), each(once, points.size(), passes, [&](int) {
                return inside(locate(batch, ring, FillRule::even_odd, set));
              }));
}

}  // namespace

/// batch_speed [passes], 21 by default.
int main(int argc, char** argv) {
  const int passes = argc > 1 ? std::atoi(argv[1]) : 21;
  if (argc > 2 || passes < 1) {
    std::fprintf(stderr, "usage: %s [passes]\n", argv[0]);
    return 2;
  }
  Table::head(ISECT_FLAGS, "ns an entry, 4 rays or boxes or 4,096 points against all, seed 1");
  const std::size_t small = 1 << 14, large = 1 << 22;
  ray_rows<double>(small, "L2", passes);
  ray_rows<float>(small, "L2", passes);
  box_rows<double>(small, "L2", passes);
  box_rows<float>(small, "L2", passes);
  ray_rows<double>(large, "memory", std::max(1, passes / 4));
  box_rows<double>(large, "memory", std::max(1, passes / 4));
  for (const std::size_t n : {100, 10'000}) polygon_rows(n, std::max(1, passes / 4));
}
