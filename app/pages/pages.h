#pragma once
// Files of pages beside their pictures, written over isect's own files only.

#include <string>
#include <vector>

#include "app/figures/figure_info.h"
#include "app/figures/style.h"
#include "app/pages/blocks.h"
#include "app/shell/options.h"

namespace isect::program {

struct PageFile {
  std::string name, mark;  ///< "handout.tex", and the first line of those that isect wrote
};

/// Returns the folder of an excerpt's pages below `out`.
std::string folder_of_pages(const std::string& out, const Excerpt&);
/// Throws viz::FileError if a file of somebody else's has the name.
void need_own(const std::string& folder, const std::vector<PageFile>&);

/// Returns the image, beside the page to which it belongs.
Image image_of(const FigureInfo&);

/// The options of handouts and decks, as written on the command line.
struct PageOptions {
  Selection asked;
  std::string theme = "print", width, out;
};
/// Returns the theme by its name; pages are white. Throws viz::BadInput.
std::string theme_of_pages(const PageOptions&);
/// Adds the options. `what`: "handout" or "deck"; `out` is its folder if none is given.
void add_page_options(CLI::App&, const Program&, PageOptions&, const std::string& what);

}  // namespace isect::program
