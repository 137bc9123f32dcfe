#include "viz/walk/alt_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <string_view>
#include <utility>

#include "viz/chart/chart.h"
#include "viz/compose/item_names.h"
#include "viz/lang/language.h"
#include "viz/lang/message.h"
#include "viz/text/rich_text.h"
#include "viz/text/utf8.h"
#include "viz/walk/closing.h"
#include "viz/walk/scene_in_words.h"
#include "viz/walk/step_text.h"

namespace isect::viz {
namespace {

/// Above this many items of one kind, they are counted rather than named.
constexpr std::size_t most_names = 8;

std::string setting_text(const Lesson& lesson, const Setting& setting) {
  if (const auto* choice = std::get_if<std::string>(&setting)) return *choice;
  if (const auto* number = std::get_if<double>(&setting)) return shown(*number);
  const Vec3& p = std::get<Vec3>(setting);
  if (lesson.flat && p.z() == 0) return fmt::format("({}, {})", shown(p.x()), shown(p.y()));
  return fmt::format("({}, {}, {})", shown(p.x()), shown(p.y()), shown(p.z()));
}

/// Returns a word and its symbol, "origin o"; else the text of the label: "size of b", "r₁".
std::string name_of(const Parameter& p) {
  const std::string label = plain(p.label);
  if (label.empty()) return p.name;
  const bool word = p.name.size() > 2 && std::ranges::all_of(p.name, [](char c) { return c >= 'a' && c <= 'z'; });
  return word && count_characters(label) == 1 ? p.name + " " + label : label;
}

/// Returns "origin o = (−3, 0.5, 2), radius r = 1.5".
std::string given(const Lesson& lesson, const Parameters& parameters) {
  std::vector<std::string> all;
  for (const Parameter& p : lesson.parameters) {
    const auto value = parameters.find(p.name);
    if (value == parameters.end()) continue;
    all.push_back(fmt::format("{} = {}", name_of(p), setting_text(lesson, value->second)));
  }
  return fmt::format("{}", fmt::join(all, ", "));
}

/// The kinds of items, and how many of them are told.
constexpr std::pair<std::string_view, Message> kinds_drawn[] = {
    {"ball", message_count("ball", "{n} balls")},
    {"line", message_count("line", "{n} lines")},
    {"arrow", message_count("arrow", "{n} arrows")},
    {"point", message_count("point", "{n} points")},
    {"chain", message_count("chain", "{n} chains")},
    {"circle", message_count("circle", "{n} circles")},
    {"interval", message_count("interval", "{n} intervals")},
    {"region", message_count("region", "{n} regions")},
    {"solid", message_count("solid", "{n} solids")},
    {"mesh", message_count("mesh", "{n} meshes")},
    {"raster", message_count("raster", "{n} rasters")},
    {"heading", message_count("heading", "{n} headings")},
    {"construction line", message_count("construction line", "{n} construction lines")},
    {"construction point", message_count("construction point", "{n} construction points")},
    {"construction circle", message_count("construction circle", "{n} construction circles")},
    {"highlight line", message_count("highlight line", "{n} highlight lines")},
    {"map", message_count("map", "{n} maps")},
    {"panel", message_count("panel", "{n} panels")},
    {"preset", message_count("preset", "{n} presets")}};

/// Returns "ball", or "3 balls".
std::string counted(std::size_t count, const std::string& what) {
  const auto* const known = std::ranges::find(kinds_drawn, what, &std::pair<std::string_view, Message>::first);
  if (known != std::end(kinds_drawn)) return tr_count(count, known->second);
  if (count == 1) return what;
  const bool es = what.ends_with("x") || what.ends_with("sh");
  return fmt::format("{} {}{}", count, what, es ? "es" : "s");
}

/// Returns "Fixed: box: (−2, −1.25) to (2, 1.25).", without what the parameters tell.
std::string fixed(const Lesson& lesson, const Parameters& parameters, const Scene& scene) {
  const std::vector<std::string> all = scene_in_words(scene, parameters, lesson.flat);
  return all.empty()
             ? ""
             : "\n" +
                   tr("Fixed: {objects}.", {{"objects", with_minus_signs(fmt::format("{}", fmt::join(all, "; ")))}}) +
                   "\n";
}

/// The items of one kind and role in the picture: how many there are, and their names.
struct Group {
  std::string kind;
  Role role;
  std::size_t count = 0;
  std::vector<std::string> names = {};

  std::string told() const {
    const std::string of_role = role == Role::construction || role == Role::highlight ? name_of(role) + " " : "";
    std::string text = counted(count, of_role + kind);
    if (!names.empty() && names.size() <= most_names) text += fmt::format(" {}", fmt::join(names, ", "));
    return text;
  }
};

/// Returns "ball c, 2 lines, 3 points o, t₁, t₂". Labels are told with what they name, so only headings stand alone.
std::string drawn(const Scene& scene) {
  std::vector<Group> groups;
  for (const Object& o : objects_of(scene)) {
    if (o.kind == "label" || o.kind == "right angle") continue;
    const bool apart = o.role == Role::construction || o.role == Role::highlight;
    auto group = std::ranges::find_if(groups, [&](const Group& g) {
      return g.kind == o.kind &&
             (g.role == o.role || (!apart && g.role != Role::construction && g.role != Role::highlight));
    });
    if (group == groups.end()) group = groups.insert(groups.end(), {o.kind, o.role});
    ++group->count;
    if (!o.name.empty() && std::ranges::find(group->names, o.name) == group->names.end())
      group->names.push_back(o.name);
  }
  std::vector<std::string> all;
  for (const Group& group : groups) all.push_back(group.told());
  return fmt::format("{}", fmt::join(all, "; "));
}

std::vector<std::string> all_plain(const auto& items, const auto& markup_of) {
  std::vector<std::string> all;
  for (const auto& item : items)
    if (const std::string text = plain(markup_of(item)); !text.empty()) all.push_back(text);
  return all;
}

std::string without_period(std::string text) {
  if (text.ends_with('.')) text.pop_back();
  return text;
}

std::string told(const Plot& plot) {
  const auto panels = all_plain(plot.panels, [](const Panel& p) { return p.title; });
  const auto series = all_plain(plot.series, [](const Series& s) { return s.name; });
  std::string text = fmt::format("A chart of {} against {}", plain(plot.y.title), plain(plot.x.title));
  if (plot.panels.size() > 1) text += fmt::format(", in {} panels", plot.panels.size());
  if (!panels.empty()) text += fmt::format(": {}", fmt::join(panels, ", "));
  if (!series.empty()) text += fmt::format(". It compares {}", fmt::join(series, ", "));
  return text;
}

std::string told(const Maps& maps) {
  const auto titles = all_plain(maps.maps, [](const Map& m) { return m.title; });
  const auto kinds = all_plain(maps.kinds, [](const auto& k) { return k.first; });
  return fmt::format("{} of verdicts, cell by cell: {}. A cell says {}", counted(maps.maps.size(), "map"),
                     fmt::join(titles, ", "), fmt::join(kinds, ", "));
}

std::string told(const Bars& bars) {
  const auto rows = all_plain(bars.bars, [](const Bar& b) { return b.text.empty() ? b.name : b.name + ": " + b.text; });
  return fmt::format("A chart of {} rows over {}: {}", bars.bars.size(), plain(bars.x.title), fmt::join(rows, "; "));
}

std::string told(const Mirrored& chart) {
  const auto panels = all_plain(chart.panels, [](const Mirrored::Panel& p) { return p.title; });
  return fmt::format("Bars back to back, in {}: {}. To the left: {}. To the right: {}",
                     counted(chart.panels.size(), "panel"), fmt::join(panels, ", "), plain(chart.kinds[0].first),
                     plain(chart.kinds[1].first));
}

std::string told(const Cases& cases) {
  std::set<int> present;  // the others have no place on this map
  for (const Cases::Patch& patch : cases.patches) present.insert(patch.branch);
  for (const Cases::Spot& spot : cases.presets) present.insert(spot.branch);
  if (cases.here) present.insert(cases.here->branch);
  const auto regions = all_plain(
      present, [&](int branch) -> const std::string& { return cases.branches[static_cast<std::size_t>(branch)]; });
  const auto scale = [](const Scale& s) {
    return tr("{title} from {p} to {q}", {{"title", plain(s.title)}, {"p", shown(s.lo)}, {"q", shown(s.hi)}});
  };
  std::string text =
      tr("A map of all cases, over the plane of two numbers. Across: {x}. Upwards: {y}. Regions: {regions}",
         {{"x", scale(cases.x)}, {"y", scale(cases.y)}, {"regions", fmt::format("{}", fmt::join(regions, ", "))}});
  if (const auto& here = cases.here)
    text += ". " + tr("This setting lies at ({x}, {y}), in the region: {case}",
                      {{"x", shown(here->at.x())},
                       {"y", shown(here->at.y())},
                       {"case", plain(cases.branches.at(static_cast<std::size_t>(here->branch)))}});
  if (!cases.presets.empty())
    text += ". " + tr("Small marks show {presets}", {{"presets", counted(cases.presets.size(), "preset")}});
  return text;
}

std::string told(const Card& card) {
  std::string text = tr("A card of text");
  for (const auto& [head, row] : card.rows) text += fmt::format(". {}: {}", plain(head), without_period(plain(row)));
  return text;
}

/// Returns " (lengths of d)", or nothing where the name says it: "volume of a" needs no unit.
std::string unit_of(const Value& v) {
  const std::string unit = plain(v.unit);
  return unit.empty() || plain(v.name).find(unit) != std::string::npos ? "" : " (" + unit + ")";
}

/// Returns the numbers that are new in this step.
std::string fresh_values(const Step& step) {
  std::vector<std::string> all;
  const std::vector<std::string> digits = shown(step.values);
  for (std::size_t i = 0; i < digits.size(); ++i)
    if (const Value& v = step.values[i]; v.fresh)
      all.push_back(fmt::format("{} = {}{}", plain(v.name), digits[i], unit_of(v)));
  return fmt::format("{}", fmt::join(all, ", "));
}

}  // namespace

std::vector<std::string> shown(const std::vector<Value>& values) {
  const std::size_t n = values.size();
  const bool has_zero =
      std::ranges::any_of(values, [](const Value& v) { return v.value == 0 && !std::signbit(v.value); });
  std::vector<std::string> alone, digits;
  for (const Value& v : values) alone.push_back(shown(v.value));
  for (std::size_t i = 0; i < n; ++i) {
    const double value = values[i].value;
    bool mistaken = false;
    for (std::size_t k = 0; k < n && !std::isnan(value); ++k)
      mistaken |= values[k].value != value && alone[k] == alone[i];
    digits.push_back(mistaken ? to_text(value) : has_zero ? shown_with_sign(value) : alone[i]);
  }
  return digits;
}

std::string listed(const std::vector<Value>& values) {
  const std::vector<std::string> digits = shown(values);
  std::string all;
  for (std::size_t i = 0; i < digits.size(); ++i)
    all += (i == 0 ? "" : ", ") + values[i].name + " = " + as_markup(digits[i]);
  return all;
}

std::string figure_title(const Lesson& lesson, const Step& step) {
  const std::string of_lesson = plain(lesson.title), of_step = plain(step.title);
  return of_lesson == of_step ? of_step : of_lesson + ": " + of_step;  // a scene's first step has its own
}

std::string as_sentence(const std::string& title) {
  return title.ends_with('?') || title.ends_with('!') || title.ends_with('.') ? title : title + ".";
}

std::string drawn_text(const Walk& walk, const Scene& scene, bool outcome) {
  if (scene.chart) return std::visit([](const auto& chart) { return told(chart); }, scene.chart->kind) + ".";
  const std::string what = drawn(scene);
  std::string text = outcome ? plain(walk.alt) : "";
  if (!what.empty()) text += (text.empty() ? "" : " ") + tr("Drawn: {objects}.", {{"objects", what}});
  if (!outcome && !scene.said.empty())
    text += " " + tr("Marked: {marks}.", {{"marks", plain(scene.said)}});  // else the walk says it
  return text;
}

std::string alt_text(const Lesson& lesson, const Parameters& parameters, const Walk& walk, int step) {
  const Speaking speaking(lesson.language);
  const Step& s = walk.steps[step];
  std::string text = as_sentence(figure_title(lesson, s)) + "\n\n";
  if (s.scene.chart)
    text += std::visit([](const auto& chart) { return told(chart); }, s.scene.chart->kind) + ".\n\n";
  else if (step >= outcome(walk))  // before, it would tell the answer
    text += plain(walk.alt) + "\n";
  if (const std::string what = s.scene.chart ? "" : drawn(s.scene); !what.empty())
    text += tr("Drawn: {objects}.", {{"objects", what}}) + "\n";
  if (!s.scene.said.empty() && step < outcome(walk))
    text += tr("Marked: {marks}.", {{"marks", plain(s.scene.said)}}) + "\n";
  const std::string numbers = given(lesson, parameters);
  text += s.scene.chart ? tr("The setting: {numbers}.", {{"numbers", numbers}})
                        : tr("Given: {numbers}.", {{"numbers", numbers}});
  text += "\n\n" + plain(s.caption) + "\n";
  if (!s.scene.chart) text += fixed(lesson, parameters, walk.steps.front().scene);
  const std::optional<ComparisonText> compared = step_text(lesson, walk, step).comparison;
  std::string found;
  if (!s.formula.empty()) found += tr("Formula: {formula}", {{"formula", plain(s.formula)}}) + "\n";
  if (const std::string values = fresh_values(s); !values.empty())
    found += tr("New: {values}", {{"values", values}}) + "\n";
  if (compared) found += plain(fmt::format("{} {} {}\n", compared->question, compared->answer, compared->why));
  if (!s.verdict.text.empty()) found += tr("Verdict: {verdict}", {{"verdict", plain(verdict_text(s.verdict))}}) + "\n";
  return found.empty() ? text : text + "\n" + found;
}

}  // namespace isect::viz
