#pragma once
// All that a lesson says, in any of its presets.

#include <string>
#include <variant>
#include <vector>

#include "viz/chart/chart.h"
#include "viz/lesson.h"
#include "viz/walk/closing.h"

namespace isect::tests {

/// The lesson's texts as markup, without those that it shares with other lessons.
inline std::vector<std::string> texts(const viz::Lesson& lesson) {
  std::vector<std::string> all = {lesson.title, lesson.summary, lesson.opening};
  for (const viz::Parameter& p : lesson.parameters) all.insert(all.end(), {p.label, p.help});
  for (const viz::Card::Row& row : card_rows(*lesson.closing)) all.insert(all.end(), {row.head, row.text});
  all.insert(all.end(), lesson.closing->reading.begin(), lesson.closing->reading.end());
  for (const viz::Exercise& e : lesson.closing->exercises) {
    all.insert(all.end(), {e.prompt, e.solution});
    all.insert(all.end(), e.program.begin(), e.program.end());
  }
  if (const auto own = viz::judge(lesson)) all.push_back(own->told);
  for (const viz::Erratum& e : lesson.errata) all.insert(all.end(), {e.published, e.corrected, e.why});
  if (lesson.map) all.insert(all.end(), {lesson.map->x_title, lesson.map->y_title, lesson.map->told});
  for (const viz::Preset& p : lesson.presets) {
    all.push_back(p.title);
    if (lesson.opinions)
      for (const viz::Opinion& o : lesson.opinions(p.parameters)) all.insert(all.end(), {o.method, o.says});
    const viz::Walk walk = lesson.walk(p.parameters);
    all.insert(all.end(), {walk.method, walk.alt});
    all.insert(all.end(), walk.pseudocode.begin(), walk.pseudocode.end());
    for (const viz::Step& s : walk.steps) {
      all.insert(all.end(), {s.title, s.caption, s.formula, s.source, s.verdict.text});
      for (const viz::Value& v : s.values) all.push_back(v.name);
      for (const viz::Item& item : s.scene.items) {
        if (const auto* label = std::get_if<viz::Label>(&item)) all.push_back(label->text);
        if (const auto* heading = std::get_if<viz::Heading>(&item)) all.push_back(heading->text);
      }
      if (!s.question) continue;
      all.insert(all.end(), {s.question->prompt, s.question->because});
      all.insert(all.end(), s.question->choices.begin(), s.question->choices.end());
      if (const auto& number = s.question->number)
        for (const viz::WrongNumber& wrong : number->wrong) all.push_back(wrong.reply);
      if (const auto& line = s.question->line)
        for (const viz::WrongLine& wrong : line->wrong) all.push_back(wrong.reply);
      if (const auto& order = s.question->order)
        for (const viz::WrongOrder& wrong : order->wrong) all.push_back(wrong.reply);
    }
  }
  return all;
}

}  // namespace isect::tests
