#include "app/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/shell/command_line.h"
#include "app/shell/terminal.h"
#include "viz/formats/files.h"
#include "viz/gl/offscreen.h"
#include "viz/player/reader_state.h"
#include "viz/text/text.h"

namespace isect::program {

namespace {

std::vector<std::string> names_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* sub : app.get_subcommands({})) names.push_back(sub->get_name());
  return names;
}

/// CLI11's help with plain option names: no "{failed}", no "Excludes: --size".
class Help final : public CLI::Formatter {
 public:
  Help() {
    column_width(26);
    label("Positionals", "Arguments");
  }
  std::string make_option_name(const CLI::Option* option, bool is_positional) const override {
    const std::string name = CLI::Formatter::make_option_name(option, is_positional);
    return name.substr(0, name.find('{'));
  }
  std::string make_option_opts(const CLI::Option* option) const override {
    return option->get_type_name().empty() ? "" : " " + option->get_type_name();
  }
};

/// Inserts `show`, the window, if there is no subcommand.
void complete(const CLI::App& app, std::vector<std::string>& arguments) {
  const std::string first = arguments.empty() ? "" : arguments.front();
  if (first == "--help" || first == "-h" || first == "--version") return;
  if (arguments.empty() || first.starts_with("-")) {
    arguments.insert(arguments.begin(), "show");
  } else if (const auto names = names_of(app); std::ranges::find(names, first) == names.end()) {
    std::error_code absent;
    if (std::filesystem::is_regular_file(first, absent))
      throw viz::BadInput(
          fmt::format("subcommand: \"{0}\" is a file; isect show {0} opens it, isect render {0} draws "
                      "it, and isect scene {0} tells the answers of a scene",
                      first));
    throw viz::unknown("subcommand", first, names);
  }
}

void describe(CLI::App& app, Program& program) {
  app.formatter(std::make_shared<Help>());  // subcommands inherit it
  app.set_help_flag("-h,--help", "this text; every SUBCOMMAND has its own");
  app.require_subcommand(0, 1);  // after one subcommand, the name of another is an ordinary argument
  app.set_version_flag("--version", fmt::format("{} {}", program.name, viz::version()), "the version");
  if (!program.only) add_list(app, program);
  add_show(app, program);
  add_explain(app, program);
  add_render(app, program);
  add_strip(app, program);
  add_handout(app, program);
  add_quiz(app, program);
  add_deck(app, program);
  add_book(app, program);
  if (!program.only) add_scene(app, program);
  if (!program.only) add_lang(app, program);
  if (!program.only) add_theme(app, program);
  add_check(app, program);
  if (!program.only) add_query(app, program);
  if (!program.only) add_grade(app, program);
#ifdef ISECT_HAS_BENCH
  if (!program.only) add_bench(app, program);
#endif
  if (!program.only) add_doctor(app, program);
  for (CLI::App* sub : app.get_subcommands({})) sub->set_help_flag("-h,--help", "this text");
  app.footer(
      fmt::format("Without a subcommand the window opens.\nExample: {} render{} --step 3\n\n"
                  "Exit status: 0 done; 1 a check or a graded program failed, or a case of a query was an error;\n"
                  "2 a wrong name, value or usage; 3 a baseline is missing; 4 a file can't be read or written,\n"
                  "or out of memory; 77 nowhere to draw: no rendering back end, no fonts, or no display for the\n"
                  "window. A reader who goes away (isect list | head -1) ends it as it ends cat: by SIGPIPE (141).",
                  program.name, program.only ? "" : " ray-sphere"));
}

int parse_and_run(Program& program, std::vector<std::string> arguments) {
  const std::string what = program.only ? program.only->title + ": " + program.only->summary
                                        : "isect: intersection tests, step by step, exactly right";
  CLI::App app(what, program.name);
  describe(app, program);
  complete(app, arguments);
  check_values(app, arguments);
  std::ranges::reverse(arguments);  // as CLI11 wants them
  try {
    app.parse(arguments);
  } catch (const CLI::CallForHelp&) {
    const std::vector<CLI::App*> chosen = app.get_subcommands();
    print(chosen.empty() ? app.help() : chosen.front()->help(program.name));
    return done;
  } catch (const CLI::CallForVersion& e) {
    print(std::string(e.what()) + "\n");
    return done;
  } catch (const CLI::ParseError& e) {
    throw viz::BadInput(complaint(app, e));
  }
  return program.chosen();
}

}  // namespace

int run(std::vector<const viz::Lesson*> lessons, const char* only, std::vector<std::string> arguments) {
  Program program{only ? only : "isect", std::move(lessons)};
  const auto complain = [&](const std::exception& e, int status) {
    say(fmt::format("{}: {}", program.name, e.what()));
    return status;
  };
  try {
    if (only) program.only = &viz::lesson_named(program.lessons, only);
    return parse_and_run(program, std::move(arguments));
  } catch (const viz::BadInput& e) {
    return complain(e, bad_input);
  } catch (const viz::FileError& e) {
    return complain(e, file_trouble);
  } catch (const std::filesystem::filesystem_error& e) {
    say(fmt::format("{}: '{}': {}", program.name, e.path1().string(), e.code().message()));
    return file_trouble;
  } catch (const viz::NoBackend& e) {
    return complain(e, nowhere_to_draw);
  } catch (const viz::NoFonts& e) {
    return complain(e, nowhere_to_draw);
  } catch (const std::bad_alloc&) {
    say(program.name + ": out of memory");
    return file_trouble;
  } catch (const std::exception& e) {
    return complain(e, check_failed);
  } catch (const ReaderGone&) {
    end_by_closed_pipe();
  }
}

}  // namespace isect::program
