// Well-known text (OGC 06-103r4): polygons, one after the other, each with an SRID before it if it has one.

#include <array>
#include <utility>

#include "app/scene/files/polygon_builder.h"
#include "app/scene/files/reading.h"

namespace isect::program::scene {

namespace {

class WktReader {
 public:
  WktReader(const std::string& bytes, const std::string& file)
      : text_(bytes, file), polygons_([this](const std::string& why) { text_.refuse(why); }) {}

  ShapeFile read() {
    while (!token().empty()) geometry(0);
    return polygons_.made();
  }

 private:
  /// Returns the next bracket, comma, semicolon or word without taking it; empty at the end.
  std::string_view token() {
    while (left_.empty()) {
      if (!text_.next()) return {};
      left_ = trimmed(text_.line());
    }
    const std::size_t end = std::min(left_.find_first_of("(),; \t\v\f"), left_.size());
    return left_.substr(0, std::max<std::size_t>(end, 1));
  }
  std::string_view take() {
    const std::string_view taken = token();
    left_ = trimmed(left_.substr(taken.size()));
    return taken;
  }
  bool take_if(std::string_view expected) {
    if (lower(token()) != expected) return false;
    take();
    return true;
  }
  void need(std::string_view expected) {
    if (!take_if(expected)) refuse_token(fmt::format("\"{}\"", expected));
  }
  [[noreturn]] void refuse_token(const std::string& expected) {
    const std::string_view found = token();
    text_.refuse(fmt::format("{} where {} is expected", found.empty() ? "the end" : in_quotes(found), expected));
  }

  void geometry(int level) {
    if (lower(token()).starts_with("srid=")) take(), need(";");
    const std::string type = lower(take());
    const bool many = type.starts_with("multipolygon"),
               collection = type.starts_with("geometrycollection") && level < 8;
    if (!many && !collection && !type.starts_with("polygon")) refuse_type(type);
    std::string tag = type.substr(many ? 12 : collection ? 18 : 7);  // z, m or zm, after a blank or not
    for (const char* const apart : {"zm", "z", "m"})
      if (tag.empty() && take_if(apart)) tag = apart;
    if (!tag.empty() && tag != "zm" && tag != "z" && tag != "m") refuse_type(type);
    numbers_ = tag.empty() ? 0 : 2 + tag.size(), last_is_measure_ = tag.ends_with('m');
    if (collection) return each([&] { geometry(level + 1); });
    return many ? each([&] { polygon(); }) : polygon();
  }
  [[noreturn]] void refuse_type(const std::string& type) const {
    text_.refuse(fmt::format("{}; POLYGON and MULTIPOLYGON are read, and collections of them", in_quotes(type)));
  }

  /// Reads what stands in brackets, between commas, or EMPTY.
  template <class One>
  void each(const One& one) {
    if (take_if("empty")) return;
    need("(");
    do one();
    while (take_if(","));
    need(")");
  }

  void polygon() {
    bool begun = false;
    each([&] {
      if (!std::exchange(begun, true)) polygons_.begin_polygon();
      polygons_.begin_ring();
      each([&] { position(); });
      polygons_.end_ring();
    });
  }

  void position() {
    std::array<double, 4> numbers = {};
    std::size_t count = 0;
    while (count < 4 && token() != "," && token() != ")") numbers[count++] = text_.real(take());
    if (count < 2 || count > (numbers_ == 0 ? 3 : numbers_) || (numbers_ != 0 && count < numbers_))
      text_.refuse(fmt::format("{} numbers; {} expected", count,
                               numbers_ == 0 ? "two or three are" : fmt::format("{} are", numbers_)));
    const std::size_t coordinates = count - (last_is_measure_ ? 1 : 0);
    viz::Vec3 p = viz::Vec3::Zero();
    for (std::size_t i = 0; i < coordinates; ++i) p[static_cast<int>(i)] = numbers[i];
    polygons_.position(p, coordinates);
  }

  TextFile text_;
  std::string_view left_;  ///< of the line
  PolygonBuilder polygons_;
  std::size_t numbers_ = 0;  ///< per position; 0: not known
  bool last_is_measure_ = false;
};

}  // namespace

ShapeFile read_wkt(const std::string& bytes, const std::string& file) { return WktReader(bytes, file).read(); }

}  // namespace isect::program::scene
