#include "viz/paper.h"

namespace isect::viz {

std::optional<OnPaper> readable_figure(const Walk& walk, int step, ThemeName theme, const PaperSize& asked, bool title,
                                       const std::function<Camera(double aspect)>& camera) {
  constexpr double wider = 1.05, widest = 8;
  constexpr double least_text = 0.7;  // of the labels' size
  PaperSize size = asked;
  for (double factor = 1; factor < widest; factor *= wider) {
    size.width = factor * asked.width, size.height = factor * asked.height;
    const PageLayout layout = paper_layout(walk, step, theme, size, title);
    Figure made = figure(walk.steps[step], camera(layout.width / layout.picture_height()), layout);
    if (label_faults(made, least_text * size.text_size).empty()) return OnPaper{std::move(made), size};
  }
  return {};
}

}  // namespace isect::viz
