#include "app/figures/figure_info.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/figures/ownership.h"
#include "app/shell/option_values.h"
#include "viz/text/rich_text.h"
#include "viz/walk/alt_text.h"

namespace isect::program {

namespace {

constexpr const char* several = "steps";

/// Returns "03-06" if the steps follow each other, "03+05" otherwise.
std::string numbers(const std::vector<int>& steps) {
  const bool in_a_row = steps.back() - steps.front() + 1 == static_cast<int>(steps.size());
  std::string text;
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (!in_a_row || i == 0 || i + 1 == steps.size())
      text += fmt::format("{}{:02}", text.empty() ? "" : in_a_row ? "-" : "+", steps[i] + 1);
  return text;
}

}  // namespace

FigureInfo info_of(const Excerpt& e, int step) {
  const viz::Step& s = e.walk.steps[step];
  return {file_of(e, step),
          {step},
          s.title,
          s.caption,
          viz::figure_title(*e.lesson, s),
          viz::alt_text(*e.lesson, e.parameters, e.walk, step),
          metadata_of(e, step)};
}

FigureInfo info_of(const Excerpt& e, const std::string& kind) {
  FigureInfo info = {fmt::format("{}/{}-{}", folder_of(e), kind, numbers(e.steps)), e.steps, {}, {}, {}, {}, {}};
  info.title = e.lesson->title;
  info.imprint = fmt::format("{}: steps {}", viz::plain(e.lesson->title), numbers(e.steps));
  for (std::size_t i = 0; i < e.steps.size(); ++i) {
    const FigureInfo one = info_of(e, e.steps[i]);
    const char letter = static_cast<char>('a' + i % 26);
    info.caption += fmt::format("{}({}) {}", i == 0 ? "" : " ", letter, viz::as_sentence(one.title));
    info.alt += fmt::format("{}({}) {}", i == 0 ? "" : "\n\n", letter, one.alt);
  }
  const bool timed = e.time && std::ranges::find(e.steps, *e.step) != e.steps.end();
  info.metadata = metadata_of(e, timed ? *e.step : e.steps.front());
  info.metadata["file"] = info.stem;
  info.metadata[several] = numbers(e.steps);
  return info;
}

bool shows_several(const viz::Metadata& data) { return data.contains(several); }

std::string steps_of(const viz::Metadata& data) {
  if (!shows_several(data)) return {};
  std::string text = data.at(several);
  std::ranges::replace(text, '+', ',');
  return Steps::read(text) ? text : std::string();
}

}  // namespace isect::program
