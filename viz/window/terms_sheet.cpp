// The terms of the course: each leads to the lesson that explains it.

#include "viz/text/rich_text.h"
#include "viz/window/sheets.h"

namespace isect::viz {

void terms_sheet(Player& player, Ui& ui, std::string& searched, const Course& course, Toast& toast,
                 const Rect& window) {
  if (!begin_sheet(ui, "terms", window, 720, 600)) return;
  const bool entered = search_field(ui, searched, "Search terms");
  ImGui::BeginChild("list of terms");
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x - 4;
  float y = at.y + 6;
  const Palette& c = ui.palette;
  const Course::Term *first = nullptr, *chosen = nullptr;
  for (const Course::Term& term : course.terms) {
    if (!matches(term.name + " " + plain(term.meaning), searched)) continue;
    if (!first) first = &term;
    const Paragraph meaning{.markup = term.meaning, .width = width - 16, .colour = c.text};
    const Rect r{at.x, y, at.x + width, y + 34 + ui.texts.size_of(meaning).y};
    const Press p = press(ui, "term " + term.name, r);
    if (p.hovered) filled(r, c.card, 5);
    text(ui.fonts.bold, r.left + 8, y + 16, packed(c.text), term.name);
    for (const Lesson* l : player.lessons())
      if (l->id == term.lesson) text(ui.fonts.body, r.right - 8, y + 16, packed(c.muted), plain(l->title), 1);
    rich(ui, meaning, {r.left + 8, y + 28});
    if (p.clicked) chosen = &term;
    y = r.bottom + 2;
  }
  if (!first) text(ui.fonts.body, at.x + 8, y + 16, packed(c.muted), "No term has these words");
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy({1, y - at.y});
  ImGui::EndChild();
  if (entered && !chosen && ui.focus.name().empty()) chosen = first;
  if (chosen) {
    attempt(toast, [&] { player.open(lesson_named(player.lessons(), chosen->lesson)); });
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace isect::viz
