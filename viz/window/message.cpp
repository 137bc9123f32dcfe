// The current message over the scene, where it covers least of what is to be read.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "viz/window/scene_marks.h"

namespace isect::viz {
namespace {

/// Returns the square px of a rectangle that lie within another one.
float shared(const Rect& a, const Rect& b) {
  const float across = std::min(a.right, b.right) - std::max(a.left, b.left);
  const float down = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
  return across > 0 && down > 0 ? across * down : 0;
}

/// Returns the usual place: low in the middle, above what stands in the lower corners.
Rect usual_place(const Ui& ui, const Rect& scene, float width, float height) {
  const float left = std::round(scene.middle_x() - width / 2), top = std::round(scene.bottom - 68 - height);
  Rect r{left, top, left + width, top + height};
  for (const char* mark : {"tripod", "changed", "pin", "projection"}) {
    const auto found = ui.rects.find(mark);
    if (found == ui.rects.end()) continue;
    const Rect& at = found->second;
    const bool meets = at.left < r.right && r.left < at.right && at.top < r.bottom + 4 && r.top < at.bottom;
    if (meets) r.bottom = std::round(at.top - 4), r.top = r.bottom - height;
  }
  return r;
}

/// What a message should not cover: the larger the weight, the less.
struct Kept {
  Rect at;
  float weight;
};

/// Returns the labels and handles of a scene, and its chips and marks, which a message hardly ever covers.
std::vector<Kept> kept_free(const Ui& ui, const Rect& scene, const std::vector<PlacedLabel>& labels) {
  constexpr float mark_weight = 1000;
  std::vector<Kept> kept;
  for (const PlacedLabel& label : labels) {
    const auto x = [&](double at) { return scene.left + static_cast<float>(at); };
    const auto y = [&](double at) { return scene.top + static_cast<float>(at); };
    kept.push_back({{x(label.box.left), y(label.box.top), x(label.box.right), y(label.box.bottom)}, 1});
  }
  for (const char* mark : {"verdict", "alarm", "tripod", "changed", "pin", "projection", "words on the handle"})
    if (const auto found = ui.rects.find(mark); found != ui.rects.end()) kept.push_back({found->second, mark_weight});
  for (auto at = ui.rects.lower_bound("handle "); at != ui.rects.end() && at->first.starts_with("handle "); ++at)
    kept.push_back({at->second, 1});
  return kept;
}

/// Returns the usual place or, if it covers something, one at its height or above that covers least, the nearest one of
/// several.
Rect clear_place(const Rect& usual, const Rect& scene, const std::vector<Kept>& kept) {
  const auto covered = [&](const Rect& r) {
    float sum = 0;
    for (const Kept& one : kept) sum += one.weight * shared(r, one.at);
    return sum;
  };
  constexpr float edge = 4, pitch = 3;
  Rect best = usual;
  float least = covered(usual);
  if (least == 0) return best;
  const float width = usual.width(), height = usual.height();
  const int rows = static_cast<int>(std::max(0.0f, std::ceil((usual.top - scene.top - edge) / pitch)));
  for (int row = 0; row <= rows; ++row) {
    const float top = std::max(usual.top - pitch * static_cast<float>(row), std::min(usual.top, scene.top + edge));
    for (const float left : {usual.left, std::round(scene.right - 12 - width), std::round(scene.left + 12)}) {
      const Rect r{left, top, left + width, top + height};
      const float now = covered(r);
      if (now < least) best = r, least = now;
    }
  }
  return best;
}

}  // namespace

void toast(Ui& ui, const Toast& toast, const Rect& scene, const std::vector<PlacedLabel>& labels,
           const std::string& shown, MessagePlace& kept) {
  if (toast.seconds_left <= 0) return kept.of.clear();
  const Colour& ink = toast.error ? ui.palette.miss : ui.palette.hit;
  ImFont* font = ui.fonts.body;
  const float room = std::min(scene.width() - 40, 560.0f), size = font->FontSize * font->Scale;
  const ImVec2 words = font->CalcTextSizeA(size, room - 56, room - 56, toast.text.c_str());
  const Rect usual = usual_place(ui, scene, words.x + 56, words.y + 22);
  const std::string of =
      fmt::format("{} {} {} {} {} {}", toast.text, shown, scene.width(), scene.height(), usual.left, usual.top);
  if (kept.of != of) kept = {of, clear_place(usual, scene, kept_free(ui, scene, labels))};
  const Rect& r = kept.at;
  ui.rects["message"] = r;
  filled(r, ui.palette.window, 8);
  outlined(r, ink, 1.5f, 8);
  (toast.error ? cross : tick)(r.left + 20, r.middle_y(), 13, packed(ink));
  ImGui::GetWindowDrawList()->AddText(font, size, {r.left + 38, r.top + 11}, packed(ui.palette.text),
                                      toast.text.c_str(), nullptr, room - 56);
}

}  // namespace isect::viz
