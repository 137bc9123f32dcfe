// What a reader presses instead of typing an answer: the tiles of an order, and lines of the pseudocode.

#include <algorithm>
#include <cctype>

#include "viz/walk/given_order.h"
#include "viz/window/column.h"
#include "viz/window/panels.h"

namespace isect::viz {
namespace {

std::size_t place_of(char letter, const std::string& text) {
  return text.find_first_of(std::string{letter, static_cast<char>(letter - 'a' + 'A')});
}

int letters_in(const std::string& text) {
  return static_cast<int>(std::ranges::count_if(text, [](unsigned char c) { return std::isalpha(c) != 0; }));
}

}  // namespace

void order_tiles(Column& c, const OrderAsked& asked, AnswerField& field) {
  const Palette& ink = c.ui.palette;
  constexpr float height = 36, gap = 8, beside_letter = 26, beside_place = 24;
  float x = c.x;
  for (int i = 0; i < static_cast<int>(asked.tiles.size()); ++i) {
    const Paragraph words{.markup = asked.tiles[static_cast<std::size_t>(i)], .line_pitch = 21, .colour = ink.text};
    const float width = c.ui.texts.size_of(words).x + beside_letter + beside_place;
    if (x > c.x && x + width > c.x + c.width) x = c.x, c.y += height + gap;
    const Rect r{x, c.y, x + width, c.y + height};
    x = r.right + gap;
    const Press p = press(c.ui, "tile " + std::to_string(i), r);
    const char letter = tile_letter(i);
    const std::size_t place = place_of(letter, field.text);
    const bool taken = place != std::string::npos;
    filled(r, p.hovered ? ink.hovered : ink.frame);
    if (p.hovered || taken) outlined(r, ink.first);
    text(c.ui.fonts.body, r.left + 9, r.middle_y(), packed(ink.muted), std::string(1, letter));
    rich_line(c.ui, words, r.left + beside_letter, r.middle_y());
    if (taken)
      text(c.ui.fonts.bold, r.right - 8, r.middle_y(), packed(ink.first),
           std::to_string(1 + letters_in(field.text.substr(0, place))), 1);
    if (!p.clicked) continue;
    field.refused.clear();
    if (taken)
      field.text.erase(place, 1);
    else
      field.text += letter;
  }
  c.y += height + gap;
}

int lines_to_point_at(Column& c, const Walk& walk) {
  const Palette& ink = c.ui.palette;
  constexpr float beside_number = 38;
  const float next_row = static_cast<float>(c.ui.fonts.large) + 5, first_row = next_row + 5;
  ImFont* const font = c.ui.fonts.mono_large;
  int pressed = -1;
  for (int i = 0; i < static_cast<int>(walk.pseudocode.size()); ++i) {
    const std::vector<std::string> rows =
        rows_of_line(walk.pseudocode[static_cast<std::size_t>(i)], font, c.width - beside_number - 6);
    const Rect r{c.x, c.y, c.x + c.width, c.y + first_row + next_row * static_cast<float>(rows.size() - 1)};
    float y = c.y + first_row / 2;
    c.y = r.bottom;
    const Press p = press(c.ui, "point " + std::to_string(i + 1), r);
    if (p.hovered) filled(r, ink.hovered, 5);
    text(c.ui.fonts.mono, r.left + beside_number - 10, y, packed(ink.muted), std::to_string(i + 1), 1);
    for (const std::string& row : rows) {
      text(font, r.left + beside_number, y, packed(ink.text), row);
      y += next_row;
    }
    if (p.clicked) pressed = i;
  }
  c.y += 8;
  return pressed;
}

}  // namespace isect::viz
