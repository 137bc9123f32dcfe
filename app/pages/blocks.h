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

/// What a reader needs to compute along: "*r* = 2, ... Box a: (0, 0) to (1, 1)." What a preset has is told in full, and
/// what was moved by hand in a few digits.
std::string given(const viz::Lesson&, const viz::Parameters&, const viz::Walk&);
/// Of the question before `step`, among all of the walk, from 1.
int number_of_question(const viz::Walk&, int step);
/// A question's prompt with the numbers that it is given.
std::string prompt(const viz::Question&);
/// The same with all that is known of the step that it is asked before: for a page that has no other place for that.
std::string prompt(const viz::Walk&, int step);
/// An exercise's prompt with the preset that it starts from, if it has one: "... until they touch. (Preset ends.)"
std::string prompt(const viz::Exercise&);
/// "(b) It misses. The reason why."
std::string answer(const viz::Question&);
/// The pseudocode.
Code code(const Excerpt&, int current = -1);

}  // namespace isect::program
