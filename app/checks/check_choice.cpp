#include "app/checks/check_choice.h"

#include <algorithm>

#include "app/checks/pictured.h"
#include "app/preset_folder.h"

namespace isect::program {

namespace {

/// Returns the name that is meant: the file's own, with or without its ending.
std::string named_as(const std::string& asked, const std::vector<std::string>& names) {
  const std::string ending = ".json";
  for (const std::string& name :
       {asked, asked.ends_with(ending) ? asked.substr(0, asked.size() - ending.size()) : asked})
    if (std::ranges::find(names, name) != names.end()) return name;
  throw viz::unknown("preset", asked, names);
}

/// Stores in `asked` the presets of a folder that are asked for. Returns the broken ones as failures.
std::vector<Failure> choose_own(const Program& program, const std::string& dir, Selection& asked) {
  PresetFolder folder = preset_folder(dir, program);
  say_passed_over(folder);
  if (asked.preset != "all") {
    std::vector<std::string> names;
    for (const PresetFile& file : folder.presets) names.push_back(file.name);
    for (const BrokenPreset& broken : folder.broken) names.push_back(broken.file.name);
    const std::string name = named_as(asked.preset, names);
    std::erase_if(folder.presets, [&](const PresetFile& file) { return file.name != name; });
    std::erase_if(folder.broken, [&](const BrokenPreset& broken) { return broken.file.name != name; });
  }
  asked.files = folder.presets;
  std::vector<Failure> failures;
  for (const BrokenPreset& broken : folder.broken) {
    failures.push_back(failure(Failure::Kind::preset, broken.what, broken.file.path));
    failures.back().preset = broken.file.name;
  }
  return failures;
}

std::vector<Excerpt> chosen_of(const Program& program, const std::string& dir, const Selection& asked) {
  if (!dir.empty() && asked.files.empty()) return {};  // all of them are broken
  std::vector<Excerpt> chosen = excerpts(program, asked);
  for (const Excerpt& e : chosen)
    if (is_own(e) && dir.empty())
      throw viz::BadInput("preset: only the lesson's own presets have baselines here; for files of yours give --dir");
  return chosen;
}

}  // namespace

CheckChoice check_choice(const Program& program, Selection asked, const std::string& dir) {
  CheckChoice choice;
  const bool own = !dir.empty(), all = asked.lessons.empty() && !program.only;
  asked.all = all && !own;
  asked.step = "all";
  if (own) choice.broken = choose_own(program, dir, asked);
  choice.reach = {all && asked.preset == "all", asked.preset == "all"};
  for (const Failure& broken : choice.broken) choice.reach.spared.insert(broken.preset);
  choice.presets = chosen_of(program, dir, asked);
  return choice;
}

}  // namespace isect::program
