// PLY, text and binary: the points of its element vertex, the faces of face, the strips of tristrips.

#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <type_traits>
#include <utility>

#include "app/scene/files/mesh_builder.h"
#include "app/scene/files/reading.h"

namespace isect::program::scene {

namespace {

using viz::Vec3;

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::int8;
  std::optional<PlyType> counted_by = {};  ///< of a list
};
struct PlyElement {
  std::string name;
  long count = 0;
  std::vector<PlyProperty> properties = {};
};

/// Reads the header, then the data as it says.
class PlyReader {
 public:
  PlyReader(const std::string& bytes, const std::string& file) : bytes_(bytes), file_(file), text_(bytes, file) {}

  ShapeFile read() {
    header();
    MeshBuilder mesh(file_, {.of_face = format_ == "ascii" ? "line" : "face", .first_point = 0});
    mesh_ = &mesh;
    if (format_ == "ascii")
      of_text();
    else
      of_bytes();
    ShapeFile shape = mesh.made();
    shape.flat = flat_;
    if (!note_.empty()) shape.note += (shape.note.empty() ? "" : " ") + note_;
    return shape;
  }

 private:
  // The header.

  void header() {
    if (!text_.next() || text_.word() != "ply") text_.refuse("\"ply\" is expected");
    text_.end_line();
    const bool lines_end_by_cr = bytes_.substr(text_.offset() - 1, 1) == "\r";
    for (std::string_view keyword; keyword != "end_header";) {
      if (!text_.next()) refuse(file_, "its header does not end");
      keyword = text_.word();
      if (keyword == "comment" || keyword == "obj_info" || text_.line().empty()) continue;
      if (keyword == "format")
        format();
      else if (keyword == "element")
        element();
      else if (keyword == "property")
        property();
      else if (keyword != "end_header")
        text_.refuse(fmt::format("{} begins no line of a PLY's header", in_quotes(keyword)));
      text_.end_line();
    }
    body_ = text_.offset();
    if (lines_end_by_cr && bytes_.substr(body_ - 2, 2) == "\r\n") --body_;  // the first byte of the data is 10
    if (format_.empty()) refuse(file_, "its header names no format");
    check_points();
  }

  void format() {
    format_ = text_.word();
    if (format_ != "ascii" && format_ != "binary_little_endian" && format_ != "binary_big_endian")
      text_.refuse(
          fmt::format("format {}; ascii, binary_little_endian or binary_big_endian is expected", in_quotes(format_)));
    if (const std::string_view version = text_.word(); version != "1.0")
      text_.refuse(fmt::format("version {}; 1.0 is expected", in_quotes(version)));
  }

  void element() {
    PlyElement e = {std::string(text_.word())};
    if (std::ranges::find(elements_, e.name, &PlyElement::name) != elements_.end())
      text_.refuse(fmt::format("two elements are called {}", in_quotes(e.name)));
    e.count = text_.whole(text_.word());
    if (e.count < 0 || e.count > static_cast<long>(most_in_file))
      text_.refuse(fmt::format("{} elements, and {} are the most", e.count, most_in_file));
    elements_.push_back(std::move(e));
  }

  void property() {
    if (elements_.empty()) text_.refuse("a property of no element");
    PlyElement& e = elements_.back();
    PlyProperty p;
    std::string_view word = text_.word();
    if (word == "list") p.counted_by = type(text_.word()), word = text_.word();
    p.type = type(word);
    p.name = text_.word();
    if (std::ranges::find(e.properties, p.name, &PlyProperty::name) != e.properties.end())
      text_.refuse(fmt::format("two properties are called {}", in_quotes(p.name)));
    if (p.counted_by && (*p.counted_by == PlyType::float32 || *p.counted_by == PlyType::float64))
      text_.refuse("a list that is counted by no whole number");
    if (is_corners(p) && e.name != "face" && e.name != "tristrips")
      text_.refuse(fmt::format("vertices of the element {}; those of face and tristrips are read", in_quotes(e.name)));
    e.properties.push_back(std::move(p));
  }

  PlyType type(std::string_view word) const {
    static const std::map<std::string_view, PlyType> all = {
        {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
        {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
        {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
        {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
        {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
        {"float64", PlyType::float64}};
    const auto found = all.find(word);
    if (found == all.end()) text_.refuse(fmt::format("{} is no type of a PLY", in_quotes(word)));
    return found->second;
  }

  static bool is_corners(const PlyProperty& p) {
    return p.counted_by && (p.name == "vertex_indices" || p.name == "vertex_index");
  }

  /// Checks that there are x and y, and z unless the points are in the plane.
  void check_points() {
    for (const PlyElement& e : elements_) {
      const auto has = [&](const char* name) {
        return std::ranges::any_of(e.properties, [&](const PlyProperty& p) { return p.name == name && !p.counted_by; });
      };
      if (e.name == "vertex" && (!has("x") || !has("y"))) refuse(file_, "its vertices have no properties x and y");
      if (e.name == "vertex") flat_ = !has("z");
      if ((e.name == "face" || e.name == "tristrips") && e.count > 0 && std::ranges::none_of(e.properties, is_corners))
        refuse(file_, fmt::format("its element {} has no list vertex_indices", in_quotes(e.name)));
    }
  }

  // The elements.

  void of_text() {
    for (const PlyElement& e : elements_)
      for (long i = 0; i < e.count; ++i) {
        do {
          if (!text_.next()) refuse(file_, fmt::format("it ends early, before {} {} of {}", e.name, i + 1, e.count));
        } while (text_.ended());
        take(e, text_.number(), [&](PlyType type) { return number(text_, text_.word(), type); });
        text_.end_line();
      }
    while (text_.next())
      if (!text_.ended()) text_.refuse("more than the elements that its header announces");
  }

  void of_bytes() {
    Bytes data(bytes_, file_, body_, format_ == "binary_big_endian");
    for (const PlyElement& e : elements_)
      for (long i = 0; i < e.count; ++i)
        take(e, static_cast<int>(i) + 1, [&](PlyType type) { return number(data, type); });
    const std::string_view left = std::string_view(bytes_).substr(bytes_.size() - data.left());
    if (left.find_first_not_of("\r\n") != left.npos) note_ = bytes_left_out(left.size(), "element");
  }

  /// Calls what(0) with a number of that type.
  template <class What>
  static double as(PlyType type, const What& what) {
    switch (type) {
      case PlyType::int8:
        return what(std::int8_t());
      case PlyType::uint8:
        return what(std::uint8_t());
      case PlyType::int16:
        return what(std::int16_t());
      case PlyType::uint16:
        return what(std::uint16_t());
      case PlyType::int32:
        return what(std::int32_t());
      case PlyType::uint32:
        return what(std::uint32_t());
      case PlyType::float32:
        return what(float());
      case PlyType::float64:
        return what(double());
    }
    return 0;
  }

  /// Returns a number. A whole one must be in its type's range. One not finite is refused only as a coordinate.
  static double number(const TextFile& text, std::string_view word, PlyType type) {
    return as(type, [&]<class T>(T) -> double {
      if constexpr (std::is_integral_v<T>) {
        using Range = std::numeric_limits<T>;
        const long value = text.whole(word);
        if (!std::in_range<T>(value))
          text.refuse(fmt::format("{} is beyond its type, {} to {}", value, +Range::min(), +Range::max()));
        return static_cast<double>(value);
      } else {
        const std::string small = lower(word.substr(word.find_first_not_of("+-") == 1 ? 1 : 0));
        return small == "nan" || small == "inf" || small == "infinity" ? HUGE_VAL : text.real(word);
      }
    });
  }
  static double number(Bytes& data, PlyType type) {
    return as(type, [&]<class T>(T) -> double { return data.next<T>(); });
  }

  template <class Next>
  void take(const PlyElement& e, int place, const Next& next) {
    const bool vertex = e.name == "vertex", strips = e.name == "tristrips";
    Vec3 p = Vec3::Zero();
    for (const PlyProperty& property : e.properties) {
      if (!property.counted_by) {
        const double value = next(property.type);
        if (vertex && property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z')
          p[property.name[0] - 'x'] = value;
        continue;
      }
      const double size = next(*property.counted_by);
      if (!(size >= 0)) wrong(e, place, fmt::format("a list of {} entries", size));
      const bool face = is_corners(property) && !strips;
      if (face) mesh_->begin_face(place);
      strip_.clear();
      for (double i = 0; i < size; ++i) {
        const double value = next(property.type);
        if (!is_corners(property)) continue;
        if (value != std::trunc(value) || std::abs(value) > 1e15)
          wrong(e, place, fmt::format("vertex {}, which is no whole number", value));
        if (face)
          mesh_->corner(static_cast<long>(value));
        else
          strip_corner(e, static_cast<long>(value), place);
      }
      if (is_corners(property) && strips) strip_corner(e, -1, place);
    }
    if (!vertex) return;
    if (!p.allFinite()) wrong(e, place, "a coordinate that is no finite number");
    mesh_->add(p, place);
  }

  /// Each corner makes a triangle with the two before it, with alternating orientation; -1 ends a strip. A triangle
  /// with a repeated corner only leads from one part to the next.
  void strip_corner(const PlyElement& e, long corner, int place) {
    if (corner == -1) {
      if (strip_.size() == 1 || strip_.size() == 2) wrong(e, place, "a strip of fewer than three vertices");
      return strip_.clear();
    }
    strip_.push_back(corner);
    if (strip_.size() < 3) return;
    const long a = strip_[strip_.size() - 3], b = strip_[strip_.size() - 2];
    if (a == b || b == corner || a == corner) return;
    const bool odd = strip_.size() % 2 == 0;
    mesh_->begin_face(place);
    for (const long i : {odd ? b : a, odd ? a : b, corner}) mesh_->corner(i);
  }

  [[noreturn]] void wrong(const PlyElement& e, int place, const std::string& why) const {
    if (format_ == "ascii") text_.refuse(why);
    refuse(file_, fmt::format("{} {}: {}", e.name, place, why));
  }

  const std::string& bytes_;
  const std::string& file_;
  TextFile text_;
  std::string format_, note_;
  std::vector<PlyElement> elements_;
  std::size_t body_ = 0;
  bool flat_ = false;
  MeshBuilder* mesh_ = nullptr;
  std::vector<long> strip_;
};

}  // namespace

ShapeFile read_ply(const std::string& bytes, const std::string& file) { return PlyReader(bytes, file).read(); }

}  // namespace isect::program::scene
