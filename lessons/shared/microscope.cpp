#include "lessons/shared/microscope.h"

#include <fmt/format.h>

#include <utility>

namespace isect::lessons::microscope {

using namespace viz;

namespace {

constexpr double side = 5.2, left = -2.3, bottom = -2;  // of the grid
constexpr double cell = side / columns, middle = side / 2;

/// Adds how many steps away the border is, except where the lines' grips and names stand.
void add_axes(Scene& scene, const std::array<int, 2>& selected) {
  constexpr double near = 9;
  const auto number = [&](int steps, int looked_at, const Vec3& at, double lean) {
    if (std::abs(steps - looked_at) <= near) return;
    scene.items.emplace_back(Heading{at, shown(steps), Role::muted, 0, false, lean});
  };
  for (const int steps : {-half, half}) {
    const double along = middle + cell * steps;
    number(steps, selected[0], {left + along, bottom - 0.4, 0}, 0.5);
    number(steps, selected[1], {left - 0.14, bottom + along, 0}, 1);
  }
}

/// Adds two lines that meet in the selected neighbour, each with a grip at the rim.
void add_crosshair(Scene& scene, const std::array<int, 2>& selected) {
  constexpr double rim = 0.6, end = 0.9;  // a grip has room for its name beside it
  const Vec3 centre = {left + middle, bottom + middle, 0};
  const Vec3 at = centre + cell * Vec3(selected[0], selected[1], 0);
  const Vec3 below = {at.x(), bottom - rim, 0}, beside = {left - rim, at.y(), 0};
  scene.items.emplace_back(Line{{at.x(), bottom - end, 0}, at, Role::construction, Pen::construction});
  scene.items.emplace_back(Line{{left - end, at.y(), 0}, at, Role::construction, Pen::construction});
  scene.items.emplace_back(Dot{at, Mark::ring, Role::text});
  scene.handles = {{"right", Handle::Kind::along, below, {centre.x(), below.y(), 0}, Role::text, Vec3::UnitX() / cell},
                   {"up", Handle::Kind::along, beside, {beside.x(), centre.y(), 0}, Role::text, Vec3::UnitY() / cell}};
}

}  // namespace

Parameter steps_towards(const std::string& direction) {
  const std::string to = direction == "right" ? "to the right" : direction;
  return {direction,
          direction,
          fmt::format("Which neighbour is ringed: steps {}, -{} to {}, rounded to an integer.", to, half, half),
          0.0,
          -half,
          half,
          -half,
          half};
}

std::array<int, 2> selected_of(const Parameters& values) {
  const auto cells = [&](const char* name) { return static_cast<int>(std::round(std::get<double>(values.at(name)))); };
  return {cells("right"), cells("up")};
}

void add_cells(Scene& scene, std::vector<Cell> cells, const std::array<int, 2>& selected) {
  scene.items.emplace_back(
      Raster{{left, bottom + side, 0}, {side, 0, 0}, {0, -side, 0}, columns, std::move(cells), true});
  add_crosshair(scene, selected);
  add_axes(scene, selected);
}

Keys::Keys(Scene& scene) : scene_(scene), y_(bottom + side - 0.4) {}

void Keys::add(Role ink, const std::string& text) {
  const Vec3 corner = {left + side + 0.45, y_ + 0.16, 0};
  const bool pale = ink == Role::highlight || ink == Role::grid;
  scene_.items.emplace_back(Raster{corner, {0.32, 0, 0}, {0, -0.32, 0}, 1, {{ink, {}}}, true});
  scene_.items.emplace_back(Heading{{left + side + 0.95, y_, 0}, text, pale ? Role::text : ink, 3.1, false, 0});
  y_ -= 0.6;
}

}  // namespace isect::lessons::microscope
