// Two hierarchies: a pair of nodes apart rules out all pairs below them.

#include <fmt/format.h>

#include <isect/many/bvh_pairs.h>
#include "lessons/hierarchy/changes.h"
#include "lessons/hierarchy/tree.h"
#include "lessons/shared/plural.h"
#include "lessons/shared/questions.h"

namespace isect::lessons::hierarchy_lesson {

using namespace viz;

namespace {

class Colliding {
 public:
  Colliding(const Boxes& boxes, const Vec3& q)
      : q_(q),
        a_(boxes),
        b_(cluster(q)),
        script_({"Lecture note, bounding volume hierarchies; Gottschalk, Lin and Manocha, OBBTree (1996)",
                 fmt::format("{} boxes of one object and {} of another, with their trees.", a_.boxes.size(),
                             b_.boxes.size()),
                 {"push the pair of both roots",                               // 0
                  "pop a pair of nodes; if their boxes are apart: prune",      // 1
                  "both are leaves: test what they hold",                      // 2
                  "else open an inner one, push its children with the other",  // 3
                  "return the pairs found"},                                   // 4
                 "two hierarchies"}) {
    drawn_a_.role = Role::second, drawn_b_.role = Role::first;
    drawn_b_.prefix = "b";
    clear();
  }

  Walk tell() {
    using bvh_pairs::Pruned, bvh_pairs::Tested, bvh_pairs::Visited;
    script_.value("pairs of boxes", static_cast<double>(a_.boxes.size() * b_.boxes.size()), "tests");
    count();
    show(0, 0, State::waiting);
    add("roots", "Two objects of many boxes", 0,
        fmt::format("{} · {} pairs of boxes might meet. Two nodes apart rule out all pairs below them.",
                    b_.boxes.size(), a_.boxes.size()));
    Record<bvh_pairs::Event> record;
    report_pairs(
        b_.bvh, b_.boxes, a_.bvh, a_.boxes, [](int, int) {}, record);
    const auto& all = record.events;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (const auto* e = std::get_if<Visited>(&all[i])) {
        ++nodes_;
        std::vector<Tested> tested;
        for (std::size_t k = i + 1; k < all.size() && std::get_if<Tested>(&all[k]); ++k)
          tested.push_back(std::get<Tested>(all[k]));
        visited(*e, tested);
      }
      if (const auto* e = std::get_if<Pruned>(&all[i])) pruned(*e);
    }
    finish();
    return std::move(script_.walk());
  }

 private:
  void clear() {
    drawn_a_.states.assign(static_cast<std::size_t>(a_.size()), State::unseen);
    drawn_b_.states.assign(static_cast<std::size_t>(b_.size()), State::unseen);
  }
  void show(int in_b, int in_a, State state) {
    clear();
    drawn_b_.states[in_b] = drawn_a_.states[in_a] = state;
  }
  void count() {
    changes_.tell(script_, "node pairs", nodes_, "tests");
    changes_.tell(script_, "box pairs", boxes_, "tests");
    changes_.tell(script_, "found", static_cast<double>(found_), {}, Role::hit);
  }

  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption) {
    Step& step = script_.add(slug, title, line, caption);
    step.scene = picture();
    return step;
  }

  Scene picture() const {
    Scene scene;
    for (const auto& [tree, drawn] : {std::pair{&a_, &drawn_a_}, {&b_, &drawn_b_}})
      for (const Item& item : nested(*tree, *drawn)) scene.items.push_back(item);
    for (const Aabb<double, 2>& box : shared_)
      scene.items.push_back(Region{.rings = {corners(box)}, .role = Role::hit});
    for (const Item& item : branches(b_, drawn_b_, {2, 0.75}, {5, 1.75})) scene.items.push_back(item);
    for (const Item& item : branches(a_, drawn_a_, {2, -1.625}, {5, -0.125})) scene.items.push_back(item);
    scene.handles = {{"p", Handle::Kind::point, middle(a_.box(0)), Vec3::Zero(), Role::second},
                     {"q", Handle::Kind::point, q_, Vec3::Zero(), Role::first}};
    add_handles_of_others(a_.boxes, scene);
    return scene;
  }

  void visited(const bvh_pairs::Visited& e, const std::vector<bvh_pairs::Tested>& tested) {
    show(e.a, e.b, State::current);
    int met = 0;
    for (const bvh_pairs::Tested& t : tested) {
      ++boxes_;
      if (!t.meet) continue;
      ++met, ++found_;
      shared_.push_back(aabb_aabb::common(b_.box(t.i), a_.box(t.j)));
    }
    count();
    const bool leaves = b_.node(e.a).leaf() && a_.node(e.b).leaf();
    Step& step =
        add(fmt::format("meet-{}", ++number_), test(leaves ? "two leaves meet" : "two nodes meet"), leaves ? 2 : 3,
            leaves ? fmt::format("Both are leaves, which hold {} of boxes. Of these, {} {}.",
                                 plural(static_cast<long long>(tested.size()), "pair"),
                                 met == 0 ? "none" : std::to_string(met), met == 1 ? "meets" : "meet")
            : b_.node(e.a).leaf() || a_.node(e.b).leaf()
                ? "Their boxes share points. One node is a leaf, so the other one is opened."
                : "Their boxes share points, so the wider node is opened.");
    step.decides = leaves;
  }

  /// The title of a test of two nodes.
  std::string test(const char* what) const { return fmt::format("Test {}: {}", nodes_, what); }

  void pruned(const bvh_pairs::Pruned& e) {
    ++nodes_;
    show(e.a, e.b, State::current);
    const Scene asking = picture();
    show(e.a, e.b, State::pruned);
    const std::size_t spared = b_.below(e.a).size() * a_.below(e.b).size();
    spared_ += spared;
    script_.value("pairs ruled out", static_cast<double>(spared_), {}, Role::miss);
    count();
    Step& step = add(fmt::format("apart-{}", ++number_), test("two nodes apart"), 1,
                     fmt::format("Their boxes share no point: one test rules out {} of boxes. Large rings mark both.",
                                 plural(static_cast<long long>(spared), "pair")));
    step.decides = true;
    if (asked_) return;
    asked_ = true;
    const auto in_b = static_cast<double>(b_.below(e.a).size()), in_a = static_cast<double>(a_.below(e.b).size());
    step.question = which_count(
        fmt::format("A node of {} and one of {} lie apart. How many pairs of boxes does that rule out?",
                    plural(static_cast<long long>(in_a), "box"), plural(static_cast<long long>(in_b), "box")),
        in_a * in_b,
        {{1, "That counts the two nodes alone, and not the boxes below them."},
         {in_a + in_b, "That adds the two numbers of boxes. Pairs take their product."},
         {static_cast<double>(a_.boxes.size() * b_.boxes.size()), "That counts all pairs of the two trees."}},
        "Each box below one node pairs with each box below the other.");
    step.question->over = asking;
  }

  void finish() {
    clear();
    const bool any = found_ > 0;
    script_.settle(any ? Verdict::Kind::yes : Verdict::Kind::no,
                   any ? fmt::format("{} pair{} meet{}", found_, found_ == 1 ? "" : "s", found_ == 1 ? "s" : "")
                       : std::string("no pair meets"));
    add("result", any ? "All pairs that meet" : "No pair meets", 4,
        fmt::format("{} of nodes and {} of boxes, where testing every pair takes {}.", plural(nodes_, "test"), boxes_,
                    a_.boxes.size() * b_.boxes.size()));
  }

  const Vec3 q_;
  const Tree a_, b_;
  Script script_;
  Changes changes_;
  Drawn drawn_a_, drawn_b_;
  int nodes_ = 0, boxes_ = 0, found_ = 0, number_ = 0;
  std::vector<Aabb<double, 2>> shared_;  ///< by pairs that meet
  std::size_t spared_ = 0;
  bool asked_ = false;
};

}  // namespace

Walk pairs(const Boxes& boxes, const Vec3& q) { return Colliding(boxes, {q.x(), q.y(), 0}).tell(); }

}  // namespace isect::lessons::hierarchy_lesson
