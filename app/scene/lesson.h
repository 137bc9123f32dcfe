#pragma once
// A scene file as a lesson: its objects, then a step for each question, then all answers.

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/scene/file.h"
#include "viz/lesson.h"

namespace isect::program::scene {

struct KnownScene;  ///< app/scene/known.h

/// Returns a lesson called "scene". `folder` and exceptions are as in read_scene. Each answer is a step; above 200
/// pairs, those with the same first object are one. `known`: where the lesson keeps what it knows, such as all that is
/// known of another scene which begins with the same objects in the same order.
viz::Lesson lesson_of(const std::string& text, const std::string& folder,
                      const std::shared_ptr<KnownScene>& known = nullptr);

/// Returns the lesson without its steps, for which the core would be asked.
viz::Lesson without_steps(const File&);

/// Returns the lesson of the scene, kept as long as the program runs.
const viz::Lesson& kept_lesson_of(const std::string& text, const std::string& folder);

/// Replaces the kept lesson by one made from its file's text with these numbers.
void keep(const viz::Lesson& kept, const std::string& folder, const viz::Parameters&);

/// Whether it is a kept lesson with a text of its own, whose questions it asks.
bool is_editable(const viz::Lesson&);

/// Returns the text of a kept lesson with these numbers, with its comments; nothing if the lesson's questions are not
/// those of the text. Throws viz::BadInput if a number stands in another file.
std::optional<std::string> text_with(const viz::Lesson& kept, const viz::Parameters&);

/// Returns the lesson of the kept one's text with these numbers, after `edit` has changed that; kept, too. `same`: the
/// objects before and after stand in the same order, but for new ones behind. Throws viz::BadInput.
const viz::Lesson& edited(const viz::Lesson& kept, const viz::Parameters&, bool same,
                          const std::function<std::string(const std::string&)>& edit);

/// Returns the kept lesson with its answers hidden, or shown; itself if they are so already.
const viz::Lesson& with_answers(const viz::Lesson& kept, bool hidden);
/// Returns the kept lesson in a language, given as a code; itself if it is so already.
const viz::Lesson& with_language(const viz::Lesson& kept, const std::string& code);

/// Returns the lesson's own walks through all of the scene's objects that it takes, instead of the scene's own
/// questions; kept, too. `method`: one of its methods for many objects; empty: the first. Throws viz::BadInput if it
/// takes none of them, naming what it takes and which lessons take any.
const viz::Lesson& kept_walks_of(const viz::Lesson&, const std::string& method, const std::string& text,
                                 const std::string& folder);

/// Passes on the answers to all questions with the file's parameters: names, verdict in words, query and result. One at
/// a time: many objects have many pairs.
void each_answer(const File&, const std::function<void(Json)>& take);
Json answers(const File&);

}  // namespace isect::program::scene
