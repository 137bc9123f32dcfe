// Languages: files of translations, plural forms, places to fill in; and the translations that isect is built with.

#include <algorithm>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/catch.h"
#include "viz/lang/catalogue.h"
#include "viz/lang/language.h"
#include "viz/lang/message.h"
#include "viz/lang/numbered.h"
#include "viz/lang/po.h"
#include "viz/lesson.h"

namespace lang_test {

using namespace isect::viz;
using isect::test::Contains;

namespace {

const std::string head =
    "msgid \"\"\nmsgstr \"\"\n\"Language: de\\n\"\n\"Content-Type: text/plain; charset=UTF-8\\n\"\n"
    "\"Plural-Forms: nplurals=2; plural=(n != 1);\\n\"\n";

std::string refused(const std::string& text) {
  try {
    read_po(text);
  } catch (const BadInput& e) {
    return e.what();
  }
  return "";
}

/// The places to fill in, "{a}" and "{1}", but no markup such as "_{in}".
std::set<std::string> places(const std::string& text) {
  static const std::regex place("\\{([a-z]+|[0-9]+)\\}");
  std::set<std::string> all;
  for (std::sregex_iterator i(text.begin(), text.end(), place), end; i != end; ++i) {
    const auto at = static_cast<std::size_t>(i->position());
    if (at == 0 || (text[at - 1] != '_' && text[at - 1] != '^')) all.insert(i->str());
  }
  return all;
}

}  // namespace

TEST_CASE("a file of translations is read with its contexts, plurals and escapes", "[lang]") {
  const PoFile file = read_po(head +
                              "\n#: app/x.cpp\nmsgctxt \"in a list\"\nmsgid \"ball\"\nmsgstr \"Kugel\"\n"
                              "\n#, fuzzy\nmsgid \"{n} ray\"\nmsgid_plural \"{n} rays\"\nmsgstr[0] \"{n} Strahl\"\n"
                              "msgstr[1] \"\"\n\"{n} Strah\"\n\"len\"\n\nmsgid \"a\\\"b\\n\\\\c\"\nmsgstr \"\"\n");
  CHECK(file.language == "de");
  REQUIRE(file.entries.size() == 3);
  CHECK(file.entries[0].context == "in a list");
  CHECK(file.entries[0].texts == std::vector<std::string>{"Kugel"});
  CHECK(file.entries[0].is_translated());
  CHECK(file.entries[1].texts == std::vector<std::string>{"{n} Strahl", "{n} Strahlen"});
  CHECK_FALSE(file.entries[1].is_translated());  // fuzzy
  CHECK(file.entries[2].english == "a\"b\n\\c");
  CHECK_FALSE(file.entries[2].is_translated());  // empty
  const PoFile again = read_po(po_text(file));
  REQUIRE(again.entries.size() == 3);
  CHECK(again.entries[1].texts == file.entries[1].texts);
  CHECK(again.entries[1].fuzzy);
  CHECK(again.entries[2].english == file.entries[2].english);
}

TEST_CASE("a broken file of translations is refused with its line", "[lang]") {
  CHECK_THAT(refused("msgid \"a\"\nmsgstr \"b\"\n"), Contains("it has no head"));
  CHECK_THAT(refused(""), Contains("it has no head"));
  CHECK_THAT(refused(head + "\nmsgid \"a\"\n"), Contains("no msgstr"));
  CHECK_THAT(refused(head + "\nmsgid \"a\nmsgstr \"b\"\n"), Contains("line 7: the closing quote is missing"));
  CHECK_THAT(refused(head + "\nmsgid \"a\\q\"\nmsgstr \"b\"\n"), Contains("after \\ one of n, t"));
  CHECK_THAT(refused(head + "\nmsgid \"a\" b\nmsgstr \"b\"\n"), Contains("behind the closing quote"));
  CHECK_THAT(refused(head + "\nmsg \"a\"\n"), Contains("\"msg\" is unknown here"));
  CHECK_THAT(refused(head + "\n\"a\"\n"), Contains("without its keyword"));
  CHECK_THAT(refused(head + "\nmsgid \"a\"\nmsgid_plural \"b\"\nmsgstr[0] \"c\"\n"),
             Contains("1 msgstr") && Contains("2 plural"));
  CHECK_THAT(refused(head + "\nmsgid \"a\"\nmsgstr \"b\"\n\nmsgid \"a\"\nmsgstr \"c\"\n"),
             Contains("stands here twice"));
  CHECK_THAT(refused("msgid \"\"\nmsgstr \"Plural-Forms: nplurals=3; plural=n%3;\\n\"\n"), Contains("are not known"));
  CHECK_THAT(refused("msgid \"\"\nmsgstr \"Content-Type: text/plain; charset=latin1\\n\"\n"), Contains("UTF-8"));
}

TEST_CASE("each language counts in its own way", "[lang]") {
  CHECK(plural_form(Plural::one_is_singular, 0) == 1);
  CHECK(plural_form(Plural::one_is_singular, 1) == 0);
  CHECK(plural_form(Plural::below_two_is_singular, 0) == 0);
  CHECK(plural_form(Plural::below_two_is_singular, 1) == 0);
  CHECK(plural_form(Plural::below_two_is_singular, 2) == 1);
  CHECK(plural_form(Plural::one_form, 7) == 0);
}

TEST_CASE("places are filled in, and markup stays", "[lang]") {
  CHECK(filled_in("{a} and {b}", {{"a", "{b}"}, {"b", "B"}}) == "{b} and B");  // once only
  CHECK(filled_in("*t*_{a} of {a}, x^{a}, {c} {", {{"a", "A"}}) == "*t*_{a} of A, x^{a}, {c} {");
  CHECK(tr_count(1, "{n} ray of {a}", "{n} rays of {a}", {{"a", "A"}}) == "1 ray of A");
  CHECK(tr_count(0, "{n} ray", "{n} rays") == "0 rays");
}

TEST_CASE("numbers are taken out of a text and put into another", "[lang]") {
  const Numbered text =
      numbered("*d*^2 of " + shown(-1.5) + " and " + shown(2e-9) + ", 3D, *r*_1, ∞ or " + shown(26654) + ".");
  CHECK(text.key == "*d*^2 of {1} and {2}, 3D, *r*_1, {3} or {4}.");
  CHECK(text.numbers == std::vector<std::string>{shown(-1.5), shown(2e-9), "∞", shown(26654)});
  CHECK(with_numbers("{4} vor {1}, 10^{38}", text.numbers) == shown(26654) + " vor " + shown(-1.5) + ", 10^{38}");
  CHECK_THROWS_AS(with_numbers("{5}", text.numbers), std::logic_error);
  CHECK_THROWS_AS(with_numbers("{a}", text.numbers), std::logic_error);
}

TEST_CASE("a language is spoken until the end of its block, and what it lacks is English", "[lang]") {
  CHECK(spoken() == "en");
  CHECK(tr("{both} touch", {{"both", "A and B"}}) == "A and B touch");
  {
    const Speaking german("de");
    CHECK(spoken() == "de");
    CHECK(tr("{both} touch", {{"both", "A und B"}}) == "A und B berühren sich");
    CHECK(tr_as("no test is made for", "a ray") == "einen Strahl");
    CHECK(tr_as("in a list", "ray") == "Strahl");
    CHECK(tr_count(1, "{n} ray", "{n} rays") == "1 Strahl");
    CHECK(tr_count(3, "{n} ray", "{n} rays") == "3 Strahlen");
    CHECK(tr("nobody says {a}", {{"a", "this"}}) == "nobody says this");
    {
      const Speaking english("");
      CHECK(tr("{both} touch", {{"both", "A and B"}}) == "A and B touch");
    }
    CHECK(spoken() == "de");
  }
  CHECK(spoken() == "en");
  CHECK_THROWS_WITH(Speaking("dee"), Contains("lang: \"dee\"") && Contains("de") && Contains("zh"));
}

TEST_CASE("every language has every text of the program, with the same places", "[lang]") {
  std::size_t files = 0;
  for (const PoText& source : po_texts()) {
    INFO(source.subject << "/" << source.language);
    const PoFile file = read_po(source.text);
    const bool is_template = *source.language == '\0';
    CHECK(file.language == source.language);
    for (const PoEntry& entry : file.entries) {
      INFO(entry.english);
      if (is_template) continue;
      CHECK(entry.is_translated());
      for (const std::string& text : entry.texts) {
        // a form for one number need not tell it
        const std::set<std::string> here = places(text),
                                    wanted = places(entry.other.empty() ? entry.english : entry.other);
        CHECK(std::ranges::includes(wanted, here));
        if (&text == &entry.texts.back()) CHECK(here == wanted);
      }
    }
    files += *source.subject == '\0' && !is_template;
  }
  CHECK(files + 1 == languages().size());  // English needs none
  for (const Language& language : languages()) {
    INFO(language.code);
    const Coverage told = coverage(language.code);
    CHECK(told.all > 400);
    CHECK(told.translated == told.all);
  }
}

}  // namespace lang_test
