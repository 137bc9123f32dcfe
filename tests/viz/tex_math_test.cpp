#include "viz/text/tex_math.h"

#include "tests/catch.h"
#include "viz/text/tex.h"

namespace tex_math_test {
using namespace isect::viz;

namespace {

/// Returns what readers see without LaTeX: as plain text, and as runs with i(...) italic, b(...) bold, _ and ^ scripts.
std::string seen(const std::string& source) { return plain("$" + source + "$"); }
std::string shape(const std::string& source) {
  std::string out;
  for (const Run& run : read_tex_math(source).runs)
    out += std::string(run.script == Run::Script::sub     ? "_"
                       : run.script == Run::Script::super ? "^"
                                                          : "") +
           (run.bold ? "b" : "") + (run.italic ? "i" : "") + "(" + run.text + ")";
  return out;
}

}  // namespace

TEST_CASE("letters slant, digits stand upright, vectors are bold", "[tex_math]") {
  CHECK(shape("2r") == "(2)i(r)");
  CHECK(shape("\\mathbf{a} - b") == "b(a)( − )i(b)");
  CHECK(shape("\\lambda \\Delta") == "i(λ)(Δ)");  // a space is no mark of LaTeX's
  CHECK(shape("\\mathrm{in} A") == "(in)i(A)");
  CHECK(shape("\\text{if } x") == "(if )i(x)");
}

TEST_CASE("scripts are small, and a digit in a script is one of Unicode's", "[tex_math]") {
  CHECK(shape("x_i^2") == "i(x)_i(i)^(2)");
  CHECK(shape("x^2_i") == "i(x)_i(i)^(2)");
  CHECK(shape("t_{i_1}") == "i(t)_i(i)_(₁)");
  CHECK(seen("x^{n+1}") == "x^(n+1)");
  CHECK(seen("90^\\circ") == "90°");
  CHECK(seen("f'") == "f′");
}

TEST_CASE("operators between two sides and relations have space around, signs have none", "[tex_math]") {
  CHECK(seen("a-b\\le -1") == "a − b ≤ −1");
  CHECK(seen("f(-x,-y)") == "f(−x, −y)");
  CHECK(seen("A\\cap B\\ne\\emptyset") == "A ∩ B ≠ ∅");
  CHECK(seen("x\\in A\\cup B \\to y") == "x ∈ A ∪ B → y");
  CHECK(seen("\\sin\\alpha\\cdot\\cos(2\\beta)") == "sin α · cos(2β)");
  CHECK(seen("\\left\\lVert a \\times b\\right\\rVert") == "‖a × b‖");
}

TEST_CASE("fractions and roots stand in one line, in brackets where they would be misread", "[tex_math]") {
  CHECK(seen("\\frac{a}{b}") == "a/b");
  CHECK(seen("\\frac{a+b}{2c}") == "(a + b)/(2c)");
  CHECK(seen("\\frac12") == "1/2");
  CHECK(seen("\\sqrt{2}") == "√2");
  CHECK(seen("\\sqrt{x^2+1}") == "√(x² + 1)");
  CHECK(seen("\\sqrt[3]{x}") == "∛x");
}

TEST_CASE("a mark stands over one letter", "[tex_math]") {
  CHECK(shape("\\vec{v}") == "i(v\u20d7)");
  CHECK(shape("\\hat{\\mathbf n}") == "b(n\u0302)");
  CHECK(read_tex_math("\\vec{AB}").beyond == std::vector<std::string>{"\\vec over more than one letter"});
}

TEST_CASE("what one line can't show is named, and stands there as a word", "[tex_math]") {
  const TexMath math = read_tex_math("\\oint f + \\oint g");
  CHECK(math.beyond == std::vector<std::string>{"\\oint"});
  CHECK(math.error.empty());
  CHECK(seen("\\oint f") == "oint f");
  CHECK(read_tex_math("x_{i_j}").beyond == std::vector<std::string>{"a script in a script"});
  CHECK(read_tex_math("\\mathbb{R}^3").beyond.empty());
  CHECK(read_tex_math("\\mathbb{x}").beyond == std::vector<std::string>{"\\mathbb{x}"});
}

TEST_CASE("what LaTeX refuses is told and stays ordinary text", "[tex_math]") {
  CHECK(read_tex_math("{a").error == "a brace is not closed");
  CHECK(read_tex_math("a}").error == "a brace is closed that none opens");
  CHECK(read_tex_math("a^").error == "nothing follows ^");
  CHECK_THAT(read_tex_math("a^b^c").error, isect::test::Contains("two scripts ^"));
  CHECK_THAT(read_tex_math("50 %").error, isect::test::Contains("\\%"));
  CHECK_FALSE(read_tex_math("\\left( a").error.empty());
  CHECK_FALSE(read_tex_math(std::string(10000, '{')).error.empty());
  CHECK(seen("{a") == "${a$");
}

TEST_CASE("a lone dollar is a dollar, and so are two prices", "[tex_math]") {
  CHECK(plain("it costs $5") == "it costs $5");
  CHECK(plain("$5 and $6") == "$5 and $6");
  CHECK(plain("a \\$x\\$ b") == "a $x$ b");
  CHECK(plain("$x$ for $5") == "x for $5");
  CHECK(plain(as_markup("a $x$ b")) == "a $x$ b");
  CHECK(end_of_tex_math("$a\\$b$", 0) == 6);
}

TEST_CASE("stars in mathematics mark nothing outside, and no line ends in it", "[tex_math]") {
  CHECK(plain("2 *and $x*y$ here") == "2 *and x ∗ y here");
  CHECK(unbreakable("is $a + b$ less") == std::vector<std::string>{"is", "$a + b$", "less"});
}

TEST_CASE("LaTeX gets the source as it is", "[tex_math]") {
  CHECK(tex("with $\\frac{a}{b}$, *t* = $x^2$") == "with $\\frac{a}{b}$, $t = x^2$");
  CHECK(tex("$\\alpha$*b*") == "$\\alpha b$");
  CHECK(tex("$x_1$_2") == "$x_1{}_{2}$");
  CHECK(tex("$a ≤ b$") == "$a \\le  b$");
  CHECK(tex("$\\oint f$") == "$\\oint f$");
}

TEST_CASE("the packages are those of the commands that LaTeX alone does not know", "[tex_math]") {
  CHECK(tex_packages("\\textbf{a} \\frac{a}{b}").empty());
  CHECK(tex_packages("\\lVert a\\rVert") == "amsmath");
  CHECK(tex_packages("\\mathbb{R}") == "amssymb");
  CHECK(tex_packages("\\text{in} \\mathbb{R}") == "amsmath,amssymb");
}

}  // namespace tex_math_test
