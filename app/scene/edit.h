#pragma once
// Edits of a scene file's text: an object more or less, another name, a question more or less, a corner more or
// less. All else of the text stays as it is, with its comments and its order. What the reader would refuse is refused
// in the same words, as viz::BadInput.

#include <string>

#include "app/scene/types.h"

namespace isect::program::scene {

/// Returns the first free one of A, B, ..., Z, A1, B1, ...
std::string free_name(const std::string& text);

/// Adds an object behind the others.
std::string with_object(const std::string& text, Type, const std::string& name, const Start&);
/// Removes an object, and the questions that name it. Of a question about three objects or more only its name is
/// removed.
std::string without_object(const std::string& text, const std::string& name);
/// Gives an object another name, in the questions, too.
std::string with_name(const std::string& text, const std::string& name, const std::string& now);
/// Leaves an object out of the picture, or draws it again.
std::string with_hidden(const std::string& text, const std::string& name, bool hidden);
/// Hides the scene's answers, or shows them.
std::string with_answers(const std::string& text, bool hidden);
/// Has the scene told in a language, given as a code.
std::string with_language(const std::string& text, const std::string& code);
/// Adds a question, as an entry of "ask".
std::string with_question(const std::string& text, const Json& asked);
/// Removes the first entry of "ask" that is this question. "all pairs" is one, too: then nothing is asked.
std::string without_question(const std::string& text, const Json& asked);
/// Whether a question, an entry of "ask" or "all pairs", names this object, or all objects.
bool is_about(const Json& asked, const std::string& name);

/// Adds a corner to a polygon behind one of its corners, which are counted from 1 through all its outlines. `place`: in
/// the scene, where the polygon's "at" has moved it.
std::string with_corner(const std::string& text, const std::string& name, int corner, const viz::Vec3& place);
/// Removes that corner.
std::string without_corner(const std::string& text, const std::string& name, int corner);

/// Returns the field of an object that is its type, with its name: "circle"; empty: it has none.
std::string type_field(const Json& object);
/// Returns JSON on one line as people write it: {"box": "A", "lo": [0, 0], "hi": [1, 1]}.
std::string on_one_line(const Json&);

}  // namespace isect::program::scene
