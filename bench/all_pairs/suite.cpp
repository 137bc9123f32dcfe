// All overlapping pairs of n boxes: time against n of every method. A time includes building whatever is built, and
// listing each pair once.

#include <isect/many/all_pairs.h>

#include <stdexcept>

#include <isect/many/bvh_pairs.h>
#include <isect/many/overlapping_pairs.h>
#include "bench/growth.h"
#include "bench/growth_shapes.h"
#include "bench/session.h"
#ifdef ISECT_PEERS
#include "bench/all_pairs/peers.h"
#endif

namespace isect::bench::all_pairs_suite {
namespace {

using Boxes = std::vector<Aabb<float, 3>>;

/// The number of pairs and a sum that hardly any other set has.
struct Print {
  std::size_t count = 0;
  std::uint64_t sum = 0;
  void add(int i, int j) {
    if (i > j) std::swap(i, j);
    ++count;
    sum += (static_cast<std::uint64_t>(i) << 32 | static_cast<std::uint64_t>(j)) * 0x9E3779B97F4A7C15u >> 20;
  }
  friend bool operator==(const Print&, const Print&) = default;
};

/// One distribution of sizes.
class Race {
 public:
  Race(Session& session, bool heavy) : session_(session), test_(heavy ? "all pairs, heavy-tailed" : "all pairs") {
    for (const int n : sizes(session, 1000)) {
      boxes_.push_back(scattered_boxes<float>(n, heavy));
      prints_.push_back(print(boxes_.back(), [](const Boxes& b) { return overlapping_pairs(b); }));
    }
  }
  /// find(boxes) returns the pairs. Throws std::logic_error where a method of isect finds other pairs than the default.
  template <class Find>
  void add(const char* method, int most, const Find& find, const char* library = "isect") {
    session_.progress(test_ + ", " + method);
    Grown grown(test_, method, "all pairs", library);
    for (std::size_t k = 0; k < boxes_.size(); ++k) {
      if (static_cast<int>(boxes_[k].size()) > most) continue;
      if (std::string(library) == "isect" && print(boxes_[k], find) != prints_[k])
        throw std::logic_error(test_ + ": " + method + " finds other pairs than the default");
      grown.add(static_cast<double>(boxes_[k].size()), least_time(session_, [&] { return find(boxes_[k]); }));
    }
    grown.report(session_);
  }

 private:
  template <class Find>
  static Print print(const Boxes& boxes, const Find& find) {
    Print p;
    for (const auto& [i, j] : find(boxes)) p.add(i, j);
    return p;
  }

  Session& session_;
  std::string test_;
  std::vector<Boxes> boxes_;
  std::vector<Print> prints_;
};

/// Turns a method that reports pairs into one that lists them.
template <class Method>
auto listing(const Method& method) {
  return [method](const Boxes& boxes) {
    std::vector<IndexPair> pairs;
    method(boxes, [&](int i, int j) { pairs.push_back({i, j}); });
    return pairs;
  };
}

void race(Session& session, bool heavy) {
  Race r(session, heavy);
  r.add("brute force", 10'000,
        listing([](const auto& boxes, const auto& report) { all_pairs::brute_force(boxes, report); }));
  r.add("sweep and prune", 100'000,
        listing([](const auto& boxes, const auto& report) { all_pairs::sweep_and_prune(boxes, report); }));
  r.add("grid", heavy ? 100'000 : 1'000'000,
        listing([](const auto& boxes, const auto& report) { all_pairs::grid(boxes, report); }));
  r.add("bvh", 1'000'000, [](const Boxes& boxes) { return overlapping_pairs(build_bvh(boxes), boxes); });
  r.add("overlapping_pairs", 1'000'000, [](const Boxes& boxes) { return overlapping_pairs(boxes); });
#ifdef ISECT_PEERS
  peers::all_pairs_growth(r);
#endif
}

}  // namespace

void measure(Session& session) {
  session.aim(
      {.work = "all overlapping pairs of like boxes, 10^6",
       .kind = Target::growth,
       .test = "all pairs",
       .ours = "overlapping_pairs",
       .theirs = "Embree",
       .n = 1e6,
       .at_most = 0.2,
       .limit = "Two fifths of it are tests of boxes in neighbouring cells, a third sorts a million boxes by size and "
                "cell, and the rest finds sizes and writes the pairs."});
  session.aim({.work = "all overlapping pairs, some boxes large, 10^6",
               .kind = Target::growth,
               .test = "all pairs, heavy-tailed",
               .ours = "overlapping_pairs",
               .theirs = "Embree",
               .n = 1e6,
               .at_most = 0.7});
  race(session, false);
  race(session, true);
}

}  // namespace isect::bench::all_pairs_suite
