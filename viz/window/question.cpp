// The question before a step, and its result.

#include <algorithm>
#include <cmath>

#include "viz/walk/step_text.h"
#include "viz/window/column.h"
#include "viz/window/panels.h"

namespace isect::viz {
namespace {

/// An answer's look: before it is given, and after.
struct Choice {
  std::string name, markup;
  char key;
  bool open, right, chosen;
};

/// The space that a button keeps free of words for the key, or the sign, at its left.
constexpr float beside_key = 26;

/// Returns the words on one line if there is room, else on several.
Paragraph choice_words(Ui& ui, const std::string& markup, float width, const Colour& colour) {
  Paragraph words{.markup = markup, .line_pitch = 21, .colour = colour};
  if (ui.texts.size_of(words).x > width - beside_key - 6) words.width = width - beside_key - 6;
  return words;
}

bool choice_button(Ui& ui, const Choice& choice, const Rect& r) {
  const Palette& c = ui.palette;
  const Press p = press(ui, choice.name, r);
  filled(r, choice.open && p.hovered ? c.hovered : c.frame);
  if (choice.open && p.hovered) outlined(r, c.first);
  if (!choice.open && (choice.right || choice.chosen)) outlined(r, choice.right ? c.hit : c.miss);
  const float y = r.middle_y();
  if (choice.open) text(ui.fonts.small, r.left + 9, y, packed(c.muted), std::string(1, choice.key));
  if (!choice.open && choice.right) tick(r.left + 13, y, 11, packed(c.hit));
  if (!choice.open && !choice.right && choice.chosen) cross(r.left + 13, y, 11, packed(c.miss));
  const bool quiet = !choice.open && !choice.right && !choice.chosen;
  const Paragraph words = choice_words(ui, choice.markup, r.width(), quiet ? c.muted : c.text);
  const ImVec2 size = ui.texts.size_of(words);
  const float left = words.width > 0 ? r.left + beside_key : r.middle_x() + 7 - size.x / 2;
  rich(ui, words, {left, y - size.y / 2});
  return p.clicked && choice.open;
}

/// Draws the question's answers, side by side if they fit. Returns the one that was pressed, or -1. Where it is not
/// `open` any more, `given` was chosen; -1: none.
int choices(Column& c, const Question& question, bool open, int given) {
  Ui& ui = c.ui;
  const int n = static_cast<int>(question.choices.size());
  float widest = 0;
  for (const std::string& markup : question.choices)
    widest = std::max(widest, ui.texts.size_of({.markup = markup, .colour = ui.palette.text}).x);
  const float share = (c.width - 8 * static_cast<float>(n - 1)) / static_cast<float>(std::max(n, 1));
  const bool in_a_row = widest + 38 <= share;
  int pressed = -1;
  for (int i = 0; i < n; ++i) {
    const float x = in_a_row ? c.x + static_cast<float>(i) * (share + 8) : c.x;
    const float width = in_a_row ? share : c.width;
    const float lines = ui.texts.size_of(choice_words(ui, question.choices[i], width, ui.palette.text)).y;
    const Rect r{x, c.y, x + width, c.y + std::max(36.0f, lines + 12)};
    const Choice choice{"choice " + std::to_string(i), question.choices[i], static_cast<char>('A' + i), open,
                        i == question.answer,          i == given};
    if (choice_button(ui, choice, r)) pressed = i;
    if (!in_a_row || i + 1 == n) c.y = r.bottom + (i + 1 < n ? 6.0f : 0.0f);
  }
  return pressed;
}

}  // namespace

void question(Column& c, Player& player, AnswerField& field, bool fresh, bool values) {
  const Palette& ink = c.ui.palette;
  if (const Question* asked = player.quiz().asked()) {
    c.y += 24;
    if (fresh) ImGui::SetScrollFromPosY(c.y - ImGui::GetWindowPos().y, 0);
    c.paragraph("Your turn", ink.text, 15, 23, true);
    c.y += 2;
    c.paragraph(asked->prompt, ink.text);
    if (const std::vector<Value>& known = player.shown().values; values && !known.empty()) {
      const float top = c.y += 8;
      c.paragraph(given_text(known), ink.text);
      c.ui.rects["known values"] = {c.x, top, c.x + c.width, c.y};
    }
    c.y += 10;
    if (player.quiz().asks_more()) return answer_field(c, player, field, values);
    const int pressed = choices(c, *asked, true, -1);
    if (pressed >= 0) player.answer(pressed);
    return;
  }
  const auto answered = player.quiz().answered();
  if (!answered) return;
  c.y += 24;
  const float begin = c.y;
  const bool right = answered->right();
  const Colour& colour = right ? ink.hit : ink.miss;
  (right ? tick : cross)(c.x + 7, c.y + 11, 13, packed(colour));
  c.x += 22, c.width -= 22;
  c.paragraph(right ? "Right" : "Not quite", colour, 15, 23, true);
  c.x -= 22, c.width += 22;
  c.ui.rects["what came of it"] = {c.x, begin, c.x + c.width, c.y};
  const Rect again{c.x + c.width - 92, begin - 1, c.x + c.width, begin + 23};
  if (chip(c.ui, "numbers again", again, "Again (Y)", false, c.ui.fonts.small)) field.other = true;
  if (ImGui::IsItemHovered()) tooltip(c.ui, "The same question with other numbers");
  c.paragraph(answered->question->prompt, ink.muted);
  if (!answered->told.empty()) {
    const float top = c.y;
    c.paragraph(answered->told, ink.text);
    c.ui.rects["what was typed"] = {c.x, top, c.x + c.width, c.y};
  }
  if (!answered->reply.empty()) {
    const float top = c.y;
    c.paragraph(answered->reply, ink.text);
    c.ui.rects["reply"] = {c.x, top, c.x + c.width, c.y};
  }
  c.y += 8;
  choices(c, *answered->question, false, answered->choice);
  c.y += 10;
  c.paragraph(answered->question->because, ink.text);
  if (!fresh) return;
  // scroll until its end is in sight, or its beginning at the top
  constexpr float margin = 20;
  const float top = ImGui::GetWindowPos().y, height = ImGui::GetWindowHeight();
  if (c.y + margin + ImGui::GetScrollY() > top + height)  // the words begin at the window's top by now
    ImGui::SetScrollFromPosY(c.y - begin + margin < height ? c.y + margin - top : begin - top,
                             c.y - begin + margin < height ? 1 : 0);
}

namespace {

/// Draws the question at the lower end of `r`, as high as its words, which scroll if there is too little room.
void question_within(Player& player, Ui& ui, StepWords& step_words, bool values, Rect r) {
  constexpr float margin = 16;
  r.top = std::max(r.top, r.bottom - step_words.question_height);
  begin_region(ui, "question over scene", r, ui.palette.window, true);
  outlined(r, ui.palette.rule, 1.5f, 0);
  const float top = ImGui::GetCursorScreenPos().y;
  Column c{ui, r.left + margin, top - 12, r.width() - 2 * margin};
  question(c, player, step_words.answer, false, values);
  step_words.question_height = c.y - top + margin;
  ImGui::SetCursorScreenPos({r.left, c.y});
  ImGui::Dummy({1, margin});
  ImGui::End();
}

bool has_question(const Player& player) { return player.quiz().asked() || player.quiz().answered(); }

}  // namespace

void question_over_scene(Player& player, Ui& ui, StepWords& step_words, const Rect& scene, const Rect& words) {
  if (!has_question(player)) return;
  // Once it is answered, the axes in the scene's corner and a ray's t-axis stay visible below it, if there is room.
  const float width = std::min(640.0f, scene.width() - 40), axes = scene.height() < 480 ? 0 : 94;
  const float bottom = player.quiz().asked() ? words.bottom : scene.bottom - axes;
  question_within(player, ui, step_words, true,
                  {scene.left + 20, scene.top + 70, scene.left + 20 + width, bottom - 12});
}

void question_over_scenes(Player& player, Ui& ui, StepWords& step_words, bool values, const Rect& scenes) {
  if (has_question(player)) question_within(player, ui, step_words, values, scenes.inset(12));
}

}  // namespace isect::viz
