#include "app/checks/causes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>

#include "app/checks/check_report.h"

namespace isect::program {

namespace {

using Kind = Failure::Kind;
using ChangeOf = viz::Change::Of;

/// What a failure is one of, in the order in which they are counted.
enum class Thing { picture, trace, preset };

Thing thing_of(const Failure& f) {
  const std::filesystem::path file = f.baseline;
  if (f.kind == Kind::preset || f.kind == Kind::moved || !file.has_extension()) return Thing::preset;
  return file.filename() == "trace.json" ? Thing::trace : Thing::picture;
}

}  // namespace

std::string cause_of_trace(const std::vector<viz::Change>& sorted) {
  return sorted.empty() ? std::string() : sorted.front().cause;
}

std::string cause_of_picture(const std::vector<viz::Change>& sorted, int step) {
  const auto setting = std::ranges::find(sorted, ChangeOf::setting, &viz::Change::of);
  if (setting != sorted.end()) return setting->cause;
  const auto here = [&](const viz::Change& c, ChangeOf of) { return c.step == step && c.of == of; };
  if (std::ranges::none_of(sorted, [&](const viz::Change& c) { return here(c, ChangeOf::drawing); }))
    return only_pixels;
  return std::ranges::find_if(
             sorted, [&](const viz::Change& c) { return here(c, ChangeOf::course) || here(c, ChangeOf::drawing); })
      ->cause;
}

std::string cause_of(Kind kind) {
  switch (kind) {
    case Kind::missing:
      return "no baseline yet";
    case Kind::orphan:
      return "no step has these baselines any more";
    case Kind::moved:
      return "the same under another name";
    case Kind::preset:
      return "the preset can't be read";
    case Kind::unreadable:
      return "the baseline can't be read";
    case Kind::blank:
      return "the picture is blank";
    case Kind::size:
      return "the size is another";
    case Kind::text:
      return "the text of the picture differs";
    case Kind::trace:
    case Kind::picture:
      break;
  }
  return only_pixels;
}

std::string cause_of(const Failure& f) { return f.cause.empty() ? cause_of(f.kind) : f.cause; }

std::vector<CauseGroup> by_cause(const Report& r) {
  std::vector<CauseGroup> groups;
  std::map<std::string, std::size_t> known;
  for (const Failure& f : r.failures) {
    if (f.accepted) continue;
    const std::string cause = cause_of(f);
    const auto [place, fresh] = known.try_emplace(cause, groups.size());
    if (fresh) groups.push_back({cause, {}});
    groups[place->second].failures.push_back(&f);
  }
  std::ranges::stable_sort(groups, std::ranges::greater(), [](const CauseGroup& g) { return g.failures.size(); });
  return groups;
}

std::string counted(const std::vector<const Failure*>& failures) {
  constexpr std::array names = {"picture", "trace", "preset"};
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto n = std::ranges::count_if(failures, [&](const Failure* f) { return thing_of(*f) == Thing(i); });
    if (n > 0) text += fmt::format("{}{} {}{}", text.empty() ? "" : " and ", n, names[i], n == 1 ? "" : "s");
  }
  return text;
}

std::string heading(const CauseGroup& group) { return counted(group.failures) + ": " + group.cause; }

}  // namespace isect::program
