#include "app/pages/pages.h"

#include <fmt/format.h>

#include <filesystem>

#include "app/figures/ownership.h"
#include "viz/formats/files.h"

namespace isect::program {

namespace fs = std::filesystem;

std::string folder_of_pages(const std::string& out, const Excerpt& e) {
  return (fs::path(out) / folder_of(e)).string() + "/";
}

void need_own(const std::string& folder, const std::vector<PageFile>& files) {
  std::error_code absent;
  for (const auto& [name, mark] : files)
    if (fs::is_regular_file(folder + name, absent) && !viz::read_regular_file(folder + name).starts_with(mark))
      throw viz::FileError(
          fmt::format("cannot write '{}': the file there was not made by isect; move it away, or give another folder "
                      "with --out",
                      folder + name));
}

Image image_of(const FigureInfo& info) { return {fs::path(info.stem).filename(), {}, info.alt}; }

std::string theme_of_pages(const PageOptions& options) {
  if (viz::theme_named(options.theme) == viz::ThemeName::dark)
    throw viz::BadInput("theme: \"dark\" is not meant for white pages; give print, grey or screen");
  return options.theme;
}

void add_page_options(CLI::App& sub, const Program& program, PageOptions& options, const std::string& what) {
  const std::string width = options.width;
  options.out = what + "s";
  add_lesson(sub, program, options.asked, Takes::one, "a lesson's id, or a preset's file");
  add_preset(sub, options.asked, Takes::one, "a preset, or a file with one; the first if not given");
  add_step(sub, options.asked, Takes::many, "counted from 1: 3, 3-6, 3,5,7-9 or all (if not given)");
  add_scene_file(sub, program, options.asked);
  add_set(sub, options.asked);
  sub.add_option("--theme", options.theme, "print (if not given), grey or screen")->type_name("THEME");
  sub.add_option("--width", options.width, fmt::format("of each picture; {} if not given", width))->type_name("LENGTH");
  add_path(sub, "--out", options.out, fmt::format("folder; {} if not given", options.out), "DIR");
}

}  // namespace isect::program
