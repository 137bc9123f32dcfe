#pragma once
// The result of a check: as text, as JSON, JUnit XML and GitHub's annotations for programs, and as an HTML page with
// pictures, in which a person ticks what is to be accepted.

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/checks/baselines.h"

namespace isect::program {

/// The part of the command line that chose what is checked; repeated with --update, it accepts it.
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

/// Returns 0, 1, 2 or 3: a failed check, then a broken preset file, then a missing baseline. Accepted failures do not
/// count.
int status(const Report&);
/// Whether an update may accept it: no empty picture, no file that isect did not make, no preset that can't be read.
bool may_be_accepted(const Failure&);
/// Returns the command that accepts all failures that may be accepted; empty if there are none.
std::string accept_command(const Report&);
/// Returns the command that accepts this failure, and others of its preset; empty if it may not be accepted.
std::string accept_command(const Report&, const Failure&);
/// Returns the command that accepts what a file lists, without the file's name, which is the last word.
std::string accept_file_command(const Report&);

/// Returns the text quoted as one word for a shell.
std::string quoted(const std::string& word);

/// Tells the first of many failures with one cause in full, the others in a line each.
std::string to_text(const Report&);
std::string to_json(const Report&);

/// The files of an HTML report. Pictures stand inside the page, unless they are more than a browser opens at once: then
/// they lie beside it, in a folder with its name.
struct HtmlReport {
  std::string page;
  std::string folder;                           ///< "check-pictures", beside the page; empty if there is none
  std::map<std::string, std::string> pictures;  ///< by their names in that folder, which are their digests
};
/// `file`: the page's name; `most_inside`: bytes of pictures that may stand in the page.
HtmlReport to_html(const Report&, const std::string& file, std::size_t most_inside = std::size_t{24} << 20);
/// Writes the page and its pictures. Pictures of an earlier report that it no longer shows are removed; they are known
/// by their digests. Throws viz::FileError.
void write_html(const HtmlReport&, const std::string& file);

/// Returns one test suite per lesson, one test case per preset.
std::string to_junit(const Report&);
/// Returns GitHub's workflow commands, an error a cause: as many as GitHub shows of a step, and the last one tells of
/// the rest. Empty if nothing failed.
std::string to_github(const Report&);
/// Returns the result as Markdown for GitHub's summary of a job: never more than 100 kB, however much failed.
std::string to_markdown(const Report&);
/// Escape text for such a command: its message, and a property, in which colons and commas mean something, too.
std::string github_message(const std::string&);
std::string github_property(const std::string&);
/// Whether a file that begins so is a report of isect's as HTML, as JUnit XML.
bool begins_html_report(const std::string& bytes);
bool begins_junit_report(const std::string& bytes);

// Shared by the forms.

/// Returns "ray-sphere tangent, step 3 (foot)".
std::string where(const Failure&);
/// Returns "2 failures in 12 pictures and the trace of 1 preset; 3 accepted".
std::string summary(const Report&);
/// Returns what is known of a failure besides its first difference, one line each.
std::vector<std::string> details(const Failure&);
/// Returns why a file among the baselines is left alone.
std::string left_alone_text(const std::string& file);
/// Escapes text for XML and HTML: characters that these forbid or would interpret are replaced.
std::string escaped(const std::string&);

}  // namespace isect::program
