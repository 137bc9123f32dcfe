// The section of one test, put together, and its advice on what to choose.

#include <fmt/format.h>

#include <optional>
#include <string>

#include "bench/findings.h"
#include "bench/prose.h"
#include "bench/report_sections.h"
#include "bench/rows.h"

namespace isect::bench {
namespace {

/// Sentences on where an inexact method is faster, other than in double in the portable build.
std::string elsewhere(const Measured& m, const std::string& test) {
  std::string text;
  const auto look = [&](const Report& report, const std::string& scalar, const std::string& where) {
    if (const auto best = rival(report, test, scalar, false); best && best->is_faster())
      text += fmt::format(" {} {} does, {} ns against {}.", where, name_of(*best->row), number(best->row->median),
                          number(best->exact->median));
  };
  look(m.portable, "float", "In float");
  if (m.native) look(*m.native, "double", "Compiled for this machine");
  if (m.native) look(*m.native, "float", "Compiled for this machine, in float");
  return text;
}

/// Sentences on where another method that is as exact takes much less time.
std::string exceptions(const Findings& d) {
  std::string text;
  for (const Better& b : better_where(d))
    text += fmt::format(" On \"{}\" {} takes {} ns, against {}.", words(b.row->family), name_of(*b.row),
                        number(b.row->median), number(b.chosen->median));
  return text;
}

/// What to choose; empty if the faster methods met no hard case.
std::string advice(const Measured& m, const std::string& test, const Findings& d) {
  const std::optional<Choice> c = choice(m, test);
  if (!c || c->why == Choice::not_judged) return {};
  const bool another = c->exact != name_of(*d.exact);
  const std::string exact = another ? c->exact : "the exact call";
  const std::string as_exact =
      !another             ? ""
      : c->peer == nullptr ? d.judged_hard() ? "It is as exact as the exact call. "
                                             : "It promises what the exact call does; it was judged on ordinary input. "
                           : fmt::format("It is as exact as the exact call, and takes {} of its time. ",
                                         ratio_text(*c->peer, best_exact(Findings(*m.peers, test, "double"))));
  if (c->why == Choice::nothing_faster)
    return fmt::format("**Choose {}.** {}In double nothing inexact takes clearly less time.{}{}", exact, as_exact,
                       elsewhere(m, test), exceptions(d));
  if (c->why == Choice::errs_on_ordinary)
    return fmt::format("**Choose {}.** {} takes less time, but errs on ordinary input already.", exact,
                       sentence(c->other));
  const Rival best = *rival(m, test);
  const std::string other = c->other + (c->no_value ? " (yes or no only)" : "");
  const std::string saved = number(best.exact->median - best.row->median), part = ratio_text(*best.row, *best.exact);
  if (c->why == Choice::as_exact)
    return fmt::format("**Choose {}.** It is as exact, and takes {} of the time.", other, part);
  if (c->why == Choice::never_broken)
    return fmt::format(
        "**Choose {} where time matters.** It takes {} of the time, and no case judged here broke it; only {} promises "
        "that none does.",
        other, part, exact);
  if (c->peer != nullptr)
    return fmt::format("**Choose {}.** {}{} takes less, but {}.", exact, as_exact, sentence(c->other),
                       c->all_families ? "is for input like the ordinary family only"
                                       : "not where input may be " + listed(c->families));
  if (c->all_families)
    return fmt::format(
        "**Choose {}.** Use {} only if all input is like the ordinary family, and saving {} ns a call outweighs a "
        "wrong verdict.",
        exact, other, saved);
  return fmt::format("**Choose {},** or {} where no input is {}: it saves {} ns a call.", exact, other,
                     listed(c->families), saved);
}

}  // namespace

std::string test_text(const Measured& m, const std::string& test) {
  const Findings d(m.portable, test, "double"), f(m.portable, test, "float");
  std::string text;
  if (d.comparable()) {
    text = cost_sentences(m, test, d, f) + verdict_sentences(d, f);
    text.pop_back();
    text += "\n\n";
    if (const std::string words = advice(m, test, d); !words.empty()) text += words + "\n\n";
    if (m.native) {
      const Findings n(*m.native, test, "double");
      if (n.naive != nullptr && n.exact != nullptr)
        text += fmt::format("Compiled for this machine: {} {} ns, exact {} ns.\n\n", name_of(*n.naive),
                            time_of(*n.naive), time_of(*n.exact));
    }
  }
  if (d.rows.empty()) return text;
  return text + tables_text(m, test, d);
}

}  // namespace isect::bench
