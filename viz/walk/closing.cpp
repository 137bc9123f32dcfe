#include "viz/walk/closing.h"

#include <algorithm>
#include <sstream>

#include "viz/chart/case_map.h"
#include "viz/lang/language.h"
#include "viz/lang/lesson_texts.h"
#include "viz/lang/message.h"
#include "viz/text/rich_text.h"
#include "viz/walk/question_scene.h"

namespace isect::viz {

int outcome(const Walk& walk) {
  int step = static_cast<int>(walk.steps.size()) - 1;
  const auto surrounds = [&](const std::string& slug) { return slug == case_map_slug || slug == closing_slug; };
  while (step > 0 && surrounds(walk.steps[step].slug)) --step;
  return step;
}

std::string own_caption(const Lesson& lesson, const Step& step) {
  const std::string opening = lesson.opening + "\n";
  return !lesson.opening.empty() && step.caption.starts_with(opening) ? step.caption.substr(opening.size())
                                                                      : step.caption;
}

int line_of(const Erratum& e, const Walk& walk) {
  const auto found = std::ranges::find_if(
      walk.pseudocode, [&](const std::string& line) { return line == e.published || line == e.corrected; });
  return found == walk.pseudocode.end() ? -1 : static_cast<int>(found - walk.pseudocode.begin());
}

std::vector<Card::Row> card_rows(const Closing& c) {
  return {{tr("Result"), c.result},
          {tr("Cost"), c.cost},
          {tr("Choose it"), c.choose},
          {tr("Used"), c.used},
          {tr("Typical bug"), c.bug}};
}

std::vector<Card::Row> card_rows(const Lesson& lesson, std::size_t most_named) {
  std::vector<Card::Row> rows = card_rows(*lesson.closing);
  std::string text;
  for (const SharedIdea& shared : shared_ideas(lesson)) {
    const SharedIdea told = {spoken_text(lesson, shared.idea), {}};
    text += (text.empty() ? "" : ". ") + heading(told) + ": ";
    const std::size_t all = shared.others.size(), named = all <= most_named ? all : most_named - 1;
    for (std::size_t i = 0; i < named; ++i)
      text += (i == 0 ? "" : ", ") + short_title(lesson_in(*shared.others[i], spoken()));
    if (named < all) text += " " + tr_count(all - named, "and {n} more", "and {n} more");
  }
  if (!text.empty()) rows.push_back({tr(shared_head), text + "."});
  return rows;
}

std::string heading(const SharedIdea& shared) {
  std::string text = shared.idea;
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z' && !text.starts_with("k-")) text[0] += 'A' - 'a';
  return text;
}

std::vector<SharedIdea> shared_ideas(const Lesson& lesson) {
  return lesson.shared ? lesson.shared(lesson) : std::vector<SharedIdea>();
}

std::string short_title(const Lesson& lesson) { return lesson.title.substr(0, lesson.title.find(':')); }

std::optional<Judge> judge(const Lesson& lesson) {
  if (lesson.query.empty()) return {};
  Judge own = {
      tr("Write this test yourself, in any language. The command “isect query” reads one case a line, as JSON, and "
         "answers each exactly: so it can judge your program. For instance:"),
      {}};
  std::istringstream lines(lesson.query);
  for (std::string line; std::getline(lines, line);)  // several words of echo are one line
    own.command.push_back((own.command.empty() ? "echo '" : "     '") + unindented(line) + "' \\");
  own.command.back().pop_back();
  own.command.back() += "| isect query";
  return own;
}

Step closing_step(const Lesson& lesson, const Step& before) {
  const Closing& closing = *lesson.closing;
  Step step = before;
  step.slug = closing_slug, step.title = tr("What to remember");
  step.caption = closing.result;
  for (const std::string& source : closing.reading) step.caption += "\n" + tr("Read: {source}", {{"source", source}});
  step.formula = {}, step.source = {};
  if (!closing.reading.empty()) step.source = closing.reading.front();
  step.decides = false;
  step.comparison.reset(), step.question.reset();
  for (Value& value : step.values) value.fresh = false;
  step.scene = {};
  step.scene.chart = std::make_shared<const Chart>(Chart{Card{card_rows(lesson, named_on_card)}});
  return step;
}

/// Returns the step that comes before a first step with a question.
static Step opening_step(const Lesson& lesson, const Walk& walk) {
  const Step& first = walk.steps.front();
  Step step;
  step.slug = opening_slug, step.title = tr("The setting"), step.caption = lesson.opening, step.source = first.source;
  step.scene = opening_scene(first);
  return step;
}

Walk Lesson::walk(const Parameters& here) const {
  const Speaking speaking(language);
  Walk walk = steps(here);
  if (walk.steps.empty()) return walk;
  ask_once(walk);
  if (walk.steps.front().question && !opening.empty())
    walk.steps.insert(walk.steps.begin(), opening_step(*this, walk));
  else if (!opening.empty())
    walk.steps.front().caption = opening + "\n" + walk.steps.front().caption;
  const Step last = walk.steps.back();
  if (map)
    if (const std::optional<Cases::Spot> spot = spot_on(*map, here))
      walk.steps.push_back(map_step(*this, here, *spot, last));
  if (closing) walk.steps.push_back(closing_step(*this, last));
  return walk;
}

}  // namespace isect::viz
