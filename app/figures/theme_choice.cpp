#include "app/figures/theme_choice.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "app/shell/named_file.h"
#include "viz/lesson.h"

namespace isect::program {

namespace fs = std::filesystem;

namespace {

/// Throws viz::BadInput if the theme has a fault; `where` begins the message.
const viz::OwnTheme& need_readable(const ReadTheme& read, const std::string& where) {
  if (read.faults.empty()) return read.theme;
  const std::size_t more = read.faults.size() - 1;
  throw viz::BadInput(fmt::format("{}{}{}", where, read.faults.front(),
                                  more == 0 ? "" : fmt::format("; and {} more, which `isect theme` lists", more)));
}

}  // namespace

const ReadTheme& read_theme_file(const std::string& path) {
  static std::map<std::string, ReadTheme> read;
  if (const auto known = read.find(path); known != read.end()) return known->second;
  const std::string text = read_named_file(path), stem = fs::path(path).stem().string();
  try {
    return read.emplace(path, read_theme(text, viz::is_theme_name(stem) ? "my " + stem : stem)).first->second;
  } catch (const viz::BadInput& e) {
    throw viz::BadInput(fmt::format("theme: {}: {}", path, e.what()));
  }
}

bool is_theme_file(const std::string& word) {
  std::error_code absent;
  return word.ends_with(".json") || word.find('/') != word.npos ||
         (word.find('.') != word.npos && fs::is_regular_file(word, absent));
}

viz::ThemeChoice theme_choice(const std::string& word) {
  if (word.starts_with('{')) {
    try {
      return viz::ThemeChoice(need_readable(read_theme(word, {}), ""));
    } catch (const viz::BadInput& e) {
      throw viz::BadInput(fmt::format("theme: its text: {}", e.what()));
    }
  }
  if (!is_theme_file(word)) return viz::theme_named(word);
  return viz::ThemeChoice(need_readable(read_theme_file(word), fmt::format("theme: {}: ", word)));
}

}  // namespace isect::program
