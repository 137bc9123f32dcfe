// Many boxes under a hierarchy: what lies outside as a whole is skipped as a whole.

#include <fmt/format.h>

#include "lessons/culling/culled.h"
#include "lessons/shared/digits.h"
#include "lessons/shared/line_question.h"
#include "lessons/shared/plural.h"
#include "lessons/shared/script.h"
#include "viz/chart/chart.h"

namespace isect::lessons::culling_lesson {

using namespace viz;

namespace {

class UnderHierarchy {
 public:
  UnderHierarchy(const Frustum<double>& view, const Vec3& eye)
      : view_(view),
        eye_(eye),
        boxes_(few()),
        bvh_(build_bvh(boxes_, {.largest_leaf = 4, .visit = 4})),
        script_({"Lecture note, view-volume culling and hierarchies; Assarsson and Möller (2000)",
                 "A view frustum with its eye, and sixteen boxes in four clusters, each in a node's box.",
                 {"cull(node): test the node's box against the frustum",       // 0
                  "    outside: skip all below it",                            // 1
                  "    inside: draw all below it, with no more tests",         // 2
                  "    crossing: cull both children; test what a leaf holds",  // 3
                  "cull(root)"},                                               // 4
                 "a hierarchy"}),
        known_(boxes_.size()) {}

  Walk tell() {
    const Culled all = culled(bvh_, boxes_, view_);
    Step& first = script_.add("build", "Boxes in boxes", 4,
                              "Each node's box contains all boxes below it. What is true of all of the node's box is "
                              "true of each of them.");
    first.scene = picture();
    for (const BvhNode<double, 3>& node : bvh_.nodes)
      if (node.leaf()) wire(node.box, Role::construction, Pen::construction, first.scene);
    for (const Visit& v : all.visits) say(v);
    total(all);
    growth();
    return std::move(script_.walk());
  }

 private:
  static void wire(const Box& b, Role role, Pen pen, Scene& scene) {
    const auto ring = [&](double y) -> std::vector<Vec3> {
      return {{b.lo.x(), y, b.lo.z()}, {b.hi.x(), y, b.lo.z()}, {b.hi.x(), y, b.hi.z()}, {b.lo.x(), y, b.hi.z()}};
    };
    const std::vector<Vec3> low = ring(b.lo.y()), high = ring(b.hi.y());
    scene.items.emplace_back(Chain{low, true, role, pen});
    scene.items.emplace_back(Chain{high, true, role, pen});
    for (std::size_t i = 0; i < 4; ++i) scene.items.emplace_back(Chain{{low[i], high[i]}, false, role, pen});
  }

  Scene picture() const {
    Scene scene;
    add_view(view_, eye_, scene);
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if (known_[i])
        add(boxes_[i], {*known_[i]}, scene);
      else
        add(boxes_[i], Role::muted, scene);
    }
    scene.handles = {{"eye", Handle::Kind::point, eye_, Vec3::Zero(), Role::first}};
    return scene;
  }

  /// All boxes below a node share its answer.
  int know(int node, Culling culling) {
    const BvhNode<double, 3>& n = bvh_.nodes[node];
    for (int k = 0; k < n.count; ++k) known_[bvh_.primitives[n.first + k]] = culling;
    return n.leaf() ? n.count : know(n.first, culling) + know(n.first + 1, culling);
  }

  void say(const Visit& v) {
    const Culling culling = v.answer.culling;
    const Box& box = bvh_.nodes[v.node].box;
    tests_ += 1 + static_cast<int>(v.tested.size());
    const int below = culling == Culling::crossing ? 0 : know(v.node, culling);
    for (const auto& [i, answer] : v.tested) known_[i] = answer.culling;
    script_.value("tests", tests_);
    const bool leaf = !v.tested.empty();
    Step& step = script_.add(
        fmt::format("node-{}", v.node),
        fmt::format("{} is {}", v.node == 0 ? "The root" : fmt::format("Node {}", v.node), word(culling)),
        v.node == 0                   ? 0
        : culling == Culling::outside ? 1
        : culling == Culling::inside  ? 2
                                      : 3,
        culling == Culling::outside ? fmt::format("The node's box lies beyond the {} plane. One test skips {}.",
                                                  plane_names[v.answer.rejecting_plane()], plural(below, "box"))
        : culling == Culling::inside
            ? fmt::format("The node's box lies inside. One test accepts {}.", plural(below, "box"))
        : leaf ? fmt::format("The leaf crosses, so its contents are tested: {}.",
                             plural(static_cast<long long>(v.tested.size()), "box"))
               : "The node's box crosses the frustum, which says nothing about its contents. Its children are "
                 "next.");
    step.decides = true;
    step.scene = picture();
    wire(box, Role::highlight, Pen::highlight, step.scene);
    const Vec3 at = middle(box);
    if (culling == Culling::outside)
      step.scene.items.emplace_back(Label{at, plane_names[v.answer.rejecting_plane()], Role::miss});
    const std::string given = fmt::format("The box of {} reaches from {} to {}. The frustum is {}.",
                                          v.node == 0 ? "the root" : fmt::format("node {}", v.node),
                                          coordinates(box.lo), coordinates(box.hi), inner_side(eye_));
    if (v.node != 0)
      return ask_for_line(
          script_.walk(), given + " Which line settles what is below it?",
          {{1, "No plane has the whole box on its outer side."},
           {2, "Not all of the box lies on the inner side of every plane."},
           {3, culling == Culling::outside ? "The box lies beyond a plane, so nothing below it is asked."
                                           : "The box lies inside, so nothing below it is asked."},
           {4, "That line begins with the root."}},
          "The same six planes decide as for any box.");
    step.question = {given + " Where does the box lie?",
                     {"wholly outside", "wholly inside", "across the boundary"},
                     culling == Culling::outside  ? 0
                     : culling == Culling::inside ? 1
                                                  : 2,
                     "The same six planes decide as for any box."};
  }

  void total(const Culled& all) {
    const int n = static_cast<int>(boxes_.size());
    script_.settle(all.drawn.empty() ? Verdict::Kind::no : Verdict::Kind::yes,
                   fmt::format("drawn: {} of {} boxes, after {}", all.drawn.size(), n, plural(all.tests, "test")));
    script_.value("drawn", static_cast<double>(all.drawn.size()), {}, Role::hit);
    Step& step = script_.add(
        "total", "What is drawn", 4,
        fmt::format("{} of boxes, nodes included. One by one it would be {}.", plural(all.tests, "test"), n));
    step.scene = picture();
  }

  void growth() {
    Panel panel;
    panel.curves = {{0, {}, "one by one"}, {1, {}, "hierarchy"}};
    int tests = 0, fewest = 0;  // of the most boxes, of the fewest
    for (const int n : {16, 64, 256, 1024, 4096}) {
      const std::vector<Box> boxes = many(n, eye_);
      tests = culled(build_bvh(boxes), boxes, view_).tests;
      if (n == 16) fewest = tests;
      panel.curves[0].points.emplace_back(n, n);
      panel.curves[1].points.emplace_back(n, tests);
      script_.value(fmt::format("hierarchy, {} boxes", n), tests, "tests", Role::hit);
    }
    Step& step = script_.add(
        "growth", "As *n* grows", 4,
        fmt::format("Another scene: boxes all around the eye, not in clusters. Of 4096 of them a hierarchy "
                    "tests {}, nodes included, and draws the same boxes.\nOf 16 it takes {} tests{}",
                    tests, fewest,
                    fewest > 16 ? ", more than one by one: without clusters it pays from some size on." : "."));
    const auto scale = [](const char* title) { return Scale{Scale::Kind::log, 10, 10000, title}; };
    const Plot plot = {scale("boxes"),
                       scale("tests"),
                       {{"one by one", Glyph::disc, Role::second, 0}, {"hierarchy", Glyph::square, Role::hit, 1}},
                       {panel}};
    step.scene.chart = std::make_shared<const Chart>(Chart{plot});
    step.question = {"Which boxes cost the tests?",
                     {"those outside", "those inside", "those near the frustum's sides"},
                     2,
                     "What lies outside or inside as a whole is settled with its node."};
  }

  const Frustum<double> view_;
  const Vec3 eye_;
  const std::vector<Box> boxes_;
  const Bvh<double, 3> bvh_;
  Script script_;
  std::vector<std::optional<Culling>> known_;
  int tests_ = 0;
};

}  // namespace

Walk hierarchy(const Frustum<double>& view, const Vec3& eye) { return UnderHierarchy(view, eye).tell(); }

}  // namespace isect::lessons::culling_lesson
