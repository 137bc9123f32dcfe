#include "app/grade/reduced.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "app/query/query.h"

namespace isect::grade {

namespace {

/// A part of the numbers of a case: those of a field, without the count of a list.
struct Span {
  const Field* field;
  std::size_t begin, end;
};
std::vector<Span> spans_of(const Task& task, const Numbers& x) {
  std::vector<Span> spans;
  std::size_t at = 0;
  for (const Field& field : task.fields) {
    const bool list = field.shape == Field::Shape::list;
    const std::size_t rows = list ? static_cast<std::size_t>(x.at(at++)) : static_cast<std::size_t>(field.rows);
    spans.push_back({&field, at, at + rows * static_cast<std::size_t>(field.width)});
    at = spans.back().end;
  }
  return spans;
}

/// Whether single numbers may change: axes stay of unit length, flat polygons flat, convex ones convex.
bool is_free(const Task& task, const Field& field) {
  if (field.shape == Field::Shape::list) return task.id != "convex-polygon" && task.id != "ray-polygon";
  return !field.name.ends_with(".u");
}
int least_rows(const Field& field) { return field.width == 2 && field.name != "points" ? 3 : 1; }

double to_digits(double x, int digits) { return std::strtod(fmt::format("{:.{}e}", x, digits - 1).c_str(), nullptr); }

std::vector<double> simpler_than(double x) {
  std::vector<double> all = {0, 1, -1, 2, 3, std::round(x), std::trunc(x)};
  for (const int digits : {1, 2, 3, 6}) all.push_back(to_digits(x, digits));
  return all;
}

/// Returns radii, half-lengths, and the sides of boxes and intervals, outside of lists.
Numbers sizes_of(const Task& task, const Numbers& x) {
  Numbers sizes;
  const Span* lo = nullptr;
  const std::vector<Span> spans = spans_of(task, x);
  for (const Span& span : spans) {
    const std::string& name = span.field->name;
    if (span.field->shape == Field::Shape::list) continue;
    if (name.ends_with("hi") && lo)
      for (std::size_t i = 0; i < span.end - span.begin; ++i) sizes.push_back(x[span.begin + i] - x[lo->begin + i]);
    if (name == "radius" || name == "r1" || name == "r2" || name.ends_with(".e"))
      sizes.insert(sizes.end(), x.begin() + static_cast<std::ptrdiff_t>(span.begin),
                   x.begin() + static_cast<std::ptrdiff_t>(span.end));
    if (task.id == "interval") sizes.push_back(x[span.begin + 1] - x[span.begin]);
    if (name.ends_with("lo")) lo = &span;
  }
  return sizes;
}
/// Whether what has a size in the one has a size in the other.
bool as_solid(const Numbers& sizes, const Numbers& of) {
  for (std::size_t i = 0; i < std::min(sizes.size(), of.size()); ++i)
    if (of[i] > 0 && !(sizes[i] > 0)) return false;
  return true;
}

bool is_valid(const Task& task, const Numbers& x) {
  for (const double n : x)
    if (n != 0 && !(std::isnormal(n) && std::abs(n) <= largest)) return false;
  for (const Span& span : spans_of(task, x)) {
    const auto zero = [](double n) { return n == 0; };
    const bool direction = span.field->name == "dir" || span.field->name == "normal";
    if (direction && std::all_of(x.begin() + static_cast<std::ptrdiff_t>(span.begin),
                                 x.begin() + static_cast<std::ptrdiff_t>(span.end), zero))
      return false;
    for (std::size_t i = span.begin; i < span.end; ++i) {
      const bool ball = span.field->name == "spheres" && (i - span.begin) % 4 == 3;
      if (ball && x[i] < 0) return false;
      if (span.field->name == "boxes" && (i - span.begin) % 6 < 3 && x[i] > x[i + 3]) return false;
    }
  }
  return task.kind.empty() || !query::answer(json_line(task, x), 0, true).error;
}

/// All cases that are one change simpler, or a change of all numbers.
std::vector<Numbers> simpler_cases(const Task& task, const Numbers& from) {
  std::vector<Numbers> all;
  for (const Span& span : spans_of(task, from)) {
    if (!is_free(task, *span.field)) continue;
    const auto width = static_cast<std::size_t>(span.field->width);
    if (span.field->shape == Field::Shape::list && from[span.begin - 1] > least_rows(*span.field))
      for (std::size_t row = span.begin; row < span.end; row += width) {
        Numbers less = from;
        less.erase(less.begin() + static_cast<std::ptrdiff_t>(row),
                   less.begin() + static_cast<std::ptrdiff_t>(row + width));
        less[span.begin - 1] -= 1;
        all.push_back(std::move(less));
      }
    for (std::size_t i = span.begin; i < span.end; ++i)
      for (const double simple : simpler_than(from[i])) {
        Numbers one = from;
        one[i] = simple;
        all.push_back(std::move(one));
      }
  }
  for (std::size_t way = 0; way < simpler_than(0).size(); ++way) {
    Numbers every = from;
    for (const Span& span : spans_of(task, from))
      for (std::size_t i = span.begin; is_free(task, *span.field) && i < span.end; ++i)
        every[i] = simpler_than(from[i])[way];
    all.push_back(std::move(every));
  }
  return all;
}

/// Returns those of the cases on which the program has the fault.
std::vector<Numbers> faulty(const Task& task, const Asked& asked, const std::vector<Numbers>& tried,
                            const std::string& fault) {
  std::vector<Case> cases;
  for (const Numbers& x : tried) cases.push_back({"", x});
  Limits limits = asked.limits;
  limits.held_back = 0;
  limits.output = 65536 + cases.size() * 2048;
  const Run run = run_contained(asked.command, input_of(task, cases, asked.plain), limits);
  const std::vector<std::string_view> lines = answers_in(run.output);
  std::vector<Numbers> found;
  if (run.end != Run::End::exited || lines.size() != cases.size()) return found;
  for (std::size_t i = 0; i < tried.size(); ++i) {
    const auto known = truth(task, tried[i], asked.convention);
    if (known && marked(task, *known, lines[i]).fault == fault) found.push_back(tried[i]);
  }
  return found;
}

std::size_t length_of(const Numbers& x) { return plain_line(x).size(); }

/// Puts all changes of single numbers together that keep the fault, the simplest of each.
Numbers together(const Numbers& from, const std::vector<Numbers>& found) {
  Numbers all = from;
  std::vector<std::size_t> length(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) length[i] = plain_line({from[i]}).size();
  for (const Numbers& x : found) {
    if (x.size() != from.size()) continue;
    for (std::size_t i = 0; i < x.size(); ++i)
      if (const std::size_t now = plain_line({x[i]}).size(); now < length[i]) all[i] = x[i], length[i] = now;
  }
  return all;
}

}  // namespace

Numbers reduced(const Task& task, const Asked& asked, const Numbers& from, const std::string& fault) {
  constexpr int rounds = 24;
  constexpr std::size_t most = 2000;
  Numbers best = from, combined = from;
  const Numbers sizes = sizes_of(task, from);
  for (int round = 0; round < rounds; ++round) {
    std::vector<Numbers> tried = simpler_cases(task, best);
    tried.push_back(combined);
    const auto useless = [&](const Numbers& x) {
      return length_of(x) >= length_of(best) || !as_solid(sizes_of(task, x), sizes) || !is_valid(task, x);
    };
    tried.erase(std::remove_if(tried.begin(), tried.end(), useless), tried.end());
    if (tried.size() > most) tried.resize(most);
    if (tried.empty()) break;
    const std::vector<Numbers> found = faulty(task, asked, tried, fault);
    if (found.empty()) break;
    combined = together(best, found);
    best = *std::min_element(found.begin(), found.end(),
                             [](const Numbers& a, const Numbers& b) { return length_of(a) < length_of(b); });
  }
  return best;
}

}  // namespace isect::grade
