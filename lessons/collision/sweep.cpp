// Sweep and prune: only boxes that a sweeping plane meets together are tested.

#include <fmt/format.h>

#include <isect/many/all_pairs.h>
#include "lessons/collision/telling.h"
#include "lessons/shared/order_question.h"

namespace isect::lessons::collision_lesson {

using namespace viz;

namespace {

class Sweep : Teller {
 public:
  Sweep(const Boxes& boxes, const Frame& frame)
      : Teller(boxes, frame, "sweep and prune",
               {"sort the boxes by their lower ends",                      // 0
                "for each box b",                                          // 1
                "    remove what ended before b begins",                   // 2
                "    for each active a: if a and b overlap: report a, b",  // 3
                "    add b to the active boxes"}) {}                       // 4

  Walk tell() {
    Record<all_pairs::Event<2>> record;
    all_pairs::sweep_and_prune(
        boxes_, [](int, int) {}, record);
    int box = 0;
    for (const auto& event : record.events) {
      if (const auto* e = std::get_if<all_pairs::Axis>(&event)) axis_ = e->axis, begin();
      if (const auto* e = std::get_if<all_pairs::Leaves>(&event))
        std::erase(drawn_.active, e->box), left_.push_back(e->box);
      if (const auto* e = std::get_if<all_pairs::Tested>(&event)) {
        enter(box);
        tested(e->i, e->j, e->overlap, 3, 3);
      }
      if (const auto* e = std::get_if<all_pairs::Enters>(&event)) {
        enter(box);
        box = e->box, fresh_ = true;
      }
    }
    enter(box);
    total(1, tests_ < pairs() ? "Only boxes whose intervals on the axis meet were tested. The other pairs took no test."
                              : "On this axis all intervals meet, so every pair was tested: the sweep saved nothing.");
    return std::move(script_.walk());
  }

 private:
  int pairs() const { return static_cast<int>(boxes_.size() * (boxes_.size() - 1) / 2); }

  void begin() {
    add("sort", "Sort along an axis", 0,
        axis_ == 0 ? "A plane will sweep to the right. Boxes that it never meets at the same time cannot overlap.\n"
                     "In the next frame little has moved, so the order is nearly sorted already: temporal coherence."
                   : "The boxes spread most along *y*, so the sweep runs along it.");
    drawn_.sweeping = axis_ == 0;
  }

  /// The plane reaches a box; shown after the boxes that it leaves.
  void enter(int box) {
    if (!fresh_) return;
    fresh_ = false;
    drawn_.i = drawn_.j = -1;
    drawn_.sweep = boxes_[box].lo[axis_];
    drawn_.active.push_back(box);
    std::string gone;
    for (std::size_t k = 0; k < left_.size(); ++k)
      gone += fmt::format("{}{}",
                          k == 0                 ? (left_.size() == 1 ? "box " : "boxes ")
                          : k + 1 < left_.size() ? ", "
                                                 : " and ",
                          left_[k]);
    left_.clear();
    const auto active = static_cast<double>(drawn_.active.size());
    script_.value("active", active);
    ++entered_;
    Step& step = add(fmt::format("enter-{}", box), fmt::format("Box {} begins", box), gone.empty() ? 4 : 2,
                     fmt::format("The plane meets {} now: {} active.{}", plural(static_cast<long long>(active), "box"),
                                 active == 1 ? "it is" : "they are", gone.empty() ? "" : " It has left " + gone + "."));
    if (entered_ == 1) ask_order(step);
    if (gone.empty() || asked_) return;
    asked_ = true;
    step.question =
        which_count(fmt::format("Next is box {}. How many boxes are active then, with it?", box), active,
                    {{static_cast<double>(entered_), "That counts every box that has begun, but some have ended."},
                     {active > 1 ? active - 1 : active + 2,
                      active > 1 ? "That leaves out the new box." : "That counts boxes that have ended."},
                     {active + 1, "That counts a box that has ended."}},
                    "Boxes that have begun and not yet ended meet the plane.");
    keep_picture(script_.walk());
    give_before(script_.walk(), {"active", "tests", "pairs"});
    for (Item& item : step.question->over->items)  // the plane has gone on
      if (Line* line = std::get_if<Line>(&item); line && line->pen == Pen::highlight)
        line->from[axis_] = line->to[axis_] = drawn_.sweep;
  }

  /// Asks, before the first box, for the order in which the plane meets them.
  void ask_order(Step& step) {
    std::vector<InOrder> begins;
    std::vector<double> ends, numbers;
    std::vector<Value> given;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      begins.push_back({fmt::format("box {}", i), boxes_[i].lo[axis_]});
      ends.push_back(boxes_[i].hi[axis_]), numbers.push_back(static_cast<double>(i));
      given.push_back({fmt::format("lower end of box {}", i), boxes_[i].lo[axis_], "length"});
    }
    step.question = which_order(
        fmt::format("The plane sweeps along {}. In which order do the boxes begin?", axis_ == 0 ? "*x*" : "*y*"),
        begins,
        {{numbers, "That is the order of their numbers."},
         {ends, "That is the order in which the boxes end. They are sorted by their lower ends."}},
        "The plane meets a box first at its lower end, so the boxes are sorted by these.");
    if (!step.question) return;
    step.question->given = std::move(given);
    keep_picture(script_.walk());
  }

  int axis_ = 0;
  int entered_ = 0;
  bool fresh_ = false, asked_ = false;
  std::vector<int> left_;
};

}  // namespace

Walk sweep(const Boxes& boxes, const Frame& frame) { return Sweep(boxes, frame).tell(); }

}  // namespace isect::lessons::collision_lesson
