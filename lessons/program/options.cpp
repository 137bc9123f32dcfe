#include "lessons/program/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <map>
#include <optional>

#include "lessons/program/setting_name.h"
#include "viz/files.h"
#include "viz/place.h"

namespace isect::program {

namespace {

template <class T>
std::optional<T> number(std::string_view text) {
  T value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  return value;
}

bool is_file(const std::string& preset) {
  return preset.ends_with(".json") || preset.find('/') != std::string::npos;
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

void change(Excerpt& to, const std::vector<std::string>& changes) {
  const viz::Parameters before = to.parameters;
  for (const std::string& text : changes) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos)
      throw viz::BadInput(fmt::format("set: \"{}\" has no '='; write name=value, such as {}={}", text,
                                      to.lesson->parameters.front().name,
                                      viz::to_text(to.lesson->parameters.front().initial)));
    viz::set(*to.lesson, to.parameters, text.substr(0, equals), text.substr(equals + 1));
  }
  to.folder += name_of_change(before, to.parameters);
  if (!to.preset.empty() && to.parameters != viz::preset(*to.lesson, to.preset).parameters) to.preset.clear();
}

/// The preset of a file, whose name becomes the folder's.
Excerpt from_file(const Program& program, const PresetFile& file) {
  viz::Place place;
  try {
    place = viz::place_from_json(viz::read_file(file.path), program.lessons);
  } catch (const viz::BadInput& e) {
    throw viz::BadInput(fmt::format("{}: {}", file.path, e.what()));
  }
  Excerpt e;
  e.lesson = &viz::lesson_named(program.lessons, place.lesson);
  e.folder = file.name;
  e.preset = place.preset;
  e.parameters = *place.parameters;
  return e;
}

/// The lessons asked for; none if the answer is left to a preset's file.
std::vector<const viz::Lesson*> lessons_of(const Program& program, const Selection& asked) {
  if (program.only) return {program.only};
  if (asked.all && !asked.lessons.empty())
    throw viz::BadInput("lesson: give either names or --all, not both");
  if (asked.all) return program.lessons;
  std::vector<const viz::Lesson*> lessons;
  for (const std::string& id : asked.lessons) {
    const viz::Lesson* lesson = &viz::lesson_named(program.lessons, id);
    if (std::ranges::find(lessons, lesson) == lessons.end()) lessons.push_back(lesson);
  }
  return lessons;
}

void walk(Excerpt& e, const std::string& step, bool one_of_many) {
  e.walk = e.lesson->walk(e.parameters);
  const int count = static_cast<int>(e.walk.steps.size());
  if (step == "all") {
    for (int i = 0; i < count; ++i) e.steps.push_back(i);
    return;
  }
  const std::optional<int> number = program::number<int>(step);
  if (!number || *number < 1 || (*number > count && !one_of_many))
    throw viz::BadInput(
        fmt::format("step: \"{}\" is unknown; {} has steps 1 to {}, or give all", step, e.folder, count));
  if (*number <= count) e.steps.push_back(*number - 1);
}

}  // namespace

void add_lesson(CLI::App& sub, const Program& program, Selection& to, Takes takes, const std::string& help) {
  if (program.only) return;
  CLI::Option* lesson = sub.add_option("LESSON", to.lessons, help)->type_name("");
  if (takes == Takes::one) lesson->expected(0, 1);
}

void add_preset(CLI::App& sub, Selection& to, const std::string& help) {
  sub.add_option("--preset", to.preset, help)->type_name("NAME|FILE")->check(not_empty());
}

void add_step(CLI::App& sub, Selection& to, Takes takes, const std::string& help) {
  sub.add_option("--step", to.step, help)->type_name(takes == Takes::one ? "N" : "N|all");
}

void add_set(CLI::App& sub, Selection& to) {
  sub.add_option("--set", to.changes, "change a parameter; may be repeated")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
}

CLI::Validator not_empty() {
  const auto complaint = [](const std::string& value) { return value.empty() ? "empty; give a name" : ""; };
  return {complaint, ""};
}

CLI::Option* add_path(CLI::App& sub, const std::string& name, std::string& to, const std::string& help,
                      const std::string& type) {
  return sub.add_option(name, to, help)->type_name(type)->check(not_empty());
}

std::vector<Excerpt> excerpts(const Program& program, const Selection& asked) {
  std::vector<const viz::Lesson*> lessons = lessons_of(program, asked);
  std::vector<Excerpt> found;
  if (!asked.files.empty()) {
    for (const PresetFile& file : asked.files) {
      Excerpt e = from_file(program, file);
      if (lessons.empty() || std::ranges::find(lessons, e.lesson) != lessons.end())
        found.push_back(std::move(e));
    }
    if (found.empty())
      throw viz::BadInput(fmt::format("lesson: no preset file is for {}", fmt::join(asked.lessons, ", ")));
    std::ranges::stable_sort(found, {}, [](const Excerpt& e) { return e.lesson->id; });
  } else if (is_file(asked.preset)) {
    found.push_back(from_file(program, {asked.preset, std::filesystem::path(asked.preset).stem()}));
    if (!lessons.empty() && std::ranges::find(lessons, found[0].lesson) == lessons.end())
      throw viz::BadInput(
          fmt::format("preset: {} is for {}, not for {}", asked.preset, found[0].lesson->id, lessons[0]->id));
  } else if (lessons.empty()) {
    std::vector<std::string> ids;
    for (const viz::Lesson* lesson : program.lessons) ids.push_back(lesson->id);
    throw viz::BadInput(fmt::format("lesson: none given; allowed: {}", fmt::join(ids, ", ")));
  } else {
    for (const viz::Lesson* lesson : lessons) {
      const bool every = asked.preset == "all" || (asked.preset.empty() && asked.all);
      const auto add = [&](const viz::Preset& p) {
        found.push_back({lesson, p.id, p.id, p.parameters, {}, {}});
      };
      if (every)
        std::ranges::for_each(lesson->presets, add);
      else
        add(asked.preset.empty() ? lesson->presets.front() : viz::preset(*lesson, asked.preset));
    }
  }
  for (Excerpt& e : found) {
    change(e, asked.changes);
    walk(e, asked.step, found.size() > 1);
  }
  if (std::ranges::all_of(found, [](const Excerpt& e) { return e.steps.empty(); }))
    throw viz::BadInput(fmt::format("step: \"{}\" is unknown; no preset has so many", asked.step));
  return found;
}

Excerpt excerpt(const Program& program, const Selection& asked) {
  if (asked.preset == "all") throw viz::BadInput("preset: \"all\" does not do here; name one");
  return std::move(excerpts(program, asked).front());
}

Size size_of(const std::string& text) {
  constexpr int least = 16, most = 8192;
  const std::size_t x = text.find('x');
  const auto side = [&](const std::string& part) {
    const std::optional<int> n = number<int>(part);
    if (x == std::string::npos || !n || *n < least || *n > most)
      throw viz::BadInput(fmt::format(
          "size: \"{}\" does not do; give WIDTHxHEIGHT, each {} to {}, such as 960x600", text, least, most));
    return *n;
  };
  return {side(text.substr(0, x)), side(x == std::string::npos ? text : text.substr(x + 1))};
}

double points_of(const std::string& text) {
  struct Unit {
    const char* name;
    double points;
  };
  constexpr double least = 10, most = 14400;
  for (const Unit& unit : {Unit{"cm", 72 / 2.54}, Unit{"mm", 72 / 25.4}, Unit{"in", 72}, Unit{"pt", 1}}) {
    if (!text.ends_with(unit.name)) continue;
    const std::optional<double> n = number<double>(text.substr(0, text.size() - 2));
    if (n && *n * unit.points >= least && *n * unit.points <= most) return *n * unit.points;
  }
  throw viz::BadInput(fmt::format(
      "width: \"{}\" does not do; give a width with its unit (cm, mm, pt, in), {}pt to {}pt, such as 8cm",
      text, least, most));
}

std::vector<std::string> formats_of(const std::string& text) {
  const std::vector<std::string> allowed = {"png", "svg"};
  std::vector<std::string> formats;
  for (const std::string& name : split(text, ',')) {
    if (std::ranges::find(allowed, name) == allowed.end()) throw viz::unknown("format", name, allowed);
    if (std::ranges::find(formats, name) == formats.end()) formats.push_back(name);
  }
  return formats;
}

namespace {

/// The walks of all presets, made once for each lesson: presets stay as they are.
const std::vector<viz::Walk>& walks_of(const viz::Lesson& lesson) {
  static std::map<const viz::Lesson*, std::vector<viz::Walk>> known;
  std::vector<viz::Walk>& walks = known[&lesson];
  if (walks.empty())
    for (const viz::Preset& p : lesson.presets) walks.push_back(lesson.walk(p.parameters));
  return walks;
}

}  // namespace

viz::Camera camera_for(const viz::Lesson& lesson, const viz::Walk& walk, viz::ThemeName theme,
                       const Size& size) {
  return viz::frame_alike(lesson.camera, walk, walks_of(lesson),
                          viz::picture_aspect(walk, theme, size.width, size.height));
}

}  // namespace isect::program
