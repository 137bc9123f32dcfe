#pragma once
// Files of pages beside their pictures, written over isect's own files only.

#include <string>
#include <vector>

#include "app/figures/blocks.h"
#include "app/figures/figure_folder.h"
#include "app/figures/figure_maker.h"
#include "app/pages/paper.h"

namespace isect::program {

struct PageFile {
  std::string name, mark;  ///< "handout.tex", and the first line of those that isect wrote
  bool at_end = false;     ///< the mark stands at the end instead: of a package
};

/// Throws viz::FileError if a file of somebody else's has the name.
void need_own(const std::string& folder, const std::vector<PageFile>&);

/// Returns the image as a page of this paper refers to it.
Image image_of(const FigureInfo&, const Paper&);

/// The options of handouts, quizzes and decks, as written on the command line.
struct PageOptions {
  Selection asked;
  std::string theme = "print", width, out;
};
/// Returns the theme by its name; pages are white. Throws viz::BadInput.
std::string theme_of_pages(const PageOptions&);

/// The two pages of a paper, beside their pictures; all values must outlive it.
class PageFolder {
 public:
  /// `kind`: "handout", "quiz" or "deck"; `formats`: those of its pictures; `which`: the steps that it shows, or that
  /// ask without being shown. Throws viz::FileError if a file that it would replace is not isect's.
  PageFolder(const Program&, const PageOptions&, const Paper&, const std::string& kind,
             const std::vector<const viz::Format*>& formats, PaperSteps which = PaperSteps::all);
  /// Writes a picture of one of its parts.
  void add(const Excerpt&, const FigureInfo&, const viz::Drawing&, FigureMaker&);
  /// Writes both pages below their first lines, and says where they are.
  void finish(const std::string& latex, const std::string& html);

 private:
  const Paper& paper_;
  const std::string kind_;
  const std::vector<const viz::Format*> formats_;
  FigureFolder figures_;
};

/// Adds the options. `what`: "handout", "quiz" or "deck"; a folder called "handouts" is theirs if none is given.
void add_page_options(CLI::App&, const Program&, PageOptions&, const std::string& what);

}  // namespace isect::program
