#include "viz/player/player.h"

#include <algorithm>

#include "viz/walk/closing.h"

namespace isect::viz {

Player::Player(std::vector<const Lesson*> lessons, const ReaderState& at, bool reduced_motion)
    : lessons_(std::move(lessons)), motion_(reduced_motion), camera_(reduced_motion) {
  if (lessons_.empty()) throw BadInput("there is no lesson to show");
  ReaderState start = at;
  if (start.lesson.empty()) start.lesson = lessons_.front()->id;
  go(start);
  history_ = {};
}

std::size_t Player::index_of(const std::string& lesson_id) const {
  const Lesson* found = &lesson_named(lessons_, lesson_id);
  return static_cast<std::size_t>(std::find(lessons_.begin(), lessons_.end(), found) - lessons_.begin());
}

int Player::step_in(const Walk& walk, const Chosen& chosen) {
  if (chosen.outcome) return outcome(walk);
  const auto same = std::ranges::find(walk.steps, chosen.slug, &Step::slug);
  if (same != walk.steps.end()) return static_cast<int>(same - walk.steps.begin());
  return std::min(chosen.step, outcome(walk));
}

void Player::show_step(int step) {
  leave_time();
  at_ = step;
  while (played_->prepare(step)) continue;
  quiz_.show(walk(), step);
}

void Player::choose(int step) {
  show_step(step);
  chosen_.step = step;
  chosen_.slug = walk().steps[step].slug;
  chosen_.outcome = step == outcome(walk()) && step > 0;
  look(seconds_to_move);
}

/// Changes the lesson or its parameters; nothing else does.
void Player::show(Chosen next, bool same_lesson) {
  if (!next.version) next.version = lessons_[next.lesson];
  lessons_[next.lesson] = next.version;
  const Lesson& lesson = *next.version;
  const bool same_version = same_lesson && &played_->lesson() == &lesson;
  const bool asks = quiz_.asked(), chooses = asks && !quiz_.asks_more();
  quiz_ = {};
  played_ = std::make_shared<PlayedWalk>(lesson, next.parameters, same_version ? played_->overview() : nullptr);
  ++walks_;
  chosen_ = std::move(next);
  show_step(step_in(walk(), chosen_));
  ask(asks);
  if (chooses) quiz_.show_choices();
  motion_.end();
  ++revision_;
  if (same_version) return;
  exercise_.reset();
  if (same_lesson) return;
  camera_.pin(false);
  camera_.forget_projection();
  camera_.jump(opening_view(), false);
}

std::string Player::told_title(const Preset& preset, bool question_ahead) const {
  if (!quiz_.asked() && !question_ahead) return preset.title;
  const std::vector<const Preset*> all = played_->group();
  const auto found = std::ranges::find(all, &preset);
  return found == all.end() ? "another preset" : "preset " + std::to_string(found - all.begin() + 1);
}

ReaderState Player::reader_state() const {
  return {lesson().id, played_->preset_id(), index(), parameters(), camera_.goal(), {}, now_};
}

void Player::go_to(int step) {
  begin_motion();
  ask(false);
  choose(std::clamp(step, 0, count() - 1));
  clock_.begin_step();
  history_.end_action();
  ++revision_;
}

void Player::begin_motion() {
  if (posed_)
    motion_.begin(posed_);
  else if (quiz_.asked())
    motion_.begin({quiz_.asking_step(), &shown().scene});
  else
    motion_.begin({played_, &shown().scene});
}

void Player::reduce_motion(bool reduced) {
  motion_.reduce(reduced);
  camera_.reduce_motion(reduced);
}

void Player::arrive() {
  motion_.end();
  camera_.arrive();
}

void Player::look(double seconds) {
  if (!camera_.moved()) camera_.glide(framed_view(), false, seconds);
}

void Player::turn_to(const Camera& view) {
  if (!camera_.pinned()) camera_.glide(view, false);
}

void Player::ask(bool wanted) {
  leave_time();
  if (wanted && can_ask())
    quiz_.ask(walk(), index() + 1);
  else
    quiz_.close();
}

void Player::next() {
  if (at_end()) return;
  const int to = index() + 1;
  const bool skips = quiz_.asked() != nullptr;
  if (skips) quiz_.skip(to);
  if (skips || !can_ask() || quiz_.is_answered(to)) return go_to(to);
  begin_motion();
  ask(true);
  look(seconds_to_move);
  history_.end_action();
  ++revision_;
}

void Player::back() {
  if (!quiz_.asked()) return go_to(index() - 1);
  begin_motion();
  ask(false);
  look(seconds_to_move);
  ++revision_;
}

bool Player::tells_title(int step) const { return step <= index() || (!quiz_.asked() && !walk().steps[step].question); }

void Player::answer(int choice) {
  const Question* asked = quiz_.asked();
  if (!asked || choice < 0 || choice >= static_cast<int>(asked->choices.size())) return;
  answer(GivenAnswer{choice});
}

void Player::answer(GivenAnswer given) {
  quiz_.keep(index() + 1, std::move(given));
  ++answers_;
  go_to(index() + 1);
  clock_.begin_answered_step();
}

void Player::answer_typed(const std::string& text) {
  if (quiz_.asks_more()) answer(answer_from(walk(), index() + 1, text));
}

void Player::answer_line(int line) {
  if (quiz_.wants_line()) answer(pointed_at(*quiz_.asked(), line));
}

void Player::show_choices() {
  if (!quiz_.asks_more()) return;
  quiz_.show_choices();
  ++revision_;
}

void Player::ask_again(int step) {
  quiz_.forget(step);
  go_to(step - 1);
  next();
}

void Player::toggle_play() {
  time_runs_ = false;
  if (clock_.playing() && !running()) return next();
  if (!clock_.playing() && at_end()) first();
  clock_.play(!clock_.playing());
}

void Player::advance(double seconds) {
  camera_.advance(seconds);
  motion_.advance(seconds);
  let_time_run(seconds);
  if (!running() || !clock_.advance(seconds)) return;
  const bool passes = !clock_.stops_at_questions() && can_ask();
  if (passes) quiz_.skip(index() + 1);
  passes ? go_to(index() + 1) : next();
  if (at_end()) clock_.play(false);
}

const Exercise* Player::exercise() const {
  return exercise_ ? &lesson().closing->exercises[static_cast<std::size_t>(*exercise_)] : nullptr;
}

void Player::open(const Lesson& lesson) {
  ReaderState to;
  to.lesson = lesson.id;
  go(to);
}

void Player::open_neighbour(int by) {
  const int n = static_cast<int>(lessons_.size());
  open(*lessons_[((static_cast<int>(chosen_.lesson) + by) % n + n) % n]);
}

void Player::load(const Preset& preset) {
  all_or_nothing([&](Player& next) {
    next.remember("", true);
    Chosen chosen = chosen_;
    chosen.parameters = preset.parameters;
    chosen.origin = preset.id;
    chosen.choose_first_step();
    next.quiz_.close();
    next.show(std::move(chosen), true);
    next.turn_to(next.framed_view());
  });
}

void Player::load_method(const std::string& choice) {
  all_or_nothing([&](Player& next) {
    next.remember("", true);
    Chosen chosen = chosen_;
    chosen.parameters[lesson().group_by] = choice;
    next.quiz_.close();
    next.show(std::move(chosen), true);
    next.look();
    const std::string &before = played_->preset_id(), &now = next.played_->preset_id();
    if (!before.empty() && !now.empty()) next.chosen_.origin = now;
  });
}

void Player::reread() {
  played_->reread();
  if (!played_->preset_id().empty()) chosen_.origin = played_->preset_id();
  ++revision_;
}

void Player::show_version(const Lesson& version, bool leaves_step) {
  all_or_nothing([&](Player& next) {
    next.remember("", leaves_step);
    Chosen chosen = chosen_;
    chosen.version = &version;
    chosen.parameters = version.presets.front().parameters;
    chosen.origin = version.presets.front().id;
    next.quiz_.close();
    next.show(std::move(chosen), true);
  });
}

void Player::restart() {
  all_or_nothing([&](Player& next) {
    next.remember("", true);
    const Lesson& l = lesson();
    Chosen chosen = chosen_;
    if (!l.presets.empty()) chosen.parameters = preset(l, chosen_.origin).parameters;
    chosen.choose_first_step();
    next.quiz_.close();
    next.clock_.play(false);
    next.show(std::move(chosen), true);
    next.turn_to(next.opening_view());
  });
}

void Player::set_parameters(Parameters parameters) {
  if (parameters == chosen_.parameters) return;
  all_or_nothing([&](Player& next) {
    Chosen chosen = chosen_;
    chosen.parameters = std::move(parameters);
    next.show(std::move(chosen), true);
    next.keep_time(*this);
    if (quiz_.asked() && !next.quiz_.asked()) next.history_.loses_place();
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

void Player::go_to_case(const Vec2& at) {
  const CaseMap& map = *lesson().map;
  Parameters moved = map.moved(parameters(), at.cwiseMax(map.lo).cwiseMin(map.hi));
  validate(lesson(), moved);
  set_parameters(std::move(moved));
}

void Player::go(const ReaderState& to) {
  Chosen chosen;
  chosen.lesson = index_of(to.lesson);
  const Lesson& l = *lessons_[chosen.lesson];
  if (!l.presets.empty()) chosen.origin = l.presets.front().id;
  if (!to.preset.empty()) chosen.origin = preset(l, to.preset).id;
  if (to.parameters)
    chosen.parameters = *to.parameters;
  else if (!chosen.origin.empty())
    chosen.parameters = preset(l, chosen.origin).parameters;
  else
    for (const Parameter& p : l.parameters)
      if (!p.optional) chosen.parameters[p.name] = p.initial;

  all_or_nothing([&](Player& next) {
    if (played_) next.remember("", true);
    next.show(std::move(chosen), false);
    next.quiz_.close();
    next.clock_.play(false);
    next.go_to(to.step.value_or(0));
    if (to.time) next.set_time(*to.time);
    if (to.camera)
      next.camera_.jump(*to.camera, true);
    else if (to.time)
      next.camera_.jump(next.framed_view(), false);
  });
}

void Player::return_as(Player kept) {
  kept.revision_ = revision_ + 1, kept.walks_ = walks_ + 1, kept.answers_ = answers_;
  *this = std::move(kept);
}

void Player::set_aspect(double aspect) {
  if (aspect == camera_.aspect()) return;
  all_or_nothing([&](Player& next) {
    next.camera_.set_aspect(aspect);
    if (!camera_.moved()) next.camera_.jump(next.framed_view(), false);
  });
}

void Player::move_camera(const std::string& action, const std::function<void(CameraRig&)>& move) {
  remember(action);
  camera_.move(move);
}

void Player::frame(const Camera& camera) {
  remember("");
  camera_.glide(camera, false);
}

void Player::remember(const std::string& action, bool with_step) {
  if (history_.goes_on(action)) return;
  Memory now = memory();
  now.with_step = with_step;
  history_.remember(action, std::move(now));
}

bool Player::undo() {
  if (!history_.can_undo()) return false;
  all_or_nothing([&](Player& next) { next.return_to(next.history_.undo(memory())); });
  return true;
}

bool Player::redo() {
  if (!history_.can_redo()) return false;
  all_or_nothing([&](Player& next) { next.return_to(next.history_.redo(memory())); });
  return true;
}

void Player::return_to(Memory last) {
  const bool same_lesson = last.chosen.lesson == chosen_.lesson;
  if (last.with_step)
    quiz_.close();
  else if (same_lesson)
    last.chosen.choose_step(chosen_);
  show(std::move(last.chosen), same_lesson);
  if (last.with_step) {
    ask(last.asked);
    if (last.chooses) quiz_.show_choices();
  }
  camera_.glide(last.camera, last.moved);
}

}  // namespace isect::viz
