#include "viz/player/map_beside.h"

#include <algorithm>

#include "viz/chart/case_map.h"
#include "viz/walk/closing.h"

namespace isect::viz {
namespace {

/// Whether there is no room for all names; then regions too small for theirs have none: the setting's own name stands
/// beside the map, and a pane shows any other under the pointer.
bool crowded(const Cases& cases, const std::vector<PlacedLabel>& labels, double plane_height) {
  const auto is_name = [&](const PlacedLabel& l) { return std::ranges::count(cases.branches, l.text) > 0; };
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (is_name(labels[i]) && labels[i].leads_to && plane_height < 180) return true;
    for (std::size_t k = 0; k < i; ++k) {
      const TextBox &a = labels[i].box, &b = labels[k].box;
      const bool meet = a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
      if (meet && (is_name(labels[i]) || is_name(labels[k]))) return true;
    }
  }
  return false;
}

}  // namespace

Composed compose_map(const Cases& all, const Vec2& corner, double width, double height, const Theme& theme) {
  Cases cases = all;
  Composed composed = compose({cases}, corner, width, height, theme);
  const Box2 plane = plane_of(cases, corner, width, height, theme);
  if (!crowded(cases, composed.labels, plane.hi.y() - plane.lo.y())) return composed;
  cases.named = Cases::Named::within;
  composed = compose({cases}, corner, width, height, theme);
  if (!crowded(cases, composed.labels, plane.hi.y() - plane.lo.y())) return composed;
  cases.named = Cases::Named::none;
  return compose({cases}, corner, width, height, theme);
}

Vec2 case_at(const Cases& cases, const Box2& plane, const Vec2& pixel) {
  const Vec2 share = (pixel - plane.lo).cwiseQuotient(plane.hi - plane.lo);
  return {cases.x.lo + share.x() * (cases.x.hi - cases.x.lo), cases.y.hi - share.y() * (cases.y.hi - cases.y.lo)};
}

Vec2 pixel_of(const Cases& cases, const Box2& plane, const Vec2& at) {
  const Vec2 share((at.x() - cases.x.lo) / (cases.x.hi - cases.x.lo),
                   (cases.y.hi - at.y()) / (cases.y.hi - cases.y.lo));
  return plane.lo + share.cwiseProduct(plane.hi - plane.lo);
}

bool waits_for_answer(const Player& player) {
  if (player.quiz().asked()) return true;
  const std::vector<Step>& steps = player.walk().steps;
  for (int i = player.index() + 1; i <= outcome(player.walk()); ++i)
    if (steps[static_cast<std::size_t>(i)].question && !player.quiz().is_past(i)) return true;
  return false;
}

const Cases& MapBeside::find(const Player& player) {
  const CaseMap& map = *player.lesson().map;
  const Parameters elsewhere = map.moved(player.parameters(), (map.lo + map.hi) / 2);
  if (lesson_ != &player.lesson() || elsewhere != elsewhere_) {
    cases_ = std::get<Cases>(case_map(player.lesson(), player.parameters()).kind);
    lesson_ = &player.lesson(), elsewhere_ = elsewhere;
    ++found_;
  }
  cases_.here = player.quiz().asked() ? std::nullopt : spot_on(map, player.parameters());
  return cases_;
}

Moved drag_on_map(Player& player, const Vec2& start, const Vec2& to, bool snapping) {
  const auto go = [to](Player& moved) {
    moved.go_to_case(to);
    return Moved{};
  };
  if (!snapping) return go(player);
  const Way way = way_of(player.lesson(), player.parameters(), start, to);
  return Snap(BorderSearch(player.lesson(), way, 0, 1.25, 1), go).settle(player);
}

}  // namespace isect::viz
