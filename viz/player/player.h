#pragma once
// What the window shows, and what a reader's actions do to it. It uses no ImGui and no OpenGL, so that tests can drive
// it directly. Its parts stand in files of their own; here is what ties them together.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "viz/lesson.h"
#include "viz/player/history.h"
#include "viz/player/play_clock.h"
#include "viz/player/played_walk.h"
#include "viz/player/quiz.h"
#include "viz/player/reader_camera.h"
#include "viz/player/reader_state.h"
#include "viz/player/step_motion.h"

namespace isect::viz {

class Player {
 public:
  /// Starts paused at `at`; an empty place is the first lesson with its first preset. Throws BadInput.
  explicit Player(std::vector<const Lesson*>, const ReaderState& at = {}, bool reduced_motion = false);

  const PlayedWalk& played() const { return *played_; }
  const Quiz& quiz() const { return quiz_; }
  const PlayClock& clock() const { return clock_; }
  PlayClock& clock() { return clock_; }
  const StepMotion& motion() const { return motion_; }
  const ReaderCamera& camera() const { return camera_; }
  const History& history() const { return history_; }

  const std::vector<const Lesson*>& lessons() const { return lessons_; }
  const Lesson& lesson() const { return *lessons_[chosen_.lesson]; }
  const Parameters& parameters() const { return chosen_.parameters; }
  const Walk& walk() const { return played_->walk(); }
  int count() const { return static_cast<int>(walk().steps.size()); }
  int index() const { return at_; }
  /// Returns the last step that was told.
  const Step& step() const { return walk().steps[index()]; }
  /// Returns step() or, while a question is open, what is known of the step that it asks about.
  const Step& shown() const { return quiz_.asked() ? *quiz_.asking_step() : step(); }
  /// Returns the scene that is drawn.
  const Scene& scene() const { return arranged_ ? *arranged_ : own_scene(); }
  /// Returns that scene in the lesson's own arrangement: at the time that is chosen, if one is.
  const Scene& own_scene() const { return posed_ ? *posed_ : shown().scene; }
  /// Draws the scene on show in another arrangement (viz/compose/small_multiples.h) until another one is on show; null:
  /// in its own. Figures, copied states and the camera know nothing of it.
  void arrange(std::shared_ptr<const Scene> arranged) { arranged_ = std::move(arranged); }
  bool is_arranged() const { return arranged_ != nullptr; }
  /// Returns a preset's title, or "preset 2", its place in the group, while a question is open that it may answer, or
  /// is ahead.
  std::string told_title(const Preset&, bool question_ahead = false) const;
  /// Returns the preset that was loaded last.
  const std::string& origin() const { return chosen_.origin; }
  ReaderState reader_state() const;
  /// Returns another number for every other walk.
  unsigned walk_number() const { return walks_; }
  /// Returns a number that grows with every change of what is shown, except the camera's and the time's.
  unsigned revision() const { return revision_; }

  // Stepping. A step with a question is asked about before it is shown; stepping on again skips the question, which is
  // asked again whenever the reader comes by.
  void next();
  void back();
  void go_to(int step);
  void first() { go_to(0); }
  void last() { go_to(count() - 1); }
  bool at_end() const { return index() + 1 == count(); }
  /// Does part of the work that the next step's chart still takes; returns false if nothing is left to do.
  bool prepare_next() { return !at_end() && played_->prepare(index() + 1); }
  /// Whether a step's title gives no answer away: its question, if any, has been passed.
  bool tells_title(int step) const;
  void answer(int choice);
  /// Answers with what was typed, where more than a choice is asked for. Throws BadInput if it can't be read: then
  /// nothing has changed.
  void answer_typed(const std::string&);
  /// Answers with a line of the pseudocode, from 0, where one is asked for.
  void answer_line(int line);
  /// Shows the choices of a question that asks for more than a choice, as a hint.
  void show_choices();
  /// Goes to just before that step, which has a question, and asks it, whatever the answer was before.
  void ask_again(int step);
  /// Returns how many answers were given so far.
  unsigned answers_given() const { return answers_; }

  void toggle_play();
  /// Whether play goes on by itself: not while a question is open, if play stops at questions.
  bool running() const { return clock_.playing() && !(quiz_.asked() && clock_.stops_at_questions()); }
  /// Lets time pass for play, for the motion, for the camera, and for the shapes of a scene in which it runs.
  void advance(double seconds);
  void reduce_motion(bool);  ///< all is there at once
  /// Ends the motion at once: a scene that takes long to draw does not move smoothly anyway.
  void arrive();

  // Time within a step whose shapes move; another step begins at its own. (player_time.cpp)
  /// Returns the time of the scene on show; null where nothing moves, and while a question is open.
  const Scene::Time* time() const { return shown().scene.time.get(); }
  /// Returns the time at which the scene is drawn.
  double now() const;
  bool time_is_chosen() const { return now_.has_value(); }  ///< it need not be the step's own
  bool time_runs() const { return time_runs_; }
  /// Returns the walk with the step on show as it is drawn, if a time is chosen (viz/player/scene_time.h).
  Walk drawn_walk() const;
  /// Draws the scene at this time, or at the nearest one of its motion.
  void set_time(double);
  /// Lets time run, from the begin once it has ended, or stops it; with reduced motion it shows the next still.
  void toggle_time();
  void stop_time() { time_runs_ = false; }

  // Other lessons, presets and parameters. They throw BadInput on what does not exist. If one of them throws, for
  // whatever reason, nothing has changed: neither what is shown, nor the camera, nor what undo() knows.
  void open(const Lesson&);
  void open_neighbour(int by);
  /// Loads a preset, as restart() does the one that was loaded last, and frames it, even if the reader has moved the
  /// camera, unless it is pinned.
  void load(const Preset&);
  /// Shows what another method does with this setting: its step that corresponds to the one on show.
  void load_method(const std::string& choice);
  void restart();
  /// Reads the lesson again, which has other presets now.
  void reread();
  /// Shows an edited version of the scene on show in its place, at its first preset and at the same step; undo() brings
  /// back this one, and the step, too, if the reader `leaves_step` for another one. Both must outlive the player. The
  /// reader's view stays.
  void show_version(const Lesson&, bool leaves_step = false);
  void edit(const std::string& name, const Setting&);
  void set_parameters(Parameters);
  /// Drags a handle. Returns the condition that forbids it, if any: then nothing moves.
  const Condition* drag_handle(const Handle&, const Vec3& to);
  /// Moves the setting to a place on the lesson's map of cases; a place beyond the map is moved to its rim.
  void go_to_case(const Vec2&);
  void go(const ReaderState&);
  /// Becomes what it was when `kept` was copied from it, with its history; the counts above go on.
  void return_as(Player kept);

  /// Returns the exercise that is tried: by its index in the lesson, until another lesson is opened
  /// (viz/player/practice.h).
  const Exercise* exercise() const;
  void set_exercise(std::optional<int> index) { exercise_ = index; }

  /// Sets width / height of the scene; a view that nobody has moved is framed anew.
  void set_aspect(double);
  /// Moves the camera for the reader, after `action` was remembered (viz/player/camera_moves.h).
  void move_camera(const std::string& action, const std::function<void(CameraRig&)>& move);
  /// Glides to a view that counts as not moved: the next step and the next preset frame themselves.
  void frame(const Camera&);
  /// Keeps the reader's view whatever is loaded, until it is let go or another lesson is opened.
  void pin_camera(bool pinned) { camera_.pin(pinned); }

  // Two panes. (player_pair.cpp)
  /// Becomes a player with these parameters at the lead's step and through the lead's camera. If it throws BadInput,
  /// nothing has changed.
  void follow(const Player& lead, const Parameters&);
  /// Takes over what a reader has done to `other` since it last followed this one: its step, its camera, and the
  /// parameters that this player has `shared` with it.
  void take_from(const Player& other, const Parameters& shared);
  /// From now on frames views so that the other's walk is in them, too; null: no longer.
  void accompany(const Player* other);

  /// Remembers the present state for undo(). A run of actions of one name counts as one, until end_action().
  void remember(const std::string& action) { remember(action, false); }
  void end_action() { history_.end_action(); }
  /// Undoes the last change of parameters, lesson or camera; returns false if there is none. The step stays, unless
  /// that change had chosen one, or had taken the open question away: then it is asked again, too.
  bool undo();
  /// Does it again; returns false if nothing was undone, or something else was done since.
  bool redo();

 private:
  std::size_t index_of(const std::string& lesson_id) const;
  /// Calls action(copy of this player), and becomes that copy if nothing was thrown. A copy is cheap, as its large
  /// parts are shared.
  template <class Action>
  void all_or_nothing(const Action& action) {
    static_assert(std::is_nothrow_move_assignable_v<Player>);
    Player next = *this;
    action(next);
    *this = std::move(next);
  }
  /// `same_lesson`: the same, or another version of it.
  void show(Chosen, bool same_lesson);
  void show_step(int);
  void choose(int step);  ///< of the walk that is shown
  static int step_in(const Walk&, const Chosen&);
  void remember(const std::string& action, bool with_step);
  Memory memory() const {
    const bool asked = quiz_.asked();
    return {chosen_, camera_.goal(), camera_.moved(), false, asked, asked && !quiz_.asks_more()};
  }
  void return_to(Memory);
  /// Turns towards what is drawn now, unless the reader has moved the camera.
  void look(double seconds = CameraRig::usual_glide);
  void turn_to(const Camera&);  ///< unless the reader has pinned the view
  void begin_motion();          ///< from what is shown now
  bool can_ask() const { return !at_end() && walk().steps[index() + 1].question; }
  void ask(bool);  ///< about the next step, if it has a question
  void answer(GivenAnswer);
  Camera opening_view() const { return camera_.opening(*played_, shown().view, own_scene()); }
  /// Returns the projection for the next view: the present one, which the reader may have chosen; where steps have
  /// views of their own, only what the reader has chosen.
  std::optional<bool> projection() const {
    return has_own_views(walk()) ? camera_.projection() : std::optional(camera_.goal().perspective);
  }
  /// Returns the opening view in the projection that the reader has chosen; once a time is chosen, with the whole
  /// motion in view. (player_time.cpp)
  Camera framed_view() const;

  void let_time_run(double seconds);
  void leave_time();  ///< the scene is the step's own again, in its own arrangement
  /// Shows the same step of another walk at the time that was shown before.
  void keep_time(const Player& before);

  std::vector<const Lesson*> lessons_;
  Chosen chosen_;
  std::shared_ptr<PlayedWalk> played_;     ///< shared with copies of this player
  int at_ = 0;                             ///< the step that is shown
  std::optional<double> now_;              ///< the time of its scene; none: the scene is the step's own
  std::shared_ptr<const Scene> posed_;     ///< the scene at that time, if there is one
  std::shared_ptr<const Scene> arranged_;  ///< the scene in another arrangement, if there is one
  bool time_runs_ = false;
  std::optional<int> exercise_;
  unsigned revision_ = 0, walks_ = 0, answers_ = 0;

  Quiz quiz_;
  PlayClock clock_;
  StepMotion motion_;
  ReaderCamera camera_;
  History history_;
};

}  // namespace isect::viz
