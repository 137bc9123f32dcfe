#include "app/platforms/quiz_formats.h"

#include <algorithm>
#include <sstream>

namespace isect::program::platforms {

const std::vector<QuizFormat>& quiz_formats() {
  static const std::string made = "Made by isect quiz.";
  static const std::vector<QuizFormat> all = {
      {"moodle", "quiz.moodle.xml", "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- " + made + " -->", false, moodle},
      {"gift", "quiz.gift.txt", "// " + made, false, gift},
      {"qti", "quiz.qti.zip", made, true, qti},
      {"h5p", "quiz.h5p", made, true, h5p}};
  return all;
}

AskedFormats asked_formats(const std::string& words) {
  std::vector<std::string> allowed = {"paper", "pdf"};
  for (const QuizFormat& format : quiz_formats()) allowed.push_back(format.name);
  AskedFormats asked;
  std::istringstream all(words + ",");
  for (std::string name; std::getline(all, name, ',');) {
    if (name == "scorm")
      throw viz::BadInput("format: scorm packs a lesson's page, not its questions alone: isect book LESSON --scorm");
    const auto found = std::ranges::find(quiz_formats(), name, &QuizFormat::name);
    if (name != "paper" && name != "pdf" && found == quiz_formats().end()) throw viz::unknown("format", name, allowed);
    if (name == "paper")
      asked.paper = true;
    else if (name == "pdf")
      asked.pdf = true;
    else if (std::ranges::count(asked.platforms, &*found) == 0)
      asked.platforms.push_back(&*found);
  }
  return asked;
}

}  // namespace isect::program::platforms
