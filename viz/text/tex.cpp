#include "viz/text/tex.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <vector>

#include "viz/text/rich_text.h"
#include "viz/text/utf8.h"

namespace isect::viz {
namespace {

/// A character or a script, as TeX sets it.
struct Atom {
  enum class Kind {
    words,     ///< of running text
    math,      ///< only between dollars
    relation,  ///< math, with space of its own around it
    neutral,   ///< either: digits, brackets, commas
    space
  };
  Kind kind = Kind::words;
  std::string tex;
  char script = 0;      ///< '_' or '^'
  bool source = false;  ///< mathematics as an author wrote it
};
using Atoms = std::vector<Atom>;

const std::map<std::string_view, Atom>& symbols() {
  using enum Atom::Kind;
  static const std::map<std::string_view, Atom> all = {{"−", {relation, "-"}},
                                                       {"+", {relation, "+"}},
                                                       {"=", {relation, "="}},
                                                       {"<", {relation, "<"}},
                                                       {">", {relation, ">"}},
                                                       {"/", {relation, "/"}},
                                                       {"·", {relation, "\\cdot "}},
                                                       {"×", {relation, "\\times "}},
                                                       {"≤", {relation, "\\le "}},
                                                       {"≥", {relation, "\\ge "}},
                                                       {"≠", {relation, "\\ne "}},
                                                       {"≈", {relation, "\\approx "}},
                                                       {"∓", {relation, "\\mp "}},
                                                       {"±", {relation, "\\pm "}},
                                                       {"←", {relation, "\\leftarrow "}},
                                                       {"→", {relation, "\\to "}},
                                                       {"⊆", {relation, "\\subseteq "}},
                                                       {"⊂", {relation, "\\subset "}},
                                                       {"∩", {relation, "\\cap "}},
                                                       {"∪", {relation, "\\cup "}},
                                                       {"∈", {relation, "\\in "}},
                                                       {"∉", {relation, "\\notin "}},
                                                       {"∧", {relation, "\\wedge "}},
                                                       {"∨", {relation, "\\vee "}},
                                                       {"∥", {relation, "\\parallel "}},
                                                       {"⊥", {relation, "\\perp "}},
                                                       {"⌈", {math, "\\lceil "}},
                                                       {"⌉", {math, "\\rceil "}},
                                                       {"⌊", {math, "\\lfloor "}},
                                                       {"⌋", {math, "\\rfloor "}},
                                                       {"|", {math, "|"}},
                                                       {"√", {math, "\\sqrt"}},
                                                       {"∞", {math, "\\infty "}},
                                                       {"∅", {math, "\\emptyset "}},
                                                       {"′", {math, "'"}},
                                                       {"Σ", {math, "\\Sigma "}},
                                                       {"Δ", {math, "\\Delta "}},
                                                       {"α", {math, "\\alpha "}},
                                                       {"β", {math, "\\beta "}},
                                                       {"γ", {math, "\\gamma "}},
                                                       {"δ", {math, "\\delta "}},
                                                       {"ε", {math, "\\varepsilon "}},
                                                       {"θ", {math, "\\theta "}},
                                                       {"λ", {math, "\\lambda "}},
                                                       {"μ", {math, "\\mu "}},
                                                       {"π", {math, "\\pi "}},
                                                       {"ρ", {math, "\\rho "}},
                                                       {"σ", {math, "\\sigma "}},
                                                       {"τ", {math, "\\tau "}},
                                                       {"φ", {math, "\\varphi "}},
                                                       {"ω", {math, "\\omega "}},
                                                       {"●", {math, "\\bullet "}},
                                                       {"°", {math, "^{\\circ}"}},
                                                       {"✗", {math, "\\times "}},
                                                       {"✓", {math, "\\surd "}},
                                                       {"“", {words, "``"}},
                                                       {"”", {words, "''"}},
                                                       {"‘", {words, "`"}},
                                                       {"’", {words, "'"}},
                                                       {"…", {words, "\\ldots{}"}},
                                                       {"–", {words, "--"}},
                                                       {"—", {words, "---"}},
                                                       {"ö", {words, "\\\"o"}},
                                                       {"ä", {words, "\\\"a"}},
                                                       {"ü", {words, "\\\"u"}},
                                                       {"é", {words, "\\'e"}},
                                                       {"\u00a0", {space, "~"}},
                                                       {"\u2009", {space, "\\,"}},
                                                       {" ", {space, " "}},
                                                       {"(", {neutral, "("}},
                                                       {")", {neutral, ")"}},
                                                       {"[", {neutral, "["}},
                                                       {"]", {neutral, "]"}},
                                                       {",", {neutral, ","}},
                                                       {".", {neutral, "."}},
                                                       {"{", {math, "\\{"}},
                                                       {"}", {math, "\\}"}},
                                                       {"\\", {words, "\\textbackslash{}"}},
                                                       {"$", {words, "\\$"}},
                                                       {"&", {words, "\\&"}},
                                                       {"#", {words, "\\#"}},
                                                       {"%", {words, "\\%"}},
                                                       {"_", {words, "\\_"}},
                                                       {"^", {words, "\\^{}"}},
                                                       {"~", {words, "\\~{}"}},
                                                       {"\"", {words, "''"}}};
  return all;
}

/// Returns '_' or '^' for a small digit or sign, and sets `base` to the ordinary one; 0 for any other character.
char script_of(std::string_view character, std::string& base) {
  static const std::map<std::string_view, std::pair<char, const char*>> small = {
      {"₀", {'_', "0"}}, {"₁", {'_', "1"}}, {"₂", {'_', "2"}}, {"₃", {'_', "3"}}, {"₄", {'_', "4"}}, {"₅", {'_', "5"}},
      {"₆", {'_', "6"}}, {"₇", {'_', "7"}}, {"₈", {'_', "8"}}, {"₉", {'_', "9"}}, {"₊", {'_', "+"}}, {"₋", {'_', "-"}},
      {"₌", {'_', "="}}, {"₍", {'_', "("}}, {"₎", {'_', ")"}}, {"⁰", {'^', "0"}}, {"¹", {'^', "1"}}, {"²", {'^', "2"}},
      {"³", {'^', "3"}}, {"⁴", {'^', "4"}}, {"⁵", {'^', "5"}}, {"⁶", {'^', "6"}}, {"⁷", {'^', "7"}}, {"⁸", {'^', "8"}},
      {"⁹", {'^', "9"}}, {"⁺", {'^', "+"}}, {"⁻", {'^', "-"}}, {"⁼", {'^', "="}}, {"⁽", {'^', "("}}, {"⁾", {'^', ")"}}};
  const auto found = small.find(character);
  if (found == small.end()) return 0;
  base = found->second.second;
  return found->second.first;
}

/// Adds a script. Two scripts of one kind in a row would be an error in TeX, so they become one.
void add_script(Atoms& atoms, char script, const std::string& tex) {
  if (!atoms.empty() && atoms.back().source) atoms.push_back({Atom::Kind::math, "{}"});  // it may have one already
  if (!atoms.empty() && atoms.back().script == script)
    atoms.back().tex.insert(atoms.back().tex.size() - 1, tex);
  else
    atoms.push_back({Atom::Kind::math, std::string(1, script) + "{" + tex + "}", script});
}

/// Returns the contents of a script or a root: mathematics throughout.
std::string all_math(const Atoms& atoms);

void add_characters(Atoms& atoms, std::string_view text) {
  for (std::size_t i = 0, n = 0; i < text.size(); i += n) {
    n = character_at(text, i).size();
    const std::string_view c = text.substr(i, n);
    std::string base;
    if (const char script = script_of(c, base)) {
      add_script(atoms, script, base);
    } else if (const auto found = symbols().find(c); found != symbols().end()) {
      atoms.push_back(found->second);
    } else {
      atoms.push_back({is_digit(c) ? Atom::Kind::neutral : Atom::Kind::words, std::string(c)});
    }
  }
}

/// Adds letters in italics or bold. Signs among them, and spaces between, are treated as elsewhere.
void add_letters(Atoms& atoms, const Run& run) {
  for (std::size_t i = 0; i < run.text.size();) {
    std::size_t end = i;
    while (end < run.text.size() && std::isalpha(static_cast<unsigned char>(run.text[end]))) ++end;
    if (end == i) {
      end = i + character_at(run.text, i).size();
      add_characters(atoms, std::string_view(run.text).substr(i, end - i));
    } else {
      const std::string letters = run.text.substr(i, end - i);
      const char* const font = run.bold ? "\\mathbf{" : letters.size() > 1 ? "\\mathit{" : nullptr;
      atoms.push_back({Atom::Kind::math, font ? font + letters + "}" : letters});
    }
    i = end;
  }
}

/// Adds mathematics that an author wrote for LaTeX, as it is; signs of Unicode become LaTeX's.
void add_source(Atoms& atoms, const std::string& source) {
  std::string tex;
  for (std::size_t i = 0, n = 0; i < source.size(); i += n) {
    n = character_at(source, i).size();
    const std::string_view c = std::string_view(source).substr(i, n);
    const auto known = n > 1 ? symbols().find(c) : symbols().end();
    tex += known == symbols().end() ? std::string(c) : known->second.tex;
  }
  std::size_t letters = tex.size();
  while (letters > 0 && std::isalpha(static_cast<unsigned char>(tex[letters - 1]))) --letters;
  const bool ends_in_command = letters < tex.size() && letters > 0 && tex[letters - 1] == '\\';
  atoms.push_back({Atom::Kind::math, ends_in_command ? tex + " " : tex, 0, true});
}

void add(Atoms& atoms, const Run& run) {
  if (run.math) {
    if (!run.tex.empty()) add_source(atoms, run.tex);
    return;
  }
  Atoms own;
  if (run.italic || run.bold)
    add_letters(own, run);
  else
    add_characters(own, run.text);
  if (run.script != Run::Script::base) {
    add_script(atoms, run.script == Run::Script::sub ? '_' : '^', all_math(own));
    return;
  }
  for (const Atom& atom : own) {
    if (atom.script)
      add_script(atoms, atom.script, atom.tex.substr(2, atom.tex.size() - 3));
    else
      atoms.push_back(atom);
  }
}

/// Returns the bracket that closes the one at `open`; the end if none does.
std::size_t closing(const Atoms& atoms, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < atoms.size(); ++i) {
    depth += atoms[i].tex == "(" ? 1 : atoms[i].tex == ")" ? -1 : 0;
    if (depth == 0) return i;
  }
  return atoms.size();
}

/// Joins roots with what stands under them: a bracket, a number, or a letter with its scripts.
Atoms with_roots(const Atoms& atoms) {
  Atoms out;
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    if (atoms[i].tex != "\\sqrt") {
      out.push_back(atoms[i]);
      continue;
    }
    std::size_t begin = i + 1, end = begin;
    if (begin < atoms.size() && atoms[begin].tex == "(") {
      end = closing(atoms, begin);
      ++begin;
    } else if (begin < atoms.size() && is_digit(atoms[begin].tex)) {
      while (end < atoms.size() && (is_digit(atoms[end].tex) || atoms[end].tex == ".")) ++end;
      if (atoms[end - 1].tex == ".") --end;
    } else if (begin < atoms.size() && atoms[begin].kind == Atom::Kind::math) {
      do ++end;
      while (end < atoms.size() && atoms[end].script);
    }
    const Atoms under(atoms.begin() + static_cast<std::ptrdiff_t>(begin),
                      atoms.begin() + static_cast<std::ptrdiff_t>(end));
    const std::string inner = all_math(with_roots(under));
    out.push_back({Atom::Kind::math, inner.empty() ? "\\surd " : "\\sqrt{" + inner + "}"});
    const bool bracket = begin == i + 2;
    i = bracket ? std::min(end, atoms.size() - 1) : std::max(end, i + 1) - 1;
  }
  return out;
}

std::string all_math(const Atoms& atoms) {
  std::string out, word;
  const auto end_word = [&] {
    if (!word.empty()) out += "\\mathrm{" + word + "}";
    word.clear();
  };
  for (const Atom& atom : atoms) {
    if (atom.kind == Atom::Kind::words) {
      word += atom.tex;
    } else {
      end_word();
      out += atom.kind == Atom::Kind::space && atom.tex != "\\," ? " " : atom.tex;
    }
  }
  end_word();
  return out;
}

bool is_math(const Atom& a) { return a.kind == Atom::Kind::math || a.kind == Atom::Kind::relation; }

/// Whether atom i, a space, stands beside a sign with space of its own, so that mathematics may continue across it.
bool joins(const Atoms& atoms, std::size_t i) {
  return i > 0 && i + 1 < atoms.size() &&
         (atoms[i].tex == "\\," || atoms[i - 1].kind == Atom::Kind::relation ||
          atoms[i + 1].kind == Atom::Kind::relation);
}

/// Whether atom i is a comma or full stop that ends a clause, not one within a number or a bracket.
bool ends_clause(const Atoms& atoms, std::size_t i) {
  const bool mark = atoms[i].tex == "," || atoms[i].tex == ".";
  return mark && (i + 1 == atoms.size() || atoms[i + 1].kind == Atom::Kind::space);
}

/// Returns where the mathematics that begins at `begin` ends: before a word, before a space between words, before the
/// end of a clause.
std::size_t end_of_math(const Atoms& atoms, std::size_t begin) {
  std::size_t end = begin;
  while (end < atoms.size()) {
    const Atom& a = atoms[end];
    if (a.kind == Atom::Kind::words || ends_clause(atoms, end)) break;
    if (a.kind == Atom::Kind::space && !joins(atoms, end)) break;
    ++end;
  }
  return end;
}

/// Whether a sign at the beginning or end of mathematics stands between two sides, one of which is a word, as in "count
/// + 1". TeX would take it for a unary sign, and set it close; an empty group serves as the other side.
bool stands_between(const Atoms& atoms, std::size_t i) {
  return atoms[i].kind == Atom::Kind::relation && i > 0 && atoms[i - 1].kind == Atom::Kind::space &&
         i + 1 < atoms.size() && atoms[i + 1].kind == Atom::Kind::space;
}

std::string running(const Atoms& atoms) {
  std::string out;
  for (std::size_t i = 0; i < atoms.size();) {
    // Spaces at either end belong to the words around: TeX would lose them.
    std::size_t end = end_of_math(atoms, i);
    const std::size_t behind = end;
    while (end > i && atoms[end - 1].kind == Atom::Kind::space) --end;
    std::string spaces;
    while (i < end && atoms[i].kind == Atom::Kind::space) spaces += atoms[i++].tex;
    const Atoms part(atoms.begin() + static_cast<std::ptrdiff_t>(i), atoms.begin() + static_cast<std::ptrdiff_t>(end));
    if (std::ranges::any_of(part, is_math)) {
      const bool begins = stands_between(atoms, i), ends = stands_between(atoms, end - 1);
      out += begins ? "${}" : spaces + '$';
      out += all_math(part);
      out += ends ? "{}$" : "$";
      i = ends ? behind : end;
    } else {
      out += spaces;
      const std::size_t next = std::max(end, i + 1);
      for (; i < next; ++i) out += atoms[i].tex;
    }
  }
  return out;
}

}  // namespace

std::string tex(const std::string& markup) {
  Atoms atoms;
  for (const Run& run : parse_markup(markup)) add(atoms, run);
  return running(with_roots(atoms));
}

std::string tex_plain(const std::string& text) {
  const std::size_t indent = std::min(text.find_first_not_of(' '), text.size());
  Atoms atoms;
  add_characters(atoms, std::string_view(text).substr(indent));
  std::string out;
  for (std::size_t i = 0; i < indent; ++i) out += "~";
  return out + running(with_roots(atoms));
}

std::string tex_said(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\')
      out += "\\textbackslash{}";
    else if (c == '~' || c == '^')
      (out += '\\') += c, out += "{}";
    else if (std::string_view("#$%&_{}").find(c) != std::string_view::npos)
      (out += '\\') += c;
    else
      out += c;
  }
  return out;
}

}  // namespace isect::viz
