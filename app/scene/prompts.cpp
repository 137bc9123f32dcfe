#include "app/scene/prompts.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/scene/types.h"

namespace isect::program::scene {

namespace {

std::string both_names(const Context& c, std::size_t a, std::size_t b) {
  return fmt::format("{} and {}", c.name(a), c.name(b));
}

std::string names_of_all(const Context& c, const std::vector<std::size_t>& objects) {
  std::string all;
  for (std::size_t i = 0; i < objects.size(); ++i)
    all += (i == 0 ? "" : i + 1 < objects.size() ? ", " : " and ") + c.name(objects[i]);
  return all;
}

/// Writes the words of one kind of question.
struct PromptWriter {
  const Context& c;

  std::string volume_in_words(const std::string& name) const {
    const auto type = std::ranges::find(types(), name, &TypeSpec::name);
    return type == types().end() ? name : in_words(type->type, c.file.flat);
  }

  Prompt operator()(const PairAsked& asked) const {
    const std::string names = both_names(c, asked.a, asked.b);
    return {slug_of(c.object(asked.a).name + "-" + c.object(asked.b).name),
            names,
            fmt::format("How do {} lie: do they meet?", names),
            {asked.a, asked.b}};
  }
  Prompt operator()(const FirstHitAsked& asked) const {
    return {"first-hit-" + slug_of(c.object(asked.ray).name),
            fmt::format("What {} meets first", c.name(asked.ray)),
            fmt::format("Which object does {} meet first, and at which *t*?", c.name(asked.ray)),
            {}};
  }
  Prompt operator()(const FitAsked& asked) const {
    const std::string title = fmt::format("Volumes around {}", c.name(asked.object));
    if (asked.volume.empty())
      return {"fit-" + slug_of(c.object(asked.object).name),
              title,
              fmt::format("Which volume fits {} most tightly?", c.name(asked.object)),
              {asked.object}};
    return {"fit-" + slug_of(c.object(asked.object).name),
            title,
            fmt::format("Which {} fits {} tightly?", volume_in_words(asked.volume), c.name(asked.object)),
            {asked.object}};
  }
  Prompt operator()(const ClipAsked& asked) const {
    const bool by_plane = c.object(asked.to).type == Type::plane;
    const std::string to = c.name(asked.to), where = by_plane ? "where the normal of " + to + " points" : "in " + to;
    return {slug_of("clip-" + c.object(asked.what).name + "-" + c.object(asked.to).name),
            fmt::format("What of {} lies {}", c.name(asked.what), where),
            fmt::format("Which part of {} lies {}?", c.name(asked.what), where),
            {asked.what, asked.to}};
  }
  Prompt operator()(const HierarchyAsked& asked) const {
    if (asked.objects.size() == 1)
      return {"hierarchy-" + slug_of(c.object(asked.objects[0]).name),
              fmt::format("A hierarchy over the triangles of {}", c.name(asked.objects[0])),
              "How would you divide the triangles, level by level?", asked.objects};
    return {"hierarchy-of-objects",
            "A hierarchy over the objects",
            fmt::format("How would you divide {}, level by level?", names_of_all(c, asked.objects)),
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
              fmt::format("Which two of {} meet?", names_of_all(c, asked.many)),
              {}};
    if (asked.a == asked.b)
      return {slug_of("walk-" + c.object(asked.a).name),
              fmt::format("The hull of {}", c.name(asked.a)),
              fmt::format("Which points of {} are corners of its convex hull?", c.name(asked.a)),
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
          fmt::format("{} and {} others", c.name(object), others),
          fmt::format("Which of {} others does {} meet?", others, c.name(object)),
          {object}};
}

}  // namespace isect::program::scene
