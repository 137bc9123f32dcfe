#pragma once
// An H5P package: its fields as the platforms' validator asks for them, and its questions.

#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <utility>

#include "tests/app/readers/quiz.h"

namespace isect::test {

inline void need_h5p(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error("h5p: " + what);
}

/// Only elements that H5P keeps are in this HTML.
inline std::string h5p_words(const std::string& html) {
  static const std::regex element("</?([a-z0-9]+)");
  static const std::set<std::string> kept = {"p", "br", "div", "em", "strong", "sub", "sup"};
  for (auto at = std::sregex_iterator(html.begin(), html.end(), element); at != std::sregex_iterator(); ++at)
    need_h5p(kept.contains((*at)[1]), "it drops " + (*at)[1].str());
  std::string words = words_of_html(html);
  while (words.ends_with('\n')) words.pop_back();
  return words;
}

/// The libraries that h5p.json names, as contents name them: "H5P.Image 1.1".
inline std::set<std::string> h5p_libraries(const nlohmann::json& about) {
  const auto fits = [&](const char* field, const std::string& pattern) {
    need_h5p(about.contains(field) && std::regex_match(about[field].get<std::string>(), std::regex(pattern)),
             std::string(field) + " is missing or wrong");
  };
  fits("title", ".{1,255}"), fits("language", "[-a-zA-Z]{1,10}"),
      fits("mainLibrary", "[$a-z_A-Z][0-9a-zA-Z_.$]{1,254}");
  fits("license", "CC BY|CC BY-SA|CC BY-ND|CC BY-NC|CC BY-NC-SA|CC BY-NC-ND|CC0 1\\.0|GNU GPL|PD|ODC PDDL|CC PDM|U|C");
  for (const auto& type : about.at("embedTypes"))
    need_h5p(type == "iframe" || type == "div", "it is embedded otherwise");
  std::set<std::string> all;
  for (const auto& library : about.at("preloadedDependencies"))
    all.insert(library.at("machineName").get<std::string>() + " " +
               std::to_string(library.at("majorVersion").get<int>()) + "." +
               std::to_string(library.at("minorVersion").get<int>()));
  const std::string main = about.at("mainLibrary").get<std::string>() + " ";
  need_h5p(std::ranges::any_of(all, [&](const std::string& name) { return name.starts_with(main); }),
           "the main library is none that it needs");
  return all;
}

/// Reads a whole package, `files`.
inline std::vector<ReadQuestion> read_h5p(const std::map<std::string, std::string>& files) {
  using Json = nlohmann::json;
  const Json about = Json::parse(files.at("h5p.json")), content = Json::parse(files.at("content/content.json"));
  const std::set<std::string> libraries = h5p_libraries(about);
  need_h5p(about["mainLibrary"] == "H5P.QuestionSet", "it is no question set");
  std::set<std::string> used = {"h5p.json", "content/content.json"}, ids;
  const auto check_part = [&](const Json& part, const std::string& library) {
    const std::string name = part.at("library").get<std::string>(), id = part.at("subContentId").get<std::string>();
    need_h5p(name.starts_with(library + " ") && libraries.contains(name), name + " is not named by h5p.json");
    need_h5p(std::regex_match(id, std::regex("[0-9a-f]{8}-[0-9a-f]{4}-4[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}")),
             id + " is no id");
    need_h5p(ids.insert(id).second, id + " is there twice");
    need_h5p(part.at("metadata").at("license") == "U" && !part["metadata"].at("title").get<std::string>().empty(),
             "a part has no title or licence");
  };
  std::vector<ReadQuestion> all;
  for (const Json& question : content.at("questions")) {
    check_part(question, "H5P.MultiChoice");
    const Json& asked = question.at("params");
    ReadQuestion read = {"choice", question["subContentId"], question["metadata"]["title"], {}, {}, {}, {}};
    read.words = h5p_words(asked.at("question").get<std::string>()) + "\n";
    need_h5p(asked.at("behaviour").at("type") == "single" && asked["behaviour"].at("randomAnswers") == false,
             "the answers are no single choice in a fixed order");
    for (const Json& answer : asked.at("answers")) {
      ReadAnswer one = {h5p_words(answer.at("text").get<std::string>()), answer.at("correct").get<bool>(),
                        h5p_words(answer.at("tipsAndFeedback").at("chosenFeedback").get<std::string>())};
      const std::string otherwise = h5p_words(answer["tipsAndFeedback"].at("notChosenFeedback").get<std::string>());
      need_h5p(otherwise == (one.right ? one.reply : ""), "who chose another one is told something else");
      if (one.right) read.solution = std::exchange(one.reply, {});
      read.answers.push_back(one);
    }
    if (asked.at("media").contains("type")) {
      const Json& image = asked["media"]["type"];
      check_part(image, "H5P.Image");
      const Json& file = image.at("params").at("file");
      const std::string path = "content/" + file.at("path").get<std::string>();
      need_h5p(path.starts_with("content/images/") && files.contains(path) && file.at("mime") == "image/png",
               path + " is no picture of the package");
      used.insert(path);
      read.png = files.at(path), read.alt = image["params"].at("alt").get<std::string>();
    }
    all.push_back(read);
  }
  for (const auto& [name, bytes] : files) need_h5p(used.contains(name), name + " is not used");
  return all;
}

}  // namespace isect::test
