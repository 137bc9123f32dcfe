// A published line that is seen to fail, and the way back from there.

#include "viz/player/practice.h"
#include "viz/window/column.h"
#include "viz/window/panels.h"

namespace isect::viz {
namespace {

/// Whether the failure itself is on show, and not a setting made from it.
bool fault_on_show(const Player& player) { return player.played().preset_id() == player.origin(); }

void go_back(Player& player, std::optional<Player>& before) {
  player.return_as(std::move(*before));
  before.reset();
}

}  // namespace

bool can_return(const Player& player, const std::optional<Player>& before) {
  if (!before || &before->lesson() != &player.lesson()) return false;
  const Erratum* const e = erratum(*before);
  return e && player.origin() == e->preset;
}

void fault_or_back(Player& player, std::optional<Player>& before) {
  const bool kept = can_return(player, before);
  if (kept && fault_on_show(player)) return go_back(player, before);
  if (!erratum(player)) return;
  Player now = player;
  show_erratum(player);
  if (!kept) before = std::move(now);
}

void way_back(Column& c, Player& player, std::optional<Player>& before) {
  if (!can_return(player, before)) return before.reset();
  c.y += 16;
  float x = c.x;
  const std::string words = "Back to step " + std::to_string(before->index() + 1) + ", where I was";
  const bool pressed = c.button("way back", words + (fault_on_show(player) ? " (E)" : ""), x);
  c.y += Column::button_height;
  if (pressed) go_back(player, before);
}

}  // namespace isect::viz
