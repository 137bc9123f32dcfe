// One scene, two back ends: what the SVG draws stands where the PNG shows it, and both where the camera projects it.

#include <cstdio>
#include <map>
#include <sstream>

#include "tests/catch.h"
#include "tests/viz/pixels.h"
#include "viz/compose/compose.h"
#include "viz/formats/files.h"

namespace agreement_test {
using namespace isect::viz;

namespace {

constexpr double width = 640, height = 400;

struct Box {
  double left = 1e9, top = 1e9, right = -1e9, bottom = -1e9;
  void grow(double x, double y) {
    left = std::min(left, x), right = std::max(right, x);
    top = std::min(top, y), bottom = std::max(bottom, y);
  }
  Vec2 middle() const { return {(left + right) / 2, (top + bottom) / 2}; }
};

/// The box of the last path filled with this colour, in the drawing's units. Our circles are four cubic arcs, whose
/// control points keep to the circle's box.
Box in_svg(const std::string& svg, const Colour& colour) {
  double svg_width = 0;
  std::sscanf(svg.c_str() + svg.find("viewBox=\"0 0 ") + 13, "%lf", &svg_width);
  Box box;
  for (std::size_t at = svg.find("<path d=\""); at != std::string::npos; at = svg.find("<path d=\"", at + 1)) {
    unsigned rgb = 0;
    std::sscanf(svg.c_str() + svg.find("style=\"", at), "style=\"fill:#%6x", &rgb);
    const Colour c = hex(rgb);
    if (std::abs(c.r - colour.r) + std::abs(c.g - colour.g) + std::abs(c.b - colour.b) > 1e-5) continue;
    const std::size_t path = at + std::string("<path d=\"").size();
    std::istringstream words(svg.substr(path, svg.find('"', path) - path));
    box = {};
    double x = 0, y = 0;
    bool have_x = false;
    for (std::string word; words >> word;) {
      if (word.size() == 1 && std::isalpha(static_cast<unsigned char>(word[0]))) continue;
      (have_x ? y : x) = std::stod(word) * width / svg_width;
      if (have_x) box.grow(x, y);
      have_x = !have_x;
    }
  }
  return box;
}

/// The box of the pixels of this colour, edges included at half cover.
Box in_picture(const Picture& p, const Colour& colour) {
  Box box;
  for (int y = 0; y < p.height; ++y) {
    for (int x = 0; x < p.width; ++x) {
      const double off = std::abs(channel(p, x, y, 0) - 255 * colour.r) +
                         std::abs(channel(p, x, y, 1) - 255 * colour.g) +
                         std::abs(channel(p, x, y, 2) - 255 * colour.b);
      if (off > 6) continue;
      box.grow(x, y);
      box.grow(x + 1, y + 1);
    }
  }
  return box;
}

}  // namespace

TEST_CASE("PNG and SVG of one scene agree about where things are, within a pixel", "[agreement]") {
  const std::map<Role, Vec3> dots = {{Role::hit, {0.3, 0.8, 0.1}},
                                     {Role::first, {-1.5, -0.4, 1}},
                                     {Role::second, {1.7, -0.9, -0.5}},
                                     {Role::miss, {0.9, 1.1, -1.2}},
                                     {Role::muted, {-0.6, 0.2, 0.8}}};
  Scene scene;
  for (const auto& [role, at] : dots) scene.items.push_back(Dot{at, Mark::disc, role});

  for (const bool perspective : {false, true}) {
    Camera start;
    start.perspective = perspective;
    const View view(frame(start, {&scene}, width / height), width, height);
    const Theme style = theme(ThemeName::print, width, height);
    const Drawing drawing = {width, height, style.background, compose(scene, view, style).shapes};
    const std::string vector = svg(drawing);
    const Picture pixels = offscreen().render(drawing);

    for (const auto& [role, at] : dots) {
      const Box a = in_svg(vector, style.ink(role)), b = in_picture(pixels, style.ink(role));
      const Vec2 truth = view.project(at).at;
      INFO("role " << static_cast<int>(role) << ", svg " << a.middle().transpose() << ", png "
                   << b.middle().transpose());
      CHECK((a.middle() - truth).norm() < 0.01);
      CHECK((b.middle() - truth).norm() < 0.75);
      CHECK(std::abs((a.right - a.left) - 2 * style.sizes.disc) < 0.01);
      CHECK(std::abs((b.right - b.left) - (a.right - a.left)) < 2);
    }
  }
}

}  // namespace agreement_test
