// Building: a box around all, cut where it costs least, and each part again.

#include <fmt/format.h>

#include "lessons/hierarchy/tree.h"
#include "lessons/shared/script.h"

namespace isect::lessons::hierarchy_lesson {

using namespace viz;

namespace {

class Building {
 public:
  explicit Building(const Vec3& p)
      : p_(p),
        tree_(scattered(p)),
        script_({"Note, N09; Goldsmith and Salmon (1987), Wald (2007)",
                 fmt::format("{} boxes in nested boxes, and their tree.", tree_.boxes.size()),
                 {"box ← the smallest around all primitives",              // 0
                  "cut them along the widest axis, where it costs least",  // 1
                  "if no cut pays: make a leaf",                           // 2
                  "else build both parts in the same way"},                // 3
                 "building"}) {
    drawn_.states.assign(static_cast<std::size_t>(tree_.size()), State::hidden);
  }

  Walk tell() {
    set(0, State::current);
    script_.value("*n*", static_cast<double>(tree_.boxes.size()));
    add("root", "One box around all", 0,
        "Bounding volumes nest. The outermost one holds all objects: what misses it misses them all.", nullptr);
    Record<bvh::Event<double>> record;
    build_bvh(tree_.boxes, options, record);
    int number = 0;
    for (const auto& event : record.events)
      if (const auto* split = std::get_if<bvh::Split<double>>(&event)) cut(*split, ++number);
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
    for (const Item& item : branches(tree_, drawn_, {1.25, -1.5}, {5, 1.625})) scene.items.push_back(item);
    scene.handles = {{"p", Handle::Kind::point, p_, Vec3::Zero(), Role::second}};
    return step;
  }

  void cut(const bvh::Split<double>& split, int number) {
    const int first = tree_.node(split.node).first;
    for (State& s : drawn_.states)
      if (s == State::current) s = State::seen;
    set(split.node, State::current), set(first, State::waiting), set(first + 1, State::waiting);
    const char* const axis = split.axis == 0 ? "*x*" : "*y*";
    Step& step = add(fmt::format("cut-{}", number), fmt::format("Cut along {}", axis), number == 1 ? 1 : 3,
                     number == 1 ? fmt::format("Centres spread most along {}. Of the cuts tried the cheapest is taken: "
                                               "small boxes, with many objects in the smaller one.",
                                               axis)
                                 : fmt::format("The part is cut in the same way: {} go one way, {} the other.",
                                               split.left, split.right),
                     &split);
    step.formula = fmt::format("{} + {} boxes", split.left, split.right);
    if (number > 1) return;
    step.decides = true;
    const Vec2 size = tree_.node(0).box.hi - tree_.node(0).box.lo;
    step.question = Question{"Along which axis are the boxes cut?",
                             {"*x*", "*y*"},
                             split.axis,
                             fmt::format("All reach over {} by {}; their centres spread most along {}.",
                                         shown(size.x()), shown(size.y()), axis)};
  }

  void done() {
    for (State& s : drawn_.states) s = State::seen;
    const BvhStatistics s = statistics(tree_.bvh);
    script_.value("nodes", s.nodes);
    script_.value("leaves", s.leaves);
    script_.value("depth", s.depth);
    script_.settle(Verdict::Kind::yes, fmt::format("{} nodes, depth {}", s.nodes, s.depth));
    add("done", "The hierarchy", 2,
        fmt::format("Leaves hold {} to {} boxes here. Of *n* boxes there are at most 2*n* − 1 nodes.\n"
                    "Each level takes O(*n*) to build, and there are about lg *n* levels.",
                    s.least_leaf, s.largest_leaf),
        nullptr);
  }

  const Vec3 p_;
  const Tree tree_;
  Script script_;
  Drawn drawn_;
};

}  // namespace

Walk build(const Vec3& p) { return Building({p.x(), p.y(), 0}).tell(); }

}  // namespace isect::lessons::hierarchy_lesson
