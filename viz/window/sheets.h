#pragma once
// Sheets that cover the window for a while: keys, lessons, terms, a figure to be saved.

#include <imgui.h>

#include "viz/window/key_codes.h"
#include "viz/window/window_session.h"

namespace isect::viz {

/// Whether a key was pressed in an open sheet; the press that opened it does not count.
inline bool key_down(key::Code code) { return ImGui::IsKeyPressed(code, false) && !ImGui::IsWindowAppearing(); }

/// Opens in the middle of the window, which is dimmed behind it and takes no click; Escape or a click beside it closes
/// it. Returns whether it is open.
bool begin_sheet(Ui&, const char* name, const Rect& window, float width, float height);
/// Page Down and Page Up scroll the open sheet, or the part of it that is being drawn; at its end Page Down closes the
/// sheet: a presenter has no other keys.
void page_through_sheet();
/// Draws the field for `words` to search for, which has the keyboard. Returns whether Enter was pressed in it.
bool search_field(Ui&, std::string& words, const char* hint);
/// Whether each wanted word, or another name for the same thing, occurs in the text; case is ignored.
bool matches(const std::string& text, const std::string& wanted);

void key_sheet(Ui&, const Rect& window);
/// What the picker lists: lessons in the order of the course, what a reader did in them, and presets saved in a folder.
struct Shelf {
  const std::vector<const Lesson*>& lessons;
  const Course& course;
  const Settings& settings;
  const std::string& figures;
};
/// Lists the shelf; what is chosen from it the player opens.
void picker(Player&, Ui&, Picker&, const Shelf&, Toast&, const Rect& window);
/// Lists the terms in which the words `searched` occur; the player opens the lesson of the one that is chosen.
void terms_sheet(Player&, Ui&, std::string& searched, const Course&, Toast&, const Rect& window);
/// Lists the reviews of the course with what came of each. (review.cpp)
void reviews_sheet(WindowSession&, const Rect& window);
/// Lists all lessons with what the reader did in them, and the reviews. (progress_sheet.cpp)
void progress_sheet(WindowSession&, const Rect& window);
/// Lists the playlist's stops, to go to one. (hour_panels.cpp)
void stops_sheet(WindowSession&, const Rect& window);
/// Asks for the format, theme, size, name and folder of a figure. `to_file`: the setting can be written into the
/// scene's file. `figures`: the usual folder.
void save_sheet(const Player&, Ui&, SaveSheet&, Settings&, const std::string& figures, KeptScene, Requests&,
                const Rect& window);

}  // namespace isect::viz
