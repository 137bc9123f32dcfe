#include "app/pages/latex.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "viz/lang/language.h"
#include "viz/text/rich_text.h"
#include "viz/text/tex.h"

namespace isect::program {

namespace {

/// Returns a line on a coloured ground as wide as the text around it.
std::string lit(const std::string& line) {
  return "\\hspace*{-\\fboxsep}\\colorbox{isectlit}{\\parbox{\\linewidth}{\\raggedright " + line +
         "}}\\hspace*{-\\fboxsep}\\par\n";
}

/// Returns a line of markup after the spaces with which it begins.
std::string indented(const std::string& line) {
  const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
  std::string spaces;
  for (std::size_t i = 0; i < indent; ++i) spaces += "~";
  return spaces + viz::tex(line.substr(indent));
}

std::string fitted(const std::string& picture) {
  return "\\resizebox{\\ifdim\\width>\\linewidth \\linewidth\\else\\width\\fi}{!}{" + picture + "}";
}

/// Returns a picture in words, which LaTeX expands and does not set. Only lualatex, which alone makes tags, reads it:
/// \Uchar35 is the character with that number. The space behind the number ends it.
std::string picture_in_words(const std::string& alt) {
  std::string out;
  bool numbered = false;  // so that TeX drops a space that follows
  for (const char c : alt) {
    const bool is_space = c == ' ' || c == '\n', was_numbered = std::exchange(numbered, false);
    if (std::string_view("#$%&_{}~^\\").find(c) != std::string_view::npos)
      out += fmt::format("\\Uchar{} ", static_cast<int>(c)), numbered = true;
    else if (is_space)
      out += was_numbered ? "\\space " : " ";
    else
      out += c;
  }
  return out;
}

struct AsLatex {
  std::string operator()(const Heading& h) const {
    const char* before = h.level == 1 ? "" : h.level == 2 ? "sub" : "subsub";
    return fmt::format("\n\\{}section*{{{}}}\n", before, viz::tex(h.text));
  }
  std::string operator()(const Prose& p) const {
    std::string out = p.head.empty() ? "" : fmt::format("\\textbf{{{}}} ", viz::tex(p.head));
    for (const std::string& paragraph : paragraphs(p.text)) out += viz::tex(paragraph) + "\n\n";
    return out;
  }
  std::string operator()(const Code& c) const {
    std::string out = "{\\raggedright\n";
    for (std::size_t i = 0; i < c.lines.size(); ++i) {
      const bool current = static_cast<int>(i) == c.current;
      const std::string said = current && !c.said.empty() ? fmt::format("\\quad\\textbf{{{}}}", c.said) : "";
      const std::string line = fmt::format("\\hangindent=3em \\makebox[1.3em][r]{{\\scriptsize {}}}\\quad {}{}",
                                           c.first + static_cast<int>(i), indented(c.lines[i]), said);
      out += current ? lit(line) : line + "\\par\n";
    }
    return out + "}\n";
  }
  std::string operator()(const Image& image) const {
    const std::string picture = fmt::format("\\input{{{}.tikz}}", image.stem);
    if (image.fits) return fmt::format("\\begin{{center}}{}\\end{{center}}\n", fitted(picture));
    return fmt::format("\\begin{{center}}\\isectfigure{{{}}}{{{}}}\\end{{center}}\n", picture_in_words(image.alt),
                       picture);
  }
  std::string operator()(const Choices& choices) const {
    // No page break within them, or between them and their question.
    std::string out =
        "{\\csname @beginparpenalty\\endcsname=10000\n\\begin{itemize}\\csname @itempenalty\\endcsname=10000\n";
    for (std::size_t i = 0; i < choices.all.size(); ++i)
      out += fmt::format("\\item[({})] {}\n", viz::choice_letter(i), viz::tex(choices.all[i]));
    return out + "\\end{itemize}}\n";
  }
  std::string operator()(const Blanks& blanks) const {
    std::string out = viz::tex(blanks.head) + ":";
    for (int i = 0; i < blanks.count; ++i) out += " \\rule{2em}{0.4pt}";
    return out + "\n\n";
  }
  std::string operator()(const Stops& stops) const {
    std::string out = "\\begin{itemize}\n";
    for (const auto& [number, text] : stops.all) out += fmt::format("\\item[{}.] {}\n", number, viz::tex(text));
    return out + "\\end{itemize}\n";
  }
  std::string operator()(const NewPage&) const { return "\\clearpage\n"; }
  std::string operator()(const Pause&) const { return "\\pause\n"; }
};

}  // namespace

std::string latex_mark(const std::string& what) { return fmt::format("% Made by isect {}.", what); }

std::string latex_metadata() {
  return "% Tags for screen readers, by lualatex with the package tagpdf; \\def\\isectuntagged{} before this for "
         "none.\n"
         "\\ifdefined\\isectuntagged\\else\\ifdefined\\directlua\\ifdefined\\DocumentMetadata\n"
         "\\IfFileExists{tagpdf.sty}{\\def\\isecttagged{phase-II}"
         "\\IfFileExists{phase-III-latex-lab-testphase.ltx}{\\def\\isecttagged{phase-III}}{}}{}\n"
         "\\fi\\fi\\fi\n"
         "\\ifdefined\\isecttagged\n"
         "\\edef\\isecttags{\\noexpand\\DocumentMetadata{testphase=\\isecttagged,lang=" +
         viz::spoken() +
         ",pdfversion=1.7}}\\isecttags\n"
         "\\fi\n";
}

std::string latex_preamble(const std::string& title, const std::string& packages) {
  return "\\usepackage{tikz" + packages + "}\n\\usepackage[hidelinks]{hyperref}\n" + pdf_properties(title) +
         "\\colorlet{isectlit}{yellow!40}\n"
         "\\ifdefined\\isecttagged\n\\typeout{" +
         tagged_note +
         "}\n"
         "\\ifdefined\\SuspendTagging\\else\\newcommand{\\SuspendTagging}[1]{}\\newcommand{\\ResumeTagging}[1]{}\\fi\n"
         "\\newcommand{\\isectfigure}[2]{\\leavevmode\\tagmcend\n"
         "  \\edef\\isectbegin{\\noexpand\\tagstructbegin{tag=Figure,alt={#1}}}\\isectbegin\n"
         "  \\tagmcbegin{tag=Figure}\\SuspendTagging{isect}#2\\ResumeTagging{isect}\\tagmcend\\tagstructend\n"
         "  \\tagmcbegin{tag=P}}\n"
         "\\else\n\\newcommand{\\isectfigure}[2]{#2}\n\\fi\n";
}

std::string pdf_properties(const std::string& title) {
  return fmt::format("\\hypersetup{{pdftitle={{{}}},pdflang={}}}\n", viz::tex_said(viz::plain(title)), viz::spoken());
}

std::string latex(const Blocks& blocks) {
  std::string out;
  for (const Block& block : blocks) out += std::visit(AsLatex(), block);
  return out;
}

}  // namespace isect::program
