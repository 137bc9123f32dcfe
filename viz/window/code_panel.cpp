#include <algorithm>
#include <cmath>

#include "viz/window/panels.h"

namespace isect::viz {
namespace {

constexpr float padding = 20, code_top = 46;

/// Pitches and heights of the panel: roomy where the whole walk fits, tighter where it does not. The walk's
/// fullest step decides, so that lines keep their places while a reader steps.
struct Fit {
  float code_pitch, value_pitch, operations, code_height, values_height;
};

float most_values(const Walk& walk, float pitch) {
  float most = 0;
  for (const Step& step : walk.steps) most = std::max(most, values_height(step, pitch));
  return most;
}

Fit fit(const Walk& walk, const Step& step, float height) {
  constexpr Fit sizes[] = {{26, 28, 58, 0, 0}, {23, 25, 34, 0, 0}, {21, 22, 34, 0, 0}};
  const float lines = static_cast<float>(walk.pseudocode.size());
  Fit f{};
  float room = 0;
  for (const Fit& size : sizes) {
    f = size;
    f.code_height = lines * f.code_pitch;
    f.values_height = most_values(walk, f.value_pitch);
    room = height - code_top - f.operations;
    if (f.code_height + f.values_height <= room) return f;
  }
  // Too much for this window: the code shows a part around its current line, the values scroll if they must.
  const float least_code = std::min(f.code_height, 5 * f.code_pitch);
  f.values_height = std::min(values_height(step, f.value_pitch), room - least_code);
  const float whole_lines = std::floor((room - f.values_height) / f.code_pitch) * f.code_pitch;
  f.code_height = std::min(f.code_height, whole_lines);
  return f;
}

bool has(const std::vector<int>& lines, int line) {
  return std::find(lines.begin(), lines.end(), line) != lines.end();
}

/// The next step, going round, that stands at this line; -1 if none does.
int step_at_line(const Player& player, int line) {
  for (int i = 1; i <= player.count(); ++i) {
    const int step = (player.index() + i) % player.count();
    if (player.walk().steps[step].line == line) return step;
  }
  return -1;
}

void code_line(Session& s, int line, const Rect& r) {
  Ui& ui = s.ui;
  const Palette& c = ui.palette;
  const Step& step = s.player.step();
  const bool current = line == step.line;
  const int to = step_at_line(s.player, line);
  const Press p = press(ui, "line " + std::to_string(line + 1), r);
  if (current)
    filled(r, c.highlight, 5);
  else if (p.hovered && to >= 0)
    filled(r, c.frame, 5);
  if (p.clicked && to >= 0) s.player.go_to(to);

  const Colour& ink = current ? c.on_highlight : has(step.untaken, line) ? c.muted : c.text;
  const float y = r.middle_y(), number = r.left + 26;
  text(ui.fonts.mono_small, number, y, packed(current ? c.on_highlight : c.muted), std::to_string(line + 1),
       1);
  const bool refused = has(step.refused, line);
  ImGui::PushClipRect({number + 8, r.top}, {r.right - (refused ? 38 : 4), r.bottom}, true);
  const std::string& words = s.player.walk().pseudocode[line];
  ImFont* font =
      text_width(ui.fonts.mono, words) > r.right - number - 20 ? ui.fonts.mono_small : ui.fonts.mono;
  text(font, number + 16, y, packed(ink), words);
  ImGui::PopClipRect();
  if (refused) text(ui.fonts.small, r.right - 12, y, packed(current ? c.on_highlight : c.miss), "no", 1);
}

void code(Session& s, const Rect& r, float pitch) {
  s.ui.rects["code lines"] = r;
  ImGui::SetCursorScreenPos(top_left(r));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{0, 0});
  ImGui::BeginChild("code", {r.width(), r.height()}, false, ImGuiWindowFlags_NoScrollbar);
  ImGui::PopStyleVar();
  const int line = s.player.step().line;
  const float lines_before = std::floor(static_cast<float>(line) - (r.height() / pitch - 1) / 2);
  if (line >= 0) ImGui::SetScrollY(std::max(0.0f, lines_before * pitch));
  const float top = ImGui::GetCursorScreenPos().y;
  const int count = static_cast<int>(s.player.walk().pseudocode.size());
  for (int i = 0; i < count; ++i) {
    const float y = top + static_cast<float>(i) * pitch;
    code_line(s, i, {r.left, y, r.right, y + pitch});
  }
  ImGui::EndChild();
}

}  // namespace

void code_panel(Session& s, const Rect& r) {
  Ui& ui = s.ui;
  begin_region(ui, "code panel", r, ui.palette.window);
  ImGui::GetWindowDrawList()->AddRectFilled({r.left, r.top}, {r.left + 1, r.bottom}, packed(ui.palette.rule));
  const Fit f = fit(s.player.walk(), s.player.step(), r.height());
  const float heading = r.top + 32;
  text(ui.fonts.bold, r.left + padding, heading, packed(ui.palette.text), "Pseudocode");
  if (s.player.step().counters.early_out)
    text(ui.fonts.small, r.right - padding, heading, packed(ui.palette.fresh_text), "early out", 1);
  const float code_bottom = r.top + code_top + f.code_height;
  code(s, {r.left + 10, r.top + code_top, r.right - 10, code_bottom}, f.code_pitch);
  values_block(s, {r.left + 10, code_bottom, r.right - 10, code_bottom + f.values_height}, f.value_pitch);
  operations_block(s, {r.left + 10, r.bottom - f.operations, r.right - 10, r.bottom});
  ImGui::End();
}

}  // namespace isect::viz
