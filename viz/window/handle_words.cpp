// What is told of the handle at the pointer: beside it while the pointer only points, at the edge of the picture while
// it drags, as words at the pointer would cover what moves.

#include <algorithm>
#include <cmath>
#include <vector>

#include "viz/text/names.h"
#include "viz/text/rich_text.h"
#include "viz/window/scene_marks.h"
#include "viz/window/scene_names.h"

namespace isect::viz {

void ring_handle(const Ui& ui, const View& view, const Handle& handle) {
  const Vec2 at = view.project(handle.at).at;
  const ImVec2 middle{static_cast<float>(at.x()), static_cast<float>(at.y())};
  ImGui::GetWindowDrawList()->AddCircle(middle, 14, packed(ui.palette.highlight), 32, 2);
}

std::string words_on_handle(const Player& player, const Handle& handle, const std::string& forbidden) {
  std::string name = handle.parameter, help;
  for (const Parameter& p : player.lesson().parameters)
    if (p.name == handle.parameter) {
      if (!p.label.empty()) name = plain(p.label);
      help = "\n" + p.help;
    }
  const std::string why = forbidden.empty() ? "" : "\n" + forbidden;
  if (!handle.with.empty() && !handle.one_of.empty()) return plain(handle.one_of) + why;
  if (!handle.name.empty() && !handle.one_of.empty()) name = plain(handle.one_of) + ": " + name;
  const auto value = player.parameters().find(handle.parameter);  // a parameter that was not moved yet has no value
  const Setting set = value == player.parameters().end() ? Setting(handle.at) : value->second;
  return name + " = " + value_in_words(set, player.lesson().flat) + help + why;
}

void words_at_edge(Ui& ui, const std::string& words, const Rect& scene, const std::vector<Vec2>& off) {
  constexpr float apart = 24;  // px
  ImFont* const font = ui.fonts.body;
  const float size = font->FontSize * font->Scale, room = std::min(scene.width() - 40, 420.0f);
  const ImVec2 extent = font->CalcTextSizeA(size, room, room, words.c_str());
  const float width = extent.x + 20, height = extent.y + 14, in = is_low(scene) ? 8.0f : 20.0f;
  const float alarm = ui.rects.contains("alarm") && is_low(scene) ? 36.0f : 0.0f;
  const float right = std::round(scene.right - in), top = std::round(scene.top + in + alarm);
  Rect r{right - width, top, right, top + height};
  const auto meets = [&](const Vec2& at) {
    return static_cast<float>(at.x()) > r.left - apart && static_cast<float>(at.y()) < r.bottom + apart;
  };
  if (std::ranges::any_of(off, meets)) {  // the corner at the bottom left, where the axes' directions stand
    const float left = std::round(scene.left + in), bottom = std::round(scene.bottom - in);
    r = {left, bottom - height, left + width, bottom};
  }
  ui.rects["words on the handle"] = r;
  filled(r, ui.palette.window.with_alpha(0.92), 8);
  outlined(r, ui.palette.rule, 1, 8);
  ImGui::GetWindowDrawList()->AddText(font, size, {r.left + 10, r.top + 7}, packed(ui.palette.text), words.c_str(),
                                      nullptr, room);
}

}  // namespace isect::viz
