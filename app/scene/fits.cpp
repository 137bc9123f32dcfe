#include "app/scene/fits.h"

#include <fmt/format.h>

#include <isect/convex_hull.h>
#include <isect/directions.h>
#include <isect/fit.h>
#include <isect/fit_tight.h>
#include <isect/kdop_polytope.h>
#include <isect/volume.h>

#include "app/query/reply.h"
#include "app/scene/answered.h"
#include "app/scene/shapes.h"
#include "app/scene/type_words.h"
#include "viz/lang/message.h"
#include "viz/text/rich_text.h"

namespace isect::program::scene {

namespace {

using viz::Role;
using viz::Vec3;

/// A volume around points; in the plane its size is the area.
struct Fitted {
  double size = 0;
  std::string told = {};  ///< its numbers, as markup
  std::vector<viz::Item> items = {};
  Json json = {};
};

template <int N>
Json list(const Eigen::Matrix<double, N, 1>& v) {
  Json all = Json::array();
  for (int i = 0; i < N; ++i) all.push_back(v[i]);
  return all;
}

template <int N>
std::string told(const Eigen::Matrix<double, N, 1>& v) {
  std::string text;
  for (int i = 0; i < N; ++i) text += (i == 0 ? "(" : ", ") + viz::shown(v[i]);
  return text + ")";
}

viz::Region region(const std::vector<Vec3>& ring) {
  viz::Region r;
  r.rings = {ring}, r.role = Role::second;
  return r;
}

template <int N>
Fitted sphere_around(const std::vector<Point<double, N>>& points) {
  const Sphere<double, N> ball = fit_sphere_smallest(points);
  Fitted out = {volume(ball),
                viz::tr("centre {p}, *r* = {r}", {{"p", told<N>(ball.center)}, {"r", viz::shown(ball.radius)}})};
  Vec3 center = Vec3::Zero();
  center.head<N>() = ball.center;
  if constexpr (N == 2)
    out.items = {viz::Circle{center, ball.radius, Role::second, viz::Pen::solid, true}};
  else
    out.items = {viz::Ball{center, ball.radius, Role::second}};
  out.json = {{"center", list<N>(ball.center)}, {"radius", ball.radius}};
  return out;
}

template <int N>
Fitted box_around(const std::vector<Point<double, N>>& points) {
  const Aabb<double, N> box = fit_aabb(points);
  Fitted out = {volume(box), viz::tr("from {p} to {q}", {{"p", told<N>(box.lo)}, {"q", told<N>(box.hi)}})};
  if constexpr (N == 2)
    out.items = {region({{box.lo.x(), box.lo.y(), 0},
                         {box.hi.x(), box.lo.y(), 0},
                         {box.hi.x(), box.hi.y(), 0},
                         {box.lo.x(), box.hi.y(), 0}})};
  else
    out.items = {viz::solid(box, Role::second)};
  out.json = {{"lo", list<N>(box.lo)}, {"hi", list<N>(box.hi)}};
  return out;
}

template <int N>
Fitted obb_around(const std::vector<Point<double, N>>& points) {
  const Obb<double, N> box = fit_obb_tight(points);
  Fitted out = {volume(box), viz::tr("half-lengths {p}", {{"p", told<N>(box.half)}})};
  if constexpr (N == 2) {
    const Point<double, 2> u = box.half.x() * box.axes.col(0), v = box.half.y() * box.axes.col(1), c = box.center;
    out.items = {region(in_space({c - u - v, c + u - v, c + u + v, c - u + v}))};
  } else {
    out.items = {viz::solid(box, Role::second)};
  }
  out.json = {{"c", list<N>(box.center)}, {"u", Json::array()}, {"e", list<N>(box.half)}};
  for (int i = 0; i < N; ++i) out.json["u"].push_back(list<N>(Point<double, N>(box.axes.col(i))));
  return out;
}

template <int N>
Fitted kdop_around(const std::vector<Point<double, N>>& points) {
  constexpr int k = N == 2 ? 8 : 26;
  const Kdop<double, N> kdop = fit_kdop(points, directions<double, N>(k));
  Fitted out = {volume(kdop), viz::tr_count(k / 2, "{n} slabs", "{n} slabs")};
  if constexpr (N == 2)
    out.items = {region(in_space(polytope(kdop).vertices))};
  else
    out.items = {viz::solid(kdop, Role::second)};
  for (std::size_t i = 0; i < kdop.normals.size(); ++i) {
    out.json["normals"].push_back(list<N>(kdop.normals[i]));
    out.json["lo"].push_back(kdop.slabs[i].lo);
    out.json["hi"].push_back(kdop.slabs[i].hi);
  }
  return out;
}

Fitted hull_around(const std::vector<Point<double, 2>>& points) {
  const Ring<double, 2> hull = convex_hull(points);
  double twice = 0;
  for (std::size_t i = 2; i < hull.size(); ++i) {
    const Point<double, 2> a = hull[i - 1] - hull[0], b = hull[i] - hull[0];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  Fitted out = {twice / 2, viz::tr_count(hull.size(), "{n} vertices", "{n} vertices"), {region(in_space(hull))}};
  for (const Point<double, 2>& p : hull) out.json["vertices"].push_back(list<2>(p));
  return out;
}

Fitted hull_around(const std::vector<Point<double, 3>>& points) {
  const Hull3<double> hull = convex_hull(points);
  Fitted out = {volume(hull),
                viz::tr_count(hull.vertices.size(), "{n} vertices, {m} triangles", "{n} vertices, {m} triangles",
                              {{"m", std::to_string(hull.triangles.size())}})};
  if (hull.dimension == 3) out.items = {viz::solid(hull, Role::second)};
  for (const Vec3& p : hull.vertices) out.json["vertices"].push_back(list<3>(p));
  out.json["triangles"] = hull.triangles;
  return out;
}

template <int N>
Fitted fitted(const std::vector<Vec3>& all, const std::string& volume) {
  const std::vector<Point<double, N>> points = points_of<N>(all);
  if (volume == "sphere") return sphere_around<N>(points);
  if (volume == "box") return box_around<N>(points);
  if (volume == "obb") return obb_around<N>(points);
  if (volume == "kdop") return kdop_around<N>(points);
  return hull_around(points);
}

}  // namespace

const std::vector<std::string>& volumes() {
  static const std::vector<std::string> all = {"sphere", "box", "obb", "kdop", "hull"};
  return all;
}

bool can_fit(Type t) {
  return t == Type::segment || t == Type::triangle || t == Type::polygon || t == Type::hull || t == Type::mesh ||
         t == Type::cloud;
}

/// Draws one volume around the object, or compares all five; then the tightest one is drawn.
Answered answered(const Context& c, const FitAsked& asked) {
  const Object& o = c.object(asked.object);
  const bool flat = c.file.flat;
  const std::vector<Vec3> points = c.numbers.extent(o);
  const std::string size = flat ? "area" : "volume";
  Answered out = {"fit-" + slug_of(o.name), "", "", {}};
  out.lit = {asked.object};
  out.json = {{"fit", o.name}};
  const std::vector<std::string> wanted = asked.volume.empty() ? volumes() : std::vector<std::string>{asked.volume};
  for (const std::string& volume : wanted) {
    Fitted one = flat ? fitted<2>(points, volume) : fitted<3>(points, volume);
    const VolumeWords& words = words_of(volume, flat);
    out.values.push_back(
        {tr(words.size), one.size, flat ? viz::tr("units^2") : viz::tr("units^3"), Role::second, true});
    out.json["volumes"].push_back({{"fitted", volume}, {size, query::number(one.size)}, {"result", one.json}});
    if (wanted.size() == 1) {
      out.slug += "-" + volume;
      out.title = tr(words.title, {{"a", c.name(asked.object)}});
      out.formula = one.told;
      out.verdict = {viz::Verdict::Kind::yes,
                     tr(words.verdict, {{"a", c.name(asked.object)}, {"size", viz::shown(one.size)}})};
      out.caption = viz::tr("Every point lies in it, exactly: {told}.", {{"told", one.told}});
    } else {
      out.formula += fmt::format("{}{}: {}", out.formula.empty() ? "" : ", ", tr(words.in_list), viz::shown(one.size));
    }
    if (wanted.size() == 1 || volume == "hull") out.items = std::move(one.items);
  }
  if (wanted.size() > 1) {
    out.title = viz::tr("Volumes around {a}", {{"a", c.name(asked.object)}});
    out.caption = flat ? viz::tr(
                             "The area of each volume that holds every point. The hull, which is drawn, is the least "
                             "convex one.")
                       : viz::tr(
                             "The volume of each volume that holds every point. The hull, which is drawn, is the least "
                             "convex one.");
    out.verdict = {viz::Verdict::Kind::yes,
                   tr(words_of("hull", flat).verdict,
                      {{"a", c.name(asked.object)}, {"size", viz::shown(out.values.back().value)}})};
  }
  out.json["verdict"] = viz::plain(out.verdict.text);
  return out;
}

}  // namespace isect::program::scene
