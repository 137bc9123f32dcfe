#include "app/scene/scene_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <memory>

#include "app/scene/answered.h"
#include "app/scene/lesson.h"
#include "app/scene/marks.h"
#include "app/scene/prompts.h"
#include "app/scene/scene_picture.h"
#include "app/scene/type_words.h"
#include "app/scene/types.h"
#include "app/scene/walks.h"
#include "viz/chart/chart.h"
#include "viz/lang/language.h"
#include "viz/lang/lesson_texts.h"
#include "viz/lang/message.h"
#include "viz/text/rich_text.h"

namespace isect::program::scene {

namespace {

using viz::Role;
using viz::tr;
using viz::tr_count;

/// Returns its type and its name, and what no parameter says: the number of triangles or points.
std::string listed(const Object& o, bool flat) {
  const std::string what = type_in_list(o.type, flat) + " " + shown_name(o.name);
  if (!o.fixed.triangles.empty())
    return tr_count(o.fixed.triangles.size(), "{a} of {n} triangles", "{a} of {n} triangles", {{"a", what}});
  if (o.fixed.points.empty()) return what;
  return tr_count(o.fixed.points.size(), "{a} of {n} points", "{a} of {n} points", {{"a", what}});
}

/// Above this many pairs, those with the same first object share one step.
constexpr std::ptrdiff_t most_steps_of_pairs = 200;
/// The most of their answers in full.
constexpr std::size_t most_told = 12;
/// The most objects that the first step names.
constexpr std::size_t most_listed = 200;
/// The most answers on the card of all answers.
constexpr std::size_t most_rows = 36;

class Walker {
  /// A row of the card: one answer.
  struct Row {
    std::string head, text;  ///< markup
    bool says_no;
  };

 public:
  Walker(const File& file, const viz::Parameters& parameters, Known& known)
      : known_(known),
        context_{file, {parameters, file.flat}, known.pictures.room({parameters, file.flat}, file.objects)},
        roles_(roles_of_all(file)) {
    for (const AuthorMark& mark : file.marks)
      if (!file.answers_hidden || !mark.tells(file)) marks_.push_back({&mark, picture_of(context_, mark, file.camera)});
  }

  viz::Walk made() {
    PairAnswers& pairs = known_.pairs;
    const auto asked_of_pairs = std::ranges::count_if(
        context_.file.asked, [](const Asked& asked) { return std::holds_alternative<PairAsked>(asked); });
    viz::Walk walk;
    walk.steps.push_back(all_objects());
    walk.alt = held() + noted() + marked();
    for (const Note& note : context_.file.notes) walk.alt += " " + tr("Note: {text}.", {{"text", note.text}});
    const std::vector<Asked>& all = context_.file.asked;
    const bool hidden = context_.file.answers_hidden;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::size_t number = walk.steps.size() + 1;
      if (const WalkAsked* const walked = std::get_if<WalkAsked>(&all[i]); walked && !hidden) {
        add(*walked, walk);
        if (const viz::StepView* const view = view_of(i))
          for (std::size_t s = number - 1; s < walk.steps.size(); ++s) walk.steps[s].view = *view;
      } else if (const PairAsked* const pair = std::get_if<PairAsked>(&all[i])) {
        const std::size_t first = i;
        std::vector<PairAnswers::Answer> answers = {pairs.of(context_, *pair)};
        if (asked_of_pairs > most_steps_of_pairs && !has_own(first))
          for (; i + 1 < all.size() && !has_own(i + 1); ++i) {
            const PairAsked* const next = std::get_if<PairAsked>(&all[i + 1]);
            if (!next || next->a != pair->a) break;
            answers.push_back(pairs.of(context_, *next));
          }
        const bool one = answers.size() == 1;
        if (hidden)
          walk.steps.push_back(asking(
              one ? prompt(context_, all[i]) : prompt_of_others(context_, pair->a, answers.size()), first, number));
        else
          walk.steps.push_back(step(one ? *answers[0] : together(pair->a, answers), first, number));
      } else {
        Answered answer = answer_to(all[i]);  // what the core refuses is told, whether answers are hidden or not
        walk.steps.push_back(hidden ? asking(prompt(context_, all[i]), i, number) : step(std::move(answer), i, number));
      }
    }
    if (rows_.size() > 1) walk.steps.push_back(summary());
    return walk;
  }

  /// Passes each answer on as JSON, without a step.
  void each_answer(const std::function<void(Json)>& take) {
    for (const Object& o : context_.file.objects)  // what can't be drawn is refused
      static_cast<void>(drawn(context_.numbers, o, context_.room, Role::first));
    const std::vector<Asked>& all = context_.file.asked;
    for (std::size_t i = 0; i < all.size(); ++i) {
      viz::Walk unseen;
      if (const WalkAsked* const walked = std::get_if<WalkAsked>(&all[i])) add(*walked, unseen);
      Json answer = answer_to(all[i]).json;
      if (const OwnWords* const own = words_of(i); own && own->tells()) answer["said"] = json_of(*own);
      take(std::move(answer));
    }
  }

 private:
  Answered answer_to(const Asked& asked) const {
    return std::visit([&](const auto& a) { return answered(context_, a); }, asked);
  }

  /// Returns what the author says of an answer; null: nothing.
  const OwnWords* words_of(std::size_t asked) const {
    const auto found = context_.file.words.find(asked);
    return found == context_.file.words.end() ? nullptr : &found->second;
  }

  const viz::StepView* view_of(std::size_t asked) const {
    const auto found = context_.file.views.find(asked);
    return found == context_.file.views.end() ? nullptr : &found->second;
  }
  /// Whether a question has words or a camera of its own.
  bool has_own(std::size_t asked) const { return words_of(asked) || view_of(asked); }

  /// Returns what an object meets, of all that it was asked about with.
  Answered together(std::size_t object, const std::vector<PairAnswers::Answer>& answers) const {
    const std::string name = context_.name(object);
    Answered out = {slug_of(context_.object(object).name + "-and-others"),
                    tr_count(answers.size(), "{a} and {n} others", "{a} and {n} others", {{"a", name}}),
                    tr("Decided exactly for these numbers."),
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
    if (met + open > most_told) out.caption += " " + tr_count(met + open - most_told, "And {n} more.", "And {n} more.");
    out.verdict = {met > 0    ? viz::Verdict::Kind::yes
                   : open > 0 ? viz::Verdict::Kind::open
                              : viz::Verdict::Kind::no,
                   tr_count(answers.size(), "{a} meets {met} of {n} others", "{a} meets {met} of {n} others",
                            {{"a", name}, {"met", std::to_string(met)}})};
    if (open > 0)
      out.verdict.text += tr_count(open, ", and of {n} it is not decided", ", and of {n} it is not decided");
    return out;
  }

  /// Returns all objects by name or, if they are many, how many there are of each type.
  std::string listed_objects() const {
    const std::vector<Object>& all = context_.file.objects;
    std::string list;
    if (all.size() <= most_listed) {
      for (const Object& o : all) list += (list.empty() ? "" : ", ") + listed(o, context_.file.flat);
      return list;
    }
    for (const TypeSpec& type : types()) {
      const auto count = static_cast<std::size_t>(std::ranges::count(all, type.type, &Object::type));
      if (count > 0) list += (list.empty() ? "" : ", ") + counted_types(count, type.type, context_.file.flat);
    }
    return tr_count(all.size(), "{n} objects: {list}", "{n} objects: {list}", {{"list", list}});
  }

  /// Returns what the marks say, for readers who can't see them.
  std::string marked() const {
    std::string all;
    for (const Marked& mark : marks_)
      if (!mark.picture.said.empty()) all += (all.empty() ? "" : "; ") + mark.picture.said;
    return all.empty() ? all : " " + tr("Marked: {marks}.", {{"marks", all}});
  }

  /// Draws what the step shows, and adds to its caption which marks are missing and why. `number`: of the step, from 1.
  /// `view`: its own, or null.
  void draw(viz::Step& step, const std::vector<std::size_t>& lit, std::size_t number, const viz::StepView* view) {
    const int n = static_cast<int>(number);
    if (view) step.view = *view;
    const viz::Camera& camera = view ? view->camera : context_.file.camera;
    step.scene = scene_picture(context_, known_.pictures, roles_, lit, n, camera);
    for (const Marked& mark : marks_) {
      if (!mark.mark->steps.has(n)) continue;
      std::ranges::copy(view ? picture_of(context_, *mark.mark, camera).items : mark.picture.items,
                        std::back_inserter(step.scene.items));
      if (!mark.picture.said.empty()) step.scene.said += (step.scene.said.empty() ? "" : "; ") + mark.picture.said;
      if (!mark.picture.missing.empty()) step.caption += "\n" + mark.picture.missing;
    }
  }

  std::string held() const { return tr("The scene holds {objects}.", {{"objects", listed_objects()}}); }

  /// Returns what was noted of objects when they were read.
  std::string noted() const {
    std::string all;
    for (const Object& o : context_.file.objects)
      if (!o.note.empty()) all += fmt::format(" {}: {}", shown_name(o.name), viz::as_markup(o.note));
    return all;
  }

  viz::Step all_objects() {
    viz::Step step;
    step.slug = "objects";
    step.title = context_.file.title;
    step.caption = (context_.file.caption.empty() ? held() : context_.file.caption) + noted();
    draw(step, {}, 1, nullptr);
    return step;
  }

  /// Makes the step that asks what `step` tells: the same objects in the same colours, and nothing that was found.
  viz::Step asking(Prompt asked, std::size_t index, std::size_t number) {
    viz::Step step;
    step.slug = asked.slug, step.title = asked.title, step.caption = asked.text;
    if (const OwnWords* const own = words_of(index); own && own->question) step.caption = *own->question;
    draw(step, asked.lit, number, view_of(index));
    return step;
  }

  /// `index`: of what is asked.
  viz::Step step(Answered answer, std::size_t index, std::size_t number) {
    viz::Step step;
    if (const OwnWords* const own = words_of(index))
      put_words(*own, known_.written_for.try_emplace(index, answer.verdict.text).first->second, answer);
    step.slug = answer.slug, step.title = answer.title, step.caption = answer.caption, step.formula = answer.formula;
    step.verdict = answer.verdict, step.values = answer.values;
    draw(step, answer.lit, number, view_of(index));
    std::ranges::move(answer.items, std::back_inserter(step.scene.items));
    if (!answer.verdict.text.empty())
      rows_.push_back({step.title, answer.verdict.text + (answer.formula.empty() ? "" : ": " + answer.formula),
                       answer.verdict.kind == viz::Verdict::Kind::no});
    return step;
  }

  /// Adds the lesson's own steps on these numbers; a walk has only one pseudocode, that of the first.
  void add(const WalkAsked& asked, viz::Walk& to) {
    const Object &a = context_.object(asked.a), &b = context_.object(asked.b);
    const bool one = asked.a == asked.b;
    const std::string who = !asked.many.empty() ? asked.lesson
                            : one               ? a.name
                                                : tr("{a} and {b}", {{"a", a.name}, {"b", b.name}});
    rows_.push_back({tr("{a}, step by step", {{"a", who}}), answered(context_, asked).verdict.text, false});
    if (!asked.many.empty()) return add_of_many(asked, to);
    const LessonWalk& pair = *walk_of(a.type, b.type, context_.file.flat, one, asked.lesson);
    viz::Walk walk = naming_question(asked, [&] {
      return viz::spoken_walk(pair.lesson, [&] { return scene::walk(pair, context_.numbers, a, b); });
    });
    const bool first = to.pseudocode.empty();
    if (first) to.pseudocode = walk.pseudocode;
    for (viz::Step& s : walk.steps) {
      s.slug = slug_of(one ? fmt::format("{}-{}", a.name, s.slug) : fmt::format("{}-{}-{}", a.name, b.name, s.slug));
      if (!first) s.line = -1;
      give_handles(s, handles_of(a, b));
      if (&s == &walk.steps.front()) {
        const std::string first_name = name_in_lesson(pair.name_a);
        s.caption =
            one ? tr("Step by step: here {a} are {x}. {caption}",
                     {{"a", shown_name(a.name)}, {"x", first_name}, {"caption", s.caption}})
                : tr("Step by step: here {a} is {x}, and {b} is {y}. {caption}", {{"a", shown_name(a.name)},
                                                                                  {"x", first_name},
                                                                                  {"b", shown_name(b.name)},
                                                                                  {"y", name_in_lesson(pair.name_b)},
                                                                                  {"caption", s.caption}});
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
      who += all.size() == 1 ? "" : ", ";
      who += tr("{a} is {x}",
                {{"a", context_.name(i)}, {"x", ray ? name_in_lesson("the ray") : std::to_string(all.size() - 1)}});
      std::ranges::move(scene::handles(context_.numbers, *all.back(), context_.room, Role::second, HandlesOf::points),
                        std::back_inserter(handles));
    }
    viz::Walk walk = naming_question(
        asked, [&] { return viz::spoken_walk(way.lesson, [&] { return scene::walk(way, context_.numbers, all); }); });
    const bool first = to.pseudocode.empty();
    if (first) to.pseudocode = walk.pseudocode;
    walk.steps.front().caption =
        tr("Step by step: here {who}. {caption}", {{"who", who}, {"caption", walk.steps.front().caption}});
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
    std::vector<viz::Handle> all = handles(context_.numbers, a, context_.room, Role::first);
    if (&a == &b) return all;
    std::ranges::move(handles(context_.numbers, b, context_.room, Role::second), std::back_inserter(all));
    return all;
  }

  /// Makes the card of all answers: of many, those that say that something is met, as far as one card has room.
  viz::Step summary() const {
    viz::Step step;
    step.slug = "answers";
    step.title = tr("All answers");
    step.caption = tr("Each was decided exactly for the numbers of the scene.");
    std::vector<Row> listed = rows_;
    if (listed.size() > most_rows) {
      std::erase_if(listed, [](const Row& row) { return row.says_no; });
      if (listed.empty()) listed = rows_;
      listed.resize(std::min(listed.size(), most_rows));
      step.caption +=
          "\n" + tr("Listed are {some} of {all}, those that meet something before others. Each has its step.",
                    {{"some", std::to_string(listed.size())}, {"all", std::to_string(rows_.size())}});
    }
    viz::Card card;
    for (const Row& row : listed) card.rows.push_back({row.head, row.text});
    step.scene.chart = std::make_shared<const viz::Chart>(viz::Chart{card});
    return step;
  }

  Known& known_;
  Context context_;
  struct Marked {
    const AuthorMark* mark;
    MarkPicture picture;  ///< as the scene's camera sees it
  };
  std::vector<Marked> marks_;
  std::vector<Role> roles_;  ///< of all objects, where none is asked about
  std::vector<Row> rows_;
};

}  // namespace

viz::Walk steps_of_scene(const File& file, const viz::Parameters& parameters, Known& known) {
  const viz::Speaking speaking(file.language);
  known.move_to(file, parameters);
  return Walker(file, parameters, known).made();
}

void each_answer(const File& file, const std::function<void(Json)>& take) {
  const viz::Speaking speaking(file.language);
  Known nothing;
  Walker(file, file.parameters, nothing).each_answer(take);
}

Json answers(const File& file) {
  Json all = Json::array();
  each_answer(file, [&](Json answer) { all.push_back(std::move(answer)); });
  return all;
}

}  // namespace isect::program::scene
