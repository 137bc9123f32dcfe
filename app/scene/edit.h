#pragma once
// Edits of a scene file's text: an object more or less, another name, a question more. All else of the text stays as it
// is, with its comments and its order. What the reader would refuse is refused in the same words, as viz::BadInput.

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
/// Adds a question, as an entry of "ask".
std::string with_question(const std::string& text, const Json& asked);

/// Returns the field of an object that is its type, with its name: "circle"; empty: it has none.
std::string type_field(const Json& object);
/// Returns JSON on one line as people write it: {"box": "A", "lo": [0, 0], "hi": [1, 1]}.
std::string on_one_line(const Json&);

}  // namespace isect::program::scene
