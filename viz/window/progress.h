#pragma once
// A reader's progress over the whole course: what stands on its sheet, and the file that tells it to others.

#include <string>
#include <vector>

#include "viz/window/window_session.h"

namespace isect::viz {

/// A reader's progress in a lesson.
struct LessonProgress {
  const Lesson* lesson = nullptr;
  bool finished = false;
  int seen = 0, of = 0;                      ///< the furthest step that was shown, and the steps of its walk; or 0
  int right = 0, answered = 0, skipped = 0;  ///< questions
  int solved = 0, exercises = 0;             ///< exercises
};
/// Returns it for all lessons in the order of the course; scenes from files are none.
std::vector<LessonProgress> progress_of(const std::vector<const Lesson*>&, const Settings&);

/// Returns the progress as JSON, on several lines:
///
///     {
///       "isect": "progress",
///       "version": 1,
///       "lessons": {                    by id, in the order of the course; all of them
///         "ray-sphere": {
///           "finished": true,           read to its end
///           "seen": 9, "of": 9,         the furthest step that was shown, and the steps of its walk; 0: none was
///           "right": 3, "answered": 4,  questions that were answered right the last time, of those answered at all
///           "skipped": 1,               questions that were passed over and never answered
///           "solved": 1, "exercises": 5
///         }
///       },
///       "reviews": {"1": {"right": 7, "of": 8}},   the last of each, by its number
///       "record": {...}                 each question's answers, as text_of(AnswerRecord) and pages keep them
///     }
///
/// Pages save the same, and besides that "pages": {...}, which they need to go on; what reads the file can pass it
/// over.
std::string progress_json(const std::vector<const Lesson*>&, const Settings&);
/// The name of its file, where no other is given.
inline const std::string usual_progress_name = "progress";
/// Writes that to <folder>/<name>.json, without a name to progress.json; where another file has that name, a number is
/// added to it. Returns the whole path. Throws FileError.
std::string save_progress(const std::vector<const Lesson*>&, const Settings&, const std::string& folder,
                          const std::string& name);

}  // namespace isect::viz
