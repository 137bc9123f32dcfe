#pragma once
// A lesson is a value: parameters in, steps out. Nothing here draws, opens a file or knows a particular lesson.
//
// parameters -> core call with a Record -> events -> steps -> scene -> back end. No callbacks back up.
// Texts are markup (see viz/text/rich_text.h).

#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "viz/camera.h"
#include "viz/scene.h"

namespace isect::viz {

/// The value of a parameter: a number, a point or vector, or one of several named choices.
using Setting = std::variant<double, Vec3, std::string>;

/// One knob of a lesson. `initial` fixes its type.
struct Parameter {
  std::string name;   ///< as in `--set name=value`
  std::string label;  ///< markup, for the window
  std::string help;   ///< one plain sentence with the unit
  Setting initial;
  double lo = -1e300, hi = 1e300;         ///< allowed range of a number or of each coordinate
  double drag_lo = -10, drag_hi = 10;     ///< comfortable range for a slider
  std::vector<std::string> choices = {};  ///< allowed values of a choice
  bool optional = false;                  ///< may be absent: then the choices decide, and `initial` only gives the type
  /// Where it counts: the allowed choices, by the name of the parameter that makes them. Elsewhere it changes nothing.
  std::map<std::string, std::vector<std::string>> where = {};
};

/// Values by parameter name; has every parameter of its lesson except the optional ones.
using Parameters = std::map<std::string, Setting>;

/// A condition on a parameter besides its own range: a direction that is not zero, a side that is not along another.
struct Condition {
  std::string parameter;  ///< the one to blame
  std::string allowed;    ///< what to give, in plain words: "a vector of any length but 0"
  std::function<bool(const Parameters&)> holds;
};

/// A named number of this step, with the text shown for it.
struct Value {
  std::string name;  ///< markup
  double value = 0;
  std::string unit = {};  ///< values of one unit share a bar scale; empty: no bar
  Role role = Role::muted;
  bool fresh = false;  ///< computed or changed in this step
};

/// An inequality shown as a bar against a tick: `left op right`.
struct Comparison {
  std::string text;  ///< markup, e.g. "*m*^2 ≤ *r*^2"
  double left = 0, right = 0;
  bool holds = false;
  std::string meaning;  ///< "the line meets the ball"
  /// The inequalities that a condition joins, "*s* < 0 and *l*^2 > *r*^2", each with its own sides and no meaning; then
  /// the condition's own `left` and `right` are unused. Empty: it is one inequality.
  std::vector<Comparison> parts = {};
};

/// Operations done so far, counted by running the same algorithm with a counting scalar type.
struct Counters {
  int mul = 0, add = 0, div = 0, sqrt = 0, compare = 0;
  bool early_out = false;
};

/// A wrong number that is usually given, and the mistake behind it.
struct WrongNumber {
  double value = 0;
  std::string reply = {};  ///< markup, one or two short sentences: "That is *s*, not *s*^2."
};

/// The number that a question asks for. A reader types it; the question's choices are for paper, and a hint.
/// viz/walk/typed_answer.h judges it.
struct Numeric {
  double truth = 0;
  int digits = 3;  ///< how many digits count; 0: it is a count, and only itself is right
  std::vector<WrongNumber> wrong = {};
};

/// A wrong line that is usually pointed at, and the mistake behind it.
struct WrongLine {
  int line = 0;            ///< from 0
  std::string reply = {};  ///< as in WrongNumber
};

/// The line of the pseudocode that a question asks for: a reader points at it, or types its number. The question's
/// choices are a hint. viz/walk/pointed_line.h judges it.
struct LineAsked {
  int truth = 0;                  ///< the line that the question's step lights, from 0
  std::vector<int> offered = {};  ///< by choice: its line
  std::vector<WrongLine> wrong = {};
};

/// A wrong order that is usually given, and the mistake behind it.
struct WrongOrder {
  std::vector<int> order = {};  ///< indices of tiles
  std::string reply = {};       ///< as in WrongNumber
};

/// Things to put in order: a reader takes one tile after the other, or types their letters. The question's choices are
/// a hint. viz/walk/given_order.h judges it.
struct OrderAsked {
  std::vector<std::string> tiles = {};  ///< markup; they are called a, b, c ...
  std::vector<int> ranks = {};          ///< by tile, from 0: those of one rank may come in any order among themselves
  std::vector<std::vector<int>> offered = {};  ///< by choice: its order
  std::vector<WrongOrder> wrong = {};
};

/// A question for the reader: predict, then reveal. The answer comes from the predicate itself.
struct Question {
  std::string prompt;                    ///< markup
  std::vector<std::string> choices;      ///< markup
  int answer = 0;                        ///< index into choices
  std::string because;                   ///< markup, shown with the answer
  std::optional<Scene> over = {};        ///< the scene while it is open; none: see viz/walk/question_scene.h
  std::vector<Value> given = {};         ///< the numbers it needs, as before its step: shown while it is open
  std::optional<Numeric> number = {};    ///< it asks for this number, which then is the right choice, too
  std::optional<LineAsked> line = {};    ///< it asks for this line, which then is the right choice, too
  std::optional<OrderAsked> order = {};  ///< it asks for this order; no choice but the right one is one
};

/// What is known at this step.
struct Verdict {
  enum class Kind { open, yes, no, on };
  Kind kind = Kind::open;
  std::string text;  ///< markup
  std::string exact =
      {};  ///< markup: the core's own words where `text` is somebody else's; empty: `text` is the core's

  const std::string& of_core() const { return exact.empty() ? text : exact; }
};

struct Step {
  std::string slug;               ///< for file names: lower case, digits, '-'
  std::string title;              ///< markup, short
  std::string caption;            ///< markup, sentences of at most 20 words; '\n' separates paragraphs
  std::string formula;            ///< markup, at most one line, may be empty
  std::string source;             ///< page of the note or book, may be empty
  int line = -1;                  ///< current pseudocode line, from 0; -1: none
  std::vector<int> untaken = {};  ///< lines of branches not taken so far
  std::vector<int> refused = {};  ///< `if` lines whose condition was false so far (marked "no")
  bool decides = false;           ///< a branch is decided here
  std::vector<Value> values = {};
  std::optional<Comparison> comparison = {};
  Counters counters = {};
  Verdict verdict = {};
  std::optional<Question> question = {};  ///< asked before this step is shown
  Scene scene = {};
  std::optional<StepView> view = {};  ///< where it is seen from; none: as the lesson is
};

struct Preset {
  std::string id;     ///< lower case, digits, '-'; names its snapshot folder
  std::string title;  ///< short, for a button
  std::string group;  ///< value of the lesson's `group_by` parameter, empty if it has none
  Parameters parameters;
};

/// The steps for one setting of the parameters, with the text of the algorithm they walk through.
struct Walk {
  std::string method;                   ///< title of the variant, may be empty
  std::vector<std::string> pseudocode;  ///< plain text lines
  std::vector<Step> steps;
  std::string alt;  ///< the picture in plain words
};

/// The result of one of several methods that should agree on the same setting.
struct Opinion {
  std::string method;  ///< markup: "quadratic formula"
  std::string says;    ///< markup: "two roots"
  bool agrees = true;  ///< with the exact method
};

/// The plane of a lesson's two natural parameters, coloured by the branch that the core takes at each point of it.
/// viz/chart/case_map.h draws it, and a walk ends with it.
struct CaseMap {
  std::string x_title, y_title;       ///< markup
  Vec2 lo, hi;                        ///< the part shown
  std::vector<std::string> branches;  ///< markup, short; some may be no more than a line or a point of the plane
  int (*branch)(const Parameters&) = nullptr;  ///< index into `branches`
  Vec2 (*place)(const Parameters&) = nullptr;  ///< where the setting lies; NaN: nowhere
  Parameters (*moved)(const Parameters&,
                      const Vec2&) = nullptr;  ///< the setting moved to a place; the rest stays
  std::string told = {};                       ///< markup: what the plane means, in sentences of at most 20 words
  bool one_scale = true;                       ///< both axes count the same lengths; a circle is drawn as one
  bool own_group = false;                      ///< presets of other groups have other shapes, and no rings here
};

/// What a program and the core say of one setting: "OVERLAP" and "DISJOINT".
struct TwoVerdicts {
  std::string program, exact;
  bool differ() const { return program != exact; }
};

/// Something to do with a pencil or with the mouse, and its solution.
struct Exercise {
  std::string prompt;       ///< markup
  std::string solution;     ///< markup
  std::string preset = {};  ///< the setting it speaks of; empty: none
  /// If a setting is to be found: whether this is one, as the core decides. Null: the answer is words or a number.
  bool (*found)(const Parameters&) = nullptr;
  /// The parameters to set, starting from `preset`, to find one: {"c", "0,2,0"}.
  std::vector<std::pair<std::string, std::string>> by = {};
  /// A program with one wrong line, as a walk's pseudocode: a setting is to be found in which its verdict is wrong. The
  /// solution names that line, and stays hidden until then. Empty: the exercise shows none.
  std::vector<std::string> program = {};
  /// Runs that program, and the core's test. Null if there is none.
  TwoVerdicts (*verdicts)(const Parameters&) = nullptr;
};

/// The summary of a lesson: the card that ends a walk (viz/walk/closing.h). All markup, one or two short sentences
/// each.
struct Closing {
  std::string result;                ///< what holds, and why
  std::string cost;                  ///< operations, or growth
  std::string choose;                ///< when to choose it, and what else one would
  std::string used;                  ///< where engines and renderers use it
  std::string bug;                   ///< the mistake usually made
  std::string bug_preset;            ///< a preset whose verdict it would spoil
  std::vector<std::string> reading;  ///< author, title, year, section
  std::vector<Exercise> exercises;   ///< three to five
};

/// An error in the pseudocode as published.
struct Erratum {
  std::string published, corrected;  ///< one of the two stands in a walk's pseudocode
  std::string why;                   ///< markup, one sentence
  std::string preset;                ///< the published line fails on it
};

struct Lesson;

/// An idea that other lessons share.
struct SharedIdea {
  std::string idea;  ///< plain text
  std::vector<const Lesson*> others;
};

struct Lesson {
  std::string id;
  std::string title;
  std::string rows;     ///< note rows, "N16-N19"
  std::string summary;  ///< one plain sentence
  std::vector<Parameter> parameters;
  std::vector<Condition> conditions = {};
  std::string group_by;         ///< name of the choice parameter that groups the presets, may be empty
  std::vector<Preset> presets;  ///< the first one is loaded at the start
  Camera camera;                ///< see opening(); target and scale are set by framing all presets alike
  /// Called by `walk`. Throws BadInput if the lesson refuses a setting that is in range and keeps the conditions.
  std::function<Walk(const Parameters&)> steps = nullptr;
  /// All lies in z = 0 and is seen straight on, whatever `camera` says: a drag pans, nothing rotates.
  bool flat = false;
  /// Calls methods that should agree, side by side; the first is exact. Null where a lesson has one method.
  std::vector<Opinion> (*opinions)(const Parameters&) = nullptr;
  /// The lesson's map of cases; a walk whose setting has a place on it ends with a step that shows it.
  const CaseMap* map = nullptr;
  /// The question, its purpose, and the idea, in a few sentences of markup: told before the first step's own caption.
  std::string opening = {};
  const Closing* closing = nullptr;     ///< the last step of every walk
  std::vector<Erratum> errata = {};     ///< of the pseudocode as published
  std::vector<std::string> after = {};  ///< ids of the lessons that this one builds on
  std::vector<std::string> ideas = {};  ///< terms of the glossary that it shares with others
  /// Returns which other lessons these are, by idea. Null: the lesson stands alone.
  std::vector<SharedIdea> (*shared)(const Lesson&) = nullptr;
  /// A case of the lesson's test as JSON for `isect query`, with line breaks where it is long: see `judge` in
  /// viz/walk/closing.h. Empty: none.
  std::string query = {};
  std::string made_from = {};  ///< the text of the scene file that it was made from; empty: it is built in
  std::string language = {};   ///< of its texts, as a code: "de" (viz/lang/language.h); empty: English

  /// Returns all steps for a setting: the lesson's own, its map of cases, its closing card. The map lacks its regions,
  /// as walks are made far more often than maps are shown: see viz/chart/case_map.h. Throws as `steps` does.
  Walk walk(const Parameters&) const;
};

/// An error in a name or a value: the message names the field, what was given and what is allowed.
struct BadInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Returns the lesson's own view. A flat lesson is seen straight on, whatever its camera says.
Camera opening(const Lesson&);
/// Returns the direction and the projection in which a step is seen, of which `view` is that of its own, if any.
Camera opening(const Lesson&, const std::optional<StepView>& view);
/// Whether some step has a view of its own.
bool has_own_views(const Walk&);
/// Whether some step has a t-axis: then all steps leave room for it, so that the scene stays in place.
bool has_axis(const Walk&);
/// Whether shapes move in some step: then all steps leave room for the time below the scene.
bool has_time(const Walk&);
const Preset& preset(const Lesson&, const std::string& id);  ///< throws BadInput with the nearest name
/// Sets one parameter from text ("1.5", "1,2,3", "haines"). Throws BadInput; `to` is unchanged then. The lesson's
/// conditions are left to `validate`, as they may hold only when all parameters are set.
void set(const Lesson&, Parameters& to, const std::string& name, const std::string& text);
/// Sets one parameter to a value, as `set` does.
void set_value(const Lesson&, Parameters& to, const std::string& name, const Setting&);
/// Returns what values a parameter takes, in words: "a number from 0 to 10".
std::string wanted(const Parameter&);
bool counts(const Parameter&, const Parameters&);
/// Returns "Counts where walk is test"; empty where it always counts.
std::string told_where(const Parameter&);
/// Throws BadInput unless every parameter is present, of the right type, finite and in range, and keeps the conditions.
void validate(const Lesson&, const Parameters&);
/// Moves the handle's parameter to `p`, clamped to its range, and those that move with it. If a condition forbids that,
/// nothing moves, and the condition is returned; else null.
const Condition* drag(const Lesson&, Parameters&, const Handle&, const Vec3& p);
/// Sets a parameter. Another choice of objects starts anew: moves of the old objects are forgotten.
void choose(const Lesson&, Parameters&, const std::string& name, const Setting&);
std::string to_text(const Setting&);  ///< shortest text that `set` reads back exactly
/// Returns the candidate closest to `word` by edit distance; empty where none is near.
std::string nearest(const std::string& word, const std::vector<std::string>& candidates);
/// Returns the error for an unknown name: it names the field, what was given, a similar name, if any, and all that is
/// allowed.
BadInput unknown(const std::string& field, const std::string& given, const std::vector<std::string>& allowed);
/// Returns the number as shown to readers: about five significant digits, a real minus, no trailing zeros lost.
std::string shown(double value);
/// Returns the same text, but -0 keeps its sign.
std::string shown_with_sign(double value);
/// Returns both numbers as shown; in full where they would read alike without being equal.
std::pair<std::string, std::string> shown_apart(double a, double b);

}  // namespace isect::viz
