#include "viz/compose/compose.h"

#include <algorithm>
#include <iterator>

#include "viz/chart/chart.h"
#include "viz/compose/canvas.h"
#include "viz/compose/halos.h"
#include "viz/compose/item_names.h"
#include "viz/compose/own_colours.h"
#include "viz/text/rich_text.h"

namespace isect::viz {
namespace {

// Drawn before the other items, far to near.
void draw(Canvas&, const Ball&) {}
void draw(Canvas&, const Solid&) {}

}  // namespace

Composed compose(const Scene& scene, const View& view, const Theme& theme, bool handles) {
  if (scene.chart) return compose(*scene.chart, view.corner(), view.width(), view.height(), theme);
  const Theme own = with_colours(theme, scene.colours);
  Canvas canvas(scene, view, own, handles);
  Composed result;
  result.objects = objects_of(scene);
  if (theme.floor_grid && view.camera().elevation > 0.05 && !is_page(scene))
    canvas.own(add_object(result.objects, {"floor", "grid", Role::grid}), [&] { draw_floor(canvas); });
  for (std::size_t i = 0; i < canvas.ball_items.size(); ++i)
    canvas.own(canvas.ball_items[i], [&] { draw_ball(canvas, static_cast<int>(i)); });
  for (std::size_t i = 0; i < canvas.capsule_items.size(); ++i) {
    const Line& axis = std::get<Line>(scene.items[canvas.capsule_items[i]]);
    canvas.own(add_object(result.objects, {"capsule", plain(axis.name), axis.role}),
               [&] { draw_capsule(canvas, static_cast<int>(i), axis.role); });
  }
  draw_solids(canvas);
  for (std::size_t i = 0; i < scene.items.size(); ++i)
    canvas.own(static_cast<int>(i), [&] { std::visit([&](const auto& it) { draw(canvas, it); }, scene.items[i]); });
  if (handles)
    for (const Handle& handle : scene.handles)
      canvas.own(add_object(result.objects, {"handle", handle.id(), handle.role}), [&] { draw(canvas, handle); });

  for (std::vector<Shape>* layer : canvas.layers()) std::ranges::move(*layer, std::back_inserter(result.shapes));
  add_halos_over_lines(result.shapes, theme);  // headings, which keep their places; labels keep off lines
  const Vec2 corner = view.corner();
  const double margin = theme.sizes.margin;
  const Bounds bounds = {corner.x() + margin, corner.y() + margin, corner.x() + view.width() - margin,
                         corner.y() + view.height() - margin};
  result.labels = place_labels(canvas.labels, canvas.obstacles, bounds, theme, result.shapes);
  result.labels.insert(result.labels.end(), canvas.placed.begin(), canvas.placed.end());
  add_halos(result.shapes, theme);
  return result;
}

}  // namespace isect::viz
