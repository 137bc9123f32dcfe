#include "app/grade/truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/query/query.h"

namespace isect::grade {

namespace {

using Result = nlohmann::json;

/// Returns the result of a line of a query, or nothing if that is an error.
std::optional<Result> asked(const std::string& line) {
  const query::Answer answer = query::answer(line);
  if (answer.error) return std::nullopt;
  return Result::parse(answer.text).at("result");
}

double number_of(const Result& value) { return value.is_number() ? value.get<double>() : std::nan(""); }

/// Whether two balls, or a ball and a box, meet by the note's strict comparison.
bool strictly(const Task& task, const Numbers& x, const Result& result) {
  const std::string relation = result.at("relation");
  if (!result.at("intersects").get<bool>() || relation == "touch" || relation == "touch_outer") return false;
  if (task.id == "sphere-aabb") return x[3] > 0;
  return relation != "touch_inner" && x[3] + x[7] > 0;
}

std::optional<Truth> truth_of_query(const Task& task, const Numbers& x, Convention convention) {
  const std::optional<Result> found = asked(json_line(task, x));
  if (!found) return std::nullopt;
  const Result& result = *found;
  switch (task.output) {
    case Output::yes_no:
      if (convention == Convention::note && !task.note.empty()) return Truth{strictly(task, x, result)};
      return Truth{result.at("intersects").get<bool>()};
    case Output::location:
      return Truth{true, result.at("evenodd").get<std::string>()};
    case Output::span:
      if (!result.at("hit").get<bool>()) return Truth{false};
      return Truth{true, "", {number_of(result.at("t_in")), number_of(result.at("t_out"))}};
    case Output::corners: {
      Truth corners;
      for (const Result& point : result.at("hull"))
        for (const Result& coordinate : point) corners.numbers.push_back(coordinate.get<double>());
      return corners;
    }
    default:
      break;
  }
  double t = 0;
  if (task.kind == "ray_sphere") {
    t = number_of(result.at("t_first_surface"));
  } else if (task.kind == "ray_plane") {
    if (!result.at("ray_hit").get<bool>()) return Truth{false};
    t = result.at("coplanar").get<bool>() ? 0 : number_of(result.at("t"));
  } else {
    if (!result.at("hit").is_boolean()) return std::nullopt;  // within the plane of a polygon
    if (!result.at("hit").get<bool>()) return Truth{false};
    t = number_of(result.at(task.kind == "ray_box" ? "t_in" : "t"));
  }
  return std::isnan(t) ? Truth{false} : Truth{true, "", {t}};
}

/// Asks each pair of boxes.
std::optional<Truth> truth_of_pairs(const Numbers& x) {
  const Task& pair = task_named("aabb");
  Truth all;
  const int count = static_cast<int>(x[0]);
  for (int i = 0; i < count; ++i)
    for (int j = i + 1; j < count; ++j) {
      Numbers two(x.begin() + 1 + 6 * i, x.begin() + 7 + 6 * i);
      two.insert(two.end(), x.begin() + 1 + 6 * j, x.begin() + 7 + 6 * j);
      const std::optional<Truth> one = truth_of_query(pair, two, Convention::closed);
      if (!one) return std::nullopt;
      if (one->yes) all.numbers.insert(all.numbers.end(), {static_cast<double>(i), static_cast<double>(j)});
    }
  all.yes = !all.numbers.empty();
  return all;
}

/// Asks each ball.
std::optional<Truth> truth_of_nearest(const Numbers& x) {
  const Task& ray = task_named("ray-sphere");
  Truth all = {false};
  for (std::size_t i = 7; i + 4 <= x.size(); i += 4) {
    Numbers one(x.begin(), x.begin() + 6);
    one.insert(one.end(), x.begin() + static_cast<std::ptrdiff_t>(i), x.begin() + static_cast<std::ptrdiff_t>(i) + 4);
    const std::optional<Truth> hit = truth_of_query(ray, one, Convention::closed);
    if (!hit) return std::nullopt;
    all.yes = all.yes || hit->yes;
    all.numbers.push_back(hit->yes ? hit->numbers[0] : std::nan(""));
  }
  return all;
}

}  // namespace

std::optional<Truth> truth(const Task& task, const Numbers& x, Convention convention) {
  if (task.output == Output::pairs) return truth_of_pairs(x);
  if (task.output == Output::nearest) return truth_of_nearest(x);
  const std::optional<Truth> found = truth_of_query(task, x, convention);
  // a point that lies beyond the largest number is none that a program can answer
  if (found && task.output != Output::corners)
    for (const double value : found->numbers)
      if (!std::isfinite(value)) return std::nullopt;
  return found;
}

std::string answer_line(const Task& task, const Truth& answer) {
  switch (task.output) {
    case Output::yes_no:
      return answer.yes ? "1" : "0";
    case Output::location:
      return answer.location;
    case Output::corners:
    case Output::pairs: {
      std::string line = fmt::format("{}", answer.numbers.size() / 2);
      if (!answer.numbers.empty()) line += " " + plain_line(answer.numbers);
      return line;
    }
    case Output::nearest: {
      if (!answer.yes) return "miss";
      const auto nearer = [](double a, double b) { return !std::isnan(a) && !(a >= b); };
      const auto least = std::min_element(answer.numbers.begin(), answer.numbers.end(), nearer);
      return fmt::format("{} {}", std::distance(answer.numbers.begin(), least), *least);
    }
    default:
      return answer.yes ? plain_line(answer.numbers) : "miss";
  }
}

}  // namespace isect::grade
