#include "viz/walk/pseudocode.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "viz/text/names.h"
#include "viz/text/rich_text.h"
#include "viz/walk/alt_text.h"

namespace isect::viz {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
  return text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

/// An assignment in pseudocode: "s ← l · d".
struct Assignment {
  int line;
  std::string left, right;
};

std::vector<Assignment> assignments(const std::string& line, int number) {
  static const std::string arrow = "←";
  std::vector<Assignment> all;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t end = std::min(line.find(';', at), line.size());
    const std::string part = line.substr(at, end - at);
    at = end + 1;
    const std::size_t sign = part.find(arrow);
    if (sign == std::string::npos) continue;
    const std::size_t colon = part.rfind(": ", sign);
    const std::size_t begin = colon == std::string::npos ? 0 : colon + 2;
    all.push_back({number, std::string(trimmed(std::string_view(part).substr(begin, sign - begin))),
                   std::string(trimmed(std::string_view(part).substr(sign + arrow.size())))});
  }
  return all;
}

/// Returns how the walk has computed a name up to a step or, where it has not yet, how it will.
std::optional<Assignment> assignment_of(const Walk& walk, int step, const std::string& key) {
  std::optional<Assignment> found;
  for (int line = 0; line < static_cast<int>(walk.pseudocode.size()); ++line)
    for (const Assignment& a : assignments(walk.pseudocode[line], line)) {
      if (keys(names_in_line(a.left)) != std::vector{key}) continue;
      if (std::ranges::any_of(names_in_line(a.right), [&](const Name& n) { return n.key == key; })) continue;
      const bool run = std::ranges::any_of(walk.steps.begin(), walk.steps.begin() + step + 1,
                                           [&](const Step& s) { return s.line == line; });
      if (!found || run) found = a;
    }
  return found;
}

/// Describes a knob, or a point that the picture calls by this name.
std::string given(const Lesson& lesson, const Parameters& parameters, const Scene& scene, const std::string& key) {
  for (const Parameter& p : lesson.parameters)
    if (const auto value = parameters.find(p.name);
        value != parameters.end() && keys(names_in(p.label)) == std::vector{key})
      return fmt::format("{} = {}\n{}", plain(p.label), value_in_words(value->second, lesson.flat), p.help);
  for (const Item& item : scene.items) {
    const Label* label = std::get_if<Label>(&item);
    if (!label || label->until) continue;
    const std::vector<Name> names = names_in(label->text);
    const bool point = std::ranges::any_of(scene.items, [&](const Item& other) {
      const Dot* dot = std::get_if<Dot>(&other);
      return dot && dot->at == label->at;
    });
    if (point && names.size() == 1 && names[0].vector && names[0].key == key &&
        names[0].end == plain(label->text).size())
      return fmt::format("{} = {}", plain(label->text), value_in_words(label->at, lesson.flat));
  }
  return {};
}

}  // namespace

std::vector<std::string> subject_of_line(const std::string& line, const std::set<std::string>& known) {
  std::vector<Name> left;
  for (const Assignment& a : assignments(line, 0))
    for (const Name& name : names_in_line(a.left, known)) left.push_back(name);
  return keys(left.empty() ? names_in_line(line, known) : left);
}

std::string sum_of(const Lesson& lesson, const Parameters& parameters, const Walk& walk, int step,
                   const std::string& key) {
  const Step& now = walk.steps[step];
  const std::optional<Assignment> computed = assignment_of(walk, step, key);
  const Value* value = nullptr;
  for (const Value& v : now.values) {
    const bool of_it = keys(names_in(v.name)) == std::vector{key} && v.name.find('|') == std::string::npos;
    if (of_it && (!value || (computed && plain(v.name) == computed->left))) value = &v;
  }
  const std::string digits = value ? shown(now.values)[static_cast<std::size_t>(value - now.values.data())] : "";
  const std::string told = given(lesson, parameters, now.scene, key);
  const std::string unit = value && !value->unit.empty() ? "\nunit: " + plain(value->unit) : "";
  if (!computed) return value ? fmt::format("{} = {}", plain(value->name), digits) + unit : told;
  std::string sum = fmt::format("{} = {}", computed->left, computed->right);
  if (value && plain(value->name) == computed->left)
    sum += " = " + digits;
  else if (value)
    sum += fmt::format("\n{} = {}", plain(value->name), digits);
  else if (!told.empty())
    return told;
  return sum + unit;
}

}  // namespace isect::viz
