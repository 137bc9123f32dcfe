#pragma once
// A scene file: objects of one's own, and what is asked of them. JSON, as presets and queries are, so that an object
// can be copied from one to the other; comments (// and /* */) are allowed.
//
//   { "title": "A ray past a box",                                   // may be left out, as may all but "objects"
//     "objects": [ {"ray": "r", "origin": [-4, 0, 1], "dir": [1, 0, 0]},
//                  {"box": "A", "lo": [-1, -1, -1], "hi": [1, 1, 1]},
//                  {"mesh": "M", "file": "bunny.ply"} ],             // beside this file
//     "ask": [ ["r", "A"],                                           // or "all pairs"
//              {"first hit": "r"},                                   // among all objects
//              {"fit": "M", "volume": "sphere"},                     // or box, obb, kdop, hull; all if not given
//              {"clip": "r", "to": "A"},                             // the part of a line or a polygon in a box
//              {"hierarchy": "M"},                                   // of its triangles; or of objects: ["A", "M"],
//              "all"
//              {"walk": ["r", "A"]},                                 // step by step, as the lesson of such a pair, or
//                                                                    // of one object: "H"; with "lesson": another one
//              {"walk": ["A", "B", "C"], "lesson": "collision",      // of many, or "all"
//               "method": "sweep"} ],
//     "notes": [ {"at": [0, 2, 0], "text": "the *y*-axis"} ],
//     "camera": {"azimuth": 30, "elevation": 20} }                   // degrees
//
// The first field of an object is its type with its name; the others are those of app/scene/objects.h, in the plane
// with two coordinates, in space with three.

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/scene/objects.h"
#include "viz/files.h"

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
  std::vector<std::size_t> objects;  ///< one of them: its triangles
};
struct WalkAsked {
  std::size_t a, b;                    ///< the same where it is of one object
  std::string lesson = {};             ///< its id, where another than the usual one for such objects is asked for
  std::vector<std::size_t> many = {};  ///< where it is of many: all of them, of which a is the first and b the second
  std::string method = {};             ///< of those that the lesson has for many; empty: the first
  bool with_ray = false;               ///< the last of the many is the ray that they are asked by
};
using Asked = std::variant<PairAsked, FirstHitAsked, FitAsked, ClipAsked, HierarchyAsked, WalkAsked>;

struct Note {
  viz::Vec3 at;
  std::string text;  ///< markup
};

struct File {
  std::string title;
  std::vector<Object> objects;
  viz::Parameters parameters;
  std::vector<Asked> asked;
  std::vector<Note> notes;
  viz::Camera camera;
  bool flat = false;
  std::string text;  ///< the file as it is, without comments, and with the points of short files that it names
};

/// Throws viz::BadInput where lists and objects nest so deep that no parser of ours may see them.
void require_shallow(const std::string& text);
/// Whether a text is meant as a scene: JSON with "objects".
bool is_scene(const std::string& text);
/// Whether there are objects of ours in it: not somebody else's JSON with a field of that name.
bool holds_objects(const std::string& text);
/// `folder`: what names of files in it are relative to. Throws viz::BadInput, which names line and field, what is
/// allowed and the nearest name, and viz::FileError.
File read_scene(const std::string& text, const std::string& folder);

/// What `read` gives; what it says of another file, as one of a mesh, is told with the scene's.
template <class Read>
auto naming_scene(const std::string& path, const Read& read) {
  try {
    return read();
  } catch (const viz::FileError& e) {
    throw viz::FileError(path + ": " + e.what());
  }
}

}  // namespace isect::program::scene
