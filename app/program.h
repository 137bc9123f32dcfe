#pragma once
// The program `isect`, and with `only` set the small program of one lesson: the same subcommands without
// LESSON.
//
// Each subcommand is one file of commands/ with one function that adds it to the command line. Parsing sets `chosen`;
// main calls it.

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}
namespace isect::viz {
struct Lesson;
}

namespace isect::program {

enum Exit {
  done = 0,
  check_failed = 1,  ///< or a case of `query` was an error; outranks baseline_missing
  bad_input = 2,     ///< usage, or a bad name or value
  baseline_missing = 3,
  file_trouble = 4,     ///< a file can't be read or written, or memory has run out
  nowhere_to_draw = 77  ///< no rendering back end, no fonts, or a window without a display
};

struct Program {
  std::string name;
  std::vector<const viz::Lesson*> lessons;
  const viz::Lesson* only = nullptr;
  std::function<int()> chosen = {};
};

void add_list(CLI::App&, Program&);
void add_show(CLI::App&, Program&);
void add_explain(CLI::App&, Program&);
void add_render(CLI::App&, Program&);
void add_strip(CLI::App&, Program&);
void add_handout(CLI::App&, Program&);
void add_quiz(CLI::App&, Program&);
void add_deck(CLI::App&, Program&);
void add_book(CLI::App&, Program&);
void add_scene(CLI::App&, Program&);
void add_lang(CLI::App&, Program&);
void add_theme(CLI::App&, Program&);
void add_check(CLI::App&, Program&);
void add_query(CLI::App&, Program&);
void add_grade(CLI::App&, Program&);
void add_bench(CLI::App&, Program&);
void add_doctor(CLI::App&, Program&);

/// Runs the program of these lessons, or of the one with this id, if it is not null. `arguments` without the program's
/// name. Returns the exit status.
int run(std::vector<const viz::Lesson*> lessons, const char* only, std::vector<std::string> arguments);

}  // namespace isect::program
