#include "viz/player/practice.h"

#include <algorithm>

#include "viz/walk/closing.h"
#include "viz/walk/other_numbers.h"

namespace isect::viz {

const Erratum* erratum(const Player& player) {
  const Erratum* found = nullptr;
  for (const Erratum& e : player.lesson().errata) {
    const int line = line_of(e, player.walk());
    if (line >= 0 && line == player.step().line) return &e;
    if (line >= 0 && !found) found = &e;
  }
  return found;
}

void show_erratum(Player& player) {
  const Erratum* e = erratum(player);
  if (!e) return;
  player.load(preset(player.lesson(), e->preset));
  const int line = line_of(*e, player.walk());
  for (int i = 0; i < player.count(); ++i)
    if (player.walk().steps[i].line == line) return player.go_to(i);
  player.go_to(outcome(player.walk()));  // the line was refused on the way there
}

const Lesson* next_lesson(const Player& player) {
  const std::vector<const Lesson*>& all = player.lessons();
  if (!player.lesson().made_from.empty()) return nullptr;
  const auto after = std::find(all.begin(), all.end(), &player.lesson()) + 1;
  return after == all.end() || !(*after)->made_from.empty() ? nullptr : *after;
}

bool leads_to_next_lesson(const Player& player) {
  return player.at_end() && player.step().slug == closing_slug && next_lesson(player);
}

void begin_exercise(Player& player, int index) {
  const Exercise& e = player.lesson().closing->exercises.at(static_cast<std::size_t>(index));
  if (!e.preset.empty()) player.load(preset(player.lesson(), e.preset));
  player.go_to(outcome(player.walk()));
  player.set_exercise(index);
}

bool exercise_solved(const Player& player) {
  const Exercise* e = player.exercise();
  return e && e->found && e->found(player.parameters());
}

bool ask_with_other_numbers(Player& player) {
  if (!player.quiz().answered()) return false;
  const std::optional<OtherSetting> other =
      other_numbers(player.lesson(), player.parameters(), player.index(), player.answers_given());
  if (!other) return false;
  player.remember("");
  player.set_parameters(other->parameters);
  player.ask_again(other->step);
  return true;
}

}  // namespace isect::viz
