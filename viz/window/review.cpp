// Reviews: questions of several lessons one after the other, each as its lesson asks it, and what came of them.

#include "viz/walk/review.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "viz/text/rich_text.h"
#include "viz/walk/closing.h"
#include "viz/window/column.h"
#include "viz/window/panels.h"
#include "viz/window/sheets.h"

namespace isect::viz {
namespace {

std::string review_title(int number) { return "Review " + std::to_string(number); }

std::string right_of(int right, std::size_t of) {
  return std::to_string(right) + " of " + std::to_string(of) + " right";
}

std::string title_of_lesson(const Player& player, const std::string& id) {
  return plain(short_title(lesson_named(player.lessons(), id)));
}

/// Asks the question whose turn it is.
void ask_now(WindowSession& s) {
  Reviewing& review = *s.review;
  const ReviewPrompt& prompt = review.prompts[review.results.size()];
  ReaderState to;
  to.lesson = prompt.lesson, to.preset = prompt.preset, to.step = prompt.step - 1;
  attempt(s.toast, [&] {
    s.player.go(to);
    s.player.ask_again(prompt.step);
  });
  review.answers_before = s.player.answers_given();
  review.result.reset();
}

/// Leaves the review for the step that a question of it was about.
void go_to_prompt(WindowSession& s, const ReviewPrompt& prompt) {
  ReaderState to;
  to.lesson = prompt.lesson, to.preset = prompt.preset, to.step = prompt.step;
  leave_review(s);
  attempt(s.toast, [&] { s.player.go(to); });
}

/// Draws the questions that were not answered right, each with a button that leads to its step. Returns the one that
/// was pressed; null: none.
const ReviewPrompt* not_right(Column& c, const Player& player, const Reviewing& review) {
  const ReviewPrompt* pressed = nullptr;
  const Palette& ink = c.ui.palette;
  for (std::size_t i = 0; i < review.prompts.size(); ++i) {
    const ReviewPrompt& prompt = review.prompts[i];
    if (review.results[i] == true) continue;
    c.y += 16;
    c.paragraph(prompt.asks, ink.text);
    c.paragraph(review.results[i] ? "Not right. It returns first." : "Skipped.", ink.muted, body_size, 21);
    c.y += 6;
    float x = c.x;
    const std::string where = title_of_lesson(player, prompt.lesson) + ", step " + std::to_string(prompt.step + 1);
    if (c.button("to step " + std::to_string(i + 1), where, x)) pressed = &prompt;
    c.y += Column::button_height;
  }
  return pressed;
}

/// Returns the titles of a review's lessons: "Relations, Points, Intervals".
std::string titles_of(const std::vector<const Lesson*>& lessons) {
  std::string titles;
  for (const Lesson* lesson : lessons) titles += (titles.empty() ? "" : ", ") + plain(short_title(*lesson));
  return titles;
}

}  // namespace

void begin_review(WindowSession& s, int number) {
  leave_review(s);
  const AnswerRecord& record = s.settings.record;
  const std::vector<ReviewPrompt> all = prompts_of_review(s.player.lessons(), number, record);
  Reviewing review{.number = number, .before = s.player, .beside = s.settings.beside};
  for (const int i : draw_review(all, record, static_cast<std::uint32_t>(record.answers)))
    review.prompts.push_back(all[static_cast<std::size_t>(i)]);
  if (review.prompts.empty()) return s.toast.say("These lessons ask nothing");
  s.review.emplace(std::move(review));
  s.step_words.before_fault.reset();  // nothing in a review leads away from it
  ask_now(s);
}

void leave_review(WindowSession& s) {
  if (!s.review) return;
  keep_score(s.player, s.settings, s.answers_kept);
  s.settings.beside = s.review->beside;
  s.player.return_as(std::move(s.review->before));
  s.review.reset();
}

void next_in_review(WindowSession& s) {
  follow_review(s);
  if (!s.review || s.review->over()) return;
  keep_score(s.player, s.settings, s.answers_kept);
  Reviewing& review = *s.review;
  review.results.push_back(review.result);
  review.result.reset();
  if (!review.over()) return ask_now(s);
  s.settings.record.reviews[review.number] = {review.right(), static_cast<int>(review.prompts.size())};
}

void follow_review(WindowSession& s) {
  if (!s.review || s.review->over() || s.review->result) return;
  const Quiz& quiz = s.player.quiz();
  if (s.player.answers_given() != s.review->answers_before && quiz.answered())
    s.review->result = quiz.answered()->right();
  else if (!quiz.asked())
    ask_now(s);
}

void review_bars(WindowSession& s, const Rect& top, const Rect& bottom) {
  Ui& ui = s.ui;
  const Palette& c = ui.palette;
  const Reviewing& review = *s.review;
  begin_region(ui, "top bar", top);
  logo(ui, 30, 24);
  const float end = 54 + text(ui.fonts.heading, 54, 24, packed(c.text), review_title(review.number));
  const Rect leave{top.right - 140, 9, top.right - 20, 39};
  if (!review.over()) {
    const ReviewPrompt& prompt = review.prompts[review.results.size()];
    const std::string where = "Question " + std::to_string(review.results.size() + 1) + " of " +
                              std::to_string(review.prompts.size()) + "  ·  " +
                              title_of_lesson(s.player, prompt.lesson);
    text(ui.fonts.body, end + 24, 24, packed(c.muted), fitted(ui.fonts.body, where, leave.left - end - 48));
    ui.rects["review question"] = {end + 24, 9, leave.left - 24, 39};
  }
  const bool left = chip(ui, "leave review", leave, "Leave (Esc)", false);
  rule(ui, top.left, top.right, top.bottom - 1);
  ImGui::End();

  begin_region(ui, "transport", bottom);
  rule(ui, bottom.left, bottom.right, bottom.top);
  bool next = false;
  if (!review.over()) {
    const int right = review.right() + (review.result == true);
    const std::size_t done = review.results.size() + (review.result ? 1 : 0);
    text(ui.fonts.body, 24, bottom.middle_y(), packed(c.text), right_of(right, done));
    const Rect r{bottom.middle_x() - 70, bottom.middle_y() - 18, bottom.middle_x() + 70, bottom.middle_y() + 18};
    next = chip(ui, "next in review", r, review.result ? "Next  →" : "Skip  →", review.result.has_value());
  }
  ImGui::End();
  if (left) return leave_review(s);
  if (next) next_in_review(s);
}

void review_score(WindowSession& s, const Rect& r) {
  Ui& ui = s.ui;
  const Palette& ink = ui.palette;
  const Reviewing& review = *s.review;
  const ReviewPrompt* pressed = nullptr;
  bool again = false, leave = false;
  begin_region(ui, "review score", r);
  scrolling(ui, "review results", r, [&] {
    const float width = std::min(640.0f, r.width() - 40), x = std::round(r.middle_x() - width / 2);
    Column c{ui, x, ImGui::GetCursorScreenPos().y + 28, width};
    c.paragraph(right_of(review.right(), review.prompts.size()), ink.text, 19, 26, true);
    c.y += 4;
    c.paragraph(review.right() == static_cast<int>(review.prompts.size())
                    ? "The next review of these lessons asks what was asked longest ago."
                    : "What was wrong returns first in the next review of these lessons.",
                ink.muted);
    pressed = not_right(c, s.player, review);
    c.y += 24;
    float from = c.x;
    again = c.button("review again", "Eight more", from);
    leave = c.button("end review", "Back to where I was", from);
    c.y += Column::button_height + 24;
    ImGui::SetCursorScreenPos({r.left, c.y});
    ImGui::Dummy({1, 1});
  });
  ui.rects["review results"] = r;
  ImGui::End();
  if (pressed) return go_to_prompt(s, ReviewPrompt(*pressed));
  if (again) return begin_review(s, review.number);
  if (leave) leave_review(s);
}

void review_offer(Column& c, const Player& player, Requests& requests) {
  const int number = review_after(player.lessons(), player.lesson());
  if (number == 0) return;
  c.y += 24;
  c.paragraph(review_title(number), c.ui.palette.text, true);
  c.y += 6;
  c.paragraph("Eight questions from these lessons: " + titles_of(lessons_of_review(player.lessons(), number)) + ".",
              c.ui.palette.muted);
  c.y += 6;
  float x = c.x;
  if (c.button("take review " + std::to_string(number), "Begin", x)) requests.review = number;
  c.y += Column::button_height + 4;
}

void reviews_sheet(WindowSession& s, const Rect& window) {
  constexpr float row = 56, head = 46;
  const int count = review_count(s.player.lessons());
  if (!begin_sheet(s.ui, "reviews", window, 720, 40 + head + row * static_cast<float>(count))) return;
  Ui& ui = s.ui;
  const Palette& c = ui.palette;
  ImGui::BeginChild("list of reviews");
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float right = at.x + ImGui::GetContentRegionAvail().x - 4;
  text(ui.fonts.heading, at.x + 8, at.y + 14, packed(c.text), "Reviews");
  float y = at.y + head;
  for (int number = 1; number <= count; ++number, y += row) {
    const Rect r{at.x, y, right, y + row - 4};
    const Press p = press(ui, "review " + std::to_string(number), r);
    if (p.hovered) filled(r, c.card, 5);
    text(ui.fonts.bold, r.left + 8, y + 16, packed(c.text), review_title(number));
    const auto kept = s.settings.record.reviews.find(number);
    if (kept != s.settings.record.reviews.end())
      text(ui.fonts.body, r.right - 8, y + 16, packed(c.muted),
           right_of(kept->second.right, static_cast<std::size_t>(kept->second.of)), 1);
    text(ui.fonts.body, r.left + 8, y + 36, packed(c.muted),
         fitted(ui.fonts.body, titles_of(lessons_of_review(s.player.lessons(), number)), r.width() - 16));
    if (!p.clicked) continue;
    s.requests.review = number;
    ImGui::CloseCurrentPopup();
  }
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy({1, y - at.y});
  ImGui::EndChild();
  ImGui::EndPopup();
}

}  // namespace isect::viz
