#include "lessons/ray_triangle/picture.h"

#include <algorithm>
#include <utility>

#include "lessons/shared/microscope.h"
#include "viz/compose/compose.h"
#include "viz/compose/small_multiples.h"

namespace isect::lessons::ray_triangle_lesson {

using namespace viz;

namespace {

class Painter {
 public:
  Painter(const Setup& setup, const Known& known) : s_(setup), k_(known), neighbour_(setup.seam() || known.neighbour) {
    constexpr double farthest = 40;
    const double length = s_.ray.direction.norm();
    const double t = s_.line && std::abs(*s_.line) * length < farthest ? *s_.line : 0;
    crossing_ = s_.line && std::abs(*s_.line) * length < farthest;
    end_ = s_.segment() ? s_.ray.range.hi : std::max(crossing_ ? t + 0.875 : 3.25, 1.5);
  }

  Scene paint() {
    triangles();
    plane_of_edge();
    weights();
    ray();
    edges();
    meeting();
    names();
    handles();
    return std::move(scene_);
  }

 private:
  void add(Item item) { scene_.items.push_back(std::move(item)); }
  Vec3 at(double u, double v) const {
    return s_.vertex(0) + u * (s_.vertex(1) - s_.vertex(0)) + v * (s_.vertex(2) - s_.vertex(0));
  }

  void triangles() {
    const std::vector<Vec3> own = {s_.vertex(0), s_.vertex(1), s_.vertex(2)};
    if (s_.flat)
      add(Chain{own, true, Role::second, Pen::solid});
    else
      add(Region{.rings = {own}, .role = Role::second, .hides = true});
    const auto& [c, b, q] = s_.neighbour.vertices;
    if (neighbour_) add(Region{.rings = {{c, b, q}}, .role = Role::muted, .hides = true});
  }

  void plane_of_edge() {
    if (k_.edge < 0) return;
    const Vec3 &p = s_.vertex((k_.edge + 1) % 3), &q = s_.vertex((k_.edge + 2) % 3);
    add(Region{.rings = {{s_.ray.origin, p, q}}, .role = Role::first, .pen = Pen::construction});
    add(Line{p, q, Role::highlight, Pen::highlight});
  }

  /// The points of one weight lie on a line along the edge opposite its vertex.
  void weights() {
    constexpr double beyond = 0.25;
    const auto reach = [&](double w) { return std::max(1 - w, 0.5) + beyond; };
    const Pen latest = k_.v ? Pen::construction : Pen::highlight;
    if (k_.u && std::abs(*k_.u) < largest_weight)
      add(Line{at(*k_.u, -beyond), at(*k_.u, reach(*k_.u)), k_.v ? Role::construction : Role::highlight, latest});
    if (k_.v && std::abs(*k_.v) < largest_weight)
      add(Line{at(-beyond, *k_.v), at(reach(*k_.v), *k_.v), k_.crossing ? Role::construction : Role::highlight,
               k_.crossing ? Pen::construction : Pen::highlight});
  }

  void ray() {
    const double t = s_.line.value_or(0);
    if (k_.crossing && crossing_ && t < 0)
      add(Line{s_.ray.origin, s_.ray.at(t - 0.25), Role::construction, Pen::construction});
    if (k_.crossing && crossing_ && t > end_)
      add(Line{s_.ray.at(end_), s_.ray.at(t + 0.25), Role::construction, Pen::construction});
    if (s_.segment()) {
      add(Line{s_.ray.origin, s_.ray.at(end_), Role::first, Pen::solid});
      add(Dot{s_.ray.at(end_), Mark::disc, Role::first});
    } else {
      add(Arrow{s_.ray.origin, s_.ray.at(end_), Role::first, Pen::solid});
    }
    add(Label{s_.ray.at(end_), s_.segment() ? "*t*_{max}" : "**d**", Role::first});
  }

  void edges() {
    if (!k_.edges) return;
    for (const int i : {1, 2}) {
      add(Arrow{s_.vertex(0), s_.vertex(i), Role::highlight, Pen::highlight});
      add(Label{s_.vertex(0), i == 1 ? "**e**_1" : "**e**_2", Role::text, s_.vertex(i)});
    }
  }

  void meeting() {
    if (!k_.crossing || !crossing_) return;
    const Vec3 p = s_.ray.at(*s_.line);
    const bool within = s_.truth.location != Location::out, hit = s_.truth.t.has_value();
    Dot dot = {p, Mark::disc, Role::text};
    if (within && !hit) dot = {p, Mark::excluded, Role::construction};
    if (k_.settled && hit && s_.truth.location == Location::in) dot = {p, Mark::disc, Role::hit};
    if (k_.settled && hit && s_.truth.location == Location::on) dot = {p, Mark::diamond, Role::highlight};
    if (k_.settled && !within) dot = {p, Mark::no, Role::miss};
    if (s_.seam()) dot = {p, Mark::disc, Role::text};  // either triangle counts
    add(dot);
    if (s_.place() != Place::vertex) add(Label{p, "**r**(*t*)", Role::text});
  }

  void names() {
    for (int i = 0; i < 3; ++i) add(Label{s_.vertex(i), vertex_names[i], Role::second});
    if (neighbour_) add(Label{s_.neighbour.vertices[2], "**q**", Role::text});
    add(Dot{s_.ray.origin, Mark::disc, Role::first});
    add(Label{s_.ray.origin, "**o**", Role::first});
  }

  void handles() {
    const auto point = [](const char* name, const Vec3& p, Role role) -> Handle {
      return {name, Handle::Kind::point, p, Vec3::Zero(), role};
    };
    scene_.handles = {point("o", s_.ray.origin, Role::first),
                      {"d", Handle::Kind::vector, s_.ray.origin + s_.given, s_.ray.origin, Role::first},
                      point("a", s_.vertex(0), Role::second),
                      point("b", s_.vertex(1), Role::second),
                      point("c", s_.vertex(2), Role::second)};
    if (s_.seam()) scene_.handles.push_back(point("q", s_.neighbour.vertices[2], Role::text));
    const Vec3& d = s_.ray.direction;
    const double dd = d.squaredNorm();
    if (s_.segment() && dd > 0)
      scene_.handles.push_back(
          {"t_max", Handle::Kind::along, s_.ray.at(end_), s_.ray.origin, Role::first, Vec3(d / dd)});
  }

  const Setup& s_;
  const Known& k_;
  const bool neighbour_;
  bool crossing_ = false;  ///< the line meets the plane not too far away to be drawn
  double end_ = 1;         ///< t where the drawn ray ends
  Scene scene_;
};

/// A point of a drawing in the plane, on the plane that faces the camera.
Vec3 towards_camera(const Vec2& p) {
  const View view(Camera{}, 1, 1);
  return p.x() * view.right() + p.y() * view.up();
}
Vec3 towards_camera(const Vec3& p) { return towards_camera(Vec2(p.x(), p.y())); }

/// Moves a drawing to the middle of the picture in space, so that the camera stands still.
std::vector<Item> in_the_middle(std::vector<Item> items, const Setup& s) {
  const Box2 own = extent(items, Camera{}), whole = extent(picture(s, {}).items, Camera{});
  return viz::moved(std::move(items), towards_camera(Vec2((whole.lo + whole.hi - own.lo - own.hi) / 2)));
}

}  // namespace

Scene picture(const Setup& setup, const Known& known) { return Painter(setup, known).paint(); }

Scene sheared(const Setup& s, const std::array<Vec2, 3>& corners, bool filled) {
  constexpr double scale = 1.25;
  Inset inset;
  const auto at = [&](int i) { return towards_camera(Vec2(scale * corners[i])); };
  if (filled) inset.items.emplace_back(Region{.rings = {{at(0), at(1), at(2)}}, .role = Role::second});
  for (int i = 0; i < 3; ++i) {
    inset.items.emplace_back(Dot{at(i), Mark::disc, Role::second});
    inset.items.emplace_back(Label{at(i), std::string(vertex_names[i]) + "′", Role::second});
  }
  inset.items.emplace_back(Dot{Vec3::Zero(), Mark::disc, Role::first});
  inset.items.emplace_back(Label{Vec3::Zero(), "the ray", Role::first});
  inset.heading = "seen along the ray";
  Scene scene;
  scene.items = in_the_middle(small_multiples({inset}, 1, Camera{}), s);
  return scene;
}

Scene cells(const Setup& s, std::vector<Cell> all, const std::vector<std::pair<Role, std::string>>& keys) {
  Scene scene;
  microscope::add_cells(scene, std::move(all), s.selected);
  microscope::Keys key(scene);
  for (const auto& [role, text] : keys) key.add(role, text);
  for (Item& item : scene.items) {
    if (Raster* raster = std::get_if<Raster>(&item)) {
      raster->corner = towards_camera(raster->corner);
      raster->across = towards_camera(raster->across), raster->down = towards_camera(raster->down);
    } else if (Heading* heading = std::get_if<Heading>(&item)) {
      heading->at = towards_camera(heading->at);
    } else if (Line* line = std::get_if<Line>(&item)) {
      line->from = towards_camera(line->from), line->to = towards_camera(line->to);
    } else if (Dot* dot = std::get_if<Dot>(&item)) {
      dot->at = towards_camera(dot->at);
    }
  }
  for (Handle& handle : scene.handles) {
    handle.at = towards_camera(handle.at), handle.anchor = towards_camera(handle.anchor);
    handle.direction = towards_camera(handle.direction);
  }
  return scene;
}

}  // namespace isect::lessons::ray_triangle_lesson
