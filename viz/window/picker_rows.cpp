#include "viz/window/picker_rows.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <utility>

#include "viz/text/rich_text.h"
#include "viz/walk/closing.h"

namespace isect::viz {
namespace {

/// How a lesson was found; the better comes first.
enum class Found { by_exact_title, by_begin, by_title, by_words, nowhere };

std::string in_small_letters(std::string s) {
  std::ranges::transform(s, s.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return s;
}

bool wanted(const Lesson& l, const Course& course, const std::string& words) {
  std::string all = l.id + " " + plain(l.title) + " " + l.summary;
  for (const std::string& idea : l.ideas) all += " " + idea;
  for (const Preset& preset : l.presets) all += " " + plain(preset.title);
  for (const Course::Term& term : course.terms)
    if (term.lesson == l.id) all += " " + term.name;
  return matches(all, words);
}

/// A lesson's title is the whole one, the part before its colon, or its id.
Found found(const Lesson& l, const Course& course, const std::string& words) {
  const std::string wanted_title = in_small_letters(words.substr(0, words.find_last_not_of(' ') + 1));
  const std::string title = in_small_letters(plain(l.title));
  if (wanted_title == title || wanted_title == in_small_letters(plain(short_title(l))) || wanted_title == l.id)
    return Found::by_exact_title;
  if (title.starts_with(wanted_title)) return Found::by_begin;
  if (matches(plain(l.title), words)) return Found::by_title;
  return wanted(l, course, words) ? Found::by_words : Found::nowhere;
}

/// Adds the lessons that were found, the best first; those that are equally good stand in the order of the course.
void add_found(std::vector<PickerRow>& rows, const Shelf& shelf, const std::string& words) {
  std::map<Found, std::vector<const Lesson*>> all;
  for (const Lesson* l : shelf.lessons) all[found(*l, shelf.course, words)].push_back(l);
  all.erase(Found::nowhere);
  std::string heading = "By their titles";
  for (const auto& [how, lessons] : all) {
    if (how == Found::by_words) heading = "By their words, presets, ideas and terms";
    for (const Lesson* l : lessons) {
      if (!heading.empty()) rows.push_back({std::exchange(heading, {})});
      rows.push_back({{}, l});
    }
  }
}

}  // namespace

std::string name_of_preset(const std::string& figures, const std::filesystem::path& file) {
  const std::filesystem::path lesson = file.parent_path(), folder = lesson.parent_path();
  const std::string name = lesson.filename().string() + ", " + file.stem().string();
  std::error_code error;
  const std::filesystem::path own = std::filesystem::absolute(figures, error);
  return (own / "").lexically_normal() == folder / "" ? name : name + ", in " + folder.string();
}

std::vector<PickerRow> rows_of(const Picker& picker, const Shelf& shelf, const Lesson& now) {
  std::vector<PickerRow> rows;
  const auto add = [&](const std::string& heading, const PickerRow& row) {
    if (!heading.empty()) rows.push_back({heading});
    rows.push_back(row);
  };
  if (picker.search.empty() && shelf.settings.recent.size() > 1) {
    std::string heading = "Last opened";
    for (const std::string& id : shelf.settings.recent) {
      if (id == now.id) continue;
      add(std::exchange(heading, {}), {{}, &lesson_named(shelf.lessons, id), {}, true});
    }
  }
  std::string heading;
  if (picker.search.empty()) {
    for (const Lesson* l : shelf.lessons) {
      for (const Course::Part& part : shelf.course.parts)
        if (part.first == l->id) heading = part.title;
      add(std::exchange(heading, {}), {{}, l});
    }
  } else {
    add_found(rows, shelf, picker.search);
  }
  heading = "Saved presets";
  for (const std::string& file : picker.presets)
    if (matches(name_of_preset(shelf.figures, file), picker.search))
      add(std::exchange(heading, {}), {{}, nullptr, file});
  return rows;
}

std::string name_of_row(const PickerRow& row, const std::string& figures) {
  if (!row.lesson) return "saved " + name_of_preset(figures, row.preset);
  return (row.again ? "recent " : "lesson ") + row.lesson->id;
}

const PickerRow* chosen_row(const std::vector<PickerRow>& rows, const Picker& picker, const Shelf& shelf,
                            const Lesson& now, const std::string& held) {
  const PickerRow* first = nullptr;
  for (const PickerRow& row : rows) {
    if (!row.heading.empty()) continue;
    if (!held.empty() && name_of_row(row, shelf.figures) == held) return &row;
    if (!first && (!picker.search.empty() || (row.lesson == &now && !row.again))) first = &row;
  }
  return held.empty() ? first : nullptr;
}

}  // namespace isect::viz
