#include "viz/lang/catalogue.h"

#include <fmt/format.h>

#include <map>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "viz/lang/po.h"
#include "viz/lesson.h"

namespace isect::viz {

namespace {

/// The translations of one file by context and English text.
struct Translations {
  Plural plural = Plural::one_is_singular;
  std::map<std::pair<std::string, std::string>, std::vector<std::string>> texts;

  const std::vector<std::string>* of(std::string_view context, std::string_view english) const {
    const auto found = texts.find({std::string(context), std::string(english)});
    return found == texts.end() ? nullptr : &found->second;
  }
};

PoFile file_from(const PoText& source) {
  try {
    return read_po(source.text);
  } catch (const BadInput& e) {
    throw std::logic_error(fmt::format("{}/{}.po, {}", source.subject, source.language, e.what()));
  }
}

/// By subject and language; read when the first text is looked up.
const std::map<std::pair<std::string, std::string>, Translations>& translations() {
  static const auto all = [] {
    std::map<std::pair<std::string, std::string>, Translations> read;
    for (const PoText& source : po_texts()) {
      if (*source.language == '\0') continue;
      PoFile file = file_from(source);
      Translations& to = read[{source.subject, source.language}];
      to.plural = file.plural;
      for (PoEntry& entry : file.entries)
        if (entry.is_translated())
          to.texts.emplace(std::pair(std::move(entry.context), std::move(entry.english)), std::move(entry.texts));
    }
    return read;
  }();
  return all;
}

}  // namespace

const std::string* translation(const std::string& language, const Message& m, std::optional<std::size_t> count) {
  if (language == "en") return nullptr;
  for (const auto& [whose, all] : translations()) {
    if (whose.second != language) continue;
    if (const std::vector<std::string>* const texts = all.of(m.context, m.english))
      return &texts->at(count && texts->size() > 1 ? plural_form(all.plural, *count) : 0);
  }
  return nullptr;
}

const std::string* translation_in(const std::string& subject, const std::string& language, const std::string& english) {
  const auto file = translations().find({subject, language});
  if (file == translations().end()) return nullptr;
  const std::vector<std::string>* const texts = file->second.of("", english);
  return texts ? &texts->front() : nullptr;
}

bool speaks(const std::string& subject, const std::string& language) {
  return language == "en" || translations().contains({subject, language});
}

Coverage coverage(const std::string& language) {
  Coverage told;
  for (const PoText& source : po_texts()) {
    if (*source.subject != '\0' || *source.language != '\0') continue;
    for (const PoEntry& entry : file_from(source).entries) {
      const Message key = {entry.english, entry.other, entry.context};
      ++told.all;
      if (language == "en" || translation(language, key, 1)) ++told.translated;
    }
  }
  return told;
}

}  // namespace isect::viz
