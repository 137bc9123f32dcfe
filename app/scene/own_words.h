#pragma once
// What the author of a scene says of an answer, in place of the usual words. The core's verdict stays known beside it.

#include <optional>
#include <string>
#include <vector>

#include "app/scene/source.h"

namespace isect::program::scene {

struct Answered;

struct OwnWords {
  std::optional<std::string> title = {}, caption = {};  ///< markup
  std::optional<std::string> verdict = {};              ///< markup; empty: the figure shows none
  std::optional<std::string> question = {};  ///< markup; stands in the caption's place while answers are hidden

  bool any() const { return title || caption || verdict || question; }
  /// Whether one of them speaks of the answer.
  bool tells() const { return title || caption || verdict; }
};

/// Returns the fields of a question that hold them, and its camera, behind its own.
std::vector<std::string> and_words(std::vector<std::string> fields);
/// Reads them from a question. Throws viz::BadInput if one is no text, or empty.
OwnWords read_words(const Source&, const Json& question, const Path&);

/// Returns a question without them and without its camera, as it is written where it has none: ["A", "B"] for {"of":
/// ["A", "B"], ...}.
Json without_words(const Json& question);

/// Puts them in the place of an answer's own words; the verdict keeps those of the core. `written_for`: the core's
/// verdict that the author saw. If the verdict is another one by now, title and verdict stay as they are, and the
/// caption says for which verdict it was written.
void put_words(const OwnWords&, const std::string& written_for, Answered&);
/// Returns them for `--json`, as plain text: {"caption": "...", "verdict": null}.
Json json_of(const OwnWords&);

}  // namespace isect::program::scene
