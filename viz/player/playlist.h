#pragma once
// A playlist: the presets, steps and scenes of an hour, in its order. app/playlist_file.h reads one from its file.

#include <string>
#include <vector>

#include "viz/lesson.h"
#include "viz/player/reader_state.h"

namespace isect::viz {

/// A part of an hour: some steps of one setting of one lesson.
struct Stop {
  const Lesson* lesson = nullptr;  ///< a scene is one, too; null if the stop can't be opened
  ReaderState state = {};          ///< its step is the first of `steps`, its parameters are never missing
  std::optional<int> timed = {};   ///< that one of `steps` which is drawn at the state's time; none: none is
  std::vector<int> steps = {};     ///< from 0, in order
  bool whole = false;              ///< these are all steps of its walk
  bool asks = false;               ///< the first of them has a question, with which the stop begins
  std::string name = {};           ///< of the preset or of the file, without ending: "tangent"; empty: it has none
  std::string note = {};           ///< markup, for those who watch; may be empty
  std::string path = {};           ///< of the file that it names; empty: it names none
  std::string fault = {};          ///< why it can't be opened, naming line and field; empty: it can
};

/// Returns "steps 3–6" or "step 3"; nothing for all steps.
std::string steps_in_words(const Stop&);

struct Playlist {
  std::string title = {};  ///< markup; may be empty
  std::string file = {};   ///< that it was read from: its whole path
  std::vector<Stop> stops = {};
};

}  // namespace isect::viz
