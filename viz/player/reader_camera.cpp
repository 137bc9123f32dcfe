#include "viz/player/reader_camera.h"

#include <utility>

#include "viz/compose/compose.h"

namespace isect::viz {
namespace {

std::vector<const Scene*> scenes_of(const Walk& walk) {
  std::vector<const Scene*> scenes;
  for (const Step& s : walk.steps) scenes.push_back(&s.scene);
  return scenes;
}

}  // namespace

Camera ReaderCamera::opening(const PlayedWalk& played, const std::optional<StepView>& own, const Scene& shown,
                             std::optional<bool> perspective) const {
  Camera view = viz::opening(played.lesson(), own);
  view.perspective = perspective.value_or(view.perspective);
  if (!beside_) return placed(own, closer(frame_alike(view, played.walk(), played.samples(), aspect_), shown, aspect_));
  std::vector<const Scene*> scenes = scenes_of(played.walk());
  for (const Scene* scene : scenes_of(*beside_)) scenes.push_back(scene);
  return placed(own, viz::frame(view, scenes, aspect_));
}

Camera ReaderCamera::whole(const PlayedWalk& played, const std::optional<StepView>& own,
                           const std::vector<const Scene*>& more) const {
  Camera from = viz::opening(played.lesson(), own);
  from.perspective = goal().perspective;
  std::vector<const Scene*> scenes = scenes_of(played.walk());
  scenes.insert(scenes.end(), more.begin(), more.end());
  return viz::frame(from, scenes, aspect_);
}

bool ReaderCamera::has_in_view(const Camera& view, const Scene& scene) const {
  const Box2 all = extent(scene.items, view), middle = extent({Dot{view.target}}, view);
  const Vec2 room(view.half_height * aspect_, view.half_height), lo = all.lo - middle.lo, hi = all.hi - middle.lo;
  return (lo.array() >= -room.array()).all() && (hi.array() <= room.array()).all();
}

Camera ReaderCamera::holding(const Scene& shown) const {
  Scene all = shown;
  for (const Handle& h : shown.handles) all.items.emplace_back(Dot{h.at});
  return viz::frame(goal(), {&all}, aspect_);
}

bool ReaderCamera::accompany(std::shared_ptr<const Walk> other) {
  const bool anew = (other == nullptr) != (beside_ == nullptr);
  beside_ = std::move(other);
  return anew;
}

void ReaderCamera::arrive() {
  if (moving()) rig_.jump(goal());
}

void ReaderCamera::jump(const Camera& camera, bool moved) {
  rig_.jump(camera);
  moved_ = moved;
}

void ReaderCamera::glide(const Camera& camera, bool moved, double seconds) {
  rig_.glide(camera, seconds);
  moved_ = moved;
}

void ReaderCamera::move(const std::function<void(CameraRig&)>& move) {
  move(rig_);
  moved_ = true;
}

void ReaderCamera::take(const ReaderCamera& other) {
  rig_ = other.rig_;
  moved_ = true;
}

}  // namespace isect::viz
