#include "viz/window/object_changes.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "viz/player/side_at.h"
#include "viz/window/objects_panel.h"
#include "viz/window/sheets.h"

namespace isect::viz {

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
    panel.asked_about.clear(), panel.questions.clear(), panel.asked.clear();
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
  panel.asked = s.scene_editor.asked(lesson, panel.chosen);
}

bool change_scene(WindowSession& s, const SceneEdit& edit, bool leaves_step) {
  bool done = false;
  attempt(s.toast, [&] {
    const Lesson* const before = &s.player.lesson();
    s.player.show_version(s.scene_editor.edited(*before, s.player.parameters(), edit), leaves_step);
    std::map<const Lesson*, const Lesson*>& versions = s.scene_file.versions;
    const Lesson* const first = versions.try_emplace(before, before).first->second;
    versions.try_emplace(&s.player.lesson(), first);
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

void ask_about_chosen(WindowSession& s, const std::string& question) {
  std::set<std::string> before;
  for (const Step& step : s.player.walk().steps) before.insert(step.slug);
  if (!change_scene(s, {.kind = SceneEdit::Kind::ask, .what = question}, true)) return;
  const std::vector<Step>& steps = s.player.walk().steps;
  const auto answer = std::ranges::find_if(steps, [&](const Step& step) { return !before.contains(step.slug); });
  if (answer != steps.end()) s.player.go_to(static_cast<int>(answer - steps.begin()));
}

void remove_question(WindowSession& s, const SceneQuestion& question) {
  if (!change_scene(s, {.kind = SceneEdit::Kind::unask, .what = question.id})) return;
  s.toast.say("“" + question.words + "” is no longer asked. Ctrl+Z brings it back");
}

namespace {

/// Returns the sides of the scene on show: none while a question is open, or if it can't be changed.
std::vector<SceneSide> sides(const WindowSession& s) {
  const Lesson& lesson = s.player.lesson();
  if (!s.scene_editor.sides || lesson.made_from.empty() || s.player.quiz().asked()) return {};
  return s.scene_editor.sides(lesson, s.player.parameters());
}

std::optional<SceneSide> side_from(const WindowSession& s, const std::string& handle) {
  const std::vector<SceneSide> all = sides(s);
  const auto found = std::ranges::find(all, handle, &SceneSide::parameter);
  return found == all.end() ? std::nullopt : std::optional(*found);
}

void add_corner(WindowSession& s, SceneSide side, const Vec3& at) {
  const SceneEdit edit = {
      .kind = SceneEdit::Kind::add_corner, .what = side.object, .middle = at, .corner = side.corner};
  if (!change_scene(s, edit)) return;
  ++side.corner;
  if (s.ui.focus.name().starts_with("handle ")) s.ui.focus.take("handle " + side.parameter());
  s.toast.say(side.object + " has a corner more. Drag it to its place");
}

}  // namespace

bool add_corner_at(WindowSession& s, const View& view, const Vec2& pixel) {
  constexpr double reach = 8;  // px
  const std::optional<PlaceOnSide> place = side_at(sides(s), view, pixel, reach);
  if (place) add_corner(s, place->side, place->at);
  return place.has_value();
}

bool add_corner_behind(WindowSession& s, const std::string& handle) {
  const std::optional<SceneSide> side = side_from(s, handle);
  if (side) add_corner(s, *side, side->from / 2 + side->to / 2);
  return side.has_value();
}

bool remove_corner(WindowSession& s, const std::string& handle) {
  const std::optional<SceneSide> side = side_from(s, handle);
  if (!side) return false;
  if (change_scene(s, {.kind = SceneEdit::Kind::remove_corner, .what = side->object, .corner = side->corner}))
    s.toast.say("A corner of " + side->object + " is removed. Ctrl+Z brings it back");
  return true;
}

void begin_renaming(ObjectsPanel& panel, const std::string& name) {
  panel.renaming = {name, name};
  panel.to_see = name;
}

}  // namespace isect::viz
