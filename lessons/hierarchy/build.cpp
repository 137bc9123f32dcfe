// Building: a box around all, split at the cheapest of a few cuts, and each part again.

#include <fmt/format.h>

#include "lessons/hierarchy/large.h"
#include "lessons/hierarchy/splits.h"
#include "lessons/shared/order_question.h"
#include "lessons/shared/plural.h"
#include "lessons/shared/questions.h"
#include "lessons/shared/script.h"

namespace isect::lessons::hierarchy_lesson {

using namespace viz;

namespace {

class Building {
 public:
  explicit Building(Tree tree)
      : tree_(std::move(tree)),
        script_({"Lecture note, bounding volume hierarchies; Goldsmith and Salmon, IEEE CG&A 7 (1987); Wald, "
                 "Interactive Ray Tracing (2007)",
                 fmt::format("{} boxes in nested boxes, and their tree.", tree_.boxes.size()),
                 {"box ← the smallest around all primitives",                 // 0
                  "try 15 cuts on the axis of widest spread; take the best",  // 1
                  "if at most 3 are left and no split pays: make a leaf",     // 2
                  "else build both parts in the same way"},                   // 3
                 "building"}) {
    drawn_.states.assign(static_cast<std::size_t>(tree_.size()), State::hidden);
  }

  Walk tell() {
    set(0, State::current);
    script_.value("*n*", static_cast<double>(tree_.boxes.size()));
    add("root", "One box around all", 0,
        "The root's box contains all objects. They are split, and each part gets its own box.", nullptr);
    Record<bvh::Event<double>> record;
    build_bvh(tree_.boxes, options, record);
    int number = 0;
    for (const auto& event : record.events)
      if (const auto* split = std::get_if<bvh::Split<double>>(&event)) cut(*split, ++number);
    for (State& s : drawn_.states) s = State::seen;
    if (const std::optional<LargeBox> large = large_box(tree_)) tell_large(*large);
    done();
    return std::move(script_.walk());
  }

 private:
  void set(int node, State state) { drawn_.states[node] = state; }

  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption,
            const bvh::Split<double>* split) {
    Step& step = script_.add(slug, title, line, caption);
    Scene& scene = step.scene;
    scene.items = nested(tree_, drawn_);
    if (split) {
      const Aabb<double, 2>& box = tree_.node(split->node).box;
      Vec3 from = flat(box.lo), to = flat(box.hi);
      from[split->axis] = to[split->axis] = split->at;
      scene.items.push_back(Line{from, to, Role::text, Pen::thick});
    }
    for (const Item& item : branches(tree_, drawn_)) scene.items.push_back(item);
    scene.handles = {{"p", Handle::Kind::point, middle(tree_.box(0)), Vec3::Zero(), Role::second}};
    add_handles_of_others(tree_.boxes, scene);
    return step;
  }

  /// Why a part is split although that costs more than a leaf.
  static std::string too_many(const bvh::Split<double>& split) {
    const int count = split.left + split.right;
    return count > options.largest_leaf
               ? fmt::format("{} boxes are more than the {} that a leaf may hold. ", count, options.largest_leaf)
               : "";
  }

  static const char* name_of(int axis) { return axis == 0 ? "*x*" : "*y*"; }

  static std::string parts(const bvh::Split<double>& split) {
    return fmt::format("{} on one side of it, {} on the other.", plural(split.left, "centre"),
                       plural(split.right, "centre"));
  }

  /// How the first split is found.
  static std::string tried(const bvh::Split<double>& split) {
    if (split.median) return halved(split);
    return fmt::format("Tried are 15 cuts along {}, where the centres spread most. The cheapest is taken: ",
                       name_of(split.axis)) +
           parts(split);
  }
  static std::string in_the_same_way(const bvh::Split<double>& split) {
    return split.median ? halved(split) : "The part is split in the same way: " + parts(split);
  }
  static std::string halved(const bvh::Split<double>& split) {
    return fmt::format("No cut is tried here: they are halved by number, {} and {}.", split.left, split.right);
  }

  void cut(const bvh::Split<double>& split, int number) {
    const int first = tree_.node(split.node).first;
    for (State& s : drawn_.states)
      if (s == State::current) s = State::seen;
    set(split.node, State::current), set(first, State::waiting), set(first + 1, State::waiting);
    const char* const axis = name_of(split.axis);
    Step& step =
        add(fmt::format("cut-{}", number), fmt::format("Split {}: along {}", number, axis), number == 1 ? 1 : 3,
            number == 1
                ? "The surface-area heuristic: the chance that a random line meets a box is proportional to its "
                  "surface, in the plane its perimeter *P*.\n" +
                      fmt::format(
                          "A visit costs {}, a test 1; a leaf costs its number of boxes, *n*. L and R mark the parts. ",
                          options.visit) +
                      tried(split)
                : too_many(split) + in_the_same_way(split),
            &split);
    const auto perimeter = [&](int node) { return shown(2 * half_perimeter(tree_.node(node).box)); };
    const double cost =
        cost_of(tree_.node(split.node).box, tree_.node(first).box, split.left, tree_.node(first + 1).box, split.right);
    step.formula = fmt::format("cost = {} + (*P*_L *n*_L + *P*_R *n*_R) / *P* = {} + ({} · {} + {} · {}) / {} = {}",
                               options.visit, options.visit, perimeter(first), split.left, perimeter(first + 1),
                               split.right, perimeter(split.node), shown(cost));
    if (number > 1) return ask_order(split, step);
    step.decides = true;
    const Vec2 size = tree_.node(0).box.hi - tree_.node(0).box.lo;
    step.question = Question{"Along which axis are the boxes split?",
                             {"*x*", "*y*"},
                             split.axis,
                             fmt::format("Together they span {} by {}; their centres spread most along {}.",
                                         shown(size.x()), shown(size.y()), axis)};
    Vec2 lo = Vec2::Constant(INFINITY), hi = -lo;
    for (const auto& box : tree_.boxes) {
      const Vec2 centre = (box.lo + box.hi) / 2;
      lo = lo.cwiseMin(centre), hi = hi.cwiseMax(centre);
    }
    step.question->given = {{"spread of centres on *x*", hi.x() - lo.x(), "length"},
                            {"spread of centres on *y*", hi.y() - lo.y(), "length"}};
    keep_picture(script_.walk());
    if (!split.median) untried(split, cost);
  }

  /// Asks, at the first split with few boxes, for the order of their centres.
  void ask_order(const bvh::Split<double>& split, Step& step) {
    if (order_asked_ || split.left + split.right > 8) return;
    const std::string axis = name_of(split.axis);
    std::vector<InOrder> boxes;
    std::vector<double> numbers, lower, across;
    std::vector<Value> given;
    for (const int i : tree_.below(split.node)) {
      const Aabb<double, 2>& box = tree_.box(i);
      const Vec2 centre = (box.lo + box.hi) / 2;
      boxes.push_back({fmt::format("box {}", i), centre[split.axis]});
      given.push_back({fmt::format("centre of box {} on {}", i, axis), centre[split.axis], "length"});
      numbers.push_back(i), lower.push_back(box.lo[split.axis]), across.push_back(centre[1 - split.axis]);
    }
    step.question = which_order(
        fmt::format("A part is split along {}. In which order do the centres of its boxes come there, from less to "
                    "more?",
                    axis),
        boxes,
        {{numbers, "That is the order of their numbers."},
         {across, fmt::format("That is their order along {}.", name_of(1 - split.axis))},
         {lower, "That is the order of their lower ends. Their centres are sorted."}},
        "A cut parts the boxes by their centres: those before it, and those after it.");
    if (!step.question) return;
    order_asked_ = true;
    step.question->given = std::move(given);
    keep_picture(script_.walk());
  }

  /// Adds a step about the cheapest split of all boxes, where the builder has not tried it.
  void untried(const bvh::Split<double>& chosen, double cost) {
    const std::optional<PossibleSplit> best = cheapest_split(tree_.boxes);
    if (!best || !(best->cost < cost) || shown(best->cost) == shown(cost)) return;
    const bvh::Split<double> drawn = {0, best->axis, best->at, best->left, best->right, false};
    const std::string where = best->axis == chosen.axis
                                  ? fmt::format("Between the cuts tried along {}", name_of(best->axis))
                                  : fmt::format("Along {}, where no cut is tried", name_of(best->axis));
    add("untried", "A cheaper split", 1,
        fmt::format("{}, a split would cost {} in place of {}: {}\n"
                    "It would save {:.2g} %. Trying few cuts keeps the construction fast.",
                    where, shown(best->cost), shown(cost), parts(drawn), 100 * (cost - best->cost) / cost),
        &drawn);
  }

  void tell_large(const LargeBox& large) {
    script_.value("expected cost", large.cost, "tests", Role::second);
    script_.value(fmt::format("expected cost, box {} apart", large.box), large.apart, "tests", Role::hit);
    add("large", "A box nearly as large as all", 1, told_of(large), nullptr).question = asked_of(large);
  }

  void done() {
    const BvhStatistics s = statistics(tree_.bvh);
    script_.value("nodes", s.nodes);
    script_.value("leaves", s.leaves);
    script_.value("depth", s.depth);
    script_.settle(Verdict::Kind::yes, fmt::format("{} nodes, depth {}", s.nodes, s.depth));
    const auto n = static_cast<double>(tree_.boxes.size());
    add("done", "The hierarchy", 2,
        fmt::format("{} here; *n* boxes make at most 2*n* − 1 nodes. Each level takes O(*n*) to build.\n"
                    "Even splits give about lg *n* levels, but nothing ensures even splits.",
                    s.least_leaf == s.largest_leaf
                        ? "Each leaf holds " + plural(s.largest_leaf, "box")
                        : fmt::format("Leaves hold {} to {}", s.least_leaf, plural(s.largest_leaf, "box"))),
        nullptr)
        .question = which_count(fmt::format("How many nodes can a tree over {} boxes have at most?", n), 2 * n - 1,
                                {{n, "That counts the leaves alone."},
                                 {2 * n, "That counts as many inner nodes as leaves."},
                                 {n * (n - 1) / 2, "That counts the pairs of boxes."}},
                                "Each inner node has two children, and each node but the root is a child. So a tree "
                                "with *n* leaves has *n* − 1 inner nodes.");
  }

  const Tree tree_;
  Script script_;
  Drawn drawn_;
  bool order_asked_ = false;
};

}  // namespace

Walk build(const Boxes& boxes, const TreePlace& place) { return Building(Tree(boxes, place)).tell(); }
Walk build(const Boxes& boxes) { return build(boxes, place_beside(boxes)); }

}  // namespace isect::lessons::hierarchy_lesson
