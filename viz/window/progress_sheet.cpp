// The whole course on one page: how far each lesson was read, and what came of its questions, exercises and reviews.

#include <algorithm>

#include "viz/text/rich_text.h"
#include "viz/walk/closing.h"
#include "viz/window/panels.h"
#include "viz/window/progress.h"
#include "viz/window/sheets.h"

namespace isect::viz {
namespace {

constexpr float progress_row = 23, progress_head = 22, progress_gutter = 28;

std::string share_of(int part, int whole) { return std::to_string(part) + " of " + std::to_string(whole); }

/// Where the numbers of a row end, from the left: seen, right, exercises.
struct Ends {
  float seen, right, solved;
};
Ends ends_in(const Rect& r) { return {r.right - 174, r.right - 92, r.right - 8}; }

/// Draws the names of the columns.
void progress_names(const Ui& ui, const Rect& r) {
  const ImU32 ink = packed(ui.palette.muted);
  const Ends at = ends_in(r);
  text(ui.fonts.body, at.seen, r.middle_y(), ink, "steps seen", 1);
  text(ui.fonts.body, at.right, r.middle_y(), ink, "right", 1);
  text(ui.fonts.body, at.solved, r.middle_y(), ink, "exercises", 1);
}

/// Draws a lesson's row. Returns whether it was pressed.
bool progress_line(Ui& ui, const LessonProgress& p, const Rect& r, bool now) {
  const Palette& c = ui.palette;
  const Press pressed = press(ui, "progress " + p.lesson->id, r);
  if (pressed.hovered || now) filled(r, pressed.hovered ? c.hovered : c.card, 4);
  const Ends at = ends_in(r);
  const bool begun = p.of > 0 || p.finished || p.answered > 0;
  if (p.finished) tick(r.left + 12, r.middle_y(), 12, packed(c.hit));
  const float left = r.left + 24;
  text(ui.fonts.body, left, r.middle_y(), packed(begun ? c.text : c.muted),
       fitted(ui.fonts.body, plain(short_title(*p.lesson)), at.seen - 76 - left));
  const ImU32 ink = packed(c.text);
  if (p.of > 0) text(ui.fonts.body, at.seen, r.middle_y(), ink, share_of(p.seen, p.of), 1);
  if (p.answered > 0) text(ui.fonts.body, at.right, r.middle_y(), ink, share_of(p.right, p.answered), 1);
  if (p.exercises > 0)
    text(ui.fonts.body, at.solved, r.middle_y(), packed(p.solved > 0 ? c.text : c.muted),
         share_of(p.solved, p.exercises), 1);
  return pressed.clicked;
}

/// Draws the row of a review, below its lessons. Returns whether it was pressed.
bool progress_review(Ui& ui, const Settings& settings, int number, const Rect& r) {
  const Palette& c = ui.palette;
  const std::string name = "Review " + std::to_string(number);
  const Press p = press(ui, "progress review " + std::to_string(number), r);
  if (p.hovered) filled(r, c.hovered, 4);
  const auto kept = settings.record.reviews.find(number);
  const bool taken = kept != settings.record.reviews.end();
  text(ui.fonts.bold, r.left + 24, r.middle_y(), packed(taken ? c.text : c.muted), name);
  text(ui.fonts.body, ends_in(r).right, r.middle_y(), packed(taken ? c.text : c.muted),
       taken ? share_of(kept->second.right, kept->second.of) : std::string("not taken"), 1);
  return p.clicked;
}

/// Returns "12 of 30 lessons read to the end · 45 of 60 answers right · 3 questions skipped · 8 of 61 exercises
/// solved".
std::string sum_of_progress(const std::vector<LessonProgress>& all) {
  LessonProgress sum;
  int finished = 0;
  for (const LessonProgress& p : all) {
    finished += p.finished;
    sum.right += p.right, sum.answered += p.answered, sum.skipped += p.skipped;
    sum.solved += p.solved, sum.exercises += p.exercises;
  }
  std::string words = share_of(finished, static_cast<int>(all.size())) + " lessons read to the end · " +
                      share_of(sum.right, sum.answered) + " answers right · ";
  if (sum.skipped > 0)
    words += std::to_string(sum.skipped) + (sum.skipped == 1 ? " question" : " questions") + " skipped · ";
  return words + share_of(sum.solved, sum.exercises) + " exercises solved";
}

/// What was pressed in the list: a lesson, or a review by its number.
struct PressedProgress {
  const Lesson* lesson = nullptr;
  int review = 0;
};

/// Draws all lessons, five and their review below each other, in two columns if there is room.
PressedProgress progress_list(Ui& ui, const Player& player, const Settings& settings,
                              const std::vector<LessonProgress>& all, const ImVec2& at, float width) {
  const int columns = width >= 760 ? 2 : 1, reviews = review_count(player.lessons());
  const int groups = (static_cast<int>(all.size()) + lessons_a_review - 1) / lessons_a_review;
  const float wide = (width - progress_gutter * static_cast<float>(columns - 1)) / static_cast<float>(columns);
  float x = at.x, y = at.y, end = y;
  PressedProgress pressed;
  for (int i = 0; i < static_cast<int>(all.size()); ++i) {
    const int group = i / lessons_a_review;
    const bool second = columns == 2 && i > 0 && i == (groups + 1) / 2 * lessons_a_review;
    if (second) x += wide + progress_gutter, y = at.y;
    if (i == 0 || second) {
      progress_names(ui, {x, y, x + wide, y + progress_head});
      y += progress_head;
    }
    const LessonProgress& p = all[static_cast<std::size_t>(i)];
    if (progress_line(ui, p, {x, y, x + wide, y + progress_row - 1}, p.lesson == &player.lesson()))
      pressed.lesson = p.lesson;
    y += progress_row;
    const bool last_of_group = (i + 1) % lessons_a_review == 0 || i + 1 == static_cast<int>(all.size());
    if (!last_of_group) continue;
    if (group < reviews) {
      if (progress_review(ui, settings, group + 1, {x, y, x + wide, y + progress_row - 1})) pressed.review = group + 1;
      y += progress_row;
    }
    y += 6;
    end = std::max(end, y);
  }
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy({1, end - at.y});
  return pressed;
}

}  // namespace

void progress_sheet(WindowSession& s, const Rect& window) {
  if (!begin_sheet(s.ui, "progress sheet", window, 1080, 640)) return;
  Ui& ui = s.ui;
  const std::vector<LessonProgress> all = progress_of(s.player.lessons(), s.settings);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetContentRegionAvail().y;
  text(ui.fonts.heading, at.x, at.y + 10, packed(ui.palette.text), "Progress");
  const Paragraph sum{.markup = sum_of_progress(all), .width = width, .line_pitch = 21, .colour = ui.palette.muted};
  const float top = at.y + 30 + rich(ui, sum, {at.x, at.y + 28}).y + 8;

  constexpr float foot = 44;
  ImGui::SetCursorScreenPos({at.x, top});
  ImGui::BeginChild("progress of all", {width, at.y + height - foot - top});
  const PressedProgress pressed =
      progress_list(ui, s.player, s.settings, all, ImGui::GetCursorScreenPos(), ImGui::GetContentRegionAvail().x - 4);
  ImGui::EndChild();

  const float y = at.y + height - 18;
  const bool saved = chip(ui, "save progress", {at.x, y - 17, at.x + 150, y + 17}, "Save as JSON", false);
  text(ui.fonts.body, at.x + 166, y, packed(ui.palette.muted), "Enter opens a lesson or a review, Escape closes");
  if (saved) s.requests.save_progress = true;
  if (pressed.lesson) attempt(s.toast, [&] { s.player.open(*pressed.lesson); });
  if (pressed.review > 0) s.requests.review = pressed.review;
  if (saved || pressed.lesson || pressed.review > 0) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace isect::viz
