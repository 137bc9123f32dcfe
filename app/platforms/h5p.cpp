// Questions as H5P: a question set of multiple choices, each with its picture above it.

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/pages/html.h"
#include "app/platforms/quiz_formats.h"
#include "app/platforms/quiz_html.h"
#include "app/platforms/zip.h"
#include "viz/text/utf8.h"

namespace isect::program::platforms {

namespace {

using Json = nlohmann::ordered_json;

/// A library that the platform has, at the version for which the content is written.
struct H5pLibrary {
  const char* name;
  int major, minor;
  std::string told() const { return fmt::format("{} {}.{}", name, major, minor); }
};
constexpr H5pLibrary question_set = {"H5P.QuestionSet", 1, 20}, multi_choice = {"H5P.MultiChoice", 1, 16},
                     image = {"H5P.Image", 1, 1};

/// Returns HTML with the elements that H5P keeps: it drops i and b.
std::string with_emphasis(std::string html) {
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"<i>", "<em>"},
                                 {"</i>", "</em>"},
                                 {"<b>", "<strong>"},
                                 {"</b>", "</strong>"}})
    for (std::size_t at = 0; (at = html.find(from, at)) != html.npos; at += to.size())
      html.replace(at, from.size(), to);
  return html;
}

std::string h5p_text(const std::string& markup) { return with_emphasis(html_text(markup)); }

/// Returns at most 255 bytes, as H5P's titles have, and whole characters.
std::string h5p_title(std::string title) {
  constexpr std::size_t most = 255;
  if (title.size() <= most) return title;
  std::size_t end = most;
  while (end > 0 && viz::continues_character(title[end])) --end;
  return title.substr(0, end);
}

Json h5p_metadata(const char* type, const std::string& title) {
  return {{"contentType", type}, {"license", "U"}, {"title", h5p_title(title)}};
}

/// Returns a part of a content: a library with its parameters.
Json h5p_part(const H5pLibrary& library, const std::string& id, const char* type, const std::string& title,
              Json parameters) {
  return {{"library", library.told()},
          {"params", std::move(parameters)},
          {"subContentId", uuid(id)},
          {"metadata", h5p_metadata(type, title)}};
}

/// `path`: of its file, below content/.
Json h5p_picture(const QuizItem& item, const std::string& path) {
  if (!item.picture) return {{"disableImageZooming", false}};
  Json file = {{"path", path},
               {"mime", "image/png"},
               {"copyright", {{"license", "U"}}},
               {"width", item.picture->width},
               {"height", item.picture->height}};
  Json picture = {
      {"contentName", "Image"}, {"file", std::move(file)}, {"alt", item.picture->alt}, {"decorative", false}};
  return {{"type", h5p_part(image, item.id + "/picture", "Image", item.title, std::move(picture))},
          {"disableImageZooming", false}};
}

/// What is said to the right choice is told to whoever chose another one, too, once the solution is shown.
Json h5p_answer(const QuizItem& item, std::size_t i) {
  const bool right = i == item.right;
  const std::string solution = h5p_text(item.solution);
  return {{"text", fmt::format("<div>{}</div>\n", h5p_text(item.choices[i].text))},
          {"correct", right},
          {"tipsAndFeedback",
           {{"tip", ""},
            {"chosenFeedback", right ? solution : h5p_text(item.choices[i].reply)},
            {"notChosenFeedback", right ? solution : ""}}}};
}

Json h5p_question(const QuizItem& item, const std::string& picture) {
  Json answers = Json::array();
  for (std::size_t i = 0; i < item.choices.size(); ++i) answers.push_back(h5p_answer(item, i));
  Json parameters = {{"media", h5p_picture(item, picture)},
                     {"question", with_emphasis(task_html(item)) + "\n"},
                     {"answers", std::move(answers)},
                     {"overallFeedback", Json::array({Json{{"from", 0}, {"to", 100}}})},
                     {"behaviour",
                      {{"enableRetry", true},
                       {"enableSolutionsButton", true},
                       {"enableCheckButton", true},
                       {"type", "single"},
                       {"singlePoint", false},
                       {"randomAnswers", false},
                       {"showSolutionsRequiresInput", true},
                       {"confirmCheckDialog", false},
                       {"confirmRetryDialog", false},
                       {"autoCheck", false},
                       {"passPercentage", 100},
                       {"showScorePoints", true}}}};
  return h5p_part(multi_choice, item.id, "Multiple Choice", item.title, std::move(parameters));
}

Json h5p_content(Json questions) {
  return {{"introPage", {{"showIntroPage", false}, {"startButtonText", "Start"}}},
          {"progressType", "dots"},
          {"passPercentage", 50},
          {"questions", std::move(questions)},
          {"disableBackwardsNavigation", false},
          {"randomQuestions", false},
          {"endGame",
           {{"showResultPage", true},
            {"showSolutionButton", true},
            {"showRetryButton", true},
            {"message", "Your result:"},
            {"overallFeedback", Json::array({Json{{"from", 0}, {"to", 100}}})}}},
          {"override", {{"checkButton", true}}}};
}

Json h5p_package(const QuizSheet& sheet) {
  Json needs = Json::array();
  for (const H5pLibrary& library : {question_set, multi_choice, image})
    needs.push_back({{"machineName", library.name}, {"majorVersion", library.major}, {"minorVersion", library.minor}});
  return {{"title", h5p_title(sheet.title)},       {"language", "en"}, {"mainLibrary", question_set.name},
          {"embedTypes", Json::array({"iframe"})}, {"license", "U"},   {"preloadedDependencies", std::move(needs)}};
}

}  // namespace

std::string h5p(const QuizSheet& sheet, const std::string& mark) {
  Json questions = Json::array();
  std::vector<ZipEntry> pictures;
  for (const QuizItem& item : sheet.items) {
    const std::string picture = fmt::format("images/question-{}.png", questions.size() + 1);
    questions.push_back(h5p_question(item, picture));
    if (item.picture) pictures.push_back({"content/" + picture, item.picture->png});
  }
  std::vector<ZipEntry> files = {{"h5p.json", h5p_package(sheet).dump(2)},
                                 {"content/content.json", h5p_content(std::move(questions)).dump(2)}};
  files.insert(files.end(), pictures.begin(), pictures.end());
  return zip_archive(files, mark);
}

}  // namespace isect::program::platforms
