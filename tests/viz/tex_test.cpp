#include "viz/text/tex.h"

#include "tests/catch.h"

namespace tex_test {
using isect::viz::tex;
using isect::viz::tex_plain;
using isect::viz::tex_said;

TEST_CASE("marked letters, signs and scripts become mathematics, words stay words", "[tex]") {
  CHECK(tex("hit at *t* = 3.4") == "hit at $t = 3.4$");
  CHECK(tex("*t*_{1,2} = *s* ∓ *q*") == "$t_{1,2} = s \\mp  q$");
  CHECK(tex("the point **o**, then *d*.") == "the point $\\mathbf{o}$, then $d$.");
  CHECK(tex("*t*_{max} and *d*_*i*^2") == "$t_{\\mathrm{max}}$ and $d_{i}^{2}$");
  CHECK(tex("3 of 4 sides") == "3 of 4 sides");
}

TEST_CASE("minus, root, small digits and bars print as themselves", "[tex]") {
  CHECK(tex("*q* = √(*r*^2 − *m*^2)") == "$q = \\sqrt{r^{2} - m^{2}}$");
  CHECK(tex("√2 · 10⁻¹⁷") == "$\\sqrt{2} \\cdot  10^{-17}$");
  CHECK(tex("√*x*_1 + √") == "$\\sqrt{x_{1}} + \\surd $");
  CHECK(tex("|*x* − *c*| ≤ 2") == "$|x - c| \\le  2$");
  CHECK(tex("t₁ < t₂") == "t$_{1} <{}$t$_{2}$");
}

TEST_CASE("a sign between words and numbers keeps its space, one before a number stands close to it", "[tex]") {
  CHECK(tex("count + 1") == "count${}+ 1$");
  CHECK(tex("from −1 on") == "from $-1$ on");
  CHECK(tex("edge → *p*") == "edge${}\\to  p$");
}

TEST_CASE("what TeX would misread is escaped", "[tex]") {
  CHECK(tex("50 % of d\\_max & #1 ~ $ \\$") == "50 \\% of d\\_max \\& \\#1 \\~{} \\$ \\$");
  CHECK(tex("a\\b") == "a\\textbackslash{}b");
  CHECK(tex("“near tangent”") == "``near tangent''");
  CHECK(tex("{a}") == "$\\{$a$\\}$");
  CHECK(tex("") == "");
}

TEST_CASE("two scripts of one kind in a row are one: TeX refuses a second", "[tex]") {
  CHECK(tex("*a*^2²") == "$a^{22}$");
  CHECK(tex("*a*_{1*i*}") == "$a_{1i}$");
}

TEST_CASE("a line of pseudocode keeps its indent, and no character of it is a mark", "[tex]") {
  CHECK(tex_plain("  t_min ← −(n · o)") == "~~t\\_min${}\\leftarrow  -($n${}\\cdot {}$o)");
}

TEST_CASE("an alternative text stays words, and TeX reads none of it as its own", "[tex]") {
  CHECK(tex_said("t₁ < −2, 50 % of {a_b} & #1^2 ~ $\\") ==
        "t₁ < −2, 50 \\% of \\{a\\_b\\} \\& \\#1\\^{}2 \\~{} \\$\\textbackslash{}");
}

}  // namespace tex_test
