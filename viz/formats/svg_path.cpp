#include "viz/formats/svg_path.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdlib>

namespace isect::viz {
namespace {

/// Returns a number with at most `digits` after the point, and nothing superfluous: "12", "-0.5".
std::string short_number(double x, int digits) {
  std::string text = fmt::format("{:.{}f}", x, digits);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

/// Writes points relative to the one before as it was written, so that no error grows along the way.
class RelativePen {
 public:
  void move(const Vec2& p) { out_ += started_ ? 'm' : 'M', tell(p), now_ = to_, started_ = true; }
  void line(const Vec2& p) { out_ += 'l', tell(p), now_ = to_; }
  void curve(const Path::Cubic& c) {
    out_ += 'c';
    for (const Vec2& p : {c.control1, c.control2, c.to}) tell(p);
    now_ = to_;
  }
  void close(const Vec2& start) { out_ += 'z', now_ = rounded(start); }
  std::string take() { return std::move(out_); }

 private:
  /// Rounds to hundredths, and returns their number.
  static Vec2 rounded(const Vec2& p) { return (100 * p).array().round(); }
  void tell(const Vec2& p) {
    to_ = rounded(p);
    for (const double x : {to_.x() - now_.x(), to_.y() - now_.y()}) {
      if (x >= 0 && !std::isalpha(static_cast<unsigned char>(out_.back()))) out_ += ' ';
      if (std::abs(x) < 1e15)
        tell(static_cast<long long>(x));
      else
        out_ += fmt::format("{:.0f}", x / 100);
    }
  }
  void tell(long long hundredths) {
    if (hundredths < 0) out_ += '-';
    const auto [whole, part] = std::div(std::abs(hundredths), 100LL);
    char digits[20];
    out_.append(digits, std::to_chars(digits, digits + sizeof digits, whole).ptr);
    if (part == 0) return;
    out_ += '.', out_ += static_cast<char>('0' + part / 10);
    if (part % 10 != 0) out_ += static_cast<char>('0' + part % 10);
  }

  std::string out_;
  Vec2 now_ = Vec2::Zero(), to_ = Vec2::Zero();  ///< in hundredths
  bool started_ = false;
};

}  // namespace

std::string svg_number(double x) { return short_number(x, 3); }

std::string svg_paint(const std::string& what, const Colour& c) {
  std::string style = fmt::format("{}:{};", what, hex_of(c));
  if (c.a < 1) style += fmt::format("{}-opacity:{};", what, svg_number(c.a));
  return style;
}

std::string svg_path(const Path& path) {
  const auto point = [](const Vec2& p) { return svg_number(p.x()) + " " + svg_number(p.y()); };
  std::string d = fmt::format("M {}", point(path.start));
  for (const Path::Segment& segment : path.segments) {
    if (const Vec2* to = std::get_if<Vec2>(&segment)) {
      d += fmt::format(" L {}", point(*to));
    } else {
      const auto& [a, b, end] = std::get<Path::Cubic>(segment);
      d += fmt::format(" C {} {} {}", point(a), point(b), point(end));
    }
  }
  return path.closed ? d + " Z" : d;
}

std::string svg_letters(const std::vector<Path>& outlines) {
  RelativePen pen;
  for (const Path& path : outlines) {
    pen.move(path.start);
    for (const Path::Segment& segment : path.segments) {
      if (const Vec2* to = std::get_if<Vec2>(&segment))
        pen.line(*to);
      else
        pen.curve(std::get<Path::Cubic>(segment));
    }
    if (path.closed) pen.close(path.start);
  }
  return pen.take();
}

std::string base64(const std::string& bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) { return k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0u; };
    const unsigned group = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    for (unsigned k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : digits[group >> (18 - 6 * k) & 63];
  }
  return text;
}

std::string svg_address(const std::string& svg) { return "data:image/svg+xml;base64," + base64(svg); }

std::string xml_escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '\'':
        out += "&apos;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\t' ? ' ' : c;
    }
  }
  return out;
}

}  // namespace isect::viz
