#pragma once
// State that the parts of the window share while it is open.

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "viz/course.h"
#include "viz/formats/formats.h"
#include "viz/player/hour.h"
#include "viz/player/player.h"
#include "viz/scene_editor.h"
#include "viz/walk/review.h"
#include "viz/window/widgets.h"

namespace isect::viz {

/// The smallest window, in px of the layout.
constexpr int least_width = 800, least_height = 500;
/// The range for the size of everything: large for a lecture hall, say.
constexpr double least_size = 0.5, most_size = 4;
/// The range for the width of a figure on paper.
constexpr double least_width_cm = 2, most_width_cm = 60;

/// A reader's results in a lesson.
struct Score {
  std::map<std::string, bool> answers = {};  ///< by question: whether the last answer was right
  bool finished = false;                     ///< read to its end
  std::set<std::string> skipped = {};        ///< questions that were passed over and never answered
  std::set<std::string> solved = {};         ///< exercises, by their prompts
  int seen = 0, of = 0;                      ///< the furthest step that was shown, from 1; and the steps of its walk
  int right() const {
    return static_cast<int>(std::ranges::count_if(answers, [](const auto& answer) { return answer.second; }));
  }
};
constexpr std::size_t recent_kept = 5, saved_kept = 100, hours_kept = 10;
/// The version of the file of settings: 1 had none, and neither skipped questions nor solved exercises. Files of all
/// versions are read; a copy of a newer one is kept before it is written over.
constexpr int settings_version = 2;

/// The contents of the second of two panes: a method, or a preset.
struct Beside {
  std::string lesson, method, preset;  ///< one of the latter two is empty
  bool operator==(const Beside&) const = default;
};
/// Returns the contents of the second pane of a place that has one.
inline std::optional<Beside> beside_of(const ReaderState& state) {
  if (!state.beside) return {};
  return Beside{state.lesson, state.beside->method, state.beside->preset};
}

/// What is kept between runs.
struct Settings {
  ThemeName theme = ThemeName::dark;
  std::string save_format = formats().front().name;
  ThemeName save_theme = ThemeName::print;
  bool parameters_open = false;
  double speed = 1;
  bool nonstop = false;            ///< play passes over questions
  int width = 1280, height = 800;  ///< px of the layout, whatever the screen's density
  bool reduced_motion = false;
  bool map = false;              ///< of cases, beside the scene
  double size = 1;               ///< of everything
  double save_width_cm = 0;      ///< of a saved figure on paper; 0: a picture for a screen
  std::string save_folder = {};  ///< the one chosen last, a whole path; empty: the usual one
  std::optional<ReaderState> reader_state = {};
  std::optional<Beside> beside = {};
  std::map<std::string, Score> scores = {};  ///< by lesson
  AnswerRecord record = {};                  ///< all answers: what reviews are drawn from
  std::vector<std::string> recent = {};      ///< ids of the lessons last opened
  std::vector<std::string> saved = {};       ///< whole paths of presets, the last saved first, wherever they lie
  std::vector<HourPlace> hours = {};         ///< where playlists were left, the last one first
};

/// Returns the file in the user's state folder; empty if there is no home.
std::string settings_file();
/// Reads the settings. A missing or damaged file gives the defaults, a damaged field its default.
Settings read_settings(const std::string& file, const std::vector<const Lesson*>&);
/// Renames a file that can't be read as settings, which would be overwritten at the end, to a new name beside it; keeps
/// a copy there of one whose record of answers alone can't be read, or that a newer version has written. Returns the
/// message about it; empty if there was nothing to do.
std::string set_spoilt_settings_aside(const std::string& file);
/// Returns the settings as the file holds them.
std::string text_of(const Settings&);
/// Writes the settings. Throws FileError.
void write_settings(const std::string& file, const Settings&);

/// The sheets that may cover the window.
enum class Sheet { none, keys, picker, save, terms, reviews, progress, stops };

/// What keys and buttons ask for, to be done between two frames.
struct Requests {
  Sheet sheet = Sheet::none;   ///< to be opened
  bool save_figure = false;    ///< this frame's figure as a file
  bool save_preset = false;    ///< the setting as a preset file
  bool save_back = false;      ///< the setting into the scene's file
  bool save_progress = false;  ///< what the reader has done, as a file
  bool save_scene = false;     ///< a scene that has no file, as a new one
  bool close = false;          ///< the reader wants to close the window
  int review = 0;              ///< to be begun: its number
  double zoom = 1;
};

/// The file of the scene that the lesson is made from.
struct SceneFile {
  /// Writes the lesson with this setting into it, from which the lesson is then made; null: there is no file.
  std::function<void(const Lesson&, const Parameters&)> save = {};
  NewSceneFile fresh = {};                    ///< while there is none, and one can be made
  std::optional<unsigned> told_unsaved = {};  ///< revision of a scene that was unsaved when the reader wanted to close
  /// The version of the scene that it was saved from last; null: nobody has saved it.
  const Lesson* written = nullptr;
  /// Each version of an edited scene, with the one that it was made from first.
  std::map<const Lesson*, const Lesson*> versions = {};
};

/// Where the scene on show is saved: nowhere, as it is none or can't be; in its file; in a new one.
enum class KeptScene { nowhere, in_file, without_file };

/// The list of a scene's objects. (objects_panel.cpp)
struct ObjectsPanel {
  const Lesson* of = nullptr;             ///< the version that is listed
  std::vector<SceneObject> objects = {};  ///< its objects
  std::vector<std::size_t> found = {};    ///< those with the words that are searched for, in their order
  std::string search = {}, searched = {};
  std::vector<std::string> chosen = {};       ///< at most two names
  std::vector<std::string> asked_about = {};  ///< those that `questions` and `asked` are about
  std::vector<SceneQuestion> questions = {};  ///< that can be added
  std::vector<SceneQuestion> asked = {};      ///< that are asked
  std::string to_see = {};                    ///< the object whose row is to come into view
  /// A name that is being typed.
  struct Renaming {
    std::string object, text;
    int frames = 0;      ///< without the keyboard, so far
    bool begun = false;  ///< the field has the keyboard
  } renaming = {};
};

/// The sheet that saves files: a figure, which it shows as it would save it, drawn between two frames; or else the
/// reader's progress, or a scene.
struct SaveSheet {
  enum class What { figure, progress, scene };
  What what = What::figure;
  bool open = false;
  ImTextureID picture = {};
  float width = 0, height = 0;   ///< of the figure, in any unit
  std::string why = {};          ///< why there is none
  std::string width_text = {};   ///< as typed
  std::string width_wrong = {};  ///< why it is refused
  std::string name = {};         ///< as typed, without ending; empty: the usual one
  std::string folder = {};       ///< as typed
  std::string failed = {};       ///< why the last file could not be written
};

/// The list of lessons.
struct Picker {
  std::string search = {};                ///< words that are searched for
  bool progress = false;                  ///< the sheet of progress is wanted instead
  const Lesson* lesson = nullptr;         ///< the one whose picture is wanted; null: none
  ImTextureID picture = {};               ///< nothing until it has been drawn, between two frames
  std::vector<std::string> presets = {};  ///< files of saved ones, as they were found
};

/// The fields of the parameters.
struct Fields {
  /// A number that is being typed into a field.
  struct Typing {
    std::string field, text;
    int frames = 0;      ///< without the keyboard, so far
    bool begun = false;  ///< the field has the keyboard
  } typing = {};
  /// Why the last one was refused.
  struct Refused {
    std::string field, why;
    unsigned revision = 0;  ///< the player's; shown until something changes
  } refused = {};
  float height = 0;  ///< as the last frame found it
};

/// The field for what a question asks for besides a choice: a number, a line's number, the letters of an order.
struct AnswerField {
  std::pair<unsigned, int> of = {};  ///< the walk and the step whose question it is
  std::string text = {};
  bool typing = false;       ///< it has the keyboard, or gets it in one of the next frames
  bool begun = false;        ///< it has had it
  bool at_end = false;       ///< the cursor was set behind the text
  int frames = 0;            ///< without the keyboard, so far
  std::string refused = {};  ///< why the text can't be read; empty: it was not tried
  bool other = false;        ///< the question that was answered is wanted once more, with other numbers
};

/// The words of a step, beside its scene or below it.
struct StepWords {
  unsigned seen = 0;                         ///< the revision whose words are shown
  std::set<const Exercise*> solutions = {};  ///< those that are shown
  bool reading = false;                      ///< the closing card's references are unfolded
  std::string note = {};                     ///< the playlist's, told before them
  std::optional<Player> before_fault = {};   ///< as the reader was before a published line was shown to fail
  AnswerField answer = {};
  float beyond = 0;   ///< px of the words, or of what stands beside them, below the end of a lecture's strip
  bool turn = false;  ///< these are wanted
};

/// Where the walks of two panes part: a line, one of the step's values; -1: nowhere.
struct Parted {
  int line = -1, value = -1;
  std::vector<int> renamed = {};  ///< lines that differ by names alone
};

/// A message over the scene.
struct Toast {
  std::string text = {};
  bool error = false;
  double seconds_left = 0;
  std::optional<std::pair<unsigned, int>> at = {};  ///< its revision and step, if it is about no others

  void say(const std::string& words) { *this = {words, false, 5}; }
  /// Says what holds only for this setting and step: the message ends with them.
  void say_here(const Player& player, const std::string& words) { *this = {words, false, 5, here(player)}; }
  void complain(const std::string& words) { *this = {words, true, 12}; }
  static std::pair<unsigned, int> here(const Player& player) { return {player.revision(), player.index()}; }
};
/// Runs an action that may be refused, and shows why it was.
template <class Action>
void attempt(Toast& toast, Action&& action) {
  try {
    action();
  } catch (const BadInput& wrong) {
    toast.complain(wrong.what());
  } catch (const FileError& failed) {
    toast.complain(failed.what());
  }
}

/// A review that is on. (review.cpp)
struct Reviewing {
  int number = 0;
  std::vector<ReviewPrompt> prompts = {};
  std::vector<std::optional<bool>> results = {};  ///< of those that are done: right or not; none: skipped
  unsigned answers_before = 0;                    ///< that had been given when the question on show was asked
  std::optional<bool> result = {};                ///< of the question on show, once it is answered
  Player before;                                  ///< as the reader left it
  std::optional<Beside> beside = {};              ///< as it was then
  bool over() const { return results.size() == prompts.size(); }
  int right() const { return static_cast<int>(std::ranges::count(results, std::optional<bool>(true))); }
};

/// All that the parts of the window share. The window itself, its keys and what opens its sheets take it whole; a panel
/// takes what it needs of it.
struct WindowSession {
  Player& player;
  Ui& ui;
  Settings& settings;
  const Course& course;
  std::string figures;  ///< folder for saved figures
  SceneFile scene_file = {};
  SceneEditor scene_editor = {};
  ObjectsPanel objects = {};
  bool panels = true, full_screen = false;  ///< without panels it is a lecture
  bool dark = false;                        ///< a lecturer has made the screen dark
  Requests requests = {};
  SaveSheet save_sheet = {};
  Picker picker = {};
  std::string searched_term = {};  ///< words among the terms
  Fields fields = {};
  StepWords step_words = {};
  Toast toast = {};
  std::optional<Reviewing> review = {};
  std::optional<Hour> hour = {};  ///< the playlist that is gone through
  int typed_stop = 0;             ///< the number of one of its stops, as far as it is typed in their list
  unsigned answers_kept = 0;      ///< how many of the player's answers are in the record
};

}  // namespace isect::viz
