#pragma once
// A question as a learning platform reads it from a file, whatever the format.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "tests/app/readers/package.h"

namespace isect::test {

/// An answer in a file: a choice, a number with its tolerance, or letters.
struct ReadAnswer {
  std::string text;  ///< of HTML its words
  bool right = false;
  std::string reply = {};
  double value = 0, tolerance = 0;
};

struct ReadQuestion {
  std::string kind;  ///< "choice", "number" or "letters"
  std::string id, title;
  std::string words;  ///< of the whole text, a line for each paragraph
  std::string solution;
  std::string png, alt;
  std::vector<ReadAnswer> answers = {};

  /// The first answer that fits a number; null: none does.
  const ReadAnswer* of_number(double value) const {
    const auto found =
        std::ranges::find_if(answers, [&](const ReadAnswer& a) { return std::abs(a.value - value) <= a.tolerance; });
    return found == answers.end() ? nullptr : &*found;
  }
  const ReadAnswer* of_letters(const std::string& letters) const {
    const auto found = std::ranges::find(answers, letters, &ReadAnswer::text);
    return found == answers.end() ? nullptr : &*found;
  }
};

/// Takes the only picture of a text, whose address is returned.
inline std::string take_picture(ReadQuestion& to, const Xml& html) {
  std::string address;
  for (const Xml* p : html.all("p"))
    for (const Xml* img : p->all("img")) {
      if (!address.empty()) throw std::runtime_error("a question has two pictures");
      address = img->at("src"), to.alt = img->at("alt");
      if (!(std::stoi(img->at("width")) > 0 && std::stoi(img->at("height")) > 0))
        throw std::runtime_error("a picture has no size");
    }
  return address;
}
/// The words of a text without the line that its picture leaves.
inline std::string words_without_picture(const std::string& words, bool picture) {
  return picture ? words.substr(words.find('\n') + 1) : words;
}

/// Reads Moodle XML; the name of the category goes to `category`.
inline std::vector<ReadQuestion> read_moodle(const std::string& file, std::string& category) {
  std::vector<ReadQuestion> all;
  const auto text = [](const Xml& of) { return of.one("text").text; };
  const Xml quiz = parsed_xml(file);
  if (quiz.name != "quiz") throw std::runtime_error("moodle: the root is " + quiz.name);
  for (const Xml& q : quiz.children) {
    const std::string type = q.at("type");
    if (type == "category") {
      category = text(q.one("category"));
      continue;
    }
    ReadQuestion read = {type == "multichoice" ? "choice"
                         : type == "numerical" ? "number"
                                               : "letters",
                         q.one("idnumber").text,
                         text(q.one("name")),
                         {},
                         {},
                         {},
                         {}};
    if (type != "multichoice" && type != "numerical" && type != "shortanswer")
      throw std::runtime_error("moodle: a question is " + type);
    const Xml html = parsed_html(text(q.one("questiontext")));
    const std::string address = take_picture(read, html), begin = "@@PLUGINFILE@@/";
    const std::vector<const Xml*> files = q.one("questiontext").all("file");
    if (files.size() != (address.empty() ? 0u : 1u)) throw std::runtime_error("moodle: a picture has no file");
    if (!address.empty()) {
      if (address != begin + files[0]->at("name") || files[0]->at("encoding") != "base64")
        throw std::runtime_error("moodle: " + address + " is no file of the question");
      read.png = from_base64(files[0]->text);
    }
    read.words = words_without_picture(html.words(), !address.empty());
    read.solution = words_of_html(text(q.one("generalfeedback")));
    for (const Xml* a : q.all("answer")) {
      ReadAnswer answer = {text(*a), a->at("fraction") == "100", words_of_html(text(a->one("feedback")))};
      if (!answer.right && a->at("fraction") != "0") throw std::runtime_error("moodle: a fraction of its own");
      if (type == "multichoice") answer.text = words_of_html(answer.text);
      if (type == "numerical")
        answer.value = std::stod(answer.text), answer.tolerance = std::stod(a->one("tolerance").text);
      read.answers.push_back(answer);
    }
    if (type == "multichoice" && (q.one("single").text != "true" || q.one("shuffleanswers").text != "false"))
      throw std::runtime_error("moodle: choices are no single choice in a fixed order");
    all.push_back(read);
  }
  return all;
}

}  // namespace isect::test
