#include "app/scene/written.h"

#include <fmt/format.h>

#include "app/scene/types.h"

namespace isect::program::scene {

namespace {

/// Returns "ray origin dir [tmin] [tmax]".
std::string how_written(const TypeSpec& type) {
  std::string line = type.name;
  if (const std::string other = other_name(type); !other.empty()) line += fmt::format(" (or {})", other);
  for (const FieldSpec& field : type.fields) line += field.optional ? " [" + field.name + "]" : " " + field.name;
  if (!type.made_of.empty()) line += " " + type.made_of;
  return line;
}

/// Lists all types, two per line where they fit.
std::string list_of_types() {
  constexpr std::size_t half = 42;
  std::string list, left;
  for (const TypeSpec& type : types()) {
    const std::string one = how_written(type);
    if (!left.empty() && one.size() <= half + 10) {
      list += fmt::format("  {:<{}}{}\n", left, half, one), left.clear();
      continue;
    }
    if (!left.empty()) list += "  " + left + "\n";
    left = one;
    if (left.size() >= half) list += "  " + left + "\n", left.clear();
  }
  return left.empty() ? list : list + "  " + left + "\n";
}

constexpr const char* before =
    "A scene:\n"
    "  {\"title\": \"A ray past a box\",\n"
    "   \"objects\": [{\"ray\": \"r\", \"origin\": [-4, 0, 1], \"dir\": [1, 0, 0]},\n"
    "               {\"box\": \"A\", \"lo\": [-1, -1, -1], \"hi\": [1, 1, 1]}],\n"
    "   \"ask\": [[\"r\", \"A\"], {\"first hit\": \"r\"}]}\n"
    "Objects, with two coordinates or with three (what stands in brackets may be left out). A name has 1 to 16\n"
    "letters a to z, A to Z and digits, a letter first; y points up.\n";

constexpr const char* after =
    "A plane is where normal . x + d = 0. An obb reaches from center as far as half tells along u, v and, in space,\n"
    "w: axes of length 1 at right angles. angle is in degrees, from bottom to top. at moves all points of its object.\n"
    "\"hidden\": true in any object leaves it out of the picture, not out of the answers.\n"
    "\"color\" in any object: first, second, text or muted, as a theme has them; or #1f77b4, or a name of CSS, six\n"
    "of these at most. It is made darker or lighter until it can be read on the theme's ground; in grey print its\n"
    "object looks as without it.\n"
    "Files, named from the scene's folder, as other programs write them; up to 1,000,000 points, and as many "
    "triangles:\n"
    "  .csv .tsv .txt     a point a row: two or three numbers; or, below a first row of names, the columns x, y (and "
    "z).\n"
    "                     Between semicolons or tabs a comma is a decimal one. Comments begin with #, // or %\n"
    "  .xyz               the same; what stands behind three numbers is left out\n"
    "  .obj .ply .stl .off    meshes, text or binary (.off: text). Faces with notches or holes are cut into triangles\n"
    "  .geojson .json .wkt    polygons in the plane, with holes, in collections or not; read as one, by the even-odd "
    "rule\n"
    "What is not understood is an error with its line. What is read otherwise than it may be meant is told.\n"
    "Numbers are decided exactly as the doubles nearest to them: 0.1 + 0.2 lies above 0.3. Where objects are to\n"
    "touch, write halves, quarters or whole numbers.\n"
    "Questions: two names; {\"first hit\": \"r\"}; {\"fit\": \"M\"} with \"volume\": sphere, box, obb, kdop or hull, "
    "or\n"
    "all five; {\"clip\": \"r\", \"to\": \"A\"}, a box or a plane; {\"hierarchy\": \"M\"}, or [\"A\", \"B\"], or "
    "\"all\"; {\"walk\": "
    "[\"r\", \"S\"]},\n"
    "step by step as in the usual lesson, or with \"lesson\": \"convex-polygon\" in that one; {\"walk\": \"H\"} of "
    "points;\n"
    "{\"walk\": \"all\", \"lesson\": \"collision\", \"method\": \"sweep\"} of boxes in the plane, or of a list "
    "of them;\n"
    "in \"lesson\": \"hierarchy\", too, with \"method\": \"build\", or \"ray\" and \"ray\": \"r\".\n"
    "\"ask\" may be \"all pairs\".\n"
    "Words of your own may stand beside a question that is no walk; two names are written {\"of\": [\"r\", \"S\"]} "
    "then.\n"
    "\"title\", \"caption\" and \"verdict\" stand in place of the usual ones (\"verdict\": null shows none); --json "
    "keeps\n"
    "the core's verdict. If other numbers have another verdict, that one is shown, and the caption says so.\n"
    "\"caption\" beside \"objects\" is that of the first step. \"answers\": \"hidden\" makes an exercise sheet: a step "
    "asks,\n"
    "in the words of \"question\" if there are any, and tells no answer. render, strip, handout and deck have "
    "--answers\n"
    "hidden and --answers shown, so that one file gives the sheet and its solution.\n"
    "\"camera\" beside any question is that of its steps, such as {\"azimuth\": 60, \"elevation\": 20, \"target\": [0, "
    "1, 0],\n"
    "\"half_height\": 2}: the point in the middle, and what is seen from there to the top edge. There are perspective "
    "and\n"
    "field_of_view, too; in the plane only the target and half_height. What is left out is as in other steps. The "
    "window\n"
    "moves from one camera to the next, and so do gif, apng and mp4; not with --same-scale.\n"
    "Texts: *italic*, a_1 and a_{in}, x^2, √2, Greek letters and signs as they are. Between dollars stands mathematics "
    "as\n"
    "in LaTeX, $\\\\frac{a}{b} \\\\le \\\\lVert c \\\\rVert^2$ (JSON doubles each backslash). TikZ and LaTeX get it as "
    "it is; elsewhere\n"
    "it is set in one line: scripts, \\frac, \\sqrt, \\vec, \\hat, \\bar, \\tilde, \\dot, \\overline, \\mathbf, "
    "\\mathrm, \\mathbb, \\text,\n"
    "\\operatorname, \\left, \\right, Greek letters, and the usual operators, relations, arrows, brackets and "
    "functions. A\n"
    "command that is none of these is refused, but with --format tikz. A lone dollar is one, and so is \\$.\n"
    "\"marks\": [{\"point\": \"q\", \"at\": \"r x S\"}, {\"dimension\": [\"q\", \"S.center\"]}]: drawn into the "
    "picture.\n"
    "There are point, arrow, line (dashed), dimension, brace, angle and \"right angle\"; an angle's corner is its "
    "second\n"
    "place. A place is [1, 2], a point, \"A.center\", the point of an earlier mark, \"r x S\", where both meet (in a "
    "point\n"
    "with \"nth\": 2 the second one), or \"foot of p on T\", the nearest point of T. Each may have \"label\" and "
    "\"color\"\n"
    "(first, second, text or muted), dimension and brace \"offset\". A length or an angle that is rounded says ≈. A\n"
    "right angle must be one; a mark whose place does not exist is told in words. \"from step\": 2 and \"to step\": 3, "
    "in\n"
    "a mark or an object, say when it is drawn; what a step asks about always is.\n"
    "\"lang\": \"de\" has isect say its own words in German; isect lang lists the languages.\n"
    "\"notes\": [{\"at\": [0, 2, 0], \"text\": \"*h*\"}] and \"camera\": {\"azimuth\": 30, \"elevation\": 20} may "
    "follow.\n";

}  // namespace

std::string how_written() { return before + list_of_types() + after; }

}  // namespace isect::program::scene
