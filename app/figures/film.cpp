#include "app/figures/film.h"

#include "app/figures/figure_maker.h"
#include "viz/chart/chart.h"
#include "viz/player/transition.h"

namespace isect::program {

namespace {

constexpr int pictures_between = 12;
constexpr double seconds_between = 0.04;  ///< each of them: 25 pictures a second
constexpr int card_as_long = 4;

bool camera_moves(const Excerpt& e, int from, int to) {
  const viz::Step &a = e.walk.steps[from], &b = e.walk.steps[to];
  if (e.scaled_with || !(a.view || b.view) || !viz::may_move(a.scene, b.scene)) return false;
  constexpr double any_aspect = 1.6;
  return !(camera_for(e, a, any_aspect) == camera_for(e, b, any_aspect));
}

}  // namespace

std::vector<Shot> shots_of(const std::vector<int>& steps) {
  std::vector<Shot> shots;
  for (const int step : steps) shots.push_back({.step = step, .from = step});
  return shots;
}

std::vector<Shot> film_of(const Excerpt& e, const std::vector<int>& steps, double seconds) {
  std::vector<Shot> shots;
  for (const int step : steps) {
    const int before = shots.empty() ? step : shots.back().step;
    if (before != step && camera_moves(e, before, step))
      for (int i = 1; i <= pictures_between; ++i)
        shots.push_back({step, before, static_cast<double>(i) / (pictures_between + 1), seconds_between});
    shots.push_back({step, step, 1, seconds, viz::is_card(e.walk.steps[step].scene) ? card_as_long : 1});
  }
  return shots;
}

}  // namespace isect::program
