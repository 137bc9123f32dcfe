#include "app/scene/lesson.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <mutex>

#include "app/scene/scene_steps.h"
#include "app/scene/types.h"
#include "viz/lang/language.h"
#include "viz/lang/message.h"

namespace isect::program::scene {

namespace {

std::string help_of(const Object& o, const std::string& field) {
  const auto known = std::ranges::find(spec(o.type).fields, field, &FieldSpec::name);
  if (known != spec(o.type).fields.end()) return fmt::format("Of {}: {}.", o.name, known->help);
  if (field == "at") return fmt::format("How far {} is moved from where its points are given.", o.name);
  if (o.type == Type::kdop) return "An end of a slab of " + o.name + ".";
  return fmt::format("A point of {}.", o.name);
}

/// Returns the knobs of the window: every number of the file, and how far fixed points are moved.
std::vector<viz::Parameter> parameters_of(const File& file) {
  std::vector<viz::Parameter> all;
  for (const Object& o : file.objects) {
    for (const std::string& field : o.fields) {
      const auto known = std::ranges::find(spec(o.type).fields, field, &FieldSpec::name);
      const bool vertex = known == spec(o.type).fields.end();
      const bool its_place = !vertex && (field == "center" || field == "at" || field == "origin");
      viz::Parameter p = {o.name + "." + field, shown_name(o.name) + (its_place ? "" : "." + field), help_of(o, field),
                          file.parameters.at(o.name + "." + field)};
      if (!vertex) p.lo = known->lo, p.hi = known->hi, p.drag_lo = std::max(p.drag_lo, p.lo);
      all.push_back(std::move(p));
    }
    if (!o.lacks_at()) continue;
    all.push_back({o.name + ".at", shown_name(o.name) + ".at", help_of(o, "at"), viz::Vec3(0, 0, 0)});
    all.back().optional = true;
  }
  return all;
}

/// Returns the object's own numbers.
viz::Parameters numbers_of(const File& file, const Object& o) {
  viz::Parameters all;
  for (const std::string& field : o.fields) all.insert(*file.parameters.find(o.name + "." + field));
  return all;
}

/// Whether these numbers are as they were read, which is fine: of many objects a drag moves one.
bool has_all(const viz::Parameters& p, const viz::Parameters& before) {
  return std::ranges::all_of(before, [&](const auto& one) {
    const auto now = p.find(one.first);
    return now != p.end() && now->second == one.second;
  });
}

std::vector<viz::Condition> conditions_of(const File& file) {
  std::vector<viz::Condition> all;
  for (const Object& o : file.objects)
    for (const FieldSpec& field : spec(o.type).fields)
      if (field.means == Means::direction) {
        const std::string name = o.name + "." + field.name;
        all.push_back({name, "a vector of any length but 0",
                       [name](const viz::Parameters& p) { return !std::get<viz::Vec3>(p.at(name)).isZero(0); }});
      }
  const auto add = [&](const Object& o, const ShapeRule& rule) {
    if (const std::string name = o.name + "." + rule.field; file.parameters.contains(name))
      all.push_back({name, rule.allowed, [o, rule, read = numbers_of(file, o), flat = file.flat](const auto& p) {
                       return has_all(p, read) || rule.holds({p, flat}, o);
                     }});
  };
  for (const Object& o : file.objects) {
    for (const ShapeRule& rule : spec(o.type).rules) add(o, rule);
    for (const ShapeRule& rule : spec(o.type).drawable) add(o, rule);
  }
  return all;
}

}  // namespace

viz::Lesson without_steps(const File& file) {
  const viz::Speaking speaking(file.language);
  viz::Lesson lesson;
  lesson.id = "scene";
  lesson.title = file.title;
  lesson.summary = viz::tr_count(file.objects.size(), "A scene of {n} object, and {questions} about it.",
                                 "A scene of {n} objects, and {questions} about them.",
                                 {{"questions", viz::tr_count(file.asked.size(), "{n} question", "{n} questions")}});
  lesson.parameters = parameters_of(file);
  lesson.conditions = conditions_of(file);
  lesson.presets = {{"file", viz::tr("As in the file"), "", file.parameters}};
  lesson.camera = file.camera;
  lesson.flat = file.flat;
  lesson.made_from = file.text;
  lesson.language = file.language;
  return lesson;
}

viz::Lesson lesson_of(const std::string& text, const std::string& folder, const std::shared_ptr<KnownScene>& known) {
  const auto file = std::make_shared<const File>(read_scene(text, folder));
  const auto walk = [file, kept = known ? known : std::make_shared<KnownScene>()](const viz::Parameters& parameters) {
    const std::lock_guard lock(kept->busy);
    return steps_of_scene(*file, parameters, kept->known);
  };
  viz::Lesson lesson = without_steps(*file);
  // What the core refuses is reported now; a large mesh is asked only once.
  lesson.steps = [file, walk, first = std::make_shared<const viz::Walk>(walk(file->parameters))](
                     const viz::Parameters& parameters) {
    return parameters == file->parameters ? *first : walk(parameters);
  };
  return lesson;
}

}  // namespace isect::program::scene
