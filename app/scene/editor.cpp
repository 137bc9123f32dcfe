#include "app/scene/editor.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "app/scene/edit.h"
#include "app/scene/fits.h"
#include "app/scene/lesson.h"
#include "app/scene/own_words.h"
#include "app/scene/questions.h"
#include "app/scene/walks.h"
#include "lessons/lessons.h"
#include "viz/player/reader_state.h"
#include "viz/text/rich_text.h"

namespace isect::program::scene {

namespace {

/// What a list of objects needs of one.
struct Listed {
  std::string name;
  Type type;
  bool hidden;
};

Json scene_of(const viz::Lesson& lesson) { return Json::parse(lesson.made_from); }

const TypeSpec& type_named(const std::string& name) {
  return *std::ranges::find_if(types(), [&](const TypeSpec& t) { return t.name == name || other_name(t) == name; });
}

std::vector<Listed> listed(const Json& scene) {
  std::vector<Listed> all;
  for (const Json& object : scene["objects"]) {
    const std::string field = type_field(object);
    all.push_back({object[field].get<std::string>(), type_named(field).type, object.value("hidden", false)});
  }
  return all;
}

std::vector<viz::SceneObject> objects_of(const viz::Lesson& lesson) {
  if (!is_editable(lesson)) return {};
  std::vector<viz::SceneObject> all;
  for (const Listed& o : listed(scene_of(lesson)))
    all.push_back({o.name, shown_name(o.name), in_words(o.type, lesson.flat), o.hidden});
  return all;
}

std::vector<viz::SceneType> types_for(const viz::Lesson& lesson) {
  std::vector<viz::SceneType> all;
  for (const TypeSpec& type : types())
    if (const std::string words = in_words(type.type, lesson.flat); !words.empty()) all.push_back({type.name, words});
  return all;
}

/// The questions about some objects, as entries of "ask".
class Offered {
 public:
  Offered(const Json& scene, bool flat)
      : flat_(flat), all_pairs_(scene.contains("ask") && scene["ask"] == "all pairs") {
    if (scene.contains("ask") && scene["ask"].is_array())
      for (const Json& asked : scene["ask"]) asked_.push_back(without_words(asked));
  }

  void about(const Listed& a) {
    if (runs_along_a_line(a.type)) offer({{"first hit", a.name}}, "What " + a.name + " meets first");
    if (can_fit(a.type)) offer({{"fit", a.name}}, "Volumes around " + a.name);
    if (a.type == Type::mesh) offer({{"hierarchy", a.name}}, "A hierarchy of the triangles of " + a.name);
    offer_walks(a, a);
  }

  void about(const Listed& a, const Listed& b) {
    if (!is_asked(Json{b.name, a.name}) && is_decided(a.type, b.type, flat_))
      offer(Json{a.name, b.name}, fmt::format("How {} and {} lie", a.name, b.name));
    offer_clip(a, b);
    offer_clip(b, a);
    offer_walks(a, b);
  }

  std::vector<viz::SceneQuestion> questions = {};

 private:
  bool is_asked(const Json& entry) const {
    return std::ranges::any_of(asked_, [&](const Json& other) { return other == entry; });
  }
  void offer(const Json& entry, const std::string& words) {
    const bool fits = !all_pairs_;  // else "ask" is no list
    if (fits && !is_asked(entry)) questions.push_back({entry.dump(), words});
  }

  void offer_clip(const Listed& what, const Listed& to) {
    const bool can = runs_along_a_line(what.type) || what.type == Type::triangle || what.type == Type::polygon ||
                     what.type == Type::hull;
    if (can && to.type == Type::box) offer(clip(what, to), fmt::format("The part of {} in {}", what.name, to.name));
    if (can && to.type == Type::plane)
      offer(clip(what, to), fmt::format("The part of {} on the inner side of {}", what.name, to.name));
  }
  static Json clip(const Listed& what, const Listed& to) { return {{"clip", what.name}, {"to", to.name}}; }

  /// Offers the lessons that step through one object or two: in the file the usual one for such objects has no name.
  void offer_walks(const Listed& a, const Listed& b) {
    const bool one = a.name == b.name;
    bool usual = true;
    std::vector<std::string> known;
    for (const LessonWalk& walk : walks()) {
      if (!walk.takes(a.type, b.type, flat_, one) && !walk.takes(b.type, a.type, flat_, one)) continue;
      if (std::ranges::find(known, walk.lesson) != known.end()) continue;
      known.emplace_back(walk.lesson);
      Json entry = {{"walk", one ? Json(a.name) : Json{a.name, b.name}}};
      if (!std::exchange(usual, false)) entry["lesson"] = walk.lesson;
      offer(entry, "Step by step: " + viz::plain(viz::lesson_named(lessons::all_lessons(), walk.lesson).title));
    }
  }

  bool flat_, all_pairs_;
  Json asked_ = Json::array();
};

std::vector<viz::SceneQuestion> questions_about(const viz::Lesson& lesson, const std::vector<std::string>& names) {
  const Json scene = scene_of(lesson);
  const std::vector<Listed> all = listed(scene);
  std::vector<Listed> chosen;
  for (const std::string& name : names)
    if (const auto found = std::ranges::find(all, name, &Listed::name); found != all.end()) chosen.push_back(*found);
  Offered offered(scene, lesson.flat);
  if (chosen.size() == 1) offered.about(chosen[0]);
  if (chosen.size() == 2) offered.about(chosen[0], chosen[1]);
  return std::move(offered.questions);
}

std::string changed_text(const std::string& text, const viz::SceneEdit& edit, bool flat) {
  using Kind = viz::SceneEdit::Kind;
  switch (edit.kind) {
    case Kind::add:
      return with_object(text, type_named(edit.what).type, edit.name, {edit.middle, edit.size, flat});
    case Kind::remove:
      return without_object(text, edit.what);
    case Kind::rename:
      return with_name(text, edit.what, edit.name);
    case Kind::hide:
    case Kind::show:
      return with_hidden(text, edit.what, edit.kind == Kind::hide);
    case Kind::ask:
      return with_question(text, Json::parse(edit.what));
  }
  return text;
}

}  // namespace

viz::SceneEditor editor() {
  return {.objects = objects_of,
          .types = types_for,
          .free_name = [](const viz::Lesson& lesson) { return free_name(lesson.made_from); },
          .questions = questions_about,
          .edited = [](const viz::Lesson& lesson, const viz::Parameters& now,
                       const viz::SceneEdit& edit) -> const viz::Lesson& {
            const bool same = edit.kind != viz::SceneEdit::Kind::remove && edit.kind != viz::SceneEdit::Kind::rename;
            const auto change = [&](const std::string& text) { return changed_text(text, edit, lesson.flat); };
            return edited(lesson, now, same, change);
          }};
}

}  // namespace isect::program::scene
