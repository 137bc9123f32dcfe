#pragma once
// The judge: a program's answers to the cases of a task, family by family.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "app/grade/answers.h"
#include "app/grade/mistakes.h"
#include "app/grade/sandbox.h"

namespace isect::grade {

struct Asked {
  std::vector<std::string> command;
  std::uint64_t seed = 1;
  int count = 40;  ///< cases of a family
  Convention convention = Convention::closed;
  bool plain = false;   ///< numbers in place of JSON
  bool reduced = true;  ///< look for simpler cases with the same faults
  bool timed = true;    ///< measure the speed, too
  Limits limits = {};
};

/// What became of a family's cases. Those that are neither wrong, unreadable nor without an answer are right.
struct OfFamily {
  std::string name;
  int cases = 0, wrong = 0, unreadable = 0, unanswered = 0;
  std::map<std::string, int> faults = {};  ///< of the wrong ones
  double ulps = 0;                         ///< the farthest of its values that are right or wrong
  int right() const { return cases - wrong - unreadable - unanswered; }
};

/// The first case of a fault.
struct Example {
  std::size_t line = 0;  ///< from 1, of the input
  std::string family, fault, said, truth;
  Numbers numbers, simplest;  ///< the case, and a simpler one with the same fault, or the same
};

struct Verdict {
  std::vector<OfFamily> families;
  std::vector<Example> examples;  ///< one of each fault, and one that could not be read
  std::vector<Fit> likely;        ///< mistakes that explain its answers
  Run run;
  std::size_t cases = 0, right = 0, answers = 0;
  double calls_a_second = 0;  ///< 0: not measured, or too fast to
  bool passes() const {
    return right == cases && answers == cases && !run.early && run.end == Run::End::exited && run.code == 0;
  }
};

/// Returns the lines of an output that are not blank.
std::vector<std::string_view> answers_in(std::string_view output);
/// Returns the cases as the program reads them, a line each.
std::string input_of(const Task&, const std::vector<Case>&, bool plain);

/// Runs the program and judges it. The true answers are found when it has ended. Throws viz::FileError if the program
/// can't be started.
Verdict judged(const Task&, const Asked&);

/// Returns the verdict in words. All that comes
/// from the program is bounded and harmless.
std::string in_words(const Task&, const Asked&, const Verdict&);
/// Returns it as JSON.
std::string in_json(const Task&, const Asked&, const Verdict&);

}  // namespace isect::grade
