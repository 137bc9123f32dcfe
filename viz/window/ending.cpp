// The end of a lesson: the next one, what was skipped or answered wrong, and what to read.

#include "viz/player/practice.h"
#include "viz/text/rich_text.h"
#include "viz/walk/closing.h"
#include "viz/window/column.h"
#include "viz/window/panels.h"

namespace isect::viz {
namespace {

/// Draws a paragraph beside a sign's room.
void beside_sign(Column& c, const std::string& markup, const Colour& ink) {
  constexpr float sign = 22;
  c.x += sign, c.width -= sign;
  c.paragraph(markup, ink);
  c.x -= sign, c.width += sign;
}

}  // namespace

void open_next_lesson(Player& player, Toast& toast) {
  if (!leads_to_next_lesson(player)) return;
  const Lesson& next = *next_lesson(player);
  attempt(toast, [&] {
    player.open(next);
    toast.say(plain(next.title) + ". Ctrl+Z goes back");
  });
}

void next_lesson_button(Column& c, Player& player, Toast& toast) {
  if (!leads_to_next_lesson(player)) return;
  Ui& ui = c.ui;
  c.y += 16;
  const std::string words = "Next: " + plain(short_title(*next_lesson(player)));
  const Rect r{c.x, c.y, c.x + c.width, c.y + Column::button_height + 4};
  const bool pressed = chip(ui, "next lesson", r, fitted(ui.fonts.body, words, c.width - 20), true);
  text(ui.fonts.body, r.middle_x(), r.bottom + 12, packed(ui.palette.muted), "→ or N goes there, too", 0.5f);
  c.y = r.bottom + 22;
  if (pressed) open_next_lesson(player, toast);
}

void missed(Column& c, Player& player, const Settings& settings) {
  const std::vector<Missed> all = missed_questions(player, settings);
  if (all.empty()) return;
  const Palette& ink = c.ui.palette;
  c.y += 24;
  c.paragraph("Skipped or wrong", ink.text, true);
  for (const auto& [step, skipped] : all) {
    c.y += 10;
    const float sign = c.y + 11;
    if (skipped)
      ring(c.x + 7, sign, 12, packed(ink.muted));
    else
      cross(c.x + 7, sign, 11, packed(ink.miss));
    beside_sign(c, player.walk().steps[step].question->prompt, ink.text);
    c.y += 6;
    float x = c.x;
    const std::string number = std::to_string(step + 1);
    if (c.button("again " + number, skipped ? "Skipped: answer it" : "Wrong: answer again", x))
      return player.ask_again(step);
    c.y += Column::button_height + 4;
  }
}

void reading(Column& c, const Player& player, bool& open) {
  const Closing* const closing = player.lesson().closing;
  if (!closing || closing->reading.empty()) return;
  const Palette& ink = c.ui.palette;
  c.y += 24;
  const Press p = press(c.ui, "reading", {c.x, c.y, c.x + c.width, c.y + 26});
  caret(c.x + 6, c.y + 13, open, packed(p.hovered ? ink.text : ink.muted));
  const std::string count = std::to_string(closing->reading.size());
  text(c.ui.fonts.bold, c.x + 20, c.y + 13, packed(ink.text), "To read (" + count + ")");
  c.y += 30;
  if (open)
    for (const std::string& source : closing->reading) {
      c.paragraph(source, ink.text);
      c.y += 6;
    }
  if (p.clicked) open = !open;
}

}  // namespace isect::viz
