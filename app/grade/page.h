#pragma once
// The page of a task: what a program is asked, what it reads and answers, by which conventions; as text or Markdown.

#include <cstddef>
#include <string>

#include "app/grade/task.h"

namespace isect::grade {

/// Returns how many numbers a case has: "12", or "1 + 2 n + 2" with lists.
std::string count_of(const Task&);
/// Returns the page as Markdown.
std::string markdown_page(const Task&);
/// Returns the page as text, lines at most `width` characters.
std::string text_page(const Task&, std::size_t width);

}  // namespace isect::grade
