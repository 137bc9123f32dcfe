// Pairs by a hierarchy of boxes: what misses a node misses all that is in it.

#include <fmt/format.h>

#include <isect/many/bvh_pairs.h>
#include "lessons/collision/telling.h"

namespace isect::lessons::collision_lesson {

using namespace viz;

namespace {

class Hierarchy : Teller {
 public:
  Hierarchy(const Boxes& boxes, const Frame& frame)
      : Teller(boxes, frame, "hierarchy",
               {"build a hierarchy of boxes",                   // 0
                "for two nodes a, b",                           // 1
                "    if their boxes are apart: prune",          // 2
                "    if both are leaves: test what they hold",  // 3
                "    else open one that is no leaf"}) {}        // 4

  Walk tell() {
    using namespace bvh_pairs;
    const Bvh<double, 2> bvh = build_bvh(boxes_);
    for (const BvhNode<double, 2>& node : bvh.nodes) drawn_.nodes.push_back(node.box);
    add("build", "Boxes in boxes", 0,
        "Each node's box contains all boxes below it. What misses the node misses them all.");
    drawn_.nodes.clear();
    Record<bvh_pairs::Event> record;
    report_pairs(
        bvh, boxes_, [](int, int) {}, record);
    int number = 0;
    for (const auto& event : record.events) {
      drawn_.i = drawn_.j = -1;
      if (const auto* e = std::get_if<Pruned>(&event)) {
        drawn_.compared = {bvh.nodes[e->a].box, bvh.nodes[e->b].box};
        script_.value("tests", ++tests_);
        ++number;
        add(fmt::format("prune-{}", number), fmt::format("Test {}: two nodes apart", tests_), 2,
            "Their boxes share no point: one test rules out all pairs between them.")
            .decides = true;
      }
      if (const auto* e = std::get_if<Visited>(&event)) {
        drawn_.compared = {bvh.nodes[e->a].box, bvh.nodes[e->b].box};
        script_.value("tests", ++tests_);
        const bool leaves = bvh.nodes[e->a].leaf() && bvh.nodes[e->b].leaf();
        const bool leaf = bvh.nodes[e->a].leaf() || bvh.nodes[e->b].leaf(), self = e->a == e->b;
        ++number;
        add(fmt::format("visit-{}", number),
            fmt::format("Test {}: {}", tests_, self ? "a node with itself" : "two nodes overlap"), leaves ? 3 : 4,
            self     ? leaves ? "The node is a leaf: the boxes in it are tested against each other."
                              : "A node may contain pairs. Each child is paired with itself, and both with each other."
            : leaves ? "Both are leaves: the boxes in one are tested against those in the other."
            : leaf   ? "Their boxes meet. One is a leaf, so the other one is opened."
                     : "Their boxes meet, so the wider one is opened.");
      }
      if (const auto* e = std::get_if<Tested>(&event))
        tested(std::min(e->i, e->j), std::max(e->i, e->j), e->meet, 3, 3);
    }
    drawn_.compared.clear();
    const int pairs = static_cast<int>(boxes_.size() * (boxes_.size() - 1) / 2);
    total(1, fmt::format("{} of nodes and boxes, where brute force takes {}.{}", plural(tests_, "test"), pairs,
                         tests_ >= pairs ? " So few boxes gain nothing from a hierarchy." : ""));
    return std::move(script_.walk());
  }
};

}  // namespace

Walk hierarchy(const Boxes& boxes, const Frame& frame) { return Hierarchy(boxes, frame).tell(); }

}  // namespace isect::lessons::collision_lesson
