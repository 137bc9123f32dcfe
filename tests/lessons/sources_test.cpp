// What lessons cite is listed, spelt in one way; and no text shows a mark that our markup does not know.

#include <fmt/format.h>

#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "lessons/glossary.h"
#include "tests/catch.h"
#include "tests/lessons/asked_for.h"
#include "tests/lessons/texts.h"
#include "viz/text/rich_text.h"
#include "viz/walk/closing.h"

namespace sources_test {
using namespace isect;
using namespace isect::viz;
using isect::tests::texts;

namespace {

struct Cited {
  std::string author, year;  ///< the first author's family name
};

/// "Haines in Glassner (ed.), An Introduction to Ray Tracing (1989), ch. 2" cites Haines, 1989. A part of our own has
/// no year, or is the note's or a measurement.
std::vector<Cited> cited(const std::string& source) {
  std::vector<Cited> all;
  std::istringstream parts(source);
  for (std::string part; std::getline(parts, part, ';');) {
    static const std::regex year("(1[89][0-9]{2}|20[0-9]{2})");
    static const std::regex author("^ *([A-Z][^ ,]+)");
    std::smatch y, a;
    if (part.find("Lecture note") != part.npos || part.find("measured") != part.npos) continue;
    if (!std::regex_search(part, y, year) || !std::regex_search(part, a, author)) continue;
    all.push_back({a[1], y[1]});
  }
  return all;
}

/// A method named after whom it is by: "the same, small = 10⁻⁸ (Sunday)".
std::vector<std::string> named_after(const std::string& method) {
  static const std::regex name("\\(([A-Z][a-z]+)\\)");
  std::vector<std::string> all;
  for (std::sregex_iterator at(method.begin(), method.end(), name), end; at != end; ++at) all.push_back((*at)[1]);
  return all;
}

bool is_listed(const Lesson& lesson, const std::string& author, const std::string& year) {
  return std::ranges::any_of(lesson.closing->reading, [&](const std::string& entry) {
    return plain(entry).find(author) != std::string::npos && entry.find(year) != std::string::npos;
  });
}

/// Authors, title, edition, year: what stands before the section.
std::string work(const std::string& entry) {
  static const std::regex section(", (sections?|chapters?|pages?) .*$");
  std::string text = std::regex_replace(plain(entry), section, "");
  while (text.ends_with('.')) text.pop_back();
  return text;
}

}  // namespace

TEST_CASE("a source that a lesson cites is in its list of readings", "[every lesson]") {
  CHECK(cited("Lecture note, x; Goldsmith and Salmon, IEEE CG&A 7 (1987); Wald (2007)").size() == 2);
  CHECK(cited("Haines in Glassner (ed.), An Introduction to Ray Tracing (1989), ch. 2")[0].author == "Haines");
  int seen = 0;
  for (const Lesson* lesson : those_asked_for())
    for (const Preset& p : lesson->presets) {
      for (const Step& s : lesson->walk(p.parameters).steps) {
        if (s.slug == closing_slug) continue;  // its source is a reading
        for (const Cited& c : cited(s.source)) {
          INFO(lesson->id << ", " << s.slug << ": " << s.source);
          CHECK(is_listed(*lesson, c.author, c.year));
          ++seen;
        }
      }
      if (!lesson->opinions) continue;
      for (const Opinion& o : lesson->opinions(p.parameters))
        for (const std::string& name : named_after(o.method)) {
          INFO(lesson->id << ", " << o.method);
          CHECK(is_listed(*lesson, name, ""));
        }
    }
  if (those_asked_for().size() == lessons::all_lessons().size()) CHECK(seen > 100);
}

TEST_CASE("a reading is spelt in one way, in whatever lesson it stands", "[every lesson]") {
  std::map<std::string, std::set<std::string>> spelt;  // by what stands before the first comma, and year
  for (const Lesson* lesson : those_asked_for())
    for (const std::string& entry : lesson->closing->reading) {
      static const std::regex year("(1[89][0-9]{2}|20[0-9]{2})");
      std::smatch y;
      const std::string text = work(entry), author = text.substr(0, text.find(','));
      if (!std::regex_search(text, y, year)) continue;  // the lecture note
      spelt[author + ' ' + y.str()].insert(text);
    }
  for (const auto& [key, ways] : spelt) {
    INFO(key);
    CAPTURE(ways);
    CHECK(ways.size() == 1);
  }
}

TEST_CASE("a card's rows and a glossary's meanings are single paragraphs", "[every lesson]") {
  for (const Lesson* lesson : those_asked_for())
    for (const Card::Row& row : card_rows(*lesson)) {
      INFO(lesson->id << ": " << row.text);
      CHECK(row.text.find('\n') == std::string::npos);
    }
  for (const lessons::Term& term : lessons::glossary()) CHECK(term.meaning.find('\n') == std::string::npos);
}

TEST_CASE("no text shows a backtick, or a mark that is left over", "[every lesson]") {
  for (const Lesson* lesson : those_asked_for())
    for (const std::string& text : texts(*lesson)) {
      INFO(lesson->id << ": " << text);
      CHECK(text.find('`') == std::string::npos);
      CHECK(plain(text).find("**") == std::string::npos);
    }
  for (const lessons::Term& term : lessons::glossary()) CHECK(term.meaning.find('`') == std::string::npos);
}

}  // namespace sources_test
