// What every lesson says must hold on any setting: the claims of its steps are compared with what they show, with the
// branch that was taken and with each other. Nothing here knows a lesson by name.

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "lessons/course.h"
#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/lessons/random_settings.h"
#include "tests/settings.h"
#include "viz/text/rich_text.h"
#include "viz/walk/closing.h"

namespace truth_test {
using namespace isect;
using namespace isect::viz;

namespace {

/// All lessons, or the one that ISECT_LESSON names.
std::vector<const Lesson*> those_asked_for() {
  const char* const only = std::getenv("ISECT_LESSON");
  std::vector<const Lesson*> lessons = lessons::all_lessons();
  if (only) std::erase_if(lessons, [&](const Lesson* lesson) { return lesson->id != only; });
  REQUIRE_FALSE(lessons.empty());
  return lessons;
}

/// The faults found in walks, each reported once per lesson with the setting that shows it.
class Faults {
 public:
  explicit Faults(const Lesson& lesson) : lesson_(lesson) {}

  void look_at(const Parameters& setting) {
    setting_ = &setting;
    const Walk walk = lesson_.walk(setting);
    const int last = outcome(walk);
    for (int i = 0; i <= last; ++i) {
      step_ = &walk.steps[i];
      if (step_->comparison) comparison(*step_->comparison);
      asked_by_line(walk);
      equations();
      chains();
      stretches();
      language(step_->caption), language(step_->formula), language(step_->verdict.text);
      if (step_->question) question(*step_->question, i > 0 ? &walk.steps[i - 1] : nullptr);
      lines(walk, i, last);
    }
    step_ = &walk.steps[last];
    language(walk.alt);
    if (step_->verdict.kind == Verdict::Kind::open) fault("the outcome is left open", "");
    returned(walk);
    questions(walk);
  }

  const std::map<std::string, std::string>& found() const { return found_; }

 private:
  void fault(const std::string& what, const std::string& where) {
    std::string told = step_->slug + ": " + where + "\n     with";
    for (const auto& [name, value] : *setting_) told += " --set " + name + "=" + to_text(value);
    found_.emplace(what, told);
  }

  /// The sign between two sides must agree with the numbers beside it.
  void comparison(const Comparison& c) {
    for (const Comparison& part : c.parts) comparison(part);
    if (!c.parts.empty()) return;
    const std::string text = plain(c.text);
    if (c.meaning.find(':') != c.meaning.npos) fault("a meaning is not one clause", plain(c.meaning));
    const std::pair<const char*, bool> signs[] = {{" ≤ ", c.left <= c.right}, {" ≥ ", c.left >= c.right},
                                                  {" < ", c.left < c.right},  {" > ", c.left > c.right},
                                                  {" = ", c.left == c.right}, {" ≠ ", c.left != c.right}};
    for (const auto& [sign, truth] : signs)
      if (text.find(sign) != std::string::npos) {
        if (truth != c.holds) fault("a comparison says the opposite of its numbers", text);
        return;
      }
  }

  /// The card must ask what its line asks: for "if x > y" it can't be "x ≤ y".
  void asked_by_line(const Walk& walk) {
    if (!step_->comparison || step_->line < 0) return;
    const std::string line = walk.pseudocode[step_->line], card = plain(step_->comparison->text);
    const auto signs_in = [](const std::string& text) {
      std::set<int> found;  // strict, not strict, equal, unequal
      for (const auto& [sign, kind] : std::initializer_list<std::pair<std::string, int>>{
               {" < ", 0}, {" > ", 0}, {" ≤ ", 1}, {" ≥ ", 1}, {" = ", 2}, {" ≠ ", 3}})
        for (std::size_t at = text.find(sign); at != std::string::npos; at = text.find(sign, at + 1))
          found.insert(kind);
      return found;
    };
    const std::set<int> of_line = signs_in(line), of_card = signs_in(card);
    const std::size_t first = std::min(line.find_first_not_of(' '), line.size());
    if (line.compare(first, 3, "if ") == 0 && of_line.size() == 1 && of_card.size() == 1 && of_line != of_card)
      fault("a comparison does not ask what its line asks", card + " beside " + line);
  }

  /// "d² = l · l = 2.64": a name that is also among the values must have the value given there.
  void equations() {
    const std::string formula = plain(step_->formula);
    std::set<std::string> names;
    for (const Value& v : step_->values) {
      const std::string name = plain(v.name);
      if (!names.insert(name).second) fault("a name stands for two values", name);
      static const std::regex equation(" = [−-]?[0-9][0-9\u2009  ]*$");
      if (std::regex_search(name, equation)) fault("a value's name ends in an equation", name);
      static const std::regex number("^[−-]?[0-9][0-9 .\\u2009·⁰¹²³⁴⁵⁶⁷⁸⁹⁻]*$");
      if (formula.compare(0, name.size() + 3, name + " = ") != 0) continue;
      const std::string right = formula.substr(formula.rfind(" = ") + 3);
      if (std::regex_match(right, number) && right != shown(v.value))
        fault("a formula gives another value than the table", formula + " beside " + shown(v.value));
    }
  }

  /// "d = 2 < r + s = 3": the signs between the numbers of a chain must be true of them.
  void chains() {
    std::string chain = ascii(plain(step_->formula));
    std::replace(chain.begin(), chain.end(), ';', ',');
    std::istringstream parts(chain);
    for (std::string part; std::getline(parts, part, ',');) chain_of(part);
  }
  /// "gap: 1 to 2": a stretch must go from its lower end to its upper one.
  void stretches() {
    static const std::regex stretch("(-?[0-9.]+(e-?[0-9]+)?) to (-?[0-9.]+(e-?[0-9]+)?)");
    const std::string formula = ascii(plain(step_->formula));
    for (std::sregex_iterator at(formula.begin(), formula.end(), stretch), end; at != end; ++at)
      if (number((*at)[1]).value_or(0) > number((*at)[3]).value_or(0)) fault("a stretch goes backwards", formula);
  }
  void chain_of(const std::string& part) {
    static const std::regex sign(" (<=|>=|<|>|=) ");
    std::optional<double> left, right;  // the last numbers of the expressions before and after the sign
    std::string between;
    std::sregex_iterator at(part.begin(), part.end(), sign), end;
    std::size_t from = 0;
    for (;; ++at) {
      const std::string side = part.substr(from, at == end ? std::string::npos : at->position() - from);
      if (const std::optional<double> x = number(side)) right = x;
      const bool goes_on = at != end;
      if (goes_on && (*at)[1] == "=") {
        from = at->position() + at->length();
        continue;
      }
      const bool wrong = left && right &&
                         ((between == "<" && *left > *right) || (between == ">" && *left < *right) ||
                          (between == "<=" && *left > *right) || (between == ">=" && *left < *right));
      if (wrong) fault("a sign in a formula is not true of its numbers", part);
      if (!goes_on) return;
      left = std::exchange(right, std::nullopt), between = (*at)[1];
      from = at->position() + at->length();
    }
  }

  static std::optional<double> number(std::string text) {
    text.erase(0, text.find_first_not_of(' '));
    text.erase(text.find_last_not_of(" .") + 1);
    double x = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
    return error == std::errc{} && end == text.data() + text.size() ? std::optional(x) : std::nullopt;
  }
  /// Numbers and signs as they are typed.
  static std::string ascii(std::string text) {
    const std::pair<const char*, const char*> signs[] = {{"\u2009·\u200910", "e"},
                                                         {"\u2009", ""},
                                                         {"−", "-"},
                                                         {"⁻", "-"},
                                                         {"≤", "<="},
                                                         {"≥", ">="},
                                                         {"∞", "inf"},
                                                         {"⁰", "0"},
                                                         {"¹", "1"},
                                                         {"²", "2"},
                                                         {"³", "3"},
                                                         {"⁴", "4"},
                                                         {"⁵", "5"},
                                                         {"⁶", "6"},
                                                         {"⁷", "7"},
                                                         {"⁸", "8"},
                                                         {"⁹", "9"}};
    for (const auto& [from, to] : signs)
      for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at))
        text.replace(at, std::strlen(from), to);
    return text;
  }

  void language(const std::string& markup) {
    const std::string text = plain(markup);
    static const std::regex one(
        "(^|[^0-9.,^·/−⁻ \\u2009] |^)1 (?!is |has |less|does |was |lies |reaches |across |as |its |this )[a-z]+[^s "
        "]s\\b");
    static const std::regex twice("\\b(on|the|of|is|to|in|and|are|that) \\1\\b");
    std::smatch match;
    if (std::regex_search(text, match, one)) fault("one of a plural", text);
    if (std::regex_search(text, match, twice)) fault("a word twice", text);
    static const std::regex long_count("(^|[^0-9.{_^-])[0-9]{5,}(?![0-9.e])");
    if (std::regex_search(markup, match, long_count)) fault("a count without a thin space", text);
    static const std::regex short_count("(^|[^0-9\u2009])[0-9]\u2009[0-9]{3}($|[^0-9\u2009])");
    if (std::regex_search(markup, match, short_count)) fault("a count of four digits with a thin space", text);
    for (const char* wrong : {"..", "?.", "!.", " ,", " .", ",,", "::", "NaN", " nan", "(nan", "inf "})
      if (text.find(wrong) != std::string::npos && text.find("...") == std::string::npos)
        fault(std::string("“") + wrong + "” in a sentence", text);
  }

  void question(const Question& q, const Step* before) {
    const std::set<std::string> different(q.choices.begin(), q.choices.end());
    if (different.size() != q.choices.size() || q.choices.size() < 2) fault("choices that are no choice", q.prompt);
    if (q.answer < 0 || q.answer >= static_cast<int>(q.choices.size())) return fault("no answer", q.prompt);
    language(q.prompt), language(q.because);
    if (q.number)
      for (const WrongNumber& wrong : q.number->wrong) language(wrong.reply);
    if (q.line)
      for (const WrongLine& wrong : q.line->wrong) language(wrong.reply);
    if (q.order)
      for (const WrongOrder& wrong : q.order->wrong) language(wrong.reply);
    if (!before) return;
    if (before->verdict.kind != Verdict::Kind::open && before->verdict.text == step_->verdict.text &&
        plain(before->verdict.text).find(plain(q.choices[q.answer])) != std::string::npos)
      fault("the verdict on the screen holds the answer", q.prompt);
    const std::string answer = plain(q.choices[q.answer]);
    if (answer.size() > 3 && plain(before->caption).find(answer) != std::string::npos)
      fault("the caption on the screen holds the answer", q.prompt + " → " + answer);
  }

  /// Checks questions about lines, and questions that are asked again.
  void questions(const Walk& walk) {
    std::set<std::string> lines, asked;
    for (const std::string& line : walk.pseudocode) lines.insert(as_markup(unindented(line)));
    for (const Step& step : walk.steps) {
      if (!step.question) continue;
      step_ = &step;
      const Question& q = *step.question;
      if (plain(q.prompt).find("runs next") != std::string::npos) fault("tests that fail run, too", q.prompt);
      if (std::ranges::all_of(q.choices, [&](const std::string& c) { return lines.contains(c); }) &&
          q.choices[q.answer] != as_markup(unindented(walk.pseudocode.at(step.line))))
        fault("the line asked for is not the step's", q.prompt);
      std::string all = q.because + " " + std::to_string(q.answer);
      for (const std::string& choice : q.choices) all += "/" + choice;
      if (!asked.insert(all).second) fault("what was asked is asked again, with the same answer", q.prompt);
    }
  }

  bool returns(const Walk& walk, int line) const {
    return line >= 0 && walk.pseudocode[line].find("return") != std::string::npos;
  }

  void lines(const Walk& walk, int i, int last) {
    const int line = step_->line;
    if (line >= static_cast<int>(walk.pseudocode.size())) return fault("a line that is not there", "");
    if (std::ranges::find(step_->untaken, line) != step_->untaken.end())
      fault("a line that was not taken is the current one", walk.pseudocode[line]);
    if (i < last && returns(walk, line) && walk.steps[i + 1].line != line)
      fault("something runs after a return", walk.pseudocode[line]);
  }

  /// A line that returns MISS must not stand under a verdict that says hit, unless the caption blames rounding, or the
  /// note; in the latter case an erratum must correct this line, or one on the way to it.
  void returned(const Walk& walk) {
    const int line = step_->line;
    if (!returns(walk, line)) return;
    const std::string code = walk.pseudocode[line];
    const auto says = [&](std::initializer_list<const char*> words) {
      return std::ranges::any_of(words, [&](const char* w) { return code.find(w) != std::string::npos; });
    };
    const bool no = says({"DISJOINT", "MISS", "OUT", "REJECT", "FAR", "none", "false"}),
               yes = says({"OVERLAP", "HIT", "INTERSECT", "NEAR", "true"});
    if (no == yes) return;
    const Verdict::Kind kind = step_->verdict.kind;
    const std::string told = plain(step_->caption) + plain(step_->verdict.text);
    const auto tells = [&](const char* word) { return told.find(word) != std::string::npos; };
    const bool corrected = std::ranges::any_of(lesson_.errata, [&](const Erratum& e) {
      const int at = line_of(e, walk);
      return at >= 0 && at <= line;
    });
    const bool owned = tells("ounding") || tells("rounded") || (corrected && (tells("note") || tells("wrong")));
    const bool against = no ? kind == Verdict::Kind::yes || kind == Verdict::Kind::on : kind == Verdict::Kind::no;
    if (against && !owned)
      fault("the line that returns contradicts the verdict", code + " under " + step_->verdict.text);
  }

  const Lesson& lesson_;
  const Parameters* setting_ = nullptr;
  const Step* step_ = nullptr;
  std::map<std::string, std::string> found_;
};

void look_at_any_setting(const Lesson& lesson) {
  Faults faults(lesson);
  tests::at_any_settings(lesson, [&](const Parameters& setting) { faults.look_at(setting); });
  for (const auto& [what, where] : faults.found()) FAIL_CHECK(lesson.id << ": " << what << "\n  " << where);
}

/// Looks at every `of`-th lesson, so that tests can run in parallel.
void look_at_lessons(std::size_t first, std::size_t of) {
  const std::vector<const Lesson*> lessons = those_asked_for();
  for (std::size_t i = first; i < lessons.size(); i += of) look_at_any_setting(*lessons[i]);
}

}  // namespace

TEST_CASE("what the steps say holds on presets, on random settings and at the borders of the map: first lesson of four",
          "[every lesson]") {
  look_at_lessons(0, 4);
}
TEST_CASE("what the steps say holds on presets, on random settings and at the borders of the map: second of four",
          "[every lesson]") {
  look_at_lessons(1, 4);
}
TEST_CASE("what the steps say holds on presets, on random settings and at the borders of the map: third of four",
          "[every lesson]") {
  look_at_lessons(2, 4);
}
TEST_CASE("what the steps say holds on presets, on random settings and at the borders of the map: last of four",
          "[every lesson]") {
  look_at_lessons(3, 4);
}

TEST_CASE("at most one question in five is answered by yes or no", "[every lesson]") {
  for (const Lesson* lesson : those_asked_for()) {
    std::set<std::string> prompts, simple;
    for (const Preset& p : lesson->presets)
      for (const Step& s : lesson->walk(p.parameters).steps)
        if (s.question) {
          prompts.insert(s.question->prompt);
          if (s.question->choices == std::vector<std::string>{"yes", "no"}) simple.insert(s.question->prompt);
        }
    INFO(lesson->id << ": " << simple.size() << " of " << prompts.size());
    CHECK(5 * simple.size() <= prompts.size());
  }
}

TEST_CASE("each lesson opens with what is asked and closes with a card and exercises", "[every lesson]") {
  for (const Lesson* lesson : those_asked_for()) {
    INFO(lesson->id);
    CHECK_FALSE(lesson->opening.empty());
    REQUIRE(lesson->closing);
    const Closing& c = *lesson->closing;
    for (const std::string& text : {c.result, c.cost, c.choose, c.used, c.bug}) CHECK_FALSE(text.empty());
    CHECK_NOTHROW(preset(*lesson, c.bug_preset));
    CHECK_FALSE(c.reading.empty());
    CHECK((c.exercises.size() >= 3 && c.exercises.size() <= 5));
  }
}

TEST_CASE("a setting that an exercise wants found is not its first one, and its solution finds it", "[every lesson]") {
  for (const Lesson* lesson : those_asked_for()) {
    if (!lesson->closing) continue;
    for (const Exercise& e : lesson->closing->exercises) {
      INFO(lesson->id << ": " << e.prompt);
      CHECK_FALSE(e.solution.empty());
      if (!e.preset.empty()) CHECK_NOTHROW(preset(*lesson, e.preset));
      if (!e.found) continue;
      Parameters setting = preset(*lesson, e.preset).parameters;
      CHECK_FALSE(e.found(setting));
      for (const auto& [name, text] : e.by) set(*lesson, setting, name, text);
      CHECK_NOTHROW(validate(*lesson, setting));
      CHECK(e.found(setting));
    }
  }
}

TEST_CASE("an erratum names a line of the pseudocode, as published or as corrected, and a preset", "[every lesson]") {
  for (const Lesson* lesson : those_asked_for())
    for (const Erratum& e : lesson->errata) {
      INFO(lesson->id << ": " << e.published);
      const Walk walk = lesson->walk(preset(*lesson, e.preset).parameters);
      const auto stands = [&](const std::string& line) { return std::ranges::count(walk.pseudocode, line) > 0; };
      CHECK((stands(e.published) || stands(e.corrected)));
      CHECK(e.published != e.corrected);
      CHECK_FALSE(e.why.empty());
    }
}

TEST_CASE("a course leads from lesson to lesson without a circle", "[every lesson]") {
  std::set<std::string> before;
  for (const Lesson* lesson : lessons::all_lessons()) {
    for (const std::string& id : lesson->after) {
      INFO(lesson->id << " builds on " << id);
      CHECK(before.contains(id));
    }
    before.insert(lesson->id);
  }
}

TEST_CASE("the course's part on polygons holds what is about them", "[every lesson]") {
  std::string part;
  for (const Lesson* lesson : lessons::all_lessons()) {
    for (const Course::Part& p : lessons::course().parts)
      if (p.first == lesson->id) part = p.title;
    INFO(lesson->id);
    CHECK((lesson->title.find("olygon") != std::string::npos) == (part == "Polygons"));
  }
}

}  // namespace truth_test
