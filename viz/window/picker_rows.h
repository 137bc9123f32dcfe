#pragma once
// What the picker lists, in which order, and which of it Enter opens.

#include <filesystem>
#include <string>
#include <vector>

#include "viz/window/sheets.h"

namespace isect::viz {

/// A row of the picker: a heading, a lesson, or a saved preset.
struct PickerRow {
  std::string heading = {};
  const Lesson* lesson = nullptr;
  std::string preset = {};
  bool again = false;  ///< the lesson is listed below, too
};

/// Returns "ray-sphere, setting-1", with the folder unless that is the one for figures.
std::string name_of_preset(const std::string& figures, const std::filesystem::path& file);
/// Returns the rows in the order of the course or, where something is searched for, those that were found, the best
/// first: the exact title, a title that begins so, a title with these words, and what has them elsewhere. `now`: the
/// lesson on show.
std::vector<PickerRow> rows_of(const Picker&, const Shelf&, const Lesson& now);
/// Returns the name of a row's widget.
std::string name_of_row(const PickerRow&, const std::string& figures);
/// Returns the row that Enter opens: the one that the keyboard holds; else the best that was found or, as long as
/// nothing is searched for, the lesson on show. Null: none. `held`: the name of the widget that the keyboard holds.
const PickerRow* chosen_row(const std::vector<PickerRow>&, const Picker&, const Shelf&, const Lesson& now,
                            const std::string& held);

}  // namespace isect::viz
