// The sheet that saves the figure on show as a file.

#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "viz/formats/formats.h"
#include "viz/text/rich_text.h"
#include "viz/window/number_text.h"
#include "viz/window/panels.h"
#include "viz/window/sheets.h"

namespace isect::viz {

namespace {

/// Draws a field for any other width in cm, which is read on Enter or on leaving the field.
void other_width(WindowSession& s, const Rect& r) {
  s.ui.rects["other width"] = r;
  const bool held = focused(s.ui, "other width", r);
  ImGui::SetCursorScreenPos(top_left(r));
  ImGui::SetNextItemWidth(r.width());
  if (held && (s.ui.focus.pressed() || s.ui.focus.moved())) ImGui::SetKeyboardFocusHere();
  ImGui::InputTextWithHint("##width", "cm", &s.width_text, ImGuiInputTextFlags_AutoSelectAll);
  if (ImGui::IsItemActive() && !held && s.ui.focus.moved()) ImGui::ClearActiveID();
  const bool tab = left_by_tab(s.ui, "other width") && !s.width_text.empty();
  const bool chosen = s.settings.save_width_cm > 0 && s.width_text == shown(s.settings.save_width_cm);
  if (chosen || !s.width_wrong.empty()) outlined(r, chosen ? s.ui.palette.first : s.ui.palette.miss, 1.5f);
  if (!tab && !ImGui::IsItemDeactivatedAfterEdit()) return;
  s.width_wrong.clear();
  try {
    const double cm = number_from(s.width_text);
    if (!(cm >= least_width_cm && cm <= most_width_cm))
      throw BadInput("give a width from " + shown(least_width_cm) + " to " + shown(most_width_cm) + " cm");
    s.settings.save_width_cm = cm, s.width_text = shown(cm);
  } catch (const BadInput& wrong) {
    s.width_wrong = wrong.what();
  }
}

/// Draws the figure as it would be saved, as large as it fits.
void preview(WindowSession& s, const Rect& room) {
  const WindowSession::Preview& p = s.preview;
  if (!p.why.empty()) {
    Paragraph why{.markup = as_markup(p.why), .line_pitch = 21, .colour = s.ui.palette.muted};
    why.width = room.width();
    return static_cast<void>(rich(s.ui, why, top_left(room)));
  }
  if (!p.picture || !(p.width > 0)) return;
  const float scale = std::min(room.width() / p.width, room.height() / p.height);
  const float left = room.middle_x() - scale * p.width / 2, top = room.middle_y() - scale * p.height / 2;
  const Rect r{left, top, left + scale * p.width, top + scale * p.height};
  s.ui.rects["save preview"] = r;
  ImGui::GetWindowDrawList()->AddImage(p.picture, top_left(r), bottom_right(r), {0, 1}, {1, 0});
  outlined(r, s.ui.palette.rule, 1, 0);
}

}  // namespace

void save_sheet(WindowSession& s, const Rect& window) {
  if (!begin_sheet(s, "save sheet", window, 780, 310)) {
    s.preview.wanted = false;
    return;
  }
  s.preview.wanted = true;
  Ui& ui = s.ui;
  const Palette& c = ui.palette;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  float x = at.x, y = at.y + 10;
  text(ui.fonts.heading, x, y, packed(c.text), "Save this figure");
  y += 46;
  text(ui.fonts.body, x, y, packed(c.muted), "Format");
  for (const std::string& format : still_format_names()) {
    if (chip(ui, "format " + format, {x + 80, y - 15, x + 140, y + 15}, format, s.settings.save_format == format))
      s.settings.save_format = format;
    x += 66;
  }
  x = at.x, y += 42;
  text(ui.fonts.body, x, y, packed(c.muted), "Theme");
  for (const std::string& name : theme_names()) {
    const float width = text_width(ui.fonts.body, name) + 20;
    if (chip(ui, "save theme " + name, {x + 80, y - 15, x + 80 + width, y + 15}, name,
             s.settings.save_theme == theme_named(name)))
      s.settings.save_theme = theme_named(name);
    x += width + 6;
  }
  x = at.x, y += 42;
  text(ui.fonts.body, x, y, packed(c.muted), "Size");
  for (const double cm : {0.0, 8.0, 12.0, 16.0}) {
    const std::string name = cm > 0 ? shown(cm) + " cm" : std::string("960 × 600");
    const float width = text_width(ui.fonts.body, name) + 20;
    if (chip(ui, "size " + shown(cm), {x + 80, y - 15, x + 80 + width, y + 15}, name, s.settings.save_width_cm == cm))
      s.settings.save_width_cm = cm, s.width_text.clear(), s.width_wrong.clear();
    x += width + 6;
  }
  other_width(s, {x + 80, y - 15, x + 150, y + 15});
  if (const std::string why = s.width_wrong; !why.empty()) {
    const float width = text(ui.fonts.small, at.x + 80, y + 28, packed(c.miss), why);
    ui.rects["refused width"] = {at.x + 80, y + 20, at.x + 80 + width, y + 36};
  }
  x = at.x, y += 60;
  const bool again = ImGui::GetIO().InputQueueCharacters.contains('s') && !ImGui::IsWindowAppearing();
  const bool held = !ui.focus.name().empty() || ImGui::GetIO().WantTextInput;  // then Enter belongs to them
  const bool enter = (!held && (key_down(key::enter) || key_down(key::keypad_enter))) || key_down(key::f12) || again;
  if ((chip(ui, "save", {x, y - 18, x + 110, y + 18}, "Save", true) || enter) && s.width_wrong.empty()) {
    s.save_now = true;
    ImGui::CloseCurrentPopup();
  }
  const bool scene = !s.player.lesson().made_from.empty();
  if (scene && keeps_file(s) && chip(ui, "save scene", {x + 120, y - 18, x + 260, y + 18}, "Save the scene", false)) {
    save_back(s);
    ImGui::CloseCurrentPopup();
  }
  if (!scene && chip(ui, "save as preset", {x + 120, y - 18, x + 260, y + 18}, "Save as preset", false)) {
    s.save_preset = true;
    ImGui::CloseCurrentPopup();
  }
  text(ui.fonts.small, x + 276, y, packed(c.muted), "Enter saves");
  preview(s, {ui.rects["other width"].right + 20, at.y + 10, ui.rects["save sheet"].right - 20,
              ui.rects["save sheet"].bottom - 20});
  ImGui::EndPopup();
}

}  // namespace isect::viz
