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
    {"N", "play past questions, or stop"},
    {"→ or N at the end", "the next lesson"},
    {"1 … 9, 0", "presets"},
    {"Page Up / Down", "preset before / after"},
    {"A, B, C …", "answer the question"},
    {"1, 3/4, bca, Enter", "type the answer"},
    {"Y", "ask it with other numbers"},
    {"[ and ]", "lesson before / after"},
    {"Ctrl+O", "all lessons, saved presets"},
    {"G", "terms"},
    {"T", "reviews"},
    {"R", "restart the preset"},
    {"E", "see the line fail, or go back"},
    {"Ctrl+C / Ctrl+V", "copy / paste the whole state"},
    {"Ctrl+Z", "take the last change back"},
    {"Ctrl+Y, Ctrl+Shift+Z", "do it again"},
    {"S, F12, Ctrl+S", "save this figure or preset"},
    {"Ctrl+S in a scene", "save it into its file"},
    {"F2 / Delete", "in a scene: rename / remove"},
    {"F1 or ?", "this sheet"},
    {"Ctrl+Q", "leave"},
};
constexpr Row right_keys[] = {
    {"drag a handle", "move the object"},
    {"drag on a map", "move the setting"},
    {"Shift while dragging", "snap to where the case changes"},
    {"drag, right-drag", "turn, shift the scene"},
    {"wheel", "zoom at the pointer"},
    {"double click or F", "frame all"},
    {"L", "keep this view, or not"},
    {"P / O", "perspective / orthographic"},
    {"Shift+arrows", "turn, or move the held handle"},
    {"Ctrl+Shift+arrows", "snap it to the next case"},
    {"Ctrl+arrows, + / −", "shift, zoom"},
    {"↓ / ↑", "go through all controls"},
    {"F6", "to the next part of the window"},
    {"Enter / Escape", "press what is ringed / let go"},
    {"Ctrl+click a number", "type it: 1,5 or 2*pi or 1/3"},
    {"Tab", "lecture: no panels, or not"},
    {"N, Page Down / Up", "in a lecture: on / back"},
    {"B or .", "in a lecture: dark, or light"},
    {"F11", "full screen"},
    {"V", "two panes, or one"},
    {"W", "where this case lies: the map"},
    {"H", "how far I am, over all lessons"},
    {"M", "reduce motion, or not"},
    {"Ctrl and + / − / 0", "size of everything"},
};

constexpr float key_gap = 18;  ///< between an input and its action

float widest_of(std::span<const Row> all, ImFont* font, const char* Row::*member) {
  float most = 0;
  for (const Row& r : all) most = std::max(most, text_width(font, r.*member));
  return most;
}

float width_of(std::span<const Row> all, ImFont* font) {
  return widest_of(all, font, &Row::input) + key_gap + widest_of(all, font, &Row::action);
}

/// Draws rows below each other from `at` on, each of this height.
void key_column(Ui& ui, const char* name, std::span<const Row> all, ImFont* font, const ImVec2& at, float row) {
  float y = at.y;
  ui.rects[name] = {at.x, y, at.x + width_of(all, font), y + row * static_cast<float>(all.size())};
  const float actions = at.x + widest_of(all, font, &Row::input) + key_gap;
  for (const Row& r : all) {
    text(font, at.x, y, packed(ui.palette.first), r.input);
    text(font, actions, y, packed(ui.palette.text), r.action);
    y += row;
  }
}

}  // namespace

void key_sheet(Ui& ui, const Rect& window) {
  constexpr float rows = static_cast<float>(std::max(std::size(left_keys), std::size(right_keys)));
  const float row = std::min(27.0f, std::floor((window.height() - 140) / rows));
  if (!begin_sheet(ui, "key sheet", window, 920, 100 + row * rows)) return;
  if (key_down(key::f1)) ImGui::CloseCurrentPopup();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float half = ImGui::GetContentRegionAvail().x / 2;
  const bool narrow =
      std::max(width_of(left_keys, ui.fonts.body), width_of(right_keys, ui.fonts.body)) + key_gap > half;
  ImFont* font = narrow ? ui.fonts.small : ui.fonts.body;
  text(ui.fonts.heading, at.x, at.y + 10, packed(ui.palette.text), "Keys");
  key_column(ui, "keys left", left_keys, font, {at.x, at.y + 46}, row);
  key_column(ui, "keys right", right_keys, font, {at.x + half, at.y + 46}, row);
  ImGui::SetCursorScreenPos({at.x, at.y});
  ImGui::Dummy({1, 46 + row * rows});
  ImGui::EndPopup();
}

}  // namespace isect::viz
