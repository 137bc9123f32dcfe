// All lessons, in the order of the course: full titles by subject, answers, saved presets.

#include <algorithm>
#include <cmath>
#include <utility>

#include "viz/formats/files.h"
#include "viz/player/reader_state.h"
#include "viz/text/rich_text.h"
#include "viz/walk/closing.h"
#include "viz/window/lesson_picture.h"
#include "viz/window/picker_rows.h"
#include "viz/window/save_figure.h"
#include "viz/window/sheets.h"

namespace isect::viz {
namespace {

constexpr float row_height = 25, heading_height = 27, gutter = 20, beside_progress = 124;
float height_of(const PickerRow& row) { return row.heading.empty() ? row_height + 2 : heading_height; }

constexpr const char* legend = "; ✓ read to the end";

/// Draws "5 of 6 right", after a tick if the lesson was read to its end: a green one if all answers were right.
void draw_score(Ui& ui, const Score& score, const std::string& lesson, float right, float y, bool chosen) {
  const Palette& c = ui.palette;
  float x = right;
  if (!score.answers.empty())
    x -= 20 + text(ui.fonts.body, x, y, packed(chosen ? c.on_first : c.muted),
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
  const PickerRow* pressed = nullptr;
};

/// Draws a row; the `chosen` one, which Enter opens, is filled. Returns whether it was pressed, or the pointer is
/// there.
Press row_of_list(Ui& ui, const Settings& settings, const PickerRow& row, const std::string& name, const Rect& r,
                  bool chosen) {
  const Palette& c = ui.palette;
  const Press p = press(ui, name, r);
  if (chosen) ui.rects["chosen row"] = r;
  if (p.hovered || chosen) filled(r, chosen ? c.first : c.hovered, 5);
  const auto score = row.lesson ? settings.scores.find(row.lesson->id) : settings.scores.end();
  const bool marked = score != settings.scores.end() && (score->second.finished || !score->second.answers.empty());
  const float marks = marked ? 134.0f : 0.0f;
  const std::string words = row.lesson ? plain(row.lesson->title) : name.substr(std::string("saved ").size());
  text(ui.fonts.body, r.left + 8, r.middle_y(), packed(chosen ? c.on_first : c.text),
       fitted(ui.fonts.body, words, r.width() - 16 - marks));
  if (marked) draw_score(ui, score->second, row.lesson->id, r.right - 8, r.middle_y(), chosen);
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
  const Paragraph words{.markup = l.summary, .width = room, .line_pitch = 20, .colour = c.text};
  const float end = r.top + 28 + rich(ui, words, {left, r.top + 24}).y;
  const Paragraph others{.markup = near, .width = room, .line_pitch = 20, .colour = c.muted};
  if (end + ui.texts.size_of(others).y < r.bottom - 22) rich(ui, others, {left, end});
  const std::string keys = "↓ and ↑ choose, Enter opens, Escape closes";
  const bool roomy = text_width(ui.fonts.body, keys + legend) < room - beside_progress;
  text(ui.fonts.body, left, r.bottom - 10, packed(c.muted), roomy ? keys + legend : keys);
}

/// Returns the heading that begins the second column, so that the longer one is as short as possible; null: none.
const PickerRow* second_column(const std::vector<PickerRow>& rows) {
  float total = 0, before = 0;
  for (const PickerRow& row : rows) total += height_of(row);
  const PickerRow* best = nullptr;
  float least = total;
  for (const PickerRow& row : rows) {
    if (const float longer = std::max(before, total - before); !row.heading.empty() && longer < least)
      least = longer, best = &row;
    before += height_of(row);
  }
  return best;
}

/// Draws the rows in as many columns as there is room for, of about equal length.
Touched columns(Ui& ui, const Shelf& shelf, const PickerRow* chosen, const std::vector<PickerRow>& rows, ImVec2 at,
                float width) {
  const int count = width >= 660 ? 2 : 1;
  const float wide = (width - gutter * static_cast<float>(count - 1)) / static_cast<float>(count);
  const PickerRow* const second = count > 1 ? second_column(rows) : nullptr;
  float x = at.x, y = at.y + 8, end = y;
  Touched touched;
  for (const PickerRow& row : rows) {
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
    y += height_of(row);
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
  const std::vector<PickerRow> rows = rows_of(picker, shelf, player.lesson());

  const float below_rows = window.height() < 700 ? 86 : picture_height;
  ImGui::BeginChild("lessons", {0, ImGui::GetContentRegionAvail().y - below_rows - 18});
  const PickerRow* const chosen = chosen_row(rows, picker, shelf, player.lesson(), ui.focus.name());
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
