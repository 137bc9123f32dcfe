#include <algorithm>
#include <cmath>
#include <span>

#include "viz/window/sheets.h"

namespace isect::viz {
namespace {

struct Row {
  const char *input, *action;
};

constexpr Row left_keys[] = {
    {"← / →", "step back / on"},
    {"Home / End", "first / last step"},
    {"Space", "play / pause"},
    {"N", "play past questions"},
    {"K / J", "time runs / to contact"},
    {"→ or N at the end", "the next lesson"},
    {"1 … 9, 0", "presets"},
    {"Page Up / Down", "preset before / after"},
    {"A, B, C …", "answer the question"},
    {"1, 3/4, bca, Enter", "type the answer"},
    {"Y", "with other numbers"},
    {"I, then a number", "a stop of a playlist"},
    {"[ and ]", "lesson before / after"},
    {"Ctrl+O", "lessons, saved presets"},
    {"G", "terms"},
    {"T", "reviews"},
    {"R", "restart the preset"},
    {"E", "see the line fail, or back"},
    {"Ctrl+C / Ctrl+V", "copy / paste the state"},
    {"Ctrl+Z / Ctrl+Y", "take back / do again"},
    {"S, F12, Ctrl+S", "save figure or preset"},
    {"Ctrl+S in a scene", "save it into its file"},
    {"F2 / Delete", "rename / remove object"},
    {"Insert / Delete", "add / remove a corner"},
    {"F1 or ?", "this sheet"},
    {"Ctrl+Q", "leave"},
};
constexpr Row right_keys[] = {
    {"drag a handle", "move the object"},
    {"drag on a map", "move the setting"},
    {"Shift while dragging", "snap to the next case"},
    {"drag, right-drag", "turn, shift the scene"},
    {"wheel", "zoom at the pointer"},
    {"double click or F", "frame all"},
    {"double click a side", "a polygon’s: add a corner"},
    {"L", "keep this view, or not"},
    {"P / O", "perspective / orthographic"},
    {"Shift+arrows", "turn, or move the handle"},
    {"Ctrl+Shift+arrows", "snap it to the next case"},
    {"Ctrl+arrows, + / −", "shift, zoom"},
    {"↓ / ↑", "go through all controls"},
    {"F6", "next part of the window"},
    {"Enter / Escape", "press the ringed / let go"},
    {"Ctrl+click a number", "type it: 1,5 or 2*pi or 1/3"},
    {"Tab", "lecture: no panels, or not"},
    {"N, Page Down / Up", "lecture, playlist: on / back"},
    {"B or .", "in a lecture: dark, or light"},
    {"F11", "full screen"},
    {"V", "two panes, or one"},
    {"W", "the map of cases, or not"},
    {"H", "progress over all lessons"},
    {"M", "reduce motion, or not"},
    {"Ctrl and + / − / 0", "size of everything"},
    {"Escape", "close a sheet"},
};

static_assert(std::size(left_keys) == std::size(right_keys), "the columns of the sheet have equal heights");

constexpr float key_gap = 14;  ///< between an input and its action

float widest_of(std::span<const Row> all, ImFont* font, const char* Row::*member) {
  float most = 0;
  for (const Row& r : all) most = std::max(most, text_width(font, r.*member));
  return most;
}

float width_of(std::span<const Row> all, ImFont* font) {
  return widest_of(all, font, &Row::input) + key_gap + widest_of(all, font, &Row::action);
}

/// Draws rows of this height below each other and below the heading, which begins at `at`.
void key_column(Ui& ui, const char* name, std::span<const Row> all, const ImVec2& at, float row) {
  ImFont* const font = ui.fonts.body;
  const float top = at.y + 46;
  ui.rects[name] = {at.x, top - row / 2, at.x + width_of(all, font),
                    top + row * (static_cast<float>(all.size()) - 0.5f)};
  float y = top;  // the middle of a row
  const float actions = at.x + widest_of(all, font, &Row::input) + key_gap;
  for (const Row& r : all) {
    text(font, at.x, y, packed(ui.palette.first), r.input);
    text(font, actions, y, packed(ui.palette.text), r.action);
    y += row;
  }
}

}  // namespace

void key_sheet(Ui& ui, const Rect& window) {
  constexpr float rows = static_cast<float>(std::size(left_keys)), least = 18;  // px; the sheet of a low window scrolls
  const float row = std::clamp(std::floor((window.height() - 140) / rows), least, 27.0f);
  if (!begin_sheet(ui, "key sheet", window, 920, 100 + row * rows)) return;
  if (key_down(key::f1) || (pages_past_end() && !ImGui::IsWindowAppearing())) ImGui::CloseCurrentPopup();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x;
  const float left = width_of(left_keys, ui.fonts.body), right = width_of(right_keys, ui.fonts.body);
  // The right column begins in the middle; where it is too wide for its half, it ends where the sheet does.
  const float from = std::max(std::min(room / 2, room - right), left + key_gap);
  text(ui.fonts.heading, at.x, at.y + 10, packed(ui.palette.text), "Keys");
  key_column(ui, "keys left", left_keys, at, row);
  key_column(ui, "keys right", right_keys, {at.x + from, at.y}, row);
  ImGui::SetCursorScreenPos({at.x, at.y});
  ImGui::Dummy({1, 46 + row * rows});
  ImGui::EndPopup();
}

}  // namespace isect::viz
