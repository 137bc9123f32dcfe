#include "viz/window/layout.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace isect::viz {

namespace {
constexpr float bar = 48, buttons = 88;
}

WindowLayout window_layout(float width, float height) {
  // 304 and 344 from 1280 px on; a smaller window takes a little from both, the scene still loses most.
  const float lesson = std::round(std::clamp(width * 0.2375f, 256.0f, 304.0f));
  const float code = std::round(std::clamp(width * 0.26875f, 304.0f, 344.0f));
  constexpr float least_scene = 400, scene_share = 0.56f;
  const float bottom = height - buttons, right = width - code;
  WindowLayout at{.top = {0, 0, width, bar},
                  .lesson = {0, bar, lesson, bottom},
                  .scene = {lesson, bar, right, bottom},
                  .code = {right, bar, width, bottom},
                  .transport = {0, bottom, width, height}};
  if (at.scene.width() >= least_scene) return at;
  const float middle = std::round(bar + scene_share * (bottom - bar));
  at.scene = {0, bar, right, middle};
  at.lesson = {0, middle, right, bottom};
  return at;
}

WindowLayout window_layout_without_panels(float width, float height, float told) {
  const float bottom = height - buttons;
  return {.top = {0, 0, width, bar},
          .lesson = {0, bottom - told, width, bottom},
          .scene = {0, bar, width, bottom - told},
          .code = {width, bar, width, bottom},
          .transport = {0, bottom, width, height}};
}

Halves halves(const Rect& r, float share) {
  Halves h{r, r};
  if (r.width() > 1.25f * r.height())
    h.first.right = h.second.left = std::round(r.right - share * r.width());
  else
    h.first.bottom = h.second.top = std::round(r.bottom - share * r.height());
  return h;
}

PanesLayout panes_layout(const WindowLayout& whole) {
  constexpr float head = 40, least_pane = 400;
  Rect all{whole.lesson.left, whole.scene.top, whole.top.right, whole.transport.top}, lesson = all;
  const bool beside = whole.lesson.top == whole.scene.top && all.width() - whole.lesson.width() >= 2 * least_pane;
  lesson.right = all.left = beside ? whole.lesson.right : all.left;
  const float middle = std::round(all.middle_x()), top = all.top + head;
  const float code = std::round(all.bottom - std::clamp(0.53f * (all.bottom - top), 200.0f, 430.0f));
  return {.lesson = lesson,
          .heads = {all.left, all.top, all.right, top},
          .first_scene = {all.left, top, middle, code},
          .second_scene = {middle, top, all.right, code},
          .first_code = {all.left, code, middle, all.bottom},
          .second_code = {middle, code, all.right, all.bottom}};
}

std::vector<float> chip_widths(const std::vector<float>& wide, float narrow, float gap, float width, int chosen) {
  std::vector<float> widths = wide;
  const float gaps = gap * static_cast<float>(std::max<std::size_t>(wide.size(), 1) - 1);
  const auto total = [&] { return std::accumulate(widths.begin(), widths.end(), gaps); };
  for (int i = static_cast<int>(widths.size()) - 1; i >= 0 && total() > width; --i)
    if (i != chosen) widths[i] = std::min(widths[i], narrow);
  return widths;
}

}  // namespace isect::viz
