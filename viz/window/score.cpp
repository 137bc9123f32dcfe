// A reader's progress that is kept: answers, lessons read to their ends, lessons opened last.

#include "viz/walk/closing.h"
#include "viz/window/panels.h"

namespace isect::viz {
namespace {

std::string question_name(const Player& player, int step) {
  std::string name = player.played().method() + "/" + player.walk().steps[step].slug;
  std::erase_if(name, [](char c) { return c >= '0' && c <= '9'; });  // the same question in every round of a loop
  return name;
}

}  // namespace

void keep_score(const Player& player, Settings& settings) {
  Score& score = settings.scores[player.lesson().id];
  if (const auto answered = player.quiz().answered())
    score.answers[question_name(player, player.index())] = answered->right();
  if (player.step().slug == closing_slug) score.finished = true;
}

std::vector<int> missed_questions(const Player& player, const Settings& settings) {
  std::vector<int> missed;
  const auto score = settings.scores.find(player.lesson().id);
  if (score == settings.scores.end()) return missed;
  std::set<std::string> seen;
  for (int i = 1; i < player.count(); ++i) {
    if (!player.walk().steps[i].question) continue;
    const std::string name = question_name(player, i);
    const auto answer = score->second.answers.find(name);
    if (answer != score->second.answers.end() && !answer->second && seen.insert(name).second) missed.push_back(i);
  }
  return missed;
}

void keep_recent(const Player& player, Settings& settings) {
  std::vector<std::string>& recent = settings.recent;
  const std::string& id = player.lesson().id;
  if (!player.lesson().made_from.empty()) return;  // scenes from files are not among the lessons
  if (!recent.empty() && recent.front() == id) return;
  std::erase(recent, id);
  recent.insert(recent.begin(), id);
  if (recent.size() > recent_kept) recent.resize(recent_kept);
}

}  // namespace isect::viz
