#pragma once
// A playlist's file: the presets, steps and scenes of an hour, in its order. JSON; comments (// and /* */) are allowed.
//
//   { "title": "Rays and balls",                                        // optional
//     "stops": [ {"lesson": "ray-sphere", "preset": "tangent"},         // all steps of this preset
//                {"lesson": "ray-sphere", "preset": "miss", "steps": "3-6",
//                 "note": "Where does it *end*?"},                      // for those who watch, and for paper
//                {"preset": "mine/grazing.json", "steps": "verdict"},   // a preset's file
//                {"scene": "crates.json"} ] }                           // a scene's file
//
// A stop may also be what Ctrl+C copies in the window, as it is: with "step", "time", "parameters", "camera" and
// "beside". Without "steps" its "step" alone is shown, without either all steps. "steps" is what --step takes: "3-6",
// "3,5,7-9", "-1", a step's name, "verdict", "all", or a number. Files are named relative to the playlist.

#include <string>
#include <vector>

#include "app/excerpt.h"
#include "app/program.h"
#include "viz/player/playlist.h"

namespace isect::program {

struct Selection;

/// Whether a text is meant as a playlist: an object with "stops", which need not be valid JSON.
bool is_playlist(const std::string& text);

/// What is done with a stop that can't be opened.
enum class Faults { refused, kept };
/// Reads a playlist. Throws viz::BadInput, which names the file, the stop's number, line and field, and what is
/// allowed; and viz::FileError. `Faults::kept`: a stop that can't be opened says so itself, in Stop::fault, and is not
/// thrown. Each scene is one lesson, kept as long as the program runs; all of these have the same id.
viz::Playlist read_playlist(const Program&, const std::string& path, Faults = Faults::refused);

/// Returns the file of the playlist that the words of a command name; empty if they name something else. Throws
/// viz::BadInput if they choose a preset, steps, a scene or parameters besides.
std::string playlist_asked(const Selection&);

/// Returns the stops as excerpts, without those that can't be opened.
std::vector<Excerpt> excerpts_of(const viz::Playlist&);

}  // namespace isect::program
