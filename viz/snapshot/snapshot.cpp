#include "viz/snapshot/snapshot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "viz/player/reader_state.h"
#include "viz/snapshot/drawing_summary.h"
#include "viz/snapshot/step_json.h"

namespace isect::viz {

namespace {

using snap::at, snap::Changes, snap::Json;

constexpr int format_version = 3;

/// Returns a list with one element per line.
std::string lines_of(const Json& list) {
  std::string text = "[";
  for (std::size_t i = 0; i < list.size(); ++i) text += (i ? ",\n  " : "\n  ") + list[i].dump();
  return text + "\n]";
}

/// Returns the text with one member per line, and one object of the drawing per line.
std::string text_of(const Json& said, const Json& drawing) {
  std::string text = "{";
  for (const auto& item : said.items())
    text += (text.size() == 1 ? "" : ",\n   ") + Json(item.key()).dump() + ": " + item.value().dump();
  if (drawing.is_null()) return text + "}";
  text += ",\n   \"drawing\": {";
  if (drawing.contains("order")) text += "\"order\": " + drawing["order"].dump() + ",";
  text += "\"objects\": {";
  bool first = true;
  for (const auto& item : drawing["objects"].items()) {
    text += (first ? "\n    " : ",\n    ") + Json(item.key()).dump() + ": " + item.value().dump();
    first = false;
  }
  return text + "}}}";
}

/// Compares the pseudocode line by line, if there are as many lines.
void compare_pseudocode(const Json& was, const Json& is, Changes& changes) {
  if (!was.is_array() || was.size() != is.size()) return changes.add("the pseudocode has other lines");
  for (std::size_t i = 0; i < is.size(); ++i) changes.compare(fmt::format("pseudocode line {}", i + 1), was[i], is[i]);
}

void compare_opinions(const Json& was, const Json& is, Changes& changes) {
  if (was == is) return;
  if (!was.is_array() || !is.is_array() || was.size() != is.size())
    return changes.add("other methods are asked side by side");
  for (std::size_t i = 0; i < is.size(); ++i) {
    const std::string name = "opinion of the " + snap::shown(at(is[i], "method"));
    for (const std::string key : {"method", "says"}) changes.compare_texts(name, at(was[i], key), at(is[i], key));
    changes.compare(name + " agrees:", at(was[i], "agrees"), at(is[i], "agrees"));
  }
}

/// Compares lists of texts, member by member: "prompt of exercise 2 was ..., is ...".
void compare_lists(const std::string& what, const Json& was, const Json& is, Changes& changes) {
  if (was == is) return;
  if (!was.is_array() || !is.is_array() || was.size() != is.size())
    return changes.add(fmt::format("there are other cases of {} than before", what));
  for (std::size_t i = 0; i < is.size(); ++i)
    for (const auto& item : is[i].items())
      changes.compare_texts(fmt::format("{} of {} {}", item.key(), what, i + 1), at(was[i], item.key()), item.value());
}

std::vector<Change> lone_change(const std::string& what, const std::string& cause) {
  return {{-1, what, Change::Of::course, cause}};
}

Json without_drawing(Json step) {
  if (step.is_object()) step.erase("drawing");
  return step;
}

void compare_all_steps(const Json& were, const Json& are, Changes& changes) {
  Json summary_was, summary_is;
  for (std::size_t i = 0; i < std::min(were.size(), are.size()); ++i) {
    changes.of_step(static_cast<int>(i));
    changes.are_of(Change::Of::course);
    compare_steps(without_drawing(were[i]), without_drawing(are[i]), changes);
    summary_was = snap::after(std::move(summary_was), at(were[i], "drawing"));
    summary_is = snap::after(std::move(summary_is), at(are[i], "drawing"));
    changes.are_of(Change::Of::drawing);
    for (const auto& [what, cause] : snap::differences(summary_was, summary_is)) changes.add(what, cause);
  }
  changes.of_step(-1);
  changes.are_of(Change::Of::course);
  if (were.size() != are.size()) changes.add(fmt::format("{} steps became {}", were.size(), are.size()));
}

}  // namespace

std::string trace_json(const Lesson& lesson, const std::string& preset, const Parameters& parameters, const Walk& walk,
                       const std::vector<Drawing>& drawings, const Stamp& stamp, Tells tells) {
  std::string text = fmt::format("{{\n\"format\": {},\n\"lesson\": {},\n\"preset\": {},\n", format_version,
                                 Json(lesson.id).dump(), Json(preset).dump());
  const Json made = {{"renderer", stamp.renderer}, {"font", stamp.font}, {"theme", stamp.theme}, {"size", stamp.size}};
  text += fmt::format("\"made with\": {},\n\"parameters\": {},\n\"method\": {},\n\"pseudocode\": {},\n", made.dump(),
                      to_json(parameters), Json(walk.method).dump(), lines_of(walk.pseudocode));
  text += fmt::format("\"alt\": {},\n", Json(walk.alt).dump());
  if (lesson.opinions) text += fmt::format("\"opinions\": {},\n", lines_of(snap::json_of(lesson.opinions(parameters))));
  if (tells == Tells::lesson && !lesson.presets.empty() &&
      preset == lesson.presets.front().id) {  // the same for all presets, so recorded once
    if (lesson.closing) text += fmt::format("\"exercises\": {},\n", lines_of(snap::json_of(lesson.closing->exercises)));
    if (!lesson.errata.empty()) text += fmt::format("\"errata\": {},\n", lines_of(snap::json_of(lesson.errata)));
  }
  text += "\"steps\": [";
  Json before;
  for (std::size_t i = 0; i < walk.steps.size(); ++i) {
    Json drawing, now;
    if (i < drawings.size()) {
      now = snap::drawing_summary(drawings[i]);
      drawing = snap::change(before, now);
      before = std::move(now);
    }
    text += (i ? ",\n  " : "\n  ") + text_of(snap::json_of(walk.steps[i]), drawing);
  }
  return text + "\n]\n}\n";
}

std::vector<Change> compare_traces(const std::string& accepted, const std::string& fresh) {
  if (accepted == fresh) return {};
  const Json was = snap::parsed(accepted), is = Json::parse(fresh);
  if (!was.is_object() || !at(was, "steps").is_array())
    return lone_change("the accepted trace is damaged: no JSON with steps", "the accepted trace is damaged");
  if (at(was, "format") != at(is, "format"))
    return lone_change(fmt::format("the accepted trace has format {}, this program writes format {}, which tells more: "
                                   "accept it anew, and nothing else is compared until then",
                                   snap::shown(at(was, "format")), at(is, "format").dump()),
                       "the accepted trace has another format");

  Changes changes;
  changes.are_of(Change::Of::setting);
  changes.compare_all("", at(was, "made with").is_object() ? was["made with"] : Json::object(), is["made with"]);
  for (const std::string key : {"lesson", "preset", "method"}) changes.compare(key, at(was, key), is[key]);
  changes.compare_all("parameter ", at(was, "parameters").is_object() ? was["parameters"] : Json::object(),
                      is["parameters"]);
  compare_all_steps(was["steps"], is["steps"], changes);
  changes.are_of(Change::Of::course);
  compare_pseudocode(at(was, "pseudocode"), is["pseudocode"], changes);
  compare_opinions(at(was, "opinions"), at(is, "opinions"), changes);
  changes.are_of(Change::Of::wording);
  changes.compare_texts("alt text", at(was, "alt"), is["alt"]);
  compare_lists("exercise", at(was, "exercises"), at(is, "exercises"), changes);
  compare_lists("erratum", at(was, "errata"), at(is, "errata"), changes);
  return changes.take();
}

std::string file_stem(int step, const Step& s) { return fmt::format("{:02}-{}", step + 1, s.slug); }

bool blank(const Picture& picture) {
  const std::uint8_t* first = picture.rgba.data();
  for (std::size_t i = 4; i + 4 <= picture.rgba.size(); i += 4)
    if (std::memcmp(first, first + i, 4) != 0) return false;
  return true;
}

}  // namespace isect::viz
