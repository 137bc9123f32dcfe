#include "bench/session.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <stdexcept>
#include <thread>

#include "bench/contest.h"
#include "bench/measure.h"

namespace isect::bench {
namespace {

/// How much slower than its least the 95th percentile of a fixed loop is: what the machine adds by itself.
double noise() {
  std::vector<double> times;
  for (int k = 0; k < 401; ++k) {
    const auto start = std::chrono::steady_clock::now();
    double x = 1;
    for (int i = 0; i < 20000; ++i) x = x * 0.999 + 1e-3;
    asm volatile("" : : "x"(x));
    times.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  const Distribution all(std::move(times));
  return all.quantile(0.95) / all.quantile(0) - 1;
}

Machine machine() {
  Machine m;
  m.cpu = cpu();
  m.cores = static_cast<int>(std::thread::hardware_concurrency());
  m.compiler = "GCC " __VERSION__;
#ifdef __clang__
  m.compiler = __VERSION__;
#endif
  m.flags = ISECT_FLAGS;
  m.build = ISECT_BUILD;
  double load[1] = {0};
  if (getloadavg(load, 1) == 1) m.load = load[0];
  const std::time_t now = std::time(nullptr);
  char day[16] = "";
  std::tm parts{};
  if (gmtime_r(&now, &parts) != nullptr && std::strftime(day, sizeof day, "%Y-%m-%d", &parts) > 0) m.date = day;
  return m;
}

}  // namespace

Report measure(const Effort& effort, unsigned long long seed, const std::vector<std::string>& only,
               const std::function<void(const std::string&)>& progress) {
  Session session(effort, seed);
  if (progress) session.progress = progress;
  Report report;
  report.machine = machine();
  report.seed = seed;
  report.quick = effort.judged < effort.cases;
  const double before = noise();
  for (const Suite& suite : suites())
    if (only.empty() || std::ranges::find(only, suite.name) != only.end()) suite.run(session);
  report.machine.noise = std::max(before, noise());
  report.rows = std::move(session.rows);
  report.growths = std::move(session.growths);
  return report;
}

}  // namespace isect::bench
