#include "app/book/terms_script.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/book/page_shell.h"
#include "app/pages/html.h"
#include "viz/text/rich_text.h"

namespace isect::program::book {

std::string terms_script(const viz::Course& course, const std::vector<const viz::Lesson*>& lessons, bool alone) {
  constexpr std::size_t letter = 2;  // bytes: the course tells its letters among its terms
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const viz::Course::Term& term : course.terms) {
    if (term.name.size() <= letter) continue;
    nlohmann::ordered_json one = {term.name, html_text(term.meaning)};
    const auto lesson = std::ranges::find(lessons, term.lesson, &viz::Lesson::id);
    if (!alone && lesson != lessons.end())
      one.push_back(viz::plain((*lesson)->title)), one.push_back(file_of(**lesson));
    all.push_back(one);
  }
  return "var isect_terms = " + all.dump() + ";\n";
}

}  // namespace isect::program::book
