#pragma once
// A question as learning platforms take it: by itself, with all that is needed to answer it.

#include <optional>
#include <string>
#include <vector>

#include "app/excerpt.h"

namespace isect::program::platforms {

/// The picture while the question is open.
struct QuizPicture {
  std::string png, alt;       ///< the file's bytes; plain text
  int width = 0, height = 0;  ///< as it is shown, in pixels of CSS
};

/// An answer to choose, and what is said to it; to the right one nothing is.
struct QuizChoice {
  std::string text, reply;
};

/// An order of tiles that is usually given, and what is said to it.
struct QuizOrder {
  std::vector<int> order;
  std::string reply;
};

/// Texts are markup, unless it says otherwise. Every item has choices; where `number` or `order` is set, it asks for
/// that, and the choices are for platforms that can't.
struct QuizItem {
  std::string id;     ///< as identifier() makes it
  std::string title;  ///< plain text: "Ray and sphere: question 2"; it tells no setting's name, which may be the answer
  std::optional<QuizPicture> picture = {};
  std::string given;              ///< the setting
  std::vector<std::string> code;  ///< the pseudocode, each line with its number; empty if there is none to show
  std::string prompt;             ///< with the numbers that are known
  std::vector<QuizChoice> choices = {};
  std::size_t right = 0;  ///< index into choices
  bool lines = false;     ///< the choices are the lines of the pseudocode, with their numbers
  std::optional<viz::Numeric> number = {};
  std::optional<viz::OrderAsked> order = {};
  std::string solution;  ///< the right answer in words, and why
};

/// Returns the question before a step, which must have one, without its picture. Where it asks for a line, all lines of
/// the pseudocode are its choices.
QuizItem item_of(const Excerpt&, int step, std::string title);

/// Returns an identifier, as XML, QTI and Moodle take it: "isect.ray-sphere.two-roots.03-foot" for the file
/// "ray-sphere/two-roots/03-foot". The same name gives the same one, different names different ones: where a name has
/// other characters, or is too long for Moodle's 100, it ends with a digest.
std::string identifier(const std::string& name);
/// Returns the same kind of name as H5P gives its parts: "1b4e28ba-2fa1-41d2-883f-0016d3cca427".
std::string uuid(const std::string& name);

/// Returns a number in digits that give exactly this double, or all that counts of it, without an exponent.
std::string decimal(double);

/// Returns all right orders of the tiles: more than one where some are equal.
std::vector<std::vector<int>> right_orders(const viz::OrderAsked&);
/// Returns the wrong orders that are known or offered, with what is said to them.
std::vector<QuizOrder> wrong_orders(const viz::OrderAsked&);

}  // namespace isect::program::platforms
