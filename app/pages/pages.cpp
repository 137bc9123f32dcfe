#include "app/pages/pages.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

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

PageFolder::PageFolder(const Program& program, const PageOptions& options, const Paper& paper, const std::string& kind,
                       const std::vector<const viz::Format*>& formats, PaperSteps which)
    : paper_(paper), kind_(kind), formats_(formats), figures_(options.out, program) {
  need_own((fs::path(options.out) / paper.folder).string() + "/",
           {{kind + ".tex", latex_mark(kind)}, {kind + ".html", html_mark(kind)}});
  need_environment(program);
  for (const PaperPart& part : paper.parts)
    for (const int step : part.e.steps)
      for (const viz::Format* format : formats) {
        if (which == PaperSteps::all) figures_.need_ours(info_of(part.e, step), *format);
        if (part.e.walk.steps[step].question) figures_.need_ours(info_of_question(part.e, step), *format);
      }
}

void PageFolder::add(const Excerpt& e, const FigureInfo& info, const viz::Drawing& drawing, FigureMaker& maker) {
  for (const viz::Format* format : formats_)
    figures_.add(e, info, format->name, maker.write(info, drawing, *format),
                 {{"theme", viz::name_of(maker.style().theme)},
                  {"width_pt", drawing.width},
                  {"height_pt", drawing.height},
                  {"text_pt", maker.style().paper->text_size}});
}

void PageFolder::finish(const std::string& latex, const std::string& html) {
  const std::string file = paper_.folder + "/" + kind_;
  print(figures_.add_page(file + ".tex", latex_mark(kind_) + latex));
  print(figures_.add_page(file + ".html", html_mark(kind_) + html));
  figures_.list();
  figures_.say_left_alone();
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
  add_path(sub, "--out", options.out, fmt::format("folder; {} if not given", options.out), "DIR");
}

}  // namespace isect::program
