#include "viz/window/objects_panel.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "viz/text/names.h"
#include "viz/text/rich_text.h"
#include "viz/window/key_codes.h"
#include "viz/window/panels.h"
#include "viz/window/sheets.h"

namespace isect::viz {
namespace {

constexpr float object_row = 28, objects_margin = 20, question_row = 36, switch_room = 46;
constexpr std::size_t few_objects = 12;  ///< they need no search

/// What rows and buttons ask for: it is done after all are drawn, as it changes them.
using Afterwards = std::vector<std::function<void()>>;

void list_anew(WindowSession& s) {
  ObjectsPanel& panel = s.objects;
  const Lesson& lesson = s.player.lesson();
  const bool other = panel.of != &lesson;
  if (other) {
    panel.of = &lesson;
    const bool scene = s.scene_editor.objects && !lesson.made_from.empty();
    panel.objects = scene ? s.scene_editor.objects(lesson) : std::vector<SceneObject>();
    const auto gone = [&](const std::string& name) {
      return std::ranges::find(panel.objects, name, &SceneObject::name) == panel.objects.end();
    };
    std::erase_if(panel.chosen, gone);
    panel.asked_about.clear(), panel.questions.clear();
    panel.renaming = {};
  }
  if (panel.objects.size() <= few_objects) panel.search.clear();
  if (other || panel.search != panel.searched) {
    panel.searched = panel.search;
    panel.found.clear();
    for (std::size_t i = 0; i < panel.objects.size(); ++i)
      if (matches(panel.objects[i].name + " " + panel.objects[i].type, panel.search)) panel.found.push_back(i);
  }
  if (panel.asked_about == panel.chosen) return;
  panel.asked_about = panel.chosen;
  panel.questions = s.scene_editor.questions(lesson, panel.chosen);
}

/// Shows the scene after a change. Returns whether it was not refused.
bool change_scene(WindowSession& s, const SceneEdit& edit) {
  bool done = false;
  attempt(s.toast, [&] {
    const Lesson* const before = &s.player.lesson();
    s.player.show_version(s.scene_editor.edited(*before, s.player.parameters(), edit));
    if (!s.scene_file.written) s.scene_file.written = before;
    done = true;
  });
  list_anew(s);
  return done;
}

void choose_object(ObjectsPanel& panel, const std::string& name) {
  if (std::erase(panel.chosen, name) > 0) return;
  if (panel.chosen.size() == 2) panel.chosen.erase(panel.chosen.begin());
  panel.chosen.push_back(name);
}

/// Adds an object in the middle of what is seen.
void add_object_of(WindowSession& s, const std::string& type) {
  const Camera& view = s.player.camera().goal();
  const SceneEdit edit = {.kind = SceneEdit::Kind::add,
                          .what = type,
                          .name = s.scene_editor.free_name(s.player.lesson()),
                          .middle = view.target,
                          .size = view.half_height / 4};
  if (!change_scene(s, edit)) return;
  s.objects.search.clear();
  s.objects.chosen = {edit.name};
  s.objects.to_see = edit.name;
  s.toast.say(edit.name + " stands in the middle of the picture. Drag it to its place");
}

void remove_object(WindowSession& s, const std::string& name) {
  const ObjectsPanel& panel = s.objects;
  const auto at = std::ranges::find(panel.found, name, [&](std::size_t i) { return panel.objects[i].name; });
  std::string next;
  if (at != panel.found.end() && panel.found.size() > 1)
    next = panel.objects[at + 1 == panel.found.end() ? *(at - 1) : *(at + 1)].name;
  const bool by_keyboard = s.ui.focus.name().ends_with(" " + name);
  if (!change_scene(s, {.kind = SceneEdit::Kind::remove, .what = name})) return;
  if (by_keyboard && !next.empty()) s.ui.focus.take("object " + next);
  s.toast.say(name + " and the questions about it are removed. Ctrl+Z brings them back");
}

void rename_object(WindowSession& s, const std::string& name, const std::string& now) {
  const bool chosen = std::erase(s.objects.chosen, name) > 0;
  const bool done = change_scene(s, {.kind = SceneEdit::Kind::rename, .what = name, .name = now});
  if (chosen) s.objects.chosen.push_back(done ? now : name);
  s.ui.focus.take("object " + (done ? now : name));
}

/// Adds a question, and goes to its answer.
void ask_about_chosen(WindowSession& s, const std::string& question) {
  std::set<std::string> before;
  for (const Step& step : s.player.walk().steps) before.insert(step.slug);
  if (!change_scene(s, {.kind = SceneEdit::Kind::ask, .what = question})) return;
  const std::vector<Step>& steps = s.player.walk().steps;
  const auto answer = std::ranges::find_if(steps, [&](const Step& step) { return !before.contains(step.slug); });
  if (answer != steps.end()) s.player.go_to(static_cast<int>(answer - steps.begin()));
}

void begin_renaming(ObjectsPanel& panel, const std::string& name) {
  panel.renaming = {name, name};
  panel.to_see = name;
}

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

/// Draws the rows that are in view, and one beyond them at each end, to which the keyboard can move.
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
  return 62 + buttons + question_row * static_cast<float>(panel.questions.size());
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
  text(ui.fonts.small, end + 10, heading, packed(ui.palette.muted), std::to_string(panel.objects.size()));
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

void scene_answers(Column& c, Player& player) {
  constexpr float row = 27, pitch = 25;
  Ui& ui = c.ui;
  const Step& step = player.step();
  if (const float height = values_height(ui, step, c.width + 20, pitch); height > 0) {
    values_block(ui, step, {c.x - 10, c.y + 8, c.x + c.width + 10, c.y + 8 + height}, pitch, nullptr);
    c.y += 8 + height;
  }
  const std::vector<Step>& steps = player.walk().steps;
  const bool asks = std::ranges::any_of(steps, [](const Step& one) { return one.question.has_value(); });
  std::vector<int> told;
  for (int i = 0; i < player.count(); ++i) {
    const bool last = i + 1 == player.count() || steps[i + 1].verdict.text != steps[i].verdict.text;
    if (last && !steps[i].verdict.text.empty() && (!asks || i <= player.index())) told.push_back(i);
  }
  if (told.empty()) return;
  c.y += 20;
  c.paragraph("Answers", ui.palette.text, true);
  c.y += 4;
  const float view = ImGui::GetWindowPos().y, end = view + ImGui::GetWindowHeight();
  int wanted = -1;
  for (const int i : told) {
    const Rect r{c.x - 8, c.y, c.x + c.width + 8, c.y + row};
    c.y += row;
    if (r.bottom < view - row || r.top > end + row) continue;  // there may be thousands
    const Press p = press(ui, "answer " + std::to_string(i + 1), r);
    const Verdict& verdict = steps[i].verdict;
    const bool here = i == player.index();
    if (here || p.hovered) filled(r, here ? ui.palette.frame : ui.palette.hovered, 5);
    const bool yes = verdict.kind == Verdict::Kind::yes, on = verdict.kind == Verdict::Kind::on;
    const ImU32 ink = packed(yes                                 ? ui.palette.hit
                             : verdict.kind == Verdict::Kind::no ? ui.palette.miss
                                                                 : ui.palette.muted);
    (yes ? tick : on ? diamond : ring)(r.left + 14, r.middle_y(), 12, ink);
    const std::string words = plain(verdict.text), shown = fitted(ui.fonts.body, words, r.width() - 36);
    text(ui.fonts.body, r.left + 28, r.middle_y(), packed(ui.palette.text), shown);
    if (p.hovered && shown != words) tooltip(ui, words);
    if (p.clicked) wanted = i;
  }
  if (wanted >= 0) player.go_to(wanted);
}

}  // namespace isect::viz
