#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

#include "viz/text/number_text.h"
#include "viz/text/rich_text.h"
#include "viz/window/panels.h"

namespace isect::viz {
namespace {

constexpr float field_height = 32;
/// With more parameters only the fields in view are drawn, and all labels have the same room.
constexpr std::size_t many_parameters = 200;

/// The fields of the parameters, and the player that they change.
struct Form {
  Player& player;
  Ui& ui;
  Fields& fields;
};

/// Returns the number that was typed into this field, once it is complete; a refusal is shown below the field.
std::optional<double> typed(const Form& form, const std::string& field) {
  Fields::Typing& typing = form.fields.typing;
  // Dear ImGui focuses it in one of the next frames, and 1.90 only within the window that has the focus already.
  if (!typing.begun && typing.frames++ % 4 == 0) {
    ImGui::SetWindowFocus();
    ImGui::SetKeyboardFocusHere();
  }
  const bool entered = ImGui::InputText(("##" + field).c_str(), &typing.text,
                                        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  const bool left = left_by_tab(form.ui, field) || (typing.begun && !ImGui::IsItemActive());
  if (ImGui::IsItemActive()) typing.begun = true;
  if (!entered && !left) return std::nullopt;
  const std::string text = std::exchange(typing, {}).text;
  form.fields.refused = {};
  try {
    return number_from(text);
  } catch (const BadInput& wrong) {
    form.fields.refused = {field, wrong.what(), form.player.revision()};
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
std::optional<double> number_field(const Form& form, const std::string& name, const Parameter& p, double value,
                                   const Rect& r, bool slider) {
  const std::string field = "parameter " + name;
  form.ui.rects[field] = r;
  const bool held = focused(form.ui, field, r);
  ImGui::SetCursorScreenPos(top_left(r));
  ImGui::SetNextItemWidth(r.width());
  if (form.fields.typing.field == field) {
    const std::optional<double> number = typed(form, field);
    if (number && !(p.lo <= *number && *number <= p.hi)) {
      Parameter one = p;
      one.initial = 0.0;  // in a vector only this number is wrong
      form.fields.refused = {field, with_minus_signs("give " + wanted(one)), form.player.revision()};
      return std::nullopt;
    }
    if (number) form.player.end_action(), form.player.remember("type");
    return number;
  }
  const bool hovered = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(top_left(r), bottom_right(r));
  const bool click = ImGui::IsMouseClicked(ImGuiMouseButton_Left) && ImGui::GetIO().KeyCtrl;
  if ((held && form.ui.focus.pressed()) || (hovered && (click || ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)))) {
    form.fields.typing = {field, to_text(Setting(value))};
    return std::nullopt;
  }
  const std::string id = "##" + name;
  constexpr ImGuiSliderFlags by_hand = ImGuiSliderFlags_NoInput;
  const std::string format = format_for(form.ui.fonts.body, value, r.width() - 6, slider ? 5 : 4);
  const bool changed = slider ? ImGui::SliderScalar(id.c_str(), ImGuiDataType_Double, &value, &p.drag_lo, &p.drag_hi,
                                                    format.c_str(), by_hand)
                              : ImGui::DragScalar(id.c_str(), ImGuiDataType_Double, &value,
                                                  static_cast<float>((p.drag_hi - p.drag_lo) / 800), nullptr, nullptr,
                                                  format.c_str(), by_hand);
  if (ImGui::IsItemActivated()) {
    form.player.end_action();
    form.player.remember("edit");
  }
  if (ImGui::IsItemHovered() && !ImGui::IsItemActive())
    tooltip(form.ui, p.help + "\nCtrl+click to type it: 1,5 or 1e-3 or 2*pi or 1/3");
  if (!changed) return std::nullopt;
  form.fields.refused = {};
  return value;
}

/// Sets a parameter. A refusal is shown below its field.
void edit(const Form& form, const std::string& parameter, const std::string& field, const Setting& value) {
  try {
    form.player.edit(parameter, value);
  } catch (const BadInput& refused) {
    form.fields.refused = {field, refused.what(), form.player.revision()};
  }
}

/// Draws why the last number was refused, if it was one of this parameter's. Returns the height that takes.
float refusal(const Form& form, const std::string& name, float x, float y, float width) {
  const std::string field = "parameter " + name;
  if (form.fields.refused.revision != form.player.revision()) return 0;
  if (form.fields.refused.field != field && !form.fields.refused.field.starts_with(field + ".")) return 0;
  const Paragraph p{
      .markup = as_markup(form.fields.refused.why), .width = width, .line_pitch = 19, .colour = form.ui.palette.miss};
  const ImVec2 size = rich(form.ui, p, {x, y});
  form.ui.rects["refused " + form.fields.refused.field] = {x, y, x + width, y + size.y};
  return size.y + 6;
}

void number(const Form& form, const Parameter& p, double value, const Rect& r) {
  if (const auto now = number_field(form, p.name, p, value, r, true)) edit(form, p.name, "parameter " + p.name, *now);
}

void vector(const Form& form, const Parameter& p, const Vec3& value, const Rect& r) {
  constexpr const char* axes[] = {"x", "y", "z"};
  const int count = form.player.lesson().flat ? 2 : 3;  // a plane lesson does not use the third coordinate
  const float width = std::floor((r.width() - 4 * static_cast<float>(count - 1)) / static_cast<float>(count));
  for (int i = 0; i < count; ++i) {
    const float x = r.left + static_cast<float>(i) * (width + 4);
    const std::string name = p.name + "." + axes[i];
    const auto now = number_field(form, name, p, value[i], {x, r.top, x + width, r.bottom}, false);
    if (!now) continue;
    Vec3 changed = value;
    changed[i] = *now;
    edit(form, p.name, "parameter " + name, changed);
  }
}

/// Draws the choices as chips that wrap into lines. Returns the height they took.
float choice(Player& player, Ui& ui, Toast& toast, const Parameter& p, const std::string& value, const Rect& r) {
  float x = r.left, y = r.top;
  for (const std::string& c : p.choices) {
    const std::string title = fitted(ui.fonts.body, player.played().title_of(p, c), r.width() - 18);
    const float width = text_width(ui.fonts.body, title) + 18;
    if (x > r.left && x + width > r.right) {
      x = r.left;
      y += 30;
    }
    const Rect chip_rect{x, y, x + width, y + 26};
    if (chip(ui, "parameter " + p.name + "." + c, chip_rect, title, c == value))
      attempt(toast, [&] { p.name == player.lesson().group_by ? player.load_method(c) : player.edit(p.name, c); });
    x += width + 6;
  }
  return y - r.top;
}

/// Draws parameters pale that have no effect in this setting, and says when they would.
void without_effect(Ui& ui, const Parameter& p, const Rect& r) {
  ui.rects["without effect " + p.name] = r;
  filled(r, ui.palette.window.with_alpha(0.6), 0);
  const bool hovered = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) &&
                       ImGui::IsMouseHoveringRect(top_left(r), bottom_right(r));
  if (hovered) tooltip(ui, told_where(p) + ".\n" + p.help);
}

const std::string& label_of(const Parameter& p) { return p.label.empty() ? p.name : p.label; }

float label_width(Ui& ui, const Lesson& lesson) {
  constexpr float most = 96;
  if (lesson.parameters.size() > many_parameters) return most;
  float widest = 40;
  for (const Parameter& p : lesson.parameters)
    widest = std::max(widest, ui.texts.size_of({.markup = label_of(p), .colour = ui.palette.text}).x);
  return std::min(widest + 12, most);
}

}  // namespace

float parameter_fields(Player& player, Ui& ui, Fields& fields, Toast& toast, float x, float y, float width) {
  const Form form{player, ui, fields};
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2{6, 4});
  ImGui::PushStyleVar(ImGuiStyleVar_GrabMinSize, 8);
  ImGui::PushStyleColor(ImGuiCol_SliderGrab, packed(ui.palette.first, 0.65));
  const Parameters now = player.parameters();  // a field may change the player's own during this loop
  const float labels = label_width(ui, player.lesson());
  const float view = ImGui::GetWindowPos().y, end = view + ImGui::GetWindowHeight();
  for (const Parameter& p : player.lesson().parameters) {
    if (!now.contains(p.name)) continue;
    const bool far_off = y + 2 * field_height < view || y > end + field_height;
    if (far_off && player.lesson().parameters.size() > many_parameters) {  // those of a scene of a thousand objects
      y += field_height;
      continue;
    }
    const Setting& value = now.at(p.name);
    const Rect r{x + labels, y, x + width, y + 26};
    ImGui::PushClipRect({x, y}, {r.left - 4, y + field_height}, true);
    rich_line(ui, {.markup = label_of(p), .colour = ui.palette.text}, x, y + 13);
    ImGui::PopClipRect();
    if (const double* real = std::get_if<double>(&value)) number(form, p, *real, r);
    if (const Vec3* v = std::get_if<Vec3>(&value)) vector(form, p, *v, r);
    if (const std::string* word = std::get_if<std::string>(&value)) y += choice(player, ui, toast, p, *word, r);
    if (!counts(p, now)) without_effect(ui, p, {x, r.top - 2, x + width, y + 28});
    y += field_height;
    y += refusal(form, p.name, x + labels, y - 4, width - labels);
  }
  ImGui::SetCursorScreenPos({x, y});
  ImGui::Dummy({1, 4});
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
  return y + 4;
}

}  // namespace isect::viz
