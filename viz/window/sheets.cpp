#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "viz/formats.h"
#include "viz/rich_text.h"
#include "viz/window/key_codes.h"
#include "viz/window/panels.h"

namespace isect::viz {
namespace {

/// A key pressed in an open sheet; the press that opened it does not count.
bool key_down(key::Code code) { return ImGui::IsKeyPressed(code, false) && !ImGui::IsWindowAppearing(); }

/// Opens in the middle of the window; Escape or a click beside it closes it. True while it is open.
bool begin_sheet(Session& s, const char* name, const Rect& window, float width, float height) {
  const float w = std::min(width, window.width() - 40), h = std::min(height, window.height() - 40);
  const Rect r{window.middle_x() - w / 2, window.middle_y() - h / 2, window.middle_x() + w / 2,
               window.middle_y() + h / 2};
  ImGui::SetNextWindowPos(top_left(r));
  ImGui::SetNextWindowSize({w, h});
  if (!ImGui::BeginPopup(name)) return false;
  s.ui.rects[name] = r;
  if (key_down(key::escape)) ImGui::CloseCurrentPopup();
  return true;
}

void key_sheet(Session& s, const Rect& window) {
  struct Row {
    const char *input, *action;
  };
  constexpr Row rows[] = {
      {"← / →", "step back / on"},
      {"Home / End", "first / last step"},
      {"Space", "play / pause"},
      {"1 … 9", "presets"},
      {"A, B, C …", "answer the question"},
      {"[ and ]", "lesson before / after"},
      {"Ctrl+O", "all lessons"},
      {"R", "restart the preset"},
      {"E", "see the published line fail"},
      {"P / O", "perspective / orthographic"},
      {"drag a handle", "move the object"},
      {"drag on a map", "move the setting to another case"},
      {"drag, right-drag", "orbit, pan"},
      {"wheel", "zoom at the pointer"},
      {"double click", "frame all"},
      {"Ctrl+click a number", "type it"},
      {"Ctrl+C / Ctrl+V", "copy / paste the whole state"},
      {"Ctrl+Z", "take the last change back"},
      {"S or F12", "save this figure"},
      {"Tab", "hide / show the panels"},
      {"F1 or ?", "this sheet"},
      {"Ctrl+Q", "leave"},
  };
  constexpr float count = static_cast<float>(std::size(rows));
  const float row = std::min(26.0f, std::floor((window.height() - 140) / count));
  if (!begin_sheet(s, "key sheet", window, 480, 100 + row * count)) return;
  if (key_down(key::f1)) ImGui::CloseCurrentPopup();
  const Palette& c = s.ui.palette;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  text(s.ui.fonts.heading, at.x, at.y + 10, packed(c.text), "Keys");
  float y = at.y + 46;
  for (const Row& r : rows) {
    text(s.ui.fonts.body, at.x, y, packed(c.first), r.input);
    text(s.ui.fonts.body, at.x + 190, y, packed(c.text), r.action);
    y += row;
  }
  ImGui::SetCursorScreenPos({at.x, at.y});
  ImGui::Dummy({1, y - at.y});
  ImGui::EndPopup();
}

/// The two objects that a lesson's name joins: "ray-sphere" is ray and sphere.
std::optional<std::pair<std::string, std::string>> objects_of(const Lesson& lesson) {
  const std::size_t dash = lesson.id.find('-');
  if (dash == std::string::npos || lesson.id.find('-', dash + 1) != std::string::npos) return std::nullopt;
  return std::pair{lesson.id.substr(0, dash), lesson.id.substr(dash + 1)};
}

std::string lower(std::string s) {
  std::transform(s.begin(), s.end(), s.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return s;
}

/// Each word that is wanted, or another name for the same thing, stands in what the lesson says of itself.
bool matches(const Lesson& lesson, const std::string& wanted) {
  static const std::map<std::string, std::vector<std::string>> others = {
      {"box", {"aabb", "obb"}},  {"cube", {"box", "aabb"}}, {"ball", {"sphere"}},     {"circle", {"sphere"}},
      {"bvh", {"hierarchy"}},    {"tree", {"hierarchy"}},   {"camera", {"frustum"}},  {"view", {"culling", "picking"}},
      {"mouse", {"picking"}},    {"hull", {"convex"}},      {"inside", {"polygon"}},  {"rounding", {"robust"}},
      {"cylinder", {"capsule"}}, {"line", {"ray"}},         {"moving", {"collision"}}};
  const std::string all = lower(lesson.id + " " + plain(lesson.title) + " " + lesson.summary);
  const auto stands = [&](const std::string& word) { return all.find(word) != std::string::npos; };
  std::istringstream words(lower(wanted));
  for (std::string word; words >> word;) {
    const auto found = others.find(word);
    if (!stands(word) && (found == others.end() || std::ranges::none_of(found->second, stands))) return false;
  }
  return true;
}

/// First objects down, second objects across, a dot where a lesson joins them. Returns the lesson that was
/// pressed.
const Lesson* object_grid(Session& s, const std::vector<const Lesson*>& lessons, float x, float& y, float width) {
  std::set<std::string> down, across;
  for (const Lesson* l : lessons)
    if (const auto pair = objects_of(*l)) down.insert(pair->first), across.insert(pair->second);
  if (down.empty()) return nullptr;
  Ui& ui = s.ui;
  const Palette& c = ui.palette;
  const float names = 110, cell = std::min(110.0f, (width - names) / static_cast<float>(across.size()));
  float cx = x + names;
  for (const std::string& name : across) {
    text(ui.fonts.small, cx + cell / 2, y + 8, packed(c.muted), name, 0.5f);
    cx += cell;
  }
  y += 22;
  const Lesson* pressed = nullptr;
  for (const std::string& first : down) {
    text(ui.fonts.small, x, y + 16, packed(c.muted), first);
    cx = x + names;
    for (const std::string& second : across) {
      const Rect r{cx + 2, y + 2, cx + cell - 2, y + 30};
      const auto found = std::find_if(lessons.begin(), lessons.end(), [&](const Lesson* l) {
        return objects_of(*l) == std::pair{first, second};
      });
      if (found == lessons.end())
        filled(r, c.card, 5);
      else if (chip(ui, "pair " + (*found)->id, r, "●", *found == &s.player.lesson(), ui.fonts.small))
        pressed = *found;
      cx += cell;
    }
    y += 32;
  }
  y += 12;
  return pressed;
}

const Lesson* lesson_rows(Session& s, const std::vector<const Lesson*>& lessons, float x, float& y, float width) {
  Ui& ui = s.ui;
  const Palette& c = ui.palette;
  const Lesson* pressed = nullptr;
  for (const Lesson* l : lessons) {
    const Rect r{x, y, x + width, y + 52};
    const Press p = press(ui, "lesson " + l->id, r);
    filled(r, p.hovered ? c.hovered : c.card, 6);
    if (l == &s.player.lesson()) outlined(r, c.first);
    text(ui.fonts.bold, x + 12, y + 17, packed(c.text), plain(l->title));
    if (!l->after.empty()) {
      std::string after;
      for (const std::string& id : l->after) after += (after.empty() ? "after " : ", ") + id;
      const float room = width - 40 - text_width(ui.fonts.bold, plain(l->title));
      if (text_width(ui.fonts.small, after) <= room)
        text(ui.fonts.small, r.right - 12, y + 17, packed(c.muted), after, 1);
    }
    ImGui::PushClipRect(top_left(r), {r.right - 12, r.bottom}, true);
    text(ui.fonts.small, x + 12, y + 37, packed(c.muted), plain(l->summary));
    ImGui::PopClipRect();
    if (p.clicked) pressed = l;
    y += 58;
  }
  if (lessons.empty()) text(ui.fonts.body, x, y + 16, packed(c.muted), "No lesson has these words");
  return pressed;
}

void picker(Session& s, const Rect& window) {
  if (!begin_sheet(s, "picker", window, 620, 480)) return;
  std::string& wanted = s.search;
  if (ImGui::IsWindowAppearing()) {
    wanted.clear();
    ImGui::SetKeyboardFocusHere();
  }
  ImGui::SetNextItemWidth(-1);
  const bool entered =
      ImGui::InputTextWithHint("##search", "Search lessons", &wanted, ImGuiInputTextFlags_EnterReturnsTrue);
  s.ui.rects["search"] = {ImGui::GetItemRectMin().x, ImGui::GetItemRectMin().y, ImGui::GetItemRectMax().x,
                          ImGui::GetItemRectMax().y};
  std::vector<const Lesson*> found;
  for (const Lesson* l : s.player.lessons())
    if (matches(*l, wanted)) found.push_back(l);

  ImGui::BeginChild("lessons");
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x - 4;
  float y = at.y + 8;
  const Lesson* chosen = object_grid(s, found, at.x, y, width);
  if (const Lesson* row = lesson_rows(s, found, at.x, y, width)) chosen = row;
  if (entered && !found.empty()) chosen = found.front();
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy({1, y - at.y});
  ImGui::EndChild();
  if (chosen) {
    s.attempt([&] { s.player.open(*chosen); });
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

void save_sheet(Session& s, const Rect& window) {
  if (!begin_sheet(s, "save sheet", window, 380, 236)) return;
  Ui& ui = s.ui;
  const Palette& c = ui.palette;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  float x = at.x, y = at.y + 10;
  text(ui.fonts.heading, x, y, packed(c.text), "Save this figure");
  y += 46;
  text(ui.fonts.body, x, y, packed(c.muted), "Format");
  for (const std::string& format : still_format_names()) {
    if (chip(ui, "format " + format, {x + 80, y - 15, x + 140, y + 15}, format, s.settings.save_format == format))
      s.settings.save_format = format;
    x += 66;
  }
  x = at.x, y += 42;
  text(ui.fonts.body, x, y, packed(c.muted), "Theme");
  for (const std::string& name : theme_names()) {
    const float width = text_width(ui.fonts.body, name) + 20;
    if (chip(ui, "save theme " + name, {x + 80, y - 15, x + 80 + width, y + 15}, name,
             s.settings.save_theme == theme_named(name)))
      s.settings.save_theme = theme_named(name);
    x += width + 6;
  }
  x = at.x, y += 56;
  const bool again = ImGui::GetIO().InputQueueCharacters.contains('s') && !ImGui::IsWindowAppearing();
  const bool enter = key_down(key::enter) || key_down(key::keypad_enter) || key_down(key::f12) || again;
  if (chip(ui, "save", {x, y - 18, x + 110, y + 18}, "Save", true) || enter) {
    s.save_now = true;
    ImGui::CloseCurrentPopup();
  }
  text(ui.fonts.small, x + 126, y, packed(c.muted), "Enter saves, Esc closes");
  ImGui::EndPopup();
}

}  // namespace

void sheets(Session& s, const Rect& window) {
  const Sheet open = std::exchange(s.open_next, Sheet::none);
  if (open == Sheet::keys) ImGui::OpenPopup("key sheet");
  if (open == Sheet::picker) ImGui::OpenPopup("picker");
  if (open == Sheet::save) ImGui::OpenPopup("save sheet");
  key_sheet(s, window);
  picker(s, window);
  save_sheet(s, window);
}

}  // namespace isect::viz
