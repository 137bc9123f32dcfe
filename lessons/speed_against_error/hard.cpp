// The hard families: how far the methods err on each, and where their verdicts are wrong.

#include <fmt/format.h>

#include <algorithm>

#include "bench/prose.h"
#include "bench/rows.h"
#include "lessons/shared/plural.h"
#include "lessons/speed_against_error/telling.h"
#include "viz/text/rich_text.h"

namespace isect::lessons::speed_against_error_lesson {

using namespace viz;
using namespace bench;

namespace {

/// The index of the only element with the greatest value; nothing where two share it.
template <class List, class Value>
std::optional<std::size_t> only_greatest(const List& list, const Value& value) {
  if (list.empty()) return {};
  std::size_t best = 0;
  for (std::size_t i = 1; i < list.size(); ++i)
    if (value(*list[i]) > value(*list[best])) best = i;
  for (std::size_t i = 0; i < list.size(); ++i)
    if (i != best && !(value(*list[i]) < value(*list[best]))) return {};
  return best;
}

constexpr const char* the_same = "the same";  ///< how the note of a family begins that is like the one before

/// A family's note in a reader's words: "0.1", where a programmer writes ".1".
std::string readable(std::string note) {
  for (std::size_t at = note.find(" ."); at != note.npos; at = note.find(" .", at + 1))
    if (at + 2 < note.size() && note[at + 2] >= '0' && note[at + 2] <= '9') note.insert(at + 1, "0");
  for (std::size_t at = note.find("NaN"); at != note.npos; at = note.find("NaN")) note.replace(at, 3, "not-a-number");
  return note;
}

}  // namespace

bool Teller::by_convention(const Row& r) const {
  const auto strict = [](const Row& method) { return method.method.find("(<)") != std::string::npos; };
  if (!strict(r) || r.judged == 0 || r.false_no != r.judged) return false;
  const Rows rows = of(r.family);
  return std::ranges::any_of(rows, [&](const Row* other) {
    return other->library == "isect" && !other->exact && !strict(*other) && other->wrong() == 0;
  });
}

std::vector<std::string> Teller::other_families() const {
  std::vector<std::string> all;
  for (const std::string& family : families_of(rows_))
    if (const Row* r = standard_of(of(family)); r != nullptr && r->hard && std::ranges::count(hard_, family) == 0)
      all.push_back(family);
  return all;
}

std::string Teller::like(const std::string& family) const {
  if (!report_.note(test_, family).starts_with(the_same)) return {};
  std::string before;
  for (const std::string& other : families_of(rows_)) {
    if (other == family) break;
    if (!report_.note(test_, other).starts_with(the_same)) before = other;
  }
  return before;
}

std::string Teller::made_of(const std::string& family) const {
  const std::string note = readable(report_.note(test_, family)), other = like(family);
  if (note.empty()) return fmt::format("a family made to break naive methods: {}.", words(family));
  if (other.empty()) return note;
  std::string of_other = made_of(other);
  while (of_other.ends_with('.')) of_other.pop_back();
  return fmt::format("as “{}” ({}), but{}", words(other), of_other, note.substr(std::string(the_same).size()));
}

void Teller::hard_family(const std::string& family, bool first) {
  values(family);
  std::string text = sentence(made_of(family));
  text += fmt::format("\n{}: {}. The exact call: {}, in {} ns.", sentence(name_of(naive(family))),
                      error_text(naive(family)), error_text(exact(family)), shown(exact(family).ns));
  if (by_value_ && naive(family).wrong() > 0)
    text += fmt::format(" Besides, {} of the verdicts of {} are wrong.",
                        share(static_cast<double>(naive(family).wrong()), static_cast<double>(naive(family).judged)),
                        name_of(naive(family)));
  if (by_convention(naive(family)) && text.find("by convention") == std::string::npos)
    text += " Nothing is rounded there: its strict < leaves out touching, by convention.";
  text += no_cure(family);
  Plot p = plot({ordinary_, family});
  for (Panel& panel : p.panels) panel.muted = panel.title != as_markup(words(family));
  std::string slug = words(family);
  std::ranges::transform(slug, slug.begin(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) ? static_cast<char>(std::tolower(c)) : '-';
  });
  Step& step = script_.add(slug, sentence(words(family)), hard_line, text);
  show(step, {p});
  if (!first) return;

  Rows rows = of(family);
  std::erase_if(rows, [](const Row* r) { return r->exact; });  // never wrong
  const auto greatest = only_greatest(rows, [&](const Row& r) { return by_value_ ? bits(error(r)) : error(r); });
  if (!greatest || rows.size() < 2) return;
  Question q = {fmt::format("Which method errs most on the family “{}”?", words(family)), {}, 0, ""};
  for (std::size_t i = 0; i < rows.size() && q.choices.size() < 4; ++i) {
    const bool room = q.choices.size() < 3 || i >= *greatest;
    if (i == *greatest) q.answer = static_cast<int>(q.choices.size());
    if (room) q.choices.push_back(name_of(*rows[i]));
  }
  if (q.answer >= static_cast<int>(q.choices.size()) || q.choices[q.answer] != name_of(*rows[*greatest])) return;
  q.because = fmt::format("{}: {}.", sentence(name_of(*rows[*greatest])), error_text(*rows[*greatest]));
  step.question = q;
}

/// The families without a step of their own, each in a sentence, as later steps name them.
void Teller::others() {
  const std::vector<std::string> families = other_families();
  if (families.empty()) return;
  const std::string name = name_of(naive(ordinary_));
  Bars bars = {{Scale::Kind::linear, 0, 100, fmt::format("wrong verdicts of {} (%)", as_markup(name))},
               {{as_markup(name), Glyph::square, Role::second}},
               {}};
  std::string text;
  for (const std::string& family : families) {
    const bool told = std::ranges::count(families, like(family)) > 0;  // in this step
    text += fmt::format("{}{}: {}", text.empty() ? "" : "\n", sentence(words(family)),
                        told ? readable(report_.note(test_, family)) : made_of(family));
    const Row& r = naive(family);
    const double wrong = static_cast<double>(r.wrong()), judged = static_cast<double>(std::max(r.judged, 1L));
    bars.bars.push_back(
        {as_markup(words(family)), {{0, 100 * wrong / judged}}, {}, share(wrong, judged), Verdict::Kind::open});
  }
  show(script_.add("other-families", families.size() == 1 ? "One more hard family" : "The other hard families",
                   hard_line, text),
       {bars});
}

std::string Teller::no_cure(const std::string& family) const {
  Rows others = of(family);
  std::erase_if(others, [](const Row* r) { return r->exact || r->standard || !r->ulps; });
  if (!by_value_ || others.empty()) return {};
  const Row& best = **std::ranges::min_element(others, {}, [&](const Row* r) { return error(*r); });
  if (!(error(best) >= error(naive(family)) / 10)) return {};
  std::string told = fmt::format("\nNo other rounded method does ten times better: {}, the best, errs by {}.",
                                 name_of(best), error_text(best));
  if (test_ == "ray-sphere" && family == "planet")
    told += " Stable roots cure one cancellation: that in *C* = **f** · **f** − *r*^2 comes before it.";
  return told;
}

void Teller::fall() {
  const Row *worst = nullptr, *convention = nullptr;
  for (const Row* r : rows_)
    if (by_convention(*r))
      convention = r;
    else if (r->wrong() > 0 && (worst == nullptr || r->wrong_per_million() > worst->wrong_per_million()))
      worst = r;
  if (worst == nullptr) return;
  long wrong = 0, judged = 0;
  for (const Row* r : rows_)
    if (r->exact && r->library == "isect") wrong += r->wrong(), judged += r->judged;
  std::vector<std::string> families = {ordinary_};  // and the three on which the naive method is wrong most often
  Rows rows;
  for (const std::string& family : families_of(rows_))
    if (const Row* r = standard_of(of(family)); r != nullptr && r->hard) rows.push_back(r);
  std::ranges::stable_sort(rows, std::greater{}, &Row::wrong_per_million);
  for (const Row* r : rows)
    if (families.size() < 4) families.push_back(r->family);
  const Plotted plotted = verdict_plot(report_, test_, "double", families);
  Step& step = script_.add(
      "wrong-verdicts", "Where naive methods fail", wrong_line,
      fmt::format("A wrong verdict is worse than lost bits: yes and no are confused.\n"
                  "{}{} does worst, on the family “{}”: {} of its verdicts are wrong.\n"
                  "{}.",
                  convention == nullptr
                      ? ""
                      : fmt::format("On “{}” {} always says no, by convention: its strict < leaves out touching. Of "
                                    "what is rounded, ",
                                    words(convention->family), name_of(*convention)),
                  convention == nullptr ? sentence(name_of(*worst)) : name_of(*worst), words(worst->family),
                  share(static_cast<double>(worst->wrong()), static_cast<double>(worst->judged)),
                  wrong == 0 ? fmt::format("The exact call was never wrong, in {} cases", counted(judged))
                             : fmt::format("Exact calls were wrong {} in {}", plural(wrong, "time"), counted(judged))));
  if (std::ranges::any_of(rows_, [](const Row* r) { return r->method == "expanded"; }))
    step.caption += "\nExpanded adds up six products of coordinates, and subtracts no coordinates first.";
  show(step, plotted.chart);
}

}  // namespace isect::lessons::speed_against_error_lesson
