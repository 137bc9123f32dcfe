// The course speaks as textbooks do: words and sentences that a close reading replaced stay away.

#include <regex>

#include "lessons/glossary.h"
#include "tests/lessons/asked_for.h"
#include "tests/lessons/texts.h"
#include "viz/text/rich_text.h"

namespace terms_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;

namespace {

/// A word that should not be used, and the term to use instead.
struct Replaced {
  std::regex word;
  const char* term;
};

const std::vector<Replaced>& replaced() {
  static const std::vector<Replaced> all = [] {
    const std::pair<const char*, const char*> words[] = {
        {"inner points?\\b", "interior"},
        {"\\bfactors? of t\\b", "coefficient"},
        {"\\bupright\\b", "vertical"},
        {"(^|[^s] )[Pp]roducts of edges", "cross products"},
        {"\\bgrown\\b|\\bgrow the (wall|box)", "expanded; Minkowski sum"},
        {"\\bsight lines?\\b", "primary or pick ray"},
        {"\\blamps?\\b", "light source"},
        {"all that the box sweeps", "swept volume"},
        {"\\bin vain\\b|\\bIn vain\\b", "false positive"},
        {"\\babscissas?\\b|\\babscissae\\b", "x-coordinate"},
        {"\\b[Aa] (8|11|18)-", "an 8-DOP, an 18-DOP"},
        {"\\bN(0[1-9]|1[0-9]|2[0-5])\\b", "the slide's title"},
        {"\\b[Ee]ach with each\\b", "testing every pair"},
        {"\\bno wrongly\\b", "no false negatives"},
        {"\\bWho (asks|needs)\\b", "the caller; if you need"},
        {"\\bthe range will say\\b", "the range decides"},
        {"\\bOurs tells\\b", "the exact test reports"},
        {"\\bhang together\\b", "bridges join the pieces"},
        {"\\bruns beside\\b", "is parallel to"},
        {"\\bsteeply\\b", "cosine of the angle of incidence"},
        {"\\bsliver\\b", "very thin polygon"},
        {"(?!.*\\bsign\\b)\\bexactly if\\b", "if and only if"}};
    std::vector<Replaced> made;
    for (const auto& [word, term] : words) made.push_back({std::regex(word), term});
    return made;
  }();
  return all;
}

void check(const std::string& where, const std::string& markup) {
  const std::string text = plain(markup);
  for (const Replaced& r : replaced())
    if (std::regex_search(text, r.word)) FAIL_CHECK(where << ": not so, but " << r.term << ":\n  " << text);
}

}  // namespace

TEST_CASE("lessons and glossary use the terms of textbooks", "[every lesson]") {
  for (const Lesson* lesson : those_asked_for())
    for (const std::string& text : texts(*lesson)) check(lesson->id, text);
  for (const lessons::Term& term : lessons::glossary()) check("glossary", term.name + ": " + term.meaning);
}

TEST_CASE("the lecture note is introduced by its title where a lesson first speaks of it", "[every lesson]") {
  for (const Lesson* lesson : those_asked_for())
    for (const Preset& p : lesson->presets) {
      bool introduced = false;
      for (const Step& s : lesson->walk(p.parameters).steps) {
        const std::string text = plain(s.caption);
        const std::size_t title = text.find("lecture note Intersection Detection"), short_name = text.find("he note");
        INFO(lesson->id << " " << p.id << ", " << s.slug << ": " << text);
        CHECK((introduced || short_name == text.npos || title < short_name));
        introduced = introduced || title != text.npos;
      }
    }
}

}  // namespace terms_test
