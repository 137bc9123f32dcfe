// isect doctor: what is here, what is missing, and how to get it.

#include <fmt/format.h>

#include <cstdlib>

#include "lessons/program/program.h"
#include "lessons/program/terminal.h"
#include "lessons/program/versions.h"
#include "viz/offscreen.h"
#include "viz/place.h"
#include "viz/text.h"

namespace isect::program {

namespace {

std::string line(bool good, const std::string& name, const std::string& what) {
  return fmt::format("{} {:<12}{}\n", good ? inked(Ink::good, "ok ") : inked(Ink::bad, "-- "), name, what);
}

bool try_back_end(const std::string& name, std::string& out) {
  try {
    viz::Offscreen offscreen(viz::backend_named(name));
    out += line(true, name, fmt::format("{}; OpenGL {}", offscreen.driver(), offscreen.renderer().version()));
    return true;
  } catch (const std::exception& e) {
    out += line(false, name, e.what());
    return false;
  }
}

bool report_display(std::string& out) {
  for (const char* variable : {"WAYLAND_DISPLAY", "DISPLAY"}) {
    const char* value = std::getenv(variable);
    if (!value || !*value) continue;
    out += line(true, "display", fmt::format("{}={}", variable, value));
    return true;
  }
  out += line(false, "display", "none, so no window; `isect render` and `isect explain` need none");
  return false;
}

int doctor() {
  std::string out = fmt::format("isect {}\n\n", viz::version());
  const bool osmesa = try_back_end("osmesa", out);
  const bool egl = try_back_end("egl", out);
  const viz::Fonts fonts = viz::fonts();
  out += line(fonts.exact, "fonts", fmt::format("figures: {}; window: {}", fonts.figure, fonts.window));
  report_display(out);
  out += fmt::format("\nBuilt with:");
  for (const Version& v : versions) out += fmt::format(" {} {},", v.name, v.version);
  out.back() = '\n';

  std::string packages;
  if (!osmesa) packages += " libosmesa6-dev";
  if (!egl) packages += " libegl-dev libegl-mesa0";
  if (!fonts.exact) packages += " fonts-stix fonts-dejavu-core";
  if (!packages.empty())
    out += fmt::format("\nTo get what is missing (either back end will do): apt-get install{}\n", packages);
  print(out);
  return osmesa || egl ? done : nowhere_to_draw;
}

}  // namespace

void add_doctor(CLI::App& app, Program& program) {
  CLI::App& sub =
      *app.add_subcommand("doctor", "back ends, versions, fonts, what is missing and how to get it");
  sub.footer("Example: isect doctor");
  sub.callback([&program] { program.chosen = doctor; });
}

}  // namespace isect::program
