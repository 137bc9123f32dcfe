#include "app/told.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "app/geometry.h"
#include "app/terminal.h"
#include "viz/case_map.h"
#include "viz/closing.h"
#include "viz/rich_text.h"

namespace isect::program {

namespace {

using viz::plain;

/// In full, so that a reader can compute along.
std::string coordinates(const viz::Vec3& p, bool flat) {
  const std::string xy = viz::to_text(p.x()) + ", " + viz::to_text(p.y());
  return "(" + xy + (flat ? ")" : ", " + viz::to_text(p.z()) + ")");
}

bool contains(const std::vector<int>& lines, int line) { return std::ranges::find(lines, line) != lines.end(); }

std::string in_full(const viz::Setting& setting, bool flat) {
  if (const auto* p = std::get_if<viz::Vec3>(&setting)) return coordinates(*p, flat);
  return viz::to_text(setting);
}

/// "Title" over a line of `rule`.
std::string heading(const std::string& text, char rule, std::size_t width) {
  return inked(Ink::bold, wrapped(text, width, 0)) + std::string(std::min(length(text), width), rule) + "\n";
}

class Teller {
 public:
  Teller(const Excerpt& e, const Telling& how) : e_(e), how_(how) {}

  std::string all() {
    std::string out = opening();
    for (const int step : e_.steps) out += how_.brief ? line_of(step) : whole(step);
    if (!answers_.empty()) out += heading("Answers", '-', how_.columns) + answers_ + "\n";
    out.pop_back();
    return out;
  }

 private:
  std::string paragraph(const std::string& text, std::size_t indent = 0) const {
    return wrapped(text, how_.columns, indent);
  }

  std::string opening() const {
    const viz::Lesson& lesson = *e_.lesson;
    std::string out =
        heading(fmt::format("{}: {}", plain(lesson.title), e_.folder), '=', how_.columns) + paragraph(lesson.summary);
    if (!e_.walk.method.empty()) out += paragraph("Method: " + plain(e_.walk.method));
    return out + "\n" + setting() + pseudocode();
  }

  /// What a reader needs to compute along.
  std::string setting() const {
    std::string out = "Setting:\n";
    for (const viz::Parameter& p : e_.lesson->parameters) {
      const std::string name = plain(p.label.empty() ? p.name : p.label);
      out += paragraph(fmt::format("{} = {}. {}", name, in_full(e_.parameters.at(p.name), e_.lesson->flat), p.help), 2);
    }
    return out + "\n" + objects();
  }

  /// What is fixed besides the parameters.
  std::string objects() const {
    const viz::Scene& scene = e_.walk.steps.front().scene;
    const std::vector<std::string> all =
        scene.chart ? std::vector<std::string>{} : geometry(scene, e_.parameters, e_.lesson->flat);
    if (all.empty() || how_.brief) return {};
    std::string out = "Objects:\n";
    for (const std::string& object : all) out += paragraph(object, 2);
    return out + "\n";
  }

  std::string pseudocode() const {
    if (how_.brief || e_.walk.pseudocode.empty()) return {};
    std::string out = "Algorithm:\n";
    for (std::size_t i = 0; i < e_.walk.pseudocode.size(); ++i)
      out += fmt::format("  {:>2}  {}\n", i + 1, e_.walk.pseudocode[i]);
    for (const viz::Erratum& erratum : e_.lesson->errata) {
      const int line = viz::line_of(erratum, e_.walk);
      if (line < 0) continue;
      const bool published = e_.walk.pseudocode[line] == erratum.published;
      const std::string& other = published ? erratum.corrected : erratum.published;
      out += paragraph(fmt::format("Line {} {}: {}. {} (Preset {} shows it.)", line + 1,
                                   published ? "should read" : "was published as", viz::unindented(other),
                                   plain(erratum.why), erratum.preset),
                       2);
    }
    return out + "\n";
  }

  std::string title(int index) const {
    return fmt::format("Step {} of {}: {}", index + 1, e_.walk.steps.size(), plain(e_.walk.steps[index].title));
  }

  std::string line_of(int index) const {
    const viz::Step& step = e_.walk.steps[index];
    std::string out = title(index) + ".";
    if (step.comparison) out += " " + comparison(step);
    if (step.verdict.kind != viz::Verdict::Kind::open) out += " Verdict: " + plain(step.verdict.text) + ".";
    return paragraph(out);
  }

  std::string whole(int index) {
    const viz::Step& step = e_.walk.steps[index];
    std::string out = step.question ? question(*step.question) : "";  // a title may tell the answer
    out += heading(title(index), '-', how_.columns);
    if (step.slug == viz::closing_slug) return out + closing();
    out += paragraph(step.slug == viz::case_map_slug ? map_in_words() : plain(step.caption)) + "\n";
    if (step.line >= 0) out += line(step);
    if (!step.formula.empty()) out += paragraph(plain(step.formula), 5) + "\n";
    out += values(step) + points(step);
    if (step.comparison) out += paragraph(comparison(step)) + "\n";
    if (step.verdict.kind != viz::Verdict::Kind::open)
      out += inked(Ink::bold, paragraph("Verdict: " + plain(step.verdict.text))) + "\n";
    if (index == viz::outcome(e_.walk)) out += paragraph("Picture: " + plain(e_.walk.alt)) + "\n" + side_by_side();
    if (!step.source.empty()) out += paragraph("Source: " + step.source) + "\n";
    return out;
  }

  std::string line(const viz::Step& step) const {
    const std::string code = viz::unindented(e_.walk.pseudocode.at(step.line));
    return inked(Ink::mark, fmt::format("  ▸ line {}:  {}{}", step.line + 1, code,
                                        contains(step.refused, step.line) ? "   (no)" : "")) +
           "\n\n";
  }

  /// What this step computes; what was known before stands above, but for the first step told.
  std::string values(const viz::Step& step) const {
    const bool all = &step == &e_.walk.steps[e_.steps.front()];
    const std::string formula = plain(step.formula);
    const auto told = [&](const viz::Value& v) {
      const bool there = formula.starts_with(plain(v.name) + " = ") && formula.ends_with("= " + viz::shown(v.value));
      return (v.fresh || all) && !there;
    };
    std::size_t widest = 0;
    for (const viz::Value& v : step.values)
      if (told(v)) widest = std::max(widest, length(plain(v.name)));
    std::string out;
    for (const viz::Value& v : step.values)
      if (told(v)) {
        const std::string name = plain(v.name);
        out += fmt::format("     {}{} = {}\n", std::string(widest - length(name), ' '), name, viz::shown(v.value));
      }
    return out.empty() ? out : out + "\n";
  }

  /// Where the points lie that the picture names and that are no parameters, when they first appear.
  std::string points(const viz::Step& step) {
    std::string list;
    for (const viz::Item& item : step.scene.items) {
      const auto* label = std::get_if<viz::Label>(&item);
      if (!label || label->until || !label->text.starts_with("**") || !is_marked(step.scene, label->at)) continue;
      const std::string told = plain(label->text) + " " + coordinates(label->at, e_.lesson->flat);
      if (is_parameter(label->at) || !placed_.insert(told).second) continue;
      list += (list.empty() ? "" : ", ") + told;
    }
    return list.empty() ? list : paragraph("In the picture: " + list + ".") + "\n";
  }

  bool is_parameter(const viz::Vec3& p) const {
    return std::ranges::any_of(e_.parameters, [&](const auto& given) { return given.second == viz::Setting(p); });
  }

  static bool is_marked(const viz::Scene& scene, const viz::Vec3& at) {
    return std::ranges::any_of(scene.items, [&](const viz::Item& item) {
      const auto* dot = std::get_if<viz::Dot>(&item);
      return dot && dot->at == at;
    });
  }

  static std::string comparison(const viz::Step& step) {
    const viz::Comparison& c = *step.comparison;
    const std::string meaning = c.meaning.empty() ? "" : ": " + plain(c.meaning);
    const auto [left, right] = viz::shown_apart(c.left, c.right);
    return fmt::format("Is {}? {} ({} and {}){}.", plain(c.text), c.holds ? "Yes" : "No", left, right, meaning);
  }

  std::string map_in_words() const {
    const viz::CaseMap& map = *e_.lesson->map;
    std::string regions;
    for (const std::string& branch : map.branches) regions += (regions.empty() ? "" : "; ") + plain(branch);
    return fmt::format("A map of all cases. Across: {}. Up: {}.\n{}\nIts cases: {}.\nThis setting: {}.",
                       plain(map.x_title), plain(map.y_title), plain(map.told), regions,
                       plain(map.branches.at(static_cast<std::size_t>(map.branch(e_.parameters)))));
  }

  /// What the methods say that should agree.
  std::string side_by_side() const {
    if (!e_.lesson->opinions) return {};
    const std::vector<viz::Opinion> opinions = e_.lesson->opinions(e_.parameters);
    std::size_t widest = 0;
    for (const viz::Opinion& o : opinions) widest = std::max(widest, length(plain(o.method)));
    std::string out = "Methods side by side:\n";
    for (const viz::Opinion& o : opinions) {
      const std::string method = plain(o.method);
      std::string row = fmt::format(" {} {}{}  {}", o.agrees ? "✓" : "✗", method,
                                    std::string(widest - length(method), ' '), plain(o.says));
      if (length(row) > how_.columns)
        row = fmt::format(" {} {}:\n", o.agrees ? "✓" : "✗", method) + paragraph(plain(o.says), 5);
      else
        row += "\n";
      out += o.agrees ? row : inked(Ink::bold, row);
    }
    return out + "\n";
  }

  std::string question(const viz::Question& q) {
    std::string out = paragraph(fmt::format("Question {}: {}", ++asked_, plain(q.prompt)));
    for (std::size_t i = 0; i < q.choices.size(); ++i)
      out += paragraph(fmt::format("{}. {}", i + 1, plain(q.choices[i])), 4);
    const std::string right = plain(q.choices.at(static_cast<std::size_t>(q.answer)));
    if (how_.answers) return out + paragraph(fmt::format("Answer: {}. {}", right, plain(q.because))) + "\n";
    answers_ += paragraph(fmt::format("Question {}: {}. {}", asked_, right, plain(q.because)));
    return out + "\n";
  }

  std::string closing() {
    const viz::Closing& c = *e_.lesson->closing;
    std::string out;
    for (const auto& [head, text] : viz::card_rows(c)) out += paragraph(head + ": " + plain(text));
    out += paragraph(fmt::format("See it: --preset {}", c.bug_preset), 2) + "\nTo read:\n";
    for (const std::string& source : c.reading) out += paragraph(plain(source), 2);
    out += "\n";
    for (std::size_t i = 0; i < c.exercises.size(); ++i) {
      out += paragraph(fmt::format("Exercise {}: {}", i + 1, plain(c.exercises[i].prompt)));
      const std::string solution = plain(c.exercises[i].solution);
      if (how_.answers)
        out += paragraph("Solution: " + solution) + "\n";
      else
        answers_ += paragraph(fmt::format("Exercise {}: {}", i + 1, solution));
    }
    return out + (how_.answers ? "" : "\n");
  }

  const Excerpt& e_;
  const Telling how_;
  int asked_ = 0;
  std::string answers_;           ///< of what was asked so far
  std::set<std::string> placed_;  ///< points told
};

}  // namespace

std::string told(const Excerpt& e, const Telling& how) { return Teller(e, how).all(); }

std::string told_exercises(const viz::Lesson& lesson, const Telling& how) {
  std::string out = heading(plain(lesson.title) + ": exercises", '=', how.columns);
  if (!lesson.closing) return out;
  int number = 0;
  for (const viz::Exercise& e : lesson.closing->exercises) {
    out += wrapped(fmt::format("{}. {}", ++number, plain(e.prompt)), how.columns, 0);
    if (!e.preset.empty()) out += wrapped(fmt::format("Start: --preset {}", e.preset), how.columns, 3);
    for (const auto& [name, value] : e.by)
      out += wrapped(fmt::format("One way: --set {}={}", name, value), how.columns, 3);
    out += wrapped("Solution: " + plain(e.solution), how.columns, 3) + "\n";
  }
  out.pop_back();
  return out;
}

}  // namespace isect::program
