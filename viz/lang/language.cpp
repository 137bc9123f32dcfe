#include "viz/lang/language.h"

#include <algorithm>

#include "viz/lesson.h"

namespace isect::viz {

namespace {

thread_local const Language* spoken_now = nullptr;  // null: English

}  // namespace

const std::vector<Language>& languages() {
  static const std::vector<Language> all = {
      {"en", "English"}, {"de", "Deutsch"}, {"fr", "français"}, {"es", "español"}, {"zh", "中文"}};
  return all;
}

const Language& language_named(const std::string& code) {
  const auto found = std::ranges::find(languages(), code, &Language::code);
  if (found != languages().end()) return *found;
  std::vector<std::string> codes;
  for (const Language& language : languages()) codes.push_back(language.code);
  throw unknown("lang", code, codes);
}

const std::string& spoken() { return spoken_now ? spoken_now->code : languages().front().code; }

Speaking::Speaking(const std::string& code) : before_(spoken_now) {
  spoken_now = code.empty() ? nullptr : &language_named(code);
}

Speaking::~Speaking() { spoken_now = before_; }

}  // namespace isect::viz
