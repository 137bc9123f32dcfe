#pragma once
// The top of the first page: a picture to drag, where to begin, and what can be searched for.

#include <string>
#include <vector>

#include "app/book/page_shell.h"
#include "app/shell/options.h"
#include "viz/course.h"
#include "viz/formats/page_svg.h"

namespace isect::program::book {

/// What is compiled for browsers and lies beside the pages: the lessons, and what reads scenes.
struct Compiled {
  bool lessons = false, scenes = false;
};

/// Returns the top of the first page. `openings`: the first preset of each lesson, walked. Its picture may be taken out
/// of the page: draw it after all pictures that stay.
std::string cover(const std::vector<Excerpt>& openings, const Compiled&, viz::PagePictures&);
/// Returns the terms of the course for a script: name, meaning and id in glossary.html.
std::string terms_to_find(const viz::Course&);

/// Returns how many minutes a walk takes with its questions, at twenty seconds each; at least 1.
int minutes_of(const viz::Walk&);
/// Returns "1 minute", "40 minutes"; from an hour on in whole hours.
std::string duration(int minutes);
/// Returns the id of a term in glossary.html: "term-back-face". Those of letters keep upper and lower case apart.
std::string term_id(const viz::Course::Term&);

}  // namespace isect::program::book
