// The trapezoidal map: built edge by edge, then searched by the questions that the building left behind.

#include <isect/many/trapezoid_map.h>

#include <fmt/format.h>

#include <tuple>

#include "lessons/concave_polygon/depth.h"
#include "lessons/concave_polygon/map_picture.h"
#include "lessons/shared/questions.h"
#include "lessons/shared/script.h"

namespace isect::lessons::concave_polygon_lesson {

using namespace viz;

namespace {

using Index = std::size_t;
using Trapezoid = TrapezoidMap::Trapezoid;

auto key(const Trapezoid& t) { return std::tuple(t.bottom, t.top, t.left, t.right); }

class Trapezoids {
 public:
  explicit Trapezoids(const Setup& setup)
      : s_(setup),
        script_({"Lecture note, concave polygons; Seidel, Computational Geometry 1 (1991); de Berg et al., "
                 "Computational Geometry (2008), ch. 6",
                 alt_text(setup, "split into trapezoids by walls at its vertices"),
                 {"for each edge, at best in random order",                // 0
                  "    follow it through the trapezoids that it cuts",     // 1
                  "    put a question in the place of each: x or y",       // 2
                  "x: is p left or right of the vertex? next question",    // 3
                  "y: is p below or above the edge? next question",        // 4
                  "exactly on it: return ON",                              // 5
                  "no more questions: return the mark of the trapezoid"},  // 6
                 "trapezoidal map"}) {}

  Walk tell() {
    Record<trapezoid_map::BuildEvent> record;
    map_ = s_.sorted ? sorted_map(s_.ring, record) : make_trapezoid_map(s_.ring, seed, record);
    build(record.events);
    search();
    return std::move(script_.walk());
  }

 private:
  static constexpr std::uint64_t seed = 1;

  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption, Scene scene) {
    Step& step = script_.add(slug, title, line, caption);
    add_point(scene, s_, done_ && s_.truth == Location::on);
    step.scene = std::move(scene);
    return step;
  }

  void count(const TrapezoidMap& map) {
    const Sizes now = sizes(map);
    script_.value("trapezoids", now.trapezoids, {}, Role::second);
    script_.value("questions", now.questions, {}, Role::first);
  }

  /// The map grows as the core's own builder lets it, in the core's own order.
  void build(const std::vector<trapezoid_map::BuildEvent>& events) {
    TrapezoidMap map;
    map.boundary = map_.boundary;
    trapezoid_map::Builder builder(map);
    script_.value("*n*", s_.size());
    Scene start;
    start.items = {polygon(s_),
                   trapezoid(s_.frame, map, {-1, -1, -1, static_cast<int>(s_.ring.size())}, Role::highlight)};
    add("edges", "One trapezoid: the whole plane", 0,
        s_.sorted ? "The map starts with one trapezoid. Edges are added one by one, here by their left ends, from left "
                    "to right.\n"
                    "That order is a bad one for long spikes."
                  : "The map starts with one trapezoid. Edges are added one by one, in random order, so that no "
                    "polygon is bad on average.",
        start);
    const auto cuts = [](const auto& event) { return std::get<trapezoid_map::Inserted>(event).cut; };
    const Index most = static_cast<Index>(std::ranges::max_element(events, {}, cuts) - events.begin());
    for (Index k = 0; k < events.size(); ++k) {
      const auto& inserted = std::get<trapezoid_map::Inserted>(events[k]);
      const TrapezoidMap before = map;
      builder.insert(inserted.piece);
      inserted_.push_back(inserted.piece);
      if (k == 0 || k == (s_.sorted ? events.size() - 1 : most))
        tell_insert(before, map, inserted, static_cast<int>(k));
    }
    Scene all = grown(s_, map, inserted_, -1);
    all.items.emplace_back(
        table_heading(s_.frame, fmt::format("{} nodes", sizes(map).questions + sizes(map).trapezoids)));
    add_graph(all, s_.frame, map, false);
    count(map);
    const int n = s_.size();
    Step& step = add("map", "All edges added", 2,
                     "From every vertex, vertical walls run up and down to the next edge. If no two share an "
                     "*x*-coordinate, the trapezoids number 2*n* + 1.\n"
                     "Vertices of one *x* are ordered by *y*, as if the plane had been sheared a little.\n" +
                         std::string(s_.sorted ? "The questions form a graph: each path through it is a search."
                                               : "The questions form a graph of O(*n*) nodes, built in O(*n* lg *n*), "
                                                 "on average over the orders."),
                     std::move(all));
    step.formula = fmt::format("2*n* + 1 = {}", 2 * n + 1);
    step.question = which_count("How many trapezoids does the complete map have?", 2 * n + 1,
                                {{n + 1.0, "That lets a single trapezoid begin at each vertex."},
                                 {3 * n + 1.0, "That is the bound for edges that have no ends in common."},
                                 {1.0 * n * n, "That is a grid, but each wall ends at the next edge."}},
                                "On average two trapezoids begin at each vertex. One more has no left end.");
    keep_picture(script_.walk());
    if (s_.sorted) tell_depth(script_, s_.ring, map_);
  }

  void tell_insert(const TrapezoidMap& before, const TrapezoidMap& now, const trapezoid_map::Inserted& inserted,
                   int k) {
    Scene scene = grown(s_, now, inserted_, inserted.piece);
    std::vector<Item> cut;
    for (const int i : reachable(before, 0)) {
      const Trapezoid& t = before.trapezoids[i];
      const std::vector<int> left = reachable(now, 0);
      const bool stays = std::ranges::any_of(left, [&](int j) { return key(now.trapezoids[j]) == key(t); });
      if (!stays) cut.emplace_back(trapezoid(s_.frame, before, t, Role::highlight));
    }
    scene.items.insert(scene.items.begin() + 1, cut.begin(), cut.end());
    add_graph(scene, s_.frame, now, k == 0);
    count(now);
    Step& step =
        add(fmt::format("insert-{}", k + 1), fmt::format("Edge *e*_{{{}}} is added, number {}", inserted.piece, k + 1),
            k == 0 ? 2 : 1,
            k == 0 ? "Walls run up and down from its two ends. Four trapezoids replace the one.\n"
                     "Queries lead to them: circles test left or right, squares below or above."
                   : fmt::format("{}The edge cuts {} trapezoid{}, shaded here: questions take {} place. The rest stays "
                                 "as it was.",
                                 k == 1 ? "" : fmt::format("{} been added in between.\n", since(k)), inserted.cut,
                                 inserted.cut == 1 ? "" : "s", inserted.cut == 1 ? "its" : "their"),
            std::move(scene));
    if (k > 0) {
      step.question =
          which_count(fmt::format("{}How many of the {} trapezoids does the new edge *e*_{{{}}} cut?",
                                  k == 1 ? "" : since(k) + " been added. ", sizes(before).trapezoids, inserted.piece),
                      inserted.cut,
                      {{1, "That counts the trapezoid where it begins alone."},
                       {2, inserted.cut < 2 ? "Both its ends lie in one trapezoid."
                                            : "That counts the trapezoids at its two ends alone."},
                       {1.0 * sizes(before).trapezoids, "That counts all trapezoids."}},
                      "Those whose interior it runs through.");
      step.question->over = grown(s_, before, inserted_, inserted.piece);
      const Line fresh = edge(before, inserted.piece, Role::text, Pen::thick);
      step.question->over->items.emplace_back(
          Label{fresh.from, fmt::format("*e*_{{{}}}", inserted.piece), Role::text, fresh.to});
      add_graph(*step.question->over, s_.frame, before, false);
    }
  }

  /// The edges between the first and the k-th after it.
  static std::string since(int k) { return k == 2 ? "One more edge has" : fmt::format("{} more edges have", k - 1); }

  void search() {
    Record<trapezoid_map::Event> record;
    winding(s_.p, map_, record);
    for (const auto& event : record.events) std::visit([&](const auto& e) { say(e); }, event);
  }

  void say(const trapezoid_map::VertexAsked& e) {
    ask(e.side, 3,
        e.side < 0   ? "Left of the vertex"
        : e.side > 0 ? "Right of the vertex"
                     : "On the vertex",
        e.side == 0 ? "**p** is the vertex: on the boundary."
        : map_.boundary.vertex(map_.nodes[at_].index).x() == s_.p.x()
            ? "The *x*-coordinates are equal: then the lower point counts as the left one. The candidates are shaded."
            : "Comparing *x*-coordinates decides. The shaded trapezoids can still be reached.");
  }
  void say(const trapezoid_map::PieceAsked& e) {
    ask(e.side, 4,
        e.side < 0   ? "Below the edge"
        : e.side > 0 ? "Above the edge"
                     : "On the edge",
        e.side == 0 ? "The orientation is exactly zero: **p** lies on the edge."
                    : "The sign of an orientation decides. The shaded trapezoids can still be reached.");
  }
  void say(const trapezoid_map::Reached& e) { finish(e.trapezoid); }
  void say(const Fallback&) {}

  void ask(int side, int line, const std::string& title, const std::string& caption) {
    const TrapezoidMap::Node& node = map_.nodes[at_];
    path_.push_back({at_, side});
    const int next = side < 0 ? node.first : node.second;
    script_.value("questions asked", static_cast<double>(path_.size()));
    Scene scene = searched(s_, map_, path_, side == 0 ? -1 : next);
    // two steps in a row have different titles
    const std::string named = title.substr(0, title.rfind("the ")) + name(node);
    Step& step =
        add(fmt::format("ask-{}", path_.size()), title == asked_ ? named : title, side == 0 ? 5 : line, caption, scene);
    asked_ = title;
    step.decides = true;
    if (side == 0) return finish(-1);
    at_ = next;
    script_.value("trapezoids left", static_cast<double>(reachable(map_, at_).size()));
  }

  void finish(int trapezoid_reached) {
    done_ = true;
    const bool on = trapezoid_reached < 0;
    script_.settle(verdict_kind(s_.truth), verdict_text(s_.truth));
    if (on) script_.leave_early();
    if (!on) path_.push_back({at_, 0});
    Scene scene = found(s_, map_, path_, trapezoid_reached);
    const Index questions = on ? path_.size() : path_.size() - 1;
    add("verdict", on ? "On the boundary" : "A trapezoid is reached", on ? 5 : 6,
        fmt::format("{}\n{} question{} for {} vertices. The mean over all orders of insertion is O(lg *n*).{}",
                    on                         ? "A question that is answered by \"on it\" ends the search."
                    : s_.truth == Location::in ? "All of this trapezoid is inside: the mark was computed beforehand."
                                               : "All of this trapezoid is outside: the mark was computed beforehand.",
                    questions, questions == 1 ? "" : "s", s_.size(),
                    s_.sorted ? fmt::format(" In this one a search asks up to {}.", depth(map_)) : ""),
        std::move(scene));
  }

  const Setup& s_;
  TrapezoidMap map_;
  Script script_;
  std::vector<int> inserted_;
  std::vector<Asked> path_;
  int at_ = 0;         ///< the node that is asked next
  std::string asked_;  ///< the title of the question before
  bool done_ = false;
};

}  // namespace

Walk trapezoids(const Setup& setup) { return Trapezoids(setup).tell(); }

}  // namespace isect::lessons::concave_polygon_lesson
