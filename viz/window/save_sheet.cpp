// How the figure on show becomes a file.

#include "viz/formats.h"
#include "viz/window/sheets.h"

namespace isect::viz {

void save_sheet(Session& s, const Rect& window) {
  if (!begin_sheet(s, "save sheet", window, 480, 290)) return;
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
      s.settings.save_width_cm = cm;
    x += width + 6;
  }
  x = at.x, y += 56;
  const bool again = ImGui::GetIO().InputQueueCharacters.contains('s') && !ImGui::IsWindowAppearing();
  const bool held = !ui.focus.name().empty();  // then Enter presses that
  const bool enter = (!held && (key_down(key::enter) || key_down(key::keypad_enter))) || key_down(key::f12) || again;
  if (chip(ui, "save", {x, y - 18, x + 110, y + 18}, "Save", true) || enter) {
    s.save_now = true;
    ImGui::CloseCurrentPopup();
  }
  if (chip(ui, "save as preset", {x + 120, y - 18, x + 260, y + 18}, "Save as preset", false)) {
    s.save_preset = true;
    ImGui::CloseCurrentPopup();
  }
  text(ui.fonts.small, x + 276, y, packed(c.muted), "Enter saves");
  ImGui::EndPopup();
}

}  // namespace isect::viz
