#pragma once
// A scene file: objects of one's own, and what is asked of them. JSON, as presets and queries are, so that an object
// can be copied from one to the other; comments (// and /* */) are allowed.
//
//   { "title": "A ray past a box",                                   // may be left out, as may all but "objects"
//     "objects": [ {"ray": "r", "origin": [-4, 0, 1], "dir": [1, 0, 0]},
//                  {"box": "A", "lo": [-1, -1, -1], "hi": [1, 1, 1]} ],
//     "ask": [ ["r", "A"] ],                                         // or "all pairs"; {"first hit": "r"} among all
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

namespace isect::program::scene {

struct PairAsked {
  std::size_t a, b;  ///< indices of objects
};
struct FirstHitAsked {
  std::size_t ray;
};
using Asked = std::variant<PairAsked, FirstHitAsked>;

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
  std::string text;  ///< the file as it is, without comments
};

/// Whether a text is meant as a scene: JSON with "objects".
bool is_scene(const std::string& text);
/// Whether there are objects of ours in it: not somebody else's JSON with a field of that name.
bool holds_objects(const std::string& text);
/// Throws viz::BadInput, which names line and field, what is allowed and the nearest name.
File read_scene(const std::string& text);

}  // namespace isect::program::scene
