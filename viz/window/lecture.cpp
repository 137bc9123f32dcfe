// The words of a step below the scene while the panels are hidden, to be read from afar, and beside them the current
// line and the formula.

#include <algorithm>

#include "viz/window/panels.h"

namespace isect::viz {
namespace {

constexpr float told_margin = 24, told_padding = 14, told_gap = 28, line_gap = 12;

struct Told {
  Paragraph caption, formula;
  float right = 0;  ///< width of the line and the formula; 0: there are none
};

Told told_of(const Step& step, const Palette& c, float width) {
  const float room = width - 2 * told_margin;
  Told told;
  if (step.line >= 0 || !step.formula.empty()) told.right = std::clamp(0.42f * room, 260.0f, 520.0f);
  told.caption = {.markup = step.caption,
                  .width = std::min(room - (told.right > 0 ? told.right + told_gap : 0.0f), 940.0f),
                  .size = 17,
                  .line_pitch = 25,
                  .colour = c.text};
  told.formula = {
      .markup = step.formula, .width = told.right, .size = 20, .line_pitch = 28, .math = true, .colour = c.text};
  return told;
}

float line_height(const Player& player, const Ui& ui, const Told& told) {
  return player.step().line >= 0 ? current_line_height(player, ui, told.right) + line_gap : 0;
}

float height_of(const Player& player, Ui& ui, const Told& told) {
  const float formula = told.formula.markup.empty() ? 0 : ui.texts.size_of(told.formula).y;
  return 2 * told_padding + std::max(ui.texts.size_of(told.caption).y, line_height(player, ui, told) + formula);
}

}  // namespace

float lecture_height(const Player& player, Ui& ui, StepWords& step_words, float width, float room) {
  StepWords::Lecture& kept = step_words.lecture;
  if (kept.lesson != &player.lesson() || kept.width != width) kept = {&player.lesson(), width, 0};
  kept.height = std::max(kept.height, height_of(player, ui, told_of(player.step(), ui.palette, width)));
  return std::round(std::min(kept.height, 0.36f * room));
}

void lecture(Player& player, Ui& ui, StepWords& step_words, const Rect& r) {
  begin_region(ui, "lecture", r);
  if (player.quiz().asked()) {  // the question covers the scene
    rule(ui, r.left, r.right, r.top);
    ImGui::End();
    return;
  }
  const Told told = told_of(player.step(), ui.palette, r.width());
  const float left = r.left + told_margin, top = r.top + told_padding;
  const float caption = static_cast<float>(told.caption.width);
  scrolling(ui, "told words", {left, r.top + 1, left + caption + 12, r.bottom - 1}, [&] {
    const float y = ImGui::GetCursorScreenPos().y + told_padding;
    if (std::exchange(step_words.seen, player.revision()) != player.revision()) ImGui::SetScrollY(0);
    const ImVec2 size = rich(ui, told.caption, {left, y});
    ImGui::SetCursorScreenPos({left, y});
    ImGui::Dummy({1, size.y});
  });
  if (told.right > 0) {
    const float x = r.right - told_margin - told.right, below = line_height(player, ui, told);
    if (below > 0) current_line(player, ui, {x, top, x + told.right, top + below - line_gap});
    rich(ui, told.formula, {x, top + below});
  }
  rule(ui, r.left, r.right, r.top);
  ImGui::End();
}

}  // namespace isect::viz
