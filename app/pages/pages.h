#pragma once
// Files of pages beside their pictures, written over nothing but isect's own.

#include <string>
#include <vector>

#include "app/options.h"
#include "app/pages/blocks.h"
#include "app/piece.h"
#include "app/style.h"

namespace isect::program {

struct PageFile {
  std::string name, mark;  ///< "handout.tex", and the first line of those that isect wrote
};

/// The folder of an excerpt's pages below `out`.
std::string folder_of_pages(const std::string& out, const Excerpt&);
/// Throws viz::FileError where a file of somebody else's has the name.
void need_own(const std::string& folder, const std::vector<PageFile>&);

/// Beside the page that it belongs to.
Image image_of(const Piece&);

/// What handouts and decks take as options, as written on the command line.
struct PageOptions {
  Selection asked;
  std::string theme = "print", width, out;
};
/// The theme by its name; pages are white. Throws viz::BadInput.
std::string theme_of_pages(const PageOptions&);
/// `what`: "handout" or "deck"; `out` is its folder if none is given.
void add_page_options(CLI::App&, const Program&, PageOptions&, const std::string& what);

}  // namespace isect::program
