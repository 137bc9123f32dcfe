// Which values a step uses: those that a lecture shows large.

#include <algorithm>
#include <iterator>
#include <set>

#include "viz/text/names.h"
#include "viz/text/rich_text.h"
#include "viz/window/panels.h"

namespace isect::viz {
namespace {

/// Whether a name stands in a text by itself, and not as part of another one.
bool mentions(const std::string& words, const std::string& name) {
  const auto ends = [&](std::size_t at) {
    return at >= words.size() || std::string(" ()[]|,:;").find(words[at]) != std::string::npos;
  };
  for (std::size_t at = words.find(name); !name.empty() && at != std::string::npos; at = words.find(name, at + 1))
    if ((at == 0 || ends(at - 1)) && ends(at + name.size())) return true;
  return false;
}

/// Returns the value that tells most of a name: its own, or else that of an expression in which no other name stands,
/// such as a power; null: none.
const Value* value_named(const std::vector<Value>& values, const std::string& key) {
  const Value* found = nullptr;
  for (const Value& v : values) {
    if (keys(names_in(v.name)) != std::vector{key} || v.name.find('|') != std::string::npos) continue;
    if (!found || plain(v.name).size() < plain(found->name).size()) found = &v;
  }
  return found;
}

}  // namespace

std::vector<Value> values_in_use(const Walk& walk, const Step& step, const std::vector<Value>& knobs) {
  constexpr std::size_t most = 3;
  const std::string line = step.line >= 0 ? walk.pseudocode[static_cast<std::size_t>(step.line)] : std::string();
  std::set<std::size_t> used;
  std::set<std::string> told;  // names of the line that are told
  std::vector<Value> of_knobs;
  const auto use = [&](std::size_t i) {
    used.insert(i);
    for (const std::string& key : keys(names_in(step.values[i].name))) told.insert(key);
  };
  for (std::size_t i = 0; i < step.values.size(); ++i)
    if (mentions(line, plain(step.values[i].name))) use(i);
  for (const std::string& key : keys(names_in_line(line))) {
    if (told.contains(key)) continue;
    if (const Value* known = value_named(step.values, key))
      use(static_cast<std::size_t>(known - step.values.data()));
    else if (const Value* knob = value_named(knobs, key))
      of_knobs.push_back(*knob);
  }
  const auto take = [&](const auto& is_used) {
    for (std::size_t i = 0; i < step.values.size() && used.size() < most; ++i)
      if (is_used(step.values[i])) used.insert(i);
  };
  const auto take_named = [&](const std::string& words) {
    take([&](const Value& v) { return mentions(words, plain(v.name)); });
  };
  if (step.comparison) take_named(plain(step.comparison->text));
  take([](const Value& v) { return v.fresh; });
  take_named(plain(step.formula));
  std::vector<Value> in_use;
  for (const std::size_t i : used) in_use.push_back(step.values[i]);
  std::ranges::copy(of_knobs, std::back_inserter(in_use));
  return in_use;
}

}  // namespace isect::viz
