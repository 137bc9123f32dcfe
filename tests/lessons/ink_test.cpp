// How much of its frame each picture uses.

#include <algorithm>

#include "tests/catch.h"
#include "tests/lessons/asked_for.h"
#include "tests/viz/drawn.h"
#include "viz/chart/case_map.h"
#include "viz/chart/chart.h"
#include "viz/compose/compose.h"
#include "viz/compose/halos.h"
#include "viz/text/text.h"
#include "viz/walk/closing.h"

namespace ink_test {
using namespace isect;
using namespace isect::viz;

namespace {

void grow(Box2& box, const Vec2& lo, const Vec2& hi) { box = {box.lo.cwiseMin(lo), box.hi.cwiseMax(hi)}; }

/// The box of all that is drawn but the grid and the page's own texts.
Box2 ink(const Drawing& drawing) {
  Box2 box = {Vec2::Constant(INFINITY), Vec2::Constant(-INFINITY)};
  const auto path = [&](const Path& p) {
    for (const Vec2& q : flatten(p)) grow(box, q, q);
  };
  for (const Shape& shape : drawing.shapes) {
    const int object = object_of(shape);
    if (object != no_object && (drawing.objects[object].kind == "page" || drawing.objects[object].kind == "floor"))
      continue;
    if (const auto* fill = std::get_if<Fill>(&shape)) path(fill->path);
    if (const auto* stroke = std::get_if<Stroke>(&shape)) path(stroke->path);
    if (const auto* ball = std::get_if<Gradient>(&shape)) path(ellipse(ball->center, ball->major, ball->minor));
    if (const auto* facets = std::get_if<Facets>(&shape))
      for (const Vec2& corner : facets->corners) grow(box, corner, corner);
    if (const auto* text = std::get_if<Text>(&shape)) {
      const TextBox b = measure(*text);
      grow(box, {b.left, b.top}, {b.right, b.bottom});
    }
  }
  return box;
}

}  // namespace

TEST_CASE("every picture uses 60 % of its frame's width or height", "[every lesson]") {
  for (const Lesson* lesson : those_asked_for()) {
    std::vector<Walk> walks;
    for (const Preset& p : lesson->presets) walks.push_back(walk_with_map(*lesson, p.parameters));
    for (const ThemeName name : {ThemeName::screen, ThemeName::grey})
      for (std::size_t i = 0; i < walks.size(); ++i) {
        const PageLayout layout = page_layout(walks[i], name, 960, 600);
        const double aspect = picture_aspect(walks[i], name, 960, 600);
        const Camera camera = frame_alike(lesson->camera, walks[i], walks, aspect);
        for (const Step& step : walks[i].steps) {
          const Figure picture = figure(step, closer(camera, step.scene, aspect), layout);
          const Box2 box = ink(picture.drawing);
          const Vec2 frame(picture.view.width(), picture.view.height());
          const Vec2 share = (box.hi - box.lo).cwiseQuotient(frame);
          INFO(lesson->id << ' ' << lesson->presets[i].id << ", " << step.slug << ", " << name_of(name) << ": "
                          << share.x() << " of the width, " << share.y() << " of the height");
          CHECK(share.maxCoeff() >= 0.6);
        }
      }
  }
}

TEST_CASE("no card has smaller texts than a lecture hall can read", "[every lesson]") {
  for (const Lesson* lesson : those_asked_for())
    for (const ThemeName name : {ThemeName::screen, ThemeName::grey}) {
      const Step card = lesson->walk(lesson->presets.front().parameters).steps.back();
      REQUIRE(card.slug == closing_slug);
      double least = INFINITY;
      for (const Text& text : all<Text>(figure(card, lesson->camera, name, 960, 600).drawing.shapes))
        least = std::min(least, text.size);
      INFO(lesson->id << ", " << name_of(name));
      CHECK(least >= 19);  // of 600: 17 points on a slide
    }
}

TEST_CASE("every text stands out from what lies under it, or has a halo", "[every lesson]") {
  for (const Lesson* lesson : those_asked_for()) {
    std::vector<Walk> walks;
    for (const Preset& p : lesson->presets) walks.push_back(walk_with_map(*lesson, p.parameters));
    for (const ThemeName name : {ThemeName::screen, ThemeName::grey, ThemeName::dark})
      for (const Walk& walk : walks) {
        const double aspect = picture_aspect(walk, name, 960, 600);
        const Camera camera = frame_alike(lesson->camera, walk, walks, aspect);
        for (const Step& step : walk.steps) {
          const Drawing drawing = figure(step, closer(camera, step.scene, aspect), name, 960, 600).drawing;
          for (std::size_t i = 0; i < drawing.shapes.size(); ++i) {
            const Text* text = std::get_if<Text>(&drawing.shapes[i]);
            if (!text) continue;
            INFO(lesson->id << ", " << step.slug << ", " << name_of(name) << ": " << text->markup);
            const double found = text->halo > 0 ? contrast_ratio(text->colour, text->halo_colour)
                                                : contrast_of(drawing.shapes, i, drawing.background);
            CHECK(found >= least_contrast);
          }
        }
      }
  }
}

}  // namespace ink_test
