#include "app/scene/read_questions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "app/scene/cameras.h"
#include "app/scene/fits.h"
#include "app/scene/read_objects.h"
#include "app/scene/types.h"
#include "app/scene/walks.h"
#include "viz/text/spelling.h"

namespace isect::program::scene {

namespace {

class QuestionReader {
 public:
  QuestionReader(Source& source, File& file) : source_(source), file_(file) {}

  void read() {
    if (!json().contains("ask")) return;
    const Json& ask = json()["ask"];
    if (ask == "all pairs") return ask_all_pairs();
    if (!ask.is_array()) source_.refuse({"ask"}, "a list of questions is expected, or \"all pairs\"");
    for (std::size_t i = 0; i < ask.size(); ++i) {
      const Path path = {"ask", std::to_string(i)};
      file_.asked.push_back(ask[i].is_object() ? named_question(ask[i], path) : Asked(pair(ask[i], path)));
      if (ask[i].is_object() && ask[i].contains("camera"))
        file_.views[i] = read_step_camera(source_, ask[i]["camera"], below(path, "camera"), file_.camera);
      if (ask[i].is_object() && !ask[i].contains("walk"))
        if (OwnWords words = read_words(source_, ask[i], path); words.any()) file_.words[i] = std::move(words);
    }
  }

 private:
  const Json& json() const { return source_.json(); }

  const Object& object(std::size_t i) const { return file_.objects[i]; }
  std::size_t named(const Json& name, const Path& path) const {
    return object_named(source_, file_.objects, name, path);
  }

  /// Asks all pairs; pairs of points only if there is nothing else.
  void ask_all_pairs() {
    std::vector<Asked> points;
    for (std::size_t a = 0; a < file_.objects.size(); ++a)
      for (std::size_t b = a + 1; b < file_.objects.size(); ++b) {
        const bool two_points = object(a).type == Type::point && object(b).type == Type::point;
        (two_points ? points : file_.asked).push_back(PairAsked{a, b});
      }
    if (file_.asked.empty()) file_.asked = std::move(points);
  }

  /// Reads a question with a word before it: {"first hit": "r"}.
  Asked named_question(const Json& json, const Path& path) const {
    const std::vector<std::string> words = {"of", "first hit", "fit", "clip", "hierarchy", "walk"};
    const auto word = std::ranges::find_if(words, [&](const std::string& w) { return json.contains(w); });
    if (word == words.end()) source_.only(json, path, words);  // this refuses it
    if (word == words.end()) source_.refuse(path, fmt::format("one of these is expected: {}", fmt::join(words, ", ")));
    if (*word == "fit") return fit(json, path);
    if (*word == "clip") return clip(json, path);
    if (*word == "walk") return walk(json, path);
    source_.only(json, path, and_words({*word}));
    const Json& asked = json[*word];
    const Path to = below(path, *word);
    if (*word == "of") return pair(asked, to);
    if (*word == "hierarchy") return hierarchy(asked, to);
    const std::size_t ray = named(asked, to);
    need_type(ray, to, runs_along_a_line(object(ray).type), "a ray, a line or a segment");
    return FirstHitAsked{ray};
  }

  void need_type(std::size_t index, const Path& path, bool fits, const std::string& expected) const {
    if (!fits)
      source_.refuse(path, fmt::format("\"{}\" is {}; {} is expected", object(index).name,
                                       with_article(object(index).type), expected));
  }

  Asked fit(const Json& json, const Path& path) const {
    source_.only(json, path, and_words({"fit", "volume"}));
    FitAsked asked = {named(json["fit"], below(path, "fit")), {}};
    need_type(asked.object, below(path, "fit"), can_fit(object(asked.object).type),
              "what is made of points, such as a cloud, a mesh or a polygon,");
    if (!json.contains("volume") || json["volume"] == "all") return asked;
    const Path to = below(path, "volume");
    asked.volume = source_.text(json["volume"], to);
    if (std::ranges::find(volumes(), asked.volume) == volumes().end())
      source_.refuse(
          to, fmt::format("no volume is called \"{}\"{}, all", asked.volume,
                          spelling::instead(asked.volume, volumes(), "allowed: " + spelling::listed(volumes()))));
    return asked;
  }

  Asked clip(const Json& json, const Path& path) const {
    source_.only(json, path, and_words({"clip", "to"}));
    const std::size_t what = named(json["clip"], below(path, "clip"));
    const Type type = object(what).type;
    need_type(what, below(path, "clip"),
              runs_along_a_line(type) || type == Type::triangle || type == Type::polygon || type == Type::hull,
              "a ray, a line, a segment, a triangle or a convex polygon");
    const std::size_t to = named(source_.member(json, path, "to"), below(path, "to"));
    need_type(to, below(path, "to"), object(to).type == Type::box || object(to).type == Type::plane,
              "a box or a plane");
    return ClipAsked{what, to};
  }

  Asked hierarchy(const Json& json, const Path& path) const {
    HierarchyAsked asked;
    if (json == "all") {
      for (std::size_t i = 0; i < file_.objects.size(); ++i)
        if (has_box(object(i).type)) asked.objects.push_back(i);
    } else if (json.is_string()) {
      asked.objects = {named(json, path)};
      need_type(asked.objects[0], path, object(asked.objects[0]).type == Type::mesh,
                "a mesh, \"all\" or a list of names");
      return asked;
    } else {
      for (const Json& name : source_.list(json, path, 2, file_.objects.size(), "names")) {
        asked.objects.push_back(named(name, path));
        need_type(asked.objects.back(), path, has_box(object(asked.objects.back()).type), "what ends somewhere");
      }
    }
    if (asked.objects.size() < 2) source_.refuse(path, "two objects at least, which end somewhere, are expected");
    return asked;
  }

  /// Reads a walk through all objects of the type that the lesson takes, or through those named.
  Asked walk_of_many(const Json& json, const std::string& lesson, const Path& path) const {
    WalkAsked asked = {.a = 0, .b = 0, .lesson = lesson};
    if (json.contains("method")) {
      const std::vector<std::string> known = methods_for_many(lesson);
      asked.method = source_.text(json["method"], below(path, "method"));
      if (std::ranges::find(known, asked.method) == known.end())
        source_.refuse(below(path, "method"),
                       fmt::format("{} has no method \"{}\"{}", lesson, asked.method,
                                   spelling::instead(asked.method, known, "allowed: " + spelling::listed(known))));
    }
    const LessonWalk& way = *scene::walk_of_many(lesson, asked.method);
    const Path to = below(path, "walk");
    const std::string expected = fmt::format("{} {}", with_article(way.a), way.flat ? "in the plane" : "in space");
    if (json["walk"] == "all") {
      for (std::size_t i = 0; i < file_.objects.size(); ++i)
        if (object(i).type == way.a) asked.many.push_back(i);
      if (asked.many.size() < 2) source_.refuse(to, fmt::format("two {} at least are expected", way.name_a));
    } else {
      for (const Json& name : source_.list(json["walk"], to, 2, file_.objects.size(), "names, or \"all\""))
        asked.many.push_back(named(name, to));
    }
    for (const std::size_t i : asked.many)
      need_type(i, to, object(i).type == way.a && file_.flat == way.flat, expected);
    if (way.with_ray)
      asked.many.push_back(ray_of(json, path)), asked.with_ray = true;
    else if (json.contains("ray"))
      source_.refuse(below(path, "ray"), fmt::format("{} asks by no ray here", lesson));
    std::vector<std::size_t> sorted = asked.many;
    std::ranges::sort(sorted);
    if (std::ranges::adjacent_find(sorted) != sorted.end()) source_.refuse(to, "an object is named twice");
    asked.a = asked.many[0], asked.b = asked.many[1];
    return asked;
  }

  /// Returns the ray that is named, or the only one.
  std::size_t ray_of(const Json& json, const Path& path) const {
    if (json.contains("ray")) {
      const std::size_t i = named(json["ray"], below(path, "ray"));
      need_type(i, below(path, "ray"), object(i).type == Type::ray, "a ray");
      return i;
    }
    const auto is_ray = [](const Object& o) { return o.type == Type::ray; };
    if (std::ranges::count_if(file_.objects, is_ray) != 1)
      source_.refuse(path, "\"ray\" is expected: the name of the ray that asks");
    return static_cast<std::size_t>(std::ranges::find_if(file_.objects, is_ray) - file_.objects.begin());
  }

  Asked walk(const Json& json, const Path& path) const {
    source_.only(json, path, {"walk", "lesson", "method", "ray", "camera"});
    const Path to = below(path, "walk");
    std::string lesson;
    if (json.contains("lesson")) {
      const std::vector<std::string> known = walking_lessons();
      lesson = source_.text(json["lesson"], below(path, "lesson"));
      if (std::ranges::find(known, lesson) == known.end())
        source_.refuse(below(path, "lesson"),
                       fmt::format("no lesson that takes a scene's objects is called \"{}\"{}", lesson,
                                   spelling::instead(lesson, known, "allowed: " + spelling::listed(known))));
    }
    if (scene::walk_of_many(lesson, "")) return walk_of_many(json, lesson, path);
    if (json.contains("method"))
      source_.refuse(below(path, "method"),
                     "no such field is known here; with \"lesson\": \"collision\" or \"hierarchy\" it is");
    if (json.contains("ray"))
      source_.refuse(below(path, "ray"), "no such field is known here; with \"lesson\": \"hierarchy\" it is");
    const bool one = json["walk"].is_string();
    const auto [i, j] =
        one ? std::pair(named(json["walk"], to), named(json["walk"], to)) : two_objects(json["walk"], to);
    const Type a = object(i).type, b = object(j).type;
    if (walk_of(a, b, file_.flat, one, lesson)) return WalkAsked{i, j, lesson};
    if (walk_of(b, a, file_.flat, one, lesson)) return WalkAsked{j, i, lesson};
    source_.refuse(to,
                   fmt::format("{} steps through {} {}; those are: {}",
                               lesson.empty() ? "no lesson" : "the lesson " + lesson + " never",
                               one ? with_article(a) : with_article(a) + " and " + with_article(b),
                               file_.flat ? "in the plane" : "in space", fmt::join(walks_in_words(file_.flat), ", ")));
  }

  std::pair<std::size_t, std::size_t> two_objects(const Json& json, const Path& path) const {
    if (!json.is_array() || json.size() != 2)
      source_.refuse(path, "two names are expected, as in [\"r\", \"A\"], or {\"first hit\": \"r\"}");
    const std::size_t a = named(json[0], path), b = named(json[1], path);
    if (a == b) source_.refuse(path, "an object can't be asked about itself");
    return {a, b};
  }

  PairAsked pair(const Json& json, const Path& path) const {
    const auto [a, b] = two_objects(json, path);
    return {a, b};
  }

  Source& source_;
  File& file_;
};

}  // namespace

void read_questions(Source& source, File& file) { QuestionReader(source, file).read(); }

}  // namespace isect::program::scene
