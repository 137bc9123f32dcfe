#include <algorithm>
#include <cmath>

#include "viz/rich_text.h"
#include "viz/window/panels.h"

namespace isect::viz {
namespace {

constexpr float field_height = 32;

/// A number to drag along; Ctrl+click types it. `edited` gets the new value.
bool number_field(Session& s, const std::string& name, const Parameter& p, double& value, const Rect& r, bool slider) {
  s.ui.rects["parameter " + name] = r;
  ImGui::SetCursorScreenPos(top_left(r));
  ImGui::SetNextItemWidth(r.width());
  const std::string id = "##" + name;
  const bool changed =
      slider ? ImGui::SliderScalar(id.c_str(), ImGuiDataType_Double, &value, &p.drag_lo, &p.drag_hi, "%.5g")
             : ImGui::DragScalar(id.c_str(), ImGuiDataType_Double, &value,
                                 static_cast<float>((p.drag_hi - p.drag_lo) / 800), nullptr, nullptr, "%.4g");
  if (ImGui::IsItemActivated()) {
    s.player.end_action();
    s.player.remember("edit");
  }
  if (ImGui::IsItemHovered() && !ImGui::IsItemActive()) tooltip(s.ui, p.help + "\nCtrl+click to type it");
  return changed;
}

void number(Session& s, const Parameter& p, double value, const Rect& r) {
  if (!number_field(s, p.name, p, value, r, true)) return;
  s.attempt([&] { s.player.edit(p.name, value); });
}

void vector(Session& s, const Parameter& p, Vec3 value, const Rect& r) {
  constexpr const char* axes[] = {"x", "y", "z"};
  const float width = std::floor((r.width() - 8) / 3);
  bool changed = false;
  for (int i = 0; i < 3; ++i) {
    const float x = r.left + static_cast<float>(i) * (width + 4);
    changed |= number_field(s, p.name + "." + axes[i], p, value[i], {x, r.top, x + width, r.bottom}, false);
  }
  if (changed) s.attempt([&] { s.player.edit(p.name, value); });
}

/// The choices as chips that wrap into lines. Returns the height they took.
float choice(Session& s, const Parameter& p, const std::string& value, const Rect& r) {
  float x = r.left, y = r.top;
  for (const std::string& c : p.choices) {
    std::string title = c;
    for (const Method& m : s.player.methods())
      if (p.name == s.player.lesson().group_by && m.choice == c) title = plain(m.title);
    const float width = text_width(s.ui.fonts.small, title) + 18;
    if (x > r.left && x + width > r.right) {
      x = r.left;
      y += 30;
    }
    const Rect chip_rect{x, y, x + width, y + 26};
    if (chip(s.ui, "parameter " + p.name + "." + c, chip_rect, title, c == value, s.ui.fonts.small))
      s.attempt([&] { p.name == s.player.lesson().group_by ? s.player.load_method(c) : s.player.edit(p.name, c); });
    x += width + 6;
  }
  return y - r.top;
}

const std::string& label_of(const Parameter& p) { return p.label.empty() ? p.name : p.label; }

float label_width(Session& s) {
  float widest = 40;
  for (const Parameter& p : s.player.lesson().parameters)
    widest = std::max(widest, s.ui.texts.of({.markup = label_of(p), .colour = s.ui.palette.text}).size.x);
  return std::min(widest + 12, 96.0f);
}

}  // namespace

float parameter_fields(Session& s, float x, float y, float width) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2{6, 5});
  ImGui::PushStyleVar(ImGuiStyleVar_GrabMinSize, 8);
  ImGui::PushStyleColor(ImGuiCol_SliderGrab, packed(s.ui.palette.first, 0.65));
  ImGui::PushFont(s.ui.fonts.small);
  const Parameters now = s.player.parameters();  // a field may change the player's own while we go through it
  const float labels = label_width(s);
  for (const Parameter& p : s.player.lesson().parameters) {
    const Setting& value = now.at(p.name);
    const Rect r{x + labels, y, x + width, y + 26};
    ImGui::PushClipRect({x, y}, {r.left - 4, y + field_height}, true);
    rich_line(s.ui, {.markup = label_of(p), .colour = s.ui.palette.text}, x, y + 13);
    ImGui::PopClipRect();
    if (const double* real = std::get_if<double>(&value)) number(s, p, *real, r);
    if (const Vec3* v = std::get_if<Vec3>(&value)) vector(s, p, *v, r);
    if (const std::string* word = std::get_if<std::string>(&value)) y += choice(s, p, *word, r);
    y += field_height;
  }
  ImGui::SetCursorScreenPos({x, y});
  ImGui::Dummy({1, 4});
  ImGui::PopFont();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
  return y + 4;
}

}  // namespace isect::viz
