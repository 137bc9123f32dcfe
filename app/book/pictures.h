#pragma once
// A step's picture for a page of the book, in the light and in the dark theme.

#include <string>

#include "app/shell/options.h"
#include "viz/formats/page_svg.h"

namespace isect::program::book {

/// Draws the steps of one walk. Formula and verdict stand beside the picture, as text.
class Pictures {
 public:
  /// Both must outlive it. Throws viz::BadInput if labels can't be kept apart.
  Pictures(const Excerpt&, viz::PagePictures&);
  /// Returns a step's picture as a <figure>.
  std::string of(int step);
  /// Returns what is drawn while the question before this step is open: nothing of the answer. It has the class "again"
  /// if the picture before it looks the same.
  std::string asked(int step);

 private:
  std::string figure(int step, const std::string& alt, bool asked);

  const Excerpt& e_;
  viz::PagePictures& page_;
  viz::Walk bare_;  ///< without words
};

}  // namespace isect::program::book
