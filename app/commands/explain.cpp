// isect explain: the lesson as text, for terminals and screen readers.

#include <CLI/CLI.hpp>
#include <memory>

#include "app/figures/lesson_text.h"
#include "app/shell/terminal.h"

namespace isect::program {

void add_explain(CLI::App& app, Program& program) {
  CLI::App& sub = *app.add_subcommand("explain", "the lesson as text: setting, steps, questions, exercises");
  const auto asked = std::make_shared<Selection>();
  add_lesson(sub, program, *asked, Takes::one, "a lesson's id");
  add_preset(sub, *asked, Takes::one,
             "a preset, or a file with one (its step and time are\nhonoured); the first if not given");
  add_step(sub, *asked, Takes::many,
           "counted from 1: 3, 3-6, 3,5,7-9 or all; -1 is the last; or by\nname: intersect; verdict is the last before "
           "map and "
           "card. If\nnot given, that of the preset's file, or all");
  add_scene_file(sub, program, *asked);
  add_set(sub, *asked);
  add_language(sub, *asked);
  const auto how = std::make_shared<TextOptions>();
  const auto exercises = std::make_shared<bool>(false);
  sub.add_flag("--brief", how->brief, "one line a step: what it decides");
  sub.add_flag("--answers", how->answers, "each answer right after its question, not at the end");
  sub.add_flag("--exercises", *exercises, "the lesson's exercises with their solutions, nothing else");
  sub.footer("Example: " + program.name + " explain" + (program.only ? "" : " ray-sphere") + " --step 3");
  sub.callback([&program, asked, how, exercises] {
    program.chosen = [&program, asked, how, exercises] {
      how->columns = columns();
      const Excerpt e = excerpt(program, *asked);
      print(*exercises ? exercises_text(*e.lesson, *how) : lesson_text(e, *how));
      return done;
    };
  });
}

}  // namespace isect::program
