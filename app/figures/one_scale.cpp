#include "app/figures/one_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/figures/ownership.h"
#include "viz/compose/compose.h"

namespace isect::program {

namespace {

constexpr double label_room = 0.1;    ///< free on all sides, for labels; a share of the height
constexpr double least_share = 0.02;  ///< of the common height that one setting takes, at least
constexpr double no_extent = 2.0e-6;  ///< half the height that a single point is framed with, or somewhat more

double in_degrees(double radians) { return radians * 180 / std::numbers::pi; }

/// Returns the direction in which a step is seen, and its place as far as the preset's file or the step says it.
viz::StepView seen_as(const Excerpt& e, const viz::Step& step) {
  if (e.camera) return {*e.camera, true, true};
  return step.view.value_or(viz::StepView{viz::opening(*e.lesson)});
}

}  // namespace

OneScale::OneScale(Excerpts all) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Excerpt& e = all[i];
    const std::size_t first = cases_.size();
    for (const int step : e.steps) {
      const viz::Step& s = e.walk.steps[static_cast<std::size_t>(step)];
      walk_.steps.push_back(s);
      const viz::StepView seen = seen_as(e, s);
      if (cases_.size() == first || !(cases_.back().seen == seen)) cases_.push_back({&e, i, {}, seen});
      if (!s.scene.chart && !s.scene.items.empty()) cases_.back().scenes.push_back(&s.scene);
      cases_.back().end = static_cast<int>(walk_.steps.size());
    }
  }
  const Case* perspective = nullptr;
  for (const Case& one : cases_) {
    const viz::Camera& seen = one.seen.camera;
    if (!seen.perspective) continue;
    if (!perspective) perspective = &one;
    const double first = perspective->seen.camera.field_of_view;
    if (seen.field_of_view != first)
      throw viz::BadInput(fmt::format(
          "camera: {} has a field of view of {:.4g} degrees, and {} of {:.4g}; at one scale and one "
          "distance all have the same",
          folder_of(*perspective->e), in_degrees(first), folder_of(*one.e), in_degrees(seen.field_of_view)));
  }
}

std::size_t OneScale::place_of(int step) const {
  std::size_t i = 0;
  while (step >= cases_[i].end) ++i;
  return i;
}

std::size_t OneScale::case_of(int step) const { return cases_[place_of(step)].setting; }

double OneScale::shape() const {
  viz::Vec2 largest = viz::Vec2::Zero();
  for (const Case& one : cases_) {
    viz::Box2 all = {viz::Vec2::Constant(INFINITY), viz::Vec2::Constant(-INFINITY)};
    for (const viz::Scene* scene : one.scenes) {
      const viz::Box2 box = viz::extent(scene->items, one.seen.camera);
      all = {all.lo.cwiseMin(box.lo), all.hi.cwiseMax(box.hi)};
    }
    if (all.lo.x() <= all.hi.x()) largest = largest.cwiseMax(all.hi - all.lo);
  }
  return largest.y() > 0 ? largest.x() / largest.y() : INFINITY;
}

const viz::Camera& OneScale::camera(int step, double aspect) const {
  const auto [found, is_new] = known_.try_emplace(aspect);
  if (is_new) found->second = cameras(aspect);
  return found->second[place_of(step)];
}

std::vector<viz::Camera> OneScale::cameras(double aspect) const {
  std::vector<viz::Camera> all;
  std::vector<double> half_heights;
  for (const Case& one : cases_) {
    all.push_back(viz::placed(one.seen, viz::frame(one.seen.camera, one.scenes, aspect, label_room)));
    half_heights.push_back(one.scenes.empty() ? 0 : all.back().half_height);
  }
  const double common = *std::ranges::max_element(half_heights);
  require_all_visible(half_heights, common);
  if (common > 0)
    for (viz::Camera& camera : all) camera.half_height = common;
  return all;
}

void OneScale::require_all_visible(const std::vector<double>& half_heights, double common) const {
  const auto largest = static_cast<std::size_t>(std::ranges::find(half_heights, common) - half_heights.begin());
  for (std::size_t i = 0; i < cases_.size(); ++i)
    if (half_heights[i] > no_extent && half_heights[i] < least_share * common)
      throw viz::BadInput(
          fmt::format("preset: {} and {} have no common scale: the one is {:.0f} times as large as the other, which "
                      "would be too small to see; draw them apart",
                      folder_of(*cases_[largest].e), folder_of(*cases_[i].e), common / half_heights[i]));
}

}  // namespace isect::program
