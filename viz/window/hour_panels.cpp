// What is shown of a playlist: where the reader is in it, a stop's note, all stops, and a stop that can't be opened.

#include <algorithm>
#include <cmath>
#include <utility>

#include "viz/text/rich_text.h"
#include "viz/window/column.h"
#include "viz/window/panels.h"
#include "viz/window/sheets.h"

namespace isect::viz {
namespace {

constexpr float stop_row = 46;

/// Returns how a stop's lesson calls the method of its setting; empty if it has only one.
std::string method_of(const Stop& stop, const Player& player) {
  const Lesson& lesson = *stop.lesson;
  if (lesson.group_by.empty() || !stop.state.parameters) return {};
  const auto chosen = stop.state.parameters->find(lesson.group_by);
  if (chosen == stop.state.parameters->end()) return {};
  const std::string& choice = std::get<std::string>(chosen->second);
  if (&lesson == &player.lesson())
    for (const Method& method : player.played().methods())
      if (method.choice == choice) return plain(method.title);
  return choice;
}

/// Returns "Ray and sphere (Haines): tangent", without the preset while it may answer a question of this lesson that is
/// open or ahead.
std::string title_of(const Stop& stop, const WindowSession& s) {
  if (!stop.lesson) return stop.name.empty() ? "A stop" : stop.name;
  std::string title = plain(stop.lesson->title);
  if (!stop.lesson->made_from.empty()) return title;
  if (const std::string method = method_of(stop, s.player); !method.empty()) title += " (" + method + ")";
  if (!names_presets(s) && stop.lesson == &s.player.lesson()) return title;
  const auto named = std::ranges::find(stop.lesson->presets, stop.name, &Preset::id);
  if (named != stop.lesson->presets.end()) return title + ": " + plain(named->title);
  return title + ": " + (stop.name.empty() ? "a setting of its own" : stop.name);
}

/// Draws a stop's row; that of the stop whose turn it is looks chosen. Returns whether it was pressed.
bool row_of_stop(WindowSession& s, int i, const Rect& r) {
  Ui& ui = s.ui;
  const Palette& c = ui.palette;
  const Stop& stop = s.hour->stop(i);
  const std::string name = "stop " + std::to_string(i + 1);
  const bool now = i == s.hour->at();
  if (now) ui.focus.begin_at(name);
  const Press p = press(ui, name, r);
  if (p.hovered || now) filled(r, now ? c.card : c.hovered, 5);
  if (now) filled({r.left, r.top + 4, r.left + 4, r.bottom - 4}, c.first, 2);
  const float left = r.left + 52, room = r.right - 8 - left;
  text(ui.fonts.bold, left - 12, r.top + 14, packed(c.muted), std::to_string(i + 1), 1);
  text(ui.fonts.body, left, r.top + 14, packed(stop.fault.empty() ? c.text : c.miss),
       fitted(ui.fonts.body, title_of(stop, s), room));
  std::string below = steps_in_words(stop);
  if (!stop.note.empty()) below += (below.empty() ? "" : " · ") + plain(stop.note);
  if (!stop.fault.empty()) below = "can't be opened: " + stop.fault;
  text(ui.fonts.body, left, r.top + 33, packed(c.muted), fitted(ui.fonts.body, below, room));
  return p.clicked;
}

/// Takes the digits that are typed: the stop's number. Returns the stop, from 0, if no longer number begins so; else
/// that stop's row is held, and Enter opens it. -1: none.
int typed_stop(WindowSession& s) {
  for (const ImWchar c : ImGui::GetIO().InputQueueCharacters) {
    if (c < '0' || c > '9') continue;
    const int digit = static_cast<int>(c - '0'), count = s.hour->count();
    int& number = s.typed_stop;
    number = 10 * number + digit;
    if (number > count) number = digit;  // it begins another one
    if (number < 1 || number > count) number = 0;
    if (number == 0) continue;
    if (10 * number > count) return std::exchange(number, 0) - 1;
    s.ui.focus.take("stop " + std::to_string(number));
  }
  return -1;
}

}  // namespace

float hour_badge(WindowSession& s, float x, float y) {
  const Hour& hour = *s.hour;
  ImFont* const font = s.ui.fonts.heading;
  const bool away = hour.away(s.player);
  const Rect r{x, y - 16, x + text_width(font, hour.told()) + 20, y + 16};
  if (chip(s.ui, "stops", r, hour.told(), !away, font)) s.requests.sheet = Sheet::stops;
  if (ImGui::IsItemHovered())
    tooltip(s.ui, away ? "Page Down returns to this stop; I lists all" : "The stops of this playlist (I)");
  return r.right;
}

void hour_note(Column& c, const std::string& note) {
  if (note.empty()) return;
  const float top = c.y;
  c.paragraph(note, c.ui.palette.muted);
  c.ui.rects["note"] = {c.x, top, c.x + c.width, c.y};
  c.y += 10;
}

bool shows_fault(const WindowSession& s) { return s.hour && !s.review && s.hour->faulty(s.player); }

void stop_fault(WindowSession& s, const Rect& r) {
  Ui& ui = s.ui;
  const Hour& hour = *s.hour;
  bool past = false, back = false;
  begin_region(ui, "stop fault", r);
  scrolling(ui, "fault of stop", r, [&] {
    const float width = std::min(720.0f, r.width() - 40), x = std::round(r.middle_x() - width / 2);
    Column c{ui, x, ImGui::GetCursorScreenPos().y + 40, width};
    c.paragraph("Stop " + hour.told() + " can't be opened", ui.palette.text, 21, 28, true);
    c.y += 6;
    c.paragraph(as_markup(hour.stop().fault), ui.palette.muted);
    c.y += 24;
    float from = c.x;
    if (hour.at() + 1 < hour.count()) past = c.button("go past stop", "Go past it  →", from);
    if (hour.at() > 0) back = c.button("back from stop", "←  Back", from);
    c.y += Column::button_height + 16;
    ImGui::SetCursorScreenPos({r.left, c.y});
    ImGui::Dummy({1, 1});
  });
  ui.rects["fault of stop"] = r;
  ImGui::End();
  if (past) return go_on(s);
  if (back) go_back(s);
}

void stops_sheet(WindowSession& s, const Rect& window) {
  constexpr float head = 46;
  const int count = s.hour->count();
  if (!begin_sheet(s.ui, "list of stops", window, 720, 40 + head + stop_row * static_cast<float>(count))) return;
  Ui& ui = s.ui;
  const Palette& c = ui.palette;
  const ImVec2 top = ImGui::GetCursorScreenPos();
  const std::string title = plain(s.hour->list().title);
  text(ui.fonts.heading, top.x + 8, top.y + 12, packed(c.text),
       fitted(ui.fonts.heading, title.empty() ? "Playlist" : title, ImGui::GetContentRegionAvail().x - 16));
  ImGui::SetCursorScreenPos({top.x, top.y + 34});
  const bool opened = ImGui::IsWindowAppearing();
  ImGui::BeginChild("all stops");
  if (opened) ImGui::SetScrollY(std::max(0.0f, stop_row * static_cast<float>(s.hour->at() - 2)));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float right = at.x + ImGui::GetContentRegionAvail().x - 4;
  if (opened) s.typed_stop = 0;
  int pressed = opened ? -1 : typed_stop(s);
  for (int i = 0; i < count; ++i) {
    const float y = at.y + stop_row * static_cast<float>(i);
    if (row_of_stop(s, i, {at.x, y, right, y + stop_row - 2})) pressed = i;
  }
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy({1, stop_row * static_cast<float>(count)});
  const bool past = pages_past_end() && !opened;
  ImGui::EndChild();
  if (pressed >= 0 || past) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  if (pressed >= 0) open_stop(s, pressed);
}

}  // namespace isect::viz
