// isect lang: the languages, how much of isect's texts each has, and files for translators.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/program.h"
#include "app/shell/options.h"
#include "app/shell/terminal.h"
#include "viz/lang/language.h"
#include "viz/lang/lesson_texts.h"
#include "viz/lang/po.h"
#include "viz/player/reader_state.h"

namespace isect::program {

namespace {

std::string told(const viz::Coverage& c) { return fmt::format("{} of {} texts", c.translated, c.all); }

/// Returns a line for each language: what it has of isect's own texts, and of which lessons.
std::string list_of(const Program& program) {
  std::string out;
  for (const viz::Language& language : viz::languages()) {
    out +=
        fmt::format("{}  {}: scenes and pages, {}\n", language.code, language.name, told(viz::coverage(language.code)));
    if (language.code == "en") {
      out += fmt::format("    all {} lessons\n", program.lessons.size());
      continue;
    }
    for (const viz::Lesson* lesson : program.lessons)
      if (&viz::lesson_in(*lesson, language.code) != lesson)
        out += fmt::format("    {}, {}\n", lesson->id, told(viz::coverage(*lesson, language.code)));
  }
  return out;
}

/// Returns the texts of a lesson as a file for translators.
std::string template_of(const viz::Lesson& lesson) {
  viz::PoFile file;
  for (const std::string& key : viz::text_keys(lesson)) {
    viz::PoEntry entry;
    entry.english = key, entry.texts = {""};
    file.entries.push_back(std::move(entry));
  }
  return viz::po_text(file);
}

int lang(const Program& program, const std::string& lesson) {
  print(lesson.empty() ? list_of(program) : template_of(viz::lesson_named(program.lessons, lesson)));
  return done;
}

}  // namespace

void add_lang(CLI::App& app, Program& program) {
  CLI::App& sub = *app.add_subcommand("lang", "the languages, and how much of its texts isect has in each");
  const auto lesson = std::make_shared<std::string>();
  sub.add_option("LESSON", *lesson, "prints its texts as a template for translators, in gettext's format")
      ->type_name("")
      ->check(not_empty());
  sub.footer(
      "--lang CODE of show, explain, render, strip, handout, deck, quiz and scene chooses the language, and so does\n"
      "\"lang\": \"de\" in a scene's file. It is that of the words which isect adds: verdicts, lists, questions, alt\n"
      "texts, headings. What you write yourself stays as it is, and so do numbers, with a decimal point, and "
      "pseudocode.\n"
      "A lesson is told in English until somebody translates it. Its texts go to lessons/<its name>/<code>.po, with _\n"
      "for -; \"{1}\" stands for its first number. Build isect again: it then has the language.\n"
      "Example: isect lang sphere-sphere > lessons/sphere_sphere/fr.po");
  sub.callback([&program, lesson] { program.chosen = [&program, lesson] { return lang(program, *lesson); }; });
}

}  // namespace isect::program
