#include "viz/walk/pointed_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "viz/lang/message.h"

namespace isect::viz {
namespace {

/// Returns what a line does up to a step that lights another one.
std::string what_it_does(const Walk& walk, int step, int line) {
  const Step& asked = walk.steps.at(static_cast<std::size_t>(step));
  const std::string n = std::to_string(line + 1);
  if (std::ranges::count(asked.refused, line) > 0) return tr("Line {n} has run: its condition was false.", {{"n", n}});
  if (std::ranges::count(asked.untaken, line) > 0)
    return tr("Line {n} stands in a branch that was not taken.", {{"n", n}});
  const auto lit = [&](const Step& s) { return s.line == line; };
  if (std::any_of(walk.steps.begin(), walk.steps.begin() + step, lit))
    return tr("Line {n} was told at an earlier step. It is not the one that is told next.", {{"n", n}});
  return tr("Line {n} is not the one that is told next.", {{"n", n}});
}

}  // namespace

int line_from(const std::string& typed, int lines) {
  std::string text;
  for (const char c : typed)
    if (c != ' ') text += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (text.starts_with("line")) text.erase(0, 4);
  if (text.empty()) throw BadInput("a line's number is missing");
  if (!std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; }))
    throw BadInput("“" + typed + "” is not a line's number");
  const int number = text.size() > 4 ? lines + 1 : std::stoi(text);
  if (number < 1 || number > lines) throw BadInput(fmt::format("the lines have the numbers 1 to {}", lines));
  return number - 1;
}

std::string how_to_point() { return tr("Point at a line of the pseudocode, or type its number."); }

std::vector<std::string> line_replies(const Walk& walk, int step) {
  const LineAsked& asked = *walk.steps.at(static_cast<std::size_t>(step)).question->line;
  std::vector<std::string> all;
  for (int line = 0; line < static_cast<int>(walk.pseudocode.size()); ++line) {
    const auto known = std::ranges::find(asked.wrong, line, &WrongLine::line);
    all.push_back(line == asked.truth          ? std::string()
                  : known == asked.wrong.end() ? what_it_does(walk, step, line)
                                               : known->reply);
  }
  return all;
}

int choice_of_line(const Question& question, int line) {
  const std::vector<int>& offered = question.line->offered;
  const auto found = std::ranges::find(offered, line);
  return found == offered.end() ? -1 : static_cast<int>(found - offered.begin());
}

}  // namespace isect::viz
