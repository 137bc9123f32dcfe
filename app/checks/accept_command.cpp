// The command that accepts the failures of a check, ready for a shell.

#include <fmt/format.h>

#include <algorithm>

#include "app/checks/check_report.h"

namespace isect::program {

namespace {

using Kind = Failure::Kind;

bool acceptable(const Failure& f) { return !f.accepted && may_be_accepted(f); }

/// Returns " --dir notes"; nothing if the option was not given.
std::string option(const std::string& name, const std::string& value) {
  if (value.empty()) return {};
  return fmt::format(" {}{}{}", name, value.starts_with("-") ? "=" : " ", quoted(value));
}

/// Returns a preset's own name as --preset takes it: there "all" means every one, and a name that ends in .json a file.
std::string as_asked(const std::string& preset, const Asked& asked) {
  return !asked.dir.empty() && (preset == "all" || preset.ends_with(".json")) ? preset + ".json" : preset;
}

/// Returns the options that say where the baselines are, and what draws.
std::string places(const Asked& asked) {
  return option("--dir", asked.dir) + option("--snapshots", asked.snapshots) + option("--backend", asked.backend);
}

std::string command(const Asked& asked, bool only_missing) {
  std::string text = quoted(asked.program) + " check";
  for (const std::string& lesson : asked.lessons) text += " " + quoted(lesson);
  return text + option("--preset", asked.preset) + places(asked) +
         (only_missing ? " --update=missing" : " --update=failed");
}

/// Returns the lessons that failed, as others need not be run again; none if they are all or do not cover all failures.
std::vector<std::string> lessons_to_name(const Report& r) {
  constexpr std::size_t most = 8;
  std::vector<std::string> failed;
  for (const std::string& lesson : r.by_name)
    if (std::ranges::any_of(r.failures, [&](const Failure& f) { return acceptable(f) && f.lesson == lesson; }))
      failed.push_back(lesson);
  const bool all_known = std::ranges::none_of(r.failures, [&](const Failure& f) {
    return acceptable(f) && std::ranges::find(failed, f.lesson) == failed.end();
  });
  return all_known && failed.size() < std::min(most, r.lessons.size()) ? failed : std::vector<std::string>();
}

}  // namespace

std::string quoted(const std::string& word) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("_-./,:=+@%").find(c) != std::string_view::npos;
  };
  if (!word.empty() && std::ranges::all_of(word, plain)) return word;
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? "'\\''" : std::string(1, c);
  return out + "'";
}

bool may_be_accepted(const Failure& f) { return !f.foreign && f.kind != Kind::blank && f.kind != Kind::preset; }

std::string accept_command(const Report& r) {
  if (std::ranges::none_of(r.failures, acceptable)) return {};
  Asked asked = r.asked;
  if (asked.lessons.empty()) asked.lessons = lessons_to_name(r);
  return command(asked, std::ranges::all_of(
                            r.failures, [](const Failure& f) { return !acceptable(f) || f.kind == Kind::missing; }));
}

std::string accept_file_command(const Report& r) {
  return quoted(r.asked.program) + " check" + places(r.asked) + " --accept";
}

std::string accept_command(const Report& r, const Failure& f) {
  if (!acceptable(f)) return {};
  Asked asked = r.asked;
  const bool known = std::ranges::find(r.checked, std::pair(f.lesson, f.preset)) != r.checked.end();
  // Files of no preset, and the old name of a moved one, are looked for only when all presets are checked.
  if (known && f.kind != Kind::moved) asked.preset = as_asked(f.preset, asked);
  if (std::ranges::find(r.by_name, f.lesson) != r.by_name.end()) asked.lessons = {f.lesson};
  return command(asked, f.kind == Kind::missing);
}

}  // namespace isect::program
