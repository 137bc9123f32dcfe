// OFF, as text: a word such as OFF or COFF, the numbers of points, faces and edges, the points, the faces.

#include "app/scene/files/mesh_builder.h"
#include "app/scene/files/reading.h"

namespace isect::program::scene {

namespace {

class OffReader {
 public:
  OffReader(const std::string& bytes, const std::string& file)
      : text_(bytes, file), mesh_(file, {.of_face = "line", .first_point = 0}) {}

  ShapeFile read() {
    need_line("OFF");
    const std::string_view first = text_.word();
    const bool has_word = first.find_first_not_of("0123456789") != first.npos;
    if (has_word) check_word(first);
    if (has_word && text_.ended()) need_line("how many points and faces there are");
    const long points = text_.whole(has_word ? text_.word() : first), faces = text_.whole(text_.word());
    if (!text_.ended()) text_.whole(text_.word());  // edges, which are ignored
    text_.end_line();
    for (const long count : {points, faces})
      if (count < 0 || count > static_cast<long>(most_in_file))
        text_.refuse(fmt::format("{} points or faces, and {} are the most", count, most_in_file));
    for (long i = 0; i < points; ++i) point(i, points);
    for (long i = 0; i < faces; ++i) face(i, faces);
    if (next()) text_.refuse(fmt::format("more than the {} points and {} faces that it announces", points, faces));
    return mesh_.made();
  }

 private:
  /// Goes to the next line that is not empty.
  bool next() {
    while (text_.next()) {
      text_.drop_comment("#");
      if (!text_.ended()) return true;
    }
    return false;
  }
  void need_line(const std::string& of) {
    if (!next()) text_.refuse("it ends early: " + of + " is expected");
  }

  /// Checks the word [ST][C][N]OFF: points may have textures, colours or normals, too.
  void check_word(std::string_view word) {
    std::string_view kind = word;
    for (const std::string_view part : {"ST", "C", "N"})
      if (kind.starts_with(part)) kind.remove_prefix(part.size());
    if (lower(kind) != "off")
      text_.refuse(fmt::format("{}; OFF, or STOFF, COFF, NOFF and their like in space are expected", in_quotes(word)));
    const std::string_view line = text_.line();
    if (lower(line.substr(0, line.find('#'))).find("binary") != std::string::npos)
      text_.refuse("a binary OFF; one of text is expected");
  }

  void point(long i, long count) {
    need_line(fmt::format("point {} of {}", i + 1, count));
    mesh_.add(text_.point(), text_.number());
    while (!text_.ended()) text_.real();  // normal, colour, texture
  }

  void face(long i, long count) {
    need_line(fmt::format("face {} of {}", i + 1, count));
    const long corners = text_.whole(text_.word());
    if (corners < 1) text_.refuse(fmt::format("a face of {} vertices", corners));
    if (corners < 3)
      mesh_.leave_out(text_.number());
    else
      mesh_.begin_face(text_.number());
    for (long k = 0; k < corners; ++k) {
      const long corner = text_.whole(text_.word());
      if (corners >= 3) mesh_.corner(corner);
    }
    while (!text_.ended()) text_.real();  // colour
  }

  TextFile text_;
  MeshBuilder mesh_;
};

}  // namespace

ShapeFile read_off(const std::string& bytes, const std::string& file) { return OffReader(bytes, file).read(); }

}  // namespace isect::program::scene
