#include <algorithm>

#include "viz/text/rich_text.h"
#include "viz/window/panels.h"
#include "viz/window/second_pane.h"

namespace isect::viz {
namespace {

void method_menu(Player& player, Ui& ui, Settings& settings, Toast& toast, float x, float bottom) {
  ImGui::SetNextWindowPos({x, bottom});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{6, 6});
  if (ImGui::BeginPopup("methods")) {
    ImVec2 at = ImGui::GetCursorScreenPos();
    constexpr const char* two_methods = "two methods side by side";
    float width = text_width(ui.fonts.body, two_methods) + 28;
    for (const Method& m : player.played().methods())
      width = std::max(width, text_width(ui.fonts.body, plain(m.title)) + 28);
    for (const Method& m : player.played().methods()) {
      const Rect r{at.x, at.y, at.x + width, at.y + 30};
      if (chip(ui, "method " + m.choice, r, plain(m.title), m.choice == player.played().method())) {
        attempt(toast, [&] { player.load_method(m.choice); });
        ImGui::CloseCurrentPopup();
      }
      at.y += 34;
    }
    if (chip(ui, "method against method", {at.x, at.y, at.x + width, at.y + 30}, two_methods,
             two_panes(player, settings))) {
      toggle_panes(player, settings, toast);
      ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

/// Whether this preset is on show, and nothing was edited since.
bool on_show(const TopBar& head, const Preset& preset) {
  return !head.in_file && preset.id == head.player.played().preset_id();
}

/// Loads a preset that was pressed.
void load_pressed(const TopBar& head, const Preset& preset) {
  attempt(head.toast, [&] { load_preset(head.player, preset, head.in_file); });
}

std::string chip_label(const Preset& preset, std::size_t number, bool named) {
  const std::string digits = std::to_string(number);
  return named ? digits + "  " + plain(preset.title) : digits;
}

/// The chips of the presets in a row: with names while there is room for them.
struct Chips {
  float gap;
  int chosen = -1;
  std::vector<float> wide, widths;
  float total() const {
    float sum = gap * static_cast<float>(std::max<std::size_t>(widths.size(), 1) - 1);
    for (const float w : widths) sum += w;
    return sum;
  }
};

Chips chips_in(const TopBar& head, const std::vector<const Preset*>& group, float room) {
  constexpr float narrow = 30;
  Chips chips;
  for (const bool roomy : {true, false}) {
    chips = {roomy ? 8.0f : 6.0f, -1, {}, {}};
    for (std::size_t i = 0; i < group.size(); ++i) {
      if (on_show(head, *group[i])) chips.chosen = static_cast<int>(i);
      chips.wide.push_back(text_width(head.ui.fonts.body, chip_label(*group[i], i + 1, true)) + (roomy ? 24 : 16));
    }
    chips.widths = chips.wide;
    if (chips.total() <= room) return chips;
  }
  chips.widths = chip_widths(chips.wide, narrow, chips.gap, room, chips.chosen);
  return chips;
}

void draw_chips(const TopBar& head, const std::vector<const Preset*>& group, const Chips& chips, float x1, float y) {
  Ui& ui = head.ui;
  float x = x1 - chips.total();
  for (std::size_t i = 0; i < group.size(); ++i) {
    const bool whole = chips.widths[i] == chips.wide[i];
    const Rect r{x, y - 15, x + chips.widths[i], y + 15};
    if (chip(ui, "preset " + std::to_string(i + 1), r, chip_label(*group[i], i + 1, whole && head.named),
             static_cast<int>(i) == chips.chosen))
      load_pressed(head, *group[i]);
    if (ImGui::IsItemHovered() && !head.named)
      tooltip(ui, "It is named once the question is answered");
    else if (ImGui::IsItemHovered() && !whole)
      tooltip(ui, plain(group[i]->title));
    x += chips.widths[i] + chips.gap;
  }
}

/// Lists all presets below each other, if there is no room for them side by side.
void preset_menu(const TopBar& head, const std::vector<const Preset*>& group, float right, float top) {
  Ui& ui = head.ui;
  float width = 160;
  for (std::size_t i = 0; i < group.size(); ++i)
    width = std::max(width, text_width(ui.fonts.body, chip_label(*group[i], i + 1, true)) + 28);
  ImGui::SetNextWindowPos({right - width - 12, top});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{6, 6});
  if (ImGui::BeginPopup("preset menu")) {
    ImVec2 at = ImGui::GetCursorScreenPos();
    for (std::size_t i = 0; i < group.size(); ++i) {
      const Rect r{at.x, at.y, at.x + width, at.y + 30};
      if (chip(ui, "preset " + std::to_string(i + 1), r, chip_label(*group[i], i + 1, head.named),
               on_show(head, *group[i]))) {
        load_pressed(head, *group[i]);
        ImGui::CloseCurrentPopup();
      }
      at.y += 34;
    }
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

std::string chosen_label(const TopBar& head, const std::vector<const Preset*>& group) {
  for (std::size_t i = 0; i < group.size(); ++i)
    if (on_show(head, *group[i])) return chip_label(*group[i], i + 1, head.named);
  return "presets";
}

void theme_button(Ui& ui, ThemeName& theme, const Rect& r) {
  constexpr ThemeName round[] = {ThemeName::dark, ThemeName::screen, ThemeName::grey};
  const Press p = press(ui, "theme", r);
  filled(r, p.hovered ? ui.palette.hovered : ui.palette.frame);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 middle{r.middle_x(), r.middle_y()};
  const ImU32 ink = packed(ui.palette.text);
  list.AddCircle(middle, 7, ink, 24, 1.5f);
  list.PathArcTo(middle, 7, -1.5708f, 1.5708f, 16);
  list.PathFillConvex(ink);
  const auto* at = std::find(std::begin(round), std::end(round), theme);
  const ThemeName next = at == std::end(round) || at + 1 == std::end(round) ? round[0] : at[1];
  if (p.hovered) tooltip(ui, "Theme: " + name_of(theme) + ". Click for " + name_of(next));
  if (p.clicked) theme = next;
}

}  // namespace

void top_bar(const TopBar& head, const Rect& r) {
  Player& player = head.player;
  Ui& ui = head.ui;
  Requests& requests = head.requests;
  begin_region(ui, "top bar", r);
  const float y = 24;
  logo(ui, 30, y);
  text(ui.fonts.heading, 54, y, packed(ui.palette.text), "isect");
  const Rect help{r.right - 56, y - 15, r.right - 20, y + 15};
  const float x0 = 128, x1 = help.left - 60;
  const bool variants = !player.played().methods().empty();
  const std::string title = plain(player.lesson().title), variant = variants ? plain(player.walk().method) : "";
  const auto wide = [&](const std::string& words) { return text_width(ui.fonts.body, words) + 18; };
  const float names = wide(title) + (variants ? 20 + wide(variant) : 0) + 24;
  const std::vector<const Preset*> group = player.played().group();
  const Chips chips = chips_in(head, group, x1 - x0 - names);
  const bool in_a_row = chips.total() <= x1 - x0 - names;
  const float menu = in_a_row || group.empty() ? 0 : std::min(wide(chosen_label(head, group)), 190.0f) + 14;

  float room = x1 - x0 - menu - 24;
  const float for_variant = variants ? std::min(wide(variant), room * 0.4f) : 0;
  room -= variants ? for_variant + 20 : 0;
  bool pressed = false;
  float x = opener(ui, {"lesson", title, "Another lesson (Ctrl+O)", x0, y, room}, false, pressed);
  if (pressed) requests.sheet = Sheet::picker;
  if (variants) {
    x += 20;
    opener(ui, {"method", variant, "Another method", x, y, for_variant + 1}, true, pressed);
    if (pressed) ImGui::OpenPopup("methods");
    method_menu(player, ui, head.settings, head.toast, x - 8, y + 20);
  }
  if (in_a_row) {
    draw_chips(head, group, chips, x1, y);
  } else {
    const char* const help_words = head.paging ? "Another preset" : "Another preset (Page Up, Page Down)";
    opener(ui, {"presets", chosen_label(head, group), help_words, x1 - menu + 8, y, menu - 8}, false, pressed);
    if (pressed) ImGui::OpenPopup("preset menu");
    preset_menu(head, group, x1 + 12, y + 20);
  }
  if (chip(ui, "help", help, "?", false)) requests.sheet = Sheet::keys;
  theme_button(ui, head.settings.theme, {help.left - 44, help.top, help.left - 8, help.bottom});
  rule(ui, r.left, r.right, r.bottom - 1);
  ImGui::End();
}

}  // namespace isect::viz
