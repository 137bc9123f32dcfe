// A ray through the hierarchy: the nearer child first, and what lies beyond the closest hit is pruned unseen.

#include <fmt/format.h>

#include <isect/many/bvh_ray.h>
#include "lessons/hierarchy/changes.h"
#include "lessons/hierarchy/tree.h"
#include "lessons/shared/digits.h"
#include "lessons/shared/plural.h"
#include "lessons/shared/questions.h"

namespace isect::lessons::hierarchy_lesson {

using namespace viz;

namespace {

using Visited = bvh_ray::Visited<double>;
using bvh_ray::Pruned;
using Tested = bvh_ray::Tested<double>;
using Closer = bvh_ray::Closer<double>;
using Events = std::vector<bvh_ray::Event<double>>;

class Shooting {
 public:
  Shooting(Tree tree, const Ray<double, 2>& ray)
      : ray_(ray),
        tree_(std::move(tree)),
        script_({"Lecture note, bounding volume hierarchies; Kay and Kajiya, SIGGRAPH (1986)",
                 fmt::format("A ray through {} boxes in nested boxes, and their tree.", tree_.boxes.size()),
                 {"push the root, if the ray meets its box",                  // 0
                  "pop a node; if it lies beyond the closest hit: prune it",  // 1
                  "leaf: test what it holds, keep the closest hit",           // 2
                  "inner node: push the children it meets, the nearer last",  // 3
                  "return the closest hit"},                                  // 4
                 "a ray"}) {
    drawn_.states.assign(static_cast<std::size_t>(tree_.size()), State::unseen);
    drawn_.role = Role::second;
  }

  Walk tell() {
    script_.value("*n*", static_cast<double>(tree_.boxes.size()));
    set(0, State::waiting);
    add("ray", "Which box is hit first?", 0,
        "Without a hierarchy the ray is tested against each box. With it, one node may rule out all below it.");
    Record<bvh_ray::Event<double>> record;
    closest_ = closest_hit(
        tree_.bvh, ray_,
        [&](int i) -> std::optional<double> {
          const std::optional<Interval<double>> part = intersect(ray_, tree_.box(i));
          if (!part) return {};
          return part->lo;
        },
        record);
    const Events& all = record.events;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (const auto* e = std::get_if<Visited>(&all[i])) visit(*e, all, i);
      if (const auto* e = std::get_if<Pruned>(&all[i]))
        if (e->why == bvh_ray::Why::farther) farther(*e);
    }
    if (all.size() == 1) rule_out(0), ++asked_;
    finish();
    return std::move(script_.walk());
  }

 private:
  void set(int node, State state) { drawn_.states[node] = state; }
  void rule_out(int node) { set(node, State::pruned), ruled_out_ += static_cast<int>(tree_.below(node).size()); }

  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption) {
    changes_.tell(script_, "node tests", asked_, "tests");
    changes_.tell(script_, "box tests", tested_, "tests");
    changes_.tell(script_, "ruled out", ruled_out_, {}, Role::miss);
    Step& step = script_.add(slug, title, line, caption);
    step.scene = picture(drawn_);
    return step;
  }

  Scene picture(const Drawn& drawn) const {
    Scene scene;
    scene.items = nested(tree_, drawn);
    const Vec3 o = flat(ray_.origin), d = flat(ray_.direction);
    const Vec2 centre = (tree_.node(0).box.lo + tree_.node(0).box.hi) / 2;
    const double unit = tree_.place.unit, reach = std::max(5.5 * unit, (centre - ray_.origin).norm() + 2 * unit),
                 length = d.norm() > 0 ? reach / d.norm() : 0;
    scene.items.push_back(Arrow{o, o + length * d, Role::first});
    scene.items.push_back(Dot{o, Mark::disc, Role::first});
    scene.items.push_back(Label{o, "**o**", Role::first});
    if (hit_) scene.items.push_back(Dot{flat(ray_.at(*hit_)), Mark::disc, Role::hit});
    for (const Item& item : branches(tree_, drawn)) scene.items.push_back(item);
    scene.handles = {{"p", Handle::Kind::point, middle(tree_.box(0)), Vec3::Zero(), Role::second},
                     {"o", Handle::Kind::point, o, Vec3::Zero(), Role::first},
                     {"d", Handle::Kind::vector, o + d, o, Role::first}};
    add_handles_of_others(tree_.boxes, scene);
    return scene;
  }

  /// A node with what follows from it, up to the next node that is taken from the stack.
  void visit(const Visited& e, const Events& all, std::size_t i) {
    for (State& s : drawn_.states)
      if (s == State::current) s = State::seen;
    set(e.node, State::current);
    if (e.node == 0) ++asked_;
    const BvhNode<double, 2>& node = tree_.node(e.node);
    std::vector<int> missed, hits;
    for (std::size_t k = i + 1; k < all.size(); ++k) {
      if (std::get_if<Visited>(&all[k])) break;
      if (const auto* t = std::get_if<Tested>(&all[k])) ++tested_, t->t ? hits.push_back(t->primitive) : void();
      if (const auto* c = std::get_if<Closer>(&all[k])) hit_ = c->t, drawn_.hits = {c->primitive};
      const auto* pruned = std::get_if<Pruned>(&all[k]);
      if (pruned && pruned->why == bvh_ray::Why::farther) break;
      if (pruned) missed.push_back(pruned->node), rule_out(pruned->node);
    }
    if (node.leaf()) {
      leaf(node, hits);
      return;
    }
    asked_ += 2;
    for (const int child : {node.first, node.first + 1})
      if (drawn_.states[child] == State::unseen) set(child, State::waiting);
    inner(node, missed);
  }

  void leaf(const BvhNode<double, 2>& node, const std::vector<int>& hits) {
    ++number_;
    Step& step = add(fmt::format("leaf-{}", number_), fmt::format("Node {}: a leaf", number_), 2,
                     hits.empty() ? fmt::format("The leaf holds {}, and the ray misses {}.", plural(node.count, "box"),
                                                node.count == 1 ? "it" : "them")
                                  : fmt::format("The ray meets box {}. The closest hit so far is box {}, at *t* = {}.",
                                                fmt::join(hits, " and box "), drawn_.hits.front(), shown(*hit_)));
    step.decides = true;
  }

  void inner(const BvhNode<double, 2>& node, const std::vector<int>& missed) {
    ++number_;
    Step& step = add(fmt::format("open-{}", number_), fmt::format("Node {}: open it", number_), 3,
                     missed.empty()
                         ? "The ray meets both children. The nearer one is opened first: its hits may prune the other."
                     : missed.size() == 1 ? "The ray misses one child: all below it is ruled out by one test."
                                          : "The ray meets the node, but neither child. Both are ruled out.");
    step.decides = true;
    if (asked_question_) return;
    asked_question_ = true;
    step.question =
        which_count(how_many(node), 2 - static_cast<double>(missed.size()),
                    {{0, "The ray meets the box of at least one."},
                     {1, missed.empty() ? "The ray meets the other box, too." : "The ray misses both boxes."},
                     {2, "The ray misses at least one of the boxes."}},
                    missed.empty()       ? "The ray meets the boxes of both."
                    : missed.size() == 1 ? "The ray meets the box of one, and misses the other's."
                                         : "The ray misses the boxes of both.");
    Drawn asked = drawn_;
    for (const int child : {node.first, node.first + 1}) asked.states[child] = State::waiting;
    step.question->over = picture(asked);
    give_before(script_.walk(), {"node tests", "box tests", "ruled out"});
  }

  /// The question, with numbers that suffice to answer it.
  std::string how_many(const BvhNode<double, 2>& node) const {
    const auto &a = tree_.node(node.first).box, &b = tree_.node(node.first + 1).box;
    return fmt::format(
        "The ray is {} + *t* {}. One child's box reaches from {} to {}, the other's from {} to {}. How many of the two "
        "children does it meet?",
        coordinates(ray_.origin), coordinates(ray_.direction), coordinates(a.lo), coordinates(a.hi), coordinates(b.lo),
        coordinates(b.hi));
  }

  void farther(const Pruned& e) {
    for (State& s : drawn_.states)
      if (s == State::current) s = State::seen;
    rule_out(e.node);
    ++number_;
    add(fmt::format("farther-{}", number_), fmt::format("Node {}: beyond the closest hit", number_), 1,
        "The ray enters this box only after the closest hit. Nothing in it can be closer, so it is pruned.")
        .decides = true;
  }

  void finish() {
    for (State& s : drawn_.states)
      if (s == State::current) s = State::seen;
    const bool root_missed = drawn_.states[0] == State::pruned;
    script_.settle(closest_ ? Verdict::Kind::yes : Verdict::Kind::no,
                   closest_ ? fmt::format("box {} at *t* = {}", closest_->primitive, shown(closest_->t))
                            : std::string("no box is hit"));
    add("result", closest_ ? "The closest hit" : "No hit", root_missed ? 0 : 4,
        root_missed
            ? "The ray misses the outermost box, so it misses all. One test was enough: trivial reject."
            : fmt::format(
                  "{} of nodes and {} of boxes. Of {} boxes, {} {} ruled out without a test.\n"
                  "Large rings mark what was ruled out. With so few boxes the gain is small; it grows with *n*.",
                  plural(asked_, "test"), tested_, tree_.boxes.size(), ruled_out_, ruled_out_ == 1 ? "was" : "were"));
  }

  const Ray<double, 2> ray_;
  const Tree tree_;
  Script script_;
  Changes changes_;
  Drawn drawn_;
  std::optional<BvhHit<double>> closest_;
  std::optional<double> hit_;
  int asked_ = 0, tested_ = 0, ruled_out_ = 0, number_ = 0;
  bool asked_question_ = false;
};

}  // namespace

Walk ray(const Boxes& boxes, const Ray<double, 2>& ray, const TreePlace& place) {
  return Shooting(Tree(boxes, place), ray).tell();
}
Walk ray(const Boxes& boxes, const Ray<double, 2>& ray) {
  return Shooting(Tree(boxes, place_beside(boxes)), ray).tell();
}

}  // namespace isect::lessons::hierarchy_lesson
