#include "app/shell/option_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <numeric>

#include "viz/chart/chart.h"
#include "viz/lesson.h"
#include "viz/snapshot/snapshot.h"
#include "viz/text/spelling.h"
#include "viz/walk/closing.h"

namespace isect::program {

namespace {

/// Reads the whole of `text` as a number, whatever the locale.
template <class T>
std::optional<T> number(std::string_view text) {
  T value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  return value;
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find(separator, begin);
    parts.push_back(text.substr(begin, end - begin));
    if (end == std::string::npos) return parts;
    begin = end + 1;
  }
}

/// Returns a length in plain form: "8 CM" and "8,5cm" as "8cm" and "8.5cm".
std::string plainly(std::string length) {
  std::ranges::replace(length, ',', '.');
  std::ranges::transform(length, length.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (const std::size_t unit = length.find_last_of("0123456789.") + 1; unit < length.size() && length[unit] == ' ')
    length.erase(unit, length.find_first_not_of(' ', unit) - unit);
  return length;
}

}  // namespace

Size size_of(const std::string& text) {
  constexpr int least = 16, most = 8192;
  const std::size_t x = text.find('x');
  const auto side = [&](const std::string& part) {
    const std::optional<int> n = number<int>(part);
    if (x == std::string::npos || !n || *n < least || *n > most)
      throw viz::BadInput(fmt::format("size: \"{}\" is not allowed; give WIDTHxHEIGHT, each {} to {}, such as 960x600",
                                      text, least, most));
    return *n;
  };
  return {side(text.substr(0, x)), side(x == std::string::npos ? text : text.substr(x + 1))};
}

std::string in_points(double points) { return fmt::format("{:.12g}pt", points); }

double points_of(const std::string& option, const std::string& text, double least, double most) {
  struct Unit {
    const char* name;
    double points;
  };
  const std::string length = plainly(text);
  for (const Unit& unit : {Unit{"cm", 72 / 2.54}, Unit{"mm", 72 / 25.4}, Unit{"in", 72}, Unit{"pt", 1}}) {
    if (!length.ends_with(unit.name)) continue;
    const std::optional<double> n = number<double>(length.substr(0, length.size() - 2));
    if (n && *n * unit.points >= least && *n * unit.points <= most)
      return *number<double>(fmt::format("{:.12g}", *n * unit.points));
  }
  throw viz::BadInput(
      fmt::format("{}: \"{}\" is not allowed; give a length with its unit (cm, mm, pt, in), {}pt to {}pt, such as {}",
                  option, text, least, most, least < 10 ? "9pt" : "8cm"));
}

double dpi_of(const std::string& text) {
  constexpr double least = 30, most = 2400;
  const std::optional<double> n = number<double>(text);
  if (!n || !(*n >= least && *n <= most))
    throw viz::BadInput(fmt::format("dpi: \"{}\" is not allowed; give a number from {} to {}", text, least, most));
  return *n;
}

int columns_of(const std::string& text) {
  constexpr int most = 12;
  const std::optional<int> n = number<int>(text);
  if (!n || *n < 1 || *n > most)
    throw viz::BadInput(fmt::format("columns: \"{}\" is not allowed; give a number from 1 to {}", text, most));
  return *n;
}

double seconds_of(const std::string& text) {
  constexpr double least = 0.1, most = 60;
  const std::optional<double> n = number<double>(text);
  if (!n || !(*n >= least && *n <= most))
    throw viz::BadInput(fmt::format("seconds: \"{}\" is not allowed; give a number from {} to {}", text, least, most));
  return *n;
}

std::vector<const viz::Format*> formats_of(const std::string& text) {
  std::vector<const viz::Format*> formats;
  for (const std::string& name : split(text, ',')) {
    const viz::Format* format = &viz::format_named(name);
    if (std::ranges::find(formats, format) == formats.end()) formats.push_back(format);
  }
  return formats;
}

int verdict_of(const viz::Walk& walk) {
  int step = viz::outcome(walk);
  while (step > 0 && viz::is_card(walk.steps[step].scene)) --step;  // the card of a scene's answers
  return step;
}

std::vector<std::string> step_names(const viz::Walk& walk) {
  std::vector<std::string> names;
  for (const viz::Step& step : walk.steps) names.push_back(step.slug);
  if (std::ranges::find(names, verdict_step) == names.end()) names.emplace_back(verdict_step);
  return names;
}

viz::BadInput unknown_steps(const std::string& field, const std::string& asked, const viz::Walk& walk,
                            const std::string& whose) {
  std::string part = asked;  // the first one that the walk lacks
  for (const std::string& one : split(asked, ','))
    if (const std::optional<Steps> read = Steps::read(one); !read || !read->all_in(walk)) {
      part = one;
      break;
    }
  const std::vector<std::string> names = step_names(walk);
  return viz::BadInput(
      fmt::format("{}: \"{}\" is unknown{}", field, part,
                  spelling::instead(
                      part, names,
                      fmt::format("{} has steps 1 to {}: give one, some (3-6, or 3,5,7-9), -1 for the last, all, or a "
                                  "name: {}",
                                  whose, walk.steps.size(), spelling::listed(names)))));
}

std::optional<Steps> Steps::read(const std::string& text) {
  Steps steps;
  if (text == "all") return steps;
  for (const std::string& part : split(text, ',')) {
    const bool named = std::ranges::any_of(part, [](char c) { return c >= 'a' && c <= 'z'; });
    if (named) {
      steps.parts_.push_back({0, 0, part});
      continue;
    }
    const std::size_t dash = part.find('-', 1);
    const std::optional<int> from = number<int>(part.substr(0, dash));
    const std::optional<int> to = dash == part.npos ? from : number<int>(part.substr(dash + 1));
    if (!from || !to || *from == 0 || *to < *from || (*from < 0 && dash != part.npos)) return {};
    steps.parts_.push_back({*from, *to});
  }
  return steps;
}

std::vector<int> Steps::of(const Part& part, const viz::Walk& walk) {
  const int count = static_cast<int>(walk.steps.size());
  std::vector<int> found;
  if (part.from != 0) {
    const int past = part.from < 0 ? count + 1 : 0;
    for (int step = std::max(part.from + past, 1); step <= std::min(part.to + past, count); ++step)
      found.push_back(step - 1);
    return found;
  }
  for (int step = 0; step < count; ++step)
    if (part.name == walk.steps[step].slug || part.name == viz::file_stem(step, walk.steps[step]))
      found.push_back(step);
  if (part.name == verdict_step) return {verdict_of(walk)};  // whatever its own name is
  return found;
}

std::vector<int> Steps::of(const viz::Walk& walk) const {
  std::vector<int> chosen;
  for (const Part& part : parts_) std::ranges::copy(of(part, walk), std::back_inserter(chosen));
  if (parts_.empty()) {
    chosen.resize(walk.steps.size());
    std::iota(chosen.begin(), chosen.end(), 0);
  }
  std::ranges::sort(chosen);
  const auto repeats = std::ranges::unique(chosen);
  chosen.erase(repeats.begin(), repeats.end());
  return chosen;
}

bool Steps::all_in(const viz::Walk& walk) const {
  const int count = static_cast<int>(walk.steps.size());
  return std::ranges::all_of(parts_, [&](const Part& part) { return part.to <= count && !of(part, walk).empty(); });
}

}  // namespace isect::program
