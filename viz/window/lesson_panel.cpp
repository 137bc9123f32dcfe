#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "viz/chart/case_map.h"
#include "viz/compose/marks.h"
#include "viz/text/rich_text.h"
#include "viz/walk/closing.h"
#include "viz/window/column.h"
#include "viz/window/map_view.h"
#include "viz/window/objects_panel.h"
#include "viz/window/panels.h"
#include "viz/window/scene_names.h"

namespace isect::viz {
namespace {

constexpr float panel_margin = 20;

/// Draws the formula as large as it fits on one line; on several lines where it would be hard to read.
void formula_card(Column& c, const std::string& markup) {
  Ui& ui = c.ui;
  constexpr double largest = 24, least = 17;
  Paragraph p{.markup = markup, .size = largest, .line_pitch = 30, .math = true, .colour = ui.palette.text};
  const float room = c.width - 24, natural = ui.texts.size_of(p).x;
  if (natural > room) p.size = std::max(least, std::floor(p.size * room / natural));
  if (ui.texts.size_of(p).x > room) p.width = room, p.size = least - 1, p.line_pitch = 25;
  const ImVec2 size = ui.texts.size_of(p);
  const float height = std::max(60.0f, size.y + 24);
  filled({c.x, c.y, c.x + c.width, c.y + height}, ui.palette.card, 8);
  const float left = p.width > 0 ? c.x + 12 : c.x + (c.width - size.x) / 2;
  rich(ui, p, {left, c.y + (height - size.y) / 2});
  c.y += height;
}

/// Draws what each method says of this setting, and a button to keep a setting in which they differ.
void side_by_side(Column& c, const Player& player, Requests& requests) {
  const std::vector<Opinion>& said = player.played().opinions();
  const bool known = player.index() >= outcome(player.walk());  // before that they would give the answer away
  if (said.empty() || !known) return;
  Ui& ui = c.ui;
  c.y += 24;
  c.paragraph("Methods side by side", ui.palette.text, true);
  const float top = c.y;
  for (const Opinion& o : said) {
    const Colour& ink = o.agrees ? ui.palette.hit : ui.palette.miss;
    (o.agrees ? tick : cross)(c.x + 7, c.y + 11, 11, packed(ink));
    c.x += 22, c.width -= 22;
    c.paragraph(o.method + ": " + o.says, o.agrees ? ui.palette.muted : ui.palette.text);
    c.x -= 22, c.width += 22;
  }
  ui.rects["methods side by side"] = {c.x, top, c.x + c.width, c.y};
  if (!player.played().methods_differ()) return;
  c.y += 8;
  const Rect r{c.x, c.y, c.x + 180, c.y + Column::button_height};
  if (chip(ui, "save preset", r, "Save as preset", false)) requests.save_preset = true;
  c.y = r.bottom;
}

/// Draws what follows the closing card's result: where to go on first, what was read last. A button may leave the
/// lesson: then its card ends here.
void ending(Column& c, const LessonPanel& panel) {
  Player& player = panel.player;
  const auto on_show = [&, walk = player.walk_number(), step = player.index()] {
    return player.walk_number() == walk && player.index() == step;
  };
  if (!panel.in_hour) next_lesson_button(c, player, panel.toast);
  if (on_show())
    exercises(c, player, panel.words.solutions, panel.settings.scores[player.lesson().id].solved, panel.toast);
  if (on_show()) missed(c, player, panel.settings);
  if (on_show()) same_ideas(c, player, panel.toast);
  if (!on_show()) return;
  review_offer(c, player, panel.requests);
  reading(c, player, panel.words.reading);
}

/// `fresh`: these words were not there in the last frame.
void lesson_text(const LessonPanel& panel, const Rect& r, bool fresh, bool low) {
  Player& player = panel.player;
  const Step& step = player.step();
  const Palette& ink = panel.ui.palette;
  const float top = ImGui::GetCursorScreenPos().y;  // moves with the scroll
  Column c{panel.ui, r.left + panel_margin, top + (low ? 10.0f : 18.0f), r.width() - 2 * panel_margin};
  exercise_on_hand(c, player);
  hour_note(c, panel.words.note);
  if (player.quiz().asked()) {  // the scene is the next step's already: the words of this one would be taken for its
    c.y -= 24;
  } else {
    c.paragraph(step.title, ink.text, 19, 26, true);
    c.y += 8;
    c.paragraph(step.slug == closing_slug ? player.lesson().closing->result : step.caption, ink.text);
    if (!step.formula.empty()) {
      c.y += 16;
      formula_card(c, step.formula);
    }
    if (!step.source.empty() && step.slug != closing_slug) {  // there all sources stand at the end
      c.y += 8;
      c.paragraph(step.source, ink.muted, body_size, 21);
    }
    erratum(c, player, panel.words.before_fault, panel.toast);
  }
  question(c, player, panel.words.answer, fresh);
  way_back(c, player, panel.words.before_fault);
  if (panel.answers) scene_answers(c, player);
  if (step.slug == closing_slug)
    ending(c, panel);
  else
    side_by_side(c, player, panel.requests);
  ImGui::SetCursorScreenPos({r.left, c.y});
  ImGui::Dummy({1, 16});
}

/// A hint, "drag o or d", one for each role that has handles.
struct Hint {
  Role role;
  std::string markup;
  bool turns = false;  ///< the scene turns, not an object
};
constexpr std::size_t most_in_a_hint = 6;

std::vector<Hint> hints_of(const Player& player, bool map) {
  std::vector<Hint> hints;
  if (player.step().slug == case_map_slug || map) hints.push_back({Role::text, "drag over the map"});
  std::map<Role, std::vector<std::string>> by_role;
  for (const Handle& h : player.scene().handles) {
    if (by_role[h.role].size() > most_in_a_hint) continue;  // a scene may have thousands
    std::string label = h.parameter;
    for (const Parameter& p : player.lesson().parameters)
      if (p.name == h.parameter && !p.label.empty()) label = p.label;
    if (!h.one_of.empty()) label = h.one_of;
    std::vector<std::string>& labels = by_role[h.role];
    if (std::ranges::find(labels, label) == labels.end()) labels.push_back(label);
  }
  for (const auto& [role, labels] : by_role) {
    Hint hint = {role, "drag "};
    for (const std::string& label : labels) hint.markup += (&label == &labels.front() ? "" : " or ") + label;
    if (labels.size() > most_in_a_hint) hint.markup = "drag any of these handles";
    if (!draws_handles(player.scene())) hint.markup = "drag an object at its middle: a ring shows there";
    hints.push_back(hint);
  }
  const Scene& scene = player.scene();
  if (!player.lesson().flat && !scene.chart && !scene.items.empty())
    hints.push_back({Role::muted, hints.empty() ? "drag to turn" : "drag elsewhere to turn", true});
  return hints;
}

constexpr float hint_sign = 28, hint_gap = 20;

Paragraph words_of(const Ui& ui, const Hint& hint, float width) {
  return {.markup = hint.markup, .width = width, .line_pitch = 21, .colour = ui.palette.muted};
}

float hint_height(Ui& ui, const Hint& hint, float width) {
  return ui.texts.size_of(words_of(ui, hint, width - hint_sign)).y + 11;
}

float hints_height(Ui& ui, const std::vector<Hint>& hints, float width) {
  float height = 0;
  for (const Hint& hint : hints) height += hint_height(ui, hint, width);
  return height;
}

void hint_mark(const Ui& ui, const Hint& hint, float x, float y) {
  const Theme& theme = ui.palette.theme;
  if (hint.turns)
    turn_sign(x + 9, y, theme.ink(hint.role));
  else
    handle_sign(x + 9, y, theme.ink(hint.role), edge_ink(hint.role, theme));
}

/// Draws the hints below each other.
void draw_hints(Ui& ui, const std::vector<Hint>& hints, float x, float y, float width) {
  for (const Hint& hint : hints) {
    hint_mark(ui, hint, x, y + 16);
    rich(ui, words_of(ui, hint, width - hint_sign), {x + hint_sign, y + 5.5f});
    y += hint_height(ui, hint, width);
  }
}

/// Draws the hints beside each other, as many as there is room for, around the middle y.
void draw_hints_in_a_row(Ui& ui, const std::vector<Hint>& hints, float x, float right, float y) {
  for (const Hint& hint : hints) {
    const Paragraph words = words_of(ui, hint, 0);
    const float end = x + hint_sign + ui.texts.size_of(words).x;
    if (end > right) continue;
    hint_mark(ui, hint, x, y);
    rich_line(ui, words, x + hint_sign, y);
    x = end + hint_gap;
  }
}

/// `open`: whether the fields are shown, which it changes.
void parameters_header(Ui& ui, bool& open, const Rect& r) {
  const Press p = press(ui, "parameters", r);
  const Palette& ink = ui.palette;
  caret(r.left + 6, r.middle_y(), open, packed(p.hovered ? ink.text : ink.muted));
  text(ui.fonts.bold, r.left + 20, r.middle_y(), packed(ink.text), "Parameters");
  if (p.clicked) open = !open;
}

/// The parts of the panel: the words, and the header of the parameters with their fields or the hints below it, or,
/// where the panel is low, beside the words or in one row.
struct Parts {
  Rect words, header, fields;
  bool low = false;
};

Parts parts_of(const Rect& r, bool open, float fields, float hints) {
  constexpr float row = 34, words_share = 0.48f, header_width = 128;
  const float left = r.left + panel_margin, right = r.right - panel_margin;
  Parts p{{r.left, r.top, r.right - 1, r.bottom}, {}, {}, r.width() > 1.6f * r.height()};
  if (p.low && open) {
    p.words.right = std::round(r.left + words_share * r.width());
    p.header = {p.words.right + panel_margin, r.top + 6, right, r.top + 36};
    p.fields = {p.words.right, p.header.bottom + 4, r.right - 1, r.bottom - 4};
  } else if (p.low) {
    p.words.bottom = r.bottom - row;
    p.header = {left, p.words.bottom + 5, left + header_width, r.bottom - 5};
  } else {
    p.words.bottom = r.bottom - 44 - (open ? std::min(fields, r.height() * 0.5f) + 12 : hints > 0 ? hints + 12 : 0);
    p.header = {left, p.words.bottom + 8, right, p.words.bottom + 38};
    p.fields = {r.left, p.words.bottom + 42, r.right - 1, r.bottom - 4};
  }
  return p;
}

}  // namespace

void lesson_panel(const LessonPanel& panel, const Rect& r) {
  Player& player = panel.player;
  Ui& ui = panel.ui;
  begin_region(ui, "lesson panel", r);
  const bool open = panel.settings.parameters_open && !player.lesson().parameters.empty();
  const float width = r.width() - 2 * panel_margin;
  const std::vector<Hint> hints = hints_of(player, shows_map(player, panel.settings));
  Parts at = parts_of(r, open, panel.fields.height, r.height() > 420 ? hints_height(ui, hints, width) : 0);
  const bool bare = at.low && !open && player.quiz().asked();  // a question needs all the room
  if (bare) at.words.bottom = r.bottom;
  scrolling(ui, "words", at.words, [&] {
    const bool fresh = std::exchange(panel.words.seen, player.revision()) != player.revision();
    if (fresh) ImGui::SetScrollY(0);
    lesson_text(panel, at.words, fresh, at.low);
  });
  ui.rects["lesson words"] = at.words;

  if (!bare) parameters_header(ui, panel.settings.parameters_open, at.header);
  if (at.low && open)
    filled({at.words.right, r.top, at.words.right + 1, r.bottom}, ui.palette.rule, 0);
  else if (!bare)
    rule(ui, r.left + panel_margin, r.right - panel_margin, at.words.bottom);
  if (open) {
    scrolling(ui, "fields", at.fields, [&] {
      const float top = ImGui::GetCursorScreenPos().y;
      panel.fields.height =
          parameter_fields(player, ui, panel.fields, panel.toast, at.header.left, top, at.header.width()) - top;
    });
    ui.rects["lesson fields"] = at.fields;
  } else if (at.low && !bare) {
    draw_hints_in_a_row(ui, hints, at.header.right + hint_gap, r.right - panel_margin, at.header.middle_y());
  } else if (!at.low && r.height() > 420) {
    draw_hints(ui, hints, at.header.left, at.words.bottom + 44, width);
  }
  if (r.top > ui.rects["scene"].top) rule(ui, r.left, r.right, r.top);  // it lies below the scene
  filled({r.right - 1, r.top, r.right, r.bottom}, ui.palette.rule, 0);
  ImGui::End();
}

}  // namespace isect::viz
