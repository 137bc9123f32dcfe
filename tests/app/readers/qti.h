#pragma once
// A package of QTI 2.1: its items, the rules that the standard has for them, and what their responses score.

#include <set>

#include "tests/app/readers/quiz.h"

namespace isect::test {

inline void need_qti(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error("qti: " + what);
}

/// An item: what is read of it, and the item itself.
struct QtiItem {
  ReadQuestion read;
  Xml xml;
  std::vector<std::string> choices = {};  ///< identifiers
  std::string cardinality, type;          ///< of the response
  std::vector<std::string> correct = {};
  std::map<std::string, std::string> told = {};  ///< by identifier of the feedback
};

/// What a response leads to.
struct QtiOutcome {
  double score = -1;
  std::set<std::string> feedbacks = {};
};

/// Runs an item's response processing on a response.
class QtiRules {
 public:
  QtiRules(const QtiItem& item, std::vector<std::string> response) : item_(item), response_(std::move(response)) {}
  QtiOutcome run() {
    rules(item_.xml.one("responseProcessing"));
    return out_;
  }

 private:
  using Values = std::vector<std::string>;
  void rules(const Xml& in) {
    for (const Xml& rule : in.children) {
      if (rule.name == "setOutcomeValue")
        set(rule);
      else if (rule.name == "responseCondition")
        condition(rule);
      else
        need_qti(&rule == &in.children.front(), "a rule is " + rule.name);  // the expression of a case
    }
  }
  void set(const Xml& rule) {
    const Values values = evaluated(rule.children.at(0));
    if (rule.at("identifier") == "SCORE")
      out_.score = std::stod(values.at(0));
    else
      need_qti(rule.at("identifier") == "FEEDBACK", "no such outcome"), out_.feedbacks = {values.begin(), values.end()};
  }
  void condition(const Xml& rule) {
    for (std::size_t i = 0; i < rule.children.size(); ++i) {
      const Xml& one = rule.children[i];
      need_qti(one.name == (i == 0 ? "responseIf" : "responseElseIf") || (i > 0 && one.name == "responseElse"),
               "a case is " + one.name);
      if (one.name != "responseElse" && !holds(one.children.at(0))) continue;
      return rules(one);
    }
  }
  bool holds(const Xml& e) {
    if (e.name == "isNull") return evaluated(e.children.at(0)).empty();
    if (e.name == "match") return evaluated(e.children.at(0)) == evaluated(e.children.at(1));
    if (e.name == "or") return std::ranges::any_of(e.children, [&](const Xml& child) { return holds(child); });
    need_qti(e.name == "equal" && e.at("toleranceMode") == "absolute", "a condition is " + e.name);
    const Values a = evaluated(e.children.at(0)), b = evaluated(e.children.at(1));
    const std::string both = e.at("tolerance");
    const std::size_t space = both.find(' ');
    need_qti(space != both.npos && both.substr(0, space) == both.substr(space + 1), "a tolerance has two sides");
    return std::abs(std::stod(a.at(0)) - std::stod(b.at(0))) <= std::stod(both);
  }
  Values evaluated(const Xml& e) {
    if (e.name == "baseValue") return {e.text};
    if (e.name == "variable") return response_;
    if (e.name == "correct") return item_.correct;
    need_qti(e.name == "multiple" || e.name == "ordered", "an expression is " + e.name);
    Values all;
    for (const Xml& child : e.children)
      for (const std::string& value : evaluated(child)) all.push_back(value);
    return all;
  }

  const QtiItem& item_;
  const Values response_;
  QtiOutcome out_;
};

inline QtiOutcome qti_outcome(const QtiItem& item, const std::vector<std::string>& response) {
  return QtiRules(item, response).run();
}

inline bool is_qti_identifier(const std::string& text) {
  return !text.empty() && (std::isalpha(static_cast<unsigned char>(text[0])) || text[0] == '_') &&
         std::ranges::all_of(text, [](char c) {
           return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-' || c == '.';
         });
}

/// Reads what an item declares, and holds it to the rules.
inline QtiItem read_qti_item(const std::string& document) {
  QtiItem item = {{}, parsed_xml(document), {}, {}, {}, {}, {}};
  const Xml& root = item.xml;
  need_qti(root.name == "assessmentItem" && root.at("xmlns") == "http://www.imsglobal.org/xsd/imsqti_v2p1", "no item");
  need_qti(root.at("adaptive") == "false" && root.at("timeDependent") == "false" && !root.at("title").empty(),
           "an item lacks an attribute");
  need_qti(is_qti_identifier(root.at("identifier")), "no identifier: " + root.at("identifier"));
  item.read.id = root.at("identifier"), item.read.title = root.at("title");
  const Xml& response = root.one("responseDeclaration");
  need_qti(response.at("identifier") == "RESPONSE", "the response has another name");
  item.cardinality = response.at("cardinality"), item.type = response.at("baseType");
  for (const Xml* value : response.one("correctResponse").all("value")) item.correct.push_back(value->text);
  std::map<std::string, std::string> outcomes;
  for (const Xml* o : root.all("outcomeDeclaration"))
    outcomes[o->at("identifier")] = o->at("cardinality") + o->at("baseType");
  need_qti(outcomes == std::map<std::string, std::string>{{"FEEDBACK", "multipleidentifier"}, {"SCORE", "singlefloat"}},
           "the outcomes are others");
  for (const Xml* feedback : root.all("modalFeedback")) {
    need_qti(feedback->at("outcomeIdentifier") == "FEEDBACK" && feedback->at("showHide") == "show",
             "feedback of nothing");
    need_qti(item.told.emplace(feedback->at("identifier"), feedback->words()).second, "a feedback is there twice");
  }
  need_qti(item.told.contains("SOLUTION"), "there is no solution");
  item.read.solution = item.told["SOLUTION"];
  return item;
}

/// The element by which an item is answered: it is one, and refers to the response.
inline const Xml& qti_interaction(const Xml& body, std::string& kind) {
  std::vector<const Xml*> found;
  for (const char* name : {"choiceInteraction", "orderInteraction"})
    for (const Xml* one : body.all(name)) found.push_back(one);
  for (const Xml* p : body.all("p"))
    for (const Xml* one : p->all("textEntryInteraction")) found.push_back(one);
  need_qti(found.size() == 1 && found[0]->at("responseIdentifier") == "RESPONSE", "there is not one interaction");
  kind = found[0]->name == "choiceInteraction" ? "choice" : found[0]->name == "orderInteraction" ? "letters" : "number";
  return *found[0];
}

/// Reads a whole package, `files`. Each item's picture stands beside it.
inline std::vector<QtiItem> read_qti(const std::map<std::string, std::string>& files) {
  const Xml manifest = parsed_xml(files.at("imsmanifest.xml"));
  std::set<std::string> listed = {"imsmanifest.xml"}, ids = {manifest.at("identifier")};
  std::vector<QtiItem> all;
  std::string test;
  for (const Xml* resource : manifest.one("resources").all("resource")) {
    const std::string href = resource->at("href");
    need_qti(ids.insert(resource->at("identifier")).second, "an identifier is there twice");
    for (const Xml* file : resource->all("file")) {
      need_qti(files.contains(file->at("href")), file->at("href") + " is listed and not there");
      listed.insert(file->at("href"));
    }
    need_qti(resource->all("file").at(0)->at("href") == href, href + " is not its resource's own file");
    if (resource->at("type") == "imsqti_test_xmlv2p1") {
      need_qti(test.empty(), "there are two tests"), test = files.at(href);
      continue;
    }
    need_qti(resource->at("type") == "imsqti_item_xmlv2p1", "a resource is " + resource->at("type"));
    QtiItem item = read_qti_item(files.at(href));
    need_qti(item.read.id == resource->at("identifier"), href + " has another identifier than its resource");
    const Xml& body = item.xml.one("itemBody");
    const std::string address = take_picture(item.read, body);
    if (!address.empty()) item.read.png = files.at(href.substr(0, href.rfind('/') + 1) + address);
    const Xml& interaction = qti_interaction(body, item.read.kind);
    for (const Xml* choice : interaction.all("simpleChoice")) {
      need_qti(is_qti_identifier(choice->at("identifier")), "a choice has no identifier");
      item.choices.push_back(choice->at("identifier"));
      item.read.answers.push_back({choice->words()});
    }
    need_qti(std::set<std::string>(item.choices.begin(), item.choices.end()).size() == item.choices.size(),
             "a choice is there twice");
    std::string words;
    for (const Xml& part : body.children)
      if (&part != &interaction) words += part.words();
    item.read.words = words_without_picture(words, !address.empty());
    all.push_back(item);
  }
  for (const auto& [name, bytes] : files) need_qti(listed.contains(name), name + " is in no resource");
  const Xml root = parsed_xml(test);
  const std::vector<const Xml*> refs = root.one("testPart").one("assessmentSection").all("assessmentItemRef");
  need_qti(refs.size() == all.size(), "the test has another number of items");
  for (std::size_t i = 0; i < all.size(); ++i)
    need_qti(refs[i]->at("identifier") == all[i].read.id && files.contains(refs[i]->at("href")), "the test has others");
  return all;
}

}  // namespace isect::test
