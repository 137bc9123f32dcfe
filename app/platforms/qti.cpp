// Questions as a package of QTI 2.1: imsmanifest.xml, a test, and an item for each question with its picture beside it.

#include <fmt/format.h>

#include <utility>

#include "app/pages/html.h"
#include "app/platforms/quiz_formats.h"
#include "app/platforms/quiz_html.h"
#include "app/platforms/zip.h"
#include "viz/formats/svg_path.h"
#include "viz/player/reader_state.h"
#include "viz/walk/typed_answer.h"

namespace isect::program::platforms {

namespace {

constexpr const char* qti_namespace = "http://www.imsglobal.org/xsd/imsqti_v2p1";
constexpr const char* match_correct = "http://www.imsglobal.org/question/qti_v2p1/rptemplates/match_correct";
/// The outcome that shows the right answer, beside those that show what is said to a wrong one.
constexpr const char* told_to_all = "SOLUTION";

const std::string xml_head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

std::string choice_id(std::size_t i) { return fmt::format("CHOICE-{}", i + 1); }
std::string wrong_id(std::size_t i) { return fmt::format("WRONG-{}", i + 1); }

std::string base_value(const char* type, const std::string& value) {
  return fmt::format("<baseValue baseType=\"{}\">{}</baseValue>", type, value);
}

/// Returns the rule that shows these feedbacks; each is an expression.
std::string shows(const std::string& feedbacks) {
  return fmt::format("<setOutcomeValue identifier=\"FEEDBACK\"><multiple>{}{}</multiple></setOutcomeValue>", feedbacks,
                     base_value("identifier", told_to_all));
}

std::string scores(int points) {
  return fmt::format("<setOutcomeValue identifier=\"SCORE\">{}</setOutcomeValue>",
                     base_value("float", std::to_string(points)));
}

/// A feedback and its text, as markup.
struct Told {
  std::string id, text;
};

/// What differs between the kinds of question.
struct Kind {
  const char *cardinality, *type;  ///< of the response
  std::vector<std::string> right;  ///< the values of the right response
  std::string interaction;         ///< an element of the item's body
  std::string rules;               ///< that set SCORE and FEEDBACK
  bool by_template = false;        ///< SCORE is what the standard's template match_correct sets
  std::vector<Told> told = {};     ///< to wrong responses
};

std::string simple_choices(const std::vector<std::string>& texts) {
  std::string out;
  for (std::size_t i = 0; i < texts.size(); ++i)
    out += fmt::format("<simpleChoice identifier=\"{}\">{}</simpleChoice>\n", choice_id(i), html_text(texts[i]));
  return out;
}

constexpr const char* is_correct =
    "<match><variable identifier=\"RESPONSE\"/><correct identifier=\"RESPONSE\"/></match>";

std::string condition(const std::string& cases) {
  return fmt::format("<responseCondition>\n{}</responseCondition>\n", cases);
}
/// `element`: responseIf or responseElseIf.
std::string one_case(const char* element, const std::string& holds, const std::string& rules) {
  return fmt::format("<{0}>{1}{2}</{0}>\n", element, holds, rules);
}
std::string otherwise(const std::string& rules) { return fmt::format("<responseElse>{}</responseElse>\n", rules); }

Kind choice_kind(const QuizItem& item) {
  Kind kind = {"single", "identifier", {choice_id(item.right)}, {}, {}, true};
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < item.choices.size(); ++i) {
    texts.push_back(item.choices[i].text);
    if (!item.choices[i].reply.empty()) kind.told.push_back({choice_id(i), item.choices[i].reply});
  }
  kind.interaction = fmt::format(
      "<choiceInteraction responseIdentifier=\"RESPONSE\" shuffle=\"false\" "
      "maxChoices=\"1\">\n{}</choiceInteraction>\n",
      simple_choices(texts));
  kind.rules = condition(one_case("responseIf", is_correct, scores(1)) + otherwise(scores(0))) +
               shows("<variable identifier=\"RESPONSE\"/>") + "\n";
  return kind;
}

/// Returns whether the response is a number, up to a tolerance.
std::string equals(double value, double tolerance) {
  return fmt::format(
      "<equal toleranceMode=\"absolute\" tolerance=\"{0} {0}\"><variable identifier=\"RESPONSE\"/>{1}</equal>",
      decimal(tolerance), base_value("float", decimal(value)));
}

Kind number_kind(const QuizItem& item) {
  const viz::Numeric& number = *item.number;
  Kind kind = {"single", "float", {decimal(number.truth)}, {}, {}};
  kind.interaction =
      fmt::format("<p>{} <textEntryInteraction responseIdentifier=\"RESPONSE\" expectedLength=\"12\"/></p>\n",
                  html_text(what_to_answer(item)));
  std::string cases =
      one_case("responseIf", "<isNull><variable identifier=\"RESPONSE\"/></isNull>", scores(0)) +
      one_case("responseElseIf", equals(number.truth, viz::tolerance(number, number.truth)), scores(1) + shows({}));
  for (const viz::Reply& reply : viz::replies(number)) {
    kind.told.push_back({wrong_id(kind.told.size()), reply.text});
    cases += one_case("responseElseIf", equals(reply.value, reply.tolerance),
                      scores(0) + shows(base_value("identifier", kind.told.back().id)));
  }
  kind.rules = condition(cases + otherwise(scores(0) + shows({})));
  return kind;
}

/// Returns whether the response is this order.
std::string is_order(const std::vector<int>& order) {
  std::string values;
  for (const int tile : order) values += base_value("identifier", choice_id(static_cast<std::size_t>(tile)));
  return fmt::format("<match><variable identifier=\"RESPONSE\"/><ordered>{}</ordered></match>", values);
}

Kind order_kind(const QuizItem& item) {
  const std::vector<std::vector<int>> right = right_orders(*item.order);
  Kind kind = {"ordered", "identifier", {}, {}, {}, right.size() == 1};
  for (const int tile : right.front()) kind.right.push_back(choice_id(static_cast<std::size_t>(tile)));
  kind.interaction =
      fmt::format("<orderInteraction responseIdentifier=\"RESPONSE\" shuffle=\"false\">\n{}</orderInteraction>\n",
                  simple_choices(item.order->tiles));
  std::string any;
  for (const std::vector<int>& order : right) any += is_order(order);
  const std::string holds = kind.by_template ? is_correct : fmt::format("<or>{}</or>", any);
  std::string cases = one_case("responseIf", holds, scores(1) + shows({}));
  for (const QuizOrder& wrong : wrong_orders(*item.order)) {
    kind.told.push_back({wrong_id(kind.told.size()), wrong.reply});
    cases += one_case("responseElseIf", is_order(wrong.order),
                      scores(0) + shows(base_value("identifier", kind.told.back().id)));
  }
  kind.rules = condition(cases + otherwise(scores(0) + shows({})));
  return kind;
}

std::string modal_feedback(const std::string& id, const std::string& text) {
  return fmt::format(
      "<modalFeedback outcomeIdentifier=\"FEEDBACK\" identifier=\"{}\" showHide=\"show\">{}</modalFeedback>\n", id,
      paragraphs_html(text));
}

/// `element`: the root, and its attributes besides the identifier, the title and the tool.
std::string qti_root(const std::string& element, const std::string& attributes, const std::string& identifier,
                     const std::string& title, const std::string& inside) {
  return fmt::format(
      "{0}<{1} xmlns=\"{2}\" identifier=\"{3}\" title=\"{4}\"{5} toolName=\"isect\" toolVersion=\"{6}\">\n{7}</{1}>\n",
      xml_head, element, qti_namespace, identifier, viz::xml_escaped(title), attributes, viz::version(), inside);
}

/// `picture`: the name of its file, beside the item.
std::string assessment_item(const QuizItem& item, const std::string& picture) {
  const Kind kind = item.order ? order_kind(item) : item.number ? number_kind(item) : choice_kind(item);
  std::string values, feedbacks;
  for (const std::string& value : kind.right) values += fmt::format("<value>{}</value>", value);
  for (const Told& told : kind.told) feedbacks += modal_feedback(told.id, told.text);
  return qti_root(
      "assessmentItem", " adaptive=\"false\" timeDependent=\"false\" xml:lang=\"en\"", item.id, item.title,
      fmt::format("<responseDeclaration identifier=\"RESPONSE\" cardinality=\"{}\" baseType=\"{}\">\n"
                  "<correctResponse>{}</correctResponse>\n</responseDeclaration>\n"
                  "<outcomeDeclaration identifier=\"SCORE\" cardinality=\"single\" baseType=\"float\" "
                  "normalMaximum=\"1\">\n<defaultValue><value>0</value></defaultValue>\n</outcomeDeclaration>\n"
                  "<outcomeDeclaration identifier=\"FEEDBACK\" cardinality=\"multiple\" baseType=\"identifier\"/>\n"
                  "<itemBody>\n{}{}\n{}</itemBody>\n<responseProcessing{}>\n{}</responseProcessing>\n{}{}",
                  kind.cardinality, kind.type, values, picture_html(item, picture), task_html(item), kind.interaction,
                  kind.by_template ? fmt::format(" template=\"{}\"", match_correct) : std::string(), kind.rules,
                  feedbacks, modal_feedback(told_to_all, item.solution)));
}

std::string assessment_test(const QuizSheet& sheet, const std::string& identifier) {
  std::string items;
  for (std::size_t i = 0; i < sheet.items.size(); ++i)
    items += fmt::format("<assessmentItemRef identifier=\"{}\" href=\"items/question-{}.xml\"/>\n", sheet.items[i].id,
                         i + 1);
  return qti_root(
      "assessmentTest", {}, identifier, sheet.title,
      fmt::format("<outcomeDeclaration identifier=\"SCORE\" cardinality=\"single\" baseType=\"float\"/>\n"
                  "<testPart identifier=\"PART\" navigationMode=\"nonlinear\" submissionMode=\"individual\">\n"
                  "<itemSessionControl showFeedback=\"true\"/>\n"
                  "<assessmentSection identifier=\"SECTION\" title=\"{}\" visible=\"true\">\n{}</assessmentSection>\n"
                  "</testPart>\n<outcomeProcessing><setOutcomeValue identifier=\"SCORE\"><sum>"
                  "<testVariables variableIdentifier=\"SCORE\"/></sum></setOutcomeValue></outcomeProcessing>\n",
                  viz::xml_escaped(sheet.title), items));
}

/// Returns a resource, whose own file is the first.
std::string resource(const std::string& identifier, const char* type, const std::vector<std::string>& files,
                     const std::string& needs = {}) {
  std::string all;
  for (const std::string& file : files) all += fmt::format("<file href=\"{}\"/>", file);
  return fmt::format("<resource identifier=\"{}\" type=\"{}\" href=\"{}\">{}{}</resource>\n", identifier, type,
                     files.front(), all, needs);
}

}  // namespace

std::string qti(const QuizSheet& sheet, const std::string& mark) {
  const std::string name = identifier(sheet.name);
  std::vector<ZipEntry> files = {{"imsmanifest.xml", {}}, {"test.xml", assessment_test(sheet, name)}};
  std::string resources, needs;
  for (std::size_t i = 0; i < sheet.items.size(); ++i) {
    const QuizItem& item = sheet.items[i];
    const std::string picture = fmt::format("question-{}.png", i + 1);
    std::vector<std::string> own = {fmt::format("items/question-{}.xml", i + 1)};
    files.push_back({own.front(), assessment_item(item, picture)});
    if (item.picture) own.push_back("items/" + picture), files.push_back({own.back(), item.picture->png});
    resources += resource(item.id, "imsqti_item_xmlv2p1", own);
    needs += fmt::format("<dependency identifierref=\"{}\"/>", item.id);
  }
  files.front().bytes = fmt::format(
      "{}<manifest xmlns=\"http://www.imsglobal.org/xsd/imscp_v1p1\" identifier=\"{}.manifest\">\n"
      "<metadata><schema>QTIv2.1 Package</schema><schemaversion>1.0.0</schemaversion></metadata>\n"
      "<organizations/>\n<resources>\n{}{}</resources>\n</manifest>\n",
      xml_head, name, resource(name, "imsqti_test_xmlv2p1", {"test.xml"}, needs), resources);
  return zip_archive(files, mark);
}

}  // namespace isect::program::platforms
