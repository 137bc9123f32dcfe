#pragma once
// A page as PDF: LaTeX run on it in a folder of its own, without a shell and in bounded time.

#include <string>

#include "app/shell/scratch_folder.h"

namespace isect::program {

/// The PDF that LaTeX made.
struct LatexPdf {
  std::string bytes;
  std::string engine;  ///< "lualatex"
  bool tagged = false;
  std::string untagged_because = {};  ///< LaTeX's error with tags, where it made the PDF without them
};

/// A folder with a page and the files that it reads; it is removed at the end.
class LatexRun {
 public:
  /// `kind`: the page's name, "handout". Throws viz::NoBackend, which says what to install, if there is no LaTeX.
  explicit LatexRun(const std::string& kind);
  /// Adds a file that the page reads, by its path beside the page.
  void add(const std::string& file, const std::string& bytes) const;
  /// Makes the page's PDF, by lualatex or else pdflatex; a page that fails with tags is made without them. Throws
  /// viz::FileError with LaTeX's first error and its place, or if it takes too long.
  LatexPdf run(const std::string& page) const;

 private:
  struct Outcome;
  Outcome compile(bool tags) const;

  const std::string kind_, engine_;
  const ScratchFolder folder_;
};

/// Returns LaTeX's first error with its file and line, from its log: "handout.tex, line 12: Undefined control
/// sequence."; empty if there is none.
std::string first_latex_error(const std::string& log);

}  // namespace isect::program
