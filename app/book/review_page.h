#pragma once
// A page of questions from five lessons; book.js asks eight of them at a time.

#include <string>
#include <vector>

#include "app/book/page_shell.h"
#include "app/shell/options.h"
#include "viz/formats/page_svg.h"
#include "viz/walk/review.h"

namespace isect::program::book {

/// Return the name of a review's file, "review-1.html", its title, and what it is, in a sentence.
std::string review_file(int number);
std::string review_title(int number);
std::string review_words();

class ReviewPage {
 public:
  explicit ReviewPage(viz::PageColours& colours) : pictures_(colours) {}
  /// Adds each question of a lesson once, in the setting that `shuffled` draws. `presets`: all those of the lesson,
  /// walked, in order. Throws viz::BadInput if labels can't be kept apart.
  void add(const viz::Lesson&, const std::vector<Excerpt>& presets);
  Page page(int number, const Neighbours&) const;

 private:
  void ask(const Excerpt&, const viz::ReviewPrompt&);

  viz::PagePictures pictures_;
  std::string lessons_, questions_, answers_;
  int count_ = 0;
};

}  // namespace isect::program::book
