#include "app/platforms/quiz_sheet.h"

#include <cmath>
#include <utility>

#include "app/figures/question_figure.h"
#include "app/shell/terminal.h"
#include "viz/lang/message.h"
#include "viz/text/rich_text.h"
#include "viz/walk/step_text.h"

namespace isect::program::platforms {

namespace {

std::optional<QuizPicture> picture_of(const Excerpt& e, int step, const std::string& title, FigureMaker& maker) {
  if (!has_picture(e.walk, step)) return {};
  FigureInfo info = info_of_question(e, step);
  info.metadata.clear();
  info.imprint = title;
  const viz::Drawing drawing = draw_question(maker, e, step);
  const auto pixels = [](double points) { return static_cast<int>(std::lround(points * 96 / 72)); };
  return QuizPicture{maker.write(info, drawing, viz::format_named("png")), info.alt, pixels(drawing.width),
                     pixels(drawing.height)};
}

}  // namespace

Style sheet_style(const std::string& theme, const std::string& width) {
  StyleOptions style;
  style.format = "png", style.theme = theme, style.width = width;
  style.text_size = "11pt", style.dpi = "192", style.no_title = true;
  return style_of(style);
}

QuizSheet sheet_of(const Paper& paper, FigureMaker& maker) {
  QuizSheet sheet = {viz::plain(paper.title), paper.folder, {}};
  std::size_t count = 0;
  for (const PaperPart& part : paper.parts) count += part.e.steps.size();
  const bool counted_on = paper.is_playlist() || paper.parts.size() > 1;  // through all parts
  Progress progress(count);
  for (const PaperPart& part : paper.parts)
    for (const int step : part.e.steps) {
      const int own = viz::question_text(part.e.walk, step)->number;
      const int number = counted_on ? static_cast<int>(sheet.items.size()) + 1 : own;
      QuizItem item = item_of(
          part.e, step, viz::tr("{lesson}: question {n}", {{"lesson", sheet.title}, {"n", std::to_string(number)}}));
      item.picture = picture_of(part.e, step, item.title, maker);
      progress.done(item.title);
      sheet.items.push_back(std::move(item));
    }
  return sheet;
}

}  // namespace isect::program::platforms
