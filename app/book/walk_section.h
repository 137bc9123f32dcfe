#pragma once
// One setting of a lesson, walked, as a part of its page.

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "viz/lesson.h"

namespace isect::program::book {

/// Where a reader may be in a walk: at a step, or at the question before it.
struct Station {
  int step = 0;
  bool asks = false;
  bool operator==(const Station&) const = default;
};
/// In order. The closing card is none: it stands on the page once.
std::vector<Station> stations(const viz::Walk&);

/// What all of it is about; the values must outlive the section.
struct Told {
  const viz::Lesson& lesson;
  const viz::Parameters& parameters;
  const viz::Walk& walk;
};

class WalkSection {
 public:
  using Picture = std::function<std::string(const Station&)>;  ///< as a <figure>
  /// `id`: what the ids of its parts begin with. `names`: those that can be lit wherever they stand.
  WalkSection(const Told& told, std::string id, Picture picture, std::set<std::string> names = {})
      : lesson_(told.lesson),
        parameters_(told.parameters),
        walk_(told.walk),
        id_(std::move(id)),
        picture_(std::move(picture)),
        names_(std::move(names)) {}

  /// All of it; `first_is_shown`: its first step has the class "shown".
  std::string html(bool first_is_shown = false) const;

  std::string given() const;
  std::string algorithm() const;
  /// What the methods say that should agree.
  std::string opinions() const;
  /// What the walk ends with, and how many methods say otherwise; empty: it ends with no verdict.
  std::string outcome() const;
  /// What stands above a station's picture, and below it.
  std::string above(const Station&) const;
  std::string below(const Station&) const;
  /// The attributes of its element: which lines of code are lit.
  std::string attributes(const Station&) const;

 private:
  std::string text(const std::string& markup) const;
  std::string prose(const std::string& markup) const;
  std::string id(const Station&) const;
  std::string article(const Station&, bool shown) const;
  std::string words(const viz::Step&, int index) const;
  std::string numbers(const viz::Step&) const;
  std::string question(int step) const;
  std::string known(int step) const;
  std::string caption(const viz::Step&) const;
  std::string verdict(const viz::Verdict&) const;
  std::string source(int step) const;
  std::string line(const viz::Step&) const;
  std::string code(const std::string&) const;
  std::string values(const viz::Step&) const;
  std::string comparison(const viz::Step&) const;
  std::string answers() const;

  const viz::Lesson& lesson_;
  const viz::Parameters& parameters_;
  const viz::Walk& walk_;
  const std::string id_;
  const Picture picture_;
  const std::set<std::string> names_;
};

/// Of the answer to a question, and of the solution of an exercise: unfolded by a click, never on paper.
std::string folded(const std::string& head, const std::string& prose);

}  // namespace isect::program::book
