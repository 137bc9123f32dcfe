#include "viz/formats/tikz.h"

#include <cmath>

#include "tests/catch.h"
#include "viz/formats/svg_path.h"
#include "viz/text/text.h"

namespace tikz_test {
using namespace isect::viz;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;
using isect::test::Contains;

namespace {

constexpr Colour blue = {0, 0, 1, 1};

/// One of each kind of shape.
Drawing everything() {
  return {200,
          100,
          {1, 1, 1, 1},
          {Fill{circle({50, 50}, 30), blue.with_alpha(0.14), 2, 0.2, blue},
           Stroke{polyline({{0, 0}, {200, 100}}), blue, 0.5, {1.5, 1.1}, true},
           Gradient{{150, 50}, {30, 0}, {0, 20}, {140, 40}, blue.with_alpha(0.1), blue.with_alpha(0.2)},
           Text{.markup = "*t*_{1,2} = √2", .at = {100, 90}, .size = 6.6, .colour = blue, .halo = 0.6}}};
}

Imprint of_width(double width_pt) {
  Imprint imprint;
  imprint.width_pt = width_pt;
  return imprint;
}

}  // namespace

TEST_CASE("every kind of shape reaches TikZ, within a frame of its own size", "[tikz]") {
  const std::string text = tikz(everything(), {}, of_width(200));
  CHECK_THAT(text, Contains("\\path[use as bounding box] (0,0) rectangle (200,100);") &&
                       Contains("\\clip (0,0) rectangle (200,100);"));
  CHECK_THAT(text, Contains("fill opacity=0.14") && Contains(".. controls") && Contains("-- cycle"));
  CHECK_THAT(text, Contains("line width=0.5bp, line cap=round, dash pattern=on 1.5bp off 1.1bp"));
  CHECK_THAT(text, Contains("\\pgfdeclareradialshading") && Contains("fill opacity=0.2"));
  CHECK_THAT(text, EndsWith("\\end{tikzpicture}\n"));
  CHECK_THAT(tikz(everything(), {}, of_width(400)), Contains("(0,0) rectangle (400,200)") && Contains("width=1bp"));
}

TEST_CASE("labels of TikZ are set by LaTeX, in the document's own font and size", "[tikz]") {
  const std::string text = tikz(everything(), {}, of_width(200));
  CHECK_THAT(text, Contains("{$t_{1,2} = \\sqrt{2}$}};") && Contains("anchor=base"));
  CHECK_THAT(text, !Contains("font="));
}

TEST_CASE("mathematics between dollars reaches TikZ as its author wrote it, with the packages that it needs",
          "[tikz]") {
  Drawing drawing = everything();
  CHECK_THAT(tikz(drawing), Contains("% \\usepackage{tikz} in the preamble"));
  drawing.shapes.emplace_back(Text{.markup = "$\\oint\\lVert x\\rVert$", .at = {20, 80}, .size = 6.6, .colour = blue});
  CHECK_THAT(tikz(drawing),
             Contains("{$\\oint\\lVert x\\rVert $}};") && Contains("% \\usepackage{tikz,amsmath} in the preamble"));
}

TEST_CASE("a text that was made smaller to fit into its room is so in TikZ, too", "[tikz]") {
  Drawing drawing = everything();
  drawing.shapes.emplace_back(Text{.markup = "14 operations", .at = {50, 20}, .size = 4.5, .colour = blue});
  drawing.shapes.emplace_back(Text{.markup = "axis", .at = {50, 40}, .size = 6.3, .colour = blue});
  const std::string text = tikz(drawing, {}, of_width(200));
  CHECK_THAT(text, Contains("scale=0.61] at") && Contains("{14 operations}"));  // 4.5 / 6.6, and LaTeX's are wider
  CHECK(text.find("scale=") == text.rfind("scale="));                           // the others are set as they come
}

TEST_CASE("a label that is wider in the document's font than its room is made smaller", "[tikz]") {
  Drawing drawing = everything();
  drawing.shapes.clear();
  CHECK_THAT(tikz(drawing), !Contains("isectfitted"));
  for (const double x : {10.0, 100.0})
    drawing.shapes.emplace_back(
        Text{.markup = x < 50 ? "left" : "right", .at = {x, 20}, .size = 6, .colour = blue, .align = 0});
  const auto room_of = [text = tikz(drawing, {}, of_width(200))](const std::string& word) {
    const std::size_t end = text.find("bp}{" + word), begin = text.rfind("{", end);
    return std::stod(text.substr(begin + 1));
  };
  const auto box = [&](std::size_t i) { return measure(std::get<Text>(drawing.shapes[i])); };
  const double between = box(1).left - box(0).right, middle = box(0).right + between / 2;
  const double of_left = room_of("left"), of_right = room_of("right");
  CHECK(box(0).left + of_left <= middle + 0.01);  // neither grows over the other, nor over the edge
  CHECK(of_left > box(0).right - box(0).left);
  const double centre = (box(1).left + box(1).right) / 2;
  CHECK(centre - of_right / 2 >= middle - 0.01);
  CHECK(centre + of_right / 2 <= drawing.width + 0.01);
  CHECK(of_right > box(1).right - box(1).left);
}

TEST_CASE("a text of TikZ by an edge of the picture grows away from it", "[tikz]") {
  const auto node_of = [](double x, double align) {
    Drawing drawing = everything();
    const Text axis = {.markup = "degrees about the axis", .at = {x, 20}, .size = 6, .colour = blue, .align = align};
    drawing.shapes.emplace_back(axis);
    const std::string text = tikz(drawing, {}, of_width(drawing.width));
    const std::size_t end = text.find("{degrees"), begin = text.rfind("\\node", end);
    return text.substr(begin, end - begin);
  };
  const double width = everything().width;
  CHECK_THAT(
      node_of(1, 0),
      Contains("[anchor=base west,") &&
          Contains(
              "at (" +
              svg_number(
                  measure(Text{.markup = "degrees about the axis", .at = {1, 20}, .size = 6, .colour = blue}).left)));
  CHECK_THAT(node_of(width - 1, 1), Contains("[anchor=base east,"));
  CHECK_THAT(node_of(width / 2, 0.5), Contains("[anchor=base,"));
}

TEST_CASE(
    "rows of a card begin below each other in TikZ, names in a chart at their leaders, with room for wider letters",
    "[tikz]") {
  Drawing drawing = everything();
  drawing.objects = {{"row", "Cost", Role::text}};
  for (const char* line : {"one root, and no division", "at all."})
    drawing.shapes.emplace_back(Text{.markup = line, .at = {50, 20}, .size = 6.6, .colour = blue, .object = 0});
  const std::string text = tikz(drawing, {}, of_width(200));
  const std::string expected = "scale=0.89] at (50,";
  CHECK_THAT(text, Contains("anchor=base west, text="));
  CHECK(text.find(expected) != text.rfind(expected));
  for (const char* kind : {"chart", "panel", "map", "region"}) {
    drawing.objects = {{kind, "a", Role::text}};
    CHECK_THAT(tikz(drawing, {}, of_width(200)), Contains(expected));
  }
}

TEST_CASE("a verdict of TikZ and the sign before it stand in the middle as one, in whatever font", "[tikz]") {
  Drawing drawing = {200, 100, {1, 1, 1, 1}, {}, {{"page", "verdict", Role::text}}};
  const Text verdict = {
      .markup = "the polygons overlap", .at = {104, 80}, .size = 9, .colour = blue, .align = 0.5, .object = 0};
  const TextBox box = measure(verdict);
  const double sign = box.left - 8;
  drawing.shapes = {verdict,
                    Stroke{polyline({{sign + 1, 76}, {sign + 3, 79}, {sign + 6, 72}}), blue, 2, {0, 0}, true, 0},
                    Text{.markup = "and more", .at = {104, 92}, .size = 9, .colour = blue, .align = 0.5, .object = 0}};
  const std::string text = tikz(drawing, {}, of_width(200));
  const std::string middle = svg_number((sign + box.right) / 2);
  CHECK_THAT(text, Contains("\\node[anchor=base, text=isect2] (isectverdict1) at (" + middle + ",80) {") &&
                       Contains("{\\hspace*{8bp}the polygons overlap}"));
  CHECK_THAT(text, Contains("\\begin{scope}[shift={(isectverdict1.base west)}]\n\\draw[") &&
                       Contains("(1,-4) -- (3,-1) -- (6,-8);\n\\end{scope}"));
  CHECK_THAT(text, !Contains("hspace*{8bp}and more"));
}

TEST_CASE("a TikZ picture carries its metadata, and says what it shows", "[tikz]") {
  const Metadata metadata = {{"lesson", "x"}, {"title", "q = √2 % \\end{tikzpicture}\n\\input"}};
  Imprint imprint;
  imprint.title = "Ray and sphere";
  imprint.alt = "A ray.\n\nA ball.";
  const std::string text = tikz(everything(), metadata, imprint);
  CHECK_THAT(text, StartsWith("% isect:{"));
  CHECK_THAT(text, Contains("\n% Ray and sphere\n% A ray.\n% \n% A ball.\n"));
  CHECK(tikz_metadata(text) == metadata);
  CHECK(tikz_metadata(tikz(everything())).empty());
  CHECK_THROWS_AS(tikz_metadata("\\documentclass{article}"), FileError);
  CHECK_THROWS_AS(tikz_metadata("% isect:{\"a\n\\begin{tikzpicture}"), FileError);
}

TEST_CASE("the same drawing gives the same TikZ, and one without size is refused", "[tikz]") {
  CHECK(tikz(everything()) == tikz(everything()));
  CHECK_THROWS_AS(tikz({}), FileError);
  CHECK_THROWS_AS(tikz({std::nan(""), 5, blue, {}}), FileError);
}

TEST_CASE("a TikZ picture without a ground has none", "[tikz]") {
  Drawing d = everything();
  CHECK_THAT(tikz(d), Contains("\\fill[isect"));
  d.shapes.clear();
  d.background.a = 0;
  CHECK_THAT(tikz(d), !Contains("\\fill"));
}

TEST_CASE("the faces of a mesh can be a picture beside the file, with the labels over it", "[tikz]") {
  Drawing drawing = everything();
  Facets mesh;
  for (int i = 0; i < 1200; ++i) {
    const double x = 0.1 * i;
    for (const Vec2& p : {Vec2(x, 10), Vec2(x + 0.1, 10), Vec2(x, 20)}) mesh.corners.push_back(p);
    mesh.colours.push_back(blue);
  }
  const auto label = drawing.shapes.end() - 1;
  drawing.shapes.insert(label, mesh);
  CHECK(count_faces(drawing) == 1200);
  CHECK(count_faces(everything()) == 0);
  const FacesSpan span = faces_span(drawing);
  CHECK((span.from == 3 && span.to == 4));

  Imprint imprint = of_width(200);
  const std::string paths = tikz(drawing, {}, imprint);
  imprint.faces = "sheet-faces.pdf";
  const std::string text = tikz(drawing, {}, imprint);
  CHECK_THAT(paths, !Contains("\\includegraphics"));
  CHECK(text.size() < paths.size() / 10);
  const std::size_t picture = text.find("\\includegraphics[width=200bp]{\\isectbeside sheet-faces.pdf}");
  REQUIRE(picture != text.npos);
  CHECK(text.find("\\pgfdeclareradialshading") < picture);  // what lies below stays below
  CHECK(text.find("t_{1,2}") > picture);
  CHECK_THAT(tikz(everything(), {}, imprint), !Contains("sheet-faces"));

  const std::string pdf = tikz_faces(drawing, {{"lesson", "mesh"}}, imprint);
  CHECK(pdf_metadata(pdf).at("lesson") == "mesh");
  CHECK(pdf == tikz_faces(drawing, {{"lesson", "mesh"}}, imprint));
}

}  // namespace tikz_test
