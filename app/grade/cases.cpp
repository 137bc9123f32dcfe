#include "app/grade/cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/grade/truth.h"

namespace isect::grade {

namespace {

using Lines = nlohmann::ordered_json;

/// Takes the numbers of one field.
Lines field_in_json(const Field& field, const Numbers& x, std::size_t& at) {
  const auto row = [&] {
    Lines numbers = Lines::array();
    for (int i = 0; i < field.width; ++i) numbers.push_back(x.at(at++));
    return numbers;
  };
  if (field.shape == Field::Shape::number) return x.at(at++);
  if (field.shape == Field::Shape::vector) return row();
  const int count = field.shape == Field::Shape::list ? static_cast<int>(x.at(at++)) : field.rows;
  Lines rows = Lines::array();
  for (int i = 0; i < count; ++i) rows.push_back(row());
  return field.name == "rings" ? Lines::array({rows}) : rows;  // one ring
}

/// What alternates in a family: yes and no, hit and miss.
bool wanted(const Task& task, const Truth& truth, int i) {
  return task.output == Output::corners || task.output == Output::pairs || truth.yes == (i % 2 == 0);
}

/// Whether no number is too large, or subnormal, which not every language reads.
bool within_bounds(const Numbers& x) {
  return std::all_of(x.begin(), x.end(),
                     [](double n) { return n == 0 || (std::isnormal(n) && std::abs(n) <= largest); });
}

}  // namespace

std::vector<Family> families(const Task& task) {
  for (const auto& of : {volume_families, ray_families, polygon_families})
    if (std::vector<Family> found = of(task.id); !found.empty()) return found;
  return {};
}

std::vector<Case> cases(const Task& task, std::uint64_t seed, int count) {
  constexpr int tries = 12, most_tries = 2000;
  std::vector<Case> all;
  for (const Family& family : families(task)) {
    bench::Random random(bench::stream(seed, (task.id + '/' + family.name).c_str()));
    for (int i = 0; i < count; ++i) {
      std::optional<Numbers> kept;
      for (int tried = 0; tried < (kept ? tries : most_tries); ++tried) {
        Numbers drawn = family.draw(random);
        if (!within_bounds(drawn)) continue;
        const std::optional<Truth> answer = truth(task, drawn);
        if (!answer) continue;
        kept = std::move(drawn);
        if (wanted(task, *answer, i)) break;
      }
      if (kept) all.push_back({family.name, std::move(*kept)});
    }
  }
  return all;
}

std::string json_line(const Task& task, const Numbers& x, long long id) {
  Lines line = Lines::object();
  if (id >= 0) line["id"] = id;
  if (!task.kind.empty()) line["kind"] = task.kind;
  std::size_t at = 0;
  for (const Field& field : task.fields) {
    const std::size_t dot = field.name.find('.');
    Lines value = field_in_json(field, x, at);
    if (dot == std::string::npos)
      line[field.name] = std::move(value);
    else
      line[field.name.substr(0, dot)][field.name.substr(dot + 1)] = std::move(value);
  }
  return line.dump();
}

std::string plain_line(const Numbers& x) {
  std::string line;
  for (const double number : x) line += fmt::format("{}{}", line.empty() ? "" : " ", number);
  return line;
}

}  // namespace isect::grade
