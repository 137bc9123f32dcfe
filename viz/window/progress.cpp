#include "viz/window/progress.h"

#include <nlohmann/json.hpp>

#include "viz/formats/files.h"
#include "viz/window/save_figure.h"
#include "viz/window/save_place.h"

namespace isect::viz {

std::vector<LessonProgress> progress_of(const std::vector<const Lesson*>& lessons, const Settings& settings) {
  std::vector<LessonProgress> all;
  for (const Lesson* lesson : lessons) {
    if (!lesson->made_from.empty()) continue;
    LessonProgress& p = all.emplace_back();
    p.lesson = lesson;
    if (lesson->closing) p.exercises = static_cast<int>(lesson->closing->exercises.size());
    const auto found = settings.scores.find(lesson->id);
    if (found == settings.scores.end()) continue;
    const Score& score = found->second;
    p.finished = score.finished, p.seen = score.seen, p.of = score.of;
    p.right = score.right(), p.answered = static_cast<int>(score.answers.size());
    p.skipped = static_cast<int>(score.skipped.size());
    if (lesson->closing)
      for (const Exercise& e : lesson->closing->exercises) p.solved += score.solved.contains(e.prompt);
  }
  return all;
}

std::string progress_json(const std::vector<const Lesson*>& lessons, const Settings& settings) {
  using ProgressJson = nlohmann::ordered_json;
  ProgressJson of_lessons = ProgressJson::object();
  for (const LessonProgress& p : progress_of(lessons, settings)) {
    ProgressJson& to = of_lessons[p.lesson->id];
    to["finished"] = p.finished;
    to["seen"] = p.seen, to["of"] = p.of;
    to["right"] = p.right, to["answered"] = p.answered, to["skipped"] = p.skipped;
    to["solved"] = p.solved, to["exercises"] = p.exercises;
  }
  ProgressJson json;
  json["isect"] = "progress", json["version"] = 1;
  json["lessons"] = of_lessons;
  const ProgressJson record = ProgressJson::parse(text_of(settings.record));
  json["reviews"] = record["reviews"], json["record"] = record;
  return json.dump(2) + "\n";
}

std::string save_progress(const std::vector<const Lesson*>& lessons, const Settings& settings,
                          const std::string& folder, const std::string& name) {
  const std::string text = progress_json(lessons, settings);
  const std::string path = free_path(folder + "/" + (name.empty() ? usual_progress_name : name), "json", text);
  write_file(path, text);
  return whole_path(path);
}

}  // namespace isect::viz
