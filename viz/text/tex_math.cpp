#include "viz/text/tex_math.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "viz/text/tex_math_atoms.h"
#include "viz/text/tex_math_signs.h"
#include "viz/text/utf8.h"

namespace isect::viz {
namespace tex_math {
namespace {

using Script = Run::Script;

/// Why LaTeX would refuse it.
struct Refused {
  std::string why;
};

bool is_latin(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_one_digit(char c) { return c >= '0' && c <= '9'; }

/// Marks that stand over one letter.
const std::map<std::string_view, const char*>& accents() {
  static const std::map<std::string_view, const char*> all = {
      {"vec", "\u20d7"},      {"hat", "\u0302"},   {"widehat", "\u0302"}, {"bar", "\u0304"},
      {"overline", "\u0304"}, {"tilde", "\u0303"}, {"dot", "\u0307"},     {"ddot", "\u0308"}};
  return all;
}
/// Spaces by their commands; those that are no letters stand behind a backslash, too.
const std::map<std::string_view, const char*>& spaces() {
  static const std::map<std::string_view, const char*> all = {{" ", " "}, {",", "\u2009"}, {":", " "},
                                                              {">", " "}, {";", " "},      {"!", ""},
                                                              {"/", ""},  {"quad", "  "},  {"qquad", "    "}};
  return all;
}
/// Commands that say how large something is, which one line does not show.
bool says_nothing(std::string_view command) {
  static constexpr std::array<std::string_view, 18> all = {
      "left", "right", "big",   "Big",    "bigl",   "bigr",     "Bigl",      "Bigr",         "bigg",
      "Bigg", "biggl", "biggr", "middle", "limits", "nolimits", "textstyle", "displaystyle", "thinspace"};
  return std::ranges::find(all, command) != all.end();
}
const std::map<char, const char*>& double_struck() {
  static const std::map<char, const char*> all = {{'R', "ℝ"}, {'N', "ℕ"}, {'Z', "ℤ"},
                                                  {'Q', "ℚ"}, {'C', "ℂ"}, {'P', "ℙ"}};
  return all;
}

class MathReader {
 public:
  explicit MathReader(std::string_view source) : source_(source) {}

  Runs read() {
    Atoms all = list('\0');
    if (!ended()) throw Refused{"a brace is closed that none opens"};
    if (delimited_ != 0) throw Refused{"\\left and \\right do not come in pairs"};
    return laid_out(std::move(all));
  }
  std::vector<std::string> beyond() { return std::move(beyond_); }

 private:
  static constexpr int deepest = 40;

  bool ended() const { return at_ >= source_.size(); }
  char here() const { return ended() ? '\0' : source_[at_]; }
  void skip_spaces() {
    while (!ended() && (here() == ' ' || here() == '\n' || here() == '\t' || here() == '\r')) ++at_;
  }
  void find_beyond(const std::string& what) {
    if (std::ranges::find(beyond_, what) == beyond_.end()) beyond_.push_back(what);
  }

  /// Reads up to a brace or bracket that closes, or the end, and leaves that unread.
  Atoms list(char close) {
    if (++depth_ > deepest) throw Refused{"its braces nest too deep"};
    Atoms all;
    for (skip_spaces(); !ended() && here() != '}' && !(close == ']' && here() == ']'); skip_spaces()) {
      Atom next = here() == '^' || here() == '_' ? Atom{} : one();
      add_scripts(next);
      all.push_back(std::move(next));
    }
    --depth_;
    return all;
  }

  Atoms group(char close) {
    ++at_;
    Atoms all = list(close);
    if (here() != close) throw Refused{close == '}' ? "a brace is not closed" : "a bracket is not closed"};
    ++at_;
    return all;
  }

  /// Reads what a command or a script is about: a group in braces, or one sign.
  Atoms argument(const std::string& of) {
    skip_spaces();
    if (ended() || here() == '}' || here() == '^' || here() == '_') throw Refused{"nothing follows " + of};
    if (here() == '{') return group('}');
    if (is_one_digit(here())) return {atom(Kind::letter, source_.substr(at_++, 1))};
    return {one()};
  }

  /// Reads a group of words, in which spaces stay.
  std::string words(const std::string& of) {
    skip_spaces();
    if (here() != '{') throw Refused{"a group in braces is expected after " + of};
    std::string text;
    int open = 0;
    do {
      const char c = here();
      if (ended()) throw Refused{"a brace is not closed"};
      open += c == '{' ? 1 : c == '}' ? -1 : 0;
      ++at_;
      if (c == '\\' && !ended()) {
        if (is_latin(here()))
          find_beyond("\\" + name());
        else
          text += source_[at_++];
      } else if (c == '%' || c == '#') {
        refuse_sign(c);
      } else if (c != '{' && c != '}') {
        text += c == '~' ? ' ' : c;
      }
    } while (open > 0);
    return text;
  }

  std::string name() {
    const std::size_t begin = at_;
    while (is_latin(here())) ++at_;
    return std::string(source_.substr(begin, at_ - begin));
  }

  [[noreturn]] static void refuse_sign(char c) {
    throw Refused{std::string("a ") + c + " is written \\" + c + " there"};
  }

  /// Reads a sign, a number, a command or a group.
  Atom one() {
    const char c = here();
    if (c == '\\') return command();
    if (c == '{') return {Kind::letter, laid_out(group('}'))};
    if (c == '%' || c == '#') refuse_sign(c);
    if (is_one_digit(c)) return number();
    const std::string_view character = character_at(source_, at_);
    at_ += character.size();
    if (const TexSign* sign = tex_sign_of(character)) return of(*sign);
    if (is_latin(c)) return atom(Kind::letter, character, true);
    switch (c) {
      case '-':
        return atom(Kind::binary, "−");
      case '+':
        return atom(Kind::binary, "+");
      case '*':
        return atom(Kind::binary, "∗");
      case '=':
      case '<':
      case '>':
      case ':':
        return atom(Kind::relation, character);
      case '(':
      case '[':
        return atom(Kind::open, character);
      case ')':
      case ']':
        return atom(Kind::close, character);
      case ',':
      case ';':
        return atom(Kind::comma, character);
      case '\'':
        return atom(Kind::letter, "′");
      case '~':
        return atom(Kind::space, " ");
      case '&':
        find_beyond("&");
        return atom(Kind::space, " ");
      default:
        return atom(Kind::letter, character == "−" ? "−" : character);
    }
  }

  static Atom of(const TexSign& sign) { return atom(kind_of(sign.kind), sign.text, sign.italic); }

  Atom number() {
    const std::size_t begin = at_;
    while (is_one_digit(here()) || (here() == '.' && at_ + 1 < source_.size() && is_one_digit(source_[at_ + 1]))) ++at_;
    return atom(Kind::letter, source_.substr(begin, at_ - begin));
  }

  Atom command() {
    ++at_;
    if (ended()) throw Refused{"a backslash stands at the end"};
    if (!is_latin(here())) return escaped();
    const std::string called = name(), shown = "\\" + called;
    if (const TexSign* sign = tex_sign(called)) return of(*sign);
    if (const auto space = spaces().find(called); space != spaces().end()) return atom(Kind::space, space->second);
    if (called == "left" || called == "right") return delimiter(called == "left");
    if (says_nothing(called)) return {};
    if (const auto mark = accents().find(called); mark != accents().end()) return marked(shown, mark->second);
    if (called == "frac" || called == "dfrac" || called == "tfrac") return fraction(shown);
    if (called == "sqrt") return root();
    if (called == "mathbb") return struck(shown);
    if (called == "mathbf" || called == "boldsymbol" || called == "bm")
      return {Kind::letter, styled(laid_out(argument(shown)), false, true)};
    if (called == "mathrm") return {Kind::letter, styled(laid_out(argument(shown)), false, false)};
    if (called == "mathit") return {Kind::letter, styled(laid_out(argument(shown)), true, false)};
    if (called == "text" || called == "textrm" || called == "mbox") return atom(Kind::letter, words(shown));
    if (called == "operatorname") return atom(Kind::word, words(shown));
    find_beyond(shown);
    return atom(Kind::word, called);
  }

  Atom escaped() {
    const std::string_view character = character_at(source_, at_);
    at_ += character.size();
    if (const auto space = spaces().find(character); space != spaces().end()) return atom(Kind::space, space->second);
    if (character == "{") return atom(Kind::open, "{");
    if (character == "}") return atom(Kind::close, "}");
    if (character == "|") return atom(Kind::letter, "‖");
    if (std::string_view("%#&_$").find(character) == std::string_view::npos) find_beyond("\\" + std::string(character));
    return atom(Kind::letter, character);
  }

  /// Reads what \left or \right makes large; a full stop is none.
  Atom delimiter(bool left) {
    delimited_ += left ? 1 : -1;
    if (delimited_ < 0) throw Refused{"\\left and \\right do not come in pairs"};
    skip_spaces();
    if (ended() || here() == '{' || here() == '}') throw Refused{"no bracket follows \\left or \\right"};
    if (here() == '.') return ++at_, Atom{};
    Atom bracket = one();
    bracket.kind = left ? Kind::open : Kind::close;
    return bracket;
  }

  Atom marked(const std::string& shown, const char* mark) {
    Runs runs = laid_out(argument(shown), true);
    if (runs.size() == 1 && count_characters(runs[0].text) == 1)
      runs[0].text += mark;
    else
      find_beyond(shown + " over more than one letter");
    return {Kind::letter, std::move(runs)};
  }

  static bool is_one(const Atoms& atoms) { return atoms.size() == 1 && atoms[0].kind != Kind::fraction; }

  static Runs in_brackets(const Atoms& atoms, bool bare) {
    Runs runs;
    if (!bare) append(runs, "(");
    append(runs, laid_out(atoms));
    if (!bare) append(runs, ")");
    return runs;
  }

  Atom fraction(const std::string& shown) {
    const Atoms above = argument(shown), below = argument(shown);
    const bool is_product = std::ranges::none_of(above, [](const Atom& a) {
      return a.kind == Kind::binary || a.kind == Kind::relation || a.kind == Kind::fraction;
    });
    Atom all = {Kind::fraction, in_brackets(above, is_product)};
    append(all.runs, "/");
    append(all.runs, in_brackets(below, is_one(below)));
    return all;
  }

  Atom root() {
    skip_spaces();
    std::string sign = "√";
    if (here() == '[') {
      const std::string degree = text_of(laid_out(group(']')));
      if (degree == "3")
        sign = "∛";
      else if (degree == "4")
        sign = "∜";
      else
        find_beyond("\\sqrt[" + degree + "]");
    }
    const Atoms under = argument("\\sqrt");
    Atom all = atom(Kind::letter, sign);
    append(all.runs, in_brackets(under, is_one(under)));
    return all;
  }

  Atom struck(const std::string& shown) {
    const std::string letters = text_of(laid_out(argument(shown), true));
    std::string text;
    for (const char c : letters) {
      const auto found = double_struck().find(c);
      if (found == double_struck().end()) find_beyond(shown + "{" + letters + "}");
      text += found == double_struck().end() ? std::string(1, c) : found->second;
    }
    return atom(Kind::letter, text);
  }

  /// Reads the scripts behind an atom. A script holds no other one, but small digits.
  void add_scripts(Atom& to) {
    std::optional<Runs> sub, super;
    for (skip_spaces(); here() == '^' || here() == '_'; skip_spaces()) {
      const char mark = source_[at_++];
      std::optional<Runs>& script = mark == '_' ? sub : super;
      if (script) throw Refused{twice(mark)};
      script = small(laid_out(argument(std::string(1, mark)), true), mark == '_' ? Script::sub : Script::super);
    }
    if (sub) append(to.runs, *sub);
    if (!super) return;
    const std::string text = text_of(*super);
    if (text == "∘" || text == "°" || text == "′")
      append(to.runs, std::string(text == "′" ? "′" : "°"));
    else
      append(to.runs, *super);
  }

  static std::string twice(char mark) {
    return std::string("two scripts ") + mark + " follow each other; braces tell which belongs to which";
  }

  Runs small(Runs runs, Script script) {
    for (Run& run : runs) {
      if (run.script != Script::base) {
        const std::optional<std::string> form = small_form(run.text, run.script);
        if (form)
          run.text = *form;
        else
          find_beyond("a script in a script");
      }
      run.script = script;
    }
    Runs all;
    append(all, runs);
    return all;
  }

  std::string_view source_;
  std::size_t at_ = 0;
  int depth_ = 0, delimited_ = 0;
  std::vector<std::string> beyond_;
};

}  // namespace
}  // namespace tex_math

TexMath read_tex_math(std::string_view source) try {
  tex_math::MathReader reader(source);
  TexMath math = {reader.read()};
  math.beyond = reader.beyond();
  if (math.runs.empty()) math.runs.emplace_back();
  for (Run& run : math.runs) run.math = true;
  math.runs.front().tex = source;
  return math;
} catch (const tex_math::Refused& refused) {
  return {.error = refused.why};
}

std::size_t end_of_tex_math(std::string_view markup, std::size_t i) {
  const std::size_t begin = i + 1;
  std::size_t end = begin;
  while (end < markup.size() && markup[end] != '$') end += markup[end] == '\\' ? 2 : 1;
  if (end >= markup.size() || end == begin) return std::string_view::npos;
  const bool spaced = markup[begin] == ' ' || markup[end - 1] == ' ';
  const bool price = end + 1 < markup.size() && tex_math::is_one_digit(markup[end + 1]);
  return spaced || price ? std::string_view::npos : end + 1;
}

std::string tex_packages(std::string_view tex) {
  const auto has = [&](std::string_view command) {
    for (std::size_t at = tex.find(command); at != tex.npos; at = tex.find(command, at + 1))
      if (at + command.size() == tex.size() || !tex_math::is_latin(tex[at + command.size()])) return true;
    return false;
  };
  constexpr std::array<std::string_view, 11> maths = {"\\lVert",        "\\rVert",      "\\lvert",         "\\rvert",
                                                      "\\text",         "\\dfrac",      "\\tfrac",         "\\implies",
                                                      "\\operatorname", "\\boldsymbol", "\\begin{pmatrix}"};
  constexpr std::array<std::string_view, 3> signs = {"\\mathbb", "\\varnothing", "\\checkmark"};
  const bool needs_signs = std::ranges::any_of(signs, has);
  const bool needs_maths = std::ranges::any_of(maths, has);
  return needs_signs ? (needs_maths ? "amsmath,amssymb" : "amssymb") : needs_maths ? "amsmath" : "";
}

}  // namespace isect::viz
