// The question before a step, and its result.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

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
Paragraph choice_words(Ui& ui, const std::string& markup, double size, float width, const Colour& colour) {
  Paragraph words{.markup = markup, .size = size, .line_pitch = size + 6, .colour = colour};
  if (ui.texts.size_of(words).x > width - beside_key - 6) words.width = width - beside_key - 6;
  return words;
}

bool choice_button(Ui& ui, const Choice& choice, double size_of_words, const Rect& r) {
  const Palette& c = ui.palette;
  const Press p = press(ui, choice.name, r);
  filled(r, choice.open && p.hovered ? c.hovered : c.frame);
  if (choice.open && p.hovered) outlined(r, c.first);
  if (!choice.open && (choice.right || choice.chosen)) outlined(r, choice.right ? c.hit : c.miss);
  const float y = r.middle_y();
  if (choice.open) text(ui.fonts.body, r.left + 9, y, packed(c.muted), std::string(1, choice.key));
  if (!choice.open && choice.right) tick(r.left + 13, y, 11, packed(c.hit));
  if (!choice.open && !choice.right && choice.chosen) cross(r.left + 13, y, 11, packed(c.miss));
  const bool quiet = !choice.open && !choice.right && !choice.chosen;
  const Paragraph words = choice_words(ui, choice.markup, size_of_words, r.width(), quiet ? c.muted : c.text);
  const ImVec2 size = ui.texts.size_of(words);
  const float left = words.width > 0 ? r.left + beside_key : r.middle_x() + 7 - size.x / 2;
  rich(ui, words, {left, y - size.y / 2});
  return p.clicked && choice.open;
}

constexpr float across_choices = 8, below_choices = 6;  ///< gaps between answers

/// Answers in rows, `columns` beside each other.
struct ChoiceGrid {
  int columns = 1;
  float width = 0, height = 0;  ///< of each answer; of all rows
  std::vector<float> rows = {};
};

ChoiceGrid grid_of(Column& c, const std::vector<std::string>& choices, int columns) {
  ChoiceGrid grid{columns, (c.width - across_choices * static_cast<float>(columns - 1)) / static_cast<float>(columns)};
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const Paragraph words = choice_words(c.ui, choices[i], c.size, grid.width, c.ui.palette.text);
    if (i % static_cast<std::size_t>(columns) == 0) grid.rows.push_back(36);
    grid.rows.back() = std::max(grid.rows.back(), c.ui.texts.size_of(words).y + 12);
  }
  for (const float row : grid.rows) grid.height += row + below_choices;
  return grid;
}

/// Returns the lowest rows in which each answer stands on one line, or has room enough for several.
ChoiceGrid lowest_grid(Column& c, const std::vector<std::string>& choices) {
  constexpr float room_for_lines = 280;
  const int count = static_cast<int>(choices.size());
  float widest = 0;
  for (const std::string& markup : choices)
    widest = std::max(widest, c.ui.texts.size_of({.markup = markup, .size = c.size, .colour = c.ui.palette.text}).x);
  ChoiceGrid best = grid_of(c, choices, 1);
  for (int rows = 1; rows < count; ++rows) {
    const ChoiceGrid grid = grid_of(c, choices, (count + rows - 1) / rows);
    const bool has_room = widest + 38 <= grid.width || grid.width >= room_for_lines;
    if (has_room && grid.height < best.height) best = grid;
  }
  return best;
}

/// Draws these of the question's answers. Returns the one that was pressed, or -1. Where it is not `open` any more,
/// `given` was chosen; -1: none.
int choices(Column& c, const Question& question, const std::vector<int>& which, bool open, int given) {
  std::vector<std::string> words;
  for (const int i : which) words.push_back(question.choices[static_cast<std::size_t>(i)]);
  const ChoiceGrid grid = lowest_grid(c, words);
  int pressed = -1;
  for (std::size_t k = 0; k < which.size(); ++k) {
    const std::size_t column = k % static_cast<std::size_t>(grid.columns);
    const std::size_t row = k / static_cast<std::size_t>(grid.columns);
    if (column == 0 && row > 0) c.y += grid.rows[row - 1] + below_choices;
    const float x = c.x + static_cast<float>(column) * (grid.width + across_choices);
    const Choice choice{"choice " + std::to_string(which[k]), words[k],         static_cast<char>('A' + which[k]), open,
                        which[k] == question.answer,          which[k] == given};
    if (c.draws && choice_button(c.ui, choice, c.size, {x, c.y, x + grid.width, c.y + grid.rows[row]}))
      pressed = which[k];
  }
  if (!which.empty()) c.y += grid.rows.back();
  return pressed;
}

std::vector<int> all_choices(const Question& question) {
  std::vector<int> all(question.choices.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/// Draws the open question with what answers it.
void open_question(Column& c, Player& player, AnswerField& field) {
  const Question& asked = *player.quiz().asked();
  c.paragraph(asked.prompt, c.ui.palette.text);
  c.y += 10;
  if (player.quiz().asks_more()) return answer_field(c, player, field);
  const int pressed = choices(c, asked, all_choices(asked), true, -1);
  if (pressed >= 0) player.answer(pressed);
}

/// Draws what came of an answer, these of the answers, and why.
void told_answer(Column& c, const Answered& answered, const std::vector<int>& which, AnswerField& field) {
  const Palette& ink = c.ui.palette;
  const float begin = c.y;
  const bool right = answered.right();
  const Colour& colour = right ? ink.hit : ink.miss;
  if (c.draws) (right ? tick : cross)(c.x + 7, c.y + static_cast<float>(std::floor(c.pitch / 2)), 13, packed(colour));
  c.x += 22, c.width -= 22;
  c.paragraph(right ? "Right" : "Not quite", colour, true);
  c.x -= 22, c.width += 22;
  c.ui.rects["what came of it"] = {c.x, begin, c.x + c.width, c.y};
  if (c.draws) {
    const Rect again{c.x + c.width - 92, begin - 1, c.x + c.width, begin + 23};
    if (chip(c.ui, "numbers again", again, "Again (Y)", false)) field.other = true;
    if (ImGui::IsItemHovered()) tooltip(c.ui, "The same question with other numbers");
  }
  c.paragraph(answered.question->prompt, ink.muted);
  if (!answered.told.empty()) {
    const float top = c.y;
    c.paragraph(answered.told, ink.text);
    c.ui.rects["what was typed"] = {c.x, top, c.x + c.width, c.y};
  }
  if (!answered.reply.empty()) {
    const float top = c.y;
    c.paragraph(answered.reply, ink.text);
    c.ui.rects["reply"] = {c.x, top, c.x + c.width, c.y};
  }
  c.y += 8;
  choices(c, *answered.question, which, false, answered.choice);
  c.y += 10;
  c.paragraph(answered.question->because, ink.text);
}

}  // namespace

void question(Column& c, Player& player, AnswerField& field, bool fresh) {
  if (player.quiz().asked()) {
    c.y += 24;
    if (fresh) ImGui::SetScrollFromPosY(c.y - ImGui::GetWindowPos().y, 0);
    c.paragraph("Your turn", c.ui.palette.text, true);
    c.y += 2;
    return open_question(c, player, field);
  }
  const std::optional<Answered>& answered = player.quiz().answered();
  if (!answered) return;
  c.y += 24;
  const float begin = c.y;
  told_answer(c, *answered, all_choices(*answered->question), field);
  if (!fresh) return;
  // scroll until its end is in sight, or its beginning at the top
  constexpr float margin = 20;
  const float top = ImGui::GetWindowPos().y, height = ImGui::GetWindowHeight();
  if (c.y + margin + ImGui::GetScrollY() > top + height)  // the words begin at the window's top by now
    ImGui::SetScrollFromPosY(c.y - begin + margin < height ? c.y + margin - top : begin - top,
                             c.y - begin + margin < height ? 1 : 0);
}

void question_in_lecture(Column& c, Player& player, AnswerField& field) {
  if (player.quiz().asked()) return open_question(c, player, field);
  const float begin = c.y;
  if (const std::optional<Answered>& answered = player.quiz().answered()) {
    std::vector<int> which = {answered->question->answer};
    if (answered->choice >= 0 && !answered->right()) which.push_back(answered->choice);
    told_answer(c, *answered, which, field);
  } else if (const std::optional<Question>& passed = player.step().question;
             passed && player.quiz().is_skipped(player.index())) {
    c.paragraph("The answer", c.ui.palette.text, true);
    c.paragraph(passed->prompt, c.ui.palette.muted);
    c.y += 8;
    choices(c, *passed, {passed->answer}, false, -1);
    c.y += 10;
    c.paragraph(passed->because, c.ui.palette.text);
    c.ui.rects["the answer"] = {c.x, begin, c.x + c.width, c.y};
  }
  if (c.y == begin) return;
  c.y += 10;
  if (c.draws) rule(c.ui, c.x, c.x + c.width, c.y);
  c.y += 12;
}

}  // namespace isect::viz
