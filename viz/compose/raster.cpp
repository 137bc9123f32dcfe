// Rasters: few cells with sharp edges. Equal cells that touch become one outline, so that a vector file stays small.

#include <algorithm>
#include <map>

#include "viz/compose/canvas.h"
#include "viz/compose/raster.h"

namespace isect::viz {
namespace {

/// Cells of one look: role and light in sixteenths; -1 for the role's own.
using Look = std::pair<Role, int>;

Look look_of(const Cell& cell) {
  if (!cell.light) return {cell.role, -1};
  return {cell.role, static_cast<int>(std::lround(16 * std::clamp(*cell.light, 0.0, 1.0)))};
}

/// Returns a cell's share of the role's ink. Lit cells are bright: little ink on paper, much on a dark screen.
double share_of(const Look& look, ThemeName theme) {
  if (look.second >= 0) return 0.2 + 0.05 * (theme == ThemeName::dark ? look.second : 16 - look.second);
  if (look.first == Role::grid) return 0.5;
  return look.first == Role::first || look.first == Role::second ? 0.26 : 1;
}

/// Returns a cell's fill. Where grey print cannot tell two colours apart, the second object has dark lines, a hit light
/// ones on black, and "on" is left white.
Fill filled(const Canvas& c, const Look& look) {
  const double share = share_of(look, c.theme.name);
  const Colour ink = c.theme.ink(look.first), &paper = c.theme.background;
  Fill fill = {{}, mixed(paper, ink, share), 0, 0, {}};
  if (!c.theme.hatch_second) return fill;
  const auto hatch = [&](const Colour& colour, double line) {
    fill.hatch_gap = 0.6 * c.sizes().hatch_gap, fill.hatch_line = line * c.sizes().hatch_line;
    fill.hatch_colour = colour;
  };
  if (look.first == Role::highlight) fill.colour = paper;
  if (look.first == Role::hit && look.second < 0) hatch(paper, 3);
  if (look.first == Role::second) {
    fill.colour = mixed(paper, ink, 0.5 * share);
    hatch(ink, 1.5);
  }
  return fill;
}

}  // namespace

void draw(Canvas& c, const Raster& it) {
  const int columns = it.columns, rows = columns > 0 ? static_cast<int>(it.cells.size()) / columns : 0;
  if (rows == 0) return;
  std::vector<Look> looks;
  std::map<Look, int> count;
  for (int i = 0; i < rows * columns; ++i) {
    looks.push_back(look_of(it.cells[i]));
    ++count[looks.back()];
  }
  const auto corner = [&](const Corner& p) {
    return c.at(it.corner + static_cast<double>(p.x()) / columns * it.across +
                static_cast<double>(p.y()) / rows * it.down);
  };
  const auto path = [&](const std::vector<Corner>& ring) {
    std::vector<Vec2> points;
    for (const Corner& p : ring) points.push_back(corner(p));
    return polyline(points, true);
  };
  const Path frame = path({{0, 0}, {columns, 0}, {columns, rows}, {0, rows}});

  // The most frequent look lies under all others: less to draw, and no seam shows the background.
  const auto most =
      std::max_element(count.begin(), count.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  Fill base = filled(c, most->first);
  base.path = frame;
  const bool plain_base = base.hatch_gap == 0;  // a hatch would show through the others
  if (!plain_base) base.hatch_gap = 0;
  c.fills.emplace_back(base);
  for (const auto& [look, cells] : count) {
    if (look == most->first && plain_base) continue;
    Fill fill = filled(c, look);
    std::vector<Path> paths;
    for (const std::vector<Corner>& ring : outlines(looks, columns, look)) paths.push_back(path(ring));
    fill.path = paths.front();
    fill.more.assign(paths.begin() + 1, paths.end());
    c.fills.emplace_back(fill);
  }
  if (it.framed)
    c.lines.emplace_back(Stroke{frame, c.theme.ink(Role::construction), c.sizes().construction, {0, 0}, true});
  for (int i = 0; i <= 12; ++i)  // labels keep off all of it
    c.block({corner({0, i * rows / 12}), corner({columns, i * rows / 12})}, c.sizes().construction, true);
}

}  // namespace isect::viz
