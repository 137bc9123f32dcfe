// The answers of a scene, beside its picture.

#include <algorithm>
#include <string>
#include <vector>

#include "viz/text/rich_text.h"
#include "viz/window/objects_panel.h"
#include "viz/window/panels.h"
#include "viz/window/scene_marks.h"

namespace isect::viz {

void scene_answers(Column& c, Player& player) {
  constexpr float row = 27, pitch = 25;
  Ui& ui = c.ui;
  const Step& step = player.step();
  if (const float height = values_height(ui, step, c.width + 20, pitch); height > 0) {
    values_block(ui, step, {c.x - 10, c.y + 8, c.x + c.width + 10, c.y + 8 + height}, pitch, nullptr);
    c.y += 8 + height;
  }
  const std::vector<Step>& steps = player.walk().steps;
  const bool asks = std::ranges::any_of(steps, [](const Step& one) { return one.question.has_value(); });
  std::vector<int> told;
  for (int i = 0; i < player.count(); ++i) {
    const bool last = i + 1 == player.count() || steps[i + 1].verdict.text != steps[i].verdict.text;
    if (last && !steps[i].verdict.text.empty() && (!asks || i <= player.index())) told.push_back(i);
  }
  if (told.empty()) return;
  c.y += 20;
  c.paragraph("Answers", ui.palette.text, true);
  c.y += 4;
  const float view = ImGui::GetWindowPos().y, end = view + ImGui::GetWindowHeight();
  int wanted = -1;
  for (const int i : told) {
    const Rect r{c.x - 8, c.y, c.x + c.width + 8, c.y + row};
    c.y += row;
    if (r.bottom < view - row || r.top > end + row) continue;  // there may be thousands
    const Press p = press(ui, "answer " + std::to_string(i + 1), r);
    const Verdict& verdict = steps[i].verdict;
    const bool here = i == player.index();
    if (here || p.hovered) filled(r, here ? ui.palette.frame : ui.palette.hovered, 5);
    verdict_sign(verdict.kind, r.left + 14, r.middle_y(), 12, packed(verdict_ink(ui.palette, verdict.kind)));
    const std::string words = plain(verdict.text), shown = fitted(ui.fonts.body, words, r.width() - 36);
    text(ui.fonts.body, r.left + 28, r.middle_y(), packed(ui.palette.text), shown);
    if (p.hovered && shown != words) tooltip(ui, words);
    if (p.clicked) wanted = i;
  }
  if (wanted >= 0) player.go_to(wanted);
}

}  // namespace isect::viz
