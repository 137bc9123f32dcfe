#pragma once
// The result of a check: as text, as JSON and JUnit XML for programs, and as one HTML page with pictures inside.

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/baselines.h"

namespace isect::program {

/// The part of the command line that chose what is checked; the same again, with --update, accepts it.
struct Asked {
  std::string program;               ///< how it was called
  std::vector<std::string> lessons;  ///< none: all
  std::string preset;                ///< empty: all
  std::string dir, snapshots;        ///< empty where not given
  std::string backend;               ///< empty where not given
};

struct Report {
  Asked asked;
  std::string folder;                                             ///< of the baselines
  std::vector<std::string> lessons = {};                          ///< in order, those that were checked
  std::vector<std::string> by_name = {};                          ///< those of them that a command line can name
  std::vector<std::pair<std::string, std::string>> checked = {};  ///< lesson and preset
  std::size_t pictures = 0;
  std::vector<Failure> failures = {};
  std::set<std::string> left_alone = {};  ///< files among the baselines that are not isect's
  bool nothing_there = false;             ///< none of the presets has a baseline
};

/// 0, 1, 2 or 3: a failed check, then a broken preset file, then a missing baseline. What was accepted counts for
/// nothing.
int status(const Report&);
/// No update touches the others: a picture of nothing, a file that isect did not make, a preset that can't be read.
bool may_be_accepted(const Failure&);
/// The command that accepts all that may be accepted; empty where there is nothing of the kind.
std::string accept_command(const Report&);
/// The command that accepts this failure, and others of its preset; empty where none may.
std::string accept_command(const Report&, const Failure&);

/// As one word of a shell's.
std::string quoted(const std::string& word);

std::string to_text(const Report&);
std::string to_json(const Report&);
/// Self-contained: old, new and difference side by side.
std::string to_html(const Report&);
/// One test suite a lesson, one test case a preset.
std::string to_junit(const Report&);
/// Whether a file that begins so is a report of isect's as HTML, as JUnit XML.
bool begins_html_report(const std::string& bytes);
bool begins_junit_report(const std::string& bytes);

// What the forms share.

/// "ray-sphere tangent, step 3 (foot)"
std::string where(const Failure&);
/// "2 failures in 12 pictures and the trace of 1 preset; 3 accepted"
std::string summary(const Report&);
/// What there is to know of a failure besides its first difference, a line each.
std::vector<std::string> details(const Failure&);
/// Why a file among the baselines is left alone.
std::string told_left_alone(const std::string& file);
/// For XML and HTML: what they hold no way or would read as their own is replaced.
std::string escaped(const std::string&);

}  // namespace isect::program
