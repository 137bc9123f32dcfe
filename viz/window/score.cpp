// A reader's progress that is kept: answers, skipped questions, solved exercises, how far lessons were read, and which
// were opened last.

#include <utility>

#include "viz/player/practice.h"
#include "viz/walk/closing.h"
#include "viz/walk/review.h"
#include "viz/window/panels.h"

namespace isect::viz {
namespace {

std::string question_at(const Player& player, int step) {
  return question_name(player.lesson(), player.parameters(), player.walk().steps[step]);
}

}  // namespace

void keep_score(const Player& player, Settings& settings, unsigned& answers_kept) {
  Score& score = settings.scores[player.lesson().id];
  const bool fresh = std::exchange(answers_kept, player.answers_given()) != player.answers_given();
  if (const auto answered = player.quiz().answered()) {
    const std::string question = question_at(player, player.index());
    score.answers[question] = answered->right();
    score.skipped.erase(question);
    if (fresh && player.lesson().made_from.empty())
      settings.record.keep(player.lesson().id, question, answered->right());
  }
  if (player.quiz().is_skipped(player.index())) {
    const std::string question = question_at(player, player.index());
    if (!score.answers.contains(question)) score.skipped.insert(question);
  }
  const Exercise* e = player.exercise();
  if (e && !score.solved.contains(e->prompt) && exercise_solved(player)) score.solved.insert(e->prompt);
  if (player.step().slug == closing_slug) score.finished = true;
}

std::vector<Missed> missed_questions(const Player& player, const Settings& settings) {
  std::vector<Missed> missed;
  const auto score = settings.scores.find(player.lesson().id);
  if (score == settings.scores.end()) return missed;
  std::set<std::string> seen;
  for (int i = 1; i < player.count(); ++i) {
    if (!player.walk().steps[i].question) continue;
    const std::string name = question_at(player, i);
    const auto answer = score->second.answers.find(name);
    const bool wrong = answer != score->second.answers.end() && !answer->second;
    const bool skipped = score->second.skipped.contains(name);
    if ((wrong || skipped) && seen.insert(name).second) missed.push_back({i, skipped});
  }
  return missed;
}

void keep_place(const Player& player, Settings& settings) {
  std::vector<std::string>& recent = settings.recent;
  const std::string& id = player.lesson().id;
  if (!player.lesson().made_from.empty()) return;  // scenes from files are not among the lessons
  Score& score = settings.scores[id];
  const int step = player.index() + 1;
  if (step * score.of >= score.seen * player.count()) score.seen = step, score.of = player.count();
  if (!recent.empty() && recent.front() == id) return;
  std::erase(recent, id);
  recent.insert(recent.begin(), id);
  if (recent.size() > recent_kept) recent.resize(recent_kept);
}

}  // namespace isect::viz
