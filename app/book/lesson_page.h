#pragma once
// A lesson as one page: what is asked, every preset step by step, the card, exercises and sources.

#include <string>
#include <vector>

#include "app/book/page.h"
#include "app/options.h"
#include "viz/page_svg.h"

namespace isect::program::book {

/// A setting, walked, under the id and the title of `as`; `end`: what stands below it.
std::string walk_section(const Excerpt&, const viz::Preset& as, bool first, viz::PagePictures&,
                         const std::string& end = {});

/// `presets`: all of the lesson's, walked, in order.
Page lesson_page(const viz::Lesson&, const std::vector<Excerpt>& presets, const std::vector<const viz::Lesson*>& course,
                 const Neighbours&, viz::PageColours&);

}  // namespace isect::program::book
