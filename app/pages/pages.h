#pragma once
// Files of pages beside their pictures, written over isect's own files only.

#include <memory>
#include <string>
#include <vector>

#include "app/figures/blocks.h"
#include "app/figures/figure_folder.h"
#include "app/figures/figure_maker.h"
#include "app/pages/latex_run.h"
#include "app/pages/paper.h"
#include "app/pages/template.h"

namespace isect::program {

struct PageFile {
  std::string name, mark;  ///< "handout.tex", and the first line of those that isect wrote
  bool at_end = false;     ///< the mark stands at the end instead: of a package
};

/// Throws viz::FileError if a file of somebody else's has the name.
void need_own(const std::string& folder, const std::vector<PageFile>&);

/// Returns the image as a page of this paper refers to it.
Image image_of(const FigureInfo&, const Paper&);

/// The files that a page is written as.
struct PageFormats {
  bool tex = false, html = false, pdf = false;
};
/// Returns the formats of "tex,html". Throws viz::BadInput.
PageFormats page_formats(const std::string& words);

/// The options of handouts, quizzes and decks, as written on the command line.
struct PageOptions {
  Selection asked;
  std::string theme = "print", width, out, format = "tex,html";
  std::string page_template;  ///< a file; empty: the built-in one
  bool print_template = false;
};
/// Returns the theme by its name; pages are white. Throws viz::BadInput.
std::string theme_of_pages(const PageOptions&);

/// The pages of a paper, beside their pictures; all values must outlive it.
class PageFolder {
 public:
  /// `kind`: "handout", "quiz" or "deck"; `formats`: those of its pictures; `which`: the steps that it shows, or that
  /// ask without being shown. Throws viz::FileError if a file that it would replace is not isect's, viz::NoBackend if
  /// LaTeX is to make a PDF and is not here, and what read_template throws.
  PageFolder(const Program&, const PageOptions&, const PageFormats&, const Paper&, const std::string& kind,
             const std::vector<const viz::Format*>& formats, PaperSteps which = PaperSteps::all);
  /// Writes a picture of one of its parts, in the formats that its pages show.
  void add(const Excerpt&, const FigureInfo&, const viz::Drawing&, FigureMaker&);
  /// Writes the pages, and says where they are. Throws viz::FileError, also if LaTeX stops.
  void finish(const PageParts& latex, const std::string& html);

 private:
  void finish_pdf(const std::string& file, const std::string& page);

  const Paper& paper_;
  const std::string kind_;
  const PageFormats pages_;
  const std::vector<const viz::Format*> formats_;
  std::string template_;
  std::unique_ptr<LatexRun> latex_;  ///< if a PDF is asked for
  FigureFolder figures_;
};

/// Writes the built-in template to stdout; returns the exit status.
int print_template(const std::string& kind);

/// Adds the options. `what`: "handout", "quiz" or "deck"; a folder called "handouts" is theirs if none is given.
void add_page_options(CLI::App&, const Program&, PageOptions&, const std::string& what);

}  // namespace isect::program
