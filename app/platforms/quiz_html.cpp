#include "app/platforms/quiz_html.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/pages/html.h"
#include "viz/formats/svg_path.h"
#include "viz/lang/message.h"
#include "viz/walk/given_order.h"
#include "viz/walk/typed_answer.h"

namespace isect::program::platforms {

namespace {

/// Returns lines of markup as one paragraph.
std::string lines_html(const std::vector<std::string>& lines) {
  std::vector<std::string> all;
  for (const std::string& line : lines) all.push_back(html_text(line));
  return all.empty() ? std::string() : fmt::format("<p>{}</p>", fmt::join(all, "<br/>"));
}

}  // namespace

std::string picture_html(const QuizItem& item, const std::string& address) {
  if (!item.picture) return {};
  return fmt::format("<p><img src=\"{}\" alt=\"{}\" width=\"{}\" height=\"{}\"/></p>", viz::xml_escaped(address),
                     viz::xml_escaped(item.picture->alt), item.picture->width, item.picture->height);
}

std::string paragraphs_html(const std::string& markup) {
  std::string out;
  for (const std::string& paragraph : paragraphs(markup)) out += fmt::format("<p>{}</p>", html_text(paragraph));
  return out;
}

std::string task_html(const QuizItem& item) {
  const std::string given =
      item.given.empty() ? "" : fmt::format("<p><b>{}</b> {}</p>", viz::tr("Given"), html_text(item.given));
  return given + lines_html(item.code) + paragraphs_html(item.prompt);
}

std::string tiles_html(const QuizItem& item) {
  if (!item.order) return {};
  std::vector<std::string> lines;
  for (const std::string& tile : item.order->tiles)
    lines.push_back(fmt::format("({}) {}", viz::tile_letter(static_cast<int>(lines.size())), tile));
  return lines_html(lines);
}

std::string what_to_answer(const QuizItem& item) {
  if (item.order)
    return viz::tr("Answer with the letters in their order, without spaces.") +
           (viz::has_ties(*item.order) ? " " + viz::tr("Of equal ones, any may come first.") : "");
  if (!item.number) return {};
  const std::string exactness = viz::exactness(*item.number);
  return item.number->digits == 0 ? viz::tr("Answer with a whole number.")
                                  : viz::tr("Answer with a number {exactness}.", {{"exactness", exactness}});
}

}  // namespace isect::program::platforms
