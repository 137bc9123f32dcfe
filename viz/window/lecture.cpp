// The strip of a lecture, below the scene while the panels are hidden, to be read from afar. Its height is the window's
// affair: where the words are longer, they scroll.

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "viz/text/rich_text.h"
#include "viz/walk/alt_text.h"
#include "viz/walk/step_text.h"
#include "viz/window/column.h"
#include "viz/window/panels.h"

namespace isect::viz {
namespace {

constexpr float told_margin = 24, told_above = 12, told_gap = 28;
constexpr float told_scrollbar = 14;

/// Whether a name stands in a text by itself, and not as part of another one.
bool mentions(const std::string& words, const std::string& name) {
  const auto ends = [&](std::size_t at) {
    return at >= words.size() || std::string(" ()[]|,:;").find(words[at]) != std::string::npos;
  };
  for (std::size_t at = words.find(name); !name.empty() && at != std::string::npos; at = words.find(name, at + 1))
    if ((at == 0 || ends(at - 1)) && ends(at + name.size())) return true;
  return false;
}

/// Draws the current line, if there is one.
void told_line(Column& c, Player& player) {
  if (player.step().line < 0) return;
  const float height = current_line_height(player, c.ui, c.width);
  const Rect r{c.x, c.y, c.x + c.width, c.y + height};
  c.y = r.bottom + 10;
  current_line(player, c.ui, r);
}

/// Draws the formula on one line, smaller if that helps.
void told_formula(Column& c, const std::string& markup) {
  if (markup.empty()) return;
  constexpr double least = 17;
  Paragraph p{.markup = markup, .size = c.size, .line_pitch = c.pitch, .math = true, .colour = c.ui.palette.text};
  const float natural = c.ui.texts.size_of(p).x;
  if (natural > c.width) p.size = std::max(least, std::floor(p.size * c.width / natural));
  if (c.ui.texts.size_of(p).x > c.width) p.width = c.width;
  const float top = c.y;
  c.y += rich(c.ui, p, {c.x, c.y}).y;
  c.ui.rects["told formula"] = {c.x, top, c.x + c.width, c.y};
  c.y += 10;
}

/// Draws values beside each other, in as many rows as they take.
void told_values(Column& c, const std::vector<Value>& values) {
  constexpr float sides = 8, ends = 3, gap = 8;
  const std::vector<std::string> digits = shown(values);
  float x = c.x, bottom = c.y;
  for (std::size_t i = 0; i < values.size(); ++i) {
    Paragraph p{.markup = values[i].name + " = " + as_markup(digits[i]),
                .size = c.size,
                .line_pitch = c.pitch,
                .colour = c.ui.palette.text};
    if (c.ui.texts.size_of(p).x + 2 * sides > c.width) p.width = c.width - 2 * sides;
    const ImVec2 size = c.ui.texts.size_of(p);
    if (x > c.x && x + size.x + 2 * sides > c.x + c.width) x = c.x, c.y = bottom + gap;
    const Rect r{x, c.y, x + size.x + 2 * sides, c.y + size.y + 2 * ends};
    filled(r, c.ui.palette.card, 5);
    if (values[i].fresh) outlined(r, c.ui.palette.fresh, 1.5f, 5);
    rich(c.ui, p, {r.left + sides, r.top + ends});
    c.ui.rects["told value " + plain(values[i].name)] = r;
    x = r.right + gap, bottom = r.bottom;
  }
  if (!values.empty()) c.y = bottom + gap;
}

/// Returns what is known besides the numbers that a question is given, which are the last of all.
std::vector<Value> known_besides(const std::vector<Value>& known, const Question& asked) {
  const std::size_t given = std::min(asked.given.size(), known.size());
  return {known.begin(), known.end() - static_cast<std::ptrdiff_t>(given)};
}

/// Draws the numbers that the open question is given, large, and below them all else that is known.
void told_known(Column& c, const Player& player) {
  const std::vector<Value>& known = player.shown().values;
  if (known.empty()) return;
  const std::vector<Value> besides = known_besides(known, *player.quiz().asked());
  const float top = c.y;
  told_values(c, {known.begin() + static_cast<std::ptrdiff_t>(besides.size()), known.end()});
  if (!besides.empty()) c.paragraph(given_text(besides), c.ui.palette.text, body_size, 23);
  c.ui.rects["known values"] = {c.x, top, c.x + c.width, c.y};
}

/// Draws the line and the values of one of two panes.
void told_pane(Column& c, Player& player, const char* name) {
  c.paragraph(name, c.ui.palette.muted, body_size, 21);
  told_line(c, player);
  told_values(c, values_in_use(player.walk(), player.step()));
  c.y += 4;
}

/// Whether the right part has something to tell.
bool has_state(const Player& player, bool two) {
  if (player.quiz().asked()) return player.quiz().wants_line() || !player.shown().values.empty();
  const Step& step = player.step();
  return two || step.line >= 0 || !step.formula.empty() || !values_in_use(player.walk(), step).empty();
}

void told_state(Column& c, Player& player, const OnItsSide& other) {
  if (player.quiz().wants_line()) {
    const int line = lines_to_point_at(c, player.walk());
    if (line >= 0) player.answer_line(line);
  } else if (player.quiz().asked()) {
    told_known(c, player);
  } else if (other) {
    told_pane(c, player, "left");
    other([&](Player& second) { told_pane(c, second, "right"); });
  } else {
    told_line(c, player);
    told_formula(c, player.step().formula);
    told_values(c, values_in_use(player.walk(), player.step()));
  }
}

/// Draws a part of the strip, which scrolls by itself; from its beginning if that is `fresh`.
template <class Inside>
void told_part(Ui& ui, const char* name, const Rect& r, double size, bool fresh, Inside&& inside) {
  scrolling(ui, name, r, [&] {
    if (fresh) ImGui::SetScrollY(0);
    Column c{ui, r.left, ImGui::GetCursorScreenPos().y + told_above, r.width() - told_scrollbar, size, size + 8};
    inside(c);
    ImGui::SetCursorScreenPos({r.left, c.y});
    ImGui::Dummy({1, 8});
  });
  ui.rects[name] = r;
}

}  // namespace

std::vector<Value> values_in_use(const Walk& walk, const Step& step) {
  constexpr std::size_t most = 3;
  std::set<std::size_t> used;
  const auto take = [&](const auto& is_used) {
    for (std::size_t i = 0; i < step.values.size() && used.size() < most; ++i)
      if (is_used(step.values[i])) used.insert(i);
  };
  const auto take_named = [&](const std::string& words) {
    take([&](const Value& v) { return mentions(words, plain(v.name)); });
  };
  if (step.comparison) take_named(plain(step.comparison->text));
  take([](const Value& v) { return v.fresh; });
  if (step.line >= 0) take_named(walk.pseudocode[static_cast<std::size_t>(step.line)]);
  take_named(plain(step.formula));
  std::vector<Value> in_use;
  for (const std::size_t i : used) in_use.push_back(step.values[i]);
  return in_use;
}

void lecture(Player& player, Ui& ui, StepWords& step_words, const Rect& r, const OnItsSide& other) {
  begin_region(ui, "lecture", r);
  const double size = std::clamp(std::floor(r.height() / 14.0), 15.0, 21.0), large = std::max(20.0, size + 3);
  const bool fresh = std::exchange(step_words.seen, player.revision()) != player.revision();
  const float room = r.width() - 2 * told_margin, left = r.left + told_margin, right = r.right - told_margin;
  const float state = has_state(player, static_cast<bool>(other)) ? std::clamp(0.42f * room, 260.0f, 640.0f) : 0;
  const float words = std::min(room - (state > 0 ? state + told_gap : 0), 1100.0f);
  const bool asks = player.quiz().asked() != nullptr;
  told_part(ui, "told words", {left, r.top + 1, left + words, r.bottom - 1}, size, fresh, [&](Column& c) {
    hour_note(c, step_words.note);
    question_in_lecture(c, player, step_words.answer);
    if (!asks) c.paragraph(player.step().caption, ui.palette.text);
  });
  if (state > 0)
    told_part(ui, "told state", {right - state, r.top + 1, right, r.bottom - 1}, large, fresh,
              [&](Column& c) { told_state(c, player, other); });
  rule(ui, r.left, r.right, r.top);
  ImGui::End();
}

void dark_screen(WindowSession& s, const Rect& window) {
  if (!s.dark) return;
  begin_region(s.ui, "dark", window, Colour{0, 0, 0}, true);
  if (press(s.ui, "dark screen", window).clicked) s.dark = false;
  ImGui::End();
}

}  // namespace isect::viz
