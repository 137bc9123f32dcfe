#pragma once
// The questions of a walk: each is asked before its step is shown.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "viz/lesson.h"
#include "viz/walk/given_answer.h"

namespace isect::viz {

/// A question that was answered, and the answer that was given.
struct Answered {
  const Question* question;
  int choice;  ///< as in GivenAnswer
  std::string typed;
  std::string told = {};   ///< "You typed 3/4 = 0.75.", as markup; empty: a choice was pressed
  std::string reply = {};  ///< what is said to a wrong answer, as markup; empty if the mistake behind it is not known
  bool right() const { return choice == question->answer; }
};

class Quiz {
 public:
  /// Returns the question to be answered now; null if none is open.
  const Question* asked() const { return asked_; }
  /// Whether the open question asks for a number, and its choices have not been shown instead.
  bool wants_number() const { return asked_ && asked_->number && !choices_shown_; }
  bool wants_line() const { return asked_ && asked_->line && !choices_shown_; }
  bool wants_order() const { return asked_ && asked_->order && !choices_shown_; }
  /// Whether it asks for more than a choice: for any of these.
  bool asks_more() const { return wants_number() || wants_line() || wants_order(); }
  void show_choices() { choices_shown_ = true; }
  /// Returns what is known of the step that the open question is about (viz/walk/question_scene.h).
  const std::shared_ptr<const Step>& asking_step() const { return asking_step_; }
  /// Returns the question of the step on show and its answer, if it was answered.
  const std::optional<Answered>& answered() const { return answered_; }

  /// Asks about a step that has a question; the walk must outlive it.
  void ask(const Walk&, int step);
  void close();
  /// Keep the answer to a step's question, or that it was skipped.
  void keep(int step, GivenAnswer answer) { answers_[step] = std::move(answer); }
  void skip(int step) { answers_.try_emplace(step); }
  void forget(int step) { answers_.erase(step); }
  void forget_all() { answers_.clear(); }
  bool is_answered(int step) const { return answers_.contains(step) && answers_.at(step); }
  bool is_past(int step) const { return answers_.contains(step); }
  bool is_skipped(int step) const { return answers_.contains(step) && !answers_.at(step); }
  /// From now on this step is on show.
  void show(const Walk&, int step);

 private:
  const Question* asked_ = nullptr;
  bool choices_shown_ = false;
  std::shared_ptr<const Step> asking_step_;
  std::map<int, std::optional<GivenAnswer>> answers_;  ///< by step; none where it was skipped
  std::optional<Answered> answered_;
};

}  // namespace isect::viz
