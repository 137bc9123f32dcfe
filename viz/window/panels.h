#pragma once
// The parts of the window around the scene, each in its rectangle.

#include <functional>

#include "viz/window/window_session.h"

namespace isect::viz {

/// What the top bar shows and changes.
struct TopBar {
  Player& player;
  Ui& ui;
  Settings& settings;
  Requests& requests;
  Toast& toast;
  bool paging = false;              ///< Page Up and Page Down go on and back, and load no preset
  bool named = true;                ///< the presets' names answer no question to come
  const Lesson* in_file = nullptr;  ///< the scene as its file has it, where the one on show was edited since; or null
};
/// Draws lesson, method and presets. (top_bar.cpp)
void top_bar(const TopBar&, const Rect&);
/// What the lesson's panel shows and changes.
struct LessonPanel {
  Player& player;
  Ui& ui;
  Settings& settings;
  Fields& fields;
  StepWords& words;
  Requests& requests;
  Toast& toast;
  bool in_hour = false;  ///< a playlist says what comes after the last step
  bool answers = false;  ///< the list of objects has the place of the values: the panel shows them, and all answers
};
/// Draws what the lesson says here, its question, its parameters and what can be dragged. (lesson_panel.cpp)
void lesson_panel(const LessonPanel&, const Rect&);
/// Draws the fields of all parameters from (x, y) down; returns where they end. (parameters.cpp)
float parameter_fields(Player&, Ui&, Fields&, Toast&, float x, float y, float width);
/// Draws pseudocode, values, comparison and operations; with `parted`, that of two panes, where lines and values
/// replace headings and counts. (code_panel.cpp, values.cpp)
void code_panel(Player&, Ui&, const Rect&, const Parted* = nullptr);
/// Returns the rows that a line of pseudocode takes in this room. (code_panel.cpp)
std::vector<std::string> rows_of_line(const std::string&, ImFont*, float room);
/// Draw the current line alone, large, on a bright ground; there must be one. (code_panel.cpp)
float current_line_height(const Player&, const Ui&, float width);
void current_line(Player&, Ui&, const Rect&);
float values_height(const Ui&, const Step&, float width, float pitch);
void values_block(Ui&, const Step&, const Rect&, float pitch, const Parted*);
void operations_block(Ui&, const Counters&, const Rect&);
/// Marks a row as the first that differs from the other pane's; `lit`: on the current line. (code_panel.cpp)
void parted_mark(Ui&, const std::string& name, const Rect&, bool lit = false);
/// Draws on the side of the second of two panes what it is given, with that pane's player.
using OnItsSide = std::function<void(const std::function<void(Player&)>& draw)>;
/// Draws the strip of a lecture, below the scene while the panels are hidden: the step's words, or its question in
/// their place; at the right the current line, the formula and the values in use, or what the question needs.
/// (lecture.cpp) `other`: draws in the second of two panes, whose line and values are told, too; empty: there is none.
void lecture(Player&, Ui&, StepWords&, const Rect&, const OnItsSide& other = {});
/// Returns which of its values a step uses, in their order: all that its line names, each by its own value or else by a
/// power of it; up to three also those that its condition names, those that are new, those that its formula names.
/// `knobs`: numbers that are set, for names of the line without a value; they come last. (values_in_use.cpp)
std::vector<Value> values_in_use(const Walk&, const Step&, const std::vector<Value>& knobs = {});
/// Where a part of a lecture's words lies below the strip's end: lets the next frame show it. Returns false where there
/// is none, so that a key goes on. (lecture.cpp)
bool shows_rest(WindowSession&);
/// Draws nothing but black over the whole window, until a click. (lecture.cpp)
void dark_screen(WindowSession&, const Rect& window);
/// Draws scrubber and buttons, and where a reader is in a playlist. (transport.cpp)
void transport(WindowSession&, const Rect&);
/// Lets play pass over questions, or stop at them again. (transport.cpp)
void pass_questions(Player&, Settings&, Toast&);
/// Draws the key sheet, the picker and the save sheet, over everything else. (sheets.cpp)
void sheets(WindowSession&, const Rect& window);

/// Keeps the answers that were given, the questions that were skipped, the exercise that was solved, and that a lesson
/// was read to its end. (score.cpp) `answers_kept`: how many of the player's answers are in the record; it keeps the
/// last one where that is new.
void keep_score(const Player&, Settings&, unsigned& answers_kept);
/// A step of this walk whose question was answered wrong when it was asked last, or skipped and never answered.
struct Missed {
  int step = 0;
  bool skipped = false;
};
std::vector<Missed> missed_questions(const Player&, const Settings&);
/// Keeps the lessons opened last, the one on show first, and how far each was read. (score.cpp)
void keep_place(const Player&, Settings&);

/// Opens the lesson after this one, where the closing card is on show and there is one. (ending.cpp)
void open_next_lesson(Player&, Toast&);

// In a playlist as without one. (hour_keys.cpp)
/// Goes on by a step; after the last one to the playlist's next stop, or else to the next lesson.
void go_on(WindowSession&);
void go_back(WindowSession&);
/// Whether going on leads to another stop or lesson: a key that is held does not run on into it.
bool leads_on(const WindowSession&);
bool may_go_on(const WindowSession&);
bool may_go_back(const WindowSession&);
/// Whether the presets' names may be told: not while a question is open that they may answer, or lies ahead in a stop.
bool names_presets(const WindowSession&);
/// Whether N, Page Down and Page Up go on and back: in a lecture, and in a playlist.
bool pages_go_on(const WindowSession&);

/// Returns the way through a playlist, from where the settings left it; none if it has no stops.
std::optional<Hour> hour_of(const Playlist&, const Settings&);
/// Called once, and in every frame: takes note of where the reader is in the playlist, if there is one.
void begin_hour(WindowSession&);
void follow_hour(WindowSession&);
/// Goes to the beginning of a stop, from 0.
void open_stop(WindowSession&, int stop);
/// Keeps where a playlist was left, before the others.
void keep_hour(std::vector<HourPlace>&, const HourPlace&);
/// Draws "3 of 14", which opens the list of stops, from x on, around the middle y; returns where it ends.
/// (hour_panels.cpp)
float hour_badge(WindowSession&, float x, float y);
/// Whether the playlist's stop can't be opened, and stop_fault, which says so and offers to go past it, is what there
/// is to see. (hour_panels.cpp)
bool shows_fault(const WindowSession&);
void stop_fault(WindowSession&, const Rect&);
/// Shows the published line fail or, where that is on show, leads back to where the reader was: `before`, which keeps
/// that. (fault.cpp)
void fault_or_back(Player&, std::optional<Player>& before);
/// Whether the reader still looks at the failure that was asked for, or at a setting made from it. (fault.cpp)
bool can_return(const Player&, const std::optional<Player>& before);

/// Begins a review, whose questions the player then asks one after the other. (review.cpp)
void begin_review(WindowSession&, int number);
/// Returns to where the reader was.
void leave_review(WindowSession&);
/// Asks the next question; the one on show is skipped if it is not answered.
void next_in_review(WindowSession&);
/// Called in every frame: takes note of an answer, and asks again where a drag has taken the question away.
void follow_review(WindowSession&);
/// Draw the bars of a review, which replace those of a lesson, and what came of it.
void review_bars(WindowSession&, const Rect& top, const Rect& bottom);
void review_score(WindowSession&, const Rect&);

/// Whether the lesson on show is a scene in a file that can be written to, or one that can get a file. (keys.cpp)
KeptScene kept_scene(const WindowSession&);
/// Returns the scene as its file has it, or as it came, where the one on show was edited since; else null. (keys.cpp)
const Lesson* scene_in_file(const WindowSession&);
/// Loads a preset; where the scene on show was edited, that is the scene as its file has it, which undo() leaves again.
void load_preset(Player&, const Preset&, const Lesson* in_file);
/// Returns false once if numbers of a scene would be lost, with a message.
bool may_leave(WindowSession&);
/// Writes the setting into the scene's file; or opens the sheet that makes one, or else the one that saves figures.
void save_back(WindowSession&);
/// Whether a character belongs to what answers the open question besides a choice: the first opens the field for it.
/// (answer_field.cpp)
bool typed_into_answer(const Player&, AnswerField&, ImWchar);
/// Does what this frame's keys ask for. (keys.cpp)
void keys(WindowSession&);

}  // namespace isect::viz
