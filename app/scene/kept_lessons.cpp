// The lessons of scenes that are kept as long as the program runs: a scene's own, and those with the walks of another
// lesson through its objects.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <deque>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "app/scene/edit.h"
#include "app/scene/known.h"
#include "app/scene/lesson.h"
#include "app/scene/save.h"
#include "app/scene/types.h"
#include "app/scene/walks.h"

namespace isect::program::scene {

namespace {

/// A lesson with the text that it was made from.
struct KeptLesson {
  viz::Lesson lesson;
  std::string text, folder;  ///< `text`: as people wrote it; empty: the lesson asks other questions
  std::shared_ptr<KnownScene> known;
};

std::deque<KeptLesson>& kept_lessons() {
  static std::deque<KeptLesson> all;  // none of them moves
  return all;
}

KeptLesson& kept_as(const viz::Lesson& lesson) {
  const auto address = [](const KeptLesson& one) { return &one.lesson; };
  const auto found = std::ranges::find(kept_lessons(), &lesson, address);
  if (found == kept_lessons().end()) throw std::logic_error("this lesson is not kept");
  return *found;
}

KeptLesson kept_from(const std::string& text, const std::string& folder, std::shared_ptr<KnownScene> known) {
  viz::Lesson lesson = lesson_of(text, folder, known);
  return {std::move(lesson), text, folder, std::move(known)};
}

}  // namespace

const viz::Lesson& kept_lesson_of(const std::string& text, const std::string& folder) {
  return kept_lessons().emplace_back(kept_from(text, folder, std::make_shared<KnownScene>())).lesson;
}

void keep(const viz::Lesson& kept, const std::string& folder, const viz::Parameters& parameters) {
  KeptLesson& one = kept_as(kept);
  const std::string& was = one.text.empty() ? kept.made_from : one.text;
  KeptLesson now = kept_from(with_numbers(was, read_scene(was, folder), parameters), folder, one.known);
  if (one.text.empty()) now.text.clear();
  one = std::move(now);
}

bool is_editable(const viz::Lesson& lesson) {
  return std::ranges::any_of(kept_lessons(),
                             [&](const KeptLesson& one) { return &one.lesson == &lesson && !one.text.empty(); });
}

std::optional<std::string> text_with(const viz::Lesson& kept, const viz::Parameters& parameters) {
  const KeptLesson& one = kept_as(kept);
  if (one.text.empty()) return {};
  return with_numbers(one.text, read_scene(one.text, one.folder), parameters);
}

const viz::Lesson& edited(const viz::Lesson& kept, const viz::Parameters& parameters, bool same,
                          const std::function<std::string(const std::string&)>& edit) {
  const std::optional<std::string> text = text_with(kept, parameters);
  if (!text) throw viz::BadInput("the objects of another lesson’s walk are changed in their own file");
  const auto known = std::make_shared<KnownScene>();
  const KeptLesson& one = kept_as(kept);
  if (same) {
    const std::lock_guard lock(one.known->busy);
    known->known = one.known->known;
  }
  return kept_lessons().emplace_back(kept_from(edit(*text), one.folder, known)).lesson;
}

namespace {

/// Returns the lesson of the kept one's text after `edit` has changed that.
const viz::Lesson& kept_again(const KeptLesson& one, const std::function<std::string(const std::string&)>& edit) {
  const bool own = !one.text.empty();
  const viz::Lesson& made = kept_lesson_of(edit(own ? one.text : one.lesson.made_from), one.folder);
  if (!own) kept_as(made).text.clear();
  return made;
}

/// Returns the kept lesson's file as its text has it.
File file_of(const KeptLesson& one) {
  return read_scene(one.text.empty() ? one.lesson.made_from : one.text, one.folder);
}

}  // namespace

const viz::Lesson& with_answers(const viz::Lesson& kept, bool hidden) {
  const KeptLesson& one = kept_as(kept);
  if (file_of(one).answers_hidden == hidden) return kept;
  return kept_again(one, [&](const std::string& text) { return with_answers(text, hidden); });
}

const viz::Lesson& with_language(const viz::Lesson& kept, const std::string& code) {
  if (kept.language == code || (kept.language.empty() && code == "en")) return kept;
  return kept_again(kept_as(kept), [&](const std::string& text) { return with_language(text, code); });
}

namespace {

/// Returns what the lesson can walk through, in the order of the file, as questions.
Json walks_through(const viz::Lesson& lesson, const std::string& method, const File& file) {
  const NamedValues numbers = {file.parameters, file.flat};
  Json asked = Json::array();
  std::string refused;
  if (const LessonWalk* const way = walk_of_many(lesson.id, method); way && way->flat == file.flat)
    if (std::ranges::count(file.objects, way->a, &Object::type) > 1) {  // its ray, if it needs one, is the only one
      asked.push_back({{"walk", "all"}, {"lesson", lesson.id}, {"method", way->method}});
      return asked;
    }
  const auto ask = [&](std::size_t i, std::size_t j) {
    const Object &a = file.objects[i], &b = file.objects[j];
    const LessonWalk* const found = walk_of(a.type, b.type, file.flat, i == j, lesson.id);
    if (!found) return;
    try {
      static_cast<void>(walk(*found, numbers, a, b));
      const Json names = i == j ? Json(a.name) : Json{a.name, b.name};
      asked.push_back({{"walk", names}, {"lesson", lesson.id}});
    } catch (const viz::BadInput& e) {
      refused += (refused.empty() ? "" : ", and ") + std::string(e.what());
    }
  };
  for (std::size_t i = 0; i < file.objects.size(); ++i)
    for (std::size_t j = 0; j < file.objects.size(); ++j)
      if (i <= j || file.objects[i].type != file.objects[j].type) ask(i, j);
  if (!asked.empty()) return asked;
  if (!refused.empty()) throw viz::BadInput(refused);
  std::string takes;
  for (const LessonWalk& w : walks()) {
    if (w.lesson != lesson.id) continue;
    const std::string one =
        fmt::format("{}{} {}", w.of_many() ? std::string("two ") + w.name_a + " or more" : spec(w.a).name,
                    w.of_one() || w.of_many() ? std::string() : std::string(" and ") + spec(w.b).name,
                    w.flat ? "in the plane" : "in space");
    if (takes.find(one) == takes.npos) takes += (takes.empty() ? "" : ", ") + one;  // several methods may take the same
  }
  if (takes.empty())
    throw viz::BadInput(fmt::format("scene: {} takes no objects of a scene; these do: {}", lesson.id,
                                    fmt::join(walking_lessons(), ", ")));
  throw viz::BadInput(fmt::format("scene: none of its objects are what {} takes: {}", lesson.id, takes));
}

}  // namespace

const viz::Lesson& kept_walks_of(const viz::Lesson& lesson, const std::string& method, const std::string& text,
                                 const std::string& folder) {
  const File file = read_scene(text, folder);
  Json scene = Json::parse(file.text);
  scene["ask"] = walks_through(lesson, method, file);
  scene["title"] = fmt::format("{}: {}", lesson.title, file.title);
  const viz::Lesson& made = kept_lesson_of(scene.dump(), folder);
  kept_as(made).text.clear();
  return made;
}

}  // namespace isect::program::scene
