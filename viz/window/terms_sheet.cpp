// The terms of the course: each leads to the lesson that explains it.

#include "viz/text/rich_text.h"
#include "viz/window/sheets.h"

namespace isect::viz {

void terms_sheet(WindowSession& s, const Rect& window) {
  if (!begin_sheet(s.ui, "terms", window, 720, 600)) return;
  const bool entered = search_field(s.ui, s.search, "Search terms");
  ImGui::BeginChild("list of terms");
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x - 4;
  float y = at.y + 6;
  const Palette& c = s.ui.palette;
  const Course::Term *first = nullptr, *chosen = nullptr;
  for (const Course::Term& term : s.course.terms) {
    if (!matches(term.name + " " + plain(term.meaning), s.search)) continue;
    if (!first) first = &term;
    const Paragraph meaning{.markup = term.meaning, .width = width - 16, .colour = c.text};
    const Rect r{at.x, y, at.x + width, y + 34 + s.ui.texts.size_of(meaning).y};
    const Press p = press(s.ui, "term " + term.name, r);
    if (p.hovered) filled(r, c.card, 5);
    text(s.ui.fonts.bold, r.left + 8, y + 16, packed(c.text), term.name);
    for (const Lesson* l : s.player.lessons())
      if (l->id == term.lesson) text(s.ui.fonts.small, r.right - 8, y + 16, packed(c.muted), plain(l->title), 1);
    rich(s.ui, meaning, {r.left + 8, y + 28});
    if (p.clicked) chosen = &term;
    y = r.bottom + 2;
  }
  if (!first) text(s.ui.fonts.body, at.x + 8, y + 16, packed(c.muted), "No term has these words");
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy({1, y - at.y});
  ImGui::EndChild();
  if (entered && !chosen && s.ui.focus.name().empty()) chosen = first;
  if (chosen) {
    s.attempt([&] { s.player.open(lesson_named(s.player.lessons(), chosen->lesson)); });
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace isect::viz
