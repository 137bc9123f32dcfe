#pragma once
// What a handout, a quiz or a deck is about: one excerpt of a lesson, or a playlist, whose stops are excerpts.

#include <string>
#include <vector>

#include "app/figures/blocks.h"
#include "app/shell/options.h"

namespace isect::program {

/// An excerpt; of a playlist, a stop of it.
struct PaperPart {
  Excerpt e;
  int stop = 0;            ///< its number in the playlist, from 1; 0: there is none
  std::string head = {};   ///< markup: "3 of 14: Ray and sphere"; of a playlist only, as the next two
  std::string entry = {};  ///< markup, for the list of stops: "Ray and sphere, steps 3–6"
  std::string note = {};   ///< markup, may be empty
  bool new_lesson = true;  ///< no part before is of this lesson
  bool new_card = true;    ///< no part before ends with this lesson's card
  int code_of = 0;         ///< the first stop with this pseudocode; 0: it is new here, or there is none
};

struct Paper {
  std::string title;   ///< markup
  std::string folder;  ///< of its pages, below that of all figures: "ray-sphere/two-roots", "hour"
  std::vector<PaperPart> parts;
  bool is_playlist() const { return parts.front().stop > 0; }
  /// The language of its own words, as a code: that of its first part.
  const std::string& language() const { return parts.front().e.lesson->language; }
};

/// Which steps of an excerpt count.
enum class PaperSteps { all, asking };
/// Returns what is asked for; `asking`: the steps with a question alone, and no parts without any. A setting's name may
/// be the answer to a question, so nothing tells it. Throws viz::BadInput, also if nothing is left, and viz::FileError.
Paper paper_of(const Program&, const Selection&, PaperSteps = PaperSteps::all);
/// Returns the questions of all presets of a lesson, a part for each preset that asks. Throws as paper_of does.
Paper paper_of_presets(const Program&, Selection);

/// Returns the caption of a step, with the lesson's opening only where that is new.
std::string caption_on_paper(const PaperPart&, int step);
/// Returns the stops of a playlist.
Stops list_of_stops(const Paper&);

}  // namespace isect::program
