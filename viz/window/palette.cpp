#include "viz/window/palette.h"

namespace isect::viz {
namespace {

ImVec4 vec4(const Colour& c, double alpha = 1) {
  return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b), static_cast<float>(c.a * alpha)};
}

void set_sizes(ImGuiStyle& s) {
  s.WindowPadding = {20, 20};
  s.FramePadding = {12, 7};
  s.ItemSpacing = {8, 8};
  s.ItemInnerSpacing = {8, 6};
  s.ScrollbarSize = 10;
  s.WindowRounding = 0;
  s.FrameRounding = s.GrabRounding = 6;
  s.ChildRounding = s.PopupRounding = 8;
  s.ScrollbarRounding = 5;
  s.WindowBorderSize = s.FrameBorderSize = s.ChildBorderSize = 0;
  s.PopupBorderSize = 1;
}

}  // namespace

ImU32 packed(const Colour& c, double alpha) { return ImGui::ColorConvertFloat4ToU32(vec4(c, alpha)); }

Palette palette(ThemeName name) {
  const Theme t = window_theme(name);
  const bool dark = name == ThemeName::dark, grey = name == ThemeName::grey;
  Palette p{.theme = t,
            .window = t.panel,
            .card = t.background,
            .frame = hex(dark   ? 0x2B3540
                         : grey ? 0xE6E6E6
                                : 0xE6EBF0),
            .hovered = hex(dark   ? 0x374452
                           : grey ? 0xD8D8D8
                                  : 0xD8E0E8),
            .text = t.ink(Role::text),
            .muted = t.ink(Role::muted),
            .rule = t.ink(Role::grid),
            .first = t.ink(Role::first),
            .second = t.ink(Role::second),
            .hit = t.ink(Role::hit),
            .miss = t.ink(Role::miss),
            .highlight = t.ink(Role::highlight),
            .fresh = t.ink(grey ? Role::muted : Role::highlight),
            .fresh_text = t.ink(dark ? Role::highlight : Role::text),
            .on_first = t.background,
            .on_highlight = hex(0x14181D)};
  return p;
}

void dress(const Palette& p) {
  ImGuiStyle& s = ImGui::GetStyle();
  ImGui::StyleColorsDark(&s);
  set_sizes(s);
  const Colour clear = p.window.with_alpha(0);
  const std::pair<ImGuiCol, Colour> colours[] = {
      {ImGuiCol_Text, p.text},
      {ImGuiCol_TextDisabled, p.muted},
      {ImGuiCol_WindowBg, p.window},
      {ImGuiCol_ChildBg, clear},
      {ImGuiCol_PopupBg, p.window},
      {ImGuiCol_Border, p.rule},
      {ImGuiCol_FrameBg, p.frame},
      {ImGuiCol_FrameBgHovered, p.hovered},
      {ImGuiCol_FrameBgActive, p.hovered},
      {ImGuiCol_ScrollbarBg, clear},
      {ImGuiCol_ScrollbarGrab, p.frame},
      {ImGuiCol_ScrollbarGrabHovered, p.hovered},
      {ImGuiCol_ScrollbarGrabActive, p.muted},
      {ImGuiCol_SliderGrab, p.first},
      {ImGuiCol_SliderGrabActive, p.first},
      {ImGuiCol_Button, p.frame},
      {ImGuiCol_ButtonHovered, p.hovered},
      {ImGuiCol_ButtonActive, p.first},
      {ImGuiCol_TextSelectedBg, p.first.with_alpha(0.35)},
      {ImGuiCol_NavHighlight, p.first},
      {ImGuiCol_ModalWindowDimBg, hex(0).with_alpha(0.45)},
  };
  for (const auto& [slot, colour] : colours) s.Colors[slot] = vec4(colour);
}

}  // namespace isect::viz
