#include "app/figures/lesson_opening.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/figures/value_words.h"
#include "app/shell/terminal.h"
#include "viz/lang/message.h"
#include "viz/text/rich_text.h"
#include "viz/text/utf8.h"
#include "viz/walk/scene_in_words.h"
#include "viz/walk/step_text.h"

namespace isect::program {
namespace {

using viz::plain;

std::string settings(const Excerpt& e, std::size_t columns) {
  std::string out = viz::tr("Setting:") + "\n";
  for (const viz::Parameter& p : e.lesson->parameters) {
    if (!e.parameters.contains(p.name)) continue;  // the choices decide it
    const std::string name = plain(p.label.empty() ? p.name : p.label);
    out +=
        wrapped(fmt::format("{} = {}. {}", name, in_full(e.parameters.at(p.name), e.lesson->flat), p.help), columns, 2);
  }
  return out + "\n";
}

/// Returns what is fixed besides the parameters.
std::string objects(const Excerpt& e, std::size_t columns) {
  const viz::Scene& scene = e.walk.steps.front().scene;
  if (scene.chart) return {};
  std::string out;
  for (const std::string& object : viz::scene_in_words(scene, e.parameters, e.lesson->flat))
    out += wrapped(object, columns, 2);
  return out.empty() ? out : viz::tr("Objects:") + "\n" + out + "\n";
}

std::string pseudocode(const Excerpt& e, std::size_t columns) {
  if (e.walk.pseudocode.empty()) return {};
  std::string out = viz::tr("Algorithm:") + "\n" + numbered(e.walk.pseudocode, columns);
  for (const viz::ErratumText& erratum : viz::errata_text(*e.lesson, e.walk))
    out += wrapped(plain(viz::with_preset(erratum, &viz::Preset::id)), columns, 2);
  return out + "\n";
}

}  // namespace

std::string numbered(const std::vector<std::string>& pseudocode, std::size_t columns) {
  std::string out;
  for (std::size_t i = 0; i < pseudocode.size(); ++i) {
    const std::string& code = pseudocode[i];
    const std::string text = viz::unindented(code);
    std::string line = std::string(6, ' ') + code + "\n";
    if (viz::count_characters(line) > columns + 1) line = wrapped(text, columns - 2, 6 + code.size() - text.size());
    for (std::size_t at = line.find('\n'); at + 1 < line.size(); at = line.find('\n', at + 1))
      line.insert(at + 1, "  ");
    out += fmt::format("  {:>2}", i + 1) + line.substr(4);
  }
  return out;
}

std::string lesson_opening(const Excerpt& e, const TextOptions& how) {
  const std::string given = settings(e, how.columns);
  return how.brief ? given : given + objects(e, how.columns) + pseudocode(e, how.columns);
}

}  // namespace isect::program
