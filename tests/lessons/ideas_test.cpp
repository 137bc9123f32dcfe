// Lessons that share an idea name each other: what they say they share, they speak of.

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "lessons/course.h"
#include "lessons/glossary.h"
#include "tests/catch.h"
#include "tests/lessons/asked_for.h"
#include "tests/lessons/texts.h"
#include "viz/text/rich_text.h"
#include "viz/walk/closing.h"

namespace ideas_test {
using namespace isect;
using namespace isect::viz;

namespace {

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// The plural of a term: "separating axes" of "separating axis"; any other term takes an s.
std::string several(const std::string& term) {
  return term.ends_with("axis") ? term.substr(0, term.size() - 2) + "es" : term + "s";
}

bool speaks_of(const Lesson& lesson, const std::string& idea) {
  return std::ranges::any_of(tests::texts(lesson), [&](const std::string& text) {
    const std::string said = lower(plain(text));
    return said.find(lower(idea)) != said.npos || said.find(lower(several(idea))) != said.npos;
  });
}

}  // namespace

TEST_CASE("an idea that a lesson shares is a term of the glossary, and the lesson speaks of it", "[every lesson]") {
  std::set<std::string> terms;
  for (const lessons::Term& term : lessons::glossary()) terms.insert(term.name);
  for (const Lesson* lesson : those_asked_for()) {
    INFO(lesson->id);
    CHECK_FALSE(lesson->ideas.empty());
    for (const std::string& idea : lesson->ideas) {
      INFO(idea);
      CHECK(terms.contains(idea));
      CHECK(speaks_of(*lesson, idea));
    }
  }
}

TEST_CASE("an idea stands in more than one lesson, and in that which explains it", "[every lesson]") {
  std::map<std::string, std::set<std::string>> where;
  for (const Lesson* lesson : lessons::all_lessons())
    for (const std::string& idea : lesson->ideas) where[idea].insert(lesson->id);
  for (const auto& [idea, ids] : where) {
    INFO(idea);
    CHECK(ids.size() > 1);
    for (const lessons::Term& term : lessons::glossary())
      if (term.name == idea) CHECK(ids.contains(term.lesson));
  }
}

TEST_CASE("lessons that share an idea name each other on their cards", "[every lesson]") {
  for (const Lesson* lesson : lessons::all_lessons()) {
    const std::vector<Card::Row> rows = card_rows(*lesson);
    INFO(lesson->id);
    REQUIRE(rows.back().head == tr(shared_head));
    for (const Lesson* other : lessons::all_lessons()) {
      const bool shared = other != lesson && std::ranges::any_of(lesson->ideas, [&](const std::string& idea) {
                            return std::ranges::count(other->ideas, idea) > 0;
                          });
      INFO(other->id << ": " << rows.back().text);
      // A title may begin as another does.
      const std::string title = ' ' + short_title(*other);
      CHECK((rows.back().text.find(title + ',') != std::string::npos ||
             rows.back().text.find(title + '.') != std::string::npos) == shared);
    }
    for (const SharedIdea& shared : shared_ideas(*lesson))
      CHECK(std::ranges::find(shared.others, lesson) == shared.others.end());
  }
}

}  // namespace ideas_test
