#include "viz/window/widgets.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "viz/text/names.h"
#include "viz/text/utf8.h"
#include "viz/window/key_codes.h"

namespace isect::viz {
namespace {

ImDrawList& list() { return *ImGui::GetWindowDrawList(); }

void triangle(float x, float y, float way, float size, ImU32 colour) {
  const float half = size / 2;
  const ImVec2 tip{x + way * half, y}, high{x - way * half, y - half}, low{x - way * half, y + half};
  if (way > 0)
    list().AddTriangleFilled(high, tip, low, colour);
  else
    list().AddTriangleFilled(low, tip, high, colour);
}

void stop_bar(float x, float y, ImU32 colour) { list().AddRectFilled({x - 1.25f, y - 7}, {x + 1.25f, y + 7}, colour); }

void draw_icon(Icon icon, float x, float y, ImU32 colour) {
  switch (icon) {
    case Icon::first:
      stop_bar(x - 7, y, colour);
      return triangle(x + 1.5f, y, -1, 13, colour);
    case Icon::back:
      return triangle(x - 0.5f, y, -1, 13, colour);
    case Icon::play:
      return triangle(x + 1, y, 1, 17, colour);
    case Icon::pause:
      list().AddRectFilled({x - 6, y - 8}, {x - 2, y + 8}, colour, 1);
      list().AddRectFilled({x + 2, y - 8}, {x + 6, y + 8}, colour, 1);
      return;
    case Icon::next:
      return triangle(x + 0.5f, y, 1, 13, colour);
    case Icon::map:
      list().AddRect({x - 9, y - 8}, {x + 9, y + 8}, colour, 2, 0, 1.5f);
      list().AddBezierCubic({x - 3, y + 8}, {x - 2, y - 2}, {x + 3, y + 2}, {x + 5, y - 8}, colour, 1.5f);
      return list().AddCircleFilled({x - 4, y - 2}, 2.5f, colour, 12);
    case Icon::panes:
      list().AddRect({x - 10, y - 8}, {x - 1, y + 8}, colour, 2, 0, 1.5f);
      return list().AddRect({x + 1, y - 8}, {x + 10, y + 8}, colour, 2, 0, 1.5f);
    case Icon::pass:  // a question mark, and an arrow over it
      list().AddBezierCubic({x - 11, y + 1}, {x - 8, y - 11}, {x + 4, y - 11}, {x + 8, y - 3}, colour, 1.5f);
      list().AddTriangleFilled({x + 10.5f, y + 1}, {x + 4.5f, y - 1.5f}, {x + 10.5f, y - 5}, colour);
      list().PathArcTo({x - 2, y + 1}, 3, -2.8f, 1.2f, 12);
      list().PathLineTo({x - 2, y + 6});
      list().PathStroke(colour, 0, 1.5f);
      return list().AddCircleFilled({x - 2, y + 9}, 1.2f, colour, 8);
    case Icon::last:
      stop_bar(x + 7, y, colour);
      return triangle(x - 1.5f, y, 1, 13, colour);
  }
}

}  // namespace

float text_width(ImFont* font, const std::string& s) {
  return font->CalcTextSizeA(font->FontSize * font->Scale, FLT_MAX, 0, s.c_str()).x;
}

namespace {

/// Records words that reach beyond the part of the window in which they are drawn.
void tell_if_cut(const std::string& words, float left, float right) {
  CutWords* const cut = static_cast<CutWords*>(ImGui::GetIO().UserData);
  if (!cut) return;
  const ImVec2 lo = list().GetClipRectMin(), hi = list().GetClipRectMax();
  if (left < lo.x - 1 || right > hi.x + 1) cut->push_back(words);
}

/// Words over a scene belong to its picture, whose names have a size of their own.
void tell_if_small(const Paragraph& p) {
  CutWords* const cut = static_cast<CutWords*>(ImGui::GetIO().UserData);
  const bool in_picture = std::string_view(ImGui::GetCurrentWindow()->RootWindow->Name).ends_with("scene");
  if (cut && p.size < body_size && !in_picture) cut->push_back("smaller than the body: " + p.markup);
}

}  // namespace

std::string fitted(ImFont* font, const std::string& s, float room) {
  if (text_width(font, s) <= room) return s;
  std::string part = s;
  do {
    while (!part.empty() && continues_character(part.back())) part.pop_back();  // removes a whole character
    if (!part.empty()) part.pop_back();
  } while (!part.empty() && (part.back() == ' ' || text_width(font, part + "…") > room));
  return part + "…";
}

float text(ImFont* font, float x, float y, ImU32 colour, const std::string& s, float align) {
  const float size = font->FontSize * font->Scale;
  const float width = text_width(font, s);
  tell_if_cut(s, x - align * width, x + (1 - align) * width);
  list().AddText(font, size, {std::round(x - align * width), std::round(y - size / 2)}, colour, s.c_str());
  return width;
}

namespace {

/// Draws a part of a paragraph that stands in `whole` once more, in the ink that the light wants.
void draw_again(Ui& ui, const Paragraph& p, const Rect& whole, const Rect& part, double strength) {
  if (!(strength > 0)) return;
  Paragraph lit = p;
  lit.colour = ui.palette.on_highlight;
  const ImTextureID image = ui.texts.of(lit);
  const ImVec2 lo{std::max(part.left, whole.left), std::max(part.top, whole.top)};
  const ImVec2 hi{std::min(part.right, whole.right), std::min(part.bottom, whole.bottom)};
  if (!image || !(lo.x < hi.x && lo.y < hi.y)) return;
  const auto uv = [&](const ImVec2& at) {
    return ImVec2{(at.x - whole.left) / whole.width(), (at.y - whole.top) / whole.height()};
  };
  list().AddImage(image, lo, hi, uv(lo), uv(hi), packed({1, 1, 1, 1}, strength));
}

}  // namespace

ImVec2 rich(Ui& ui, const Paragraph& p, ImVec2 at) {
  if (p.markup.empty()) return {0, 0};
  const ImVec2 size = ui.texts.size_of(p);
  const ImVec2 from{std::round(at.x), std::round(at.y)}, to{from.x + size.x, from.y + size.y};
  tell_if_cut(p.markup, from.x, to.x);
  tell_if_small(p);
  const bool seen = ImGui::IsRectVisible(from, to);
  if (seen)
    if (const ImTextureID image = ui.texts.of(p)) list().AddImage(image, from, to);
  const bool near = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(from, to);
  if ((near || ui.light.on()) && !(ImGui::GetCurrentWindow()->RootWindow->Flags & ImGuiWindowFlags_Popup))
    for (const NameBox& name : ui.texts.names(p)) {
      const TextBox& b = name.box;
      const auto x = [&](double px) { return from.x + static_cast<float>(px); };
      const auto y = [&](double px) { return from.y + static_cast<float>(px); };
      const Rect r{x(b.left) - 1, y(b.top), x(b.right) + 1, y(b.bottom)};
      lights(ui, {name.key}, r);
      if (seen) draw_again(ui, p, {from.x, from.y, to.x, to.y}, r, ui.light.of(name.key));
    }
  return size;
}

void lights(Ui& ui, const std::vector<std::string>& names, const Rect& r, bool bright) {
  if (ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(top_left(r), bottom_right(r))) ui.light.point(names, r);
  light_up(ui, r, ui.light.of(names), bright);
  if (ui.light.of(names) > 0)
    for (int i = 1;; ++i)
      if (ui.rects.try_emplace("lit " + names.front() + " " + std::to_string(i), r).second) break;
}

void lights_in(Ui& ui, ImFont* font, float x, float y, const std::string& s, bool bright) {
  const float size = font->FontSize * font->Scale, half = size * 0.6f;
  for (const Name& name : names_in_line(s, ui.names)) {
    const std::string word = s.substr(name.begin, name.end - name.begin);
    const float from = std::round(x) + text_width(font, s.substr(0, name.begin));
    lights(ui, {name.key}, {from - 1, y - half, from + text_width(font, word) + 1, y + half}, bright);
    if (const double strength = ui.light.of(name.key); strength > 0)
      list().AddText(font, size, {from, std::round(y - size / 2)}, packed(ui.palette.on_highlight, strength),
                     word.c_str());
  }
}

void light_up(Ui& ui, const Rect& r, double strength, bool bright) {
  if (!(strength > 0)) return;
  const Palette& c = ui.palette;
  if (!bright) filled(r, c.highlight.with_alpha(strength), 3);
  outlined(r, (bright ? c.on_highlight : c.fresh).with_alpha(strength), 1.5f, 3);
}

void tell_sum(Ui& ui, const Rect& window) {
  if (ui.sum.empty() || (!ui.light.by_keyboard() && ui.pointer_rest > pointer_patience)) return;
  ImFont* const font = ui.fonts.body;
  const float size = font->FontSize * font->Scale, most = 420;
  const ImVec2 words = font->CalcTextSizeA(size, most, most, ui.sum.c_str());
  const Rect& at = ui.light.at();
  const float width = words.x + 20, height = words.y + 14;
  const float left =
      std::round(std::clamp(at.left, window.left + 4, std::max(window.left + 4, window.right - width - 4)));
  const float below = std::round(at.bottom + 8), above = std::round(at.top - 8 - height);
  const float top = below + height <= window.bottom - 4 ? below : above;
  const Rect r{left, top, left + width, top + height};
  ui.rects["sum"] = r;
  ImDrawList& over = *ImGui::GetForegroundDrawList();
  over.AddRectFilled(top_left(r), bottom_right(r), packed(ui.palette.window), 8);
  over.AddRect(top_left(r), bottom_right(r), packed(ui.palette.fresh), 8, 0, 1.5f);
  over.AddText(font, size, {r.left + 10, r.top + 7}, packed(ui.palette.text), ui.sum.c_str(), nullptr, most);
}

ImVec2 rich_line(Ui& ui, const Paragraph& p, float x, float y, float align) {
  if (p.markup.empty()) return {0, 0};
  const ImVec2 size = ui.texts.size_of(p);
  return rich(ui, p, {x - align * size.x, y - size.y / 2});
}

Press press(Ui& ui, const std::string& name, const Rect& r) {
  ui.rects[name] = r;
  ImGui::SetCursorScreenPos(top_left(r));
  const bool clicked = ImGui::InvisibleButton(name.c_str(), {std::max(r.width(), 1.0f), std::max(r.height(), 1.0f)});
  const Press p = {clicked, ImGui::IsItemHovered(), ImGui::IsItemActive()};
  return {(focused(ui, name, r) && ui.focus.pressed()) || p.clicked, p.hovered, p.held};
}

bool focused(Ui& ui, const std::string& name, const Rect& r) {
  ImGuiWindow* const window = ImGui::GetCurrentWindow();
  std::string root = window->RootWindow->Name;
  if (root.starts_with(ui.side)) root.erase(0, ui.side.size());
  constexpr const char* parts[] = {"top bar", "lesson panel", "lecture",    "pane heads",   "scene",
                                   "time",    "map",          "code panel", "objects panel"};
  const int part = static_cast<int>(std::find(std::begin(parts), std::end(parts), root) - std::begin(parts));
  if (!ui.focus.offer(ui.side + name, part, window->RootWindow->Flags & ImGuiWindowFlags_Popup)) return false;
  const ImRect clip = window->ClipRect;
  ui.ring = {std::max(r.left - 3, clip.Min.x), std::max(r.top - 3, clip.Min.y), std::min(r.right + 3, clip.Max.x),
             std::min(r.bottom + 3, clip.Max.y)};
  if (ui.focus.moved() && window->ScrollMax.y > 0) ImGui::SetScrollFromPosY(r.middle_y() - window->Pos.y, 0.5f);
  return true;
}

bool left_by_tab(Ui& ui, const std::string& name) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!ImGui::IsItemActive() || io.KeyCtrl || !ImGui::IsKeyPressed(key::tab, false)) return false;
  ImGui::ClearActiveID();
  ui.focus.take(name);
  ui.focus.move(io.KeyShift ? -1 : 1);
  return true;
}

void focus_ring(Ui& ui) {
  const Rect r = std::exchange(ui.ring, {});
  if (ui.focus.name().empty() || r.width() <= 0 || r.height() <= 0) return;
  ui.rects["focus ring"] = r;
  ImDrawList& over = *ImGui::GetForegroundDrawList();
  over.AddRect(top_left(r), bottom_right(r), packed(ui.palette.window), 8, 0, 4.5f);
  over.AddRect(top_left(r), bottom_right(r), packed(ui.palette.text), 8, 0, 2);
}

void begin_region(Ui& ui, const char* name, const Rect& r, const std::optional<Colour>& background, bool above) {
  ui.rects[name] = r;
  ImGui::SetNextWindowPos(top_left(r));
  ImGui::SetNextWindowSize({r.width(), r.height()});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, packed(background.value_or(ui.palette.window)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{0, 0});
  ImGui::Begin((ui.side + name).c_str(), nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoFocusOnAppearing |
                   (background ? 0 : ImGuiWindowFlags_NoBackground) |
                   (above ? 0 : ImGuiWindowFlags_NoBringToFrontOnFocus));
  // It takes no focus when it appears: Dear ImGui can't have that in the frame in which a sheet opens.
  if (above && ImGui::IsWindowAppearing()) ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
}

void more_beyond(Ui& ui, const std::string& name, const Rect& r) {
  constexpr float dimmed = 20, bar = 12;
  const float right = r.right - (ImGui::GetScrollMaxY() > 0 ? bar : 0);
  const ImU32 none = packed(ui.palette.window, 0), all = packed(ui.palette.window, 0.9);
  if (ImGui::GetScrollY() > 1) {
    list().AddRectFilledMultiColor({r.left, r.top}, {right, r.top + dimmed}, all, all, none, none);
    ui.rects["more above " + name] = {r.left, r.top, right, r.top + dimmed};
  }
  if (ImGui::GetScrollY() < ImGui::GetScrollMaxY() - 1) {
    list().AddRectFilledMultiColor({r.left, r.bottom - dimmed}, {right, r.bottom}, none, none, all, all);
    ui.rects["more below " + name] = {r.left, r.bottom - dimmed, right, r.bottom};
  }
}

void tooltip(const Ui& ui, const std::string& s) {
  if (ui.pointer_rest > pointer_patience) return;  // it must not cover the text forever while the keys step
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{10, 7});
  ImGui::SetTooltip("%s", s.c_str());
  ImGui::PopStyleVar();
}

void filled(const Rect& r, const Colour& colour, float rounding) {
  list().AddRectFilled(top_left(r), bottom_right(r), packed(colour), rounding);
}

void outlined(const Rect& r, const Colour& colour, float width, float rounding) {
  list().AddRect(top_left(r), bottom_right(r), packed(colour), rounding, 0, width);
}

void rule(const Ui& ui, float x0, float x1, float y) {
  list().AddRectFilled({x0, std::round(y)}, {x1, std::round(y) + 1}, packed(ui.palette.rule));
}

float opener(Ui& ui, const Opener& o, bool quiet, bool& pressed) {
  const std::string words = fitted(ui.fonts.body, o.words, o.room - 18);
  const float end = o.x + text_width(ui.fonts.body, words) + 18;
  const Rect r{o.x - 8, o.y - 16, end + 6, o.y + 16};
  const Press p = press(ui, o.name, r);
  const Colour& ink = p.hovered || !quiet ? ui.palette.text : ui.palette.muted;
  if (p.hovered) filled(r, ui.palette.frame);
  text(ui.fonts.body, o.x, o.y, packed(ink), words);
  caret(end - 6, o.y, true, packed(p.hovered ? ui.palette.text : ui.palette.muted));
  if (p.hovered) tooltip(ui, words == o.words ? o.help : o.words + "\n" + o.help);
  pressed = p.clicked;
  return end;
}

bool chip(Ui& ui, const std::string& name, const Rect& r, const std::string& label, bool chosen, ImFont* font) {
  const Press p = press(ui, name, r);
  const Palette& c = ui.palette;
  filled(r, chosen ? c.first : p.hovered ? c.hovered : c.frame);
  if (p.held) outlined(r, c.first);
  text(font ? font : ui.fonts.body, r.middle_x(), r.middle_y(), packed(chosen ? c.on_first : c.text), label, 0.5f);
  return p.clicked;
}

bool icon_button(Ui& ui, const std::string& name, const Rect& r, Icon icon, bool primary, bool enabled) {
  const Press p = press(ui, name, r);
  const Palette& c = ui.palette;
  filled(r, primary ? c.first : p.hovered && enabled ? c.hovered : c.frame);
  if (p.held && enabled) outlined(r, primary ? c.text : c.first);
  draw_icon(icon, r.middle_x(), r.middle_y(), packed(primary ? c.on_first : c.text, enabled ? 1 : 0.35));
  return p.clicked && enabled;
}

void tick(float x, float y, float size, ImU32 colour) {
  const float u = size / 14;
  const ImVec2 points[] = {{x - 6 * u, y + 0.5f * u}, {x - 2 * u, y + 4.5f * u}, {x + 6 * u, y - 5 * u}};
  list().AddPolyline(points, 3, colour, 0, 2.4f * u);
}

void cross(float x, float y, float size, ImU32 colour) {
  const float h = size * 0.36f, width = size * 0.17f;
  list().AddLine({x - h, y - h}, {x + h, y + h}, colour, width);
  list().AddLine({x - h, y + h}, {x + h, y - h}, colour, width);
}

void ring(float x, float y, float size, ImU32 colour) {
  list().AddCircle({x, y}, size * 0.375f, colour, 24, size * 0.14f);
}

void diamond(float x, float y, float size, ImU32 colour) {
  const float h = size * 0.46f;
  list().AddQuadFilled({x, y - h}, {x + h, y}, {x, y + h}, {x - h, y}, colour);
}

void caret(float x, float y, bool open, ImU32 colour) {
  if (open)
    list().AddTriangleFilled({x - 4.5f, y - 2.5f}, {x + 4.5f, y - 2.5f}, {x, y + 3.5f}, colour);
  else
    list().AddTriangleFilled({x - 2.5f, y - 4.5f}, {x + 3.5f, y}, {x - 2.5f, y + 4.5f}, colour);
}

void handle_sign(float x, float y, const Colour& colour, const Colour& rim) {
  list().AddCircleFilled({x, y}, 8.5f, packed(colour, 0.25), 24);
  list().AddCircle({x, y}, 8.5f, packed(rim), 24, 1.2f);
  list().AddCircleFilled({x, y}, 3.8f, packed(colour), 16);
}

void turn_sign(float x, float y, const Colour& colour) {
  list().PathArcTo({x, y}, 7, -2.6f, 1.9f, 20);
  list().PathStroke(packed(colour), 0, 1.5f);
  const ImVec2 tip{x + 7 * std::cos(2.25f), y + 7 * std::sin(2.25f)};
  list().AddTriangleFilled({tip.x - 2.5f, tip.y - 3}, {tip.x + 4, tip.y - 2}, {tip.x + 1, tip.y + 4}, packed(colour));
}

void logo(const Ui& ui, float x, float y) {
  const Palette& c = ui.palette;
  list().AddCircleFilled({x, y}, 10.5f, packed(c.second, 0.16), 32);
  list().AddCircle({x, y}, 10.5f, packed(c.second), 32, 2);
  list().AddLine({x - 15, y + 5}, {x + 15, y - 6}, packed(c.first), 2.2f);
  list().AddLine({x - 9.5f, y + 3}, {x + 10, y - 4.2f}, packed(c.hit), 3);
  list().AddCircleFilled({x - 9.7f, y + 3.1f}, 2.2f, packed(c.hit), 12);
}

}  // namespace isect::viz
