// Killed at random moments: every file is whole, and the next run puts everything right.

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <random>

#include "tests/app/shell.h"
#include "tests/catch.h"
#include "viz/formats/files.h"

namespace killed_test {
namespace fs = std::filesystem;
namespace viz = isect::viz;
using isect::test::contents;
using isect::test::Shell;

namespace {

/// Whether to test everything, a hundred times (ISECT_LONG=1); otherwise enough to notice faults.
bool for_long() { return std::getenv("ISECT_LONG") != nullptr; }

/// The critical moments come early as well, since a run does the same again and again.
const double longest = for_long() ? 20 : 1.5;

bool is_left_over(const fs::path& file) { return file.filename().string().find(".tmp-") != std::string::npos; }

/// Checks that each file newer than `since` is whole.
void read_all(const fs::path& folder, fs::file_time_type since) {
  if (!fs::exists(folder)) return;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file() || is_left_over(entry.path()) || entry.last_write_time() < since) continue;
    const std::string bytes = contents(entry.path()), kind = entry.path().extension();
    INFO(entry.path());
    if (kind == ".png") CHECK_NOTHROW(viz::read_png(bytes));
    if (kind == ".svg") CHECK_FALSE(viz::svg_metadata(bytes).empty());
    if (kind == ".json") CHECK(nlohmann::json::accept(bytes));
    if (kind == ".txt") CHECK(bytes.ends_with("\n"));
  }
}

int left_over(const fs::path& folder) {
  int count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) count += is_left_over(entry.path());
  return count;
}

/// Runs `command`, which works on `folder`, that many times, each ended by a signal somewhere on its way.
void kill_often(const Shell& shell, const std::string& command, const fs::path& folder, int times, double seconds) {
  const unsigned seed = std::random_device()();
  INFO("seed " << seed);
  std::mt19937 random(seed);
  int cut_off = 0;
  for (int i = 0; i < times; ++i) {
    const std::string signal = std::array{"KILL", "TERM", "INT"}[i % 3];
    const double after = std::uniform_real_distribution(0.01, seconds)(random);
    const auto since = fs::file_time_type::clock::now() - std::chrono::seconds(1);
    const auto r = shell("timeout -s " + signal + " " + std::to_string(after) + " " + command + " >/dev/null");
    INFO(signal << " after " << after << " s: " << r.err);
    cut_off += r.status == 124 || r.status == 137;
    read_all(folder, since);
  }
  INFO(cut_off << " of " << times << " were cut off");
  CHECK(cut_off >= times / 3);
}

double seconds_of(const Shell& shell, const std::string& command) {
  const auto start = std::chrono::steady_clock::now();
  REQUIRE(shell(command + " >/dev/null").status == 0);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

TEST_CASE("render may be killed at any moment", "[killed]") {
  const Shell shell;
  const std::string what = for_long() ? "isect render --all --format png,svg --out "
                                      : "isect render intervals --preset all --format svg --out ";
  const double whole = std::min(seconds_of(shell, what + "undisturbed"), longest);
  kill_often(shell, what + "figures", shell.work() / "figures", for_long() ? 100 : 18, whole);

  REQUIRE(shell(what + "figures >/dev/null").status == 0);
  CHECK(left_over(shell.work() / "figures") == 0);
  CHECK(shell("diff -r undisturbed figures").out.empty());
}

TEST_CASE("check may be killed at any moment while it accepts", "[killed]") {
  const Shell shell;
  const std::string lesson = for_long() ? "" : " intervals";
  const std::string accept = "isect check" + lesson + " --update=all";
  const double whole = std::min(seconds_of(shell, accept), longest);
  REQUIRE(shell("cp -r snapshots undisturbed").status == 0);
  kill_often(shell, accept, shell.work() / "snapshots", for_long() ? 100 : 18, whole);

  REQUIRE(shell(accept).status == 0);
  CHECK(shell("isect check" + lesson).status == 0);
  CHECK(left_over(shell.work() / "snapshots") == 0);
  CHECK(shell("diff -r undisturbed snapshots").out.empty());
}

}  // namespace killed_test
