#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app/figures/blocks.h"
#include "app/pages/latex.h"
#include "app/pages/slides.h"
#include "viz/text/tex.h"

namespace isect::program {

namespace {

bool shows_picture(const Blocks& blocks) {
  return std::ranges::any_of(blocks, [](const Block& b) { return std::holds_alternative<Image>(b); });
}

/// Returns a slide's frame. Words alone are larger, and centred.
std::string frame(const Slide& s) {
  if (s.first)
    return fmt::format(
        "\\begin{{frame}}\n\\begin{{center}}{{\\huge\\usebeamercolor[fg]{{isect title}} {}}}\\\\[3ex]\n{}"
        "\\end{{center}}\n\\end{{frame}}\n",
        viz::tex(s.title), latex(s.left));
  std::string body = latex(s.left);
  if (!s.right.empty())
    body = "\\begin{columns}[T]\n\\begin{column}{0.6\\textwidth}\n\\small\n" + body +
           "\\end{column}\n\\begin{column}{0.38\\textwidth}\n\\footnotesize\n" + latex(s.right) +
           "\\end{column}\n\\end{columns}\n";
  else if (!shows_picture(s.left))
    body = "\\large\n" + body;
  return fmt::format("\\begin{{frame}}[{},shrink]\n\\frametitle{{{}}}\n{}{}\\end{{frame}}\n",
                     shows_picture(s.left) ? "t" : "c", viz::tex(s.title), body,
                     s.below.empty() ? "" : "\\medskip\n" + latex(s.below));
}

/// Returns what the speaker alone sees.
std::string note_of(const Slide& s) {
  if (s.note.empty()) return {};
  std::vector<std::string> all;  // a note takes no paragraphs
  for (const std::string& paragraph : paragraphs(s.note)) all.push_back(viz::tex(paragraph));
  return fmt::format("\\note{{{}}}\n", fmt::join(all, "\\\\ "));
}

constexpr const char* how_to_note = "% The speaker's notes: \\setbeameroption{show notes on second screen}\n";

/// Heights of what stands in one frame for several steps, so that nothing moves from one to the next.
constexpr const char* beside_room = "5.2cm";
constexpr const char* below_room = "1.1cm";
/// A macro for text in a room of a fixed height: it is set smaller, on more of its lines' width, if it needs more.
constexpr const char* room_macro =
    "\\newsavebox{\\isectbox}\n"
    "\\newcommand{\\isectset}[2]{\\setbox\\isectbox\\hbox{\\begin{minipage}[t]{#1}\\setlength{\\parskip}{4pt}#2"
    "\\end{minipage}}}\n"
    "\\newcommand{\\isectroom}[2]{\\isectset{\\linewidth}{#2}%\n"
    "  \\ifdim\\dimexpr\\ht\\isectbox+\\dp\\isectbox\\relax>\\dimexpr#1\\relax\n"
    "    \\pgfmathsetmacro{\\isectscale}{0.95*sqrt((#1)/(\\ht\\isectbox+\\dp\\isectbox))}%\n"
    "    \\pgfmathsetlengthmacro{\\isectwide}{\\linewidth/\\isectscale}%\n"
    "    \\isectset{\\isectwide}{#2}%\n"
    "    \\setbox\\isectbox\\hbox{\\scalebox{\\isectscale}{\\box\\isectbox}}%\n"
    "  \\fi\n"
    "  \\vbox to #1{\\box\\isectbox\\vss}}\n";

/// Returns the blocks up to a pause, and those behind it on that overlay.
std::string paused(const Blocks& blocks, int overlay) {
  const auto pause = std::ranges::find_if(blocks, [](const Block& b) { return std::holds_alternative<Pause>(b); });
  if (pause == blocks.end()) return latex(blocks);
  return latex(Blocks(blocks.begin(), pause)) +
         fmt::format("\\uncover<{}->{{%\n{}}}\n", overlay, latex(Blocks(pause + 1, blocks.end())));
}

bool has_pause(const Blocks& blocks) {
  return std::ranges::any_of(blocks, [](const Block& b) { return std::holds_alternative<Pause>(b); });
}

/// Returns one frame of several slides, one after the other in the same places: each overlay says what stands there.
/// What it says is global, as LaTeX sets a frame's title after its contents.
std::string overlays(const Slide* begin, const Slide* end) {
  std::string all;
  int overlay = 0;  // so far
  for (const Slide* s = begin; s != end; ++s) {
    const int first = ++overlay;
    if (has_pause(s->right) || has_pause(s->below)) ++overlay;
    const auto says = [](const char* macro, const std::string& text) {
      return fmt::format("\\gdef\\isect{}{{%\n{}}}%\n", macro, text);
    };
    all += fmt::format("\\only<{}>{{%\n",
                       first == overlay ? fmt::format("{}", first) : fmt::format("{}-{}", first, overlay));
    all += says("title", viz::tex(s->title)) + says("left", latex(s->left)) + says("right", paused(s->right, overlay)) +
           says("below", paused(s->below, overlay)) + "}%\n";
  }
  return fmt::format(
      "\\begin{{frame}}[t]\n{}\\frametitle{{\\isecttitle}}\n\\begin{{columns}}[T]\n\\begin{{column}}{{0.6\\textwidth}}"
      "\n"
      "\\small\n\\isectleft\n\\end{{column}}\n\\begin{{column}}{{0.38\\textwidth}}\n\\footnotesize\n"
      "\\isectroom{{{}}}{{\\isectright}}\n\\end{{column}}\n\\end{{columns}}\n\\medskip\n"
      "\\isectroom{{{}}}{{\\isectbelow}}\n\\end{{frame}}\n",
      all, beside_room, below_room);
}

/// Returns the colours of slides: those of the theme, or of dark slides.
std::string slide_colours(const SlideLook& look) {
  if (!look.is_dark()) return "\\setbeamercolor{isect title}{parent=structure}\n\\colorlet{isectlit}{yellow!40}\n";
  std::string out;
  for (const auto& [name, value] : {std::pair{"isectground", &look.ground}, std::pair{"isecttext", &look.text},
                                    std::pair{"isectlit", &look.lit}, std::pair{"isectstructure", &look.structure}})
    out += fmt::format("\\definecolor{{{}}}{{HTML}}{{{}}}\n", name, *value);
  out += "\\setbeamercolor{normal text}{fg=isecttext,bg=isectground}\n\\usebeamercolor*{normal text}\n";
  for (const char* part : {"isect title", "item", "itemize item"})
    out += fmt::format("\\setbeamercolor{{{}}}{{fg=isecttext}}\n", part);
  if (look.beamer_theme.empty()) out += "\\setbeamercolor{structure}{fg=isectstructure}\n";
  return out;
}

}  // namespace

PageParts beamer(const std::string& title, const std::vector<Slide>& slides, const SlideLook& look) {
  const bool notes = std::ranges::any_of(slides, [](const Slide& s) { return !s.note.empty(); });
  const bool overlaid = std::ranges::any_of(slides, &Slide::overlaid);
  PageParts parts;
  parts.title = viz::tex(title);
  parts.preamble = "\\usepackage{tikz}\n";
  if (!look.beamer_theme.empty()) parts.preamble += fmt::format("\\usetheme{{{}}}\n", look.beamer_theme);
  parts.preamble +=
      slide_colours(look) + pdf_properties(title) + (overlaid ? room_macro : "") + (notes ? how_to_note : "");
  for (const Slide *slide = slides.data(), *end = slide + slides.size(); slide != end;) {
    const Slide* const next = std::find_if(slide, end, [](const Slide& s) { return !s.overlaid; });
    if (next != slide) {
      parts.body += overlays(slide, next);
      slide = next;
    } else {
      parts.body += frame(*slide) + note_of(*slide);
      ++slide;
    }
  }
  return parts;
}

}  // namespace isect::program
