// Brute force: each pair is tested once.

#include <fmt/format.h>

#include <algorithm>

#include <isect/many/all_pairs.h>
#include "lessons/collision/telling.h"

namespace isect::lessons::collision_lesson {

using namespace viz;

namespace {

class DoubleLoop : Teller {
 public:
  DoubleLoop(const Boxes& boxes, const Frame& frame)
      : Teller(boxes, frame, "brute force",
               {"for i ← 0 to n − 1",                // 0
                "    for j ← i + 1 to n − 1",        // 1
                "        if boxes i and j overlap",  // 2
                "            report i, j"}) {}       // 3

  Walk tell() {
    const auto n = static_cast<double>(boxes_.size());
    add("loop", "Every pair once", 1,
        "The note starts *j* at *i*, which tests each box against itself. It must start at *i* + 1.\n"
        "That is O(*n*^2), provided that each test is O(1).",
        fmt::format("*n* (*n* − 1) / 2 = {} tests", n * (n - 1) / 2))
        .question =
        which_count(fmt::format("How many tests does the double loop take for {} boxes?", n), n * (n - 1) / 2,
                    {{n * (n + 1) / 2, "That starts *j* at *i*, so it tests each box with itself, too."},
                     {n * (n - 1), "That counts each pair twice."},
                     {n * n, "That counts each pair twice, and each box with itself."}},
                    fmt::format("Pairing each box with every other gives {} · {} = {}, which counts each pair twice. "
                                "Half of it is {}.",
                                n, n - 1, n * (n - 1), n * (n - 1) / 2));
    Record<all_pairs::Event<2>> record;
    all_pairs::brute_force(
        boxes_, [](int, int) {}, record);
    std::vector<all_pairs::Tested> tests;
    for (const auto& event : record.events)
      if (const auto* e = std::get_if<all_pairs::Tested>(&event)) tests.push_back(*e);
    for (Test test = tests.cbegin(); test != tests.cend();) test = told(test, tests.cend());
    const int found = static_cast<int>(drawn_.found.size());
    total(0, 2 * found < tests_ ? fmt::format("Of {}, {} found nothing. A better way should not run them at all.",
                                              plural(tests_, "test"), tests_ - found)
                                : fmt::format("Here {} of {} found a pair. Where few of many boxes overlap, nearly all "
                                              "find nothing.",
                                              found, plural(tests_, "test")));
    return std::move(script_.walk());
  }

 private:
  using Test = std::vector<all_pairs::Tested>::const_iterator;

  /// One step for this test, or for all that a box fails in a row. Returns the next test.
  Test told(Test test, Test end) {
    const auto other = std::find_if(test, end, [&](const auto& t) { return t.i != test->i || t.overlap; });
    if (other - test < 2) {
      tested(test->i, test->j, test->overlap, 3, 2);
      return test + 1;
    }
    std::vector<int> others;
    for (auto t = test; t != other; ++t) others.push_back(t->j);
    apart(test->i, others, 2);
    return other;
  }
};

}  // namespace

Walk double_loop(const Boxes& boxes, const Frame& frame) { return DoubleLoop(boxes, frame).tell(); }

}  // namespace isect::lessons::collision_lesson
