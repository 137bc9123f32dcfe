#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

#include "viz/text/rich_text.h"
#include "viz/window/number_text.h"
#include "viz/window/panels.h"

namespace isect::viz {
namespace {

constexpr float field_height = 32;

/// Returns the number that was typed into this field, once it is complete; a refusal is shown below the field.
std::optional<double> typed(WindowSession& s, const std::string& field) {
  Fields::Typing& typing = s.fields.typing;
  // Dear ImGui focuses it in one of the next frames, and 1.90 only within the window that has the focus already.
  if (!typing.begun && typing.frames++ % 4 == 0) {
    ImGui::SetWindowFocus();
    ImGui::SetKeyboardFocusHere();
  }
  const bool entered = ImGui::InputText(("##" + field).c_str(), &typing.text,
                                        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  const bool left = left_by_tab(s.ui, field) || (typing.begun && !ImGui::IsItemActive());
  if (ImGui::IsItemActive()) typing.begun = true;
  if (!entered && !left) return std::nullopt;
  const std::string text = std::exchange(typing, {}).text;
  s.fields.refused = {};
  try {
    return number_from(text);
  } catch (const BadInput& wrong) {
    s.fields.refused = {field, wrong.what(), s.player.revision()};
    return std::nullopt;
  }
}

/// Returns a format with as many digits, up to `most`, as there is room for.
std::string format_for(ImFont* font, double value, float room, int most) {
  for (int digits = most; digits > 2; --digits) {
    const std::string format = "%." + std::to_string(digits) + "g";
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), format.c_str(), value);
    if (text_width(font, text.data()) <= room) return format;
  }
  return "%.2g";
}

/// Draws a number to drag along; Ctrl+click, a double click or Enter begin to type it. Returns the new value, if any.
std::optional<double> number_field(WindowSession& s, const std::string& name, const Parameter& p, double value,
                                   const Rect& r, bool slider) {
  const std::string field = "parameter " + name;
  s.ui.rects[field] = r;
  const bool held = focused(s.ui, field, r);
  ImGui::SetCursorScreenPos(top_left(r));
  ImGui::SetNextItemWidth(r.width());
  if (s.fields.typing.field == field) {
    const std::optional<double> number = typed(s, field);
    if (number && !(p.lo <= *number && *number <= p.hi)) {
      Parameter one = p;
      one.initial = 0.0;  // in a vector only this number is wrong
      s.fields.refused = {field, with_minus_signs("give " + wanted(one)), s.player.revision()};
      return std::nullopt;
    }
    if (number) s.player.end_action(), s.player.remember("type");
    return number;
  }
  const bool hovered = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(top_left(r), bottom_right(r));
  const bool click = ImGui::IsMouseClicked(ImGuiMouseButton_Left) && ImGui::GetIO().KeyCtrl;
  if ((held && s.ui.focus.pressed()) || (hovered && (click || ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)))) {
    s.fields.typing = {field, to_text(Setting(value))};
    return std::nullopt;
  }
  const std::string id = "##" + name;
  constexpr ImGuiSliderFlags by_hand = ImGuiSliderFlags_NoInput;
  const std::string format = format_for(s.ui.fonts.small, value, r.width() - 6, slider ? 5 : 4);
  const bool changed = slider ? ImGui::SliderScalar(id.c_str(), ImGuiDataType_Double, &value, &p.drag_lo, &p.drag_hi,
                                                    format.c_str(), by_hand)
                              : ImGui::DragScalar(id.c_str(), ImGuiDataType_Double, &value,
                                                  static_cast<float>((p.drag_hi - p.drag_lo) / 800), nullptr, nullptr,
                                                  format.c_str(), by_hand);
  if (ImGui::IsItemActivated()) {
    s.player.end_action();
    s.player.remember("edit");
  }
  if (ImGui::IsItemHovered() && !ImGui::IsItemActive())
    tooltip(s.ui, p.help + "\nCtrl+click to type it: 1,5 or 1e-3 or 2*pi or 1/3");
  if (!changed) return std::nullopt;
  s.fields.refused = {};
  return value;
}

/// Sets a parameter. A refusal is shown below its field.
void edit(WindowSession& s, const std::string& parameter, const std::string& field, const Setting& value) {
  try {
    s.player.edit(parameter, value);
  } catch (const BadInput& refused) {
    s.fields.refused = {field, refused.what(), s.player.revision()};
  }
}

/// Draws why the last number was refused, if it was one of this parameter's. Returns the height that takes.
float refusal(WindowSession& s, const std::string& name, float x, float y, float width) {
  const std::string field = "parameter " + name;
  if (s.fields.refused.revision != s.player.revision()) return 0;
  if (s.fields.refused.field != field && !s.fields.refused.field.starts_with(field + ".")) return 0;
  const Paragraph p{.markup = as_markup(s.fields.refused.why),
                    .width = width,
                    .size = 13,
                    .line_pitch = 18,
                    .colour = s.ui.palette.miss};
  const ImVec2 size = rich(s.ui, p, {x, y});
  s.ui.rects["refused " + s.fields.refused.field] = {x, y, x + width, y + size.y};
  return size.y + 6;
}

void number(WindowSession& s, const Parameter& p, double value, const Rect& r) {
  if (const auto now = number_field(s, p.name, p, value, r, true)) edit(s, p.name, "parameter " + p.name, *now);
}

void vector(WindowSession& s, const Parameter& p, const Vec3& value, const Rect& r) {
  constexpr const char* axes[] = {"x", "y", "z"};
  const int count = s.player.lesson().flat ? 2 : 3;  // a plane lesson does not use the third coordinate
  const float width = std::floor((r.width() - 4 * static_cast<float>(count - 1)) / static_cast<float>(count));
  for (int i = 0; i < count; ++i) {
    const float x = r.left + static_cast<float>(i) * (width + 4);
    const std::string name = p.name + "." + axes[i];
    const auto now = number_field(s, name, p, value[i], {x, r.top, x + width, r.bottom}, false);
    if (!now) continue;
    Vec3 changed = value;
    changed[i] = *now;
    edit(s, p.name, "parameter " + name, changed);
  }
}

/// Draws the choices as chips that wrap into lines. Returns the height they took.
float choice(WindowSession& s, const Parameter& p, const std::string& value, const Rect& r) {
  float x = r.left, y = r.top;
  for (const std::string& c : p.choices) {
    std::string title = c;
    for (const Method& m : s.player.played().methods())
      if (p.name == s.player.lesson().group_by && m.choice == c) title = plain(m.title);
    title = fitted(s.ui.fonts.small, title, r.width() - 18);
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

/// Draws parameters pale that have no effect in this setting, and says when they would.
void without_effect(WindowSession& s, const Parameter& p, const Rect& r) {
  s.ui.rects["without effect " + p.name] = r;
  filled(r, s.ui.palette.window.with_alpha(0.6), 0);
  const bool hovered = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) &&
                       ImGui::IsMouseHoveringRect(top_left(r), bottom_right(r));
  if (hovered) tooltip(s.ui, told_where(p) + ".\n" + p.help);
}

const std::string& label_of(const Parameter& p) { return p.label.empty() ? p.name : p.label; }

float label_width(WindowSession& s) {
  float widest = 40;
  for (const Parameter& p : s.player.lesson().parameters)
    widest = std::max(widest, s.ui.texts.size_of({.markup = label_of(p), .colour = s.ui.palette.text}).x);
  return std::min(widest + 12, 96.0f);
}

}  // namespace

float parameter_fields(WindowSession& s, float x, float y, float width) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2{6, 5});
  ImGui::PushStyleVar(ImGuiStyleVar_GrabMinSize, 8);
  ImGui::PushStyleColor(ImGuiCol_SliderGrab, packed(s.ui.palette.first, 0.65));
  ImGui::PushFont(s.ui.fonts.small);
  const Parameters now = s.player.parameters();  // a field may change the player's own during this loop
  const float labels = label_width(s);
  for (const Parameter& p : s.player.lesson().parameters) {
    if (!now.contains(p.name)) continue;
    const Setting& value = now.at(p.name);
    const Rect r{x + labels, y, x + width, y + 26};
    ImGui::PushClipRect({x, y}, {r.left - 4, y + field_height}, true);
    rich_line(s.ui, {.markup = label_of(p), .colour = s.ui.palette.text}, x, y + 13);
    ImGui::PopClipRect();
    if (const double* real = std::get_if<double>(&value)) number(s, p, *real, r);
    if (const Vec3* v = std::get_if<Vec3>(&value)) vector(s, p, *v, r);
    if (const std::string* word = std::get_if<std::string>(&value)) y += choice(s, p, *word, r);
    if (!counts(p, now)) without_effect(s, p, {x, r.top - 2, x + width, y + 28});
    y += field_height;
    y += refusal(s, p.name, x + labels, y - 4, width - labels);
  }
  ImGui::SetCursorScreenPos({x, y});
  ImGui::Dummy({1, 4});
  ImGui::PopFont();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
  return y + 4;
}

}  // namespace isect::viz
