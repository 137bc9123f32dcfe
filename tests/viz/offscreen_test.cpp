#include "viz/gl/offscreen.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tests/catch.h"
#include "tests/viz/pixels.h"
#include "viz/lesson.h"

namespace offscreen_test {
using namespace isect::viz;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

/// The memory this process holds, in megabytes.
double resident_megabytes() {
  std::ifstream statm("/proc/self/statm");
  double total = 0, resident = 0;
  statm >> total >> resident;
  return resident * 4096 / 1e6;
}

std::string message_of(Backend backend) {
  try {
    Offscreen{backend};
  } catch (const NoBackend& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("the same drawing gives the same bytes every time", "[offscreen]") {
  const Drawing drawing = one_of_everything();
  Offscreen first;
  const Picture once = first.render(drawing);
  CHECK(difference(first.render(drawing), once) == 0);
  Offscreen second;
  CHECK(difference(second.render(drawing), once) == 0);
  CHECK(ink(once) > 1000);
}

TEST_CASE("OSMesa and EGL give the same bytes", "[offscreen]") {
  const Drawing drawing = one_of_everything();
  Picture osmesa;
  {
    Offscreen o(Backend::osmesa);
    CHECK(o.name() == "osmesa");
    osmesa = o.render(drawing);
  }
  Offscreen e(Backend::egl);
  CHECK(e.name() == "egl");
  CHECK(difference(e.render(drawing), osmesa) == 0);
}

TEST_CASE("several contexts live side by side", "[offscreen]") {
  const Drawing drawing = one_of_everything();
  Offscreen a(Backend::osmesa);
  const Picture picture = a.render(drawing);
  Offscreen b(Backend::egl);
  auto c = std::make_unique<Offscreen>(Backend::osmesa);
  auto d = std::make_unique<Offscreen>(Backend::egl);
  for (Offscreen* each : {&a, &b, c.get(), d.get(), &a, c.get(), &b, d.get()})
    CHECK(difference(each->render(drawing), picture) == 0);
  c.reset();
  CHECK(difference(a.render(drawing), picture) == 0);
  d.reset();
  CHECK(difference(b.render(drawing), picture) == 0);
  CHECK(difference(a.render(drawing), picture) == 0);
}

TEST_CASE("the first choice is OSMesa on llvmpipe", "[offscreen]") {
  Offscreen o;
  CHECK(o.backend() == Backend::osmesa);
  CHECK(o.driver().rfind("llvmpipe", 0) == 0);
  CHECK(o.renderer().name() == o.driver());
}

TEST_CASE("forty contexts made and destroyed leave the memory flat", "[offscreen]") {
  const Drawing drawing = drawing_of({Fill{circle({100, 60}, 40), black}, Text{"*t*", {100, 60}, 20, white}}, 512, 512);
  struct Run {
    Backend backend;
    int cycles;        // of each part
    double allowance;  // MB
  };
  for (const auto& [backend, cycles, allowance] : {Run{Backend::osmesa, 10, 0.5}, Run{Backend::egl, 5, 1}}) {
    const auto cycle = [&, b = backend] { Offscreen(b).render(drawing); };
    for (int i = 0; i < 6; ++i) cycle();
    // A leak grows in every part. An allocator that takes another arena once, when it likes, does in one or two.
    std::array<double, 4> grown;
    for (double& part : grown) {
      const double before = resident_megabytes();
      for (int i = 0; i < cycles; ++i) cycle();
      part = resident_megabytes() - before;
    }
    INFO("grown by " << grown[0] << ", " << grown[1] << ", " << grown[2] << ", " << grown[3]
                     << " MB; one context's framebuffer alone takes 37");
    CHECK(std::ranges::min(grown) < allowance);
    CHECK(std::ranges::max(grown) < 37);
  }
}

TEST_CASE("a picture larger than one part has no seams", "[offscreen]") {
  Drawing drawing = drawing_of({}, 1500, 900);
  drawing.shapes = {Fill{circle({1000, 620}, 250), black.with_alpha(0.3), 30, 3, black},
                    Stroke{polyline({{10, 30}, {1490, 870}}), black.with_alpha(0.5), 12, {40, 10}, false},
                    Text{"across *both* borders", {1024, 650}, 60, black, 0.5, true, 4, white}};
  const Picture parts = offscreen().render(drawing);

  Renderer& renderer = offscreen().renderer();
  renderer.draw(drawing, 2);
  const Picture whole = renderer.read();
  REQUIRE(parts.width == 1500);
  REQUIRE(parts.height == 900);
  int more_than_rounding = 0;
  for (int y = 0; y < parts.height; ++y)
    for (int x = 0; x < parts.width; ++x) {
      double mean = 0;
      for (const int i : {0, 1})
        for (const int j : {0, 1}) mean += channel(whole, 2 * x + i, 2 * y + j, 1) / 4.0;
      if (std::abs(mean - channel(parts, x, y, 1)) > 1) ++more_than_rounding;
    }
  CHECK(more_than_rounding < 30);  // samples that an edge runs through
}

TEST_CASE("back ends are found by name, and a wrong name names the nearest", "[offscreen]") {
  CHECK(backend_named("auto") == Backend::automatic);
  CHECK(backend_named("osmesa") == Backend::osmesa);
  CHECK(backend_named("egl") == Backend::egl);
  CHECK_THROWS_AS(backend_named("osmsa"), BadInput);
  CHECK_THROWS_WITH(backend_named("osmsa"), isect::test::Contains("did you mean \"osmesa\""));
  CHECK_THROWS_WITH(backend_named("eg"), isect::test::Contains("did you mean \"egl\""));
}

// Run by the next test in a process of its own: Mesa chooses its driver once.
TEST_CASE("softpipe alone is no back end", "[.softpipe]") {
  for (const Backend backend : {Backend::automatic, Backend::osmesa, Backend::egl}) {
    const std::string message = message_of(backend);
    CHECK(contains(message, "GALLIUM_DRIVER=softpipe is set"));
    CHECK(contains(message, "unset it, or give llvmpipe"));
  }
}

TEST_CASE("another driver than llvmpipe is refused with the reason and the remedy", "[offscreen]") {
  const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
  const std::string command = "GALLIUM_DRIVER=softpipe \"" + self + "\" '[.softpipe]' > /dev/null";
  CHECK(std::system(command.c_str()) == 0);
}

}  // namespace offscreen_test
