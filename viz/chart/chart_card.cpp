// A card of text: heads in a column, and a text beside each.

#include <algorithm>

#include "viz/chart/chart_parts.h"
#include "viz/compose/paper.h"
#include "viz/text/rich_text.h"

namespace isect::viz {
namespace {

constexpr double card_pitch = 1.45;     // from line to line, in sizes of the text
constexpr double row_gap = 0.75;        // from row to row, beyond that
constexpr double most_enlarged = 1.25;  // of a label's size
constexpr double narrow = 12;           // in sizes: a text with less room stands below its head
constexpr std::size_t many = 12;        // rows: as many may stand in several columns
constexpr std::size_t most_columns = 3;

/// A word, or words that must stay together, and their width at size 1.
using Word = std::pair<std::string, double>;

std::vector<Word> words_of(const ChartInk& ink, const std::string& markup) {
  std::vector<Word> all;
  for (const std::string& part : unbreakable(markup)) all.emplace_back(part, ink.width(part, 1));
  return all;
}

/// Breaks the text into as few lines as fit into `room`, in sizes of the text.
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

/// The card's texts at one size, in one column or several, whose rows follow each other downwards.
struct Typeset {
  double size, column;  ///< where the texts begin; 0: below their heads
  std::vector<std::vector<std::string>> lines;
  std::size_t columns = 1, rows = 0;  ///< in a column
  double height = 0;                  ///< of the highest one
};

class Typesetter {
 public:
  Typesetter(const ChartInk& ink, const Card& card) : label_(ink.sizes().label), one_size_(has_one_size(ink.theme())) {
    for (const Card::Row& row : card.rows) {
      column_ = std::max(column_, ink.width(row.head, 1, true) + 1.2);
      texts_.push_back(words_of(ink, row.text));
    }
  }

  Typeset at(double size, double width, std::size_t columns = 1) const {
    const double own = (width - gutter(columns)) / static_cast<double>(columns);
    const double column = own / size - column_ < narrow ? 0 : column_;
    Typeset s{size, column * size, {}, columns, (texts_.size() + columns - 1) / columns};
    double height = 0;
    for (const std::vector<Word>& text : texts_) {
      if (s.lines.size() % s.rows == 0) height = 0;
      s.lines.push_back(broken(text, own / size - column));
      const std::size_t lines = s.lines.back().size() + (column > 0 ? 0 : 1);
      height += (card_pitch * static_cast<double>(std::max<std::size_t>(lines, 1)) + row_gap) * size;
      s.height = std::max(s.height, height - row_gap * size);
    }
    return s;
  }

  /// Returns the card at the largest size that fits, with as few columns as that takes.
  Typeset within(const Bounds& room) const {
    Typeset best = within(room, 1);
    for (std::size_t columns = 2; columns <= most_columns && texts_.size() >= many; ++columns)
      if (Typeset s = within(room, columns); s.size > 1.05 * best.size || (one_size_ && s.height < best.height))
        best = std::move(s);
    return best;
  }

  double gutter(std::size_t columns) const { return 2 * label_ * static_cast<double>(columns - 1); }

 private:
  Typeset within(const Bounds& room, std::size_t columns) const {
    double share = most_enlarged;
    const auto next = [&] { return at(share * label_, room.right - room.left, columns); };
    if (one_size_) return at(label_, room.right - room.left, columns);
    Typeset s = next();
    while (s.height > room.bottom - room.top && share > 0.3) share *= 0.97, s = next();
    return s;
  }

  double label_, column_ = 0;
  bool one_size_;
  std::vector<std::vector<Word>> texts_;
};

}  // namespace

/// Returns the width of a card's empty margin on either side.
static double side_of(const ChartInk& ink, double width) { return std::min(1.5 * ink.sizes().label, 0.04 * width); }

double natural_height(const ChartInk& ink, const Card& card, double whole) {
  const Typesetter typesetter(ink, card);
  const double width = whole - 2 * side_of(ink, whole);
  double least = typesetter.at(ink.sizes().label, width).height;
  for (std::size_t columns = 2; columns <= most_columns && card.rows.size() >= many; ++columns)
    least = std::min(least, typesetter.at(ink.sizes().label, width, columns).height);
  return least;
}

void draw(ChartInk& ink, const Card& card, const Bounds& all) {
  const double side = side_of(ink, all.right - all.left);
  const Bounds room = {all.left + side, all.top, all.right - side, all.bottom};
  const Typesetter typesetter(ink, card);
  const Typeset s = typesetter.within(room);
  const double top = room.top + std::max(0.0, (room.bottom - room.top - s.height) / 2) + s.size;
  const double gutter = typesetter.gutter(2);
  const double width = (room.right - room.left - typesetter.gutter(s.columns)) / static_cast<double>(s.columns);
  double y = top;
  for (std::size_t i = 0; i < card.rows.size(); ++i) {
    const auto& [head, text] = card.rows[i];
    const double left = room.left + static_cast<double>(i / s.rows) * (width + gutter);
    if (i % s.rows == 0) y = top;
    ink.part("row", head);
    ink.text(head, {left, y}, {s.size, Role::first, 0, true});
    if (s.column == 0) y += card_pitch * s.size;
    for (const std::string& line : s.lines[i]) {
      ink.text(line, {left + s.column, y}, {s.size});
      y += card_pitch * s.size;
    }
    y += row_gap * s.size;
    if (i + 1 == card.rows.size() || (i + 1) % s.rows == 0) continue;
    const double rule = y - s.size - 0.5 * row_gap * s.size + 0.1 * s.size;
    ink.line({{left, rule}, {left + width, rule}}, ink.theme().ink(Role::grid), ink.sizes().hairline);
  }
}

}  // namespace isect::viz
