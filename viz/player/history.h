#pragma once
// What a reader can undo, and do again.

#include <memory>
#include <string>
#include <vector>

#include "viz/camera.h"
#include "viz/lesson.h"

namespace isect::viz {

/// A reader's choices: lesson, parameters, step.
struct Chosen {
  std::size_t lesson = 0;
  const Lesson* version = nullptr;  ///< a scene as it was after an edit; null: the lesson as the list has it
  Parameters parameters;
  std::string origin;  ///< the preset loaded last
  // The walk of another setting shows the corresponding step: its outcome for an outcome, else the step of the same
  // name, else the one of the same number.
  int step = 0;
  std::string slug;
  bool outcome = false;

  void choose_step(const Chosen& other) { step = other.step, slug = other.slug, outcome = other.outcome; }
  void choose_first_step() { choose_step({}); }
};

/// The state before a change.
struct Memory {
  Chosen chosen;
  Camera camera;
  bool moved = false;      ///< the reader had moved the camera
  bool with_step = false;  ///< the change chose a step, too
  bool asked = false;      ///< the question before the next step was open
  bool chooses = false;    ///< and its choices were shown
};

/// A copy is cheap: it shares what is remembered.
class History {
 public:
  bool can_undo() const { return !past_.empty(); }
  bool can_redo() const { return !undone_.empty(); }

  /// Whether this action goes on: a run of actions of one name counts as one, until end_action().
  bool goes_on(const std::string& action) const { return !action.empty() && action == action_; }
  void remember(const std::string& action, Memory);
  void end_action() { action_.clear(); }
  /// Says that the action that goes on has taken the reader's place away: undo() brings it back, too.
  void loses_place();
  /// Return the state before the last change, or the one that undo() left; there must be one. `now` takes its place.
  Memory undo(Memory now) { return end_action(), travel(past_, undone_, std::move(now)); }
  Memory redo(Memory now) { return end_action(), travel(undone_, past_, std::move(now)); }

 private:
  using Memories = std::vector<std::shared_ptr<const Memory>>;
  static Memory travel(Memories& from, Memories& to, Memory now);

  Memories past_, undone_;
  std::string action_;
};

}  // namespace isect::viz
