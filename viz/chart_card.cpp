// A card of text: heads in a column, what each says beside it.

#include <algorithm>

#include "viz/chart_parts.h"
#include "viz/rich_text.h"

namespace isect::viz {
namespace {

constexpr double card_pitch = 1.45;     // from line to line, in sizes of the text
constexpr double row_gap = 0.75;        // from row to row, beyond that
constexpr double most_enlarged = 1.25;  // of a label's size
constexpr double narrow = 12;           // in sizes: a text with less room stands below its head

/// A word, or what stays together, and how wide it is at size 1.
using Word = std::pair<std::string, double>;

std::vector<Word> words_of(const ChartInk& ink, const std::string& markup) {
  std::vector<Word> all;
  for (const std::string& part : unbreakable(markup)) all.emplace_back(part, ink.width(part, 1));
  return all;
}

/// The text on as few lines as fit into `room`, in sizes of the text.
std::vector<std::string> broken(const std::vector<Word>& words, double room) {
  constexpr double space = 0.34;  // with what letters keep free on either side
  std::vector<std::string> lines;
  double width = 0;
  for (const auto& [word, own] : words) {
    width += space + own;
    if (lines.empty() || width > room)
      lines.push_back(word), width = own;
    else
      lines.back() += ' ' + word;
  }
  return lines;
}

/// The card's texts at one size.
struct Typeset {
  double size, column;  ///< where the texts begin; 0: below their heads
  std::vector<std::vector<std::string>> lines;
  double height = 0;
};

class Typesetter {
 public:
  Typesetter(const ChartInk& ink, const Card& card) : label_(ink.sizes().label) {
    for (const Card::Row& row : card.rows) {
      column_ = std::max(column_, ink.width(row.head, 1, true) + 1.2);
      texts_.push_back(words_of(ink, row.text));
    }
  }

  Typeset at(double size, double width) const {
    const double column = width / size - column_ < narrow ? 0 : column_;
    Typeset s{size, column * size, {}, 0};
    for (const std::vector<Word>& text : texts_) {
      s.lines.push_back(broken(text, width / size - column));
      const std::size_t lines = s.lines.back().size() + (column > 0 ? 0 : 1);
      s.height += (card_pitch * static_cast<double>(std::max<std::size_t>(lines, 1)) + row_gap) * size;
    }
    s.height -= texts_.empty() ? 0 : row_gap * size;
    return s;
  }

  /// At the largest size that fits.
  Typeset within(const Bounds& room) const {
    double share = most_enlarged;
    const auto next = [&] { return at(share * label_, room.right - room.left); };
    Typeset s = next();
    while (s.height > room.bottom - room.top && share > 0.3) share *= 0.97, s = next();
    return s;
  }

 private:
  double label_, column_ = 0;
  std::vector<std::vector<Word>> texts_;
};

}  // namespace

double natural_height(const ChartInk& ink, const Card& card, double width) {
  return Typesetter(ink, card).at(ink.sizes().label, width).height;
}

void draw(ChartInk& ink, const Card& card, const Bounds& all) {
  const double side = std::min(1.5 * ink.sizes().label, 0.04 * (all.right - all.left));
  const Bounds room = {all.left + side, all.top, all.right - side, all.bottom};
  const Typeset s = Typesetter(ink, card).within(room);
  double y = room.top + std::max(0.0, (room.bottom - room.top - s.height) / 2) + s.size;
  for (std::size_t i = 0; i < card.rows.size(); ++i) {
    const auto& [head, text] = card.rows[i];
    ink.part("row", head);
    ink.text(head, {room.left, y}, {s.size, Role::first, 0, true});
    if (s.column == 0) y += card_pitch * s.size;
    for (const std::string& line : s.lines[i]) {
      ink.text(line, {room.left + s.column, y}, {s.size});
      y += card_pitch * s.size;
    }
    y += row_gap * s.size;
    if (i + 1 == card.rows.size()) break;
    const double rule = y - s.size - 0.5 * row_gap * s.size + 0.1 * s.size;
    ink.line({{room.left, rule}, {room.right, rule}}, ink.theme().ink(Role::grid), ink.sizes().hairline);
  }
}

}  // namespace isect::viz
