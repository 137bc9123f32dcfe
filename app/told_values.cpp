#include "app/told_values.h"

#include <fmt/format.h>

#include <algorithm>

#include "viz/closing.h"
#include "viz/rich_text.h"

namespace isect::program {

using viz::plain;

std::string in_full(const viz::Setting& setting, bool flat) {
  const auto* p = std::get_if<viz::Vec3>(&setting);
  if (!p) return viz::to_text(setting);
  const std::string xy = viz::to_text(p->x()) + ", " + viz::to_text(p->y());
  return "(" + xy + (flat ? ")" : ", " + viz::to_text(p->z()) + ")");
}

std::vector<std::string> told_errata(const viz::Lesson& lesson, const viz::Walk& walk, std::string viz::Preset::*name) {
  std::vector<std::string> all;
  for (const viz::Erratum& erratum : lesson.errata) {
    const int line = viz::line_of(erratum, walk);
    if (line < 0) continue;
    const std::string shown_by = viz::preset(lesson, erratum.preset).*name;
    const bool published = walk.pseudocode[line] == erratum.published;
    if (!published && std::ranges::count(walk.pseudocode, erratum.published) > 0) {
      all.push_back(
          fmt::format("Line {} is not in the note. {} (See the preset “{}”.)", line + 1, plain(erratum.why), shown_by));
      continue;
    }
    const std::string& other = published ? erratum.corrected : erratum.published;
    all.push_back(fmt::format("Line {} {}: {}. {} (See the preset “{}”.)", line + 1,
                              published ? "should read" : "was published as", viz::unindented(other),
                              plain(erratum.why), shown_by));
  }
  return all;
}

}  // namespace isect::program
