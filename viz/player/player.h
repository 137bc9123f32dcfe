#pragma once
// What the window shows, and what a reader's actions do to it. It uses no ImGui and no OpenGL, so that tests can drive
// it directly.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "viz/lesson.h"
#include "viz/player/camera_rig.h"
#include "viz/player/played_walk.h"
#include "viz/window/window.h"

namespace isect::viz {

/// One value of the parameter that groups a lesson's presets, with the title of its variant.
struct Method {
  std::string choice, title;
};

/// The time in which a step's picture, and its view, become the next.
constexpr double seconds_to_move = 0.220;

class Player {
 public:
  /// Starts paused at `at`; an empty place is the first lesson with its first preset. Throws BadInput.
  explicit Player(std::vector<const Lesson*>, const ReaderState& at = {}, bool reduced_motion = false);

  const std::vector<const Lesson*>& lessons() const { return lessons_; }
  const Lesson& lesson() const { return *lessons_[state_.lesson]; }
  const Parameters& parameters() const { return state_.parameters; }
  const Walk& walk() const { return walk_->walk(); }
  int count() const { return static_cast<int>(walk().steps.size()); }
  int index() const { return at_; }
  /// Does part of the work that the next step's chart still takes; returns false if nothing is left to do.
  bool prepare_next() { return !at_end() && walk_->prepare(index() + 1); }
  /// Returns the last step that was told.
  const Step& step() const { return walk().steps[index()]; }
  /// Returns step() or, while a question is open, what is known of the step that it asks about
  /// (viz/walk/question_scene.h).
  const Step& shown() const { return asking_ ? *asked_step_ : step(); }
  /// Returns the scene that is drawn.
  const Scene& scene() const { return shown().scene; }
  /// Returns the scene that this one is coming from, for the moments after a step; null at rest.
  const Scene* scene_before() const { return before_.get(); }
  /// Returns how far the motion has come: 0 at the old scene, 1 at this one. Lights come up faster than things move.
  double motion() const;
  double light() const;
  void reduce_motion(bool);  ///< all is there at once
  /// Ends the motion at once: a scene that takes long to draw does not move smoothly anyway.
  void arrive();
  /// Returns what the lesson's methods say of these parameters, if it has several that should agree.
  const std::vector<Opinion>& opinions() const { return opinions_; }
  bool methods_differ() const;
  /// Returns the preset that has these parameters; empty if they were changed by hand.
  const std::string& preset_id() const { return preset_; }
  /// Returns a preset's title, or "preset 2", its place in the group, while a question is open that it may answer.
  std::string told_title(const Preset&) const;
  /// Returns the preset that was loaded last.
  const std::string& origin() const { return state_.origin; }
  /// Returns the presets of the current group, in order: the keys 1 to 9 load them.
  std::vector<const Preset*> group() const;
  const std::vector<Method>& methods() const { return overview_->methods; }
  /// Returns the value of the grouping parameter; empty if the lesson has none.
  std::string method() const;
  ReaderState reader_state() const;
  /// Returns another number for every other walk.
  unsigned walk_number() const { return walks_; }
  /// Returns a number that grows with every change of what is shown, except the camera's.
  unsigned revision() const { return revision_; }

  // Stepping. A step with a question is asked about before it is shown; stepping on again skips the question.
  void next();
  void back();
  void go_to(int step);
  void first() { go_to(0); }
  void last() { go_to(count() - 1); }
  bool at_end() const { return index() + 1 == count(); }
  /// Whether a step's title gives no answer away: its question, if any, has been passed.
  bool tells_title(int step) const { return step <= index() || (!asking_ && !walk().steps[step].question); }

  bool playing() const { return playing_; }
  /// Whether play goes on by itself: not while a question is open, if play stops at questions.
  bool running() const { return playing_ && !(asking_ && stops_); }
  /// Whether play stops at questions, as it does at first, or passes over them.
  bool stops_at_questions() const { return stops_; }
  void stop_at_questions(bool wanted) { stops_ = wanted; }
  /// Returns the time until play shows another step.
  double seconds_to_step() const;
  void toggle_play();
  double speed() const { return speed_; }
  /// Goes through 0.5x, 1x, 1.5x, 2x and round again.
  void next_speed();
  void set_speed(double);
  /// Lets time pass for play and for the camera.
  void advance(double seconds);

  /// Returns the question to be answered now, if any.
  const Question* asked() const;
  void answer(int choice);
  /// The question of the current step, once it was answered, and the answer that was given.
  struct Answered {
    const Question* question;
    int choice;
    bool right() const { return choice == question->answer; }
  };
  std::optional<Answered> answered() const;
  /// Goes to just before that step, which has a question, and asks it, whatever the answer was before.
  void ask_again(int step);

  /// Returns an error in the pseudocode as published: at the current line, or else anywhere in this walk.
  const Erratum* erratum() const;
  /// Loads the preset on which that line fails, at the step that runs it.
  void show_erratum();

  // An exercise: a setting to be found. It ends when another lesson is opened.
  void begin_exercise(int index);
  void end_exercise() { exercise_.reset(); }
  const Exercise* exercise() const;
  bool exercise_solved() const;

  // Other lessons, presets and parameters. They throw BadInput on what does not exist. If one of them throws, for
  // whatever reason, nothing has changed: neither what is shown, nor the camera, nor what undo() knows.
  void open(const Lesson&);
  void open_neighbour(int by);
  void load(const Preset&);
  void load_method(const std::string& choice);
  void restart();
  /// Reads the lesson again, which has other presets now.
  void reread();
  void edit(const std::string& name, const Setting&);
  void set_parameters(Parameters);
  /// Drags a handle. Returns the condition that forbids it, if any: then nothing moves.
  const Condition* drag_handle(const Handle&, const Vec3& to);
  /// Moves the setting to a place on the lesson's map of cases; a place beyond the map is moved to its rim.
  void go_to_case(const Vec2&);
  void go(const ReaderState&);

  const CameraRig& camera() const { return camera_; }
  bool camera_moved() const { return moved_; }  ///< by the reader: no preset frames it anew
  /// Sets width / height of the scene; a view that nobody has moved is framed anew.
  void set_aspect(double);
  void orbit(const Vec2& pixels);  ///< a flat lesson does not turn
  void pan(const View&, const Vec2& from, const Vec2& to);
  void zoom(const View&, const Vec2& at, double factor);
  /// Glides to the lesson's opening direction with the whole walk in view.
  void frame_all();
  void set_perspective(bool);  ///< a flat lesson has none

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
  void end_action() { action_.clear(); }
  /// Undoes the last change of parameters, lesson or camera; returns false if there is none. The step stays, unless
  /// that change had chosen one.
  bool undo() { return travel(&Player::memory_, &Player::undone_); }
  /// Does it again; returns false if nothing was undone, or something else was done since.
  bool redo() { return travel(&Player::undone_, &Player::memory_); }
  bool can_undo() const { return !memory_.empty(); }
  bool can_redo() const { return !undone_.empty(); }

 private:
  struct State {
    std::size_t lesson = 0;
    Parameters parameters;
    std::string origin;  ///< the preset loaded last: where restart() returns
    // The step the reader chose. The walk of another setting shows the corresponding step: its outcome for an outcome,
    // else the step of the same name, else the one of the same number.
    int wanted = 0;
    std::string slug;
    bool outcome = false;
  };
  struct Memory {
    State state;
    Camera camera;
    bool moved;
    bool with_step;  ///< the change chose a step, too
  };

  /// What is known of a lesson regardless of its parameters.
  struct Overview {
    std::vector<Walk> samples;  ///< one of each preset
    std::vector<Method> methods;
  };

  static std::shared_ptr<const Overview> overview_of(const Lesson&, const Walk&, const Parameters&);
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
  void show(State, bool same_lesson);
  void remember(const std::string& action, bool with_step);
  bool travel(std::vector<Memory> Player::*from, std::vector<Memory> Player::*to);
  static int step_in(const Walk&, const State&);
  void choose(int step);  ///< of the walk that is shown
  void show_step(int);
  void look();          ///< towards what is drawn now, unless the reader has moved the camera
  void begin_motion();  ///< from what is shown now
  void ask(bool);       ///< about the next step, if it has a question
  /// Returns the lesson's view of the walk, at the scale that all presets share.
  Camera opening_view() const;

  std::vector<const Lesson*> lessons_;
  State state_;
  std::shared_ptr<PlayedWalk> walk_;  ///< shared with copies of this player, as the overview is
  std::shared_ptr<const Overview> overview_;
  std::vector<Opinion> opinions_;
  std::string preset_;
  int at_ = 0;  ///< the step that is shown
  std::optional<int> exercise_;
  unsigned revision_ = 0, walks_ = 0;

  bool asking_ = false;
  std::shared_ptr<const Step> asked_step_;   ///< what is shown while asking
  std::map<int, std::optional<int>> asked_;  ///< by step: the answer, or none where it was skipped

  bool playing_ = false, stops_ = true;
  double speed_ = 1, waited_ = 0;

  std::shared_ptr<const Scene> before_;
  double since_step_ = 1e9;  ///< seconds
  bool reduced_motion_ = false;

  CameraRig camera_;
  double aspect_ = 1;
  bool moved_ = false;                  ///< the reader has moved the camera
  std::shared_ptr<const Walk> beside_;  ///< in the other pane

  std::vector<Memory> memory_, undone_;
  std::string action_;
};

}  // namespace isect::viz
