// What is kept of a reader's way: answers, lessons read to their ends, lessons last opened.

#include "viz/closing.h"
#include "viz/window/panels.h"

namespace isect::viz {

void keep_score(Session& s) {
  const Player& player = s.player;
  Score& score = s.settings.scores[player.lesson().id];
  if (const auto answered = player.answered()) {
    std::string name = player.method() + "/" + player.step().slug;
    std::erase_if(name, [](char c) { return c >= '0' && c <= '9'; });  // one question, however often a loop asks it
    score.answers[name] = answered->right();
  }
  if (player.step().slug == closing_slug) score.finished = true;
}

void keep_recent(Session& s) {
  std::vector<std::string>& recent = s.settings.recent;
  const std::string& id = s.player.lesson().id;
  if (!recent.empty() && recent.front() == id) return;
  std::erase(recent, id);
  recent.insert(recent.begin(), id);
  if (recent.size() > recent_kept) recent.resize(recent_kept);
}

}  // namespace isect::viz
