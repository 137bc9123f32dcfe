// All lessons, in the order of the course: full titles by subject, answers, saved presets.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

#include "viz/formats/files.h"
#include "viz/player/reader_state.h"
#include "viz/text/rich_text.h"
#include "viz/walk/closing.h"
#include "viz/window/lesson_picture.h"
#include "viz/window/save_figure.h"
#include "viz/window/sheets.h"

namespace isect::viz {
namespace {

constexpr float row_height = 25, heading_height = 27, gutter = 20, beside_progress = 124;
constexpr const char* legend = "; ✓ read to the end";

/// A row of the picker: a heading, a lesson, or a saved preset.
struct Entry {
  std::string heading = {};
  const Lesson* lesson = nullptr;
  std::string preset = {};
  bool again = false;  ///< the lesson is listed below, too
  float height() const { return heading.empty() ? row_height + 2 : heading_height; }
};

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

/// Returns "ray-sphere, setting-1", with the folder unless that is the one for figures.
std::string name_of_preset(const std::string& figures, const std::filesystem::path& file) {
  const std::filesystem::path lesson = file.parent_path(), folder = lesson.parent_path();
  const std::string name = lesson.filename().string() + ", " + file.stem().string();
  std::error_code error;
  const std::filesystem::path own = std::filesystem::absolute(figures, error);
  return (own / "").lexically_normal() == folder / "" ? name : name + ", in " + folder.string();
}

/// Adds the lessons that were found, the best first; those that are equally good stand in the order of the course.
void add_found(std::vector<Entry>& rows, const Shelf& shelf, const std::string& words) {
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

/// `now`: the lesson on show.
std::vector<Entry> rows_of(const Picker& picker, const Shelf& shelf, const Lesson& now) {
  std::vector<Entry> rows;
  const auto add = [&](const std::string& heading, const Entry& row) {
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

/// Draws "5 of 6 right", after a tick if the lesson was read to its end: a green one if all answers were right.
void draw_score(Ui& ui, const Score& score, const std::string& lesson, float right, float y, bool chosen) {
  const Palette& c = ui.palette;
  float x = right;
  if (!score.answers.empty())
    x -= 20 + text(ui.fonts.small, x, y, packed(chosen ? c.on_first : c.muted),
                   std::to_string(score.right()) + " of " + std::to_string(score.answers.size()) + " right", 1);
  const bool all_right = !score.answers.empty() && score.right() == static_cast<int>(score.answers.size());
  if (score.finished) tick(x, y, 12, packed(chosen ? c.on_first : all_right ? c.hit : c.muted));
  const Rect r{x - 6, y - 9, right, y + 9};
  ui.rects["score " + lesson] = r;
  if (score.finished && ImGui::IsMouseHoveringRect(top_left(r), bottom_right(r)))
    tooltip(ui, all_right ? "Read to its end, all answers right" : "Read to its end");
}

/// The row whose lesson is told about below all rows, and the one that was pressed; null: none.
struct Touched {
  const Lesson* told = nullptr;
  const Entry* pressed = nullptr;
};

std::string name_of_row(const Entry& row, const std::string& figures) {
  if (!row.lesson) return "saved " + name_of_preset(figures, row.preset);
  return (row.again ? "recent " : "lesson ") + row.lesson->id;
}

/// Draws a row; the `chosen` one, which Enter opens, is filled. Returns whether it was pressed, or the pointer is
/// there.
Press row_of_list(Ui& ui, const Settings& settings, const Entry& row, const std::string& name, const Rect& r,
                  bool chosen) {
  const Palette& c = ui.palette;
  const Press p = press(ui, name, r);
  if (chosen) ui.rects["chosen row"] = r;
  if (p.hovered || chosen) filled(r, chosen ? c.first : c.hovered, 5);
  const auto score = row.lesson ? settings.scores.find(row.lesson->id) : settings.scores.end();
  const float marks = score != settings.scores.end() ? 116.0f : 0.0f;
  const std::string words = row.lesson ? plain(row.lesson->title) : name.substr(std::string("saved ").size());
  text(ui.fonts.body, r.left + 8, r.middle_y(), packed(chosen ? c.on_first : c.text),
       fitted(ui.fonts.body, words, r.width() - 16 - marks));
  if (marks > 0) draw_score(ui, score->second, row.lesson->id, r.right - 8, r.middle_y(), chosen);
  return p;
}

void open_preset(Player& player, Toast& toast, const std::string& file) {
  try {
    player.go(reader_state_from_json(read_file(file), player.lessons()));
  } catch (const FileError& failed) {
    toast.complain(failed.what());
  } catch (const BadInput& wrong) {
    toast.complain(file + ": " + wrong.what());
  }
}

/// Returns "After Interval and interval. Minkowski sum: Oriented boxes."
std::string leads(const std::vector<const Lesson*>& lessons, const Lesson& l) {
  std::string text;
  const auto name = [&](const std::string& head, const Lesson& other) {
    text += (text.ends_with(' ') || text.empty() ? head : ", ") + plain(short_title(other));
  };
  for (const Lesson* other : lessons)
    if (std::ranges::count(l.after, other->id) > 0) name("After ", *other);
  if (!text.empty()) text += ". ";
  for (const SharedIdea& shared : shared_ideas(l)) {
    for (const Lesson* other : shared.others) name(heading(shared) + ": ", *other);
    text += ". ";
  }
  return text;
}

/// Draws, below the rows, the lesson's picture, and in words what it is about. `near`: what it leads to.
void foot(Ui& ui, Picker& picker, const Lesson& l, const std::string& near, const Rect& r) {
  const Palette& c = ui.palette;
  const float width = r.height() * picture_width / picture_height;
  const Rect picture{r.left, r.top, r.left + width, r.bottom};
  filled(picture, c.card, 0);
  picker.lesson = &l;
  ui.rects["about " + l.id] = r;
  if (picker.picture) {
    ui.rects["lesson picture"] = picture;
    ImGui::GetWindowDrawList()->AddImage(picker.picture, top_left(picture), bottom_right(picture), {0, 1}, {1, 0});
  }
  outlined(picture, c.rule, 1, 0);
  const float left = picture.right + 16, room = r.right - left;
  text(ui.fonts.bold, left, r.top + 12, packed(c.text), fitted(ui.fonts.bold, plain(l.title), room));
  const Paragraph words{.markup = l.summary, .width = room, .size = 13, .line_pitch = 19, .colour = c.text};
  const float end = r.top + 30 + rich(ui, words, {left, r.top + 26}).y;
  const Paragraph others{.markup = near, .width = room, .size = 13, .line_pitch = 19, .colour = c.muted};
  if (end + ui.texts.size_of(others).y < r.bottom - 22) rich(ui, others, {left, end});
  const std::string keys = "↓ and ↑ choose, Enter opens, Escape closes";
  const bool roomy = text_width(ui.fonts.small, keys + legend) < room - beside_progress;
  text(ui.fonts.small, left, r.bottom - 10, packed(c.muted), roomy ? keys + legend : keys);
}

/// Returns the heading that begins the second column, so that the longer one is as short as possible; null: none.
const Entry* second_column(const std::vector<Entry>& rows) {
  float total = 0, before = 0;
  for (const Entry& row : rows) total += row.height();
  const Entry* best = nullptr;
  float least = total;
  for (const Entry& row : rows) {
    if (const float longer = std::max(before, total - before); !row.heading.empty() && longer < least)
      least = longer, best = &row;
    before += row.height();
  }
  return best;
}

/// Returns the row that Enter opens: the one that the keyboard holds; else the best that was found or, as long as
/// nothing is searched for, the lesson on show. Null: none.
const Entry* chosen_row(const std::vector<Entry>& rows, const Picker& picker, const Shelf& shelf, const Lesson& now,
                        const std::string& held) {
  const Entry* first = nullptr;
  for (const Entry& row : rows) {
    if (!row.heading.empty()) continue;
    if (!held.empty() && name_of_row(row, shelf.figures) == held) return &row;
    if (!first && (!picker.search.empty() || (row.lesson == &now && !row.again))) first = &row;
  }
  return held.empty() ? first : nullptr;
}

/// Draws the rows in as many columns as there is room for, of about equal length.
Touched columns(Ui& ui, const Shelf& shelf, const Entry* chosen, const std::vector<Entry>& rows, ImVec2 at,
                float width) {
  const int count = width >= 660 ? 2 : 1;
  const float wide = (width - gutter * static_cast<float>(count - 1)) / static_cast<float>(count);
  const Entry* const second = count > 1 ? second_column(rows) : nullptr;
  float x = at.x, y = at.y + 8, end = y;
  Touched touched;
  for (const Entry& row : rows) {
    if (&row == second) x += wide + gutter, y = at.y + 8;
    const Rect r{x, y, x + wide, y + row_height};
    if (row.heading.empty()) {
      const Press p = row_of_list(ui, shelf.settings, row, name_of_row(row, shelf.figures), r, &row == chosen);
      if (&row == chosen && ImGui::IsWindowAppearing())
        ImGui::SetScrollFromPosY(r.middle_y() - ImGui::GetWindowPos().y, 0.5f);
      if (p.hovered) touched.told = row.lesson;
      if (p.clicked) touched.pressed = &row;
    } else {
      text(ui.fonts.bold, x + 8, y + 18, packed(ui.palette.muted), row.heading);
    }
    y += row.height();
    end = std::max(end, y);
  }
  if (rows.empty())
    text(ui.fonts.body, x + 8, y + 16, packed(ui.palette.muted), "No title, summary, term or preset has these words");
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy({1, end - at.y});
  return touched;
}

}  // namespace

void picker(Player& player, Ui& ui, Picker& picker, const Shelf& shelf, Toast& toast, const Rect& window) {
  picker.lesson = nullptr;
  if (!begin_sheet(ui, "picker", window, 860, 730)) return;
  if (ImGui::IsWindowAppearing()) picker.presets = saved_presets(shelf.figures, shelf.settings.saved);
  const std::string searched_before = picker.search;
  const bool entered = search_field(ui, picker.search, "Search lessons");
  const bool typed = picker.search != searched_before && !ImGui::IsWindowAppearing();
  if (typed) ui.focus.clear();  // what is found best is chosen again
  const std::vector<Entry> rows = rows_of(picker, shelf, player.lesson());

  const float below_rows = window.height() < 700 ? 86 : picture_height;
  ImGui::BeginChild("lessons", {0, ImGui::GetContentRegionAvail().y - below_rows - 18});
  const Entry* const chosen = chosen_row(rows, picker, shelf, player.lesson(), ui.focus.name());
  if (chosen) ui.focus.begin_at(name_of_row(*chosen, shelf.figures));
  Touched at = columns(ui, shelf, chosen, rows, ImGui::GetCursorScreenPos(), ImGui::GetContentRegionAvail().x - 4);
  ImGui::EndChild();
  const ImVec2 below = ImGui::GetCursorScreenPos(), left = ImGui::GetContentRegionAvail();
  if (!at.told && chosen) at.told = chosen->lesson;
  if (!at.told && !chosen && picker.search.empty()) at.told = &player.lesson();
  const Rect below_all{below.x, below.y + left.y - below_rows, below.x + left.x, below.y + left.y};
  if (at.told) foot(ui, picker, *at.told, leads(shelf.lessons, *at.told), below_all);
  const Rect progress{below_all.right - 110, below_all.bottom - 22, below_all.right, below_all.bottom};
  if (chip(ui, "show progress", progress, "Progress", false)) {
    picker.progress = true;
    ImGui::CloseCurrentPopup();
  }
  const bool stays = chosen && chosen->lesson == &player.lesson() && picker.search.empty();
  if (entered && !at.pressed && ui.focus.name().empty()) {
    if (stays) ImGui::CloseCurrentPopup();  // the lesson on show is not begun anew
    if (!stays) at.pressed = chosen;
  }
  if (at.pressed) {
    if (at.pressed->lesson)
      attempt(toast, [&] { player.open(*at.pressed->lesson); });
    else
      open_preset(player, toast, at.pressed->preset);
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace isect::viz
