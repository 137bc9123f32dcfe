// Wavefront OBJ: points and faces. Names, materials, normals and textures do not change a shape; free-form surfaces are
// refused.

#include <array>

#include "app/scene/files/mesh_builder.h"
#include "app/scene/files/reading.h"

namespace isect::program::scene {

namespace {

/// Lines of names, groups, looks, normals and textures, which do not change a shape.
constexpr std::string_view look[] = {"vt",       "vn",     "g",          "o",        "s",     "mg",
                                     "usemtl",   "mtllib", "usemap",     "maplib",   "bevel", "c_interp",
                                     "d_interp", "lod",    "shadow_obj", "trace_obj"};
/// Lines of curves and curved surfaces, and of commands.
constexpr std::string_view free_form[] = {"vp",   "cstype", "deg",  "bmat", "step",  "curv",  "curv2", "surf",
                                          "parm", "trim",   "hole", "scrv", "sp",    "end",   "con",   "cdc",
                                          "cdp",  "bsp",    "bzp",  "res",  "ctech", "stech", "call",  "csh"};

class ObjReader {
 public:
  ObjReader(const std::string& bytes, const std::string& file)
      : text_(bytes, file), mesh_(file, {.of_face = "line", .first_point = 1}) {}

  ShapeFile read() {
    while (text_.next_joined()) {
      text_.drop_comment("#");
      if (!text_.ended()) statement(lower(text_.word()));
    }
    return mesh_.made();
  }

 private:
  void statement(const std::string& keyword) {
    if (keyword == "v") return vertex();
    if (keyword == "f" || keyword == "fo") return face();
    if (keyword == "l" || keyword == "p") return mesh_.leave_out(text_.number());
    if (std::ranges::find(look, keyword) != std::end(look)) return;
    if (std::ranges::find(free_form, keyword) != std::end(free_form))
      text_.refuse(fmt::format("{}: of an OBJ, faces are read, no free forms", in_quotes(keyword)));
    text_.refuse(fmt::format("{} begins no line of an OBJ", in_quotes(keyword)));
  }

  /// Reads x y z, then nothing, a weight of 1, a colour, or both.
  void vertex() {
    const viz::Vec3 p = text_.point();
    std::array<double, 4> more = {};
    std::size_t count = 0;
    while (!text_.ended() && count < more.size()) more[count++] = text_.real();
    if (count == 2) text_.refuse("five numbers; a vertex has three, then a weight or a colour");
    text_.end_line();
    if (count == 1 && more[0] != 1) text_.refuse(fmt::format("a vertex of weight {}; 1 is expected", more[0]));
    mesh_.add(p, text_.number());
  }

  /// Reads corners such as 1, 1/2, 1//3 and 1/2/3: a point, a texture and a normal.
  void face() {
    mesh_.begin_face(text_.number());
    while (!text_.ended()) {
      const std::string_view corner = text_.word();
      const std::size_t slash = std::min(corner.find('/'), corner.size());
      if (corner.find_first_not_of("0123456789/+-") != corner.npos || std::ranges::count(corner, '/') > 2)
        text_.refuse(fmt::format("{} is no corner of a face", in_quotes(corner)));
      const long given = text_.whole(corner.substr(0, slash)), count = static_cast<long>(mesh_.count());
      if (given == 0) text_.refuse("vertex 0; they are counted from 1");
      if (given < -count) text_.refuse(fmt::format("vertex {}, and there are {} so far", given, count));
      mesh_.corner(given < 0 ? count + given : given - 1);
    }
  }

  TextFile text_;
  MeshBuilder mesh_;
};

}  // namespace

ShapeFile read_obj(const std::string& bytes, const std::string& file) { return ObjReader(bytes, file).read(); }

}  // namespace isect::program::scene
