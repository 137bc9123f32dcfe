// A published line that is seen to fail, and the way back from there.

#include "viz/player/practice.h"
#include "viz/window/column.h"
#include "viz/window/panels.h"

namespace isect::viz {

bool can_return(const Player& player, const std::optional<Player>& before) {
  if (!before || &before->lesson() != &player.lesson()) return false;
  const Erratum* const e = erratum(*before);
  return e && player.origin() == e->preset;
}

void fault_or_back(Player& player, std::optional<Player>& before) {
  const bool kept = can_return(player, before);
  if (kept && player.played().preset_id() == player.origin()) {  // the failure is on show
    player.return_as(std::move(*before));
    return before.reset();
  }
  if (!erratum(player)) return;
  Player now = player;
  show_erratum(player);
  if (!kept) before = std::move(now);
}

void way_back(Column& c, Player& player, std::optional<Player>& before) {
  if (!can_return(player, before)) return before.reset();
  constexpr float height = 34;
  c.y += 16;
  float x = c.x;
  const bool by_key = player.played().preset_id() == player.origin();
  const std::string words = "Back to step " + std::to_string(before->index() + 1) + ", where I was";
  const bool pressed = c.button("way back", words + (by_key ? " (E)" : ""), x);
  c.y += height;
  if (!pressed) return;
  player.return_as(std::move(*before));
  before.reset();
}

}  // namespace isect::viz
