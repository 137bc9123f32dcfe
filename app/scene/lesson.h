#pragma once
// A scene file as a lesson: its objects, then a step for each question, then all answers.

#include <functional>
#include <memory>
#include <string>

#include "app/scene/file.h"
#include "viz/lesson.h"

namespace isect::program::scene {

/// Called "scene". `folder` and what is thrown are as in read_scene. Each answer is a step; of more
/// than 200 pairs those with the same first object are one.
viz::Lesson lesson_of(const std::string& text, const std::string& folder);

/// All of it but its steps, for which the core would be asked.
viz::Lesson without_steps(const File&);

/// The same, kept as long as the program runs.
const viz::Lesson& kept_lesson_of(const std::string& text, const std::string& folder);

/// Such a lesson is now one whose file has these numbers.
void keep(const viz::Lesson& kept, const std::string& folder, const viz::Parameters&);

/// The lesson's own walk through each of the scene's objects that it takes, in place of what the scene asks; kept, too.
/// `method`: of those that it has for many objects; empty: the first. Throws viz::BadInput where it takes none of them,
/// naming what it takes and which lessons take any.
const viz::Lesson& kept_walks_of(const viz::Lesson&, const std::string& method, const std::string& text,
                                 const std::string& folder);

/// The answers to all questions with the file's parameters: names, verdict in words, query and result. One at a time:
/// many objects have many pairs.
void each_answer(const File&, const std::function<void(Json)>& take);
Json answers(const File&);

}  // namespace isect::program::scene
