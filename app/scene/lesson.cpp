#include "app/scene/lesson.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <iterator>
#include <limits>
#include <memory>

#include "app/scene/questions.h"
#include "viz/chart.h"
#include "viz/rich_text.h"

namespace isect::program::scene {

namespace {

using viz::Role;

bool runs(Type t) { return t == Type::ray || t == Type::line || t == Type::segment; }
/// What has no inside comes first.
Role usual_role(Type t) { return runs(t) || t == Type::point ? Role::first : Role::second; }

struct Hit {
  std::size_t object;
  double t;
};

class Walker {
 public:
  Walker(const File& file, const viz::Parameters& parameters)
      : file_(file), setting_{parameters, file.flat}, room_(scene::room(setting_, file.objects)) {}

  viz::Walk made() {
    viz::Walk walk;
    walk.alt = "The objects of a scene file.";
    walk.steps.push_back(all_objects());
    for (const Asked& asked : file_.asked)
      walk.steps.push_back(std::visit([&](const auto& a) { return step(a); }, asked));
    if (rows_.size() > 1) walk.steps.push_back(summary());
    return walk;
  }

  Json answers() const {
    Json all = Json::array();
    for (const Asked& asked : file_.asked) {
      if (const PairAsked* pair = std::get_if<PairAsked>(&asked)) {
        const Answer answer = ask(setting_, file_.objects[pair->a], file_.objects[pair->b]);
        all.push_back({{"ask", {file_.objects[pair->a].name, file_.objects[pair->b].name}},
                       {"verdict", viz::plain(answer.verdict.text)},
                       {"query", answer.query},
                       {"result", answer.result}});
      } else {
        const std::size_t ray = std::get<FirstHitAsked>(asked).ray;
        const std::vector<Hit> hits = hits_of(ray);
        Json list = Json::array();
        for (const Hit& hit : hits) list.push_back({{"object", file_.objects[hit.object].name}, {"t", hit.t}});
        all.push_back({{"first hit", file_.objects[ray].name},
                       {"verdict", viz::plain(first_of(ray, hits).text)},
                       {"hits", list}});
      }
    }
    return all;
  }

 private:
  /// The two asked about in colour, the others as lines in grey.
  viz::Scene picture(const std::vector<std::size_t>& lit) const {
    viz::Scene scene;
    for (std::size_t i = 0; i < file_.objects.size(); ++i) {
      const Object& o = file_.objects[i];
      const auto at = std::ranges::find(lit, i);
      Role role = usual_role(o.type);
      if (!lit.empty() && at == lit.end()) role = Role::muted;
      if (lit.size() == 2 && at != lit.end()) role = at == lit.begin() ? Role::first : Role::second;
      std::ranges::move(drawn(setting_, o, room_, role), std::back_inserter(scene.items));
      std::ranges::move(handles(setting_, o, role), std::back_inserter(scene.handles));
    }
    for (const Note& note : file_.notes) scene.items.push_back(viz::Label{note.at, note.text, Role::text});
    return scene;
  }

  viz::Step all_objects() const {
    viz::Step step;
    step.slug = "objects";
    step.title = file_.title;
    std::string list;
    for (const Object& o : file_.objects)
      list += fmt::format("{}{} {}", list.empty() ? "" : ", ", spec(o.type).name, shown_name(o.name));
    step.caption = fmt::format("The scene holds {}.", list);
    step.scene = picture({});
    return step;
  }

  viz::Step step(const PairAsked& asked) {
    const Object &a = file_.objects[asked.a], &b = file_.objects[asked.b];
    Answer answer = ask(setting_, a, b);
    viz::Step step;
    step.slug = fmt::format("{}-{}", slug(a.name), slug(b.name));
    step.title = fmt::format("{} and {}", shown_name(a.name), shown_name(b.name));
    step.caption = fmt::format("Decided exactly for these numbers: {}.", answer.verdict.text);
    step.formula = answer.formula;
    step.verdict = answer.verdict;
    step.values = answer.values;
    step.scene = picture({asked.a, asked.b});
    std::ranges::move(answer.marks, std::back_inserter(step.scene.items));
    rows_.push_back(
        {viz::plain(step.title), answer.verdict.text + (answer.formula.empty() ? "" : ": " + answer.formula)});
    return step;
  }

  std::vector<Hit> hits_of(std::size_t ray) const {
    std::vector<Hit> hits;
    for (std::size_t i = 0; i < file_.objects.size(); ++i) {
      if (i == ray || runs(file_.objects[i].type) ||
          !can_ask(file_.objects[ray].type, file_.objects[i].type, file_.flat))
        continue;
      if (const auto t = ask(setting_, file_.objects[ray], file_.objects[i]).first_hit) hits.push_back({i, *t});
    }
    std::ranges::stable_sort(hits, {}, &Hit::t);
    return hits;
  }

  /// Each t is within 4 ulp of the true one, so closer ones are not told apart.
  viz::Verdict first_of(std::size_t ray, const std::vector<Hit>& hits) const {
    const std::string r = shown_name(file_.objects[ray].name);
    if (hits.empty()) return {viz::Verdict::Kind::no, r + " meets none of them"};
    const std::string first = shown_name(file_.objects[hits[0].object].name);
    constexpr double apart = 8 * std::numeric_limits<double>::epsilon();
    if (hits.size() > 1 && hits[1].t - hits[0].t <= apart * std::max(std::abs(hits[0].t), std::abs(hits[1].t)))
      return {viz::Verdict::Kind::on, fmt::format("{} meets {} and {} at the same t, as far as rounding tells", r,
                                                  first, shown_name(file_.objects[hits[1].object].name))};
    return {viz::Verdict::Kind::yes, fmt::format("{} meets {} first, at t = {}", r, first, viz::shown(hits[0].t))};
  }

  viz::Step step(const FirstHitAsked& asked) {
    const Object& ray = file_.objects[asked.ray];
    const std::vector<Hit> hits = hits_of(asked.ray);
    viz::Step step;
    step.slug = "first-hit-" + slug(ray.name);
    step.title = fmt::format("What {} meets first", shown_name(ray.name));
    step.verdict = first_of(asked.ray, hits);
    std::string order;
    for (const Hit& hit : hits) {
      const std::string name = shown_name(file_.objects[hit.object].name);
      order += fmt::format("{}{} at {}", order.empty() ? "" : ", ", name, viz::shown(hit.t));
      step.values.push_back({"*t* of " + name, hit.t, "t", Role::hit, true});
    }
    step.caption = hits.empty() ? "Each object was asked; none is met."
                                : fmt::format("Each object was asked; by rising *t* these are met: {}.", order);
    std::vector<std::size_t> lit = {asked.ray};
    for (const Hit& hit : hits) lit.push_back(hit.object);
    step.scene = picture(lit);
    for (const Hit& hit : hits) {
      Answer answer = ask(setting_, ray, file_.objects[hit.object]);
      if (!answer.marks.empty()) step.scene.items.push_back(answer.marks.front());
    }
    rows_.push_back({viz::plain(step.title), step.verdict.text});
    return step;
  }

  viz::Step summary() const {
    viz::Step step;
    step.slug = "answers";
    step.title = "All answers";
    step.caption = "Each was decided exactly for the numbers of the scene.";
    viz::Card card;
    for (const auto& [head, text] : rows_) card.rows.push_back({head, text});
    step.scene.chart = std::make_shared<const viz::Chart>(viz::Chart{card});
    return step;
  }

  static std::string slug(std::string name) {
    for (char& c : name)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return name;
  }

  const File& file_;
  Setting setting_;
  Room room_;
  std::vector<std::pair<std::string, std::string>> rows_;
};

/// The knobs of the window: every number of the file.
std::vector<viz::Parameter> parameters_of(const File& file) {
  std::vector<viz::Parameter> all;
  for (const Object& o : file.objects)
    for (const std::string& field : o.fields) {
      const auto known = std::ranges::find(spec(o.type).fields, field, &FieldSpec::name);
      const bool vertex = known == spec(o.type).fields.end();
      const bool its_place = field == "center" || field == "at" || field == "origin";
      viz::Parameter p = {o.name + "." + field, shown_name(o.name) + (its_place ? "" : "." + field),
                          vertex ? "A vertex of " + o.name + "." : fmt::format("Of {}: {}.", o.name, known->help),
                          file.parameters.at(o.name + "." + field)};
      if (!vertex) p.lo = known->lo, p.hi = known->hi, p.drag_lo = std::max(p.drag_lo, p.lo);
      all.push_back(std::move(p));
    }
  return all;
}

std::vector<viz::Condition> conditions_of(const File& file) {
  std::vector<viz::Condition> all;
  for (const Object& o : file.objects)
    for (const std::string& field : o.fields)
      if (field == "dir" || field == "normal") {
        const std::string name = o.name + "." + field;
        all.push_back({name, "a vector of any length but 0",
                       [name](const viz::Parameters& p) { return !std::get<viz::Vec3>(p.at(name)).isZero(0); }});
      }
  return all;
}

}  // namespace

viz::Lesson lesson_of(const std::string& text) {
  const auto file = std::make_shared<const File>(read_scene(text));
  viz::Lesson lesson;
  lesson.id = "scene";
  lesson.title = file->title;
  lesson.summary = fmt::format("A scene of {} object{}, and {} question{} about {}.", file->objects.size(),
                               file->objects.size() == 1 ? "" : "s", file->asked.size(),
                               file->asked.size() == 1 ? "" : "s", file->objects.size() == 1 ? "it" : "them");
  lesson.parameters = parameters_of(*file);
  lesson.conditions = conditions_of(*file);
  lesson.presets = {{"file", "As in the file", "", file->parameters}};
  lesson.camera = file->camera;
  lesson.flat = file->flat;
  lesson.steps = [file](const viz::Parameters& parameters) { return Walker(*file, parameters).made(); };
  lesson.made_from = file->text;
  static_cast<void>(lesson.steps(file->parameters));  // whatever the core refuses is told now
  return lesson;
}

const viz::Lesson& kept_lesson_of(const std::string& text) {
  static std::deque<viz::Lesson> all;  // none of them moves
  return all.emplace_back(lesson_of(text));
}

Json answers(const File& file) { return Walker(file, file.parameters).answers(); }

}  // namespace isect::program::scene
