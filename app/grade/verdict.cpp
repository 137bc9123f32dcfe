// The verdict in words and as JSON.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/grade/judge.h"

namespace isect::grade {

namespace {

/// Returns "12 of 40 wrong, each a false no".
std::string wrong_words(const OfFamily& family) {
  std::string text = fmt::format("{} of {} wrong", family.wrong, family.cases);
  if (family.faults.size() == 1) {
    const std::string& fault = family.faults.begin()->first;
    const bool noun = fault.starts_with("false ") || fault.starts_with("wrong ");
    text += family.wrong > 1 ? noun ? ", each a " : ", each: " : noun ? ", a " : ": ";
    return text + fault;
  }
  const char* before = ": ";
  for (const auto& [fault, count] : family.faults) text += fmt::format("{}{} {}", before, count, fault), before = ", ";
  return text;
}

std::string family_words(const Task& task, const OfFamily& family) {
  std::string text = fmt::format("  {}: ", family.name);
  if (family.right() == family.cases) return text + fmt::format("all {} right", family.cases);
  const char* before = "";
  if (family.wrong > 0) {
    text += wrong_words(family), before = "; ";
    if (task.ulps > 0 && family.faults.contains("wrong value"))
      text += fmt::format(", up to {:.3g} ulps off where {:g} are allowed", family.ulps, task.ulps);
  }
  if (family.unreadable > 0)
    text += fmt::format("{}{} of {} answers can't be read", before, family.unreadable, family.cases), before = "; ";
  if (family.unanswered > 0)
    text += fmt::format("{}{} of {} without an answer", before, family.unanswered, family.cases);
  return text;
}

std::string end_words(const Asked& asked, const Verdict& verdict) {
  const Run& run = verdict.run;
  const auto after = [&](const std::string& what) {
    return fmt::format("{} after {} of {} answers.\n", what, verdict.answers, verdict.cases);
  };
  switch (run.end) {
    case Run::End::signalled:
      return after("The program crashed: " + signal_name(run.code));
    case Run::End::out_of_time:
      return after(fmt::format("The program was too slow: it was ended after {:g} s", asked.limits.seconds));
    case Run::End::too_much_output:
      return after("The program was ended: it wrote far more than the answers");
    case Run::End::too_many_processes:
      return after(fmt::format("The program was ended: it started more than {} processes", asked.limits.processes));
    default:
      if (run.code != 0) return after(fmt::format("The program failed: exit status {}", run.code));
      if (verdict.answers < verdict.cases) return after("The program ended");
      if (verdict.answers > verdict.cases)
        return fmt::format("The program wrote {} lines for {} cases.\n", verdict.answers, verdict.cases);
      return "";
  }
}

/// The case as the program reads it, and the command that answers it.
std::string case_words(const Task& task, const Asked& asked, const Numbers& x) {
  const std::string query = json_line(task, x);
  return (asked.plain ? fmt::format("    {}\n", plain_line(x)) : "") +
         (task.kind.empty() ? fmt::format("    {}\n", query) : fmt::format("    echo '{}' | isect query\n", query));
}

std::string example_words(const Task& task, const Asked& asked, const Example& one) {
  std::string text = fmt::format("  {} ({}), line {} of the input: it said {}; true is {}\n", one.fault, one.family,
                                 one.line, one.said, one.truth);
  text += case_words(task, asked, one.numbers);
  if (one.simplest == one.numbers) return text;
  return text + "  The simplest case found with this fault:\n" + case_words(task, asked, one.simplest);
}

/// Returns a number to two digits, with no exponent.
std::string two_digits(double number) {
  const double unit = std::pow(10, std::max(0.0, std::floor(std::log10(number)) - 1));
  return fmt::format("{:.0f}", std::round(number / unit) * unit);
}

const char* end_name(Run::End end) {
  switch (end) {
    case Run::End::exited:
      return "exited";
    case Run::End::signalled:
      return "crashed";
    case Run::End::out_of_time:
      return "too slow";
    case Run::End::too_much_output:
      return "too much output";
    case Run::End::too_many_processes:
      return "too many processes";
    default:
      return "not started";
  }
}

}  // namespace

std::string in_words(const Task& task, const Asked& asked, const Verdict& verdict) {
  const Run& run = verdict.run;
  std::string text = fmt::format("{}: {} of {} right\n", task.id, verdict.right, verdict.cases);
  double ulps = 0;
  for (const OfFamily& family : verdict.families) {
    text += family_words(task, family) + '\n';
    if (family.wrong == 0) ulps = std::max(ulps, family.ulps);
  }
  if (task.ulps > 0 && ulps > 0)
    text += fmt::format("Values in families without a fault: at most {:.3g} ulps off.\n", ulps);
  if (run.early) text += "The program answered before there was any input: such answers count for nothing.\n";
  text += end_words(asked, verdict);
  for (const Fit& fit : verdict.likely)
    text += fmt::format("Its answers fit a mistake, {}: {} of {} answers, {} of the {} wrong ones.\n", fit.name,
                        fit.same, fit.answered, fit.same_wrong, fit.wrong);
  if (verdict.calls_a_second > 0)
    text += fmt::format("Speed: about {} cases a second, the start of the program taken off.\n",
                        two_digits(verdict.calls_a_second));
  if (verdict.answers == 0 && !asked.plain && !run.early)
    text += "Its input was JSON; with --plain, which the programs of --start need, it is numbers.\n";
  if (!run.messages.empty() && !verdict.passes())
    text += fmt::format("It wrote to stderr: {}\n", harmless(run.messages, 400));
  if (!verdict.examples.empty()) text += "The first case of each fault:\n";
  for (const Example& one : verdict.examples) text += example_words(task, asked, one);
  return text;
}

std::string in_json(const Task& task, const Asked& asked, const Verdict& verdict) {
  using Json = nlohmann::ordered_json;
  const Run& run = verdict.run;
  Json all = {{"task", task.id},
              {"seed", asked.seed},
              {"count", asked.count},
              {"convention", asked.convention == Convention::note ? "note" : "closed"},
              {"input", asked.plain ? "plain" : "json"},
              {"passes", verdict.passes()},
              {"cases", verdict.cases},
              {"right", verdict.right},
              {"answers", verdict.answers}};
  all["families"] = Json::array();
  for (const OfFamily& family : verdict.families) {
    Json one = {{"family", family.name},  {"cases", family.cases},           {"right", family.right()},
                {"wrong", family.wrong},  {"unreadable", family.unreadable}, {"unanswered", family.unanswered},
                {"faults", family.faults}};
    if (task.ulps > 0) one["ulps"] = std::isfinite(family.ulps) ? Json(family.ulps) : Json("inf");
    all["families"].push_back(std::move(one));
  }
  all["first"] = Json::array();
  for (const Example& one : verdict.examples)
    all["first"].push_back({{"fault", one.fault},
                            {"family", one.family},
                            {"line", one.line},
                            {"said", one.said},
                            {"true", one.truth},
                            {"case", Json::parse(json_line(task, one.numbers))},
                            {"plain", plain_line(one.numbers)},
                            {"simplest", Json::parse(json_line(task, one.simplest))}});
  all["mistakes"] = Json::array();
  for (const Fit& fit : verdict.likely)
    all["mistakes"].push_back({{"mistake", fit.name},
                               {"same", fit.same},
                               {"answered", fit.answered},
                               {"same_wrong", fit.same_wrong},
                               {"wrong", fit.wrong}});
  all["end"] = {{"how", end_name(run.end)}, {"before_input", run.early}, {"seconds", run.seconds}};
  if (run.end == Run::End::exited) all["end"]["status"] = run.code;
  if (run.end == Run::End::signalled) all["end"]["signal"] = signal_name(run.code);
  all["end"]["stderr"] = harmless(run.messages, 400);
  all["cases_a_second"] = verdict.calls_a_second > 0 ? Json(verdict.calls_a_second) : Json(nullptr);
  all["contained"] = {{"network", !run.no_network}, {"sees_others", !run.alone}, {"writes_elsewhere", !run.read_only}};
  return all.dump(2) + '\n';
}

}  // namespace isect::grade
