#pragma once
// What every lesson shares: turning the events of one run into steps that build on each other.

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <isect/counted.h>
#include "viz/lesson.h"

namespace isect::lessons {

/// Keeps each event with the operations counted up to it. Runs on Counted<double>: the core's own text,
/// counted.
template <class Event>
struct CountingRecord {
  std::vector<std::pair<Event, Tally>> events;

  template <class E>
  void operator()(const E& event) {
    events.emplace_back(event, tally());
  }
};

/// The data at the head of a walk.
struct Opening {
  std::string source;  ///< of every step: page of the note or book
  std::string alt;     ///< what the picture shows, in plain words
  std::vector<std::string> pseudocode;
  std::string method = {};  ///< title of the variant, where a lesson has several
};

/// Writes the steps of a walk one after the other. What one step sets stays: values, refused conditions, lines that
/// were not taken and the verdict carry over to the later steps.
class Script {
 public:
  explicit Script(Opening opening) {
    walk_.method = std::move(opening.method);
    walk_.alt = std::move(opening.alt);
    walk_.pseudocode = std::move(opening.pseudocode);
    state_.source = std::move(opening.source);
  }

  /// Runs `run(record)` with every operation counted, and hands each event to `say`, with the counters as they stood.
  /// Steps added after that have the counters of the whole run.
  /// The algorithm runs to its end before the first event is handed over.
  template <class Event, class Run, class Say>
  void tell(const Run& run, const Say& say) {
    CountingRecord<Event> record;
    tally() = {};
    run(record);
    const Tally total = tally();
    for (const auto& [event, counts] : record.events) {
      count(counts);
      std::visit(say, event);
    }
    count(total);
  }

  /// Sets the operations done up to the next step.
  void count(const Tally& t) {
    const bool early_out = state_.counters.early_out;
    state_.counters = {t.mul, t.add, t.div, t.sqrt, t.compare, early_out};
  }

  /// Adds a value for the next step. It replaces one of the same name, and counts as new if the number differs.
  void value(const std::string& name, double number, const std::string& unit = {}, viz::Role role = viz::Role::muted) {
    const auto unchanged = [&](const viz::Value& v) { return v.name == name && v.value == number && !v.fresh; };
    const bool fresh = std::ranges::none_of(state_.values, unchanged);
    std::erase_if(state_.values, [&](const viz::Value& v) { return v.name == name; });
    state_.values.push_back({name, number, unit, role, fresh});
  }

  /// Removes values that the next steps don't have.
  void forget(const std::vector<std::string>& names) {
    std::erase_if(state_.values, [&](const viz::Value& v) { return std::ranges::count(names, v.name) > 0; });
  }

  /// Notes that the condition on `line` was false, so that the lines of its branch are not taken.
  void refuse(int line, const std::vector<int>& branch) {
    state_.refused.push_back(line);
    state_.untaken.insert(state_.untaken.end(), branch.begin(), branch.end());
  }

  void settle(viz::Verdict::Kind kind, const std::string& text) { state_.verdict = {kind, text}; }
  void leave_early() { state_.counters.early_out = true; }

  /// Appends a step. The reference holds until the next one is added.
  viz::Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption,
                 const std::string& formula = {}) {
    viz::Step step = state_;
    step.slug = slug, step.title = title, step.line = line, step.caption = caption, step.formula = formula;
    for (viz::Value& v : state_.values) v.fresh = false;
    walk_.steps.push_back(std::move(step));
    return walk_.steps.back();
  }

  /// Sets the inequality that a step decides.
  static void decide(viz::Step& step, const viz::Comparison& comparison) {
    step.decides = true;
    step.comparison = comparison;
  }

  viz::Walk& walk() { return walk_; }

 private:
  viz::Step state_;
  viz::Walk walk_;
};

}  // namespace isect::lessons
