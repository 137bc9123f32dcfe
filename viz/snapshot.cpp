#include "viz/snapshot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <nlohmann/json.hpp>

#include "viz/place.h"
#include "viz/rich_text.h"

namespace isect::viz {

namespace {

using Json = nlohmann::ordered_json;

constexpr int format_version = 1;

std::string digits(double x) { return fmt::format("{:.9g}", x == 0 ? 0.0 : x); }  // -0 is 0

/// How two numbers lie, exactly.
std::string relation(double a, double b) { return a < b ? "<" : a > b ? ">" : a == b ? "=" : "?"; }

/// "m² ≤ r²" -> {"m²", "r²"}: the names of both sides; the numbers stand in where there is no sign between
/// them.
std::pair<std::string, std::string> sides(const Comparison& c) {
  const std::string text = plain(c.text);
  for (const std::string sign : {" ≤ ", " ≥ ", " < ", " > ", " = ", " ≠ ", " <= ", " >= "})
    if (const std::size_t at = text.find(sign); at != std::string::npos)
      return {text.substr(0, at), text.substr(at + sign.size())};
  return {digits(c.left), digits(c.right)};
}

Json json(const Comparison& c) {
  const auto [left, right] = sides(c);
  return {{"left", left},
          {"relation", relation(c.left, c.right)},
          {"right", right},
          {"values", {digits(c.left), digits(c.right)}},
          {"holds", c.holds}};
}

Json json(const Counters& c) {
  return {{"mul", c.mul},   {"add", c.add},         {"div", c.div},
          {"sqrt", c.sqrt}, {"compare", c.compare}, {"early out", c.early_out}};
}

std::string in_words(const Verdict& v) {
  constexpr std::array kinds = {"open", "yes", "no", "on"};
  const std::string kind = kinds.at(static_cast<std::size_t>(v.kind));
  return v.text.empty() ? kind : kind + ": " + plain(v.text);
}

Json json(const Step& step) {
  Json object = {
      {"slug", step.slug}, {"title", plain(step.title)}, {"line", step.line + 1}, {"decides", step.decides}};
  object["verdict"] = in_words(step.verdict);
  if (step.comparison) object["comparison"] = json(*step.comparison);
  object["values"] = Json::array();
  for (const Value& v : step.values) object["values"].push_back({plain(v.name), digits(v.value)});
  object["counters"] = json(step.counters);
  if (step.question && !step.question->choices.empty())
    object["answer"] = plain(step.question->choices.at(static_cast<std::size_t>(step.question->answer)));
  return object;
}

/// Text as it is, everything else as JSON.
std::string shown(const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

const Json& at(const Json& object, const std::string& key) {
  static const Json absent = "absent";
  return object.is_object() && object.contains(key) ? object.at(key) : absent;
}

/// Collects the changes of one step, or of none.
class Changes {
 public:
  void of_step(int step) { step_ = step; }
  /// What is said already (a value that is also compared) is not said twice.
  void add(const std::string& what) {
    const auto said = [&](const Change& c) { return c.step == step_ && c.what == what; };
    if (std::ranges::none_of(found_, said)) found_.push_back({step_, what});
  }
  void compare(const std::string& name, const Json& was, const Json& is) {
    if (was != is) add(fmt::format("{} was {}, is {}", name, shown(was), shown(is)));
  }
  /// Every key of either object.
  void compare_all(const std::string& prefix, const Json& was, const Json& is) {
    for (const auto& item : is.items()) compare(prefix + item.key(), at(was, item.key()), item.value());
    for (const auto& item : was.items())
      if (!is.contains(item.key())) compare(prefix + item.key(), item.value(), at(is, item.key()));
  }
  std::vector<Change> take() { return std::move(found_); }

 private:
  int step_ = -1;
  std::vector<Change> found_;
};

std::string left_relation(const Json& c) { return shown(at(c, "left")) + " " + shown(at(c, "relation")); }

void compare_comparisons(const Json& was, const Json& is, Changes& changes) {
  if (was == is) return;
  const bool both = was.is_object() && is.is_object();
  if (!both)
    return changes.add(was.is_object() ? "compares nothing any more"
                                       : "compares " + left_relation(is) + " " + shown(at(is, "right")));
  const std::string right = shown(at(is, "right"));
  if (at(was, "left") != at(is, "left") || at(was, "right") != at(is, "right"))
    return changes.add(fmt::format("compared {} with {}, now {} with {}", shown(at(was, "left")),
                                   shown(at(was, "right")), shown(at(is, "left")), right));
  if (at(was, "relation") != at(is, "relation"))
    changes.add(
        fmt::format("{} {} became {} {}", left_relation(was), right, shown(at(is, "relation")), right));
  if (at(was, "holds") != at(is, "holds"))
    changes.add(fmt::format("the comparison of {} with {} was {}, is {}", shown(at(is, "left")), right,
                            at(was, "holds").dump(), at(is, "holds").dump()));
  // Each side by its name; a side that is a bare number has that number in its name.
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}})
    if (at(was, "values").is_array() && at(was, "values").size() == 2)
      changes.compare(shown(at(is, i == 0 ? "left" : "right")), at(was, "values")[i], at(is, "values")[i]);
}

/// Values by name; a value that is listed twice keeps its first text.
Json by_name(const Json& values) {
  Json object = Json::object();
  if (values.is_array())
    for (const Json& v : values)
      if (v.is_array() && v.size() == 2 && v[0].is_string())
        object.emplace(v[0].get<std::string>(), Json(v[1]));
  return object;
}

void compare_steps(const Json& was, const Json& is, Changes& changes) {
  if (was == is) return;
  if (at(was, "slug") != at(is, "slug"))
    return changes.add(fmt::format("{} became {}", shown(at(was, "slug")), shown(at(is, "slug"))));
  compare_comparisons(at(was, "comparison"), at(is, "comparison"), changes);
  for (const std::string key : {"verdict", "line", "decides", "title", "answer"})
    changes.compare(key == "line" ? "pseudocode line" : key, at(was, key), at(is, key));
  changes.compare_all("", by_name(at(was, "values")), by_name(at(is, "values")));
  if (at(was, "counters").is_object())
    changes.compare_all("count of ", at(was, "counters"), at(is, "counters"));
}

void compare_pseudocode(const Json& was, const Json& is, Changes& changes) {
  if (!was.is_array() || was.size() != is.size()) return changes.add("the pseudocode has other lines");
  for (std::size_t i = 0; i < is.size(); ++i)
    changes.compare(fmt::format("pseudocode line {}", i + 1), was[i], is[i]);
}

}  // namespace

std::string trace_json(const Lesson& lesson, const std::string& preset, const Parameters& parameters,
                       const Walk& walk, const Stamp& stamp) {
  std::string text = fmt::format("{{\n\"format\": {},\n\"lesson\": {},\n\"preset\": {},\n", format_version,
                                 Json(lesson.id).dump(), Json(preset).dump());
  const Json made = {
      {"renderer", stamp.renderer}, {"font", stamp.font}, {"theme", stamp.theme}, {"size", stamp.size}};
  text += fmt::format("\"made with\": {},\n\"parameters\": {},\n\"pseudocode\": [", made.dump(),
                      to_json(parameters));
  for (std::size_t i = 0; i < walk.pseudocode.size(); ++i)
    text += (i ? ",\n  " : "\n  ") + Json(walk.pseudocode[i]).dump();
  text += "\n],\n\"steps\": [";
  for (std::size_t i = 0; i < walk.steps.size(); ++i)
    text += (i ? ",\n  " : "\n  ") + json(walk.steps[i]).dump();
  return text + "\n]\n}\n";
}

std::vector<Change> compare_traces(const std::string& accepted, const std::string& fresh) {
  if (accepted == fresh) return {};
  const Json was = Json::parse(accepted, nullptr, false), is = Json::parse(fresh);
  if (!was.is_object() || !at(was, "steps").is_array())
    return {{-1, "the accepted trace is damaged: no JSON with steps"}};
  if (at(was, "format") != at(is, "format")) return {{-1, "the accepted trace has another format"}};

  Changes changes;
  changes.compare_all("", at(was, "made with").is_object() ? was["made with"] : Json::object(),
                      is["made with"]);
  const Json &steps_were = was["steps"], &steps_are = is["steps"];
  for (std::size_t i = 0; i < std::min(steps_were.size(), steps_are.size()); ++i) {
    changes.of_step(static_cast<int>(i));
    compare_steps(steps_were[i], steps_are[i], changes);
  }
  changes.of_step(-1);
  if (steps_were.size() != steps_are.size())
    changes.add(fmt::format("{} steps became {}", steps_were.size(), steps_are.size()));
  changes.compare("lesson", at(was, "lesson"), is["lesson"]);
  changes.compare("preset", at(was, "preset"), is["preset"]);
  changes.compare_all("parameter ", at(was, "parameters").is_object() ? was["parameters"] : Json::object(),
                      is["parameters"]);
  compare_pseudocode(at(was, "pseudocode"), is["pseudocode"], changes);
  std::vector<Change> found = changes.take();
  if (found.empty()) found.push_back({-1, "the accepted trace is written differently, but says the same"});
  return found;
}

std::string file_stem(int step, const Step& s) { return fmt::format("{:02}-{}", step + 1, s.slug); }

bool blank(const Picture& picture) {
  const std::uint8_t* first = picture.rgba.data();
  for (std::size_t i = 4; i + 4 <= picture.rgba.size(); i += 4)
    if (std::memcmp(first, first + i, 4) != 0) return false;
  return true;
}

}  // namespace isect::viz
