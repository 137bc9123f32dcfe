// STL, text and binary. Facets share corners by their coordinates.

#include <bit>
#include <cstdint>
#include <functional>
#include <unordered_map>

#include "app/scene/files/mesh_builder.h"
#include "app/scene/files/reading.h"

namespace isect::program::scene {

namespace {

using viz::Vec3;

class StlReader {
 public:
  StlReader(const std::string& bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  ShapeFile read() { return is_text() ? text() : binary(); }

 private:
  static constexpr std::size_t head = 84, facet = 50;

  /// Whether the file is text: some binary files begin with "solid", too, but no text has a byte 0.
  bool is_text() const {
    if (bytes_.find('\0') != bytes_.npos) return false;
    TextFile text(bytes_, file_);
    while (text.next())
      if (!text.ended()) return lower(text.word()) == "solid";
    return false;
  }

  ShapeFile binary() {
    if (bytes_.size() < head)
      refuse(file_, "neither a text that begins with solid nor a binary STL, of 84 bytes at least");
    const auto count = Bytes(bytes_, file_, head - 4).next<std::uint32_t>();
    const std::uint64_t size = head + facet * std::uint64_t{count};
    const auto told = [&] { return fmt::format("a binary STL of {} facets has {} bytes", count, size); };
    if (bytes_.size() < size || bytes_.size() >= size + facet)
      refuse(
          file_,
          fmt::format("neither a text that begins with solid nor a binary STL of its length: {}, and this file has {}",
                      told(), bytes_.size()));
    MeshBuilder mesh(file_, {.of_face = "facet", .first_point = 0});
    Bytes data(bytes_, file_, head);
    for (std::uint32_t i = 0; i < count; ++i) {
      const int place = static_cast<int>(i) + 1;
      mesh.begin_face(place);
      data.skip(12);  // the normal
      for (int corner = 0; corner < 3; ++corner) {
        Vec3 p;
        for (int k = 0; k < 3; ++k) p[k] = data.next<float>();
        if (!p.allFinite()) refuse(file_, fmt::format("facet {}: a coordinate that is no finite number", place));
        add(mesh, p, place);
      }
      data.skip(2);
    }
    ShapeFile shape = mesh.made();
    if (data.left() > 0) shape.note = bytes_left_out(data.left(), "facet");
    return shape;
  }

  /// Reads solid NAME; facet normal x y z, outer loop, three times vertex x y z, endloop, endfacet; endsolid NAME.
  ShapeFile text() {
    TextFile text(bytes_, file_);
    MeshBuilder mesh(file_, {.of_face = "line", .first_point = 0});
    std::string expected = "solid";
    int vertices = 0;
    while (text.next()) {
      if (text.ended()) continue;
      std::string keyword = lower(text.word());
      if (keyword == "end") keyword += lower(text.word());
      const bool is_end = expected == "facet" && keyword == "endsolid";
      if (keyword != expected && !is_end)
        text.refuse(fmt::format("{} where {} is expected", in_quotes(keyword),
                                expected == "facet" ? "facet or endsolid" : expected));
      if (is_end) {
        expected = "solid";  // another solid
      } else if (keyword == "solid") {
        if (lower(text.line()).find(" facet normal ") != std::string::npos)
          text.refuse("a solid and its facets on one line");
        expected = "facet";
      } else if (keyword == "facet") {
        normal(text);
        expected = "outer", vertices = 0;
        mesh.begin_face(text.number());
      } else if (keyword == "outer") {
        if (lower(text.word()) != "loop") text.refuse("\"outer loop\" is expected");
        text.end_line();
        expected = "vertex";
      } else if (keyword == "vertex") {
        add(mesh, text.point(), text.number());
        text.end_line();
        if (++vertices == 3) expected = "endloop";
      } else {
        text.end_line();
        expected = keyword == "endloop" ? "endfacet" : "facet";
      }
    }
    if (expected != "solid")
      text.refuse(fmt::format("it ends where {} is expected", expected == "facet" ? "endsolid" : expected));
    return mesh.made();
  }

  /// Skips a normal, which is not used, so it may be any, or none.
  static void normal(TextFile& text) {
    if (text.ended()) return;
    if (lower(text.word()) != "normal") text.refuse("\"facet normal\" is expected");
    for (int i = 0; i < 3; ++i) text.word();
    text.end_line();
  }

  void add(MeshBuilder& mesh, const Vec3& p, int place) {
    const auto [found, is_new] =
        known_.try_emplace({p.x() + 0.0, p.y() + 0.0, p.z() + 0.0}, static_cast<long>(mesh.count()));
    if (is_new) mesh.add(p, place);
    mesh.corner(found->second);
  }

  struct Hash {
    std::size_t operator()(const std::array<double, 3>& p) const {
      std::uint64_t hash = 0;
      for (const double x : p) hash = (std::rotl(hash, 27) ^ std::bit_cast<std::uint64_t>(x)) * 0x9E3779B97F4A7C15u;
      return static_cast<std::size_t>(hash ^ hash >> 32);
    }
  };

  const std::string& bytes_;
  const std::string& file_;
  std::unordered_map<std::array<double, 3>, long, Hash> known_;  ///< points; -0 is 0
};

}  // namespace

ShapeFile read_stl(const std::string& bytes, const std::string& file) { return StlReader(bytes, file).read(); }

}  // namespace isect::program::scene
