#pragma once
// One setting of a lesson, walked, as a part of its page.

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "viz/lang/message.h"
#include "viz/walk/step_text.h"

namespace isect::program::book {

/// A reader's place in a walk: at a step, or at the question before it.
struct Station {
  int step = 0;
  bool asks = false;
  bool operator==(const Station&) const = default;
};
/// Returns the stations in order. The closing card is not one: it stands on the page once.
std::vector<Station> stations(const viz::Walk&);

/// What the whole section is about; the values must outlive it.
struct Told {
  const viz::Lesson& lesson;
  const viz::Parameters& parameters;
  const viz::Walk& walk;
};

class WalkSection {
 public:
  using Picture = std::function<std::string(const Station&)>;  ///< as a <figure>
  /// `id`: the prefix of its parts' ids. `names`: those that can be lit wherever they occur.
  WalkSection(const Told& told, std::string id, Picture picture, std::set<std::string> names = {})
      : lesson_(told.lesson),
        parameters_(told.parameters),
        walk_(told.walk),
        id_(std::move(id)),
        picture_(std::move(picture)),
        names_(std::move(names)) {}

  /// Returns the whole section; `first_is_shown`: its first station has the class "shown", and the others wait.
  std::string html(bool first_is_shown = false) const;

  std::string given() const;
  std::string algorithm() const;
  /// Returns what the methods say that should agree.
  std::string opinions() const;
  /// Returns the last verdict of the walk, and how many methods disagree; empty: it ends without a verdict.
  std::string outcome() const;
  /// Return what stands above a station's picture, and below it.
  std::string above(const Station&) const;
  std::string below(const Station&) const;
  /// Returns the attributes of its element: which lines of code are lit, what a question is called.
  std::string attributes(const Station&) const;
  /// Returns what the lit line says of its condition: "yes" or "no", empty where it says nothing. No line is lit while
  /// a question is open.
  std::string said(const Station&) const;
  /// Returns the lesson, a space and the name of the question before a step (viz/walk/review.h): what review.js keeps
  /// an answer under. Empty for scenes from files.
  std::string asked_name(int step) const;
  /// Returns a question without its number.
  std::string asked(const viz::QuestionText&, int step) const;

 private:
  std::string text(const std::string& markup) const;
  std::string prose(const std::string& markup) const;
  /// Returns the words in the lesson's language; "{n}" is the number.
  std::string in_its_language(const viz::Message& words, int n = 0) const;
  std::string id(const Station&) const;
  std::string article(const Station&, bool shown) const;
  std::string words(const viz::StepText&, int step) const;
  std::string numbers(const viz::StepText&) const;
  std::string question(const viz::QuestionText&, int step) const;
  std::string asked_for(const viz::Question&, int step) const;
  std::string verdict(const viz::Verdict&) const;
  std::string source(int step) const;
  std::string code(const std::string&) const;
  std::string values(const std::vector<viz::ValueText>&) const;
  std::string answers() const;

  const viz::Lesson& lesson_;
  const viz::Parameters& parameters_;
  const viz::Walk& walk_;
  const std::string id_;
  const Picture picture_;
  const std::set<std::string> names_;
};

/// Puts elements aside: a browser with scripts keeps them as text until waiting.js makes them, all others show them.
/// They must hold no others that wait.
std::string waiting(const std::string& attributes, const std::string& elements);

/// Folds the answer to a question, or the solution of an exercise: it unfolds at a click; paper omits it.
std::string folded(const std::string& head, const std::string& prose);

}  // namespace isect::program::book
