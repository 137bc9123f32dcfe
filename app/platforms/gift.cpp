// Questions as GIFT, in the dialect of Moodle.

#include <fmt/format.h>

#include "app/pages/html.h"
#include "app/platforms/quiz_formats.h"
#include "app/platforms/quiz_html.h"
#include "viz/formats/svg_path.h"
#include "viz/walk/given_order.h"
#include "viz/walk/typed_answer.h"

namespace isect::program::platforms {

namespace {

/// Escapes what GIFT would interpret. A question ends at an empty line, so there are no line breaks.
std::string gift_escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (std::string("~=#{}:\\").find(c) != std::string::npos) out += '\\';
    out += c == '\n' || c == '\r' ? ' ' : c;
  }
  return out;
}

/// Returns HTML with the mark that says so: without it, a text that begins with a bracket might be taken for one.
std::string gift_html(const std::string& html) { return "[html]" + gift_escaped(html); }

std::string gift_feedback(const std::string& reply) { return reply.empty() ? "" : "#" + gift_html(html_text(reply)); }

std::string gift_numerical(const viz::Numeric& number) {
  std::string out = fmt::format("=%100%{}:{}\n", decimal(number.truth), decimal(viz::tolerance(number, number.truth)));
  for (const viz::Reply& reply : viz::replies(number))
    out += fmt::format("=%0%{}:{}{}\n", decimal(reply.value), decimal(reply.tolerance), gift_feedback(reply.text));
  return out;
}

std::string gift_shortanswer(const viz::OrderAsked& order) {
  std::string out;
  for (const std::vector<int>& right : right_orders(order)) out += fmt::format("=%100%{}\n", viz::letters_of(right));
  for (const QuizOrder& wrong : wrong_orders(order))
    out += fmt::format("=%0%{}{}\n", viz::letters_of(wrong.order), gift_feedback(wrong.reply));
  return out;
}

std::string gift_multichoice(const QuizItem& item) {
  std::string out;
  for (std::size_t i = 0; i < item.choices.size(); ++i)
    out += fmt::format("{}{}{}\n", i == item.right ? "=" : "~", gift_html(html_text(item.choices[i].text)),
                       gift_feedback(item.choices[i].reply));
  return out;
}

std::string gift_question(const QuizItem& item) {
  const std::string address = item.picture ? "data:image/png;base64," + viz::base64(item.picture->png) : "";
  const std::string text =
      picture_html(item, address) + task_html(item) + tiles_html(item) + paragraphs_html(what_to_answer(item));
  return fmt::format("// [id:{}]\n::{}::{}{{{}\n{}####{}\n}}\n\n", item.id, gift_escaped(item.title), gift_html(text),
                     item.number ? "#" : "",
                     item.order    ? gift_shortanswer(*item.order)
                     : item.number ? gift_numerical(*item.number)
                                   : gift_multichoice(item),
                     gift_html(paragraphs_html(item.solution)));
}

}  // namespace

std::string gift(const QuizSheet& sheet, const std::string& mark) {
  // A category's name is read as it stands, with no escapes.
  std::string out = fmt::format("{}\n\n$CATEGORY: $course$/top/isect/{}\n\n", mark, sheet.name);
  for (const QuizItem& item : sheet.items) out += gift_question(item);
  return out;
}

}  // namespace isect::program::platforms
