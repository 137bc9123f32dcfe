// CSV and similar formats: one point per line, its numbers separated by commas, semicolons, tabs or blanks.

#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <vector>

#include "app/scene/files/reading.h"
#include "viz/lang/message.h"

namespace isect::program::scene {

namespace {

using viz::Vec3;

constexpr const char* header_expected = "a first row of names calls two columns x and y, or three x, y and z";

class TableReader {
 public:
  /// `takes_more`: names are not required for numbers after the third one, such as a colour.
  TableReader(const std::string& bytes, const std::string& file, bool takes_more)
      : text_(bytes, file), takes_more_(takes_more) {}

  ShapeFile read() {
    while (text_.next()) {
      if (text_.ended() || is_comment() || is_separator_line()) continue;
      if (!separator_) separator_ = separator_of(text_.line());
      split(text_.line(), row_);
      if (columns_ == 0) {
        if (is_header(row_)) continue;
        first_row(row_);
      }
      point(row_);
    }
    shape_.flat = !is_in_space_;
    return std::move(shape_);
  }

 private:
  // The separator of the fields.

  /// Whether it is Excel's own line: sep=;
  bool is_separator_line() {
    const std::string_view line = text_.line();
    if (text_.number() != 1 || line.size() != 5 || !lower(line).starts_with("sep=")) return false;
    separator_ = line.back();
    return true;
  }

  /// Returns the first of these that stands outside of quotes and before a comment; else blanks.
  static char separator_of(std::string_view line) {
    for (const char c : {';', '\t', ','}) {
      bool within = false;
      char before = ' ';
      for (const char at : line) {
        if (at == '"') within = !within;
        if (at == '#' && before == ' ' && !within) break;
        if (at == c && !within) return c;
        before = at;
      }
    }
    return ' ';
  }

  /// Splits a row into fields, without blanks and quotes around them; empty ones at its end do not count.
  void split(std::string_view line, std::vector<std::string_view>& fields) const {
    fields.clear();
    for (line = trimmed_of_blanks(line); !line.empty();) {
      if (*separator_ == ' ' && line.front() == '#') break;
      const bool has_quotes = line.front() == '"';
      const std::size_t closing = has_quotes ? closing_quote(line) : 0;
      const std::size_t end = std::min(end_of_field(line, closing), line.size());
      std::string_view field = trimmed(line.substr(0, end));
      if (has_quotes) {
        if (closing + 1 != field.size())
          text_.refuse(fmt::format("{}: a quote in the middle of a field", in_quotes(field)));
        field = trimmed(field.substr(1, closing - 1));
      } else if (const std::size_t comment = field.find(" #"); comment != field.npos) {
        field = trimmed(field.substr(0, comment)), line = line.substr(0, end);
      }
      fields.push_back(field);
      line.remove_prefix(std::min(end + 1, line.size()));
      line = trimmed_of_blanks(line);
    }
    while (!fields.empty() && fields.back().empty()) fields.pop_back();
  }
  std::size_t end_of_field(std::string_view line, std::size_t from) const {
    return *separator_ == ' ' ? line.find_first_of(" \t", from) : line.find(*separator_, from);
  }
  std::string_view trimmed_of_blanks(std::string_view line) const {
    const char* const passed = *separator_ == '\t' ? " " : " \t";
    line.remove_prefix(std::min(line.find_first_not_of(passed), line.size()));
    return line;
  }
  std::size_t closing_quote(std::string_view line) const {
    std::size_t at = 1;
    while (at = line.find('"', at), at != line.npos && line.substr(at, 2) == "\"\"") at += 2;
    if (at == line.npos) text_.refuse("a quote that does not end on its line");
    return at;
  }

  // Which columns are x, y and z.

  /// Whether the line is a comment; comments before the first row may name the columns.
  bool is_comment() {
    std::string_view line = trimmed(text_.line());
    for (const std::string_view mark : {"#", "//", "%"})
      if (line.starts_with(mark)) {
        line.remove_prefix(mark.size());
        if (columns_ == 0) comments_.push_back(line);
        return true;
      }
    return false;
  }

  /// Returns a column's name: x, X, "x [m]" and x(m) are x.
  static std::string column_name(std::string_view field) {
    return lower(trimmed(field.substr(0, field.find_first_of("[("))));
  }

  static bool is_coordinate(std::string_view field) {
    const std::string name = column_name(field);
    return name == "x" || name == "y" || name == "z";
  }

  bool is_header(const std::vector<std::string_view>& row) {
    std::array<std::optional<std::size_t>, 3> at;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string name = column_name(row[i]);
      if (name.size() != 1 || name[0] < 'x' || name[0] > 'z') continue;
      std::optional<std::size_t>& column = at[static_cast<std::size_t>(name[0] - 'x')];
      if (column) text_.refuse(fmt::format("two columns are called {}", name));
      column = i;
    }
    if (!at[0] || !at[1]) return false;
    at_ = {*at[0], *at[1], at[2].value_or(0)};
    is_in_space_ = at[2].has_value();
    columns_ = row.size(), has_names_ = true;
    return true;
  }

  /// Reads the first row if no row of names came before it; comments may have named the columns.
  void first_row(const std::vector<std::string_view>& row) {
    const std::size_t count = row.size();
    if (named_by_comments(count)) return;
    for (std::size_t i = 0; i < std::min<std::size_t>(count, 3); ++i)
      if (!number(row[i])) text_.refuse(fmt::format("{} is no finite number; {}", in_quotes(row[i]), header_expected));
    if (count < 2 || (count > 3 && !takes_more_))
      text_.refuse(
          fmt::format("{} number{}; two or three are expected, or {}", count, count == 1 ? "" : "s", header_expected));
    columns_ = count;
    is_in_space_ = count > 2;
    if (count > 3) shape_.note = viz::tr("What stands behind three numbers of a line is left out.");
  }

  /// Whether comments name the columns: the last one, whatever else it names, or one with only x, y and z. The
  /// separator of names may differ from that of numbers.
  bool named_by_comments(std::size_t count) {
    const char separator = *separator_;
    std::vector<std::string_view> names;
    for (std::size_t i = comments_.size(); i-- > 0 && columns_ == 0;) {
      std::string comment(comments_[i]);
      std::ranges::replace(comment, '"', ' ');
      for (const char c : {separator, ' ', ',', ';', '\t'}) {
        separator_ = c;
        split(comment, names);
        const bool only_coordinates = std::ranges::all_of(names, is_coordinate);
        if (names.size() == count && (only_coordinates || i + 1 == comments_.size()) && is_header(names)) break;
        if (only_coordinates && names.size() > 1 && names.size() != count &&
            !std::ranges::is_sorted(names, {}, column_name))
          text_.refuse(fmt::format("{} column{}, and a comment calls {}: {}", count, count == 1 ? "" : "s",
                                   names.size(), fmt::join(names, ", ")));
      }
    }
    separator_ = separator;
    return columns_ != 0;
  }

  // The numbers.

  void point(const std::vector<std::string_view>& row) {
    if (row.size() > columns_ || (row.size() < columns_ && !has_names_))
      text_.refuse(
          fmt::format("{} column{}, and {} in the first row", row.size(), row.size() == 1 ? "" : "s", columns_));
    if (shape_.points.size() == most_in_file) text_.refuse(fmt::format("more than {} points", most_in_file));
    Vec3 p = Vec3::Zero();
    for (std::size_t i = 0; i < (is_in_space_ ? 3 : 2); ++i) {
      if (at_[i] >= row.size() || row[at_[i]].empty()) text_.refuse(fmt::format("{} is missing", "xyz"[i]));
      const std::optional<double> x = number(row[at_[i]]);
      p[static_cast<int>(i)] = x ? *x : text_.real(row[at_[i]]);  // this refuses it
    }
    shape_.points.push_back(p);
  }

  /// Returns a number. Between semicolons or tabs a comma is a decimal one, as many countries write them: 0,5;1,25.
  std::optional<double> number(std::string_view field) const {
    const std::optional<double> x = decimal(field);
    if (x || (*separator_ != ';' && *separator_ != '\t') || field.find(',') == field.npos) return x;
    std::string with_point(field);
    with_point[field.find(',')] = '.';
    return decimal(with_point);
  }

  TextFile text_;
  bool takes_more_;
  ShapeFile shape_;
  std::optional<char> separator_;
  std::vector<std::string_view> row_;
  std::vector<std::string_view> comments_;  ///< before the first row
  std::size_t columns_ = 0;                 ///< 0 until there is a row
  bool has_names_ = false, is_in_space_ = false;
  std::array<std::size_t, 3> at_ = {0, 1, 2};
};

}  // namespace

ShapeFile read_table(const std::string& bytes, const std::string& file) {
  return TableReader(bytes, file, false).read();
}
ShapeFile read_xyz(const std::string& bytes, const std::string& file) { return TableReader(bytes, file, true).read(); }

}  // namespace isect::program::scene
