#include <algorithm>

#include "viz/rich_text.h"
#include "viz/window/panels.h"

namespace isect::viz {
namespace {

/// The lesson's title, which opens the picker. Returns where it ends.
float title(Session& s, float x, float y) {
  Ui& ui = s.ui;
  const std::string words = plain(s.player.lesson().title);
  const float end = x + text_width(ui.fonts.body, words);
  const Press p = press(ui, "lesson", {x - 8, y - 16, end + 8, y + 16});
  if (p.hovered) filled({x - 8, y - 16, end + 8, y + 16}, ui.palette.frame);
  text(ui.fonts.body, x, y, packed(ui.palette.text), words);
  if (p.clicked) s.open_next = Sheet::picker;
  if (p.hovered) tooltip(ui, "Another lesson (Ctrl+O)");
  return end;
}

void method_menu(Session& s, float x, float bottom) {
  ImGui::SetNextWindowPos({x, bottom});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{6, 6});
  if (ImGui::BeginPopup("methods")) {
    ImVec2 at = ImGui::GetCursorScreenPos();
    float width = 120;
    for (const Method& m : s.player.methods())
      width = std::max(width, text_width(s.ui.fonts.body, plain(m.title)) + 28);
    for (const Method& m : s.player.methods()) {
      const Rect r{at.x, at.y, at.x + width, at.y + 30};
      if (chip(s.ui, "method " + m.choice, r, plain(m.title), m.choice == s.player.method())) {
        s.attempt([&] { s.player.load_method(m.choice); });
        ImGui::CloseCurrentPopup();
      }
      at.y += 34;
    }
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

/// The variant on show, which opens the list of them. Returns where it ends.
float method(Session& s, float x, float y) {
  if (s.player.methods().empty()) return x;
  Ui& ui = s.ui;
  const std::string words = plain(s.player.walk().method);
  const float end = x + text_width(ui.fonts.body, words) + 18;
  const Rect r{x - 8, y - 16, end + 6, y + 16};
  const Press p = press(ui, "method", r);
  const Colour& ink = p.hovered ? ui.palette.text : ui.palette.muted;
  if (p.hovered) filled(r, ui.palette.frame);
  text(ui.fonts.body, x, y, packed(ink), words);
  caret(end - 6, y, true, packed(ink));
  if (p.clicked) ImGui::OpenPopup("methods");
  method_menu(s, r.left, r.bottom + 4);
  return end;
}

std::string chip_label(const Preset& preset, std::size_t number, bool wide) {
  const std::string digits = std::to_string(number);
  return wide ? digits + "  " + plain(preset.title) : digits;
}

/// One chip a preset, named while there is room for the name, between x0 and x1.
void presets(Session& s, float x0, float x1, float y) {
  Ui& ui = s.ui;
  const std::vector<const Preset*> group = s.player.group();
  ImFont* font = ui.fonts.body;
  float padding = 24, gap = 8;
  std::vector<float> wide;
  int chosen = -1;
  const auto measure = [&] {
    wide.clear();
    float sum = gap * static_cast<float>(std::max<std::size_t>(group.size(), 1) - 1);
    for (std::size_t i = 0; i < group.size(); ++i) {
      if (group[i]->id == s.player.preset_id()) chosen = static_cast<int>(i);
      wide.push_back(text_width(font, chip_label(*group[i], i + 1, true)) + padding);
      sum += wide.back();
    }
    return sum;
  };
  if (measure() > x1 - x0) {
    font = ui.fonts.small;
    padding = 16, gap = 6;
    measure();
  }
  const std::vector<float> widths = chip_widths(wide, 30, gap, x1 - x0, chosen);

  float x = x1 + gap;
  for (const float w : widths) x -= w + gap;
  for (std::size_t i = 0; i < group.size(); ++i) {
    const Rect r{x, y - 15, x + widths[i], y + 15};
    const std::string label = chip_label(*group[i], i + 1, widths[i] == wide[i]);
    if (chip(ui, "preset " + std::to_string(i + 1), r, label, static_cast<int>(i) == chosen, font))
      s.attempt([&] { s.player.load(*group[i]); });
    if (widths[i] != wide[i] && ImGui::IsItemHovered()) tooltip(ui, plain(group[i]->title));
    x += widths[i] + gap;
  }
}

void theme_button(Session& s, const Rect& r) {
  constexpr ThemeName round[] = {ThemeName::dark, ThemeName::screen, ThemeName::grey};
  const Press p = press(s.ui, "theme", r);
  filled(r, p.hovered ? s.ui.palette.hovered : s.ui.palette.frame);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 middle{r.middle_x(), r.middle_y()};
  const ImU32 ink = packed(s.ui.palette.text);
  list.AddCircle(middle, 7, ink, 24, 1.5f);
  list.PathArcTo(middle, 7, -1.5708f, 1.5708f, 16);
  list.PathFillConvex(ink);
  const auto* at = std::find(std::begin(round), std::end(round), s.settings.theme);
  const ThemeName next = at == std::end(round) || at + 1 == std::end(round) ? round[0] : at[1];
  if (p.hovered) tooltip(s.ui, "Theme: " + name_of(s.settings.theme) + ". Click for " + name_of(next));
  if (p.clicked) s.settings.theme = next;
}

}  // namespace

void top_bar(Session& s, const Rect& r) {
  Ui& ui = s.ui;
  begin_region(ui, "top bar", r, ui.palette.window);
  const float y = 24;
  logo(ui, 30, y);
  text(ui.fonts.heading, 54, y, packed(ui.palette.text), "isect");
  float x = title(s, 128, y);
  x = method(s, x + 20, y);
  if (s.player.preset_id().empty()) {
    const float width = text(ui.fonts.small, x + 14, y, packed(ui.palette.fresh_text), "changed");
    if (press(ui, "changed", {x + 8, y - 14, x + 20 + width, y + 14}).hovered)
      tooltip(ui, "Parameters were changed by hand. R restarts, Ctrl+Z takes the change back");
    x += width + 14;
  }

  const Rect help{r.right - 56, y - 15, r.right - 20, y + 15};
  if (chip(ui, "help", help, "?", false)) s.open_next = Sheet::keys;
  theme_button(s, {help.left - 44, help.top, help.left - 8, help.bottom});
  presets(s, x + 24, help.left - 60, y);
  rule(ui, r.left, r.right, r.bottom - 1);
  ImGui::End();
}

}  // namespace isect::viz
