#pragma once
// A lesson as one page: what is asked, every preset step by step, the card, exercises and sources.

#include <string>
#include <vector>

#include "app/book/page.h"
#include "app/options.h"
#include "viz/page_svg.h"

namespace isect::program::book {

/// `presets`: all of the lesson's, walked, in order.
Page lesson_page(const viz::Lesson&, const std::vector<Excerpt>& presets, const std::vector<const viz::Lesson*>& course,
                 const Neighbours&, viz::PageColours&);

}  // namespace isect::program::book
