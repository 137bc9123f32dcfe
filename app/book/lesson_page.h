#pragma once
// A lesson as one page: the question, every preset step by step, the card, exercises and sources.

#include <string>
#include <vector>

#include "app/book/page_shell.h"
#include "app/shell/options.h"
#include "viz/formats/page_svg.h"

namespace isect::program::book {

/// Returns a walked setting, under the id and the title of `as`; `end`: what stands below it. All but the `first` wait.
std::string walk_section(const Excerpt&, const viz::Preset& as, bool first, viz::PagePictures&,
                         const std::string& end = {});

/// `presets`: all those of the lesson, walked, in order.
Page lesson_page(const viz::Lesson&, const std::vector<Excerpt>& presets, const std::vector<const viz::Lesson*>& course,
                 const Neighbours&, viz::PageColours&);

}  // namespace isect::program::book
