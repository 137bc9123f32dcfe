#include "bench/rows.h"

#include <algorithm>
#include <cmath>

#include "viz/chart/chart.h"

namespace isect::bench {
namespace {

void add_once(std::vector<std::string>& list, const std::string& text) {
  if (std::ranges::find(list, text) == list.end()) list.push_back(text);
}

}  // namespace

std::vector<const Row*> rows_of(const Report& report, const std::string& test, const std::string& scalar,
                                const std::string& family) {
  std::vector<const Row*> rows;
  for (const Row& r : report.rows)
    if (r.test == test && r.scalar == scalar && (family.empty() || r.family == family)) rows.push_back(&r);
  return rows;
}

std::vector<std::string> tests_of(const Report& report) {
  std::vector<std::string> all;
  for (const Row& r : report.rows) add_once(all, r.test);
  return all;
}

std::vector<std::string> scalars_of(const Report& report, const std::string& test) {
  std::vector<std::string> all;
  for (const Row& r : report.rows)
    if (r.test == test) add_once(all, r.scalar);
  return all;
}

bool has_peers(const Report& report) {
  return std::ranges::any_of(report.rows, [&](const Row& r) {
    return r.library != "isect" && !r.hard && r.scalar == "double" &&
           exact_of(rows_of(report, r.test, r.scalar, r.family)) != nullptr;
  });
}

std::vector<std::string> families_of(const std::vector<const Row*>& rows) {
  std::vector<std::string> all;
  for (const Row* r : rows) add_once(all, r->family);
  return all;
}

std::string name_of(const Row& r) { return r.library == "isect" ? r.method : r.library + ": " + r.method; }
std::string name_of(const Growth& g) { return g.library == "isect" ? g.method : g.library + ": " + g.method; }

std::vector<std::string> methods_of(const std::vector<const Row*>& rows) {
  std::vector<std::string> all;
  for (const bool own : {true, false})
    for (const Row* r : rows)
      if ((r->library == "isect") == own) add_once(all, name_of(*r));
  return all;
}

std::vector<const Row*> front_of(const std::vector<const Row*>& family, bool by_value) {
  std::vector<viz::Vec2> points;
  for (const Row* r : family)
    points.emplace_back(r->median, !by_value ? r->wrong_per_million() : r->ulps ? bits(r->ulps->p99) : NAN);
  const std::vector<bool> front = viz::pareto_front(points);
  std::vector<const Row*> rows;
  for (std::size_t i = 0; i < family.size(); ++i)
    if (front[i]) rows.push_back(family[i]);
  return rows;
}

Ratio ratio_of(const Row& a, const Row& b) { return {a.median / b.median, a.lo / b.hi, a.hi / b.lo}; }

bool faster(const Row& a, const Row& b, double noise) { return a.hi < b.lo && a.median * (1 + noise) < b.median; }

const Row* standard_of(const std::vector<const Row*>& rows) {
  const auto found = std::ranges::find_if(rows, [](const Row* r) { return r->standard; });
  return found == rows.end() ? nullptr : *found;
}

const Row* exact_of(const std::vector<const Row*>& rows) {
  const auto found = std::ranges::find_if(rows, [](const Row* r) { return r->exact && r->library == "isect"; });
  return found == rows.end() ? nullptr : *found;
}

double bits(double ulps) { return std::isnan(ulps) ? 64 : std::min(std::log2(1 + ulps), 64.0); }

std::string words(std::string family) {
  std::ranges::replace(family, '-', ' ');
  return family;
}

}  // namespace isect::bench
