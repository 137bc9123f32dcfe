#include "viz/compose/paper.h"

#include <algorithm>

#include "viz/compose/halos.h"
#include "viz/text/text.h"

namespace isect::viz {

bool has_one_size(const Theme& theme) {
  return theme.sizes.title == theme.sizes.label && theme.sizes.label == theme.sizes.axis;
}

bool headings_stand_clear(const Figure& figure, const Theme& theme) {
  constexpr double least_gap = 0.6;  // of a letter's height
  const std::vector<Shape>& shapes = figure.drawing.shapes;
  std::vector<TextBox> headings;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Text* const text = std::get_if<Text>(&shapes[i]);
    if (!text || text->object == no_object || figure.drawing.objects.at(text->object).kind != "heading") continue;
    const bool is_number = text->markup.find_first_not_of("0123456789") == std::string::npos;
    if (text->bold && !is_number && stands_on_line(shapes, i, theme)) return false;  // others stand where they belong
    headings.push_back(measure(*text));
  }
  for (const TextBox& a : headings)
    for (const TextBox& b : headings) {
      const bool one_line = a.top < b.bottom && b.top < a.bottom;
      const double gap = b.left - a.right, height = std::max(a.bottom - a.top, b.bottom - b.top);
      if (one_line && gap >= 0 && gap < least_gap * height) return false;
    }
  return true;
}

std::optional<OnPaper> readable_figure(const Walk& walk, int step, const ThemeChoice& theme, const PaperSize& asked,
                                       bool title, const std::function<Camera(double aspect)>& camera) {
  constexpr double wider = 1.05, widest = 8;
  constexpr double for_headings = 1.6, wide = 36;  // the latter in text sizes: on as much, headings have room
  constexpr double of_text = 0.999;                // no text is smaller than was asked for
  const auto at = [&](double factor) {
    const PaperSize size = {factor * asked.width, factor * asked.height, asked.text_size};
    const PageLayout layout = paper_layout(walk, step, theme, size, title);
    return OnPaper{figure(walk.steps[step], camera(layout.width / layout.picture_height()), layout), size};
  };
  const auto stands_clear = [&](const OnPaper& made) {
    return headings_stand_clear(made.figure, paper_theme(theme, asked.text_size));
  };
  const auto is_readable = [&](const OnPaper& made) {
    return label_faults(made.figure, of_text * asked.text_size).empty();
  };
  double factor = 1;
  OnPaper first = at(factor);
  while (!is_readable(first)) {
    factor *= wider;
    if (!(factor < widest)) return {};
    first = at(factor);
  }
  if (stands_clear(first)) return first;
  const double last = std::min(for_headings * factor, wide * asked.text_size / asked.width);
  if (!(last > factor)) return first;
  const OnPaper end = at(last);
  if (!is_readable(end) || !stands_clear(end)) return first;  // some are meant to stand on a line
  for (factor *= wider; factor < last; factor *= wider)
    if (OnPaper made = at(factor); is_readable(made) && stands_clear(made)) return made;
  return end;
}

}  // namespace isect::viz
