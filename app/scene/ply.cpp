#include "app/scene/shape_file_parts.h"

namespace isect::program::scene {

namespace {

using viz::Vec3;

/// A PLY's header, then its elements, in text or binary.
class Ply {
 public:
  Ply(const std::string& bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  ShapeFile read() {
    header();
    if (format_ == "ascii") {
      std::size_t row = 0, element = 0;
      const std::string body = bytes_.substr(body_);
      int skipped =
          static_cast<int>(std::count(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(body_), '\n'));
      int number = 0;
      for (std::size_t at = 0; at < body.size();) {
        const std::size_t end = std::min(body.find('\n', at), body.size());
        Line line(std::string_view(body).substr(at, end - at), file_, skipped + ++number);
        at = end + 1;
        if (line.ended()) continue;
        while (element < elements_.size() && row == elements_[element].count) ++element, row = 0;
        if (element == elements_.size()) break;
        take(elements_[element], [&](const std::string&) { return line.number(line.word()); });
        ++row;
      }
      while (element < elements_.size() && row == elements_[element].count) ++element, row = 0;
      if (element < elements_.size()) refuse(file_, "it ends early");
    } else {
      Bytes data(bytes_, file_, body_, format_ == "binary_big_endian");
      for (const Element& e : elements_)
        for (std::size_t i = 0; i < e.count; ++i) take(e, [&](const std::string& type) { return number(data, type); });
    }
    return std::move(shape_);
  }

 private:
  struct Property {
    std::string name, type, counted_by = {};  ///< the latter: of a list
  };
  struct Element {
    std::string name;
    std::size_t count = 0;
    std::vector<Property> properties = {};
  };

  void header() {
    if (!bytes_.starts_with("ply")) refuse(file_, "line 1: \"ply\" is expected");
    bool ended = false;
    std::size_t at = 0;
    for (int number = 1; !ended; ++number) {
      const std::size_t end = bytes_.find('\n', at);
      if (end == bytes_.npos) refuse(file_, "its header does not end");
      Line line(std::string_view(bytes_).substr(at, end - at), file_, number);
      at = end + 1;
      const std::string_view keyword = line.word();
      if (keyword == "format") format_ = line.word();
      if (keyword == "element") {
        Element e = {std::string(line.word())};
        const long count = line.whole(line.word());
        if (count < 0 || static_cast<std::size_t>(count) > most_in_file)
          line.refuse(fmt::format("{} elements, and {} are the most", count, most_in_file));
        e.count = static_cast<std::size_t>(count);
        elements_.push_back(std::move(e));
      }
      if (keyword == "property") {
        if (elements_.empty()) line.refuse("a property of no element");
        Property p;
        p.type = line.word();
        if (p.type == "list") p.counted_by = line.word(), p.type = line.word();
        p.name = line.word();
        elements_.back().properties.push_back(p);
      }
      ended = keyword == "end_header";
    }
    body_ = at;
    if (format_ != "ascii" && format_ != "binary_little_endian" && format_ != "binary_big_endian")
      refuse(file_,
             fmt::format("format \"{}\"; ascii, binary_little_endian or binary_big_endian is expected", format_));
  }

  template <class Next>
  void take(const Element& e, const Next& next) {
    Vec3 p = Vec3::Zero();
    for (const Property& property : e.properties) {
      if (property.counted_by.empty()) {
        const double value = next(property.type);
        for (int i = 0; i < 3; ++i)
          if (property.name == std::string(1, "xyz"[i])) p[i] = value;
        continue;
      }
      const double size = next(property.counted_by);
      if (!(size >= 0 && size <= 1000)) refuse(file_, fmt::format("a list of {} entries; 1000 are the most", size));
      std::vector<int> corners;
      for (int i = 0; i < static_cast<int>(size); ++i) {
        const double index = next(property.type);
        const bool is_corner = property.name == "vertex_indices" || property.name == "vertex_index";
        if (!is_corner) continue;
        if (!(index >= 0 && index < static_cast<double>(shape_.points.size())))
          refuse(file_, fmt::format("a face of vertex {}, and there are {}", index, shape_.points.size()));
        corners.push_back(static_cast<int>(index));
      }
      if (!corners.empty()) add_face(shape_, corners);
    }
    if (e.name != "vertex") return;
    if (!p.allFinite())
      refuse(file_, fmt::format("vertex {} has a coordinate that is no finite number", shape_.points.size()));
    shape_.points.push_back(p);
  }

  double number(Bytes& data, const std::string& type) const {
    if (type == "char" || type == "int8") return data.next<std::int8_t>();
    if (type == "uchar" || type == "uint8") return data.next<std::uint8_t>();
    if (type == "short" || type == "int16") return data.next<std::int16_t>();
    if (type == "ushort" || type == "uint16") return data.next<std::uint16_t>();
    if (type == "int" || type == "int32") return data.next<std::int32_t>();
    if (type == "uint" || type == "uint32") return data.next<std::uint32_t>();
    if (type == "float" || type == "float32") return data.next<float>();
    if (type == "double" || type == "float64") return data.next<double>();
    refuse(file_, fmt::format("\"{}\" is no type of a PLY", type));
  }

  const std::string& bytes_;
  const std::string& file_;
  std::string format_;
  std::vector<Element> elements_;
  std::size_t body_ = 0;
  ShapeFile shape_;
};

}  // namespace

ShapeFile ply(const std::string& bytes, const std::string& file) { return Ply(bytes, file).read(); }

}  // namespace isect::program::scene
