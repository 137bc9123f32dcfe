#pragma once
// A scene file as a lesson: its objects, then a step for each question, then all answers.

#include <string>

#include "app/scene/file.h"
#include "viz/lesson.h"

namespace isect::program::scene {

/// Called "scene". Throws viz::BadInput as read_scene does.
viz::Lesson lesson_of(const std::string& text);

/// The same, kept as long as the program runs.
const viz::Lesson& kept_lesson_of(const std::string& text);

/// The answers to all questions, as JSON: names, verdict in words, query and result.
Json answers(const File&);

}  // namespace isect::program::scene
