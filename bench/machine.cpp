#include "bench/machine.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <sstream>
#include <thread>
#include <utility>
#include <vector>

#include "bench/distribution.h"
#include "bench/session.h"

namespace isect::bench {
namespace {

/// The value of the line "name : value" of the first processor; empty if there is none.
std::string told(const std::string& cpuinfo, const std::string& name) {
  std::istringstream lines(cpuinfo);
  for (std::string line; std::getline(lines, line) && !line.empty();)
    if (line.starts_with(name) && line.find_first_not_of(" \t", name.size()) == line.find(':'))
      if (const std::size_t at = line.find(": "); at != line.npos) return line.substr(at + 2);
  return {};
}

}  // namespace

std::string cpu_of(const std::string& cpuinfo) {
  std::string cpu = told(cpuinfo, "model name");
  if (cpu.empty()) cpu = "unknown";
  const std::string family = told(cpuinfo, "cpu family"), model = told(cpuinfo, "model");
  return family.empty() || model.empty() ? cpu : cpu + ", family " + family + ", model " + model;
}

namespace {
/// "1 MB of L2": the cache of one core.
std::string cache(const char* level, int name) {
  const long bytes = sysconf(name);
  return bytes <= 0 ? "" : std::to_string((bytes + (1 << 19)) >> 20) + " MB of " + level;
}

/// Seconds of one pass of a fixed loop: as many as a suite's pass over ordinary cases takes, 0.5 ms.
double fixed_pass() {
  const auto start = std::chrono::steady_clock::now();
  double x = 2;  // 1 would stay 1, and need no loop
  for (int i = 0; i < 300000; ++i) x = x * 0.999 + 1e-3;
  asm volatile("" : : "x"(x));
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median_of_passes() {
  std::vector<double> times;
  for (int pass = 0; pass < Effort().most_passes; ++pass) times.push_back(fixed_pass());
  return Distribution(std::move(times)).quantile(0.5);
}
}  // namespace

double noise() {
  std::vector<double> medians;
  for (int k = 0; k < 12; ++k) medians.push_back(median_of_passes());
  const auto [least, most] = std::ranges::minmax(medians);
  return most / least - 1;
}

Machine this_machine(const std::string& flags, const std::string& build) {
  Machine m;
  std::ifstream info("/proc/cpuinfo");
  m.cpu = cpu_of({std::istreambuf_iterator<char>(info), {}});
  m.cores = static_cast<int>(std::thread::hardware_concurrency());
  m.compiler = "GCC " __VERSION__;
#ifdef __clang__
  m.compiler = __VERSION__;
#endif
  m.flags = flags, m.build = build;
  m.caches = cache("L2", _SC_LEVEL2_CACHE_SIZE);
  if (const std::string l3 = cache("L3", _SC_LEVEL3_CACHE_SIZE); !l3.empty())
    m.caches += (m.caches.empty() ? "" : ", ") + l3;
  double load[1] = {0};
  if (getloadavg(load, 1) == 1) m.load = load[0];
  const std::time_t now = std::time(nullptr);
  char day[16] = "";
  std::tm parts{};
  if (gmtime_r(&now, &parts) != nullptr && std::strftime(day, sizeof day, "%Y-%m-%d", &parts) > 0) m.date = day;
  m.noise = noise();
  return m;
}

}  // namespace isect::bench
