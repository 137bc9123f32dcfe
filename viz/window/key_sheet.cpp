#include <algorithm>
#include <cmath>

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
    {"1 … 9, 0", "presets"},
    {"Page Up / Down", "preset before / after"},
    {"A, B, C …", "answer the question"},
    {"[ and ]", "lesson before / after"},
    {"Ctrl+O", "all lessons, saved presets"},
    {"G", "terms"},
    {"R", "restart the preset"},
    {"E", "see the published line fail"},
    {"Ctrl+C / Ctrl+V", "copy / paste the whole state"},
    {"Ctrl+Z", "take the last change back"},
    {"Ctrl+Y, Ctrl+Shift+Z", "do it again"},
    {"S, F12, Ctrl+S", "save this figure or preset"},
    {"Ctrl+S in a scene", "save it into its file"},
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
    {"P / O", "perspective / orthographic"},
    {"Shift+arrows", "turn, or move the held handle"},
    {"Ctrl+Shift+arrows", "snap it to the next case"},
    {"Ctrl+arrows, + / −", "shift, zoom"},
    {"↓ / ↑", "go through all controls"},
    {"F6", "to the next part of the window"},
    {"Enter", "press what is ringed"},
    {"Escape", "let go"},
    {"Ctrl+click a number", "type it: 1,5 or 2*pi or 1/3"},
    {"Tab", "hide / show the panels"},
    {"F11", "full screen"},
    {"V", "two panes, or one"},
    {"W", "where this case lies: the map"},
    {"M", "reduce motion, or not"},
    {"Ctrl and + / − / 0", "size of everything"},
};

}  // namespace

void key_sheet(Ui& ui, const Rect& window) {
  constexpr float rows = static_cast<float>(std::max(std::size(left_keys), std::size(right_keys)));
  const float row = std::min(27.0f, std::floor((window.height() - 140) / rows));
  if (!begin_sheet(ui, "key sheet", window, 920, 100 + row * rows)) return;
  if (key_down(key::f1)) ImGui::CloseCurrentPopup();
  const Palette& c = ui.palette;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float half = ImGui::GetContentRegionAvail().x / 2;
  const auto widest = [](const auto& all, ImFont* font, auto member) {
    float most = 0;
    for (const Row& r : all) most = std::max(most, text_width(font, r.*member));
    return most;
  };
  constexpr float gap = 18;
  const auto width = [&](const auto& all, ImFont* font) {
    return widest(all, font, &Row::input) + gap + widest(all, font, &Row::action);
  };
  const bool narrow = std::max(width(left_keys, ui.fonts.body), width(right_keys, ui.fonts.body)) + gap > half;
  ImFont* font = narrow ? ui.fonts.small : ui.fonts.body;
  text(ui.fonts.heading, at.x, at.y + 10, packed(c.text), "Keys");
  const auto column = [&](const char* name, const auto& all, float x) {
    float y = at.y + 46;
    ui.rects[name] = {x, y, x + width(all, font), y + row * static_cast<float>(std::size(all))};
    const float actions = x + widest(all, font, &Row::input) + gap;
    for (const Row& r : all) {
      text(font, x, y, packed(c.first), r.input);
      text(font, actions, y, packed(c.text), r.action);
      y += row;
    }
  };
  column("keys left", left_keys, at.x);
  column("keys right", right_keys, at.x + half);
  ImGui::SetCursorScreenPos({at.x, at.y});
  ImGui::Dummy({1, 46 + row * rows});
  ImGui::EndPopup();
}

}  // namespace isect::viz
