#include "app/performance.h"

#include <algorithm>
#include <optional>

#include "app/shell/scratch_folder.h"
#include "app/shell/subprocess.h"
#include "viz/formats/files.h"
#include "viz/formats/formats.h"
#include "viz/gl/offscreen.h"
#include "viz/window/frame_rate.h"

namespace isect::program {
namespace {

/// Runs this program with these arguments; returns the run with the median time, nothing if one failed.
std::optional<CompletedProcess> run_self(std::vector<std::string> arguments, int runs) {
  arguments.insert(arguments.begin(), this_program());
  std::vector<CompletedProcess> all;
  for (int i = 0; i < runs; ++i) {
    all.push_back(run_subprocess(arguments, [](const std::string&) {}));
    if (all.back().status != done) return {};
  }
  std::ranges::nth_element(all, all.begin() + runs / 2, {}, &CompletedProcess::seconds);
  return all[runs / 2];
}

/// Adds the time of a run. The target is in ms, from start to end.
void tell(std::vector<bench::Duty>& all, const std::string& what, const CompletedProcess& run, double target) {
  all.push_back({what, 1000 * run.seconds, "ms", target});
  all.push_back({what + ", processor time", 1000 * run.processor, "ms", {}});
  all.push_back({what + ", memory", run.peak, "MB", {}});
}

/// Returns the command for all figures of a lesson, as PNG.
std::vector<std::string> rendering(const Program& program, const viz::Lesson& lesson, const std::string& folder) {
  std::vector<std::string> words = {"render", "--preset", "all", "--out", folder};
  if (!program.only) words.insert(words.begin() + 1, lesson.id);
  return words;
}

}  // namespace

std::vector<bench::Duty> performance(const Program& program, bool quick,
                                     const std::function<void(const std::string&)>& told) {
  std::vector<bench::Duty> all;
  told("isect --help");
  if (const auto help = run_self({"--help"}, quick ? 5 : 15)) tell(all, "isect --help", *help, 30);

  told("isect render, one figure");
  const viz::Lesson& first = program.only ? *program.only : *program.lessons.front();
  for (const std::string& format : viz::format_names()) {
    std::vector<std::string> words = {"render", "--step", "1", "--format", format, "--out", "-"};
    if (!program.only) words.insert(words.begin() + 1, first.id);
    if (const auto figure = run_self(words, quick ? 3 : 9))
      tell(all, "isect render, one figure, " + format, *figure, 400);
  }

  told("frames of the window");
  try {
    all.push_back({"window in software, another step each frame",
                   viz::frames_per_second(program.lessons, quick ? 0.5 : 3),
                   "frames/s",
                   {}});
  } catch (const viz::NoBackend&) {
  }

  if (quick) return all;
  const ScratchFolder scratch;
  double seconds = 0, processor = 0, peak = 0;
  int lessons = 0;
  for (const viz::Lesson* lesson : program.only ? std::vector{program.only} : program.lessons) {
    told("all figures of " + lesson->id);
    const auto figures = run_self(rendering(program, *lesson, scratch.path()), 1);
    if (!figures) continue;
    seconds += figures->seconds, processor += figures->processor, ++lessons;
    peak = std::max(peak, figures->peak);
  }
  if (lessons > 0) {
    const std::string what = "all figures of all " + std::to_string(lessons) + " lessons, png";
    all.push_back({what, seconds, "s", {}});
    all.push_back({what + ", processor time", processor, "s", {}});
    all.push_back({what + ", most memory", peak, "MB", {}});
  }
  return all;
}

}  // namespace isect::program
