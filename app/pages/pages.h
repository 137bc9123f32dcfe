#pragma once
// Files of pages beside their pictures, written over isect's own files only.

#include <string>
#include <vector>

#include "app/figures/blocks.h"
#include "app/figures/figure_folder.h"
#include "app/figures/figure_maker.h"

namespace isect::program {

struct PageFile {
  std::string name, mark;  ///< "handout.tex", and the first line of those that isect wrote
};

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

/// The two pages of an excerpt, beside their pictures; all values must outlive it.
class PageFolder {
 public:
  /// `kind`: "handout" or "deck"; `formats`: those of its pictures. Throws viz::FileError if a file that it would
  /// replace is not isect's.
  PageFolder(const Program&, const PageOptions&, const Excerpt&, const std::string& kind,
             const std::vector<const viz::Format*>& formats);
  /// Writes a picture.
  void add(const FigureInfo&, const viz::Drawing&, FigureMaker&);
  /// Writes both pages below their first lines, and says where they are.
  void finish(const std::string& latex, const std::string& html);

 private:
  const PageOptions& options_;
  const Excerpt& e_;
  const std::string kind_;
  const std::vector<const viz::Format*> formats_;
  FigureFolder figures_;
};

/// Adds the options. `what`: "handout" or "deck"; `out` is its folder if none is given.
void add_page_options(CLI::App&, const Program&, PageOptions&, const std::string& what);

}  // namespace isect::program
