#include "viz/window/objects_panel.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <string>
#include <vector>

#include "viz/text/rich_text.h"
#include "viz/window/key_codes.h"
#include "viz/window/object_changes.h"
#include "viz/window/panels.h"

namespace isect::viz {
namespace {

constexpr float objects_margin = 20, question_row = 36, asked_head = 28, asked_row = 28;

/// Draws the field that filters a long list.
void object_search(WindowSession& s, const Rect& r) {
  ImGui::SetCursorScreenPos(top_left(r));
  ImGui::SetNextItemWidth(r.width());
  s.ui.rects["find objects"] = r;
  const bool held = focused(s.ui, "find objects", r);
  if (held && s.ui.focus.pressed()) ImGui::SetKeyboardFocusHere();
  ImGui::InputTextWithHint("##find objects", "Find by name or type", &s.objects.search);
  left_by_tab(s.ui, "find objects");
}

/// Draws the palette: all types of objects, below the button that opens it.
void type_menu(WindowSession& s, const Rect& button, Afterwards& then) {
  constexpr float wide = 150, high = 30, gap = 4;
  ImGui::SetNextWindowPos({button.right - 2 * wide - gap - 12, button.bottom + 2});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{6, 6});
  if (ImGui::BeginPopup("new object")) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    int i = 0;
    for (const SceneType& type : s.scene_editor.types(s.player.lesson())) {
      const float x = at.x + (wide + gap) * static_cast<float>(i % 2),
                  y = at.y + (high + gap) * static_cast<float>(i / 2);
      ++i;
      if (!chip(s.ui, "add " + type.id, {x, y, x + wide, y + high}, type.words, false)) continue;
      then.emplace_back([&s, id = type.id] { add_object_of(s, id); });
      ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

std::string words_on_chosen(const std::vector<std::string>& chosen) {
  if (chosen.empty()) return "Click an object, or two, to ask about them. F2 renames, Delete removes";
  return chosen.size() == 1 ? "About " + chosen[0] + "; click another to ask about both"
                            : "About " + chosen[0] + " and " + chosen[1];
}

float height_below_list(const ObjectsPanel& panel) {
  const float buttons = panel.chosen.size() == 1 ? question_row : 0;
  const float asked = panel.asked.empty() ? 0 : asked_head + asked_row * static_cast<float>(panel.asked.size());
  return 62 + buttons + question_row * static_cast<float>(panel.questions.size()) + asked;
}

/// Draws the questions that are asked about the chosen objects from y down, each with a cross that removes it; returns
/// where they end. There may be hundreds: those out of view are not drawn.
float asked_list(WindowSession& s, float left, float right, float y, Afterwards& then) {
  Ui& ui = s.ui;
  if (s.objects.asked.empty()) return y;
  text(ui.fonts.body, left, y + asked_head / 2, packed(ui.palette.muted), "Asked already");
  y += asked_head;
  const float top = ImGui::GetWindowPos().y, bottom = top + ImGui::GetWindowHeight();
  int number = 0;
  for (const SceneQuestion& question : s.objects.asked) {
    const Rect row{left, y, right, y + asked_row};
    ++number, y += asked_row;
    if (row.bottom < top - asked_row || row.top > bottom + asked_row) continue;
    const Rect button{right - 30, row.top + 1, right, row.bottom - 1};
    const std::string words = fitted(ui.fonts.body, question.words, button.left - left - 6);
    text(ui.fonts.body, left, row.middle_y(), packed(ui.palette.text), words);
    const Press p = press(ui, "unask " + std::to_string(number), button);
    if (p.hovered) filled(button, ui.palette.hovered);
    cross(button.middle_x(), button.middle_y(), 11, packed(ui.palette.text));
    if (p.hovered) tooltip(ui, "Ask no longer: " + question.words);
    if (p.clicked) then.emplace_back([&s, question] { remove_question(s, question); });
  }
  return y;
}

/// Draws what can be done with the objects that are chosen.
void below_list(WindowSession& s, const Rect& r, Afterwards& then) {
  Ui& ui = s.ui;
  const ObjectsPanel& panel = s.objects;
  rule(ui, r.left, r.right, r.top);
  s.ui.rects["object questions"] = r;
  scrolling(ui, "object questions", {r.left, r.top + 1, r.right, r.bottom}, [&] {
    const float top = ImGui::GetCursorScreenPos().y;
    const Paragraph words{.markup = as_markup(words_on_chosen(panel.chosen)),
                          .width = r.width() - 14,
                          .line_pitch = 21,
                          .colour = ui.palette.muted};
    float y = top + 8 + rich(ui, words, {r.left, top + 8}).y + 6;
    if (panel.chosen.size() == 1) {
      const std::string name = panel.chosen[0];
      if (chip(ui, "rename object", {r.left, y, r.left + 90, y + 30}, "Rename", false))
        then.emplace_back([&s, name] { begin_renaming(s.objects, name); });
      if (chip(ui, "remove object", {r.left + 98, y, r.left + 188, y + 30}, "Remove", false))
        then.emplace_back([&s, name] { remove_object(s, name); });
      y += question_row;
    }
    int number = 0;
    for (const SceneQuestion& question : panel.questions) {
      const Rect row{r.left, y, r.right - 14, y + 30};
      const std::string label = fitted(ui.fonts.body, question.words, row.width() - 20);
      if (chip(ui, "ask " + std::to_string(++number), row, label, false))
        then.emplace_back([&s, id = question.id] { ask_about_chosen(s, id); });
      if (label != question.words && ImGui::IsItemHovered()) tooltip(ui, question.words);
      y += question_row;
    }
    y = asked_list(s, r.left, r.right - 14, y, then);
    ImGui::SetCursorScreenPos({r.left, top});
    ImGui::Dummy({1, y - top});
  });
}

/// Returns the object whose row the keyboard holds, else the only one that is chosen.
std::string object_at_hand(const WindowSession& s) {
  for (const char* part : {"object ", "switch "})
    if (const std::string& held = s.ui.focus.name(); held.starts_with(part))
      return held.substr(std::string(part).size());
  return s.objects.chosen.size() == 1 ? s.objects.chosen[0] : std::string();
}

void object_keys(WindowSession& s, Afterwards& then) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.WantTextInput || io.KeyCtrl || ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup)) return;
  const std::string name = object_at_hand(s);
  if (const std::string part = "handle ", held = s.ui.focus.name(); held.starts_with(part)) {
    const std::string corner = held.substr(part.size());
    if (ImGui::IsKeyPressed(key::insert, false)) then.emplace_back([&s, corner] { add_corner_behind(s, corner); });
    if (ImGui::IsKeyPressed(key::del, false))
      then.emplace_back([&s, corner, name] {
        if (!remove_corner(s, corner) && !name.empty()) remove_object(s, name);
      });
    return;
  }
  if (std::ranges::find(s.objects.objects, name, &SceneObject::name) == s.objects.objects.end()) return;
  if (ImGui::IsKeyPressed(key::f2, false)) then.emplace_back([&s, name] { begin_renaming(s.objects, name); });
  if (ImGui::IsKeyPressed(key::del, false)) then.emplace_back([&s, name] { remove_object(s, name); });
}

}  // namespace

bool lists_objects(WindowSession& s) {
  list_anew(s);
  return !s.objects.objects.empty() && s.player.step().line < 0 && !s.player.quiz().asked();
}

void objects_panel(WindowSession& s, const Rect& r) {
  Ui& ui = s.ui;
  const ObjectsPanel& panel = s.objects;
  const Rect inner{r.left + objects_margin, r.top, r.right - objects_margin, r.bottom};
  Afterwards then;
  begin_region(ui, "objects panel", r);
  filled({r.left, r.top, r.left + 1, r.bottom}, ui.palette.rule, 0);
  const float heading = r.top + 32;
  const float end = inner.left + text(ui.fonts.bold, inner.left, heading, packed(ui.palette.text), "Objects");
  text(ui.fonts.body, end + 10, heading, packed(ui.palette.muted), std::to_string(panel.objects.size()));
  const Rect button{inner.right - 84, heading - 15, inner.right, heading + 15};
  if (chip(ui, "add object", button, "Add", false)) ImGui::OpenPopup("new object");
  type_menu(s, button, then);
  float top = heading + 24;
  if (panel.objects.size() > few_objects) {
    object_search(s, {inner.left, top, inner.right, top + 28});
    top += 36;
  }
  const float below = std::min(height_below_list(panel), 0.5f * r.height());
  object_list(s, {inner.left, top, inner.right, r.bottom - below - 8}, then);
  below_list(s, {inner.left, r.bottom - below, inner.right, r.bottom - 4}, then);
  object_keys(s, then);
  ImGui::End();
  for (const auto& action : then) action();
}

}  // namespace isect::viz
