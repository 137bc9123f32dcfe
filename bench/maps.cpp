#include "bench/maps.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>

#include <isect/methods/orient.h>
#include <isect/methods/point_polygon.h>
#include <isect/methods/ray_sphere.h>
#include <isect/methods/ray_sphere_stable.h>
#include <isect/methods/sphere_sphere.h>
#include <isect/orient.h>
#include <isect/point_polygon.h>
#include <isect/ray_sphere.h>
#include <isect/sphere_sphere.h>
#include "bench/near_edges.h"
#include "bench/prose.h"
#include "viz/text/rich_text.h"

namespace isect::bench {
namespace {

using Point2 = Point<double, 2>;
using viz::Tone;

constexpr int cells_a_side = 256;

/// The cell for each neighbour (i, j): `kind(i, j)` indexes the kinds of the chart, of which the last `wrong` are
/// wrong.
template <class Kind>
viz::Map map_of(const std::string& title, int kinds, int wrong, const Kind& kind) {
  viz::Map map = {title, {}, cells_a_side, cells_a_side, {}};
  long bad = 0;
  for (int j = 0; j < cells_a_side; ++j)
    for (int i = 0; i < cells_a_side; ++i) {
      const int k = kind(i, j);
      bad += k >= kinds - wrong;
      map.cells.push_back(static_cast<unsigned char>(k));
    }
  map.note = fmt::format("{:.1f} % wrong", 100.0 * static_cast<double>(bad) / (cells_a_side * cells_a_side));
  return map;
}

std::string percentages(const std::vector<viz::Map>& maps) {
  std::string text;
  for (const viz::Map& map : maps) text += fmt::format(" {}: {}.", viz::plain(map.title), map.note);
  return text;
}

int sign(double x) { return (x > 0) - (x < 0); }

/// 0 left and 1 right as in truth, 2 on, 3 called on but is not, 4 called a wrong side.
int side_kind(int naive, int truth) {
  if (naive == truth) return truth > 0 ? 0 : truth < 0 ? 1 : 2;
  return naive == 0 ? 3 : 4;
}

/// 0 yes and 1 no as in truth, 2 on the boundary, 3 called yes but is no, 4 called no but is yes.
int yes_kind(bool naive, bool truth, bool boundary) {
  if (boundary) return 2;
  return naive == truth ? (truth ? 0 : 1) : naive ? 3 : 4;
}

}  // namespace

Plotted orientation_map() {
  const struct {
    const char* name;
    Point2 p, q, r;
  } lines[] = {
      {"line 1", {0.5, 0.5}, {12, 12}, {24, 24}},
      {"line 2",
       {0.50000000000002531, 0.5000000000000171},
       {17.300000000000001, 17.300000000000001},
       {24.00000000000005, 24.0000000000000517765}},
      {"line 3", {0.5, 0.5}, {8.8000000000000007, 8.8000000000000007}, {12.1, 12.1}},
  };
  const struct {
    const char* name;
    double (*value)(const Point2&, const Point2&, const Point2&, NoTrace&&);
  } texts[] = {
      {"pivot **p**", orient::pivoted<orient::Corner::a, double>},
      {"pivot **q**", orient::pivoted<orient::Corner::b, double>},
      {"expanded", orient::expanded<double>},
  };
  const double u = 0x1p-53;
  viz::Maps chart = {{{"left", Tone::first},
                      {"right", Tone::second},
                      {"on the line", Tone::on},
                      {"called on, is not", Tone::mild},
                      {"called a wrong side", Tone::wrong}},
                     {},
                     "cell: **p** moved by *i u* and *j u*, *u* = 2^{−53}"};
  for (const auto& text : texts)
    for (const auto& line : lines)
      chart.maps.push_back(map_of(fmt::format("{}, {}", line.name, text.name), 5, 2, [&](int i, int j) {
        const Point2 p = line.p + Point2(i * u, j * u);
        return side_kind(sign(text.value(p, line.q, line.r, {})), orient2d(p, line.q, line.r));
      }));
  const std::string percent = percentages(chart.maps);
  return {"map-orientation",
          "On which side of the line through q and r a point p lies, by three ways of writing one determinant, for "
          "256 x 256 "
          "neighbours of p. Lines 1 to 3 are those of Kettner et al. (2004). The exact call is right in "
          "every cell.",
          "Maps of the verdicts of the naive orientation test beside three lines; blocks of wrong cells lie "
          "along each line." +
              percent,
          {std::move(chart)},
          300};
}

Plotted polygon_map() {
  // The edge through the neighbours runs from a to b; it holds no vertex near them.
  const Ring<double, 2> triangle = {{-8.8, -6.1}, {24.3, 17.7}, {-9.3, 20.1}};
  const Point2 at = triangle[0] + 0.28125 * (triangle[1] - triangle[0]);
  viz::Maps chart = {{{"inside", Tone::first},
                      {"outside", Tone::second},
                      {"on the edge", Tone::on},
                      {"called inside, is out", Tone::mild},
                      {"called outside, is in", Tone::wrong}},
                     {},
                     "cell: the point moved by *i u* and *j u*, *u* = 2^{−53}"};
  const auto add = [&](const std::string& title, const auto& inside) {
    chart.maps.push_back(map_of(title, 5, 2, [&](int i, int j) {
      const Point2 p = at + Point2((i - cells_a_side / 2) * 0x1p-53, (j - cells_a_side / 2) * 0x1p-53);
      const Location truth = locate(p, triangle);
      return yes_kind(inside(p), truth == Location::in, truth == Location::on);
    }));
  };
  add("crossings, dividing", [&](const Point2& p) { return point_polygon::crossings_naive(p, triangle); });
  add("winding, multiplying", [&](const Point2& p) { return point_polygon::winding_naive(p, triangle) != 0; });
  const std::string percent = percentages(chart.maps);
  return {"map-point-in-polygon",
          "Whether a point beside an edge lies in a triangle, by crossings and by winding, for 256 x 256 "
          "points 2⁻⁵³ "
          "apart. The exact call is right in every cell.",
          "Maps of the verdicts of two naive point-in-polygon tests beside an edge." + percent,
          {std::move(chart)}};
}

Plotted tangent_map() {
  using Ray2 = Ray<double, 2>;
  const Sphere<double, 2> ball = {{0.1, 0.2}, 1};
  const Vector<double, 2> along = Vector<double, 2>(2, 1).normalized(), across = {-along[1], along[0]};
  const Point2 from = ball.center - 40 * along + across;
  viz::Maps chart = {{{"hit", Tone::first},
                      {"miss", Tone::second},
                      {"tangent", Tone::on},
                      {"called a hit, is a miss", Tone::mild},
                      {"called a miss, is a hit", Tone::wrong}},
                     {},
                     "cell: the ray's origin moved by *i u* and *j u*, *u* = 2^{−48}"};
  const auto add = [&](const std::string& title, const auto& hits) {
    chart.maps.push_back(map_of(title, 5, 2, [&](int i, int j) {
      const Ray2 ray = {from + Point2((i - cells_a_side / 2) * 0x1p-48, (j - cells_a_side / 2) * 0x1p-48), along};
      const auto truth = intersect(ray, ball);
      return yes_kind(hits(ray), truth.line_roots > 0, truth.line_roots == 1);
    }));
  };
  add("quadratic", [&](const Ray2& ray) { return ray_sphere::quadratic(ray, ball).has_value(); });
  add("Haines", [&](const Ray2& ray) { return ray_sphere::haines(ray, ball).has_value(); });
  add("robust", [&](const Ray2& ray) { return ray_sphere::robust(ray, ball).has_value(); });
  const std::string percent = percentages(chart.maps);
  return {"map-ray-sphere",
          "Whether a ray that all but touches a circle hits it, by two textbook methods and by a stable "
          "one, for "
          "256 x 256 origins 2⁻⁴⁸ "
          "apart. The exact call is right in every cell.",
          "Maps of the verdicts of ray-sphere methods near tangency." + percent,
          {std::move(chart)}};
}

Plotted touching_map() {
  using Ball = Sphere<double, 2>;
  const Ball first = {{0.6, 0.8}, 0.5};
  const struct {
    const char* name;
    double radius, step;
  } seconds[] = {{"0.25 from the origin", 0.25, 0x1p-55},
                 {"0.06 from the origin", 0.44, 0x1p-57},
                 {"0.01 from the origin", 0.49, 0x1p-60}};
  viz::Maps chart = {{{"overlap", Tone::first},
                      {"disjoint", Tone::second},
                      {"touching", Tone::on},
                      {"called overlap, is disjoint", Tone::mild},
                      {"called disjoint, is overlap", Tone::wrong}},
                     {},
                     "cell: the second centre moved by one float after the other"};
  for (const auto& second_ball : seconds)
    chart.maps.push_back(map_of(second_ball.name, 5, 2, [&](int i, int j) {
      const double radius = second_ball.radius, step = second_ball.step;
      const Point2 at = first.center * (1 - first.radius - radius);
      const Ball second = {at + Point2((i - cells_a_side / 2) * step, (j - cells_a_side / 2) * step), radius};
      const Relation truth = relate(first, second);
      return yes_kind(sphere_sphere::squared_distance_naive(first, second), truth != Relation::disjoint,
                      truth == Relation::touching);
    }));
  const std::string percent = percentages(chart.maps);
  return {"map-sphere-sphere",
          "Whether two circles that all but touch overlap, by the squared distance of their centres, for 256 "
          "x 256 "
          "neighbours of the second centre. The exact call is right in every cell.",
          "Maps of the verdicts of the naive sphere-sphere test near touching." + percent,
          {std::move(chart)}};
}

Plotted near_edges_chart() {
  viz::Mirrored chart;
  chart.rows_title = "which double beside an edge";
  chart.rows = {"on it", "1st", "2nd", "4th", "8th", "16th", "32nd"};  // near_edges::steps
  chart.apart = 1;
  chart.kinds = {std::pair("called outside, is in", Tone::wrong), std::pair("called inside, is out", Tone::mild)};
  chart.below = "in % of the points that are inside (left) or outside (right)";

  std::string alt =
      "Bars of how often each point-in-polygon method is wrong on an edge and at the first doubles beside it: in "
      "percent of the points outside, called inside, and of those inside, called outside.";
  int points = 0, wrong = 0;  // of the last method
  for (const near_edges::Method& method : near_edges::methods()) {
    viz::Mirrored::Panel panel = {method.name, {}};
    std::vector<std::string> told;
    points = wrong = 0;
    for (const auto& [outside, inside] : method.rows) {
      told.push_back(fmt::format("{} {} and {}", chart.rows[told.size()], viz::percent_text(outside.percent()),
                                 viz::percent_text(inside.percent())));
      panel.pairs.push_back({inside.percent(), outside.percent()});
      points += outside.points + inside.points, wrong += outside.wrong + inside.wrong;
    }
    alt += fmt::format(" {}: {}.", sentence(method.name), fmt::join(told, ", "));
    chart.panels.push_back(std::move(panel));
  }
  return {
      "map-near-edges",
      fmt::format("How often point-in-polygon methods are wrong on and near the edges of random polygons of eight "
                  "vertices, after Schirra (2008). Rows: points exactly on an edge, which the half-open rule of the "
                  "naive methods puts inside on a left edge and outside on a right one; then the 1st, 2nd, 4th, ... "
                  "double to the left and to the right of an edge. Winding errs where multiplication does, for it "
                  "compares the same two products. The exact call is wrong on {} of {} points, and says of those on "
                  "an edge that they are.",
                  wrong == 0 ? "none" : count(wrong), count(points)),
      alt,
      {std::move(chart)}};
}

std::vector<Plotted> maps() {
  return {orientation_map(), polygon_map(), tangent_map(), touching_map(), near_edges_chart()};
}

}  // namespace isect::bench
