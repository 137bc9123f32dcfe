#include "app/pages/pages.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/figures/ownership.h"
#include "app/figures/question_figure.h"
#include "app/figures/theme_choice.h"
#include "app/pages/html.h"
#include "app/pages/latex.h"
#include "app/shell/environment.h"
#include "app/shell/terminal.h"
#include "viz/formats/files.h"

namespace isect::program {

namespace fs = std::filesystem;

void need_own(const std::string& folder, const std::vector<PageFile>& files) {
  std::error_code absent;
  const auto is_own = [](const PageFile& file, const std::string& bytes) {
    return file.at_end ? bytes.ends_with(file.mark) : bytes.starts_with(file.mark);
  };
  for (const PageFile& file : files)
    if (fs::is_regular_file(folder + file.name, absent) && !is_own(file, viz::read_regular_file(folder + file.name)))
      throw viz::FileError(
          fmt::format("cannot write '{}': the file there was not made by isect; move it away, or give another folder "
                      "with --out",
                      folder + file.name));
}

PageFormats page_formats(const std::string& words) {
  PageFormats formats;
  std::istringstream all(words + ",");
  for (std::string name; std::getline(all, name, ',');) {
    if (name == "tex")
      formats.tex = true;
    else if (name == "html")
      formats.html = true;
    else if (name == "pdf")
      formats.pdf = true;
    else
      throw viz::unknown("format", name, {"tex", "html", "pdf"});
  }
  return formats;
}

namespace {

/// Returns the last line of a PDF, by which isect knows it as its own: a comment.
std::string pdf_mark(const std::string& kind) { return latex_mark(kind) + "\n"; }

std::vector<PageFile> files_of(const std::string& kind, const PageFormats& formats) {
  std::vector<PageFile> files;
  if (formats.tex) files.push_back({kind + ".tex", latex_mark(kind)});
  if (formats.html) files.push_back({kind + ".html", html_mark(kind)});
  if (formats.pdf) files.push_back({kind + ".pdf", pdf_mark(kind), true});
  return files;
}

bool is_for_latex(const viz::Format& picture) { return picture.name == "tikz"; }

/// Returns why a PDF has no tags.
std::string why_untagged(const LatexPdf& pdf, bool template_has_metadata) {
  if (!pdf.untagged_because.empty()) return "LaTeX stopped with them: " + pdf.untagged_because;
  if (pdf.engine != "lualatex")
    return pdf.engine + " makes none; on Debian: apt-get install texlive-luatex texlive-latex-extra";
  if (!template_has_metadata) return "the template has no %%ISECT:metadata%% before \\documentclass";
  return "this LaTeX is too old for them, or has no tagpdf; on Debian: apt-get install texlive-latex-extra";
}

}  // namespace

PageFolder::PageFolder(const Program& program, const PageOptions& options, const PageFormats& pages, const Paper& paper,
                       const std::string& kind, const std::vector<const viz::Format*>& formats, PaperSteps which)
    : paper_(paper), kind_(kind), pages_(pages), formats_(formats), figures_(options.out, program) {
  template_ = options.page_template.empty() ? built_in_template(kind) : read_template(options.page_template);
  need_own((fs::path(options.out) / paper.folder).string() + "/", files_of(kind, pages));
  if (pages.pdf) latex_ = std::make_unique<LatexRun>(kind);
  need_environment(program);
  for (const PaperPart& part : paper.parts)
    for (const int step : part.e.steps)
      for (const viz::Format* format : formats) {
        if (!(is_for_latex(*format) ? pages.tex : pages.html)) continue;
        if (which == PaperSteps::all) figures_.need_ours(info_of(part.e, step), *format);
        if (part.e.walk.steps[step].question) figures_.need_ours(info_of_question(part.e, step), *format);
      }
}

void PageFolder::add(const Excerpt& e, const FigureInfo& info, const viz::Drawing& drawing, FigureMaker& maker) {
  for (const viz::Format* format : formats_) {
    const bool for_latex = is_for_latex(*format), listed = for_latex ? pages_.tex : pages_.html;
    if (!listed && !(for_latex && latex_)) continue;
    const FigureFile made = maker.write_for_folder(info, drawing, *format);
    if (for_latex && latex_) {
      const std::string stem = image_of(info, paper_).stem;
      latex_->add(stem + "." + format->name, made.bytes);
      if (!made.faces.empty()) latex_->add(faces_of(stem) + ".pdf", made.faces);
    }
    if (listed)
      figures_.add(e, info, format->name, made,
                   {{"theme", viz::name_of(maker.style().theme)},
                    {"width_pt", drawing.width},
                    {"height_pt", drawing.height},
                    {"text_pt", maker.style().paper->text_size}});
  }
}

void PageFolder::finish(const PageParts& latex, const std::string& html) {
  const std::string file = paper_.folder + "/" + kind_;
  const std::string page = latex_mark(kind_) + "\n" + filled(template_, latex);
  if (pages_.tex) print(figures_.add_page(file + ".tex", page));
  if (pages_.html) print(figures_.add_page(file + ".html", html_mark(kind_) + html));
  if (latex_) finish_pdf(file + ".pdf", page);
  figures_.list();
  figures_.say_left_alone();
}

void PageFolder::finish_pdf(const std::string& file, const std::string& page) {
  const SaidLater long_work(file + ": LaTeX is setting the page", is_terminal(STDERR_FILENO));
  const LatexPdf pdf = latex_->run(page);
  print(figures_.add_page(file, pdf.bytes + pdf_mark(kind_)));
  const bool can_have_tags = kind_ != "deck";  // beamer makes none
  if (can_have_tags && !pdf.tagged)
    say(fmt::format("{}: no tags for screen readers: {}", file,
                    why_untagged(pdf, page.find(untagged_macro) != page.npos)));
}

int print_template(const std::string& kind) {
  print(built_in_template(kind));
  return done;
}

Image image_of(const FigureInfo& info, const Paper& paper) {
  return {info.stem.substr(paper.folder.size() + 1), {}, info.alt};
}

std::string theme_of_pages(const PageOptions& options) {
  const viz::ThemeChoice theme = theme_choice(options.theme);
  if (theme.base() == viz::ThemeName::dark)
    throw viz::BadInput(fmt::format("theme: \"{}\"{} is not meant for white pages; give print, grey or screen{}",
                                    viz::name_of(theme), theme.own() ? ", which is based on dark," : "",
                                    theme.own() ? ", or a theme based on one of them" : ""));
  return options.theme;
}

void add_page_options(CLI::App& sub, const Program& program, PageOptions& options, const std::string& what) {
  const std::string width = options.width;
  if (options.out.empty()) options.out = what + "s";
  add_lesson(sub, program, options.asked, Takes::one, "a lesson's id, or the file of a preset, a scene or a playlist");
  add_preset(sub, options.asked, Takes::one, "a preset, or a file with one; the first if not given");
  add_step(sub, options.asked, Takes::many, "counted from 1: 3, 3-6, 3,5,7-9 or all (if not given)");
  add_scene_file(sub, program, options.asked);
  add_set(sub, options.asked);
  if (what != "quiz") add_answers(sub, options.asked);  // a scene has no question for it
  add_language(sub, options.asked);
  sub.add_option("--theme", options.theme,
                 "print (if not given), grey, screen, or the file of one of your own:\nsee isect theme --help")
      ->type_name("THEME");
  sub.add_option("--width", options.width, fmt::format("of each picture; {} if not given", width))->type_name("LENGTH");
  if (what != "quiz")  // it has formats of its own
    sub.add_option(
           "--format", options.format,
           "tex,html (if not given), pdf; several are joined by commas. LaTeX,\nif it is installed, makes the pdf")
        ->type_name("FORMAT");
  add_path(sub, "--template", options.page_template,
           "your own LaTeX around the page: a file with the places\n%%ISECT:preamble%% and %%ISECT:body%%; may have "
           "%%ISECT:title%%,\nand %%ISECT:metadata%% before \\documentclass",
           "FILE");
  sub.add_flag("--print-template", options.print_template, "writes the built-in template to stdout, to start from");
  add_path(sub, "--out", options.out, fmt::format("folder; {} if not given", options.out), "DIR");
}

}  // namespace isect::program
