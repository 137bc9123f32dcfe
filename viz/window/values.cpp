#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

#include "viz/text/names.h"
#include "viz/text/rich_text.h"
#include "viz/walk/alt_text.h"
#include "viz/walk/step_text.h"
#include "viz/window/panels.h"
#include "viz/window/value_bars.h"

namespace isect::viz {
namespace {

/// Heights of the block's parts: rule with the heading; a further row of the comparison's condition or meaning.
constexpr float block_heading = 36, meaning_pitch = 19;

/// Breaks words into as few lines as fit into `room`.
std::vector<std::string> lines_of(const Ui& ui, const std::string& words, float room) {
  std::vector<std::string> lines;
  std::istringstream in(words);
  for (std::string word; in >> word;)
    if (!lines.empty() && text_width(ui.fonts.body, lines.back() + " " + word) <= room)
      lines.back() += " " + word;
    else
      lines.push_back(word);
  return lines;
}

/// Returns both sides in full if they would read alike among the values; else nothing.
std::string in_full(const Comparison& c) {
  if (c.left == c.right || shown(c.left) != shown(c.right)) return {};
  return plain(compared_numbers(c));
}

/// Returns the inequalities of a comparison; each has a bar of its own.
std::vector<Comparison> inequalities(const Comparison& c) { return c.parts.empty() ? std::vector{c} : c.parts; }

/// Heights of the card's parts: its head; a part of the condition; a bar.
constexpr float card_head = 34, part_head = 22, bar_room = 28;

/// Returns a condition as a line of code, on as many rows as it takes; "true" or "false" has room after the last one.
std::vector<std::string> condition_rows(const Ui& ui, const Comparison& c, float room) {
  return rows_of_line(plain(c.text), ui.fonts.mono, room - 27 - text_width(ui.fonts.body, "false"));
}

/// Returns the height of the condition's rows after the first.
float more_rows(const Ui& ui, const Comparison& c, float room) {
  return meaning_pitch * static_cast<float>(condition_rows(ui, c, room).size() - 1);
}

/// Whether the meaning stands beside the condition.
bool on_one_line(const Ui& ui, const Comparison& c, float room) {
  const std::vector<std::string> rows = condition_rows(ui, c, room);
  return rows.size() == 1 && text_width(ui.fonts.mono, rows.front()) + 41 + text_width(ui.fonts.body, "false") +
                                     text_width(ui.fonts.body, plain(c.meaning)) <=
                                 room;
}

float card_height(const Ui& ui, const Comparison& c, float width) {
  const float room = width - 32;
  float height = card_head + 10 + more_rows(ui, c, room);
  if (!on_one_line(ui, c, room))
    height += meaning_pitch * static_cast<float>(lines_of(ui, plain(c.meaning), room).size());
  for (const Comparison& part : inequalities(c))
    height += (c.parts.empty() ? 0 : part_head + more_rows(ui, part, room)) + bar_room +
              meaning_pitch * static_cast<float>(lines_of(ui, in_full(part), room).size());
  return height;
}

/// Returns the room for the word "new" beside bars and numbers: the same for all bars of a step, as they share a scale.
float room_for_new(const Step& step) { return std::ranges::any_of(step.values, &Value::fresh) ? 38 : 0; }

/// Returns where the numbers end: beside the longest name on a line with its number, or further left if all are short.
float number_column(const Ui& ui, const Step& step, const std::vector<std::string>& digits, const Rect& r) {
  float column = r.width() * 0.494f;
  for (std::size_t i = 0; i < digits.size(); ++i)
    column = std::max(
        column, 10 + text_width(ui.fonts.mono, plain(step.values[i].name)) + 14 + text_width(ui.fonts.mono, digits[i]));
  return r.left + std::min(column, r.width() - 10 - room_for_new(step));
}

/// `number`: where the digits end; `beside_bar`: the room for the word "new".
void value_row(Ui& ui, const Value& v, const std::string& digits, const std::vector<UnitBars>& units, const Rect& r,
               float number, float beside_bar) {
  const Palette& c = ui.palette;
  const float y = r.middle_y();
  const float room = number - text_width(ui.fonts.mono, digits) - 8 - (r.left + 10);
  ImFont* const font = text_width(ui.fonts.mono, plain(v.name)) > room ? ui.fonts.body : ui.fonts.mono;
  const std::string name = fitted(font, plain(v.name), room);
  const std::vector<std::string> names = keys(names_in(v.name));
  if (ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(top_left(r), bottom_right(r))) ui.light.point(names, r);
  ui.rects["value " + name] = r;
  if (focused(ui, "value " + name, r)) ui.light.hold(names, r);
  text(font, r.left + 10, y, packed(c.text), name);
  lights_in(ui, font, r.left + 10, y, name);
  if (name != plain(v.name) && ImGui::IsMouseHoveringRect(top_left(r), bottom_right(r))) tooltip(ui, plain(v.name));
  const float from = number - text(ui.fonts.mono, number, y, packed(c.text), digits, 1);
  ui.rects["number " + name] = {from, y - 7, number, y + 7};
  if (!v.unit.empty() && names.empty() && ImGui::IsMouseHoveringRect(top_left(r), bottom_right(r)))
    tooltip(ui, "unit: " + plain(v.unit));
  const float right = r.right - 10;
  if (v.fresh) {
    outlined({r.left, r.top + 1, r.right, r.bottom - 1}, c.fresh, 1.5f, 5);
    const float width = text(ui.fonts.body, right - 2, y, packed(c.fresh_text), "new", 1);
    ui.rects["new " + name] = {right - 2 - width, y - 7, right - 2, y + 7};
  }
  const auto unit = std::ranges::find(units, v.unit, &UnitBars::unit);
  const bool room_for_bar = right - beside_bar - number - 26 > 20;
  if (unit != units.end() && room_for_bar) value_bar(ui, *unit, v, number + 26, right - beside_bar, y);
}

/// Draws a condition from the row around y down, and after its last row whether it is true.
void truth(Ui& ui, const Comparison& c, float x, float y, float room) {
  const Colour& ink = c.holds ? ui.palette.hit : ui.palette.miss;
  ImFont* const font = ui.fonts.mono;
  float end = x;
  y -= meaning_pitch;
  for (const std::string& row : condition_rows(ui, c, room)) {
    y += meaning_pitch;
    end = x + text(font, x, y, packed(ui.palette.text), row) + 10;
    lights_in(ui, font, x, y, row);
  }
  (c.holds ? tick : ring)(end + 6, y, 13, packed(ink));
  text(ui.fonts.body, end + 17, y, packed(ink), c.holds ? "true" : "false");
}

/// Draws the condition with its sign, its meaning, and both sides of each of its inequalities as bars. The meaning
/// stands beside the condition or, if there is no room, on lines of its own.
void comparison_card(Ui& ui, const Step& step, const Comparison& comparison, const Rect& r) {
  const std::vector<UnitBars> units = units_of(step);
  const Palette& c = ui.palette;
  ui.rects["comparison"] = r;
  filled(r, c.card, 8);
  const std::vector<std::string> names = keys(names_in(comparison.text));
  if (ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(top_left(r), bottom_right(r))) ui.light.point(names, r);
  if (focused(ui, "comparison", r)) ui.light.hold(names, r);
  const float y = r.top + 20, x0 = r.left + 16, x1 = r.right - 16, room = x1 - x0;
  truth(ui, comparison, x0, y, room);
  const std::string meaning = plain(comparison.meaning);
  float bar_y = r.top + 45 + more_rows(ui, comparison, room);
  const auto lines = [&](const std::string& words, const Colour& ink) {
    for (const std::string& line : lines_of(ui, words, room)) {
      text(ui.fonts.body, x0, bar_y - 4, packed(ink), line);
      bar_y += meaning_pitch;
    }
  };
  if (on_one_line(ui, comparison, room))
    text(ui.fonts.body, x1, y, packed(c.muted), meaning, 1);
  else
    lines(meaning, c.muted);
  ui.rects["meaning"] = {x0, r.top + 8, x1, bar_y - 10};
  int part_number = 0;
  for (const Comparison& part : inequalities(comparison)) {
    if (!comparison.parts.empty()) {
      const float more = more_rows(ui, part, room);
      truth(ui, part, x0, bar_y - 2, room);
      ui.rects["condition " + std::to_string(++part_number)] = {x0, bar_y - 10, x1, bar_y + 8 + more};
      bar_y += part_head + more;
    }
    if (const std::string numbers = in_full(part); !numbers.empty()) {
      const float top = bar_y - 10;
      lines(numbers, c.text);
      ui.rects["meaning in full"] = {x0, top, x1, bar_y - 10};
    }
    comparison_bar(ui, part, unit_of(units, step, part), x0, x1, bar_y);
    bar_y += bar_room;
  }
}

}  // namespace

float values_height(const Ui& ui, const Step& step, float width, float pitch) {
  const float values = step.values.empty() ? 0 : block_heading + pitch * static_cast<float>(step.values.size());
  return values + (step.comparison ? card_height(ui, *step.comparison, width - 20) + 8 : 0);
}

void values_block(Ui& ui, const Step& step, const Rect& r, float pitch, const Parted* parted) {
  ui.rects["values"] = r;
  ImGui::SetCursorScreenPos(top_left(r));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{0, 0});
  ImGui::BeginChild("values", {r.width(), r.height()}, false, 0);
  ImGui::PopStyleVar();
  const float top = ImGui::GetCursorScreenPos().y;
  float y = top;
  if (!step.values.empty()) {
    rule(ui, r.left + 10, r.right - 10, y + 5);
    text(ui.fonts.bold, r.left + 10, y + 22, packed(ui.palette.text), "Values");
    y += block_heading;
    const std::vector<UnitBars> units = units_of(step);
    unit_key(ui, units, r.left + 22 + text_width(ui.fonts.bold, "Values"), r.right - 10, y - block_heading + 22);
    const std::vector<std::string> digits = shown(step.values);
    const float indent = parted ? 10 : 0, number = number_column(ui, step, digits, {r.left + indent, y, r.right, y});
    for (std::size_t i = 0; i < digits.size(); ++i) {
      value_row(ui, step.values[i], digits[i], units, {r.left + indent, y, r.right, y + pitch}, number,
                room_for_new(step));
      if (parted && static_cast<int>(i) == parted->value)
        parted_mark(ui, "parted value", {r.left, y, r.right, y + pitch});
      y += pitch;
    }
  }
  if (step.comparison) {
    y += 8;
    const float card = card_height(ui, *step.comparison, r.width() - 20);
    comparison_card(ui, step, *step.comparison, {r.left + 10, y, r.right - 10, y + card - 10});
    y += card;
  }
  ImGui::SetCursorScreenPos({r.left, top});
  ImGui::Dummy({1, y - top});
  ImGui::EndChild();
}

void operations_block(Ui& ui, const Counters& n, const Rect& r) {
  const Palette& c = ui.palette;
  ui.rects["operations"] = r;
  struct Count {
    const char *name, *sign;
    int count;
  };
  const Count all[] = {
      {"mul", "×", n.mul}, {"add", "+", n.add}, {"div", "÷", n.div}, {"sqrt", "√", n.sqrt}, {"cmp", "<", n.compare}};
  std::vector<Count> counts;
  std::ranges::copy_if(
      all, std::back_inserter(counts), [](int count) { return count > 0; }, &Count::count);
  if (counts.empty()) return;
  rule(ui, r.left + 10, r.right - 10, r.top);
  if (r.height() > 50) text(ui.fonts.bold, r.left + 10, r.top + 16, packed(c.text), "Operations");
  const float y = r.bottom - 18;
  // In equal shares, or closer together if one is wider; where there is no room, in thousands, or with signs as names.
  const float room = r.width() - 20, share = room / 5, least_gap = 8;
  bool signs = false;
  std::vector<std::string> numbers;
  float widest = 0, sum = 0;
  const auto label_of = [&](const Count& count) { return signs ? count.sign : count.name; };
  for (const auto& [by_sign, thousands] :
       {std::pair{false, false}, std::pair{false, true}, std::pair{true, false}, std::pair{true, true}}) {
    signs = by_sign, widest = sum = 0;
    numbers.clear();
    for (const Count& one : counts) {
      numbers.push_back(thousands && one.count >= 10'000 ? fmt::format("{:.0f} k", one.count / 1e3)
                                                         : std::to_string(one.count));
      const float width = text_width(ui.fonts.body, label_of(one)) + 6 + text_width(ui.fonts.mono, numbers.back());
      widest = std::max(widest, width), sum += width;
    }
    if (sum + least_gap * static_cast<float>(counts.size() - 1) <= room) break;
  }
  const float gap = counts.size() > 1 ? std::min(16.0f, (room - sum) / static_cast<float>(counts.size() - 1)) : 0;
  float x = r.left + 10;
  std::string told = "Operations up to this step:";
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const Count& one = counts[i];
    const float width = text(ui.fonts.body, x, y, packed(c.muted), label_of(one));
    const float end = x + width + 6 + text(ui.fonts.mono, x + width + 6, y, packed(c.text), numbers[i]);
    ui.rects[std::string("count ") + one.name] = {x, y - 9, end, y + 9};
    x = widest + least_gap <= share ? x + share : end + gap;
    told += fmt::format(" {} {}{}", one.name, one.count, i + 1 < counts.size() ? "," : "");
  }
  if (ImGui::IsMouseHoveringRect(top_left(r), bottom_right(r))) tooltip(ui, told);
}

}  // namespace isect::viz
