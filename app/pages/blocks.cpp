#include "app/pages/blocks.h"

#include <fmt/format.h>

#include "viz/alt_text.h"
#include "viz/snapshot.h"

namespace isect::program {

char choice_letter(std::size_t i) { return static_cast<char>('a' + i); }

std::vector<std::string> paragraphs(const std::string& markup) {
  std::vector<std::string> all;
  for (std::size_t from = 0; from < markup.size();) {
    const std::size_t end = std::min(markup.find('\n', from), markup.size());
    if (end > from) all.push_back(markup.substr(from, end - from));
    from = end + 1;
  }
  return all;
}

Blocks question(const viz::Question& q, int number) {
  return {Prose{q.prompt, fmt::format("Question {}.", number)}, Choices{q.choices}};
}

std::string answer(const viz::Question& q) {
  const auto right = static_cast<std::size_t>(q.answer);
  return fmt::format("({}) {}. {}", choice_letter(right), q.choices.at(right), q.because);
}

Image image(const Excerpt& e, int step) {
  return {viz::file_stem(step, e.walk.steps[step]), {}, viz::alt_text(*e.lesson, e.parameters, e.walk, step)};
}

}  // namespace isect::program
