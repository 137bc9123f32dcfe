#include "app/scene/lesson.h"

#include <Eigen/Geometry>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>

#include "app/scene/answered.h"
#include "app/scene/save.h"
#include "app/scene/types.h"
#include "app/scene/walks.h"
#include "viz/camera.h"
#include "viz/chart/chart.h"
#include "viz/text/rich_text.h"

namespace isect::program::scene {

namespace {

using viz::Role;

/// Above this many objects, a step about some shows only these, and the step about all shows them without names.
constexpr std::size_t most_in_all_pictures = 200;

/// Points, clouds and what runs along a line come first.
Role usual_role(Type t) {
  return runs_along_a_line(t) || t == Type::point || t == Type::cloud ? Role::first : Role::second;
}

/// Returns the roles for the picture of all objects: the usual ones or, where these would all be equal, as for bodies,
/// two roles, such that objects that are asked about with each other differ.
std::vector<Role> roles_of_all(const File& file) {
  std::vector<Role> roles;
  for (const Object& o : file.objects) roles.push_back(usual_role(o.type));
  if (roles.size() < 2 || std::ranges::adjacent_find(roles, std::ranges::not_equal_to{}) != roles.end()) return roles;
  std::vector<std::vector<std::size_t>> asked_before(roles.size());  // the earlier ones they are asked with
  for (const Asked& asked : file.asked)
    if (const PairAsked* pair = std::get_if<PairAsked>(&asked))
      asked_before[std::max(pair->a, pair->b)].push_back(std::min(pair->a, pair->b));
  for (std::size_t i = 0; i < roles.size(); ++i) {
    const auto first = std::ranges::count_if(asked_before[i], [&](std::size_t k) { return roles[k] == Role::first; });
    const auto second = std::ssize(asked_before[i]) - first;
    roles[i] = (first == second ? i % 2 == 0 : first < second) ? Role::first : Role::second;
  }
  return roles;
}

/// Moves the name of a body of many corners, in its middle or at its top, off the names of others, as this camera sees
/// them: to the highest corner that is free or, if none is, to the one farthest from them.
void part_names(viz::Scene& scene, const Room& room, const viz::Camera& camera) {
  const viz::Vec3 ahead = viz::View(camera, 1, 1).forward();
  const double apart = 0.15 * room.reach;
  std::vector<viz::Label*> names;
  for (viz::Item& item : scene.items)
    if (viz::Label* label = std::get_if<viz::Label>(&item)) names.push_back(label);
  for (viz::Label* label : names) {
    const auto to_others = [&](const viz::Vec3& p) {
      double least = INFINITY;
      for (const viz::Label* other : names)
        if (other != label) least = std::min(least, (other->at - p).cross(ahead).norm());
      return least;
    };
    if (label->until || to_others(label->at) > apart) continue;
    for (const viz::Item& item : scene.items) {
      const std::vector<viz::Vec3>* corners = nullptr;
      if (const viz::Mesh* mesh = std::get_if<viz::Mesh>(&item); mesh && mesh->name == label->text)
        corners = &mesh->vertices;
      if (const viz::Solid* solid = std::get_if<viz::Solid>(&item); solid && solid->name == label->text)
        corners = &solid->vertices;
      if (!corners) continue;
      const auto height = [&](const viz::Vec3& p) { return std::pair(to_others(p) > apart, p.y()); };
      const viz::Vec3& best = *std::ranges::max_element(*corners, {}, height);
      label->at = height(best).first ? best : *std::ranges::max_element(*corners, {}, to_others);
    }
  }
}

/// Returns what no parameter says: the number of triangles or points.
std::string how_many(const Object& o) {
  if (!o.fixed.triangles.empty()) return fmt::format(" of {} triangles", o.fixed.triangles.size());
  return o.fixed.points.empty() ? "" : fmt::format(" of {} points", o.fixed.points.size());
}

/// The answers about pairs, kept while their objects stay: of many objects only one is moved at a time.
class PairAnswers {
 public:
  using Answer = std::shared_ptr<const Answered>;

  /// Uses these numbers from now on.
  void move_to(const File& file, const viz::Parameters& parameters) {
    for (const Object& o : file.objects)
      if (!same(o, parameters))
        std::erase_if(known_, [&](const auto& one) {
          return &file.objects[one.first.first] == &o || &file.objects[one.first.second] == &o;
        });
    numbers_ = parameters;
  }
  Answer of(const Context& context, const PairAsked& asked) {
    Answer& answer = known_[{asked.a, asked.b}];
    if (answer) return answer;
    Answered made = answered(context, asked);
    made.json = {};  // no step needs it
    return answer = std::make_shared<const Answered>(std::move(made));
  }

 private:
  bool same(const Object& o, const viz::Parameters& parameters) const {
    return std::ranges::all_of(o.fields, [&](const std::string& field) {
      const auto was = numbers_.find(o.name + "." + field), is = parameters.find(o.name + "." + field);
      return was != numbers_.end() && is != parameters.end() && was->second == is->second;
    });
  }

  viz::Parameters numbers_;
  std::map<std::pair<std::size_t, std::size_t>, Answer> known_;
};

/// Above this many pairs, those with the same first object share one step.
constexpr std::ptrdiff_t most_steps_of_pairs = 200;
/// The most of their answers in full.
constexpr std::size_t most_told = 12;
/// The most answers on the card of all answers.
constexpr std::size_t most_rows = 36;

class Walker {
  /// A row of the card: one answer.
  struct Row {
    std::string head, text;  ///< markup
    bool says_no;
  };

 public:
  Walker(const File& file, const viz::Parameters& parameters)
      : context_{file, {parameters, file.flat}, room({parameters, file.flat}, file.objects)},
        roles_(roles_of_all(file)) {}

  viz::Walk made(PairAnswers& pairs) {
    const auto asked_of_pairs = std::ranges::count_if(
        context_.file.asked, [](const Asked& asked) { return std::holds_alternative<PairAsked>(asked); });
    viz::Walk walk;
    walk.steps.push_back(all_objects());
    walk.alt = walk.steps[0].caption;
    for (const Note& note : context_.file.notes) walk.alt += " Note: " + note.text + ".";
    const std::vector<Asked>& all = context_.file.asked;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (const WalkAsked* const walked = std::get_if<WalkAsked>(&all[i])) {
        add(*walked, walk);
      } else if (const PairAsked* const pair = std::get_if<PairAsked>(&all[i])) {
        std::vector<PairAnswers::Answer> answers = {pairs.of(context_, *pair)};
        if (asked_of_pairs > most_steps_of_pairs)
          for (; i + 1 < all.size(); ++i) {
            const PairAsked* const next = std::get_if<PairAsked>(&all[i + 1]);
            if (!next || next->a != pair->a) break;
            answers.push_back(pairs.of(context_, *next));
          }
        walk.steps.push_back(step(answers.size() == 1 ? *answers[0] : together(pair->a, answers)));
      } else {
        walk.steps.push_back(step(answer_to(all[i])));
      }
    if (rows_.size() > 1) walk.steps.push_back(summary());
    return walk;
  }

  /// Passes each answer on as JSON, without a step.
  void each_answer(const std::function<void(Json)>& take) {
    for (const Object& o : context_.file.objects)  // what can't be drawn is refused
      static_cast<void>(drawn(context_.numbers, o, context_.room, Role::first));
    for (const Asked& asked : context_.file.asked) {
      viz::Walk unseen;
      if (const WalkAsked* const walked = std::get_if<WalkAsked>(&asked)) add(*walked, unseen);
      take(answer_to(asked).json);
    }
  }

 private:
  Answered answer_to(const Asked& asked) const {
    return std::visit([&](const auto& a) { return answered(context_, a); }, asked);
  }

  /// Returns what an object meets, of all that it was asked about with.
  Answered together(std::size_t object, const std::vector<PairAnswers::Answer>& answers) const {
    const std::string name = context_.name(object);
    Answered out = {slug_of(context_.object(object).name + "-and-others"),
                    fmt::format("{} and {} others", name, answers.size()),
                    "Decided exactly for these numbers.",
                    {viz::Verdict::Kind::no, ""}};
    out.lit = {object};
    std::size_t met = 0, open = 0;
    std::string told;
    for (const PairAnswers::Answer& answer : answers) {
      if (answer->verdict.kind == viz::Verdict::Kind::no) continue;
      ++(answer->verdict.kind == viz::Verdict::Kind::open ? open : met);
      if (out.lit.size() <= most_told) told += (told.empty() ? "\n" : " ") + answer->verdict.text + ".";
      out.lit.push_back(answer->lit.front() == object ? answer->lit.back() : answer->lit.front());
      std::ranges::copy(answer->items, std::back_inserter(out.items));
    }
    out.caption += told;
    if (met + open > most_told) out.caption += fmt::format(" And {} more.", met + open - most_told);
    out.verdict = {met > 0    ? viz::Verdict::Kind::yes
                   : open > 0 ? viz::Verdict::Kind::open
                              : viz::Verdict::Kind::no,
                   fmt::format("{} meets {} of {} others", name, met, answers.size())};
    if (open > 0) out.verdict.text += fmt::format(", and of {} it is not decided", open);
    return out;
  }

  /// Draws the two asked about in colour, the others as lines in grey, unless there are too many.
  viz::Scene picture(const std::vector<std::size_t>& lit) const {
    viz::Scene scene;
    for (std::size_t i = 0; i < context_.file.objects.size(); ++i) {
      const Object& o = context_.object(i);
      const auto at = std::ranges::find(lit, i);
      Role role = lit.empty() ? roles_[i] : usual_role(o.type);
      if (!lit.empty() && at == lit.end()) {
        if (context_.file.objects.size() > most_in_all_pictures) continue;
        role = Role::muted;
      }
      if (lit.size() == 2 && at != lit.end()) role = at == lit.begin() ? Role::first : Role::second;
      std::ranges::move(drawn(context_.numbers, o, context_.room, role), std::back_inserter(scene.items));
      std::ranges::move(handles(context_.numbers, o, role), std::back_inserter(scene.handles));
    }
    const bool too_many = context_.file.objects.size() > most_in_all_pictures;
    if (too_many && lit.empty())
      std::erase_if(scene.items, [](const viz::Item& item) { return std::holds_alternative<viz::Label>(item); });
    else if (!too_many && !context_.file.flat)
      part_names(scene, context_.room, context_.file.camera);
    for (const Note& note : context_.file.notes)  // each on its point
      scene.items.push_back(viz::Label{note.at, note.text, Role::text, note.at});
    return scene;
  }

  viz::Step all_objects() const {
    viz::Step step;
    step.slug = "objects";
    step.title = context_.file.title;
    std::string list;
    for (const Object& o : context_.file.objects)
      list += fmt::format("{}{} {}{}", list.empty() ? "" : ", ", in_words(o.type, context_.file.flat),
                          shown_name(o.name), how_many(o));
    step.caption = fmt::format("The scene holds {}.", list);
    for (const Object& o : context_.file.objects)
      if (!o.note.empty()) step.caption += fmt::format(" {}: {}", shown_name(o.name), viz::as_markup(o.note));
    step.scene = picture({});
    return step;
  }

  viz::Step step(Answered answer) {
    viz::Step step;
    step.slug = answer.slug, step.title = answer.title, step.caption = answer.caption, step.formula = answer.formula;
    step.verdict = answer.verdict, step.values = answer.values;
    step.scene = picture(answer.lit);
    std::ranges::move(answer.items, std::back_inserter(step.scene.items));
    rows_.push_back({step.title, answer.verdict.text + (answer.formula.empty() ? "" : ": " + answer.formula),
                     answer.verdict.kind == viz::Verdict::Kind::no});
    return step;
  }

  /// Adds the lesson's own steps on these numbers; a walk has only one pseudocode, that of the first.
  void add(const WalkAsked& asked, viz::Walk& to) {
    const Object &a = context_.object(asked.a), &b = context_.object(asked.b);
    const bool one = asked.a == asked.b;
    rows_.push_back({!asked.many.empty() ? asked.lesson + ", step by step"
                     : one               ? a.name + ", step by step"
                                         : fmt::format("{} and {}, step by step", a.name, b.name),
                     answered(context_, asked).verdict.text, false});
    if (!asked.many.empty()) return add_of_many(asked, to);
    const LessonWalk& pair = *walk_of(a.type, b.type, context_.file.flat, one, asked.lesson);
    viz::Walk walk = naming_question(asked, [&] { return scene::walk(pair, context_.numbers, a, b); });
    const bool first = to.pseudocode.empty();
    if (first) to.pseudocode = walk.pseudocode;
    for (viz::Step& s : walk.steps) {
      s.slug = slug_of(one ? fmt::format("{}-{}", a.name, s.slug) : fmt::format("{}-{}-{}", a.name, b.name, s.slug));
      if (!first) s.line = -1;
      give_handles(s, handles_of(a, b));
      if (&s == &walk.steps.front()) {
        const std::string second = one ? "" : fmt::format(", and {} is {}", shown_name(b.name), pair.name_b);
        s.caption = fmt::format("Step by step: here {} {} {}{}. {}", shown_name(a.name), one ? "are" : "is",
                                pair.name_a, second, s.caption);
      }
      to.steps.push_back(std::move(s));
    }
  }

  /// Adds to what a lesson refuses its place in the file.
  template <class Made>
  viz::Walk naming_question(const WalkAsked& asked, const Made& made) const {
    try {
      return made();
    } catch (const viz::BadInput& e) {
      const auto at = std::ranges::find_if(context_.file.asked,
                                           [&](const Asked& one) { return std::get_if<WalkAsked>(&one) == &asked; });
      throw viz::BadInput(fmt::format("ask[{}]: {}", at - context_.file.asked.begin(), e.what()));
    }
  }

  /// Adds a walk through many objects, which the lesson numbers in order.
  void add_of_many(const WalkAsked& asked, viz::Walk& to) {
    const LessonWalk& way = *walk_of_many(asked.lesson, asked.method);
    std::vector<const Object*> all;
    std::vector<viz::Handle> handles;
    std::string who;
    for (const std::size_t i : asked.many) {
      all.push_back(&context_.object(i));
      const bool ray = asked.with_ray && all.size() == asked.many.size();
      who += fmt::format("{}{} is {}", all.size() == 1 ? "" : ", ", context_.name(i),
                         ray ? "the ray" : std::to_string(all.size() - 1));
      std::ranges::move(scene::handles(context_.numbers, *all.back(), Role::second), std::back_inserter(handles));
    }
    viz::Walk walk = naming_question(asked, [&] { return scene::walk(way, context_.numbers, all); });
    const bool first = to.pseudocode.empty();
    if (first) to.pseudocode = walk.pseudocode;
    walk.steps.front().caption = fmt::format("Step by step: here {}. {}", who, walk.steps.front().caption);
    for (viz::Step& s : walk.steps) {
      s.slug = slug_of(fmt::format("{}-{}", way.lesson, s.slug));
      if (!first) s.line = -1;
      give_handles(s, handles);
      to.steps.push_back(std::move(s));
    }
  }

  /// Replaces the lesson's handles, whose parameters have other names: in the step's picture and in its question's.
  static void give_handles(viz::Step& step, const std::vector<viz::Handle>& handles) {
    if (!step.scene.handles.empty()) step.scene.handles = handles;
    if (step.question && step.question->over && !step.question->over->handles.empty())
      step.question->over->handles = handles;
  }

  std::vector<viz::Handle> handles_of(const Object& a, const Object& b) const {
    std::vector<viz::Handle> all = handles(context_.numbers, a, Role::first);
    if (&a == &b) return all;
    std::ranges::move(handles(context_.numbers, b, Role::second), std::back_inserter(all));
    return all;
  }

  /// Makes the card of all answers: of many, those that say that something is met, as far as one card has room.
  viz::Step summary() const {
    viz::Step step;
    step.slug = "answers";
    step.title = "All answers";
    step.caption = "Each was decided exactly for the numbers of the scene.";
    std::vector<Row> listed = rows_;
    if (listed.size() > most_rows) {
      std::erase_if(listed, [](const Row& row) { return row.says_no; });
      if (listed.empty()) listed = rows_;
      listed.resize(std::min(listed.size(), most_rows));
      step.caption += fmt::format("\nListed are {} of {}, those that meet something before others. Each has its step.",
                                  listed.size(), rows_.size());
    }
    viz::Card card;
    for (const Row& row : listed) card.rows.push_back({row.head, row.text});
    step.scene.chart = std::make_shared<const viz::Chart>(viz::Chart{card});
    return step;
  }

  Context context_;
  std::vector<Role> roles_;  ///< of all objects, where none is asked about
  std::vector<Row> rows_;
};

/// Returns the knobs of the window: every number of the file.
std::vector<viz::Parameter> parameters_of(const File& file) {
  std::vector<viz::Parameter> all;
  for (const Object& o : file.objects)
    for (const std::string& field : o.fields) {
      const auto known = std::ranges::find(spec(o.type).fields, field, &FieldSpec::name);
      const bool vertex = known == spec(o.type).fields.end();
      const bool its_place = field == "center" || field == "at" || field == "origin";
      const bool slab = vertex && o.type == Type::kdop;
      const std::string help = slab     ? "An end of a slab of " + o.name + "."
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
  for (const Object& o : file.objects)
    for (const ShapeRule& rule : spec(o.type).rules)
      if (const std::string name = o.name + "." + rule.field; file.parameters.contains(name))
        all.push_back({name, rule.allowed, [o, rule, flat = file.flat](const viz::Parameters& p) {
                         return rule.holds({p, flat}, o);
                       }});
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

viz::Lesson lesson_of(const std::string& text, const std::string& folder) {
  const auto file = std::make_shared<const File>(read_scene(text, folder));
  struct Kept {
    std::mutex busy;
    PairAnswers pairs;
  };
  const auto kept = std::make_shared<Kept>();
  const auto walk = [file, kept](const viz::Parameters& parameters) {
    const std::lock_guard lock(kept->busy);
    kept->pairs.move_to(*file, parameters);
    return Walker(*file, parameters).made(kept->pairs);
  };
  viz::Lesson lesson = without_steps(*file);
  // What the core refuses is reported now; a large mesh is asked only once.
  lesson.steps = [file, walk, first = std::make_shared<const viz::Walk>(walk(file->parameters))](
                     const viz::Parameters& parameters) {
    return parameters == file->parameters ? *first : walk(parameters);
  };
  return lesson;
}

namespace {

std::deque<viz::Lesson>& kept_lessons() {
  static std::deque<viz::Lesson> all;  // none of them moves
  return all;
}

}  // namespace

const viz::Lesson& kept_lesson_of(const std::string& text, const std::string& folder) {
  return kept_lessons().emplace_back(lesson_of(text, folder));
}

void keep(const viz::Lesson& kept, const std::string& folder, const viz::Parameters& parameters) {
  const auto at = std::ranges::find(kept_lessons(), &kept, [](const viz::Lesson& one) { return &one; });
  const std::string text = with_numbers(kept.made_from, read_scene(kept.made_from, folder), parameters);
  *at = lesson_of(text, folder);
}

namespace {

/// Returns what the lesson can walk through, in the order of the file, as questions.
Json walks_through(const viz::Lesson& lesson, const std::string& method, const File& file) {
  const NamedValues numbers = {file.parameters, file.flat};
  Json asked = Json::array();
  std::string refused;
  if (const LessonWalk* const way = walk_of_many(lesson.id, method); way && way->flat == file.flat)
    if (std::ranges::count(file.objects, way->a, &Object::type) > 1) {  // its ray, if it needs one, is the only one
      asked.push_back({{"walk", "all"}, {"lesson", lesson.id}, {"method", way->method}});
      return asked;
    }
  const auto ask = [&](std::size_t i, std::size_t j) {
    const Object &a = file.objects[i], &b = file.objects[j];
    const LessonWalk* const found = walk_of(a.type, b.type, file.flat, i == j, lesson.id);
    if (!found) return;
    try {
      static_cast<void>(walk(*found, numbers, a, b));
      const Json names = i == j ? Json(a.name) : Json{a.name, b.name};
      asked.push_back({{"walk", names}, {"lesson", lesson.id}});
    } catch (const viz::BadInput& e) {
      refused += (refused.empty() ? "" : ", and ") + std::string(e.what());
    }
  };
  for (std::size_t i = 0; i < file.objects.size(); ++i)
    for (std::size_t j = 0; j < file.objects.size(); ++j)
      if (i <= j || file.objects[i].type != file.objects[j].type) ask(i, j);
  if (!asked.empty()) return asked;
  if (!refused.empty()) throw viz::BadInput(refused);
  std::string takes;
  for (const LessonWalk& w : walks()) {
    if (w.lesson != lesson.id) continue;
    const std::string one =
        fmt::format("{}{} {}", w.of_many() ? std::string("two ") + w.name_a + " or more" : spec(w.a).name,
                    w.of_one() || w.of_many() ? std::string() : std::string(" and ") + spec(w.b).name,
                    w.flat ? "in the plane" : "in space");
    if (takes.find(one) == takes.npos) takes += (takes.empty() ? "" : ", ") + one;  // several methods may take the same
  }
  if (takes.empty())
    throw viz::BadInput(fmt::format("scene: {} takes no objects of a scene; these do: {}", lesson.id,
                                    fmt::join(walking_lessons(), ", ")));
  throw viz::BadInput(fmt::format("scene: none of its objects are what {} takes: {}", lesson.id, takes));
}

}  // namespace

const viz::Lesson& kept_walks_of(const viz::Lesson& lesson, const std::string& method, const std::string& text,
                                 const std::string& folder) {
  const File file = read_scene(text, folder);
  Json scene = Json::parse(file.text);
  scene["ask"] = walks_through(lesson, method, file);
  scene["title"] = fmt::format("{}: {}", lesson.title, file.title);
  return kept_lesson_of(scene.dump(), folder);
}

void each_answer(const File& file, const std::function<void(Json)>& take) {
  Walker(file, file.parameters).each_answer(take);
}

Json answers(const File& file) {
  Json all = Json::array();
  each_answer(file, [&](Json answer) { all.push_back(std::move(answer)); });
  return all;
}

}  // namespace isect::program::scene
