// The first page of the report: where it was measured, and a line a test.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "bench/findings.h"
#include "bench/prose.h"

namespace isect::bench {
namespace {

/// The anchor that GitHub gives to the heading of a test's section.
std::string anchor(const std::string& test) {
  std::string id;
  for (const char c : test)
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '-')
      id += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (c == ' ')
      id += '-';
  return id;
}

/// A shorter name than name_of gives: "CGAL, EPICK".
std::string brief(const Row& r) {
  if (r.library == "isect") return r.method;
  const std::size_t at = r.method.rfind(", ");
  return at == r.method.npos ? r.library : r.library + r.method.substr(at);
}

std::string worst_time(const Findings& d, const Row& exact) {
  const Row* worst = slowest_hard(d.of(exact));
  if (worst == nullptr) return "";
  return worst->median <= exact.median ? "none takes more"
                                       : fmt::format("{}, {}", number(worst->median), words(worst->family));
}

/// The names as `listed` joins them, but with semicolons if some name has a comma.
std::string listed_apart(const std::vector<std::string>& names) {
  if (std::ranges::none_of(names, [](const std::string& name) { return name.find(',') != name.npos; }))
    return listed(names);
  return fmt::format("{}", fmt::join(names, "; "));
}

/// The other methods that were right on every case judged, hard ones included; the row's own call is left out.
std::string also_right(const Measured& m, const std::string& test, const Findings& d) {
  std::vector<std::string> names;
  const auto gather = [&](const Findings& f, bool foreign) {
    if (!f.judged_hard() || f.exact == nullptr) return;
    for (const Row* r : f.ordinary)
      if (r != &best_exact(f) && (r->library != "isect") == foreign && total_wrong(f.of(*r)) == 0 &&
          is_judged_on_hard(f.of(*r)))
        if (const std::string name = brief(*r) + not_asked(f, *r); std::ranges::find(names, name) == names.end())
          names.push_back(name);
  };
  gather(d, false);
  if (m.peers) gather(Findings(*m.peers, test, "double"), true);
  return fmt::format("{}", d.judged_hard() ? names.empty() ? "none" : listed_apart(names) : "");
}

/// ", each a false yes", where all that a yes-or-no method gets wrong is of one kind.
std::string kind_of_errors(const std::vector<const Row*>& all) {
  long yes = 0, no = 0;
  for (const Row* r : all) {
    if (r->sides) return "";
    yes += r->false_yes, no += r->false_no;
  }
  return yes > 0 && no == 0 ? ", each a false yes" : no > 0 && yes == 0 ? ", each a false no" : "";
}

std::string how_it_fails(const Findings& d, const Row& r) {
  const std::vector<const Row*> all = d.of(r);
  if (r.wrong() > 0) return fmt::format("wrong on {} of ordinary", wrong_share({&r}));
  const std::vector<const Row*> broken = broken_by(all);
  if (!broken.empty())
    return fmt::format("wrong on {} of {}{}", wrong_share({broken[0]}), words(broken[0]->family),
                       broken.size() > 1 ? fmt::format(", and on {} more", broken.size() - 1) : "") +
           kind_of_errors(all);
  return std::ranges::any_of(all, &Row::hard) ? fmt::format("never wrong in {} cases", count(total_judged(all)))
                                              : "not judged on hard input";
}

std::string rival_cell(const Findings& d, const std::optional<Rival>& best) {
  if (best) {
    const std::string failing = how_it_fails(best->in, *best->row);
    const std::string time =
        number(best->row->median) +
        (best->row->library == "isect"
             ? ""
             : fmt::format(" ({} there: {})", best->exact->method == "exact" ? "the exact call" : best->exact->method,
                           number(best->exact->median)));
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

/// Alternatives to what is chosen: methods as exact that take much less where no value is needed or on a hard family.
std::string besides(const Findings& d) {
  const Row& chosen = best_exact(d);
  std::string text;
  for (const Row* r : d.ordinary)
    if (r->exact && r->library == "isect" && chosen.ulps && !r->ulps && clearly_faster(*r, chosen, d.noise))
      text += fmt::format("; {} ({}) where that is enough", r->method, number(r->median));
  std::vector<std::pair<std::string, std::vector<std::string>>> families;  // of a method, with its times
  for (const Better& b : better_where(d)) {
    auto place = std::ranges::find(families, b.row->method, &decltype(families)::value_type::first);
    if (place == families.end()) place = families.insert(place, {b.row->method, {}});
    place->second.push_back(fmt::format("{} ({})", words(b.row->family), number(b.row->median)));
  }
  for (const auto& [method, where] : families) text += fmt::format("; {} for input like {}", method, listed(where));
  return text;
}

/// The choice for a test without an exact call: the first method that never misses a contact.
std::string safe_side(const Findings& d) {
  for (const Row* r : d.ordinary) {
    long missed = 0;
    for (const Row* q : d.of(*r)) missed += q->false_no;
    if (missed == 0) return r->method + " where none may be missed";
  }
  return "";
}

std::string machine_line(const Report& r) {
  const Machine& m = r.machine;
  return fmt::format("- {} build of {}: {}, `{}`, seed {}, {}; load {}, noise {:.1f} %{}{}\n", m.build,
                     m.commit.empty() ? "an unknown commit" : "commit " + m.commit, m.compiler, m.flags, r.seed, m.date,
                     number(m.load), 100 * m.noise, r.quick ? "; a quick run, in which fewer cases are judged" : "",
                     m.libraries.empty() ? "" : "; beside " + m.libraries);
}

}  // namespace

std::string machine_text(const Measured& m) {
  const Machine& machine = m.portable.machine;
  std::string text = fmt::format("Measured on {} with {} cores{}:\n\n{}", machine.cpu, machine.cores,
                                 machine.caches.empty() ? "" : ", " + machine.caches, machine_line(m.portable));
  for (const std::optional<Report>* other : {&m.native, &m.peers})
    if (*other) text += machine_line(**other);
  if (!m.native) text += "- native build: not measured\n";
  if (!m.peers) text += "- beside other libraries: not measured\n";
  return text + '\n';
}

std::string summary_text(const Measured& m) {
  std::string text =
      "Times are in ns a call, in double, of the portable build; those of other libraries are of the peers build, "
      "which "
      "changes some of our times too, so that the exact call's time there stands beside them. Ordinary cases are "
      "random; "
      "hard families are made to break naive methods. [a, b] is the 95 % interval of a median over the passes of one "
      "program. Words are explained at the end.\n\n"
      "| question | exact call, ordinary | its worst hard family | also without error | what takes less, and how "
      "it "
      "fails | choose |\n| --- | --: | --- | --- | --- | --- |\n";
  for (const std::string& test : tests_of(m.portable)) {
    const Findings d(m.portable, test, "double");
    if (d.ordinary.empty()) continue;
    const Row* exact = d.exact == nullptr ? nullptr : &best_exact(d);
    text += fmt::format(
        "| [{}](#{}) | {} | {} | {} | {} | {} |\n", test, anchor(test),
        exact == nullptr ? "none" : (exact->method == "exact" ? "" : exact->method + ": ") + time_of(*exact),
        exact == nullptr ? "" : worst_time(d, *exact), also_right(m, test, d), rival_cell(d, rival(m, test)),
        exact == nullptr ? safe_side(d) : choice_cell(choice(m, test)) + besides(d));
  }
  return text + '\n';
}

}  // namespace isect::bench
