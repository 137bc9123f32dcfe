#pragma once
// The contents of a page to print or a deck's slide, before it is LaTeX or HTML. All texts are markup.

#include <string>
#include <variant>
#include <vector>

#include "app/excerpt.h"
#include "viz/walk/step_text.h"

namespace isect::program {

struct Heading {
  std::string text;
  int level = 2;        ///< 1 is a page's title
  std::string id = {};  ///< by which a web page links to it; may be empty
};
/// Paragraphs are separated by '\n'. The head, if there is one, runs into the first: "Question 2."
struct Prose {
  std::string text, head = {};
};
/// Pseudocode, its names set as in the text; `current` is lit, from 0, -1 for none.
struct Code {
  std::vector<std::string> lines;  ///< markup, except for the spaces that indent them
  int current = -1;
  std::string said = {};  ///< at its end: "yes", "no"
  int first = 1;          ///< the number of the first line
};
struct Image {
  std::string stem;  ///< beside the page: stem.tikz, stem.svg
  std::string svg;   ///< its bytes if the page contains them, empty if it points to the file
  std::string alt;
  bool fits = false;  ///< shrinks where there is less room
};
/// Answers to choose from: (a), (b), ...
struct Choices {
  std::vector<std::string> all;
};
/// Room for an answer in writing: the words before it, and how many blanks.
struct Blanks {
  std::string head;
  int count = 1;
};
/// The stops of a playlist, each with its number, from 1.
struct Stops {
  struct Entry {
    int number = 1;
    std::string text;
  };
  std::vector<Entry> all;
  bool linked = false;  ///< to the heading with the id "stop-3"
};
/// On paper, what follows begins a page.
struct NewPage {};
/// On a slide, what follows appears at the next key. Never on paper.
struct Pause {};

using Block = std::variant<Heading, Prose, Code, Image, Choices, Blanks, Stops, NewPage, Pause>;
using Blocks = std::vector<Block>;

inline void append(Blocks& to, const Blocks& more) { to.insert(to.end(), more.begin(), more.end()); }

/// Returns the paragraphs of a text, without empty ones.
std::vector<std::string> paragraphs(const std::string& markup);

/// Returns what a reader needs to compute along: "*r* = 2, ... Box a: (0, 0) to (1, 1)." Values of a preset are given
/// in full, and those that were moved by hand in a few digits.
std::string given(const viz::Lesson&, const viz::Parameters&, const viz::Walk&);
/// Returns an exercise's prompt with the preset from which it starts, if any: "... until they touch. (Preset ends.)"
std::string prompt(const viz::Exercise&);
/// Returns an exercise: its prompt, and the lines of the program that it shows, if any.
Blocks exercise(const viz::Lesson&, const viz::Exercise&, const std::string& head = {});
/// Returns those lines alone.
Blocks shown_program(const viz::Lesson&, const viz::Exercise&);
/// Returns a question and its answers to choose from, or the things to put in order; blanks for an order or a line.
Blocks question(const viz::QuestionText&, const std::string& head = {});
/// Returns "(b) It misses. The reason why.", "Line 4: return MISS. The reason why."
Prose answer(const viz::QuestionText&, const std::string& head = {});
/// Returns the pseudocode with its errata, if there is any.
Blocks algorithm(const Excerpt&);
/// Returns the pseudocode, this line of it lit, if one is.
Code code(const Excerpt&, const std::optional<viz::LineText>& lit = {});
/// Returns the lit line alone, without its indentation.
Code line_alone(const Excerpt&, const viz::LineText&);

}  // namespace isect::program
