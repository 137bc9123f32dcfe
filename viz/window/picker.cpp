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

constexpr float row_height = 25, heading_height = 27, gutter = 20;

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
std::string name_of_preset(const std::string& figures, const std::filesystem::path& file) {
  const std::filesystem::path lesson = file.parent_path(), folder = lesson.parent_path();
  const std::string name = lesson.filename().string() + ", " + file.stem().string();
  std::error_code error;
  const std::filesystem::path own = std::filesystem::absolute(figures, error);
  return (own / "").lexically_normal() == folder / "" ? name : name + ", in " + folder.string();
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
  for (const Lesson* l : shelf.lessons) {
    for (const Course::Part& part : shelf.course.parts)
      if (part.first == l->id) heading = part.title;
    if (wanted(*l, shelf.course, picker.search)) add(std::exchange(heading, {}), {{}, l});
  }
  heading = "Saved presets";
  for (const std::string& file : picker.presets)
    if (matches(name_of_preset(shelf.figures, file), picker.search))
      add(std::exchange(heading, {}), {{}, nullptr, file});
  return rows;
}

/// Draws "5 of 6 right", after a tick if the lesson was read to its end: a green one if all answers were right.
void draw_score(Ui& ui, const Score& score, const std::string& lesson, float right, float y) {
  const Palette& c = ui.palette;
  float x = right;
  if (!score.answers.empty())
    x -= 20 + text(ui.fonts.small, x, y, packed(c.muted),
                   std::to_string(score.right()) + " of " + std::to_string(score.answers.size()) + " right", 1);
  const bool all_right = !score.answers.empty() && score.right() == static_cast<int>(score.answers.size());
  if (score.finished) tick(x, y, 12, packed(all_right ? c.hit : c.muted));
  ui.rects["score " + lesson] = {x - 6, y - 9, right, y + 9};
}

/// The row whose lesson is told about below all rows, and the one that was pressed; null: none.
struct Touched {
  const Lesson* told = nullptr;
  const Entry* pressed = nullptr;
};

/// Draws a row. Returns whether it was pressed; if the pointer or the keyboard is at it, its lesson becomes `told`.
bool lesson_row(Ui& ui, const Settings& settings, const Lesson& l, const Rect& r, bool again, bool now,
                const Lesson*& told) {
  const std::string name = (again ? "recent " : "lesson ") + l.id;
  const Press p = press(ui, name, r);
  if (p.hovered || ui.focus.name() == name) told = &l;
  if (p.hovered || now) filled(r, p.hovered ? ui.palette.hovered : ui.palette.card, 5);
  const auto score = settings.scores.find(l.id);
  const float marks = score != settings.scores.end() ? 116.0f : 0.0f;
  text(ui.fonts.body, r.left + 8, r.middle_y(), packed(ui.palette.text),
       fitted(ui.fonts.body, plain(l.title), r.width() - 16 - marks));
  if (score != settings.scores.end()) draw_score(ui, score->second, l.id, r.right - 8, r.middle_y());
  return p.clicked;
}

bool preset_row(Ui& ui, const std::string& name, const Rect& r) {
  const Press p = press(ui, "saved " + name, r);
  if (p.hovered) filled(r, ui.palette.hovered, 5);
  text(ui.fonts.body, r.left + 8, r.middle_y(), packed(ui.palette.text), fitted(ui.fonts.body, name, r.width() - 16));
  return p.clicked;
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

/// Draws the rows in as many columns as there is room for, of about equal length.
Touched columns(Ui& ui, const Shelf& shelf, const Lesson& now, const std::vector<Entry>& rows, ImVec2 at, float width) {
  const int count = width >= 660 ? 2 : 1;
  const float wide = (width - gutter * static_cast<float>(count - 1)) / static_cast<float>(count);
  const Entry* const second = count > 1 ? second_column(rows) : nullptr;
  float x = at.x, y = at.y + 8, end = y;
  Touched touched;
  for (const Entry& row : rows) {
    if (&row == second) x += wide + gutter, y = at.y + 8;
    const Rect r{x, y, x + wide, y + row_height};
    bool clicked = false;
    if (!row.heading.empty())
      text(ui.fonts.bold, x + 8, y + 18, packed(ui.palette.muted), row.heading);
    else if (row.lesson)
      clicked = lesson_row(ui, shelf.settings, *row.lesson, r, row.again, row.lesson == &now, touched.told);
    else
      clicked = preset_row(ui, name_of_preset(shelf.figures, row.preset), r);
    if (clicked) touched.pressed = &row;
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
  const bool entered = search_field(ui, picker.search, "Search lessons");
  const std::vector<Entry> rows = rows_of(picker, shelf, player.lesson());

  const float below_rows = window.height() < 700 ? 86 : picture_height;
  ImGui::BeginChild("lessons", {0, ImGui::GetContentRegionAvail().y - below_rows - 18});
  Touched at =
      columns(ui, shelf, player.lesson(), rows, ImGui::GetCursorScreenPos(), ImGui::GetContentRegionAvail().x - 4);
  ImGui::EndChild();
  const ImVec2 below = ImGui::GetCursorScreenPos(), left = ImGui::GetContentRegionAvail();
  const auto first = std::ranges::find_if(rows, [](const Entry& row) { return row.heading.empty(); });
  if (!at.told && picker.search.empty()) at.told = &player.lesson();
  if (!at.told && first != rows.end()) at.told = first->lesson;  // Enter opens it
  if (at.told)
    foot(ui, picker, *at.told, leads(shelf.lessons, *at.told),
         {below.x, below.y + left.y - below_rows, below.x + left.x, below.y + left.y});
  if (entered && !at.pressed && ui.focus.name().empty() && first != rows.end()) at.pressed = &*first;
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
