#include "viz/walk/given_answer.h"

#include <fmt/format.h>

#include "viz/lang/message.h"
#include "viz/text/number_text.h"
#include "viz/walk/given_order.h"
#include "viz/walk/pointed_line.h"
#include "viz/walk/typed_answer.h"

namespace isect::viz {

bool wants_more(const Question& question) { return question.number || question.line || question.order; }

std::string how_to_answer(const Question& question) {
  if (question.line) return how_to_point();
  if (question.order) return how_to_order(*question.order);
  return question.number ? what_to_type(*question.number) : std::string();
}

GivenAnswer answer_from(const Walk& walk, int step, const std::string& typed) {
  const Question& question = *walk.steps.at(static_cast<std::size_t>(step)).question;
  GivenAnswer given;
  if (question.line) {
    given = pointed_at(question, line_from(typed, static_cast<int>(walk.pseudocode.size())));
  } else if (question.order) {
    given.order = order_from(typed, static_cast<int>(question.order->tiles.size()));
    given.choice = choice_of_order(question, given.order);
  } else {
    given.number = number_from(typed);
    given.choice = choice_of(question, given.number).value_or(-1);
  }
  given.typed = typed;
  return given;
}

GivenAnswer pointed_at(const Question& question, int line) {
  GivenAnswer given;
  given.line = line;
  given.choice = choice_of_line(question, line);
  return given;
}

std::string told_of(const Question& question, const GivenAnswer& given) {
  if (given.line >= 0) return tr("You pointed at line {n}.", {{"n", std::to_string(given.line + 1)}});
  if (!given.order.empty()) return tr("Your order was: {tiles}.", {{"tiles", tiles_in(*question.order, given.order)}});
  return given.typed.empty() ? std::string()
                             : tr("You typed {number}.", {{"number", typed_text(given.typed, given.number)}});
}

std::string reply_to(const Walk& walk, int step, const GivenAnswer& given) {
  const Question& question = *walk.steps.at(static_cast<std::size_t>(step)).question;
  if (question.line) {
    const int line = given.line >= 0 ? given.line : question.line->offered.at(static_cast<std::size_t>(given.choice));
    return line_replies(walk, step).at(static_cast<std::size_t>(line));
  }
  if (question.order) {
    const std::vector<std::vector<int>>& offered = question.order->offered;
    return reply_to(*question.order,
                    given.order.empty() ? offered.at(static_cast<std::size_t>(given.choice)) : given.order);
  }
  return given.typed.empty() ? reply_to_choice(question, given.choice) : reply_to(*question.number, given.number);
}

}  // namespace isect::viz
