// isect handout: a lesson to print, as LaTeX and as HTML: pictures, captions, pseudocode, questions, answers at the
// end.

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/gallery.h"
#include "app/ownership.h"
#include "app/studio.h"
#include "app/surroundings.h"
#include "app/terminal.h"
#include "viz/alt_text.h"
#include "viz/files.h"
#include "viz/rich_text.h"
#include "viz/snapshot.h"
#include "viz/svg_path.h"
#include "viz/tex.h"

namespace isect::program {

namespace {

namespace fs = std::filesystem;

struct HandoutOptions {
  Selection asked;
  std::string theme = "print", width = "9cm", out = "handouts";
};

/// By its first line a handout is known to be isect's: another file of that name is left alone.
constexpr const char* tex_mark = "% Made by isect handout.";
constexpr const char* html_mark = "<!-- Made by isect handout. -->";

/// How one of the two is written: the markup of a text, and what stands around its parts.
struct Dialect {
  std::string (*text)(const std::string& markup);
  std::string (*code)(const std::string& line);
  std::string mark, head, foot, section, figure, paragraph, formula, code_begin, code_line, code_end, question, choices,
      choice, choices_end, answers, answer;
};

std::string html_text(const std::string& markup) {
  std::string out;
  for (const viz::Run& run : viz::parse_markup(markup)) {
    std::string text = viz::xml_escaped(run.text);
    if (run.bold) text = fmt::format("<b>{}</b>", text);
    if (run.italic) text = fmt::format("<i>{}</i>", text);
    if (run.script == viz::Run::Script::sub) text = fmt::format("<sub>{}</sub>", text);
    if (run.script == viz::Run::Script::super) text = fmt::format("<sup>{}</sup>", text);
    out += text;
  }
  return out;
}

const Dialect& latex() {
  static const Dialect dialect = {
      viz::tex,
      viz::tex_plain,
      tex_mark,
      "\n\\documentclass[10pt]{{article}}\n\\usepackage{{tikz}}\n\\usepackage[margin=25mm]{{geometry}}\n"
      "\\setlength{{\\parindent}}{{0pt}}\n\\setlength{{\\parskip}}{{4pt plus 1pt}}\n"
      "\\begin{{document}}\n\\section*{{{0}}}\n{1}\n",
      "\\end{document}\n",
      "\n\\subsection*{{{}}}\n",
      "\\begin{{center}}\\input{{{0}.tikz}}\\end{{center}}\n",
      "{}\n\n",
      "\\begin{{center}}{}\\end{{center}}\n",
      "\\begin{{flushleft}}\\small\n",
      "{{\\scriptsize {0:>2}}}\\quad {1}\\\\\n",
      "\\end{{flushleft}}\n",
      "\\textbf{{Question {0}.}} {1}\n",
      "\\begin{{itemize}}\n",
      "\\item[({0})] {1}\n",
      "\\end{{itemize}}\n",
      "\n\\subsection*{{Answers}}\n",
      "\\textbf{{{0}.}} ({1}) {2}. {3}\n\n"};
  return dialect;
}

const Dialect& html() {
  static const Dialect dialect = {
      html_text,
      viz::xml_escaped,
      html_mark,
      "\n<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width\">\n<title>{0}</title>\n<style>\n"
      "body {{ max-width: 42em; margin: 2em auto; padding: 0 1em; font: 11pt/1.45 serif; }}\n"
      "h1, h2 {{ line-height: 1.2; }} h2 {{ margin-top: 2em; break-after: avoid; }}\n"
      "figure {{ margin: 1em 0; text-align: center; break-inside: avoid; }} img {{ max-width: 100%; }}\n"
      "ol.code {{ font: 10pt/1.35 monospace; white-space: pre-wrap; }}\n"
      "ol.choices {{ list-style: lower-alpha; }} .formula {{ text-align: center; }}\n"
      "</style>\n<h1>{0}</h1>\n<p>{1}</p>\n",
      "</html>\n",
      "<h2>{}</h2>\n",
      "<figure><img src=\"{0}.svg\" alt=\"{1}\"></figure>\n",
      "<p>{}</p>\n",
      "<p class=\"formula\">{}</p>\n",
      "<ol class=\"code\">\n",
      "<li>{1}</li>\n",
      "</ol>\n",
      "<p><b>Question {0}.</b> {1}</p>\n",
      "<ol class=\"choices\">\n",
      "<li>{1}</li>\n",
      "</ol>\n",
      "<h2>Answers</h2>\n",
      "<p><b>{0}.</b> ({1}) {2}. {3}</p>\n"};
  return dialect;
}

template <class... Parts>
std::string filled(const std::string& form, const Parts&... parts) {
  return fmt::format(fmt::runtime(form), parts...);
}

char letter(std::size_t i) { return static_cast<char>('a' + i); }

/// The steps in order; a step's question stands before its picture, which shows the answer.
std::string written(const Excerpt& e, const Dialect& d) {
  const auto text = [&](const std::string& markup) { return d.text(markup); };
  std::string out = d.mark + filled(d.head, text(e.lesson->title), text(e.lesson->summary));
  if (!e.walk.pseudocode.empty()) {
    out += filled(d.code_begin);
    for (std::size_t i = 0; i < e.walk.pseudocode.size(); ++i)
      out += filled(d.code_line, i + 1, d.code(e.walk.pseudocode[i]));
    out += filled(d.code_end);
  }
  std::string answers;
  int questions = 0;
  for (const int index : e.steps) {
    const viz::Step& step = e.walk.steps[index];
    out += filled(d.section, text(fmt::format("{}. {}", index + 1, step.title)));
    if (step.question) {
      const viz::Question& q = *step.question;
      out += filled(d.question, ++questions, text(q.prompt)) + filled(d.choices);
      for (std::size_t i = 0; i < q.choices.size(); ++i) out += filled(d.choice, letter(i), text(q.choices[i]));
      out += filled(d.choices_end);
      const auto right = static_cast<std::size_t>(q.answer);
      answers += filled(d.answer, questions, letter(right), text(q.choices.at(right)), text(q.because));
    }
    out += filled(d.figure, viz::file_stem(index, step),
                  viz::xml_escaped(viz::alt_text(*e.lesson, e.parameters, e.walk, index)));
    out += filled(d.paragraph, text(step.caption));
  }
  if (!answers.empty()) out += d.answers + answers;
  return out + d.foot;
}

/// Throws viz::FileError where a file of somebody else's has the name.
void need_own(const std::string& path, const std::string& mark) {
  std::error_code absent;
  if (fs::is_regular_file(path, absent) && !viz::read_regular_file(path).starts_with(mark))
    throw viz::FileError(
        fmt::format("cannot write '{}': the file there was not made by isect; move it away, or give another folder "
                    "with --out",
                    path));
}

int handout(const Program& program, const HandoutOptions& options) {
  StyleOptions style_options;
  style_options.format = "tikz,svg", style_options.theme = options.theme, style_options.width = options.width;
  style_options.text_size = "11pt", style_options.no_title = true;
  const Style style = style_of(style_options);
  const std::vector<Excerpt> chosen = {excerpt(program, options.asked)};
  const Excerpt& e = chosen.front();
  const std::string folder = (fs::path(options.out) / folder_of(e)).string();
  const std::string tex = folder + "/handout.tex", page = folder + "/handout.html";
  need_own(tex, tex_mark);
  need_own(page, html_mark);
  need_surroundings(program);
  Gallery gallery(options.out, program, chosen, style.formats);
  Studio studio(style, "auto");
  for (const int step : e.steps) {
    const viz::Drawing drawing = studio.draw(e, step);
    for (const viz::Format* format : style.formats)
      gallery.add(e, step, format->name, studio.write(e, step, drawing, *format),
                  {{"theme", viz::name_of(style.theme)}, {"width_pt", drawing.width}});
  }
  gallery.list();
  viz::write_file(tex, written(e, latex()));
  viz::write_file(page, written(e, html()));
  print(tex + "\n" + page + "\n");
  return done;
}

}  // namespace

void add_handout(CLI::App& app, Program& program) {
  CLI::App& sub = *app.add_subcommand("handout", "a lesson to print, as LaTeX and as HTML, answers at the end");
  const auto options = std::make_shared<HandoutOptions>();
  add_lesson(sub, program, options->asked, Takes::one, "a lesson's id");
  add_preset(sub, options->asked, Takes::one, "a preset, or a file with one; the first if not given");
  add_step(sub, options->asked, Takes::many, "counted from 1: 3, 3-6, 3,5,7-9 or all (if not given)");
  add_set(sub, options->asked);
  sub.add_option("--theme", options->theme, "print (if not given), grey, screen or dark")->type_name("THEME");
  sub.add_option("--width", options->width, "of each picture; 9cm if not given")->type_name("LENGTH");
  add_path(sub, "--out", options->out, "folder; handouts if not given", "DIR");
  sub.footer(
      "The files go to DIR/<lesson>/<preset>/, beside the pictures: handout.tex, for pdflatex and lualatex run\n"
      "there, and handout.html.\nExample: " +
      program.name + " handout" + (program.only ? "" : " ray-sphere") + " --preset tangent");
  sub.callback([&program, options] { program.chosen = [&program, options] { return handout(program, *options); }; });
}

}  // namespace isect::program
