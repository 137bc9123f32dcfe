// The rows of the list of a scene's objects.

#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "viz/text/names.h"
#include "viz/window/object_changes.h"
#include "viz/window/objects_panel.h"

namespace isect::viz {
namespace {

constexpr float object_row = 28, switch_room = 46;

/// Draws the field in which a name is typed. Escape leaves the name as it was.
void name_field(WindowSession& s, const Rect& r, Afterwards& then) {
  ObjectsPanel::Renaming& typing = s.objects.renaming;
  ImGui::SetCursorScreenPos(top_left(r));
  ImGui::SetNextItemWidth(r.width());
  // Dear ImGui focuses it in one of the next frames, as it does a field of the parameters.
  if (!typing.begun && typing.frames++ % 4 == 0) {
    ImGui::SetWindowFocus();
    ImGui::SetKeyboardFocusHere();
  }
  const bool entered = ImGui::InputText("##name of object", &typing.text,
                                        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  const bool left = left_by_tab(s.ui, "object " + typing.object) || (typing.begun && !ImGui::IsItemActive());
  if (ImGui::IsItemActive()) typing.begun = true;
  s.ui.rects["name field"] = r;
  focused(s.ui, "object " + typing.object, r);
  if (!entered && !left) return;
  const ObjectsPanel::Renaming ended = std::exchange(typing, {});
  if (ended.text == ended.object) return;
  then.emplace_back([&s, ended] { rename_object(s, ended.object, ended.text); });
}

/// Draws a switch, on or off.
bool toggle(Ui& ui, const std::string& name, const Rect& r, bool on) {
  const Press p = press(ui, name, r);
  const Palette& c = ui.palette;
  const Rect pill{r.middle_x() - 15, r.middle_y() - 8, r.middle_x() + 15, r.middle_y() + 8};
  filled(pill, on ? c.first : p.hovered ? c.hovered : c.frame, 8);
  outlined(pill, on ? c.first : c.muted, 1.2f, 8);
  ImGui::GetWindowDrawList()->AddCircleFilled({on ? pill.right - 8 : pill.left + 8, r.middle_y()}, 5,
                                              packed(on ? c.on_first : c.muted), 16);
  if (p.hovered)
    tooltip(ui, on ? "Shown. A click hides it in the picture, not in the answers" : "Hidden in the picture");
  return p.clicked;
}

void row_of_object(WindowSession& s, const SceneObject& o, const Rect& r, Afterwards& then) {
  Ui& ui = s.ui;
  const Palette& c = ui.palette;
  const Rect body{r.left, r.top + 1, r.right - switch_room, r.bottom - 1}, at_end{body.right, r.top, r.right, r.bottom};
  if (s.objects.renaming.object == o.name) {
    name_field(s, body, then);
  } else {
    const std::string name = "object " + o.name;
    const Press p = press(ui, name, body);
    const bool chosen = std::ranges::find(s.objects.chosen, o.name) != s.objects.chosen.end();
    if (chosen || p.hovered) filled(body, chosen ? c.first : c.hovered, 5);
    const std::vector<std::string> lit =
        p.hovered || ui.focus.name() == name ? keys(names_in(o.shown)) : std::vector<std::string>();
    if (p.hovered) ui.light.point(lit, body, false);
    if (ui.focus.name() == name) ui.light.hold(lit, body);
    const Colour& ink = chosen ? c.on_first : o.hidden ? c.muted : c.text;
    const float end = body.left + 10 + text(ui.fonts.body, body.left + 10, r.middle_y(), packed(ink), o.name);
    text(ui.fonts.small, body.right - 10, r.middle_y(), packed(chosen ? c.on_first : c.muted),
         fitted(ui.fonts.small, o.type, body.right - 24 - end), 1);
    if (p.hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
      then.emplace_back([&s, which = o.name] { begin_renaming(s.objects, which); });
    else if (p.clicked)
      then.emplace_back([&s, which = o.name] { choose_object(s.objects, which); });
  }
  if (toggle(ui, "switch " + o.name, at_end, !o.hidden))
    then.emplace_back([&s, which = o.name, kind = o.hidden ? SceneEdit::Kind::show : SceneEdit::Kind::hide] {
      change_scene(s, {.kind = kind, .what = which});
    });
}

}  // namespace

void object_list(WindowSession& s, const Rect& r, Afterwards& then) {
  ObjectsPanel& panel = s.objects;
  s.ui.rects["objects"] = r;
  scrolling(s.ui, "objects", r, [&] {
    const float top = ImGui::GetCursorScreenPos().y;
    const int count = static_cast<int>(panel.found.size());
    const float all = object_row * static_cast<float>(count), right = r.right - (all > r.height() ? 14.0f : 0.0f);
    const auto named = [&](std::size_t i) { return panel.objects[i].name; };
    if (const auto at = std::ranges::find(panel.found, panel.to_see, named); at != panel.found.end())
      ImGui::SetScrollY(std::max(0.0f, object_row * static_cast<float>(at - panel.found.begin()) - r.height() / 2));
    panel.to_see.clear();
    const int first = std::max(0, static_cast<int>(std::floor((r.top - top) / object_row)) - 1);
    const int last = std::min(count, first + static_cast<int>(std::ceil(r.height() / object_row)) + 3);
    for (int i = first; i < last; ++i) {
      const float y = top + object_row * static_cast<float>(i);
      row_of_object(s, panel.objects[panel.found[static_cast<std::size_t>(i)]], {r.left, y, right, y + object_row},
                    then);
    }
    if (count == 0)
      text(s.ui.fonts.body, r.left + 10, r.top + 16, packed(s.ui.palette.muted), "No name or type has these words");
    ImGui::SetCursorScreenPos({r.left, top});
    ImGui::Dummy({1, all});
  });
}

}  // namespace isect::viz
