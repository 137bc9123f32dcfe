// Practice with a lesson: a reader sees a published line fail, and tries exercises.

#include <algorithm>

#include "viz/player/practice.h"
#include "viz/text/rich_text.h"
#include "viz/walk/closing.h"
#include "viz/walk/exercise_text.h"
#include "viz/walk/step_text.h"
#include "viz/window/column.h"
#include "viz/window/layout.h"
#include "viz/window/panels.h"

namespace isect::viz {
namespace {

constexpr float button_sides = 28;  ///< beside its words, both

/// Draws the lines of the program that an exercise shows, with their numbers.
void program_lines(Column& c, const Exercise& e) {
  if (e.program.empty()) return;
  constexpr float pitch = 20, beside_number = 34;
  ImFont* const font = c.ui.fonts.mono;
  const Palette& ink = c.ui.palette;
  const float top = c.y += 6;
  const int columns = static_cast<int>((c.width - beside_number) / text_width(font, "0"));
  int number = 0;
  for (const std::string& line : e.program) {
    text(font, c.x + beside_number - 10, c.y + pitch / 2, packed(ink.muted), std::to_string(++number), 1);
    for (const std::string& row : code_rows(line, columns)) {
      text(font, c.x + beside_number, c.y + pitch / 2, packed(ink.text), row);
      c.y += pitch;
    }
  }
  c.ui.rects["program"] = {c.x, top, c.x + c.width, c.y};
  c.y += 4;
}

/// Begins an exercise; if the keyboard began it, the keyboard focus moves to what can be moved.
void begin_exercise(Player& player, Focus& focus, Toast& toast, int index) {
  const bool by_keyboard = focus.pressed();
  attempt(toast, [&] { begin_exercise(player, index); });
  const std::vector<Handle>& handles = player.scene().handles;
  const Exercise* e = player.exercise();
  if (!by_keyboard || !e || handles.empty()) return;
  const auto meant = [&](const Handle& h) {
    return std::ranges::any_of(e->by, [&](const auto& set) { return set.first == h.parameter; });
  };
  const auto first = std::ranges::find_if(handles, meant);
  focus.take("handle " + (first == handles.end() ? handles.front() : *first).id());
}

}  // namespace

bool Column::button(const std::string& name, const std::string& words, float& from) {
  const std::string label = fitted(ui.fonts.body, words, width - button_sides);
  const float wide = text_width(ui.fonts.body, label) + button_sides;
  if (from > x && from + wide > x + width) from = x, y += button_height + 6;
  const bool pressed = chip(ui, name, {from, y, from + wide, y + button_height}, label, false);
  if (label != words && ImGui::IsItemHovered()) tooltip(ui, words);
  from += wide + 8;
  return pressed;
}

void erratum(Column& c, Player& player, std::optional<Player>& before, Toast& toast) {
  const std::vector<ErratumText> all = errata_text(player.lesson(), player.walk());
  const auto e = std::ranges::find(all, player.step().line + 1, &ErratumText::line);
  if (e == all.end()) return;
  c.y += 20;
  c.paragraph(e->says, c.ui.palette.text, true);
  c.paragraph(e->why, c.ui.palette.text);
  if (player.played().preset_id() == e->shown_by->id) return;  // the line fails in this setting
  c.y += 8;
  float x = c.x;
  if (c.button("see it fail", "See it fail (E)", x)) attempt(toast, [&] { fault_or_back(player, before); });
  c.y += Column::button_height;
}

void exercises(Column& c, Player& player, std::set<const Exercise*>& shown, const std::set<std::string>& solved,
               Toast& toast) {
  const Closing* closing = player.lesson().closing;
  if (!closing) return;
  const Palette& ink = c.ui.palette;
  c.y += 24;
  c.paragraph("Exercises", ink.text, true);
  for (std::size_t i = 0; i < closing->exercises.size(); ++i) {
    const Exercise& e = closing->exercises[i];
    const std::string number = std::to_string(i + 1);
    c.y += 10;
    if (solved.contains(e.prompt)) {
      c.ui.rects["solved " + number] = {c.x, c.y + 4, c.x + 14, c.y + 18};
      tick(c.x + 7, c.y + 11, 13, packed(ink.hit));
      c.x += 22, c.width -= 22;
      c.paragraph(number + ". " + e.prompt, ink.text);
      c.x -= 22, c.width += 22;
    } else {
      c.paragraph(number + ". " + e.prompt, ink.text);
    }
    program_lines(c, e);
    c.y += 6;
    float x = c.x;
    if (e.found && c.button("try " + number, "Try it", x))
      return begin_exercise(player, c.ui.focus, toast, static_cast<int>(i));
    const bool open = shown.contains(&e);
    const char* const hide = e.program.empty() ? "Hide the solution" : "Hide the correction";
    if (c.button("solution " + number, open ? hide : solution_head(e), x))
      open ? (void)shown.erase(&e) : (void)shown.insert(&e);
    c.y += Column::button_height + 4;
    if (open) c.paragraph(e.solution, ink.muted);
  }
  if (const std::optional<Judge> own = judge(player.lesson())) {
    c.y += 10;
    c.paragraph(own->told, ink.text);
    for (const std::string& line : own->command) c.paragraph(as_markup(line), ink.muted);
  }
}

void same_ideas(Column& c, Player& player, Toast& toast) {
  const std::vector<SharedIdea> all = shared_ideas(player.lesson());
  if (all.empty()) return;
  c.y += 24;
  c.paragraph("The same idea elsewhere", c.ui.palette.text, true);
  for (const SharedIdea& shared : all) {
    c.y += 6;
    c.paragraph(heading(shared), c.ui.palette.muted);
    c.y += 4;
    float x = c.x;
    for (const Lesson* other : shared.others) {
      const std::string title = plain(short_title(*other));
      if (c.button("same idea " + shared.idea + ": " + other->id, title, x))
        return attempt(toast, [&] { player.open(*other); });
    }
    c.y += Column::button_height + 4;
  }
}

void exercise_on_hand(Column& c, Player& player) {
  const Exercise* e = player.exercise();
  if (!e) return;
  const Palette& ink = c.ui.palette;
  const bool solved = exercise_solved(player);
  const float top = c.y;
  c.paragraph(e->prompt, ink.text, true);
  program_lines(c, *e);
  if (solved) {
    const std::string said = found_text(*e, player.parameters());
    tick(c.x + 7, c.y + 11, 13, packed(ink.hit));
    c.x += 22, c.width -= 22;
    const float found = c.y;
    c.paragraph("Found. " + (said.empty() ? e->solution : said + "\n" + e->solution), ink.hit);
    c.ui.rects["found"] = {c.x, found, c.x + c.width, c.y};
    c.x -= 22, c.width += 22;
  } else {
    c.paragraph(
        "Drag the handles, with Shift to where the case changes. Where no handle reaches, type numbers under "
        "Parameters.",
        ink.muted);
  }
  c.ui.rects["exercise"] = {c.x, top, c.x + c.width, c.y};
  c.y += 8;
  float x = c.x;
  const bool back = c.button("end exercise", solved ? "Back to the exercises" : "Give up", x);
  c.y += Column::button_height + 20;
  if (!back) return;
  player.set_exercise({});
  player.last();
}

}  // namespace isect::viz
