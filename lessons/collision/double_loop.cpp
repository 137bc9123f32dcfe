// Brute force: each pair is tested once.

#include <fmt/format.h>

#include <isect/all_pairs.h>
#include "lessons/collision/telling.h"

namespace isect::lessons::collision_lesson {

using namespace viz;

namespace {

class DoubleLoop : Teller {
 public:
  explicit DoubleLoop(const Boxes& boxes)
      : Teller(boxes, "brute force",
               {"for i ← 0 to n − 1",                // 0
                "    for j ← i + 1 to n − 1",        // 1
                "        if boxes i and j overlap",  // 2
                "            report i, j"}) {}       // 3

  Walk tell() {
    add("loop", "Every pair once", 1,
        "The note lets *j* run from *i*, which tests each box with itself. It must start at *i* + 1.",
        fmt::format("*n* (*n* − 1) / 2 = {} tests", boxes_.size() * (boxes_.size() - 1) / 2));
    Record<all_pairs::Event<2>> record;
    all_pairs::brute_force(
        boxes_, [](int, int) {}, record);
    for (const auto& event : record.events)
      if (const auto* e = std::get_if<all_pairs::Tested>(&event)) tested(e->i, e->j, e->overlap, 3, 2);
    total(0, "Most tests say no. A cheaper way should not ask them at all.");
    return std::move(script_.walk());
  }
};

}  // namespace

Walk double_loop(const Boxes& boxes) { return DoubleLoop(boxes).tell(); }

}  // namespace isect::lessons::collision_lesson
