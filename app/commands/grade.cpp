// isect grade: judges a program, in any language, that answers whether and where shapes meet.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/grade/judge.h"
#include "app/grade/page.h"
#include "app/grade/starters.h"
#include "app/program.h"
#include "app/shell/options.h"
#include "app/shell/terminal.h"
#include "viz/formats/files.h"
#include "viz/lesson.h"

namespace isect::program {

namespace {

struct GradeOptions {
  std::string task, start, language = "python", out, format = "text", convention = "closed";
  bool list = false, cases = false, answers = false, json = false, no_speed = false, no_reduce = false;
  grade::Asked asked = {};
};

std::string list_of_tasks(bool json) {
  std::string text;
  auto all = nlohmann::ordered_json::array();
  for (const grade::Task& task : grade::tasks()) {
    text += fmt::format("{:<15} {}\n", task.id, task.question);
    all.push_back({{"task", task.id},
                   {"title", task.title},
                   {"question", task.question},
                   {"lesson", task.lesson},
                   {"numbers", grade::count_of(task)}});
  }
  return json ? all.dump(2) + '\n' : text;
}

int write_starter(const GradeOptions& options) {
  const grade::Task& task = grade::task_named(options.start);
  const grade::Language& language = grade::language_named(options.language);
  const std::string text = grade::starter(task, language);
  if (options.out == "-") {
    print(text);
    return done;
  }
  const std::string file = options.out.empty() ? grade::starter_file(task, language) : options.out;
  if (viz::is_there(file)) throw viz::FileError(file + ": it is there already; --out names another file");
  viz::write_file(file, text);
  std::string talk = fmt::format("{} written; these commands judge it:", file);
  for (const std::string& command : grade::commands_for(task, language)) talk += "\n  " + command;
  say(talk);
  return done;
}

void print_cases(const grade::Task& task, const GradeOptions& options) {
  const std::vector<grade::Case> all = grade::cases(task, options.asked.seed, options.asked.count);
  if (options.cases) print(grade::input_of(task, all, options.asked.plain));
  if (options.answers)
    for (const grade::Case& one : all)
      print(grade::answer_line(task, grade::truth(task, one.numbers, options.asked.convention).value()) + '\n');
}

/// Says which walls the system did not allow.
void tell_gaps(const grade::Run& run) {
  if (!run.no_network) say("isect: this system allows no network namespace, so the program could use the network");
  if (!run.alone)
    say("isect: this system allows no process namespace, so the program could see other processes, and read the seed");
  if (!run.read_only) say("isect: this system allows no read-only view, so the program could write where you can");
}

/// Refuses what no option takes.
void check_options(const GradeOptions& options) {
  if (options.format != "text" && options.format != "md")
    throw viz::unknown("--format", options.format, {"text", "md"});
  if (options.convention != "closed" && options.convention != "note")
    throw viz::unknown("--convention", options.convention, {"closed", "note"});
  const auto within = [](const char* option, double value, double least, double most) {
    if (!(least <= value && value <= most))
      throw viz::BadInput(fmt::format("{}: {} is given; allowed: {} to {}", option, value, least, most));
  };
  const grade::Limits& limits = options.asked.limits;
  within("--count", options.asked.count, 1, 1000);
  within("--seconds", limits.seconds, 0.1, 3600);
  within("--memory", static_cast<double>(limits.memory_mib), 16, 1 << 20);
  within("--processes", limits.processes, 1, 4096);
}

int grade_task(GradeOptions options, const std::vector<std::string>& command) {
  check_options(options);
  if (options.list) {
    print(list_of_tasks(options.json));
    return done;
  }
  if (!options.start.empty()) return write_starter(options);
  if (options.task.empty())
    throw viz::BadInput(
        "TASK: none is given; `isect grade --list` names the tasks, `isect grade TASK` prints its page");
  const grade::Task& task = grade::task_named(options.task);
  if (options.convention == "note") options.asked.convention = grade::Convention::note;
  if (options.cases || options.answers) {
    print_cases(task, options);
    return done;
  }
  if (command.empty()) {
    print(options.format == "md" ? grade::markdown_page(task) : grade::text_page(task, columns()));
    return done;
  }
  if (command.front().starts_with("-"))
    throw viz::BadInput(fmt::format("option: \"{}\" is unknown; `isect grade --help` lists them", command.front()));
  options.asked.command = command, options.asked.timed = !options.no_speed, options.asked.reduced = !options.no_reduce;
  const grade::Verdict verdict = grade::judged(task, options.asked);
  print(options.json ? grade::in_json(task, options.asked, verdict) : grade::in_words(task, options.asked, verdict));
  tell_gaps(verdict.run);
  return verdict.passes() ? done : check_failed;
}

constexpr const char* grade_footer = R"(
A program reads a case a line from standard input and answers a line each: in JSON, as a line of a query, or with
--plain as numbers in the order of the page. It is judged by families of cases, such as "touching faces"; the truth is
the core's. Options stand before PROGRAM; what follows it belongs to it. A word that names a file is that file.

The program is not trusted. It runs in an empty folder, without network, with limits on time, memory, processes, files
and output; it sees no other process, writes nowhere else, and neither isect nor the true answers are in its reach.
Whatever it leaves running is killed. What the system does not allow of this is told on stderr. It can still read files
that you can read. Input comes a moment after the start: what is answered before that does not count.

Exit status: 0 all answers are right; 1 something is wrong with the program; 2 usage; 4 it can't be started.
Examples: isect grade --start aabb --language python && isect grade aabb --plain python3 aabb.py
          isect grade aabb --cases --plain | head -3)";

}  // namespace

void add_grade(CLI::App& app, Program& program) {
  CLI::App& sub = *app.add_subcommand("grade", "judges a program of yours, in any language, on hard cases");
  const auto options = std::make_shared<GradeOptions>();
  sub.prefix_command();
  sub.add_option("TASK", options->task,
                 "the task; alone, it prints its page. After it: PROGRAM [ARGS...], which is judged");
  sub.add_flag("--list", options->list, "the tasks");
  sub.add_option("--format", options->format, "of the page: text or md; text if it is not given")->type_name("text|md");
  sub.add_option("--start", options->start, "writes a program to begin with")->type_name("TASK")->check(not_empty());
  sub.add_option("--language", options->language, "of that program; python if it is not given")
      ->type_name("c|c++|python|java|javascript|rust");
  add_path(sub, "--out", options->out, "its file, or - for stdout", "FILE");
  sub.add_flag("--cases", options->cases, "prints the cases in place of judging");
  sub.add_flag("--answers", options->answers, "prints the true answers, a line each");
  sub.add_flag("--plain", options->asked.plain, "cases as numbers in place of JSON");
  sub.add_option("--seed", options->asked.seed, "other cases; 1 if it is not given")->type_name("N");
  sub.add_option("--count", options->asked.count, "cases of a family; 40 if it is not given")->type_name("N");
  sub.add_option("--convention", options->convention, "closed sets, or as in the lecture note; closed if not given")
      ->type_name("closed|note");
  sub.add_option("--seconds", options->asked.limits.seconds, "of a run; 10 if it is not given")->type_name("S");
  sub.add_option("--memory", options->asked.limits.memory_mib, "MiB of address space; 4096 if it is not given")
      ->type_name("MIB");
  sub.add_option("--processes", options->asked.limits.processes, "at once; 64 if it is not given")->type_name("N");
  sub.add_flag("--no-speed", options->no_speed, "does not measure the speed, which takes two more runs");
  sub.add_flag("--no-reduce", options->no_reduce, "looks for no simpler cases, which takes many runs");
  sub.add_flag("--json", options->json, "the whole result, or the list, as JSON");
  sub.footer(grade_footer);
  sub.callback([&program, options, &sub] {
    program.chosen = [options, command = sub.remaining()] { return grade_task(*options, command); };
  });
}

}  // namespace isect::program
