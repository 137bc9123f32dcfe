#include "viz/text/rich_text.h"

#include "tests/catch.h"

namespace rich_text_test {
using namespace isect::viz;

namespace {

/// Runs in a notation of their own: i(...) italic, b(...) bold, text outside; _ and ^ before scripts.
std::string shape(const std::string& markup) {
  std::string out;
  for (const Run& run : parse_markup(markup)) {
    if (run.script == Run::Script::sub) out += "_";
    if (run.script == Run::Script::super) out += "^";
    out += std::string(run.bold ? "b" : "") + (run.italic ? "i" : "") + "(" + run.text + ")";
  }
  return out;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

}  // namespace

TEST_CASE("scalars slant, vectors are bold and upright", "[rich_text]") {
  CHECK(shape("*t*") == "i(t)");
  CHECK(shape("**o**") == "b(o)");
  CHECK(shape("**o** + *t* **d**") == "b(o)( + )i(t)( )b(d)");
  CHECK(shape("***x***") == "bi(x)");
  CHECK(shape("*s = **l**·**d***") == "i(s )(=)i( )b(l)(·)b(d)");
  CHECK(shape("**a *b***") == "b(a )bi(b)");
}

TEST_CASE("a line ends between words, never within a mark or before a relation", "[rich_text]") {
  using Parts = std::vector<std::string>;
  CHECK(unbreakable("").empty());
  CHECK(unbreakable("two balls meet") == Parts{"two", "balls", "meet"});
  CHECK(unbreakable("if *d*^2 ≤ (*r*_a − *r*_b)^2.") == Parts{"if", "*d*^2 ≤", "(*r*_a", "−", "*r*_b)^2."});
  CHECK(unbreakable("is *s = **l**·**d*** here") == Parts{"is", "*s = **l**·**d***", "here"});
}

TEST_CASE("only letters slant: digits, signs and brackets of italic text stay upright", "[rich_text]") {
  CHECK(shape("*2t*") == "(2)i(t)");
  CHECK(shape("*(a−b)*") == "(()i(a)(−)i(b)())");
  CHECK(shape("*α*") == "i(α)");
  CHECK(shape("*×*") == "(×)");
}

TEST_CASE("a script is one character, a group or marked text", "[rich_text]") {
  CHECK(shape("*t*_1") == "i(t)_(1)");
  CHECK(shape("*t*_{1,2}") == "i(t)_(1,2)");
  CHECK(shape("*t*_12") == "i(t)_(1)(2)");
  CHECK(shape("*m*^2") == "i(m)^(2)");
  CHECK(shape("*n*_*i*") == "i(n)_i(i)");
  CHECK(shape("*n*_{*i*+1}") == "i(n)_i(i)_(+1)");
  CHECK(shape("*n_i*") == "i(n)_i(i)");
  CHECK(shape("*t_{1,2}*") == "i(t)_(1,2)");
  CHECK(shape("2^−") == "(2)^(−)");
  CHECK(shape("*x*_1^2") == "i(x)_(1)^(2)");
}

TEST_CASE("a backslash gives the marks themselves", "[rich_text]") {
  CHECK(shape(R"(\*t\* a\_1 b\^2 c\\d)") == R"((*t* a_1 b^2 c\d))");
  CHECK(shape(R"(*a\*b*)") == "i(a)(*)i(b)");
  CHECK(shape(R"(x_\*)") == "(x)_(*)");
  CHECK(shape(R"(\n)") == R"((\n))");
}

TEST_CASE("an unclosed mark is ordinary text", "[rich_text]") {
  for (const std::string text :
       {"*", "**", "***", "****", "a*", "*a", "**a", "2 * 3", "2 * 3 * 4", "a_", "a^", "a_{1", "a _ b", "\\", "a\\"}) {
    INFO(text);
    std::string joined;
    for (const Run& run : parse_markup(text)) {
      joined += run.text;
      CHECK_FALSE((run.italic || run.bold || run.script != Run::Script::base));
    }
    CHECK(joined == text);
  }
  CHECK(shape("**a*b") == "(*)i(a)(b)");
  CHECK(parse_markup("").empty());
  CHECK(shape("a_{}b") == "(ab)");
}

TEST_CASE("characters of several bytes stay whole, broken ones do no harm", "[rich_text]") {
  CHECK(shape("a_∞b") == "(a)_(∞)(b)");
  CHECK(shape("*q* = √2") == "i(q)( = √2)");
  CHECK_NOTHROW(plain("\xff_\xe2\x88*\x80*"));
  CHECK_NOTHROW(pango("\xff_\xe2\x88*\x80*"));
}

TEST_CASE("hyphens before numbers become minus signs, and no others do", "[rich_text]") {
  CHECK(with_minus_signs("-2, (-1.25, -3) and 1e-09") == "−2, (−1.25, −3) and 1e−09");
  CHECK(with_minus_signs("k-dop 6-DOP, side-2, - x, e-mail, axe-1") == "k-dop 6-DOP, side-2, - x, e-mail, axe-1");
  CHECK(with_minus_signs("").empty());
}

TEST_CASE("plain text keeps digits and signs of scripts small where Unicode can", "[rich_text]") {
  CHECK(plain("*t*_1 < *t*_2") == "t₁ < t₂");
  CHECK(plain("*t*_{1,2}") == "t₁,₂");
  CHECK(plain("*m*^2 = *r*^2") == "m² = r²");
  CHECK(plain("2^{−10}") == "2⁻¹⁰");
  CHECK(plain("**n**_*i*") == "n_i");
  CHECK(plain("*a*_{min}") == "a_min");
  CHECK(plain("2^{*n*+1}") == "2^(n+1)");
  CHECK(plain("*n*^*k*") == "n^k");
  CHECK(plain(R"(\*.cpp)") == "*.cpp");
}

TEST_CASE("Pango markup is escaped and sets scripts at their size and height", "[rich_text]") {
  CHECK(pango("a < b & c > d") == "a &lt; b &amp; c &gt; d");
  CHECK(pango("*t*") == "<span style=\"italic\">t</span>");
  CHECK(pango("**o**") == "<span weight=\"bold\">o</span>");
  // -0.16 and +0.34 of an em of 100 units, in 1024ths.
  CHECK(pango("_1", {}, 1, 100) == "<span size=\"70%\" rise=\"-16384\">1</span>");
  CHECK(pango("^2", {}, 1, 100) == "<span size=\"70%\" rise=\"34816\">2</span>");
}

TEST_CASE("mathematics in a paragraph has its own font and size", "[rich_text]") {
  const std::string line = pango("the *t*_1 of 2", "STIX & co", 1.2, 15);
  CHECK(line.starts_with("the <span font_family=\"STIX &amp; co\" style=\"italic\" size=\"120%\">t</span>"));
  CHECK(contains(line, "size=\"84%\" rise=\"-2949\">1</span> of 2"));
}

TEST_CASE("plain text becomes markup that shows it as it is", "[rich_text]") {
  for (const char* text : {"overlapping_pairs ^ *", R"(a\b_1 **x**)", "|x - c|^2 <= r^2", ""})
    CHECK(plain(as_markup(text)) == text);
  CHECK(unindented("    return MISS") == "return MISS");
  CHECK(unindented("   ").empty());
}

}  // namespace rich_text_test
