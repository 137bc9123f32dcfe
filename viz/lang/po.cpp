#include "viz/lang/po.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include "viz/lesson.h"

namespace isect::viz {

namespace {

/// The rules that are read, without their blanks.
constexpr std::pair<std::string_view, Plural> plural_rules[] = {
    {"nplurals=1;plural=0;", Plural::one_form},
    {"nplurals=2;plural=n!=1;", Plural::one_is_singular},
    {"nplurals=2;plural=n>1;", Plural::below_two_is_singular}};

class PoReader {
 public:
  explicit PoReader(const std::string& text) : lines_(text) {}

  PoFile read() {
    for (std::string line; std::getline(lines_, line); ++line_) {
      if (line.ends_with('\r')) line.pop_back();
      take(line);
    }
    finish();
    if (!headed_) refuse("it has no head: an entry with msgid \"\" comes first");
    return std::move(file_);
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const { throw BadInput(fmt::format("line {}: {}", line_, what)); }

  void take(const std::string& line) {
    if (line.find_first_not_of(" \t") == line.npos) return finish();
    if (line.starts_with("#~")) return finish();  // an entry that is no longer in use
    if (line[0] == '#') {
      if (field_ != Field::none) finish();
      if (line.starts_with("#,") && line.find("fuzzy") != line.npos) fuzzy_ = true;
      return;
    }
    if (line[0] == '"') {
      if (field_ == Field::none) refuse("a text stands here without its keyword, such as msgid");
      *to_ += quoted(line);
      return;
    }
    const std::size_t end = std::min(line.find_first_of(" \t\""), line.size());
    begin(line.substr(0, end));
    const std::size_t text = line.find('"', end);
    if (text == line.npos) refuse("a text in quotes is expected");
    *to_ = quoted(line.substr(text));
  }

  void begin(const std::string& word) {
    if (word == "msgctxt" || (word == "msgid" && field_ != Field::context)) {
      if (field_ != Field::none) finish();
      entry_ = {}, entry_.fuzzy = std::exchange(fuzzy_, false), entry_.line = line_;
    }
    if (word == "msgctxt") return expect(Field::none, Field::context, entry_.context);
    if (word == "msgid") return expect(field_ == Field::context ? field_ : Field::none, Field::english, entry_.english);
    if (word == "msgid_plural") return expect(Field::english, Field::other, entry_.other);
    const std::string form = "msgstr[" + std::to_string(entry_.texts.size()) + "]";
    if (word != "msgstr" && word != form)
      refuse(fmt::format("\"{}\" is unknown here; msgctxt, msgid, msgid_plural, msgstr or {} may begin a line", word,
                         form));
    const bool counts = word == form;
    const Field before = !counts ? Field::english : entry_.texts.empty() ? Field::other : Field::text;
    if (field_ != before) refuse(fmt::format("\"{}\" stands at the wrong place of its entry", word));
    field_ = Field::text, to_ = &entry_.texts.emplace_back();
  }

  enum class Field { none, context, english, other, text };
  void expect(Field before, Field now, std::string& to) {
    if (field_ != before) refuse("this keyword stands at the wrong place of its entry");
    field_ = now, to_ = &to;
  }

  std::string quoted(const std::string& line) const {
    std::string text;
    std::size_t i = 1;
    for (; i < line.size() && line[i] != '"'; ++i) {
      if (line[i] != '\\') {
        text += line[i];
        continue;
      }
      const char next = ++i < line.size() ? line[i] : '\0';
      if (next != 'n' && next != 't' && next != '"' && next != '\\')
        refuse("after \\ one of n, t, \" and \\ is expected");
      text += next == 'n' ? '\n' : next == 't' ? '\t' : next;
    }
    if (i >= line.size()) refuse("the closing quote is missing");
    if (line.find_first_not_of(" \t", i + 1) != line.npos) refuse("something stands behind the closing quote");
    return text;
  }

  void finish() {
    if (field_ == Field::none) return;
    if (field_ != Field::text) refuse("the entry above has no msgstr");
    field_ = Field::none;
    if (!headed_) return read_head();
    if (entry_.english.empty()) refuse("an entry has an empty msgid");
    const std::size_t forms = entry_.other.empty() ? 1 : plural_forms(file_.plural);
    if (entry_.texts.size() != forms)
      refuse(fmt::format("the entry above has {} msgstr, and the language has {} plural forms", entry_.texts.size(),
                         forms));
    if (!keys_.insert({entry_.context, entry_.english}).second)
      refuse(fmt::format("\"{}\" stands here twice", entry_.english));
    file_.entries.push_back(std::move(entry_));
  }

  void read_head() {
    if (!entry_.english.empty()) refuse("it has no head: an entry with msgid \"\" comes first");
    headed_ = true;
    std::istringstream head(entry_.texts.front());
    for (std::string line; std::getline(head, line);) {
      const std::size_t colon = line.find(':');
      if (colon == line.npos) refuse(fmt::format("in the head, \"{}\" has no colon", line));
      const std::string name = line.substr(0, colon);
      std::string value = line.substr(std::min(line.find_first_not_of(' ', colon + 1), line.size()));
      if (name == "Language") file_.language = value;
      if (name == "Content-Type" && value.find("charset=UTF-8") == value.npos) refuse("it must be in UTF-8");
      if (name != "Plural-Forms") continue;
      std::erase_if(value, [](char c) { return c == ' ' || c == '(' || c == ')'; });
      const auto* const rule = std::ranges::find(plural_rules, value, &std::pair<std::string_view, Plural>::first);
      if (rule == std::end(plural_rules)) refuse(fmt::format("the plurals of \"{}\" are not known", line));
      file_.plural = rule->second;
    }
  }

  std::istringstream lines_;
  PoFile file_;
  PoEntry entry_;
  Field field_ = Field::none;
  std::string* to_ = nullptr;
  bool headed_ = false, fuzzy_ = false;
  std::set<std::pair<std::string, std::string>> keys_;
  int line_ = 1;
};

}  // namespace

bool PoEntry::is_translated() const {
  return !fuzzy && std::ranges::none_of(texts, [](const std::string& text) { return text.empty(); });
}

std::size_t plural_form(Plural rule, std::size_t n) {
  if (rule == Plural::one_form) return 0;
  return rule == Plural::one_is_singular ? n != 1 : n > 1;
}

std::size_t plural_forms(Plural rule) { return rule == Plural::one_form ? 1 : 2; }

PoFile read_po(const std::string& text) { return PoReader(text).read(); }

std::string po_text(const PoFile& file) {
  const auto in_quotes = [](const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
      if (c == '"' || c == '\\') out += '\\';
      out += c == '\n' ? "\\n" : c == '\t' ? "\\t" : std::string(1, c);
    }
    return out + "\"\n";
  };
  const auto* const rule = std::ranges::find(plural_rules, file.plural, &std::pair<std::string_view, Plural>::second);
  std::string out = "msgid \"\"\nmsgstr \"\"\n";
  if (!file.language.empty()) out += in_quotes("Language: " + file.language + "\n");
  out += in_quotes("Content-Type: text/plain; charset=UTF-8\n");
  out += in_quotes(fmt::format("Plural-Forms: {}\n", rule->first));
  for (const PoEntry& entry : file.entries) {
    out += entry.fuzzy ? "\n#, fuzzy\n" : "\n";
    if (!entry.context.empty()) out += "msgctxt " + in_quotes(entry.context);
    out += "msgid " + in_quotes(entry.english);
    if (!entry.other.empty()) out += "msgid_plural " + in_quotes(entry.other);
    for (std::size_t i = 0; i < entry.texts.size(); ++i)
      out += (entry.other.empty() ? "msgstr " : fmt::format("msgstr[{}] ", i)) + in_quotes(entry.texts[i]);
  }
  return out;
}

}  // namespace isect::viz
