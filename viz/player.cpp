#include "viz/player.h"

#include <algorithm>
#include <climits>

#include "viz/compose.h"

namespace isect::viz {
namespace {

constexpr double seconds_a_step = 1.6;
constexpr std::size_t memories_kept = 100;
constexpr int the_last = INT_MAX;

Walk walk_of(const Lesson& lesson, const Parameters& parameters) {
  validate(lesson, parameters);
  Walk walk = lesson.walk(parameters);
  if (walk.steps.empty()) throw BadInput("lesson " + lesson.id + " has no step for these parameters");
  return walk;
}

std::string matching_preset(const Lesson& lesson, const Parameters& parameters) {
  for (const Preset& p : lesson.presets)
    if (p.parameters == parameters) return p.id;
  return {};
}

std::vector<const Scene*> scenes_of(const Walk& walk) {
  std::vector<const Scene*> scenes;
  for (const Step& s : walk.steps) scenes.push_back(&s.scene);
  return scenes;
}

/// The titles of the variants come from their walks, so that they are written down in one place.
std::vector<Method> methods_of(const Lesson& lesson, Parameters parameters) {
  std::vector<Method> methods;
  for (const Parameter& p : lesson.parameters) {
    if (p.name != lesson.group_by) continue;
    for (const std::string& choice : p.choices) {
      parameters[p.name] = choice;
      const std::string title = lesson.walk(parameters).method;
      methods.push_back({choice, title.empty() ? choice : title});
    }
  }
  return methods;
}

}  // namespace

Player::Player(std::vector<const Lesson*> lessons, const Place& at, bool reduced_motion)
    : lessons_(std::move(lessons)), camera_(reduced_motion) {
  if (lessons_.empty()) throw BadInput("there is no lesson to show");
  Place start = at;
  if (start.lesson.empty()) start.lesson = lessons_.front()->id;
  go(start);
  memory_.clear();
}

std::size_t Player::index_of(const std::string& lesson_id) const {
  const Lesson* found = &lesson_named(lessons_, lesson_id);
  return static_cast<std::size_t>(std::find(lessons_.begin(), lessons_.end(), found) - lessons_.begin());
}

/// The one way the state changes: first everything that may be refused, then the change.
void Player::show(State next, bool same_lesson) {
  const Lesson& lesson = *lessons_[next.lesson];
  Walk walk = walk_of(lesson, next.parameters);
  if (!same_lesson) {
    std::vector<Walk> samples;
    for (const Preset& p : lesson.presets) samples.push_back(walk_of(lesson, p.parameters));
    if (samples.empty()) samples.push_back(walk);
    samples_ = std::move(samples);
    methods_ = methods_of(lesson, next.parameters);
  }
  state_ = std::move(next);
  walk_ = std::move(walk);
  opinions_ = lesson.opinions ? lesson.opinions(state_.parameters) : std::vector<Opinion>();
  preset_ = matching_preset(lesson, state_.parameters);
  asked_.clear();
  asking_ = asking_ && !at_end() && walk_.steps[index() + 1].question;
  ++revision_;
  if (same_lesson) return;
  moved_ = false;
  camera_.jump(opening_view());
}

Camera Player::opening_view() const { return frame_alike(lesson().camera, walk_, samples_, aspect_); }

std::vector<const Preset*> Player::group() const {
  std::vector<const Preset*> group;
  for (const Preset& p : lesson().presets)
    if (p.group == method()) group.push_back(&p);
  return group;
}

std::string Player::method() const {
  const auto found = parameters().find(lesson().group_by);
  return found == parameters().end() ? std::string() : std::get<std::string>(found->second);
}

Place Player::place() const { return {lesson().id, preset_, index(), parameters(), camera_.goal()}; }

void Player::go_to(int step) {
  step = std::clamp(step, 0, count() - 1);
  state_.wanted = step + 1 == count() && count() > 1 ? the_last : step;
  asking_ = false;
  waited_ = 0;
  action_.clear();
  ++revision_;
}

void Player::next() {
  if (at_end()) return;
  const int to = index() + 1;
  if (asking_) asked_[to] = std::nullopt;
  if (!walk_.steps[to].question || asked_.contains(to)) return go_to(to);
  asking_ = true;
  ++revision_;
}

void Player::back() {
  if (!asking_) return go_to(index() - 1);
  asking_ = false;
  ++revision_;
}

void Player::toggle_play() {
  if (!playing_ && at_end()) first();
  playing_ = !playing_;
  waited_ = 0;
}

void Player::next_speed() { speed_ = speed_ >= 2 ? 0.5 : speed_ + 0.5; }
void Player::set_speed(double speed) { speed_ = std::clamp(speed, 0.5, 2.0); }

void Player::advance(double seconds) {
  camera_.advance(seconds);
  if (!playing_ || asking_) return;
  waited_ += seconds * speed_;
  if (waited_ < seconds_a_step) return;
  waited_ = 0;
  next();
  if (at_end()) playing_ = false;
}

const Question* Player::asked() const { return asking_ ? &*walk_.steps[index() + 1].question : nullptr; }

void Player::answer(int choice) {
  if (!asking_ || choice < 0 || choice >= static_cast<int>(asked()->choices.size())) return;
  asked_[index() + 1] = choice;
  go_to(index() + 1);
}

std::optional<Player::Answered> Player::answered() const {
  const auto found = asked_.find(index());
  if (found == asked_.end() || !found->second) return std::nullopt;
  return Answered{&*step().question, *found->second};
}

void Player::open(const Lesson& lesson) {
  Place place;
  place.lesson = lesson.id;
  go(place);
}

void Player::open_neighbour(int by) {
  const int n = static_cast<int>(lessons_.size());
  open(*lessons_[((static_cast<int>(state_.lesson) + by) % n + n) % n]);
}

void Player::load(const Preset& preset) {
  remember("");
  State next = state_;
  next.parameters = preset.parameters;
  next.origin = preset.id;
  next.wanted = 0;
  asking_ = false;
  show(std::move(next), true);
  if (!moved_) camera_.glide(opening_view());
}

void Player::load_method(const std::string& choice) {
  remember("");
  const bool was_preset = !preset_.empty();
  Parameters same = parameters();
  same[lesson().group_by] = choice;
  State next = state_;
  next.parameters = std::move(same);
  next.wanted = 0;
  asking_ = false;
  show(std::move(next), true);
  if (was_preset && !preset_.empty()) state_.origin = preset_;
}

void Player::restart() {
  remember("");
  const Lesson& l = lesson();
  State next = state_;
  if (!l.presets.empty()) next.parameters = preset(l, state_.origin).parameters;
  next.wanted = 0;
  asking_ = playing_ = false;
  show(std::move(next), true);
  moved_ = false;
  camera_.glide(opening_view());
}

void Player::edit(const std::string& name, const Setting& value) {
  if (!parameters().contains(name)) throw BadInput("lesson " + lesson().id + " has no parameter " + name);
  if (parameters().at(name) == value) return;
  State next = state_;
  next.parameters[name] = value;
  show(std::move(next), true);
}

void Player::drag_handle(const Handle& handle, const Vec3& to) {
  State next = state_;
  drag(lesson(), next.parameters, handle, to);
  if (next.parameters != state_.parameters) show(std::move(next), true);
}

bool Player::methods_differ() const {
  return std::ranges::any_of(opinions_, [](const Opinion& o) { return !o.agrees; });
}

void Player::go_to_case(const Vec2& at) {
  const CaseMap& map = *lesson().map;
  State next = state_;
  next.parameters = map.moved(parameters(), at.cwiseMax(map.lo).cwiseMin(map.hi));
  validate(lesson(), next.parameters);
  if (next.parameters != state_.parameters) show(std::move(next), true);
}

void Player::go(const Place& place) {
  State next;
  next.lesson = index_of(place.lesson);
  const Lesson& l = *lessons_[next.lesson];
  if (!l.presets.empty()) next.origin = l.presets.front().id;
  if (!place.preset.empty()) next.origin = preset(l, place.preset).id;
  if (place.parameters)
    next.parameters = *place.parameters;
  else if (!next.origin.empty())
    next.parameters = preset(l, next.origin).parameters;
  else
    for (const Parameter& p : l.parameters) next.parameters[p.name] = p.initial;

  const bool starting = walk_.steps.empty();
  if (!starting) remember("");
  try {
    show(std::move(next), false);
  } catch (...) {
    if (!starting) memory_.pop_back();
    throw;
  }
  asking_ = playing_ = false;
  go_to(place.step);
  if (!place.camera) return;
  camera_.jump(*place.camera);
  moved_ = true;
}

void Player::set_aspect(double aspect) {
  if (aspect == aspect_) return;
  aspect_ = aspect;
  if (!moved_) camera_.jump(opening_view());
}

void Player::orbit(const Vec2& pixels) {
  if (lesson().flat) return;
  remember("orbit");
  camera_.orbit(pixels);
  moved_ = true;
}

void Player::pan(const View& view, const Vec2& from, const Vec2& to) {
  remember("pan");
  camera_.pan(view, from, to);
  moved_ = true;
}

void Player::zoom(const View& view, const Vec2& at, double factor) {
  remember("zoom");
  camera_.zoom(view, at, factor);
  moved_ = true;
}

void Player::frame_all() {
  remember("");
  Camera from = lesson().camera;
  from.perspective = camera_.goal().perspective;
  camera_.glide(frame(from, scenes_of(walk_), aspect_));
  moved_ = true;
}

void Player::set_perspective(bool on) {
  if (lesson().flat || camera_.goal().perspective == on) return;
  remember("");
  camera_.set_perspective(on);
  moved_ = true;
}

void Player::remember(const std::string& action) {
  if (!action.empty() && action == action_) return;
  action_ = action;
  memory_.push_back({state_, camera_.goal(), moved_});
  if (memory_.size() > memories_kept) memory_.erase(memory_.begin());
}

bool Player::undo() {
  if (memory_.empty()) return false;
  const Memory last = memory_.back();
  memory_.pop_back();
  action_.clear();
  const bool same_lesson = last.state.lesson == state_.lesson;
  asking_ = false;
  show(last.state, same_lesson);
  camera_.glide(last.camera);
  moved_ = last.moved;
  return true;
}

}  // namespace isect::viz
