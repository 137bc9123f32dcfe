#include "app/scene/editor.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
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

Type type_of(const std::vector<Listed>& objects, const std::string& name) {
  return std::ranges::find(objects, name, &Listed::name)->type;
}

std::string title_of(const std::string& lesson) {
  return viz::plain(viz::lesson_named(lessons::all_lessons(), lesson).title);
}

/// Returns the names in a walk or a hierarchy, "r, S", or "all".
std::string names_told(const Json& named) {
  if (named.is_string()) return named;
  return fmt::format("{}", fmt::join(named.get<std::vector<std::string>>(), ", "));
}

/// Returns the id of the lesson that a walk steps through: the usual one for such objects if it names none.
std::string lesson_of_walk(const Json& entry, const std::vector<Listed>& objects, bool flat) {
  if (entry.contains("lesson")) return entry["lesson"];
  const Json& walk = entry["walk"];
  const bool one = walk.is_string();
  const Type a = type_of(objects, one ? walk : walk[0]), b = type_of(objects, one ? walk : walk[1]);
  const LessonWalk* const usual = walk_of(a, b, flat, one, "");
  return (usual ? usual : walk_of(b, a, flat, one, ""))->lesson;
}

/// Returns an entry of "ask" in words.
std::string words_on(const Json& entry, const std::vector<Listed>& objects, bool flat) {
  const auto text = [&](const char* field) { return entry[field].get<std::string>(); };
  if (entry.is_string()) return "How all pairs lie";
  if (entry.is_array())
    return fmt::format("How {} and {} lie", entry[0].get<std::string>(), entry[1].get<std::string>());
  if (entry.contains("first hit")) return "What " + text("first hit") + " meets first";
  if (entry.contains("fit")) {
    const bool all = !entry.contains("volume") || entry["volume"] == "all";
    return (all ? "Volumes around " : "The " + text("volume") + " around ") + text("fit");
  }
  if (entry.contains("clip")) {
    const bool side = type_of(objects, text("to")) == Type::plane;
    return "The part of " + text("clip") + (side ? " on the inner side of " : " in ") + text("to");
  }
  if (!entry.contains("hierarchy"))
    return fmt::format("Step by step: {} ({})", title_of(lesson_of_walk(entry, objects, flat)),
                       names_told(entry["walk"]));
  const Json& asked = entry["hierarchy"];
  if (asked == "all") return "A hierarchy of all objects";
  return (asked.is_string() ? "A hierarchy of the triangles of " : "A hierarchy of ") + names_told(asked);
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
    if (runs_along_a_line(a.type)) offer({{"first hit", a.name}}, {a});
    if (can_fit(a.type)) offer({{"fit", a.name}}, {a});
    if (a.type == Type::mesh) offer({{"hierarchy", a.name}}, {a});
    offer_walks(a, a);
  }

  void about(const Listed& a, const Listed& b) {
    if (!is_asked(Json{b.name, a.name}) && is_decided(a.type, b.type, flat_)) offer(Json{a.name, b.name}, {a, b});
    offer_clip(a, b);
    offer_clip(b, a);
    offer_walks(a, b);
  }

  std::vector<viz::SceneQuestion> questions = {};

 private:
  bool is_asked(const Json& entry) const {
    return std::ranges::any_of(asked_, [&](const Json& other) { return other == entry; });
  }
  void offer(const Json& entry, const std::vector<Listed>& objects) { offer(entry, words_on(entry, objects, flat_)); }
  void offer(const Json& entry, const std::string& words) {
    const bool fits = !all_pairs_;  // else "ask" is no list
    if (fits && !is_asked(entry)) questions.push_back({entry.dump(), words});
  }

  void offer_clip(const Listed& what, const Listed& to) {
    const bool can = runs_along_a_line(what.type) || what.type == Type::triangle || what.type == Type::polygon ||
                     what.type == Type::hull;
    if (can && (to.type == Type::box || to.type == Type::plane))
      offer({{"clip", what.name}, {"to", to.name}}, {what, to});
  }

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
      offer(entry, "Step by step: " + title_of(walk.lesson));
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

std::vector<viz::SceneQuestion> asked_about(const viz::Lesson& lesson, const std::vector<std::string>& names) {
  const Json scene = scene_of(lesson);
  std::vector<viz::SceneQuestion> asked;
  if (!is_editable(lesson) || names.empty() || !scene.contains("ask")) return asked;
  const std::vector<Listed> all = listed(scene);
  const auto take = [&](const Json& entry) {
    if (std::ranges::all_of(names, [&](const std::string& name) { return is_about(entry, name); }))
      asked.push_back({entry.dump(), words_on(entry, all, lesson.flat)});
  };
  if (scene["ask"].is_string())
    take(scene["ask"]);
  else
    for (const Json& entry : scene["ask"]) take(entry);
  return asked;
}

/// Adds the sides of a polygon whose corners are parameters.
void add_sides(const Json& polygon, const std::string& name, const viz::Parameters& now,
               std::vector<viz::SceneSide>& to) {
  const auto point = [&](std::size_t number) {
    const auto found = now.find(fmt::format("{}.{}", name, number));
    return found == now.end() ? std::optional<viz::Vec3>() : std::get<viz::Vec3>(found->second);
  };
  const auto at = now.find(name + ".at");
  const viz::Vec3 way = at == now.end() ? viz::Vec3(0, 0, 0) : std::get<viz::Vec3>(at->second);
  std::size_t before = 0;
  const auto add = [&](std::size_t corners) {
    for (std::size_t i = 0; i < corners; ++i) {
      const auto from = point(before + i + 1), until = point(before + (i + 1) % corners + 1);
      if (from && until) to.push_back({name, static_cast<int>(before + i + 1), *from + way, *until + way});
    }
    before += corners;
  };
  if (polygon.contains("points")) add(polygon["points"].size());
  if (polygon.contains("rings"))
    for (const Json& ring : polygon["rings"]) add(ring.size());
}

std::vector<viz::SceneSide> sides_of(const viz::Lesson& lesson, const viz::Parameters& now) {
  std::vector<viz::SceneSide> all;
  if (!is_editable(lesson)) return all;
  const Json scene = scene_of(lesson);
  for (const Json& object : scene["objects"])
    if (type_field(object) == spec(Type::polygon).name && !object.value("hidden", false))
      add_sides(object, object[spec(Type::polygon).name], now, all);
  return all;
}

/// Whether all objects stand where they stood, with as many numbers, but for new ones behind.
bool keeps_objects(const viz::SceneEdit& edit) {
  using Kind = viz::SceneEdit::Kind;
  return edit.kind != Kind::remove && edit.kind != Kind::rename && edit.kind != Kind::add_corner &&
         edit.kind != Kind::remove_corner;
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
    case Kind::unask:
      return without_question(text, Json::parse(edit.what));
    case Kind::add_corner:
      return with_corner(text, edit.what, edit.corner, edit.middle);
    case Kind::remove_corner:
      return without_corner(text, edit.what, edit.corner);
  }
  return text;
}

}  // namespace

viz::SceneEditor editor() {
  return {.objects = objects_of,
          .types = types_for,
          .free_name = [](const viz::Lesson& lesson) { return free_name(lesson.made_from); },
          .questions = questions_about,
          .asked = asked_about,
          .sides = sides_of,
          .edited = [](const viz::Lesson& lesson, const viz::Parameters& now,
                       const viz::SceneEdit& edit) -> const viz::Lesson& {
            const auto change = [&](const std::string& text) { return changed_text(text, edit, lesson.flat); };
            return edited(lesson, now, keeps_objects(edit), change);
          }};
}

}  // namespace isect::program::scene
