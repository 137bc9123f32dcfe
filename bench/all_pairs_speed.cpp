// All overlapping pairs of n boxes: time against n for every method, the exponent of its growth, and, as
// all_pairs_peer_speed, the libraries that are installed beside it in the same run.
//
// Boxes of sides 0.8 to 1.2, three neighbours each on average if all were alike; heavy-tailed: one in a hundred is 20
// times larger. A time includes building whatever is built, and listing each pair once. The least of the passes.

#include <cmath>
#include <cstdlib>
#include <map>

#include "bench/growth_shapes.h"
#include "bench/measure.h"
#include "core/all_pairs.h"
#include "core/overlapping_pairs.h"
#ifdef ISECT_PEERS
#include "bench/all_pairs_peers.h"
#endif

using namespace isect;
using namespace isect::bench;

namespace {

template <class S>
using Boxes = std::vector<Aabb<S, 3>>;
using List = std::vector<IndexPair>;

/// log time = exponent log n + const, by least squares.
double growth(const std::map<int, double>& times) {
  double x = 0, y = 0, xx = 0, xy = 0;
  const auto count = static_cast<double>(times.size());
  for (const auto& [n, time] : times) {
    const double u = std::log(n), v = std::log(time);
    x += u, y += v, xx += u * u, xy += u * v;
  }
  return (count * xy - x * y) / (count * xx - x * x);
}

template <class S>
class Race {
 public:
  Race(bool heavy, int passes) : heavy_(heavy), passes_(passes) {
    for (int n = 1000; n <= 1'000'000; n *= 10) boxes_[n] = scattered_boxes<S>(n, heavy);
    std::printf("\n%s, %s\n%-32s %10s %10s %10s %10s %9s\n", heavy ? "heavy-tailed" : "near-equal",
                sizeof(S) == 4 ? "float" : "double", "ms", "1e3", "1e4", "1e5", "1e6", "exponent");
  }
  /// One method up to `most` boxes; then per Embree's or the first row's time.
  template <class Find>
  void row(const char* method, int most, const Find& find) {
    std::map<int, double> times;
    for (const auto& [n, boxes] : boxes_) {
      if (n > most) continue;
      double least = 1e300;
      for (int pass = 0; pass < (n < 100'000 ? 3 * passes_ : passes_); ++pass) {
        const auto start = std::chrono::steady_clock::now();
        const List list = find(boxes);
        const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - start;
        least = std::min(least, passed.count());
        if (pass == 0) check(n, list);
      }
      times[n] = least;
    }
    print(method, times);
    if (first_.empty()) first_ = times;
    std::map<int, double> ratio;
    for (const auto& [n, time] : times)
      if (first_.contains(n)) ratio[n] = time / first_[n];
    if (ratio != times && times != first_) print("  / first row", ratio);
  }
  void pairs() const {
    std::map<int, double> counts;
    for (const auto& [n, sum] : sums_) counts[n] = static_cast<double>(sum.first);
    print("pairs", counts);
  }

 private:
  /// The number of pairs and a sum that any other set changes; the same from every method.
  void check(int n, const List& list) {
    std::uint64_t sum = 0;
    for (const auto& [i, j] : list)
      sum +=
          (static_cast<std::uint64_t>(i) << 32 | static_cast<std::uint64_t>(j)) * 0x9E3779B97F4A7C15u >> 20;
    const std::pair<std::size_t, std::uint64_t> now = {list.size(), sum};
    if (!sums_.contains(n)) sums_[n] = now;
    if (sums_[n] != now) std::printf("OTHER PAIRS: n = %d, %zu, not %zu\n", n, now.first, sums_[n].first);
  }
  void print(const char* name, const std::map<int, double>& values) const {
    std::printf("%-32s", name);
    for (const auto& [n, boxes] : boxes_) {
      if (values.contains(n))
        std::printf(" %10.*f", values.at(n) < 1e5 ? 3 : 0, values.at(n));
      else
        std::printf(" %10s", "-");
    }
    if (values.size() > 1) std::printf(" %9.2f", growth(values));
    std::printf("\n");
    std::fflush(stdout);
  }

  bool heavy_;
  int passes_;
  std::map<int, Boxes<S>> boxes_;
  std::map<int, double> first_;
  std::map<int, std::pair<std::size_t, std::uint64_t>> sums_;
};

template <class S, class Method>
auto listing(const Method& method) {
  return [method](const Boxes<S>& boxes) -> List {
    List pairs;
    method(boxes, [&](int i, int j) { pairs.push_back({i, j}); });
    return pairs;
  };
}

template <class S>
void race(bool heavy, int passes) {
  Race<S> r(heavy, passes);
#ifdef ISECT_PEERS
  if constexpr (std::is_same_v<S, float>) peers::all_pairs(r);
#endif
  r.row("overlapping_pairs", 1'000'000, [](const Boxes<S>& boxes) { return overlapping_pairs(boxes); });
  r.row("all_pairs::grid", heavy ? 100'000 : 1'000'000,
        listing<S>([](const auto& boxes, const auto& report) { all_pairs::grid(boxes, report); }));
  r.row("all_pairs::sweep_and_prune", 100'000,
        listing<S>([](const auto& boxes, const auto& report) { all_pairs::sweep_and_prune(boxes, report); }));
  r.row("all_pairs::brute_force", 10'000,
        listing<S>([](const auto& boxes, const auto& report) { all_pairs::brute_force(boxes, report); }));
  r.pairs();
}

}  // namespace

/// all_pairs_speed [passes], 3 by default.
int main(int argc, char** argv) {
  const int passes = argc > 1 ? std::atoi(argv[1]) : 3;
  if (argc > 2 || passes < 1) {
    std::fprintf(stderr, "usage: %s [passes]\n", argv[0]);
    return 2;
  }
  std::printf("compiler %s\nflags    %s\ncpu      %s\n", __VERSION__, ISECT_FLAGS, cpu().c_str());
  race<float>(false, passes);
  race<float>(true, passes);
  race<double>(false, passes);
  race<double>(true, passes);
}
