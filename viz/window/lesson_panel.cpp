#include <algorithm>
#include <cmath>
#include <utility>

#include "viz/case_map.h"
#include "viz/closing.h"
#include "viz/rich_text.h"
#include "viz/window/column.h"
#include "viz/window/map_view.h"
#include "viz/window/panels.h"

namespace isect::viz {
namespace {

constexpr float margin = 20;

/// The formula as large as it fits on one line; on several lines where it would be hard to read.
void formula_card(Column& c, const std::string& markup) {
  Ui& ui = c.s.ui;
  constexpr double largest = 24, least = 17;
  Paragraph p{.markup = markup, .size = largest, .line_pitch = 30, .math = true, .colour = ui.palette.text};
  const float room = c.width - 24, natural = ui.texts.of(p).size.x;
  if (natural > room) p.size = std::max(least, std::floor(p.size * room / natural));
  if (ui.texts.of(p).size.x > room) p.width = room, p.size = least - 1, p.line_pitch = 25;
  const ImVec2 size = ui.texts.of(p).size;
  const float height = std::max(60.0f, size.y + 24);
  filled({c.x, c.y, c.x + c.width, c.y + height}, ui.palette.card, 8);
  const float left = p.width > 0 ? c.x + 12 : c.x + (c.width - size.x) / 2;
  rich(ui, p, {left, c.y + (height - size.y) / 2});
  c.y += height;
}

/// What each method says of this setting, and a button to keep one in which they differ.
void side_by_side(Column& c) {
  const std::vector<Opinion>& said = c.s.player.opinions();
  const bool known = c.s.player.index() >= outcome(c.s.player.walk());  // before that they would give the answer away
  if (said.empty() || !known) return;
  Ui& ui = c.s.ui;
  c.y += 24;
  c.paragraph("Methods side by side", ui.palette.text, 15, 23, true);
  const float top = c.y;
  for (const Opinion& o : said) {
    const Colour& ink = o.agrees ? ui.palette.hit : ui.palette.miss;
    (o.agrees ? tick : cross)(c.x + 7, c.y + 11, 11, packed(ink));
    c.x += 22, c.width -= 22;
    c.paragraph(o.method + ": " + o.says, o.agrees ? ui.palette.muted : ui.palette.text);
    c.x -= 22, c.width += 22;
  }
  ui.rects["methods side by side"] = {c.x, top, c.x + c.width, c.y};
  if (!c.s.player.methods_differ()) return;
  c.y += 8;
  if (chip(ui, "save preset", {c.x, c.y, c.x + 180, c.y + 34}, "Save as preset", false)) c.s.save_preset = true;
  c.y += 34;
}

/// `fresh`: these words were not yet there in the last frame.
void lesson_text(Session& s, const Rect& r, bool fresh) {
  const Step& step = s.player.step();
  const Palette& ink = s.ui.palette;
  const float top = ImGui::GetCursorScreenPos().y;  // moves with the scroll
  Column c{s, r.left + margin, top + 18, r.width() - 2 * margin};
  exercise_on_hand(c);
  c.paragraph(step.title, ink.text, 19, 26, true);
  c.y += 8;
  c.paragraph(step.caption, ink.text);
  if (!step.formula.empty()) {
    c.y += 16;
    formula_card(c, step.formula);
  }
  if (!step.source.empty() && step.slug != closing_slug) {  // there all sources are in the caption
    c.y += 8;
    c.paragraph(step.source, ink.muted, 13, 19);
  }
  erratum(c);
  question(c, fresh);
  if (step.slug == closing_slug)
    exercises(c);
  else
    side_by_side(c);
  ImGui::SetCursorScreenPos({r.left, c.y});
  ImGui::Dummy({1, 16});
}

/// "drag o or d", one line for each role that has handles.
struct Hint {
  Role role;
  std::string markup;
  bool turns = false;  ///< the scene, and no object
};
std::vector<Hint> hints_of(const Player& player, bool map) {
  std::vector<Hint> hints;
  if (player.step().slug == case_map_slug || map) hints.push_back({Role::text, "drag over the map"});
  for (const Handle& h : player.scene().handles) {
    std::string label = h.parameter;
    for (const Parameter& p : player.lesson().parameters)
      if (p.name == h.parameter && !p.label.empty()) label = p.label;
    if (!h.one_of.empty()) label = h.one_of;
    auto found = std::find_if(hints.begin(), hints.end(), [&](const Hint& hint) { return hint.role == h.role; });
    if (found == hints.end())
      hints.push_back({h.role, "drag " + label});
    else if (found->markup.find(label) == std::string::npos)
      found->markup += " or " + label;
  }
  const Scene& scene = player.scene();
  if (!player.lesson().flat && !scene.chart && !scene.items.empty())
    hints.push_back({Role::muted, hints.empty() ? "drag to turn" : "drag elsewhere to turn", true});
  return hints;
}

float hints_height(const std::vector<Hint>& hints) { return 32 * static_cast<float>(hints.size()); }

void draw_hints(Session& s, const std::vector<Hint>& hints, float x, float y, float width) {
  ImGui::PushClipRect({x, y}, {x + width, y + hints_height(hints)}, true);
  for (const Hint& hint : hints) {
    (hint.turns ? turn_sign : handle_sign)(x + 9, y + 16, s.ui.palette.theme.ink(hint.role));
    rich_line(s.ui, {.markup = hint.markup, .colour = s.ui.palette.muted}, x + 28, y + 16);
    y += 32;
  }
  ImGui::PopClipRect();
}

void parameters_header(Session& s, const Rect& r) {
  const Press p = press(s.ui, "parameters", r);
  const Palette& ink = s.ui.palette;
  caret(r.left + 6, r.middle_y(), s.settings.parameters_open, packed(p.hovered ? ink.text : ink.muted));
  text(s.ui.fonts.bold, r.left + 20, r.middle_y(), packed(ink.text), "Parameters");
  if (p.clicked) s.settings.parameters_open = !s.settings.parameters_open;
}

/// A part of the panel that scrolls by itself; `inside` draws it.
template <class Inside>
void scrolling(const char* name, const Rect& r, Inside&& inside) {
  ImGui::SetCursorScreenPos(top_left(r));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{0, 0});
  ImGui::BeginChild(name, {r.width(), r.height()}, false, 0);
  ImGui::PopStyleVar();
  inside();
  ImGui::EndChild();
}

}  // namespace

void lesson_panel(Session& s, const Rect& r) {
  begin_region(s.ui, "lesson panel", r, s.ui.palette.window);
  const float x = r.left + margin, width = r.width() - 2 * margin;
  const bool open = s.settings.parameters_open && !s.player.lesson().parameters.empty();
  const std::vector<Hint> hints = hints_of(s.player, shows_map(s));
  const bool hinting = !open && r.height() > 420;

  const float below = 44 + (open      ? std::min(s.fields_height, r.height() * 0.5f) + 12
                            : hinting ? hints_height(hints) + 12
                                      : 0);
  const Rect words{r.left, r.top, r.right - 1, r.bottom - below};
  scrolling("words", words, [&] {
    const bool fresh = std::exchange(s.words_seen, s.player.revision()) != s.player.revision();
    if (fresh) ImGui::SetScrollY(0);
    lesson_text(s, words, fresh);
  });
  s.ui.rects["lesson words"] = words;

  rule(s.ui, x, r.right - margin, words.bottom);
  parameters_header(s, {x, words.bottom + 8, r.right - margin, words.bottom + 38});
  if (open) {
    const Rect area{r.left, words.bottom + 42, r.right - 1, r.bottom - 4};
    scrolling("fields", area, [&] {
      const float top = ImGui::GetCursorScreenPos().y;
      s.fields_height = parameter_fields(s, x, top, width) - top;
    });
    s.ui.rects["lesson fields"] = area;
  } else if (hinting) {
    draw_hints(s, hints, x, words.bottom + 44, width);
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({r.right - 1, r.top}, {r.right, r.bottom}, packed(s.ui.palette.rule));
  ImGui::End();
}

}  // namespace isect::viz
