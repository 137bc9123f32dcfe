// The sheet that saves the figure on show as a file.

#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "viz/formats/formats.h"
#include "viz/text/number_text.h"
#include "viz/text/rich_text.h"
#include "viz/window/progress.h"
#include "viz/window/save_figure.h"
#include "viz/window/save_place.h"
#include "viz/window/sheets.h"

namespace isect::viz {

namespace {

/// Draws a field for any other width in cm, which is read on Enter or on leaving the field.
void other_width(SaveSheet& sheet, Ui& ui, Settings& settings, const Rect& r) {
  ui.rects["other width"] = r;
  const bool held = focused(ui, "other width", r);
  ImGui::SetCursorScreenPos(top_left(r));
  ImGui::SetNextItemWidth(r.width());
  if (held && (ui.focus.pressed() || ui.focus.moved())) ImGui::SetKeyboardFocusHere();
  ImGui::InputTextWithHint("##width", "cm", &sheet.width_text, ImGuiInputTextFlags_AutoSelectAll);
  if (ImGui::IsItemActive() && !held && ui.focus.moved()) ImGui::ClearActiveID();
  const bool tab = left_by_tab(ui, "other width") && !sheet.width_text.empty();
  const bool chosen = settings.save_width_cm > 0 && sheet.width_text == shown(settings.save_width_cm);
  if (chosen || !sheet.width_wrong.empty()) outlined(r, chosen ? ui.palette.first : ui.palette.miss, 1.5f);
  if (!tab && !ImGui::IsItemDeactivatedAfterEdit()) return;
  sheet.width_wrong.clear();
  try {
    const double cm = number_from(sheet.width_text);
    if (!(cm >= least_width_cm && cm <= most_width_cm))
      throw BadInput("give a width from " + shown(least_width_cm) + " to " + shown(most_width_cm) + " cm");
    settings.save_width_cm = cm, sheet.width_text = shown(cm);
  } catch (const BadInput& wrong) {
    sheet.width_wrong = wrong.what();
  }
}

/// Draws the figure as it would be saved, as large as it fits.
void preview(const SaveSheet& sheet, Ui& ui, const Rect& room) {
  if (!sheet.why.empty()) {
    Paragraph why{.markup = as_markup(sheet.why), .line_pitch = 21, .colour = ui.palette.muted};
    why.width = room.width();
    return static_cast<void>(rich(ui, why, top_left(room)));
  }
  if (!sheet.picture || !(sheet.width > 0)) return;
  const float scale = std::min(room.width() / sheet.width, room.height() / sheet.height);
  const float left = room.middle_x() - scale * sheet.width / 2, top = room.middle_y() - scale * sheet.height / 2;
  const Rect r{left, top, left + scale * sheet.width, top + scale * sheet.height};
  ui.rects["save preview"] = r;
  ImGui::GetWindowDrawList()->AddImage(sheet.picture, top_left(r), bottom_right(r), {0, 1}, {1, 0});
  outlined(r, ui.palette.rule, 1, 0);
}

/// Draws the chips of formats, themes and sizes from `at` down.
void choices_of_figure(SaveSheet& sheet, Ui& ui, Settings& settings, const ImVec2& at) {
  const Palette& c = ui.palette;
  float x = at.x, y = at.y;
  text(ui.fonts.body, x, y, packed(c.muted), "Format");
  for (const std::string& format : still_format_names()) {
    if (chip(ui, "format " + format, {x + 80, y - 15, x + 140, y + 15}, format, settings.save_format == format))
      settings.save_format = format;
    x += 66;
  }
  x = at.x, y += 42;
  text(ui.fonts.body, x, y, packed(c.muted), "Theme");
  for (const std::string& name : theme_names()) {
    const float width = text_width(ui.fonts.body, name) + 20;
    if (chip(ui, "save theme " + name, {x + 80, y - 15, x + 80 + width, y + 15}, name,
             settings.save_theme == theme_named(name)))
      settings.save_theme = theme_named(name);
    x += width + 6;
  }
  x = at.x, y += 42;
  text(ui.fonts.body, x, y, packed(c.muted), "Size");
  for (const double cm : {0.0, 8.0, 12.0, 16.0}) {
    const std::string name = cm > 0 ? shown(cm) + " cm" : std::string("960 × 600");
    const float width = text_width(ui.fonts.body, name) + 20;
    if (chip(ui, "size " + shown(cm), {x + 80, y - 15, x + 80 + width, y + 15}, name, settings.save_width_cm == cm))
      settings.save_width_cm = cm, sheet.width_text.clear(), sheet.width_wrong.clear();
    x += width + 6;
  }
  other_width(sheet, ui, settings, {x + 80, y - 15, x + 150, y + 15});
  if (const std::string why = sheet.width_wrong; !why.empty()) {
    const float width = text(ui.fonts.body, at.x + 80, y + 28, packed(c.miss), why);
    ui.rects["refused width"] = {at.x + 80, y + 20, at.x + 80 + width, y + 36};
  }
}

/// Draws the button that saves the setting, if there is one: into the scene's file or a new one, or as a preset.
void setting_button(const Player& player, Ui& ui, bool ready, KeptScene kept, Requests& requests, const Rect& r) {
  const bool scene = !player.lesson().made_from.empty(), in_file = kept == KeptScene::in_file;
  if (scene && kept != KeptScene::nowhere && chip(ui, "save scene", r, "Save the scene", false) && (ready || in_file)) {
    (in_file ? requests.save_back : requests.save_scene) = true;
    ImGui::CloseCurrentPopup();
  }
  if (!scene && chip(ui, "save as preset", r, "Save as preset", false) && ready) {
    requests.save_preset = true;
    ImGui::CloseCurrentPopup();
  }
}

/// Draws the buttons beside each other from `at` on, and presses the first one on Enter. `ready`: nothing that was
/// typed is refused.
void save_buttons(const Player& player, Ui& ui, const SaveSheet& sheet, bool ready, KeptScene kept, Requests& requests,
                  const ImVec2& at) {
  using What = SaveSheet::What;
  const float x = at.x, y = at.y;
  const bool typing = ImGui::GetIO().WantTextInput;
  const bool again = !typing && ImGui::GetIO().InputQueueCharacters.contains('s') && !ImGui::IsWindowAppearing();
  const bool held = !ui.focus.name().empty() || typing;  // then Enter belongs to them
  const bool enter = (!held && (key_down(key::enter) || key_down(key::keypad_enter))) || key_down(key::f12) || again;
  const bool figure = sheet.what == What::figure;
  if ((chip(ui, "save", {x, y - 18, x + 110, y + 18}, figure ? "Save" : "Save JSON", true) || enter) && ready) {
    (figure                         ? requests.save_figure
     : sheet.what == What::progress ? requests.save_progress
                                    : requests.save_scene) = true;
    ImGui::CloseCurrentPopup();
  }
  if (figure) setting_button(player, ui, ready, kept, requests, {x + 120, y - 18, x + 260, y + 18});
  text(ui.fonts.body, x + (figure ? 276 : 126), y, packed(ui.palette.muted), "Enter saves");
}

}  // namespace

void save_sheet(const Player& player, Ui& ui, SaveSheet& sheet, Settings& settings, const std::string& figures,
                KeptScene kept, Requests& requests, const Rect& window) {
  using What = SaveSheet::What;
  const bool figure = sheet.what == What::figure;
  const float place = sheet.failed.empty() ? 104 : 172;  // of the name and the folder, with what is said below them
  const float choices = figure ? 140 : 0;
  sheet.open = begin_sheet(ui, "save sheet", window, 780, 126 + choices + place);
  if (!sheet.open) {
    sheet.name.clear(), sheet.folder.clear(), sheet.failed.clear();
    sheet.what = What::figure;
    return;
  }
  if (ImGui::IsWindowAppearing() && sheet.folder.empty()) sheet.folder = whole_folder(sheet, settings, figures);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  text(ui.fonts.heading, at.x, at.y + 10, packed(ui.palette.text),
       figure                         ? "Save this figure"
       : sheet.what == What::progress ? "Save the progress"
                                      : "Save the scene");
  const Rect all = ui.rects["save sheet"];
  const float top = at.y + 56 + choices, buttons = top + place + 8;
  const bool named = wrong_name(sheet, settings).empty();
  if (!figure) {
    place_fields(ui, sheet, settings, figures, sheet.what == What::progress ? usual_progress_name : usual_scene_name,
                 "json", {at.x, top, all.right - 20, top + place});
    save_buttons(player, ui, sheet, named, kept, requests, {at.x, buttons});
  } else {
    choices_of_figure(sheet, ui, settings, {at.x, at.y + 56});
    const float right = ui.rects["other width"].right;
    place_fields(ui, sheet, settings, figures, usual_stem(player), settings.save_format,
                 {at.x, top, right, top + place});
    save_buttons(player, ui, sheet, named && sheet.width_wrong.empty(), kept, requests, {at.x, buttons});
    preview(sheet, ui, {right + 20, at.y + 10, all.right - 20, all.bottom - 20});
  }
  ImGui::EndPopup();
}

}  // namespace isect::viz
