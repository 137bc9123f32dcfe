#pragma once
// What stands on a page of a handout or a slide of a deck, before it is LaTeX or HTML. All texts are markup.

#include <string>
#include <variant>
#include <vector>

#include "app/excerpt.h"

namespace isect::program {

struct Heading {
  std::string text;
};
/// Paragraphs are parted by '\n'. The head, if there is one, runs into the first: "Question 2."
struct Prose {
  std::string text, head = {};
};
/// Pseudocode, its names set as in the text; `current` is lit, from 0, -1 for none.
struct Code {
  std::vector<std::string> lines;  ///< markup, but for the spaces that indent them
  int current = -1;
};
struct Image {
  std::string stem;  ///< beside the page: stem.tikz, stem.svg
  std::string svg;   ///< its bytes where the page carries them, empty where it points to the file
  std::string alt;
  bool fits = false;  ///< shrinks where there is less room
};
/// Answers to choose from: (a), (b), ...
struct Choices {
  std::vector<std::string> all;
};
/// On a slide, what follows comes at the next key. Never on paper.
struct Pause {};

using Block = std::variant<Heading, Prose, Code, Image, Choices, Pause>;
using Blocks = std::vector<Block>;

/// The letter of an answer: 'a' for 0.
char choice_letter(std::size_t i);
/// Those of a text, without empty ones.
std::vector<std::string> paragraphs(const std::string& markup);

/// A question's prompt with the numbers that it is given.
std::string prompt(const viz::Question&);
/// What of a lesson stands on more than one kind of page.
Blocks question(const viz::Question&, int number);
/// "(b) It misses. The reason why."
std::string answer(const viz::Question&);
Image image(const Excerpt&, int step);
Code code(const Excerpt&, int current = -1);

}  // namespace isect::program
