#include "app/shell/environment.h"

#include <fmt/format.h>

#include <cstring>

#include "app/shell/subprocess.h"
#include "app/shell/terminal.h"
#include "viz/compose/compose.h"
#include "viz/gl/offscreen.h"
#include "viz/gl/resources.h"
#include "viz/snapshot/snapshot.h"
#include "viz/text/text.h"

namespace isect::program {

namespace {

/// Returns the variables that change how Mesa draws: their setting may have been forgotten.
std::string mesa_variables() {
  std::string set;
  for (char** entry = environ; *entry; ++entry)
    for (const char* prefix : {"LP_", "MESA_", "GALLIUM_", "LIBGL_", "EGL_"})
      if (std::strncmp(*entry, prefix, std::strlen(prefix)) == 0) set += fmt::format(" {}", *entry);
  return set.empty() ? "" : "; set in the environment:" + set;
}

}  // namespace

void need_environment(const Program& program) {
  constexpr std::size_t room = std::size_t{96} << 20;
  constexpr int threads = 6;
  if (!viz::has_room(room))
    throw viz::NoBackend(fmt::format(
        "too little memory: even the text of a figure takes {} MB of addresses; raise the limit (ulimit -v)",
        room >> 20));
  if (!viz::has_threads(threads))
    throw viz::NoBackend(fmt::format(
        "too few threads: drawing takes {}, and the system refuses them; raise the limit (ulimit -u)", threads));
  const viz::Fonts fonts = viz::fonts();
  if (!fonts.exact)
    say(
        fmt::format("{}: fonts: {} and {} stand in for STIX and DejaVu Sans, so figures look different; on Debian: "
                    "apt install fonts-stix fonts-dejavu-core",
                    program.name, fonts.figure, fonts.window));
}

void draw_on_trial(const Program& program, const std::string& backend) {
  const viz::Lesson& lesson = *program.lessons.front();
  const viz::Walk walk = lesson.walk(lesson.presets.front().parameters);
  viz::Offscreen offscreen(viz::backend_named(backend));
  const viz::Drawing drawing = viz::figure(walk.steps.back(), lesson.camera, viz::ThemeName::screen, 240, 150).drawing;
  if (viz::blank(offscreen.render(drawing))) throw viz::NoBackend(backend + ": it draws nothing but blank pictures");
}

std::string trial(const std::string& backend) {
  std::string last;
  const CompletedProcess process =
      run_subprocess({this_program(), "doctor", "--trial", backend}, [&](const std::string& line) { last = line; });
  if (process.status == done) return {};
  if (process.status > 128)
    return fmt::format("a figure drawn on trial ended with signal {} ({}){}", process.status - 128,
                       ::strsignal(process.status - 128), mesa_variables());
  return last;
}

}  // namespace isect::program
