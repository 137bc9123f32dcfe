// All lessons, in the order of the course: full titles by subject, answers, saved presets.

#include <algorithm>
#include <cmath>
#include <filesystem>
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

constexpr float row_height = 28, heading_height = 30, gutter = 20;

/// A row of the picker: a heading, a lesson, or a saved preset.
struct Entry {
  std::string heading = {};
  const Lesson* lesson = nullptr;
  std::string preset = {};
  bool again = false;  ///< the lesson is listed below, too
  float height() const { return heading.empty() ? row_height + 2 : heading_height; }
};

bool wanted(const Lesson& l, const Course& course, const std::string& words) {
  std::string all = l.id + " " + plain(l.title) + " " + l.summary;
  for (const std::string& idea : l.ideas) all += " " + idea;
  for (const Preset& preset : l.presets) all += " " + plain(preset.title);
  for (const Course::Term& term : course.terms)
    if (term.lesson == l.id) all += " " + term.name;
  return matches(all, words);
}

/// Returns "ray-sphere, setting-1", with the folder unless that is the one for figures.
std::string name_of_preset(const WindowSession& s, const std::filesystem::path& file) {
  const std::filesystem::path lesson = file.parent_path(), folder = lesson.parent_path();
  const std::string name = lesson.filename().string() + ", " + file.stem().string();
  std::error_code error;
  const std::filesystem::path own = std::filesystem::absolute(s.figures, error);
  return (own / "").lexically_normal() == folder / "" ? name : name + ", in " + folder.string();
}

std::vector<Entry> rows_of(const WindowSession& s) {
  std::vector<Entry> rows;
  const std::vector<const Lesson*>& lessons = s.player.lessons();
  const auto add = [&](const std::string& heading, const Entry& row) {
    if (!heading.empty()) rows.push_back({heading});
    rows.push_back(row);
  };
  if (s.search.empty() && s.settings.recent.size() > 1) {
    std::string heading = "Last opened";
    for (const std::string& id : s.settings.recent) {
      if (id == s.player.lesson().id) continue;
      add(std::exchange(heading, {}), {{}, &lesson_named(lessons, id), {}, true});
    }
  }
  std::string heading;
  for (const Lesson* l : lessons) {
    for (const Course::Part& part : s.course.parts)
      if (part.first == l->id) heading = part.title;
    if (wanted(*l, s.course, s.search)) add(std::exchange(heading, {}), {{}, l});
  }
  heading = "Saved presets";
  for (const std::string& file : s.picker.presets)
    if (matches(name_of_preset(s, file), s.search)) add(std::exchange(heading, {}), {{}, nullptr, file});
  return rows;
}

/// Draws "5 of 6 right", after a tick if the lesson was read to its end: a green one if all answers were right.
void score(WindowSession& s, const Lesson& l, float right, float y) {
  const auto found = s.settings.scores.find(l.id);
  if (found == s.settings.scores.end()) return;
  const Score& score = found->second;
  const Palette& c = s.ui.palette;
  float x = right;
  if (!score.answers.empty())
    x -= 20 + text(s.ui.fonts.small, x, y, packed(c.muted),
                   std::to_string(score.right()) + " of " + std::to_string(score.answers.size()) + " right", 1);
  const bool all_right = !score.answers.empty() && score.right() == static_cast<int>(score.answers.size());
  if (score.finished) tick(x, y, 12, packed(all_right ? c.hit : c.muted));
  s.ui.rects["score " + l.id] = {x - 6, y - 9, right, y + 9};
}

/// Draws a row. Returns whether it was pressed; if the pointer or the keyboard is at it, its lesson becomes `told`.
bool lesson_row(WindowSession& s, const Lesson& l, const Rect& r, bool again, const Lesson*& told) {
  Ui& ui = s.ui;
  const std::string name = (again ? "recent " : "lesson ") + l.id;
  const Press p = press(ui, name, r);
  if (p.hovered || ui.focus.name() == name) told = &l;
  if (p.hovered || &l == &s.player.lesson()) filled(r, p.hovered ? ui.palette.hovered : ui.palette.card, 5);
  const float marks = s.settings.scores.contains(l.id) ? 116.0f : 0.0f;
  text(ui.fonts.body, r.left + 8, r.middle_y(), packed(ui.palette.text),
       fitted(ui.fonts.body, plain(l.title), r.width() - 16 - marks));
  score(s, l, r.right - 8, r.middle_y());
  return p.clicked;
}

bool preset_row(WindowSession& s, const std::string& file, const Rect& r) {
  const std::string name = name_of_preset(s, file);
  const Press p = press(s.ui, "saved " + name, r);
  if (p.hovered) filled(r, s.ui.palette.hovered, 5);
  text(s.ui.fonts.body, r.left + 8, r.middle_y(), packed(s.ui.palette.text),
       fitted(s.ui.fonts.body, name, r.width() - 16));
  return p.clicked;
}

void open_preset(WindowSession& s, const std::string& file) {
  try {
    s.player.go(reader_state_from_json(read_file(file), s.player.lessons()));
  } catch (const FileError& failed) {
    s.complain(failed.what());
  } catch (const BadInput& wrong) {
    s.complain(file + ": " + wrong.what());
  }
}

/// Returns "After Interval and interval. Minkowski sum: Oriented boxes."
std::string leads(const WindowSession& s, const Lesson& l) {
  std::string text;
  const auto name = [&](const std::string& head, const Lesson& other) {
    text += (text.ends_with(' ') || text.empty() ? head : ", ") + plain(short_title(other));
  };
  for (const Lesson* other : s.player.lessons())
    if (std::ranges::count(l.after, other->id) > 0) name("After ", *other);
  if (!text.empty()) text += ". ";
  for (const SharedIdea& shared : shared_ideas(l)) {
    for (const Lesson* other : shared.others) name(heading(shared) + ": ", *other);
    text += ". ";
  }
  return text;
}

/// Draws, below the rows, the lesson's picture, and in words what it is about.
void foot(WindowSession& s, const Lesson& l, const Rect& r) {
  Ui& ui = s.ui;
  const Palette& c = ui.palette;
  const float width = r.height() * picture_width / picture_height;
  const Rect picture{r.left, r.top, r.left + width, r.bottom};
  filled(picture, c.card, 0);
  s.picker.lesson = &l;
  ui.rects["about " + l.id] = r;
  if (s.picker.picture) {
    ui.rects["lesson picture"] = picture;
    ImGui::GetWindowDrawList()->AddImage(s.picker.picture, top_left(picture), bottom_right(picture), {0, 1}, {1, 0});
  }
  outlined(picture, c.rule, 1, 0);
  const float left = picture.right + 16, room = r.right - left;
  text(ui.fonts.bold, left, r.top + 12, packed(c.text), fitted(ui.fonts.bold, plain(l.title), room));
  const Paragraph words{.markup = l.summary, .width = room, .size = 13, .line_pitch = 19, .colour = c.text};
  const float end = r.top + 30 + rich(ui, words, {left, r.top + 26}).y;
  const Paragraph near{.markup = leads(s, l), .width = room, .size = 13, .line_pitch = 19, .colour = c.muted};
  if (end + ui.texts.size_of(near).y < r.bottom - 22) rich(ui, near, {left, end});
  text(ui.fonts.small, left, r.bottom - 10, packed(c.muted), "↓ and ↑ choose, Enter opens, Escape closes");
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

/// Draws the rows in as many columns as there is room for, of about equal length. Returns the row that was pressed.
const Entry* columns(WindowSession& s, const std::vector<Entry>& rows, ImVec2 at, float width, const Lesson*& told) {
  const int count = width >= 660 ? 2 : 1;
  const float wide = (width - gutter * static_cast<float>(count - 1)) / static_cast<float>(count);
  const Entry* const second = count > 1 ? second_column(rows) : nullptr;
  float x = at.x, y = at.y + 8, end = y;
  const Entry* pressed = nullptr;
  for (const Entry& row : rows) {
    if (&row == second) x += wide + gutter, y = at.y + 8;
    const Rect r{x, y, x + wide, y + row_height};
    bool clicked = false;
    if (!row.heading.empty())
      text(s.ui.fonts.bold, x + 8, y + 18, packed(s.ui.palette.muted), row.heading);
    else if (row.lesson)
      clicked = lesson_row(s, *row.lesson, r, row.again, told);
    else
      clicked = preset_row(s, row.preset, r);
    if (clicked) pressed = &row;
    y += row.height();
    end = std::max(end, y);
  }
  if (rows.empty())
    text(s.ui.fonts.body, x + 8, y + 16, packed(s.ui.palette.muted),
         "No title, summary, term or preset has these words");
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy({1, end - at.y});
  return pressed;
}

}  // namespace

void picker(WindowSession& s, const Rect& window) {
  s.picker.lesson = nullptr;
  if (!begin_sheet(s.ui, "picker", window, 860, 730)) return;
  if (ImGui::IsWindowAppearing()) s.picker.presets = saved_presets(s.figures, s.settings.saved);
  const bool entered = search_field(s.ui, s.search, "Search lessons");
  const std::vector<Entry> rows = rows_of(s);

  const float below_rows = window.height() < 700 ? 86 : picture_height;
  const Lesson* told = nullptr;
  ImGui::BeginChild("lessons", {0, ImGui::GetContentRegionAvail().y - below_rows - 18});
  const Entry* chosen = columns(s, rows, ImGui::GetCursorScreenPos(), ImGui::GetContentRegionAvail().x - 4, told);
  ImGui::EndChild();
  const ImVec2 below = ImGui::GetCursorScreenPos(), left = ImGui::GetContentRegionAvail();
  const auto first = std::ranges::find_if(rows, [](const Entry& row) { return row.heading.empty(); });
  if (!told && !s.search.empty() && first != rows.end()) told = first->lesson;  // Enter opens it
  if (told || s.search.empty())
    foot(s, told ? *told : s.player.lesson(),
         {below.x, below.y + left.y - below_rows, below.x + left.x, below.y + left.y});
  if (entered && !chosen && s.ui.focus.name().empty() && first != rows.end()) chosen = &*first;
  if (chosen) {
    if (chosen->lesson)
      s.attempt([&] { s.player.open(*chosen->lesson); });
    else
      open_preset(s, chosen->preset);
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace isect::viz
