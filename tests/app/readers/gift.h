#pragma once
// GIFT as Moodle reads it: escapes first, then the parts.

#include "tests/app/readers/quiz.h"

namespace isect::test {

/// Text of a GIFT file in which each escaped character is one that nothing else stands for.
class GiftText {
 public:
  explicit GiftText(std::string text) : text_(std::move(text)) {}
  /// The first place, from `from` on, where this stands and is not escaped.
  std::size_t find(const std::string& part, std::size_t from = 0) const {
    for (std::size_t i = from; i < text_.size(); i += text_[i] == '\\' ? 2 : 1)
      if (text_.compare(i, part.size(), part) == 0) return i;
    return text_.npos;
  }
  GiftText part(std::size_t from, std::size_t to = std::string::npos) const {
    return GiftText(text_.substr(from, to == std::string::npos ? to : to - from));
  }
  /// The parts that begin with one of these characters.
  std::vector<GiftText> parts(const std::string& beginnings) const {
    std::vector<std::size_t> starts;
    for (std::size_t i = 0; i < text_.size(); i += text_[i] == '\\' ? 2 : 1)
      if (beginnings.find(text_[i]) != beginnings.npos) starts.push_back(i);
    std::vector<GiftText> all;
    for (std::size_t i = 0; i < starts.size(); ++i)
      all.push_back(part(starts[i], i + 1 < starts.size() ? starts[i + 1] : text_.size()));
    return all;
  }
  /// What it says, without space around it.
  std::string plain() const {
    std::string out;
    for (std::size_t i = 0; i < text_.size(); ++i) {
      if (text_[i] == '\\' && i + 1 < text_.size() && std::string("~=#{}:\\").find(text_[i + 1]) != std::string::npos)
        ++i;
      out += text_[i];
    }
    const std::size_t begin = out.find_first_not_of(" \n"), end = out.find_last_not_of(" \n");
    return begin == out.npos ? "" : out.substr(begin, end + 1 - begin);
  }
  /// What it says as HTML, which it must say that it is.
  std::string html() const {
    const std::string said = plain(), mark = "[html]";
    if (!said.starts_with(mark)) throw std::runtime_error("gift: no HTML: " + said.substr(0, 80));
    return said.substr(mark.size());
  }

 private:
  std::string text_;
};

inline ReadAnswer read_gift_answer(GiftText text, bool html) {
  ReadAnswer answer;
  const std::size_t reply = text.find("#");
  if (reply != std::string::npos) {
    answer.reply = words_of_html(text.part(reply + 1).html());
    text = text.part(0, reply);
  }
  answer.right = text.find("=") == 0;
  std::string said = text.part(1).plain();
  if (!html && said.starts_with("%")) {
    const std::size_t end = said.find('%', 1);
    answer.right = said.substr(1, end - 1) == "100";
    said = said.substr(end + 1);
  }
  answer.text = html ? words_of_html(text.part(1).html()) : said;
  return answer;
}

inline ReadQuestion read_gift_question(const std::string& id, const GiftText& text) {
  ReadQuestion read;
  read.id = id;
  const std::size_t name = text.find("::"), name_end = text.find("::", 2), begin = text.find("{"), end = text.find("}");
  if (name != 0 || name_end == std::string::npos || begin == std::string::npos || end == std::string::npos ||
      text.find("{", begin + 1) != std::string::npos || !text.part(end + 1).plain().empty())
    throw std::runtime_error("gift: a question has other parts");
  read.title = text.part(2, name_end).plain();
  const Xml html = parsed_html(text.part(name_end + 2, begin).html());
  const std::string address = take_picture(read, html), data = "data:image/png;base64,";
  if (!address.empty() && !address.starts_with(data)) throw std::runtime_error("gift: a picture is no data");
  if (!address.empty()) read.png = from_base64(address.substr(data.size()));
  read.words = words_without_picture(html.words(), !address.empty());
  GiftText answers = text.part(begin + 1, end);
  const std::size_t solution = answers.find("####");
  if (solution == std::string::npos) throw std::runtime_error("gift: there is no solution");
  read.solution = words_of_html(answers.part(solution + 4).html());
  answers = answers.part(0, solution);
  const bool number = answers.find("#") == 0, choice = answers.find("~") != std::string::npos;
  read.kind = number ? "number" : choice ? "choice" : "letters";
  for (const GiftText& part : answers.part(number ? 1 : 0).parts(choice ? "=~" : "=")) {
    ReadAnswer answer = read_gift_answer(part, choice);
    if (number) {
      const std::size_t colon = answer.text.find(':');
      answer.value = std::stod(answer.text.substr(0, colon));
      answer.tolerance = std::stod(answer.text.substr(colon + 1));
    }
    read.answers.push_back(answer);
  }
  return read;
}

/// Reads a file of GIFT; the name of the category goes to `category`.
inline std::vector<ReadQuestion> read_gift(const std::string& file, std::string& category) {
  std::vector<ReadQuestion> all;
  const std::string of_category = "$CATEGORY: ", of_id = "// [id:";
  std::string block, id;
  for (std::size_t from = 0; from < file.size();) {
    const std::size_t end = std::min(file.find('\n', from), file.size());
    const std::string line = file.substr(from, end - from);
    from = end + 1;
    if (line.starts_with(of_id)) id = line.substr(of_id.size(), line.find(']') - of_id.size());
    if (!line.empty() && !line.starts_with("//")) block += line + "\n";
    if (!line.empty() && from < file.size()) continue;
    if (block.starts_with(of_category))
      category = block.substr(of_category.size(), block.size() - of_category.size() - 1);
    else if (!block.empty())
      all.push_back(read_gift_question(id, GiftText(block)));
    block.clear();
  }
  return all;
}

}  // namespace isect::test
