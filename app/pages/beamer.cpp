#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app/figures/blocks.h"
#include "app/pages/latex.h"
#include "app/pages/slides.h"
#include "viz/text/tex.h"

namespace isect::program {

namespace {

bool has_picture(const Blocks& blocks) {
  return std::ranges::any_of(blocks, [](const Block& b) { return std::holds_alternative<Image>(b); });
}

/// Returns a slide's frame. Words alone are larger, and centred.
std::string frame(const Slide& s) {
  if (s.first)
    return fmt::format(
        "\\begin{{frame}}\n\\begin{{center}}{{\\huge\\usebeamercolor[fg]{{frametitle}} {}}}\\\\[3ex]\n{}"
        "\\end{{center}}\n\\end{{frame}}\n",
        viz::tex(s.title), latex(s.left));
  std::string body = latex(s.left);
  if (!s.right.empty())
    body = "\\begin{columns}[T]\n\\begin{column}{0.6\\textwidth}\n\\small\n" + body +
           "\\end{column}\n\\begin{column}{0.38\\textwidth}\n\\footnotesize\n" + latex(s.right) +
           "\\end{column}\n\\end{columns}\n";
  else if (!has_picture(s.left))
    body = "\\large\n" + body;
  return fmt::format("\\begin{{frame}}[{},shrink]\n\\frametitle{{{}}}\n{}{}\\end{{frame}}\n",
                     has_picture(s.left) ? "t" : "c", viz::tex(s.title), body,
                     s.below.empty() ? "" : "\\medskip\n" + latex(s.below));
}

/// Returns what the speaker alone sees.
std::string note_of(const Slide& s) {
  if (s.note.empty()) return {};
  std::vector<std::string> all;  // a note takes no paragraphs
  for (const std::string& paragraph : paragraphs(s.note)) all.push_back(viz::tex(paragraph));
  return fmt::format("\\note{{{}}}\n", fmt::join(all, "\\\\ "));
}

constexpr const char* beamer_head =
    "\n\\documentclass[aspectratio=169,10pt]{{beamer}}\n\\usepackage{{tikz}}\n\\usefonttheme{{serif}}\n"
    "\\setbeamertemplate{{navigation symbols}}{{}}\n\\setbeamertemplate{{footline}}[frame number]\n"
    "\\setlength{{\\parskip}}{{4pt plus 1pt}}\n{}\\title{{{}}}\n\\begin{{document}}\n";
constexpr const char* how_to_note = "% The speaker's notes: \\setbeameroption{show notes on second screen}\n";

}  // namespace

std::string beamer(const std::string& title, const std::vector<Slide>& slides) {
  const bool notes = std::ranges::any_of(slides, [](const Slide& s) { return !s.note.empty(); });
  std::string out = fmt::format(beamer_head, notes ? how_to_note : "", viz::tex(title));
  for (const Slide& slide : slides) out += frame(slide) + note_of(slide);
  return out + "\\end{document}\n";
}

}  // namespace isect::program
