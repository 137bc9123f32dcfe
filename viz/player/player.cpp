#include "viz/player/player.h"

#include <algorithm>

#include "viz/player/transition.h"
#include "viz/walk/closing.h"
#include "viz/walk/question_scene.h"

namespace isect::viz {
namespace {

constexpr double seconds_a_step = 1.6, seconds_to_read = 3.2;  ///< the latter to read why an answer was right
constexpr double seconds_to_light = 0.120;
constexpr std::size_t memories_kept = 100;

std::string matching_preset(const Lesson& lesson, const Parameters& parameters) {
  for (const Preset& p : lesson.presets)
    if (p.parameters == parameters) return p.id;
  return {};
}

/// Returns the variants with the titles of their walks, so that titles are written down in one place.
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

Player::Player(std::vector<const Lesson*> lessons, const ReaderState& at, bool reduced_motion)
    : lessons_(std::move(lessons)), reduced_motion_(reduced_motion), camera_(reduced_motion) {
  if (lessons_.empty()) throw BadInput("there is no lesson to show");
  ReaderState start = at;
  if (start.lesson.empty()) start.lesson = lessons_.front()->id;
  go(start);
  memory_.clear();
}

std::size_t Player::index_of(const std::string& lesson_id) const {
  const Lesson* found = &lesson_named(lessons_, lesson_id);
  return static_cast<std::size_t>(std::find(lessons_.begin(), lessons_.end(), found) - lessons_.begin());
}

std::shared_ptr<const Player::Overview> Player::overview_of(const Lesson& lesson, const Walk& walk,
                                                            const Parameters& parameters) {
  Overview overview;
  for (const Preset& p : lesson.presets) overview.samples.push_back(checked_walk(lesson, p.parameters));
  if (overview.samples.empty()) overview.samples.push_back(walk);
  overview.methods = methods_of(lesson, parameters);
  return std::make_shared<const Overview>(std::move(overview));
}

int Player::step_in(const Walk& walk, const State& state) {
  if (state.outcome) return outcome(walk);
  const auto same = std::ranges::find(walk.steps, state.slug, &Step::slug);
  if (same != walk.steps.end()) return static_cast<int>(same - walk.steps.begin());
  return std::min(state.wanted, outcome(walk));
}

void Player::show_step(int step) {
  at_ = step;
  while (walk_->prepare(step)) continue;
}

void Player::choose(int step) {
  show_step(step);
  state_.wanted = step;
  state_.slug = walk().steps[step].slug;
  state_.outcome = step == outcome(walk()) && step > 0;
  look();
}

/// Changes the state; nothing else does.
void Player::show(State next, bool same_lesson) {
  const Lesson& lesson = *lessons_[next.lesson];
  walk_ = std::make_shared<PlayedWalk>(lesson, next.parameters);
  ++walks_;
  if (!same_lesson) overview_ = overview_of(lesson, walk(), next.parameters), exercise_.reset();
  state_ = std::move(next);
  show_step(step_in(walk(), state_));
  opinions_ = lesson.opinions ? lesson.opinions(state_.parameters) : std::vector<Opinion>();
  preset_ = matching_preset(lesson, state_.parameters);
  asked_.clear();
  ask(asking_);
  before_.reset();
  ++revision_;
  if (same_lesson) return;
  moved_ = false;
  camera_.jump(opening_view());
}

std::vector<const Preset*> Player::group() const {
  std::vector<const Preset*> group;
  for (const Preset& p : lesson().presets)
    if (p.group == method()) group.push_back(&p);
  return group;
}

std::string Player::told_title(const Preset& preset) const {
  if (!asking_) return preset.title;
  const std::vector<const Preset*> all = group();
  const auto found = std::ranges::find(all, &preset);
  return found == all.end() ? "another preset" : "preset " + std::to_string(found - all.begin() + 1);
}

std::string Player::method() const {
  const auto found = parameters().find(lesson().group_by);
  return found == parameters().end() ? std::string() : std::get<std::string>(found->second);
}

ReaderState Player::reader_state() const { return {lesson().id, preset_, index(), parameters(), camera_.goal()}; }

void Player::go_to(int step) {
  begin_motion();
  ask(false);
  choose(std::clamp(step, 0, count() - 1));
  waited_ = 0;
  action_.clear();
  ++revision_;
}

void Player::begin_motion() {
  if (reduced_motion_) return;
  before_ = asking_ ? std::shared_ptr<const Scene>(asked_step_, &asked_step_->scene)
                    : std::shared_ptr<const Scene>(walk_, &step().scene);
  since_step_ = 0;
}

double Player::motion() const { return before_ ? eased(since_step_ / seconds_to_move) : 1; }
double Player::light() const { return reduced_motion_ ? 1 : eased(since_step_ / seconds_to_light); }

void Player::reduce_motion(bool reduced) {
  reduced_motion_ = reduced;
  camera_.reduce_motion(reduced);
  if (reduced) before_.reset();
}

void Player::arrive() {
  before_.reset();
  if (camera_.moving()) camera_.jump(camera_.goal());
}

void Player::ask(bool wanted) {
  asking_ = wanted && !at_end() && walk().steps[index() + 1].question;
  asked_step_ = asking_ ? std::make_shared<const Step>(asking_step(walk(), index() + 1)) : nullptr;
}

void Player::next() {
  if (at_end()) return;
  const int to = index() + 1;
  if (asking_) asked_[to] = std::nullopt;
  if (!walk().steps[to].question || asked_.contains(to)) return go_to(to);
  begin_motion();
  ask(true);
  look();
  ++revision_;
}

void Player::back() {
  if (!asking_) return go_to(index() - 1);
  begin_motion();
  ask(false);
  look();
  ++revision_;
}

void Player::toggle_play() {
  if (playing_ && asking_ && stops_) return next();
  if (!playing_ && at_end()) first();
  playing_ = !playing_;
  waited_ = 0;
}

double Player::seconds_to_step() const { return (seconds_a_step - waited_) / speed_; }
void Player::next_speed() { speed_ = speed_ >= 2 ? 0.5 : speed_ + 0.5; }
void Player::set_speed(double speed) { speed_ = std::clamp(speed, 0.5, 2.0); }

void Player::advance(double seconds) {
  camera_.advance(seconds);
  since_step_ += seconds;
  if (since_step_ >= seconds_to_move) before_.reset();
  if (!running()) return;
  waited_ += seconds * speed_;
  if (waited_ < seconds_a_step) return;
  waited_ = 0;
  if (!stops_) asked_.try_emplace(index() + 1);
  next();
  if (at_end()) playing_ = false;
}

const Question* Player::asked() const { return asking_ ? &*walk().steps[index() + 1].question : nullptr; }

void Player::answer(int choice) {
  if (!asking_ || choice < 0 || choice >= static_cast<int>(asked()->choices.size())) return;
  asked_[index() + 1] = choice;
  go_to(index() + 1);
  waited_ = -seconds_to_read;
}

std::optional<Player::Answered> Player::answered() const {
  const auto found = asked_.find(index());
  if (found == asked_.end() || !found->second) return std::nullopt;
  return Answered{&*step().question, *found->second};
}

void Player::ask_again(int step) {
  asked_.erase(step);
  go_to(step - 1);
  next();
}

const Erratum* Player::erratum() const {
  const Erratum* found = nullptr;
  for (const Erratum& e : lesson().errata) {
    const int line = line_of(e, walk());
    if (line >= 0 && line == step().line) return &e;
    if (line >= 0 && !found) found = &e;
  }
  return found;
}

void Player::show_erratum() {
  const Erratum* e = erratum();
  if (!e) return;
  load(preset(lesson(), e->preset));
  const int line = line_of(*e, walk());
  for (int i = 0; i < count(); ++i)
    if (walk().steps[i].line == line) return go_to(i);
  go_to(outcome(walk()));  // the line was refused on the way there
}

void Player::begin_exercise(int index) {
  const Exercise& e = lesson().closing->exercises.at(static_cast<std::size_t>(index));
  if (!e.preset.empty()) load(preset(lesson(), e.preset));
  go_to(outcome(walk()));
  exercise_ = index;
}

const Exercise* Player::exercise() const {
  return exercise_ ? &lesson().closing->exercises[static_cast<std::size_t>(*exercise_)] : nullptr;
}

bool Player::exercise_solved() const { return exercise() && exercise()->found && exercise()->found(parameters()); }

void Player::open(const Lesson& lesson) {
  ReaderState to;
  to.lesson = lesson.id;
  go(to);
}

void Player::open_neighbour(int by) {
  const int n = static_cast<int>(lessons_.size());
  open(*lessons_[((static_cast<int>(state_.lesson) + by) % n + n) % n]);
}

void Player::load(const Preset& preset) {
  all_or_nothing([&](Player& next) {
    next.remember("", true);
    State state = state_;
    state.parameters = preset.parameters;
    state.origin = preset.id;
    state.wanted = 0, state.slug.clear(), state.outcome = false;
    next.asking_ = false;
    next.show(std::move(state), true);
    if (!moved_) next.camera_.glide(next.opening_view());
  });
}

void Player::load_method(const std::string& choice) {
  all_or_nothing([&](Player& next) {
    next.remember("", true);
    State state = state_;
    state.parameters[lesson().group_by] = choice;
    state.wanted = 0, state.slug.clear(), state.outcome = false;
    next.asking_ = false;
    next.show(std::move(state), true);
    if (!preset_.empty() && !next.preset_.empty()) next.state_.origin = next.preset_;
  });
}

void Player::reread() {
  overview_ = overview_of(lesson(), walk(), parameters());
  preset_ = matching_preset(lesson(), parameters());
  if (!preset_.empty()) state_.origin = preset_;
  ++revision_;
}

void Player::restart() {
  all_or_nothing([&](Player& next) {
    next.remember("", true);
    const Lesson& l = lesson();
    State state = state_;
    if (!l.presets.empty()) state.parameters = preset(l, state_.origin).parameters;
    state.wanted = 0, state.slug.clear(), state.outcome = false;
    next.asking_ = next.playing_ = false;
    next.show(std::move(state), true);
    next.moved_ = false;
    next.camera_.glide(next.opening_view());
  });
}

void Player::set_parameters(Parameters parameters) {
  if (parameters == state_.parameters) return;
  all_or_nothing([&](Player& next) {
    State state = state_;
    state.parameters = std::move(parameters);
    next.show(std::move(state), true);
  });
}

void Player::edit(const std::string& name, const Setting& value) {
  if (std::ranges::find(lesson().parameters, name, &Parameter::name) == lesson().parameters.end())
    throw BadInput("lesson " + lesson().id + " has no parameter " + name);
  Parameters edited = parameters();
  viz::choose(lesson(), edited, name, value);
  set_parameters(std::move(edited));
}

const Condition* Player::drag_handle(const Handle& handle, const Vec3& to) {
  Parameters dragged = parameters();
  const Condition* forbids = drag(lesson(), dragged, handle, to);
  set_parameters(std::move(dragged));
  return forbids;
}

bool Player::methods_differ() const {
  return std::ranges::any_of(opinions_, [](const Opinion& o) { return !o.agrees; });
}

void Player::go_to_case(const Vec2& at) {
  const CaseMap& map = *lesson().map;
  Parameters moved = map.moved(parameters(), at.cwiseMax(map.lo).cwiseMin(map.hi));
  validate(lesson(), moved);
  set_parameters(std::move(moved));
}

void Player::go(const ReaderState& to) {
  State state;
  state.lesson = index_of(to.lesson);
  const Lesson& l = *lessons_[state.lesson];
  if (!l.presets.empty()) state.origin = l.presets.front().id;
  if (!to.preset.empty()) state.origin = preset(l, to.preset).id;
  if (to.parameters)
    state.parameters = *to.parameters;
  else if (!state.origin.empty())
    state.parameters = preset(l, state.origin).parameters;
  else
    for (const Parameter& p : l.parameters)
      if (!p.optional) state.parameters[p.name] = p.initial;

  all_or_nothing([&](Player& next) {
    if (walk_) next.remember("", true);
    next.show(std::move(state), false);
    next.asking_ = next.playing_ = false;
    next.go_to(to.step.value_or(0));
    if (!to.camera) return;
    next.camera_.jump(*to.camera);
    next.moved_ = true;
  });
}

void Player::remember(const std::string& action, bool with_step) {
  if (!action.empty() && action == action_) return;
  std::string name = action;  // what may throw comes first
  memory_.push_back({state_, camera_.goal(), moved_, with_step});
  if (memory_.size() > memories_kept) memory_.erase(memory_.begin());
  undone_.clear();
  action_ = std::move(name);
}

bool Player::travel(std::vector<Memory> Player::*from, std::vector<Memory> Player::*to) {
  if ((this->*from).empty()) return false;
  all_or_nothing([&](Player& next) {
    Memory last = std::move((next.*from).back());
    (next.*from).pop_back();
    (next.*to).push_back({state_, camera_.goal(), moved_, last.with_step});
    next.action_.clear();
    const bool same_lesson = last.state.lesson == state_.lesson;
    if (last.with_step)
      next.asking_ = false;
    else if (same_lesson)
      last.state.wanted = state_.wanted, last.state.slug = state_.slug, last.state.outcome = state_.outcome;
    next.show(std::move(last.state), same_lesson);
    next.camera_.glide(last.camera);
    next.moved_ = last.moved;
  });
  return true;
}

}  // namespace isect::viz
