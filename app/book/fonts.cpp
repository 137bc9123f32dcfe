#include "app/book/fonts.h"

#include <fmt/format.h>

#include <set>

#include "app/book/page_shell.h"
#include "viz/font/subset.h"
#include "viz/formats/svg_path.h"
#include "viz/text/utf8.h"

namespace isect::program::book {

namespace {

/// Returns the characters of UTF-8 text, each as its bytes.
std::set<std::string> characters(const std::string& text) {
  std::set<std::string> all;
  for (std::size_t i = 0; i < text.size();) {
    const std::string_view character = viz::character_at(text, i);
    if (static_cast<unsigned char>(character[0]) >= ' ') all.emplace(character);
    i += character.size();
  }
  return all;
}

std::string without_comment_ends(std::string text) {
  for (std::size_t at = text.find("*/"); at != text.npos; at = text.find("*/")) text.erase(at, 2);
  return text;
}

}  // namespace

void Letters::add(const std::string& page) {
  std::set<std::string> all = characters(known_);
  all.merge(characters(page));
  known_.clear();
  for (const std::string& c : all) known_ += c;
}

std::string Letters::fonts() const {
  const struct {
    viz::Face face;
    const char *weight, *style;
  } faces[] = {{viz::Face::upright, "normal", "normal"},
               {viz::Face::italic, "normal", "italic"},
               {viz::Face::bold, "bold", "normal"}};
  std::string rules, notice;
  for (const auto& [face, weight, style] : faces) {
    const auto subset = viz::font_subset(face, known_);
    if (!subset) return {};
    notice = subset->notice;
    rules += fmt::format(
        "@font-face {{ font-family: \"Isect Letters\"; font-weight: {}; font-style: {}; "
        "src: url(data:font/otf;base64,{}) format(\"opentype\"); }}\n",
        weight, style, viz::base64(subset->bytes));
  }
  return fmt::format(
      "/* Isect Letters: a few letters of a font, under another name, as its licence asks.\n{}\n{}*/\n{}",
      without_comment_ends(notice), without_comment_ends(licence_text()), rules);
}

std::string fonts_text(const std::string& page) {
  Letters letters;
  letters.add(page);
  return letters.fonts();
}

}  // namespace isect::program::book
