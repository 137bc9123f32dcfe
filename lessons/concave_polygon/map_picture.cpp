#include "lessons/concave_polygon/map_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace isect::lessons::concave_polygon_lesson {

using namespace viz;
using Node = TrapezoidMap::Node;
using Ask = TrapezoidMap::Ask;

namespace {

using Index = std::size_t;

/// The height of a piece at an abscissa, for drawing.
double height(const TrapezoidMap& map, int piece, double x, double none) {
  if (piece < 0) return none;
  const PolygonPieces::Piece& s = map.boundary.pieces[piece];
  const Point<double, 2>&a = map.boundary.vertex(s.low), &b = map.boundary.vertex(s.high);
  return a.y() + (x - a.x()) / (b.x() - a.x()) * (b.y() - a.y());
}

double wall(const Frame& frame, const TrapezoidMap& map, int vertex) {
  if (vertex < 0) return frame.left;
  return vertex < static_cast<int>(map.boundary.vertices.size()) ? map.boundary.vertex(vertex).x() : frame.right;
}

void visit(const TrapezoidMap& map, int i, int depth, std::map<int, int>& depths) {
  const auto [it, fresh] = depths.emplace(i, depth);
  if (!fresh && it->second >= depth) return;
  it->second = depth;
  if (map.nodes[i].ask == Ask::nothing) return;
  visit(map, map.nodes[i].first, depth + 1, depths);
  visit(map, map.nodes[i].second, depth + 1, depths);
}

}  // namespace

std::map<int, int> depths(const TrapezoidMap& map, int root) {
  std::map<int, int> all;
  visit(map, root, 0, all);
  return all;
}

std::vector<int> reachable(const TrapezoidMap& map, int node) {
  std::vector<int> all;
  for (const auto& [i, _] : depths(map, node))
    if (map.nodes[i].ask == Ask::nothing) all.push_back(map.nodes[i].index);
  return all;
}

Sizes sizes(const TrapezoidMap& map) {
  Sizes s = {0, 0};
  for (const auto& [i, _] : depths(map)) ++(map.nodes[i].ask == Ask::nothing ? s.trapezoids : s.questions);
  return s;
}

std::string name(const Node& n) {
  return std::string(n.ask == Ask::vertex ? "**v**_{" : "*e*_{") + std::to_string(n.index) + "}";
}

Region trapezoid(const Frame& frame, const TrapezoidMap& map, const TrapezoidMap::Trapezoid& t, Role role) {
  const double x0 = wall(frame, map, t.left), x1 = wall(frame, map, t.right);
  const auto y = [&](int piece, double x) { return height(map, piece, x, piece == t.bottom ? frame.low : frame.high); };
  const double top0 = height(map, t.top, x0, frame.high), top1 = height(map, t.top, x1, frame.high);
  return filled({{x0, y(t.bottom, x0), 0}, {x1, y(t.bottom, x1), 0}, {x1, top1, 0}, {x0, top0, 0}}, role);
}

void add_walls(Scene& scene, const Frame& frame, const TrapezoidMap& map) {
  std::set<std::pair<double, std::pair<double, double>>> drawn;
  for (const int i : reachable(map, 0)) {
    const TrapezoidMap::Trapezoid& t = map.trapezoids[i];
    for (const int v : {t.left, t.right}) {
      if (v < 0 || v >= static_cast<int>(map.boundary.vertices.size())) continue;
      const double x = wall(frame, map, v), below = height(map, t.bottom, x, frame.low),
                   above = height(map, t.top, x, frame.high), y = map.boundary.vertex(v).y();
      for (const double end : {below, above})
        if (end != y && drawn.insert({x, {y, end}}).second)
          scene.items.emplace_back(Line{{x, y, 0}, {x, end, 0}, Role::construction, Pen::construction});
    }
  }
}

Line edge(const TrapezoidMap& map, int piece, Role role, Pen pen) {
  const PolygonPieces::Piece& s = map.boundary.pieces[piece];
  return {flat(map.boundary.vertex(s.low)), flat(map.boundary.vertex(s.high)), role, pen};
}

Scene grown(const Setup& s, const TrapezoidMap& map, const std::vector<int>& inserted, int fresh) {
  Scene scene;
  scene.items.emplace_back(polygon(s, false));
  add_walls(scene, s.frame, map);
  for (int piece = 0; piece < static_cast<int>(map.boundary.pieces.size()); ++piece) {
    const bool in = std::ranges::find(inserted, piece) != inserted.end();
    scene.items.emplace_back(edge(map, piece, in ? Role::second : Role::construction,
                                  piece == fresh ? Pen::highlight
                                  : in           ? Pen::solid
                                                 : Pen::construction));
  }
  return scene;
}

Scene searched(const Setup& s, const TrapezoidMap& map, const std::vector<Asked>& path, int next) {
  Scene scene;
  scene.items.emplace_back(polygon(s, false));
  if (next >= 0)
    for (const int t : reachable(map, next))
      scene.items.emplace_back(trapezoid(s.frame, map, map.trapezoids[t], Role::highlight));
  add_walls(scene, s.frame, map);
  for (int piece = 0; piece < static_cast<int>(map.boundary.pieces.size()); ++piece)
    scene.items.emplace_back(edge(map, piece, Role::second, Pen::solid));
  const TrapezoidMap::Node& node = map.nodes[path.back().node];
  if (node.ask == TrapezoidMap::Ask::piece) {
    scene.items.emplace_back(edge(map, node.index, Role::text, Pen::thick));
    const Line l = edge(map, node.index, Role::text, Pen::thick);
    scene.items.emplace_back(Label{l.from, name(node), Role::text, l.to});
  } else {
    const Vec3 v = flat(map.boundary.vertex(node.index));
    scene.items.emplace_back(Line{{v.x(), s.frame.low, 0}, {v.x(), s.frame.high, 0}, Role::text, Pen::hairline});
    scene.items.emplace_back(Dot{v, Mark::disc, Role::text});
    scene.items.emplace_back(Label{v, name(node), Role::text});
  }
  add_path(scene, s.frame, map, path);
  return scene;
}

Scene found(const Setup& s, const TrapezoidMap& map, const std::vector<Asked>& path, int reached) {
  Scene scene;
  scene.items.emplace_back(polygon(s));
  if (reached >= 0)
    scene.items.emplace_back(
        trapezoid(s.frame, map, map.trapezoids[reached], s.truth == Location::in ? Role::hit : Role::miss));
  add_walls(scene, s.frame, map);
  add_path(scene, s.frame, map, path);
  return scene;
}

}  // namespace isect::lessons::concave_polygon_lesson
