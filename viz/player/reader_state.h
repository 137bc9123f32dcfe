#pragma once
// Where a reader is: everything needed to come back. The text of Ctrl+C / Ctrl+V, of preset files and of
// figures.

#include <optional>
#include <string>
#include <vector>

#include "viz/camera.h"
#include "viz/formats/files.h"
#include "viz/lesson.h"

namespace isect::viz {

/// What a second pane shows: another method, or another preset; one of the two is empty.
struct OtherSide {
  std::string method, preset;
  bool operator==(const OtherSide&) const = default;
};

struct ReaderState {
  std::string lesson, preset;    ///< preset empty: parameters were changed by hand
  std::optional<int> step = {};  ///< from 0, in every text from 1; none: the whole walk
  std::optional<Parameters> parameters = {};
  std::optional<Camera> camera = {};
  std::optional<OtherSide> beside = {};
  std::optional<double> time = {};  ///< of the step's motion (Scene::Time); none: the step's own picture
};

std::string to_json(const ReaderState&);
/// Reads what to_json writes; missing fields are the preset's, or the lesson's own. A camera's angles are in degrees;
/// those of older files, in radians, are read as such (viz/player/direction.h). Throws BadInput naming the field.
ReaderState reader_state_from_json(const std::string& text, const std::vector<const Lesson*>&);

/// Returns t if the shapes of this step of the walk, from 0, move, and t is within their motion. Throws BadInput, which
/// tells the range.
double checked_time(const Walk&, int step, double t);

/// Returns what a figure carries inside: lesson, preset, step, time, parameters, camera and version.
Metadata metadata(const ReaderState&);
/// Returns the place where a figure was made. Throws BadInput naming the field, also where the metadata is another
/// program's.
ReaderState reader_state_from_metadata(const Metadata&, const std::vector<const Lesson*>&);

/// Returns the parameters as a JSON object on one line.
std::string to_json(const Parameters&);
/// Returns the lesson called `id`. Throws BadInput with the nearest name.
const Lesson& lesson_named(const std::vector<const Lesson*>&, const std::string& id);
/// Returns the version of isect, which everything it writes carries.
std::string version();

}  // namespace isect::viz
