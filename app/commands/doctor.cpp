// isect doctor: what is installed, what is missing, and how to get it.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <memory>

#include "app/program.h"
#include "app/shell/environment.h"
#include "app/shell/terminal.h"
#include "app/versions.h"
#include "viz/formats/formats.h"
#include "viz/gl/offscreen.h"
#include "viz/player/reader_state.h"
#include "viz/text/text.h"

namespace isect::program {

namespace {

std::string line(bool good, const std::string& name, const std::string& what) {
  return fmt::format("{} {:<12}{}\n", good ? inked(Ink::good, "ok ") : inked(Ink::bad, "-- "), name, what);
}

/// Tries a back end by drawing a figure: a context may be available and the first figure crash all the same.
bool try_back_end(const std::string& name, std::string& out) {
  try {
    if (const std::string trouble = trial(name); !trouble.empty()) throw viz::NoBackend(trouble);
    viz::Offscreen offscreen(viz::backend_named(name));
    out += line(true, name, fmt::format("{}; OpenGL {}", offscreen.driver(), offscreen.renderer().version()));
    return true;
  } catch (const std::exception& e) {
    out += line(false, name, e.what());
    return false;
  }
}

enum class Fonts { none, others, exact };

Fonts report_fonts(std::string& out) {
  try {
    const viz::Fonts fonts = viz::fonts();
    out += line(fonts.exact, "fonts", fmt::format("figures: {}; window: {}", fonts.figure, fonts.window));
    return fonts.exact ? Fonts::exact : Fonts::others;
  } catch (const viz::NoFonts& e) {
    out += line(false, "fonts", "none, so no figure can be drawn");
    return Fonts::none;
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

/// Reports the programs that only some formats need.
void report_programs(std::string& out) {
  for (const viz::Format& format : viz::formats())
    if (format.can_write && format.can_write())
      out += line(true, format.program, "figures as " + format.name);
    else if (format.can_write)
      out += line(
          false, format.program,
          fmt::format("none, so no {} (apt-get install {}); no other format wants it", format.name, format.program));
}

int doctor() {
  std::string out = fmt::format("isect {}\n\n", viz::version());
  const bool osmesa = try_back_end("osmesa", out);
  const bool egl = try_back_end("egl", out);
  const Fonts fonts = report_fonts(out);
  report_display(out);
  report_programs(out);
  out += fmt::format("\nBuilt with:");
  for (const Version& v : versions) out += fmt::format(" {} {},", v.name, v.version);
  out.back() = '\n';

  std::string packages;
  if (!osmesa) packages += " libosmesa6-dev";
  if (!egl) packages += " libegl-dev libegl-mesa0";
  if (fonts != Fonts::exact) packages += " fonts-stix fonts-dejavu-core";
  if (!packages.empty())
    out += fmt::format("\nTo get what is missing (either back end will do): apt-get install{}\n", packages);
  print(out);
  if (!(osmesa || egl) || fonts == Fonts::none) return nowhere_to_draw;
  return fonts == Fonts::exact ? done : check_failed;
}

}  // namespace

void add_doctor(CLI::App& app, Program& program) {
  CLI::App& sub = *app.add_subcommand("doctor", "back ends, versions, fonts, what is missing and how to get it");
  const auto backend = std::make_shared<std::string>();
  sub.add_option("--trial", *backend)->group("");  // `doctor` starts itself with it
  sub.footer(
      "Exit status: 0 figures can be drawn; 1 they can, but with other fonts than the accepted ones;\n"
      "77 none can be drawn: no back end, or no fonts. A display is wanted by the window alone.\n"
      "Example: isect doctor");
  sub.callback([&program, backend] {
    program.chosen = [&program, backend] {
      if (backend->empty()) return doctor();
      draw_on_trial(program, *backend);
      return int{done};
    };
  });
}

}  // namespace isect::program
