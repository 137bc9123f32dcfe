#include "lessons/crossings/situations.h"

#include <algorithm>
#include <numeric>

#include <isect/polygon_triangles.h>

#include "lessons/shared/parameters.h"
#include "lessons/shared/vertices.h"

namespace isect::lessons::crossings_lesson {

const std::vector<Situation>& situations() {
  static const std::vector<Situation> all = {
      {"vertex-passed",
       "vertex passed",
       {-0.75, 0},
       {{{{-2, -1.5}, {0.75, -1.75}, {2.25, 0}, {0.5, 2}, {-1.5, 1.5}}}},
       "The ray goes through a vertex, where the boundary passes from one side to the other."},
      {"inside",
       "inside",
       {-0.75, 0.25},
       {{{{-2, -1.5}, {0.75, -1.75}, {2.25, -0.5}, {1.5, 1.75}, {-1.5, 1.5}}}},
       "No vertex lies at the height of the point."},
      {"outside",
       "outside",
       {-2.75, -0.5},
       {{{{-2, -1.5}, {0.75, -1.75}, {2.25, 0.25}, {1.5, 1.75}, {-1.5, 1.5}}}},
       "The ray enters the polygon and leaves it again."},
      {"grazed-none",
       "vertex grazed: none",
       {-1.25, 0},
       {{{{-2, -1.5}, {-0.75, -1.75}, {0.25, 0}, {1.25, -1.5}, {2.25, -1.25}, {1.75, 2}, {-1.75, 1.5}}}},
       "The boundary comes up to the ray and turns back: both edges lie below."},
      {"grazed-two",
       "vertex grazed: two",
       {-1.25, 0},
       {{{{-2, -1.5}, {0, -2}, {2.25, -1.5}, {2, 1.5}, {0.5, 0}, {-0.5, 2}, {-1.75, 1.5}}}},
       "The boundary comes down to the ray and turns back: both edges lie above, so both count."},
      {"edge-along-z",
       "edge along, Z",
       {-1.25, 0},
       {{{{-2, -1.75}, {2.25, -1.75}, {2.25, 0}, {0.25, 0}, {-0.25, 2}, {-1.75, 1.75}}}},
       "An edge lies along the ray, and the boundary goes on to the other side."},
      {"edge-along-u",
       "edge along, U",
       {-2.75, 0},
       {{{{-2, -1.75}, {2.25, -1.5}, {2, 2}, {1.5, 1.75}, {1.25, 0}, {0, 0}, {-0.5, 1.75}, {-1.75, 1.5}}}},
       "An edge lies along the ray, and the boundary turns back to the side it came from."},
      {"on-edge",
       "on an edge",
       {-1.75, 0},
       {{{{-2.25, -1.5}, {1.75, -1.25}, {1.5, 1.75}, {-1.25, 1.5}}}},
       "The point lies on an edge."},
      {"on-vertex",
       "on a vertex",
       {-1.5, 0},
       {{{{-1.5, 0}, {0.5, -1.75}, {2.25, -0.25}, {0.5, 1.75}}}},
       "The point is a vertex."},
      {"on-horizontal",
       "on a horizontal edge",
       {-0.5, 0},
       {{{{-2, 0}, {1.75, 0}, {1.25, 1.75}, {-1.25, 2}}}},
       "The point lies on an edge that is parallel to the ray."},
      {"spike",
       "spike",
       {-1.25, 0},
       {{{{-2, -1.5}, {1.5, -1.5}, {1.25, 0.5}, {2.5, -0.5}, {1.25, 0.5}, {1, 1.75}, {-1.75, 1.5}}}},
       "Two edges run out to a tip and back: they cancel."},
      {"hole",
       "hole",
       {-0.25, 0.25},
       {{{{-2.25, -1.75}, {2.25, -1.75}, {2.25, 1.75}, {-2.25, 1.75}}, {{-1, -0.75}, {-1, 1}, {1, 1.25}, {1, -0.75}}}},
       "The point lies in a hole, which is a separate ring."},
      {"pentagram",
       "crosses itself",
       {0, 0.125},
       {{{{-1.25, -1.75}, {0, 2.25}, {1.25, -1.75}, {-2, 0.75}, {2, 0.75}}}},
       "The boundary goes around the point twice."},
      {"figure-eight",
       "a figure eight",
       {0.75, 0.125},
       {{{{-2, -1.5}, {2, 1.5}, {2, -1.5}, {-2, 1.5}}}},
       "The boundary crosses itself once: its two loops run in opposite ways around."},
  };
  return all;
}

const Situation& situation(const std::string& id) {
  return *std::ranges::find_if(situations(), [&](const Situation& s) { return s.id == id; });
}

namespace {

int corners_of(const Situation& s) {
  return std::accumulate(s.polygon.rings.begin(), s.polygon.rings.end(), 0,
                         [](int sum, const Ring<double, 2>& ring) { return sum + static_cast<int>(ring.size()); });
}

Polygon<double, 2> moved(Polygon<double, 2> polygon, const viz::Parameters& values) {
  std::size_t first = 0;
  for (Ring<double, 2>& ring : polygon.rings) {
    move_vertices(values, "v", ring, first);
    first += ring.size();
  }
  return polygon;
}

}  // namespace

int most_corners() {
  int most = 0;
  for (const Situation& s : situations()) most = std::max(most, corners_of(s));
  return most;
}

Setup::Setup(const viz::Parameters& values)
    : situation(crossings_lesson::situation(std::get<std::string>(values.at("polygon")))),
      p(flat_point(values, "p")),
      polygon(moved(situation.polygon, values)),
      simple(polygon.rings.size() == 1 && is_simple(polygon.rings[0])),
      truth(winding(p, polygon)) {}

Setup::Setup(const Point<double, 2>& point, const Polygon<double, 2>& of_ones_own)
    : situation([]() -> const Situation& {
        static const Situation none = {"", "", {0, 0}, {}, ""};
        return none;
      }()),
      p(point),
      polygon(of_ones_own),
      simple(polygon.rings.size() == 1 && is_simple(polygon.rings[0])),
      truth(winding(p, polygon)) {}

int Setup::vertices_on_ray() const {
  int on_ray = 0;
  for (const Ring<double, 2>& ring : polygon.rings)
    on_ray +=
        static_cast<int>(std::ranges::count_if(ring, [&](const auto& v) { return v.y() == p.y() && v.x() > p.x(); }));
  return on_ray;
}

}  // namespace isect::lessons::crossings_lesson
