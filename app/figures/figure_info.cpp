#include "app/figures/figure_info.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/figures/cases.h"
#include "app/figures/ownership.h"
#include "app/shell/option_values.h"
#include "viz/lang/language.h"
#include "viz/lang/message.h"
#include "viz/text/rich_text.h"
#include "viz/walk/alt_text.h"

namespace isect::program {

namespace {

constexpr const char* several = "steps";

/// Returns the titles of the lessons, each once.
std::string lessons_of(Excerpts cases) {
  std::vector<std::string> titles;
  for (const Excerpt& e : cases)
    if (std::ranges::find(titles, e.lesson->title) == titles.end()) titles.push_back(e.lesson->title);
  return fmt::format("{}", fmt::join(titles, "; "));
}

/// Adds to what a figure carries the settings at whose scale it is drawn.
viz::Metadata with_scale(viz::Metadata data, const Excerpt& e) {
  if (e.scaled_with) keep_cases(data, *e.scaled_with, e.scaled_as);
  return data;
}

}  // namespace

std::string faces_of(const std::string& stem) { return stem + "-faces"; }

FigureInfo info_of(const Excerpt& e, int step) {
  const viz::Step& s = e.walk.steps[step];
  return {file_of(e, step),
          {step},
          s.title,
          s.caption,
          viz::figure_title(*e.lesson, s),
          viz::alt_text(*e.lesson, e.parameters, e.walk, step),
          with_scale(metadata_of(e, step), e)};
}

FigureInfo info_of(Excerpts cases, const std::string& kind) {
  const bool one = cases.size() == 1;
  const Excerpt& first = cases[0];
  const viz::Speaking speaking(first.lesson->language);
  FigureInfo info = {stem_of(cases, kind), {}, {}, {}, {}, {}, {}};
  info.title = lessons_of(cases);
  const std::vector<std::string> titles = part_captions(cases, false);
  for (const Excerpt& e : cases)
    for (const int step : e.steps) {
      const std::size_t i = info.steps.size();
      info.steps.push_back(step);
      const char letter = static_cast<char>('a' + i % 26);
      const std::string title = viz::as_sentence(titles[i]);
      info.caption += fmt::format("{}({}) {}", i == 0 ? "" : " ", letter, title);
      info.alt += fmt::format("{}({}) {}{}", i == 0 ? "" : "\n\n", letter, one ? "" : viz::plain(title) + " ",
                              viz::alt_text(*e.lesson, e.parameters, e.walk, step));
    }
  std::vector<std::string> called = case_titles(cases);
  for (std::string& title : called) title = viz::plain(title);
  info.imprint = viz::plain(info.title) + ": " +
                 (one ? viz::tr("steps {steps}", {{"steps", numbers_of(first.steps)}})
                      : fmt::format("{}", fmt::join(called, ", ")));
  const bool timed = first.time && std::ranges::find(first.steps, *first.step) != first.steps.end();
  info.metadata = metadata_of(first, timed ? *first.step : first.steps.front());
  info.metadata["file"] = info.stem;
  if (one) info.metadata[several] = numbers_of(first.steps);
  if (one) info.metadata = with_scale(std::move(info.metadata), first);
  if (!one) keep_cases(info.metadata, cases);
  return info;
}

bool shows_several(const viz::Metadata& data) { return data.contains(several) || shows_cases(data); }

std::string steps_of(const viz::Metadata& data) {
  if (!data.contains(several)) return {};
  std::string text = data.at(several);
  std::ranges::replace(text, '+', ',');
  return Steps::read(text) ? text : std::string();
}

}  // namespace isect::program
