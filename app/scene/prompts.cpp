#include "app/scene/prompts.h"

#include "app/scene/type_words.h"
#include "app/scene/types.h"
#include "viz/lang/message.h"

namespace isect::program::scene {

using viz::tr;
using viz::tr_count;

namespace {

std::string both_names(const Context& c, std::size_t a, std::size_t b) {
  return tr("{a} and {b}", {{"a", c.name(a)}, {"b", c.name(b)}});
}

std::string names_of_all(const Context& c, const std::vector<std::size_t>& objects) {
  std::string all;
  for (std::size_t i = 0; i < objects.size(); ++i)
    all = i == 0                   ? c.name(objects[i])
          : i + 1 < objects.size() ? all + ", " + c.name(objects[i])
                                   : tr("{a} and {b}", {{"a", all}, {"b", c.name(objects[i])}});
  return all;
}

/// Writes the words of one kind of question.
struct PromptWriter {
  const Context& c;

  Prompt operator()(const PairAsked& asked) const {
    const std::string names = both_names(c, asked.a, asked.b);
    return {slug_of(c.object(asked.a).name + "-" + c.object(asked.b).name),
            names,
            tr("How do {both} lie: do they meet?", {{"both", names}}),
            {asked.a, asked.b}};
  }
  Prompt operator()(const FirstHitAsked& asked) const {
    return {"first-hit-" + slug_of(c.object(asked.ray).name),
            tr("What {a} meets first", {{"a", c.name(asked.ray)}}),
            tr("Which object does {a} meet first, and at which *t*?", {{"a", c.name(asked.ray)}}),
            {}};
  }
  Prompt operator()(const FitAsked& asked) const {
    const std::string title = tr("Volumes around {a}", {{"a", c.name(asked.object)}});
    if (asked.volume.empty())
      return {"fit-" + slug_of(c.object(asked.object).name),
              title,
              tr("Which volume fits {a} most tightly?", {{"a", c.name(asked.object)}}),
              {asked.object}};
    return {"fit-" + slug_of(c.object(asked.object).name),
            title,
            asked_volume(asked.volume, c.file.flat, c.name(asked.object)),
            {asked.object}};
  }
  Prompt operator()(const ClipAsked& asked) const {
    const bool by_plane = c.object(asked.to).type == Type::plane;
    const std::string to = c.name(asked.to),
                      where = by_plane ? tr("where the normal of {a} points", {{"a", to}}) : tr("in {a}", {{"a", to}});
    return {slug_of("clip-" + c.object(asked.what).name + "-" + c.object(asked.to).name),
            tr("What of {a} lies {where}", {{"a", c.name(asked.what)}, {"where", where}}),
            tr("Which part of {a} lies {where}?", {{"a", c.name(asked.what)}, {"where", where}}),
            {asked.what, asked.to}};
  }
  Prompt operator()(const HierarchyAsked& asked) const {
    if (asked.objects.size() == 1)
      return {"hierarchy-" + slug_of(c.object(asked.objects[0]).name),
              tr("A hierarchy over the triangles of {a}", {{"a", c.name(asked.objects[0])}}),
              tr("How would you divide the triangles, level by level?"), asked.objects};
    return {"hierarchy-of-objects",
            tr("A hierarchy over the objects"),
            tr("How would you divide {names}, level by level?", {{"names", names_of_all(c, asked.objects)}}),
            {}};
  }
  Prompt operator()(const WalkAsked& asked) const {
    if (asked.with_ray) {
      Prompt first = (*this)(FirstHitAsked{asked.many.back()});
      first.slug = "walk-" + first.slug;
      return first;
    }
    if (!asked.many.empty())
      return {slug_of("walk-" + asked.lesson),
              names_of_all(c, asked.many),
              tr("Which two of {names} meet?", {{"names", names_of_all(c, asked.many)}}),
              {}};
    if (asked.a == asked.b)
      return {slug_of("walk-" + c.object(asked.a).name),
              tr("The hull of {a}", {{"a", c.name(asked.a)}}),
              tr("Which points of {a} are corners of its convex hull?", {{"a", c.name(asked.a)}}),
              {asked.a}};
    Prompt pair = (*this)(PairAsked{asked.a, asked.b});
    pair.slug = "walk-" + pair.slug;
    return pair;
  }
};

}  // namespace

Prompt prompt(const Context& c, const Asked& asked) { return std::visit(PromptWriter{c}, asked); }

Prompt prompt_of_others(const Context& c, std::size_t object, std::size_t others) {
  return {slug_of(c.object(object).name + "-and-others"),
          tr_count(others, "{a} and {n} others", "{a} and {n} others", {{"a", c.name(object)}}),
          tr_count(others, "Which of {n} others does {a} meet?", "Which of {n} others does {a} meet?",
                   {{"a", c.name(object)}}),
          {object}};
}

}  // namespace isect::program::scene
