// The first page of the report: a line a test.

#include <fmt/format.h>

#include <algorithm>

#include "bench/findings.h"
#include "bench/prose.h"

namespace isect::bench {
namespace {

/// As GitHub names the heading of a test's section.
std::string anchor(const std::string& test) {
  std::string id;
  for (const char c : test)
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '-')
      id += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (c == ' ')
      id += '-';
  return id;
}

/// Shorter than name_of: "CGAL, EPICK".
std::string brief(const Row& r) {
  if (r.library == "isect") return r.method;
  const std::size_t at = r.method.rfind(", ");
  return at == r.method.npos ? r.library : r.library + r.method.substr(at);
}

std::string worst_time(const Findings& d, const Row& exact) {
  const Row* worst = nullptr;
  for (const Row* r : d.of(exact))
    if (r->hard && (worst == nullptr || r->median > worst->median)) worst = r;
  if (worst == nullptr) return "";
  return worst->median <= exact.median ? "ordinary"
                                       : fmt::format("{}, {}", number(worst->median), words(worst->family));
}

/// Those that no case judged showed wrong, the exact call left out.
std::string also_right(const Measured& m, const std::string& test, const Findings& d) {
  std::vector<std::string> names;
  const auto gather = [&](const Findings& f, bool foreign) {
    if (!f.judged_hard()) return;
    for (const Row* r : f.ordinary)
      if (r != f.exact && (r->library != "isect") == foreign && total_wrong(f.of(*r)) == 0 &&
          std::ranges::find(names, brief(*r)) == names.end())
        names.push_back(brief(*r));
  };
  gather(d, false);
  if (m.peers) gather(Findings(*m.peers, test, "double"), true);
  return fmt::format("{}", d.judged_hard() ? names.empty() ? "none" : listed(names) : "");
}

std::string how_it_fails(const Findings& d, const Row& r) {
  const std::vector<const Row*> all = d.of(r);
  if (r.wrong() > 0) return fmt::format("wrong on {} of ordinary", wrong_share({&r}));
  const std::vector<const Row*> broken = broken_by(all);
  if (!broken.empty())
    return fmt::format("wrong on {} of {}{}", wrong_share({broken[0]}), words(broken[0]->family),
                       broken.size() > 1 ? fmt::format(", and on {} more", broken.size() - 1) : "");
  return std::ranges::any_of(all, &Row::hard) ? "never wrong here" : "not judged on hard input";
}

std::string rival_cell(const Findings& d, const std::optional<Rival>& best) {
  if (best) {
    const std::string failing = how_it_fails(best->in, *best->row), time = number(best->row->median);
    return best->is_faster() ? fmt::format("{}: {}; {}", brief(*best->row), time, failing)
                             : fmt::format("none; least: {}, {}; {}", brief(*best->row), time, failing);
  }
  const auto least = std::ranges::min_element(d.ordinary, {}, &Row::median);
  if ((*least)->exact) return "none";
  return fmt::format("{}: {}; {}", brief(**least), number((*least)->median), how_it_fails(d, **least));
}

std::string choice_cell(const std::optional<Choice>& c) {
  if (!c) return "";
  const std::string other = c->other + (c->no_value ? " for yes or no" : "");
  switch (c->why) {
    case Choice::nothing_faster:
    case Choice::errs_on_ordinary:
      return c->exact;
    case Choice::not_judged:
      return "";
    case Choice::as_exact:
      return other;
    case Choice::never_broken:
      return fmt::format("{}; {} if time matters more than a proof", c->exact, other);
    case Choice::breaks:
      break;
  }
  if (c->all_families) return fmt::format("{}; {} only if all input is ordinary", c->exact, other);
  std::vector<std::string> some = c->families;
  if (some.size() > 3) some.resize(3), some.emplace_back("the like");
  return fmt::format("{}; {} if no input is {}", c->exact, other, listed(some));
}

}  // namespace

std::string summary_text(const Measured& m) {
  std::string text =
      "Times are in ns a call, in double. [a, b] is the 95 % interval of a median; all words are explained at the "
      "end.\n\n"
      "| question | exact call, ordinary | its worst family | never wrong, too | what takes less, and how it "
      "fails | choose |\n| --- | --: | --- | --- | --- | --- |\n";
  for (const std::string& test : tests_of(m.portable)) {
    const Findings d(m.portable, test, "double");
    if (d.ordinary.empty()) continue;
    const Row* exact = d.exact == nullptr ? nullptr : &best_exact(d);
    text += fmt::format(
        "| [{}](#{}) | {} | {} | {} | {} | {} |\n", test, anchor(test),
        exact == nullptr ? "none" : (exact->method == "exact" ? "" : exact->method + ": ") + time_of(*exact),
        exact == nullptr ? "" : worst_time(d, *exact), also_right(m, test, d), rival_cell(d, rival(m, test)),
        choice_cell(choice(m, test)));
  }
  return text + '\n';
}

}  // namespace isect::bench
