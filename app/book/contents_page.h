#pragma once
// The pages around the lessons: contents in the order of the course, and the terms.

#include <string>
#include <vector>

#include "app/book/cover.h"
#include "app/book/page_shell.h"
#include "app/shell/options.h"
#include "viz/course.h"
#include "viz/formats/page_svg.h"

namespace isect::program::book {

/// `openings`: the first preset of each lesson, walked; its outcome is the picture of the lesson.
/// `playlists`: links to them, as items of a list.
Page contents_page(const std::vector<Excerpt>& openings, const viz::Course&, const Compiled&,
                   const std::string& playlists, viz::PageColours&);
Page glossary_page(const viz::Course&, const std::vector<const viz::Lesson*>&);

}  // namespace isect::program::book
