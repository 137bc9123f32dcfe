#include "app/grade/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <set>
#include <string_view>

#include "app/grade/reduced.h"
#include "viz/formats/files.h"

namespace isect::grade {

namespace {

std::size_t output_for(std::size_t cases) { return 65536 + cases * 2048; }

/// Cases a second: the time of many less that of one, so that the start of the program does not count.
double speed(const Asked& asked, const std::string& input, std::size_t cases, double seconds) {
  constexpr std::size_t most = 20000;
  const std::string one = input.substr(0, input.find('\n') + 1);
  const double a_case = std::max(seconds / static_cast<double>(cases), 1e-7);
  const auto wanted = static_cast<std::size_t>(0.2 * asked.limits.seconds / a_case);
  const std::size_t times = std::max<std::size_t>(1, std::min(most, wanted) / cases);
  std::string many;
  for (std::size_t i = 0; i < times; ++i) many += input;
  Limits limits = asked.limits;
  limits.output = output_for(times * cases);
  const Run short_run = run_contained(asked.command, one, limits),
            long_run = run_contained(asked.command, many, limits);
  const double took = long_run.seconds - short_run.seconds;
  const bool ended = short_run.end == Run::End::exited && long_run.end == Run::End::exited;
  return ended && took > 1e-3 ? static_cast<double>(times * cases - 1) / took : 0;
}

class Tally {
 public:
  Tally(const Task& task, const Asked& asked, Verdict& verdict) : task_(task), asked_(asked), verdict_(verdict) {}

  /// Returns whether the answer is right.
  bool add(const Case& one, std::size_t line, const std::string_view* said) {
    if (verdict_.families.empty() || verdict_.families.back().name != one.family)
      verdict_.families.push_back({one.family});
    OfFamily& family = verdict_.families.back();
    ++family.cases;
    if (!said) {
      ++family.unanswered;
      return false;
    }
    const Truth known = truth(task_, one.numbers, asked_.convention).value();
    const Mark mark = marked(task_, known, *said);
    family.ulps = std::max(family.ulps, mark.ulps);
    if (mark.fault.empty()) {
      ++verdict_.right;
      return true;
    }
    if (mark.readable)
      ++family.wrong, ++family.faults[mark.fault];
    else
      ++family.unreadable;
    if (shown_.insert(mark.fault).second)
      verdict_.examples.push_back(
          {line, one.family, mark.fault, harmless(*said), answer_line(task_, known), one.numbers, one.numbers});
    return false;
  }

 private:
  const Task& task_;
  const Asked& asked_;
  Verdict& verdict_;
  std::set<std::string> shown_;
};

}  // namespace

std::vector<std::string_view> answers_in(std::string_view output) {
  std::vector<std::string_view> lines;
  while (!output.empty()) {
    const std::size_t end = std::min(output.find('\n'), output.size());
    const std::string_view line = output.substr(0, end);
    if (line.find_first_not_of(" \t\r") != line.npos) lines.push_back(line);
    output.remove_prefix(std::min(end + 1, output.size()));
  }
  return lines;
}

std::string input_of(const Task& task, const std::vector<Case>& all, bool plain) {
  std::string input;
  for (std::size_t i = 0; i < all.size(); ++i)
    input +=
        (plain ? plain_line(all[i].numbers) : json_line(task, all[i].numbers, static_cast<long long>(i) + 1)) + '\n';
  return input;
}

Verdict judged(const Task& task, const Asked& asked) {
  const std::vector<Case> all = cases(task, asked.seed, asked.count);
  const std::string input = input_of(task, all, asked.plain);
  Limits limits = asked.limits;
  limits.output = output_for(all.size());
  Verdict verdict;
  verdict.run = run_contained(asked.command, input, limits);
  if (verdict.run.end == Run::End::not_started)
    throw viz::FileError(fmt::format("{}: it can't be started: {}", asked.command[0], std::strerror(verdict.run.code)));
  std::vector<std::string_view> lines;
  if (!verdict.run.early) lines = answers_in(verdict.run.output);
  verdict.cases = all.size(), verdict.answers = lines.size();
  Tally tally(task, asked, verdict);
  std::vector<bool> right;
  for (std::size_t i = 0; i < all.size(); ++i)
    right.push_back(tally.add(all[i], i + 1, i < lines.size() ? &lines[i] : nullptr));
  verdict.likely = fits(task, all, lines, right);
  const bool ended = verdict.run.end == Run::End::exited && !verdict.run.early;
  if (asked.reduced && ended)
    for (Example& one : verdict.examples) one.simplest = reduced(task, asked, one.numbers, one.fault);
  const bool answered = verdict.run.end == Run::End::exited && lines.size() == all.size() && !verdict.run.early;
  if (asked.timed && answered) verdict.calls_a_second = speed(asked, input, all.size(), verdict.run.seconds);
  return verdict;
}

}  // namespace isect::grade
