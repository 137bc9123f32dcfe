#include "app/scene/lesson.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <mutex>

#include "app/scene/scene_steps.h"
#include "app/scene/types.h"

namespace isect::program::scene {

namespace {

/// Returns the knobs of the window: every number of the file.
std::vector<viz::Parameter> parameters_of(const File& file) {
  std::vector<viz::Parameter> all;
  for (const Object& o : file.objects)
    for (const std::string& field : o.fields) {
      const auto known = std::ranges::find(spec(o.type).fields, field, &FieldSpec::name);
      const bool vertex = known == spec(o.type).fields.end();
      const bool its_place = field == "center" || field == "at" || field == "origin";
      const bool slab = vertex && o.type == Type::kdop;
      const bool moves = vertex && field == "at";
      const std::string help = moves    ? fmt::format("How far {} is moved from where its points are given.", o.name)
                               : slab   ? "An end of a slab of " + o.name + "."
                               : vertex ? fmt::format("A point of {}.", o.name)
                                        : fmt::format("Of {}: {}.", o.name, known->help);
      viz::Parameter p = {o.name + "." + field, shown_name(o.name) + (its_place ? "" : "." + field), help,
                          file.parameters.at(o.name + "." + field)};
      if (!vertex) p.lo = known->lo, p.hi = known->hi, p.drag_lo = std::max(p.drag_lo, p.lo);
      all.push_back(std::move(p));
    }
  return all;
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
      all.push_back({name, rule.allowed, [o, rule, flat = file.flat](const viz::Parameters& p) {
                       return rule.holds({p, flat}, o);
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
  viz::Lesson lesson;
  lesson.id = "scene";
  lesson.title = file.title;
  lesson.summary = fmt::format("A scene of {} object{}, and {} question{} about {}.", file.objects.size(),
                               file.objects.size() == 1 ? "" : "s", file.asked.size(),
                               file.asked.size() == 1 ? "" : "s", file.objects.size() == 1 ? "it" : "them");
  lesson.parameters = parameters_of(file);
  lesson.conditions = conditions_of(file);
  lesson.presets = {{"file", "As in the file", "", file.parameters}};
  lesson.camera = file.camera;
  lesson.flat = file.flat;
  lesson.made_from = file.text;
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
