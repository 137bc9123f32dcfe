#include "app/scene/own_words.h"

#include <array>
#include <utility>

#include "app/scene/answered.h"
#include "app/scene/markup.h"
#include "viz/lang/message.h"
#include "viz/text/rich_text.h"

namespace isect::program::scene {

namespace {

struct WordsField {
  const char* name;
  std::optional<std::string> OwnWords::*words;
};
constexpr std::array words_fields = {WordsField{"title", &OwnWords::title}, WordsField{"caption", &OwnWords::caption},
                                     WordsField{"verdict", &OwnWords::verdict},
                                     WordsField{"question", &OwnWords::question}};

}  // namespace

std::vector<std::string> and_words(std::vector<std::string> all) {
  for (const WordsField& field : words_fields) all.emplace_back(field.name);
  all.emplace_back("camera");
  return all;
}

OwnWords read_words(const Source& source, const Json& question, const Path& path) {
  OwnWords own;
  for (const WordsField& field : words_fields) {
    if (!question.contains(field.name)) continue;
    const Json& value = question[field.name];
    const Path to = below(path, field.name);
    const bool may_be_none = field.words == &OwnWords::verdict;
    if (may_be_none && value.is_null()) {
      own.verdict = "";
      continue;
    }
    own.*field.words = read_markup(source, value, to);
    if ((own.*field.words)->empty())
      source.refuse(to, may_be_none ? "it is empty; null leaves the verdict out" : "it is empty");
  }
  return own;
}

Json without_words(const Json& question) {
  if (!question.is_object()) return question;
  Json bare = question;
  for (const WordsField& field : words_fields) bare.erase(field.name);
  bare.erase("camera");
  return bare.size() == 1 && bare.contains("of") ? bare["of"] : bare;
}

void put_words(const OwnWords& own, const std::string& written_for, Answered& answer) {
  const std::string exact = answer.verdict.text;
  const bool stands = exact == written_for;
  if (own.title && stands) answer.title = *own.title;
  if (own.caption) answer.caption = *own.caption;
  if (own.verdict && (stands || own.verdict->empty())) answer.verdict.text = *own.verdict, answer.verdict.exact = exact;
  if (own.verdict && own.verdict->empty()) answer.formula.clear();
  if (own.caption && !stands)
    answer.caption += "\n" + viz::tr("This was written for other numbers: {then}. Now: {now}.",
                                     {{"then", written_for}, {"now", exact}});
}

Json json_of(const OwnWords& own) {
  Json all = Json::object();
  for (const WordsField& field : words_fields)
    if (const std::optional<std::string>& words = own.*field.words)
      all[field.name] = words->empty() ? Json() : Json(viz::plain(*words));
  return all;
}

}  // namespace isect::program::scene
