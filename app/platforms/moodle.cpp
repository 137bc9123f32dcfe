// Questions as Moodle XML.

#include <fmt/format.h>

#include "app/pages/html.h"
#include "app/platforms/quiz_formats.h"
#include "app/platforms/quiz_html.h"
#include "viz/formats/svg_path.h"
#include "viz/walk/given_order.h"
#include "viz/walk/typed_answer.h"

namespace isect::program::platforms {

namespace {

/// Returns an element with a text of HTML, and what stands behind that in it.
std::string moodle_text(const std::string& element, const std::string& html, const std::string& more = {}) {
  return fmt::format("<{0} format=\"html\"><text>{1}</text>{2}</{0}>\n", element, viz::xml_escaped(html), more);
}

std::string moodle_feedback(const std::string& reply) { return moodle_text("feedback", html_text(reply)); }

/// `text`: escaped; `format`: of that text; `more`: behind the feedback.
std::string moodle_answer(bool right, const std::string& text, const std::string& format, const std::string& reply,
                          const std::string& more = {}) {
  return fmt::format("<answer fraction=\"{}\" format=\"{}\"><text>{}</text>{}{}</answer>\n", right ? 100 : 0, format,
                     text, moodle_feedback(reply), more);
}

/// Returns the answers to a question for a number: Moodle takes the first that fits.
std::string moodle_numerical(const viz::Numeric& number) {
  const auto answer = [](bool right, double value, double tolerance, const std::string& reply) {
    return moodle_answer(right, decimal(value), "moodle_auto_format", reply,
                         fmt::format("<tolerance>{}</tolerance>", decimal(tolerance)));
  };
  std::string out = answer(true, number.truth, viz::tolerance(number, number.truth), {});
  for (const viz::Reply& reply : viz::replies(number)) out += answer(false, reply.value, reply.tolerance, reply.text);
  return out +
         "<unitgradingtype>0</unitgradingtype>\n<unitpenalty>0.1</unitpenalty>\n<showunits>3</showunits>\n"
         "<unitsleft>0</unitsleft>\n";
}

std::string moodle_shortanswer(const viz::OrderAsked& order) {
  std::string out = "<usecase>0</usecase>\n";
  for (const std::vector<int>& right : right_orders(order))
    out += moodle_answer(true, viz::letters_of(right), "moodle_auto_format", {});
  for (const QuizOrder& wrong : wrong_orders(order))
    out += moodle_answer(false, viz::letters_of(wrong.order), "moodle_auto_format", wrong.reply);
  return out;
}

/// Returns the choices, in the order in which the lesson offers them; lines of pseudocode have numbers of their own.
std::string moodle_multichoice(const QuizItem& item) {
  std::string out = fmt::format(
      "<single>true</single>\n<shuffleanswers>false</shuffleanswers>\n<answernumbering>{}</answernumbering>\n"
      "<showstandardinstruction>0</showstandardinstruction>\n",
      item.lines ? "none" : "abc");
  for (const char* feedback : {"correctfeedback", "partiallycorrectfeedback", "incorrectfeedback"})
    out += moodle_text(feedback, {});
  for (std::size_t i = 0; i < item.choices.size(); ++i)
    out += moodle_answer(i == item.right, viz::xml_escaped(html_text(item.choices[i].text)), "html",
                         item.choices[i].reply);
  return out;
}

/// `picture`: the name of its file.
std::string moodle_question(const QuizItem& item, const std::string& picture) {
  const std::string file = item.picture ? fmt::format("<file name=\"{}\" path=\"/\" encoding=\"base64\">{}</file>",
                                                      picture, viz::base64(item.picture->png))
                                        : std::string();
  const std::string text = picture_html(item, "@@PLUGINFILE@@/" + picture) + task_html(item) + tiles_html(item) +
                           paragraphs_html(what_to_answer(item));
  const char* type = item.order ? "shortanswer" : item.number ? "numerical" : "multichoice";
  return fmt::format(
      "<question type=\"{}\">\n<name><text>{}</text></name>\n{}{}"
      "<defaultgrade>1</defaultgrade>\n<penalty>0.3333333</penalty>\n<hidden>0</hidden>\n"
      "<idnumber>{}</idnumber>\n{}</question>\n",
      type, viz::xml_escaped(item.title), moodle_text("questiontext", text, file),
      moodle_text("generalfeedback", paragraphs_html(item.solution)), item.id,
      item.order    ? moodle_shortanswer(*item.order)
      : item.number ? moodle_numerical(*item.number)
                    : moodle_multichoice(item));
}

}  // namespace

std::string moodle(const QuizSheet& sheet, const std::string& mark) {
  std::string out = fmt::format(
      "{}\n<quiz>\n<question type=\"category\">\n<category><text>$course$/top/isect/{}</text></category>\n"
      "<info format=\"html\"><text>{}</text></info>\n</question>\n",
      mark, viz::xml_escaped(sheet.name), viz::xml_escaped(viz::xml_escaped(sheet.title)));
  int number = 0;
  for (const QuizItem& item : sheet.items) out += moodle_question(item, fmt::format("question-{}.png", ++number));
  return out + "</quiz>\n";
}

}  // namespace isect::program::platforms
