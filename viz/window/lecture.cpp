// The strip of a lecture, below the scene while the panels are hidden, to be read from afar. Its height is the window's
// affair. Where the words are longer than their column, they go on below the line and the values; where that is not
// enough they are set smaller; and what does not fit even so is scrolled to, by the key that goes on, too.

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>
#include <variant>

#include "viz/text/rich_text.h"
#include "viz/walk/alt_text.h"
#include "viz/walk/closing.h"
#include "viz/window/column.h"
#include "viz/window/panels.h"

namespace isect::viz {
namespace {

constexpr float told_margin = 24, told_above = 12, told_gap = 28;
constexpr float told_scrollbar = 14, told_below = 8;
constexpr float told_unseen = 4;  ///< px below the strip's end that hold no words

/// Draws the current line, if there is one.
void told_line(Column& c, Player& player) {
  if (player.step().line < 0) return;
  const float height = current_line_height(player, c.ui, c.width);
  const Rect r{c.x, c.y, c.x + c.width, c.y + height};
  c.y = r.bottom + 10;
  if (c.draws) current_line(player, c.ui, r);
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
  c.y += (c.draws ? rich(c.ui, p, {c.x, c.y}) : c.ui.texts.size_of(p)).y;
  if (c.draws) c.ui.rects["told formula"] = {c.x, top, c.x + c.width, c.y};
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
    if (c.draws) {
      filled(r, c.ui.palette.card, 5);
      if (values[i].fresh) outlined(r, c.ui.palette.fresh, 1.5f, 5);
      rich(c.ui, p, {r.left + sides, r.top + ends});
      c.ui.rects["told value " + plain(values[i].name)] = r;
    }
    x = r.right + gap, bottom = r.bottom;
  }
  if (!values.empty()) c.y = bottom + gap;
}

/// Draws the numbers that the open question is given, and after them all else that is known.
void told_known(Column& c, const Player& player) {
  std::vector<Value> known = player.shown().values;
  if (known.empty()) return;
  const std::size_t given = std::min(player.quiz().asked()->given.size(), known.size());
  std::ranges::rotate(known, known.end() - static_cast<std::ptrdiff_t>(given));  // they are the last of all
  const float top = c.y;
  told_values(c, known);
  if (c.draws) c.ui.rects["known values"] = {c.x, top, c.x + c.width, c.y};
}

/// Returns the knobs that are numbers and have a name of mathematics, not words.
std::vector<Value> knobs_of(const Player& player) {
  std::vector<Value> knobs;
  for (const Parameter& p : player.lesson().parameters) {
    const auto set = player.parameters().find(p.name);
    if (set == player.parameters().end() || p.label.find(' ') != std::string::npos) continue;
    if (const double* number = std::get_if<double>(&set->second)) knobs.push_back({.name = p.label, .value = *number});
  }
  return knobs;
}

std::vector<Value> values_now(const Player& player) {
  return values_in_use(player.walk(), player.step(), knobs_of(player));
}

/// Draws the line and the values of one of two panes.
void told_pane(Column& c, Player& player, const char* name) {
  c.paragraph(name, c.ui.palette.muted, body_size, 21);
  told_line(c, player);
  told_values(c, values_now(player));
  c.y += 4;
}

/// Whether the card fills the scene: it tells the result, and no line is run any more.
bool shows_card(const Player& player) { return player.step().slug == closing_slug; }

/// Whether the right part has something to tell.
bool has_state(const Player& player, bool two) {
  if (player.quiz().asked()) return player.quiz().wants_line() || !player.shown().values.empty();
  if (shows_card(player)) return false;
  const Step& step = player.step();
  return two || step.line >= 0 || !step.formula.empty() || !values_now(player).empty();
}

void told_state(Column& c, Player& player, const OnItsSide& other) {
  if (!player.quiz().asked() && shows_card(player)) return;
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
    told_values(c, values_now(player));
  }
}

/// Returns the paragraphs that the step itself tells: none while a question is open, and of the closing card only what
/// the card leaves out, if there is something.
std::vector<std::string> own_paragraphs(const Player& player) {
  std::vector<std::string> paragraphs;
  if (player.quiz().asked()) return paragraphs;
  std::istringstream caption(player.step().caption);
  for (std::string one; std::getline(caption, one);) paragraphs.push_back(one);
  if (shows_card(player) && paragraphs.size() > 1) paragraphs.erase(paragraphs.begin());
  return paragraphs;
}

/// Returns paragraphs as one text.
std::string joined(const std::vector<std::string>& paragraphs, std::size_t from, std::size_t to) {
  std::string all;
  for (std::size_t i = from; i < to; ++i) all += (i > from ? "\n" : "") + paragraphs[i];
  return all;
}

/// The widths of the strip's two columns, and where the second one's words may begin, px below the strip's top.
struct Columns {
  float words = 0, state = 0, whole = 0;  ///< whole: of one column alone; 0: there are two in any case
  float state_end = 0;
};

/// How the words are set: in this size, from the first column on into the second one.
struct SetWords {
  double size = 0;
  bool one_column = false;
  std::string first, second;
};

/// A column of the strip for words of this size.
Column words_column(Ui& ui, float x, float y, float width, double size) {
  return {ui, x, y, width - told_scrollbar, size, size + 8};
}

/// Draws all that stands before the step's own words.
void told_before(Column& c, Player& player, StepWords& words) {
  hour_note(c, words.note);
  question_in_lecture(c, player, words.answer);
}

/// Returns how the words fit into a strip of this height, as large as possible, if they do.
std::optional<SetWords> fitting(Player& player, Ui& ui, StepWords& words, const Columns& columns, float height,
                                double size) {
  const std::vector<std::string> own = own_paragraphs(player);
  const Colour& ink = ui.palette.text;
  const float room = height - told_below;
  const auto before = [&](float width, double px) {
    Column c = words_column(ui, 0, told_above, width, px);
    c.draws = false;
    told_before(c, player, words);
    return c;
  };
  for (double px = size; px >= body_size; --px) {
    if (columns.whole > 0) {
      Column c = before(columns.whole, px);
      c.paragraph(joined(own, 0, own.size()), ink);
      if (c.y <= room) return SetWords{px, true, joined(own, 0, own.size()), {}};
    }
    const Column above = before(columns.words, px);
    if (above.y > room) continue;
    for (std::size_t kept = own.size() + 1; kept-- > 0;) {
      Column first = above, second = words_column(ui, 0, columns.state_end, columns.state, px);
      second.draws = false;
      first.paragraph(joined(own, 0, kept), ink);
      if (first.y > room) continue;
      second.paragraph(joined(own, kept, own.size()), ink);
      if (kept == own.size() || second.y <= room)
        return SetWords{px, false, joined(own, 0, kept), joined(own, kept, own.size())};
      break;  // fewer in the first column are more in the second one
    }
  }
  return {};
}

/// Draws a part of the strip, which scrolls by itself; from its beginning if that is `fresh`, and a page further if the
/// rest is wanted.
template <class Inside>
void told_part(Ui& ui, StepWords& words, const char* name, const Rect& r, double size, bool fresh, Inside&& inside) {
  scrolling(ui, name, r, [&] {
    const float begin = ImGui::GetCursorScreenPos().y;  // moves with the scroll
    float scroll = fresh ? 0 : ImGui::GetScrollY();
    Column c = words_column(ui, r.left, begin + told_above, r.width(), size);
    inside(c);
    const float beyond = c.y + told_below - begin - r.height();
    if (words.turn && scroll < beyond) scroll = std::min(beyond, scroll + r.height() - 2 * static_cast<float>(c.pitch));
    if (fresh || words.turn) ImGui::SetScrollY(scroll);
    words.beyond = std::max(words.beyond, beyond - scroll);
    ImGui::SetCursorScreenPos({r.left, c.y});
    ImGui::Dummy({1, told_below});
  });
  ui.rects[name] = r;
}

}  // namespace

void lecture(Player& player, Ui& ui, StepWords& step_words, const Rect& r, const OnItsSide& other) {
  begin_region(ui, "lecture", r);
  const double large = ui.fonts.large;
  const double size = std::min(lecture_sizes(r.height()).words, large > large_size ? large - 3 : large);
  const bool fresh = std::exchange(step_words.seen, player.revision()) != player.revision();
  const float room = r.width() - 2 * told_margin, left = r.left + told_margin, right = r.right - told_margin;
  const float top = r.top + 1, bottom = r.bottom - 1, height = bottom - top;
  const bool asks = player.quiz().asked() != nullptr, has = has_state(player, static_cast<bool>(other));
  Columns columns;
  columns.state = std::clamp(0.42f * room, 260.0f, 32 * static_cast<float>(large));
  const float longest = std::max(1100.0f, 46 * static_cast<float>(size));  // a line that is still easy to read
  columns.words = std::min(room - columns.state - told_gap, longest);
  columns.whole = has ? 0 : std::min(room, longest);
  columns.state_end = told_above;
  if (has && (asks || other)) {
    columns.state_end = height;  // lines to point at, or of two panes: they need all the room there is
  } else if (has) {
    Column c = words_column(ui, 0, told_above, columns.state, large);
    c.draws = false;
    told_state(c, player, other);
    columns.state_end = c.y;
  }
  std::optional<SetWords> set;
  if (!player.quiz().asks_more()) set = fitting(player, ui, step_words, columns, height, size);
  if (!set) {
    const std::vector<std::string> own = own_paragraphs(player);
    set = SetWords{size, !has, joined(own, 0, own.size()), {}};
  }
  step_words.beyond = 0;
  const float words = set->one_column ? columns.whole : columns.words;
  told_part(ui, step_words, "told words", {left, top, left + words, bottom}, set->size, fresh, [&](Column& c) {
    told_before(c, player, step_words);
    c.paragraph(set->first, ui.palette.text);
  });
  if (has || !set->second.empty())
    told_part(ui, step_words, "told state", {right - columns.state, top, right, bottom}, large, fresh, [&](Column& c) {
      told_state(c, player, other);
      if (set->second.empty()) return;
      const float begin = c.y;
      c.size = set->size, c.pitch = set->size + 8;
      c.paragraph(set->second, ui.palette.text);
      ui.rects["told on"] = {c.x, begin, c.x + c.width, c.y};
    });
  step_words.turn = false;
  rule(ui, r.left, r.right, r.top);
  ImGui::End();
}

bool shows_rest(WindowSession& s) {
  const bool now = !s.panels && !s.review && !shows_fault(s) && s.step_words.seen == s.player.revision();
  if (!now || !(s.step_words.beyond > told_unseen)) return false;
  s.step_words.beyond = 0;
  return s.step_words.turn = true;
}

void dark_screen(WindowSession& s, const Rect& window) {
  if (!s.dark) return;
  begin_region(s.ui, "dark", window, Colour{0, 0, 0}, true);
  if (press(s.ui, "dark screen", window).clicked) s.dark = false;
  if (!ImGui::IsMousePosValid() && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) s.dark = false;  // it rests, hidden
  ImGui::End();
}

}  // namespace isect::viz
