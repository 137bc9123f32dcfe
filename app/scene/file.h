#pragma once
// A scene file: a user's own objects, and the questions about them. JSON, like presets and queries, so that an object
// can be copied from one to the other; comments (// and /* */) are allowed.
//
//   { "title": "A ray past a box",                                   // optional, like all but "objects"
//     "objects": [ {"ray": "r", "origin": [-4, 0, 1], "dir": [1, 0, 0]},
//                  {"box": "A", "lo": [-1, -1, -1], "hi": [1, 1, 1]},
//                  {"mesh": "M", "file": "bunny.ply",                // beside this file
//                   "at": [0, 1, 0]} ],                              // moves it; so for polygon, hull and cloud
//     "ask": [ ["r", "A"],                                           // or "all pairs"
//              {"first hit": "r"},                                   // among all objects
//              {"fit": "M", "volume": "sphere"},                     // or box, obb, kdop, hull; all if not given
//              {"clip": "r", "to": "A"},                             // the part of a line or a polygon in a box
//              {"hierarchy": "M"},                                   // of its triangles; or of objects: ["A", "M"],
//              "all"
//              {"walk": ["r", "A"]},                                 // step by step, as the lesson of such a pair, or
//                                                                    // of one object: "H"; with "lesson": another one
//              {"walk": ["A", "B", "C"], "lesson": "collision",      // of many, or "all"
//               "method": "sweep"},
//              {"of": ["r", "A"], "title": "...",                    // words of one's own, beside any question but a
//               "caption": "...", "verdict": "...",                  // walk; "verdict": null shows none
//               "question": "...",                                   // while answers are hidden
//               "camera": {"azimuth": 60, "target": [0, 0, 0],       // of the question's steps, beside any question
//                          "half_height": 2}} ],
//     "caption": "...",                                              // of the step with all objects
//     "answers": "hidden",                                           // questions only: "shown" if not given
//     "lang": "de",                                                  // of what the program says; English if not given
//     "notes": [ {"at": [0, 2, 0], "text": "the *y*-axis"} ],
//     "marks": [ {"point": "q", "at": "r x A"},                     // or "foot of p on A"; computed
//                {"dimension": ["q", "A.lo"]} ],                     // or arrow, line, brace, angle, right angle
//     "camera": {"azimuth": 30, "elevation": 20},                    // degrees
//     "guard": [ {"theme": "dark"} ] }                               // for `isect check`: see app/guard.h
//
// The first field of an object is its type with its name; the others are those of app/scene/types.h, in the plane with
// two coordinates, in space with three. "hidden": true leaves an object out of the picture, not out of the answers.
// "color" is a role of the theme or a colour of one's own.

#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/scene/marks.h"
#include "app/scene/objects.h"
#include "app/scene/own_words.h"
#include "app/scene/source.h"
#include "viz/formats/files.h"
#include "viz/lang/message.h"

namespace isect::program::scene {

struct PairAsked {
  std::size_t a, b;  ///< indices of objects
};
struct FirstHitAsked {
  std::size_t ray;
};
struct FitAsked {
  std::size_t object;
  std::string volume;  ///< empty: all
};
struct ClipAsked {
  std::size_t what, to;  ///< a box, or a plane: the side that its normal points to
};
struct HierarchyAsked {
  std::vector<std::size_t> objects;  ///< if only one: its triangles
};
struct WalkAsked {
  std::size_t a, b;                    ///< equal for a walk of one object
  std::string lesson = {};             ///< its id, if it is not the usual one for such objects
  std::vector<std::size_t> many = {};  ///< for a walk of many: all of them; a is the first and b the second
  std::string method = {};             ///< one of the lesson's methods for many; empty: the first
  bool with_ray = false;               ///< the last of the many is the ray
};
using Asked = std::variant<PairAsked, FirstHitAsked, FitAsked, ClipAsked, HierarchyAsked, WalkAsked>;

struct Note {
  viz::Vec3 at;
  std::string text;  ///< markup
};

/// The title of a scene that has none of its own.
inline constexpr viz::Message untitled = viz::message("A scene");

struct File {
  std::string title;         ///< markup
  std::string caption = {};  ///< markup, of the step with all objects; empty: it lists them
  std::vector<Object> objects;
  viz::Parameters parameters;
  std::vector<Asked> asked;
  std::map<std::size_t, OwnWords> words;       ///< by index of what is asked
  std::map<std::size_t, viz::StepView> views;  ///< by the same: where its steps are seen from, if not from the camera
  bool answers_hidden = false;                 ///< the steps ask their questions, and tell no answer
  std::vector<Note> notes;
  std::vector<AuthorMark> marks;
  viz::Camera camera;
  bool flat = false;
  std::string language = {};  ///< of what the program says, as a code; empty: English
  std::string text;           ///< the file as it is, without comments, with the points of the short files that it names
};

/// Throws viz::BadInput if lists and objects nest too deep for our parsers.
void require_shallow(const std::string& text);
/// Whether a text is meant as a scene: JSON with "objects".
bool is_scene(const std::string& text);
/// Whether there are objects of ours in it: not somebody else's JSON with a field of that name.
bool holds_objects(const std::string& text);
/// Reads a scene. `folder`: what the names of files in it are relative to. Throws viz::BadInput, which names line and
/// field, what is allowed and the nearest name, and viz::FileError.
File read_scene(const std::string& text, const std::string& folder);
/// Reads a scene beside whose own fields others may stand, which are not looked at. The source's text must last so
/// long.
File read_scene(Source source, const std::string& folder, const std::vector<std::string>& beside);

/// Returns what `read` returns; an error in another file, such as a mesh, is reported with the scene's name.
template <class Read>
auto naming_scene(const std::string& path, const Read& read) {
  try {
    return read();
  } catch (const viz::FileError& e) {
    throw viz::FileError(path + ": " + e.what());
  }
}

}  // namespace isect::program::scene
