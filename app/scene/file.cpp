#include "app/scene/file.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/scene/cameras.h"
#include "app/scene/markup.h"
#include "app/scene/read_objects.h"
#include "app/scene/read_questions.h"
#include "app/scene/types.h"
#include "viz/lang/language.h"
#include "viz/text/spelling.h"

namespace isect::program::scene {

namespace {

class SceneReader {
 public:
  SceneReader(Source source, const std::string& folder, const std::vector<std::string>& beside)
      : source_(std::move(source)), folder_(folder), beside_(beside) {}

  File read() {
    if (json().is_object() && json().contains("lesson") && !json().contains("objects"))
      source_.refuse({"lesson"},
                     "this is a preset’s file, which show, render and explain take; a scene has \"objects\"");
    if (json().is_object() && json().contains("stops") && !json().contains("objects"))
      source_.refuse({"stops"}, "this is a playlist, which show, handout, deck and quiz take; a scene has \"objects\"");
    source_.only(json(), {},
                 {"title", "caption", "objects", "ask", "answers", "lang", "notes", "marks", "camera", "guard"},
                 beside_);  // the last for `check`
    if (json().contains("lang")) read_language();
    const viz::Speaking speaking(file_.language);
    file_.title = json().contains("title") ? read_markup(source_, json()["title"], {"title"}) : viz::tr(untitled);
    if (json().contains("caption")) file_.caption = read_markup(source_, json()["caption"], {"caption"});
    if (json().contains("answers")) read_answers();
    ReadObjects objects = read_objects(source_, folder_);
    file_.objects = std::move(objects.all), file_.parameters = std::move(objects.parameters);
    file_.flat = source_.flat();
    Json whole = json();
    whole["objects"] = std::move(objects.json);
    file_.text = whole.dump();
    file_.camera = read_camera(source_);
    read_questions(source_, file_);
    read_notes();
    read_marks(source_, file_);
    return std::move(file_);
  }

 private:
  const Json& json() const { return source_.json(); }

  void read_language() {
    file_.language = source_.text(json()["lang"], {"lang"});
    std::vector<std::string> codes;
    for (const viz::Language& language : viz::languages()) codes.push_back(language.code);
    if (std::ranges::find(codes, file_.language) == codes.end())
      source_.refuse({"lang"}, fmt::format("\"{}\" is no language that it can be told in; allowed: {}", file_.language,
                                           spelling::listed(codes)));
  }

  void read_answers() {
    const std::string word = source_.text(json()["answers"], {"answers"});
    if (word != "hidden" && word != "shown")
      source_.refuse({"answers"}, fmt::format("\"{}\" is neither \"hidden\" nor \"shown\"", word));
    file_.answers_hidden = word == "hidden";
  }

  void read_notes() {
    if (!json().contains("notes")) return;
    if (!json()["notes"].is_array()) source_.refuse({"notes"}, "a list of notes is expected");
    for (std::size_t i = 0; i < json()["notes"].size(); ++i) {
      const Path path = {"notes", std::to_string(i)};
      const Json& note = json()["notes"][i];
      source_.only(note, path, {"at", "text"});
      file_.notes.push_back({source_.vector(source_.member(note, path, "at"), below(path, "at")),
                             read_markup(source_, source_.member(note, path, "text"), below(path, "text"))});
    }
  }

  Source source_;
  const std::string& folder_;
  const std::vector<std::string>& beside_;
  File file_;
};

bool nests_too_deep(const std::string& text) { return Spans(text).too_deep() != text.npos; }

}  // namespace

bool holds_objects(const std::string& text) {
  if (nests_too_deep(text)) return false;
  const Json json = Json::parse(text, nullptr, false, true);
  if (!json.is_object() || !json.contains("objects") || !json["objects"].is_array()) return false;
  return std::ranges::any_of(json["objects"], [](const Json& o) {
    const auto named = [&](const std::string& type) {
      return !type.empty() && o.contains(type) && o[type].is_string();
    };
    return o.is_object() &&
           std::ranges::any_of(types(), [&](const TypeSpec& t) { return named(t.name) || named(other_name(t)); });
  });
}

void require_shallow(const std::string& text) {
  if (nests_too_deep(text))
    throw viz::BadInput(
        fmt::format("lists and objects nest deeper than the {} levels that are allowed", Spans::most_levels));
}

bool is_scene(const std::string& text) {
  if (nests_too_deep(text)) return text.find("\"objects\"") != text.npos;
  const Json json = Json::parse(text, nullptr, false, true);
  if (json.is_object()) return json.contains("objects");
  return json.is_discarded() && text.find("\"objects\"") != text.npos;  // meant as a scene, though broken
}

File read_scene(Source source, const std::string& folder, const std::vector<std::string>& beside) {
  return SceneReader(std::move(source), folder, beside).read();
}
File read_scene(const std::string& text, const std::string& folder) { return read_scene(Source(text), folder, {}); }

}  // namespace isect::program::scene
