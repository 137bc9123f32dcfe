#include "viz/window/sheets.h"

#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <utility>

#include "viz/window/panels.h"

namespace isect::viz {
namespace {

constexpr ImGuiWindowFlags sheet_flags = ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoTitleBar |
                                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove;

std::string lower(std::string s) {
  std::transform(s.begin(), s.end(), s.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return s;
}

}  // namespace

bool begin_sheet(Ui& ui, const char* name, const Rect& window, float width, float height) {
  const float w = std::min(width, window.width() - 40), h = std::min(height, window.height() - 40);
  const Rect r{window.middle_x() - w / 2, window.middle_y() - h / 2, window.middle_x() + w / 2,
               window.middle_y() + h / 2};
  ImGui::SetNextWindowPos(top_left(r));
  ImGui::SetNextWindowSize({w, h});
  const ImGuiStyle& style = ImGui::GetStyle();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, style.PopupRounding);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, style.PopupBorderSize);
  const bool open = ImGui::BeginPopupModal(name, nullptr, sheet_flags);
  ImGui::PopStyleVar(2);
  if (!open) return false;
  ui.rects[name] = r;
  ImGui::GetCurrentContext()->DimBgRatio = 1;  // at once: where nothing moves, no further frame is drawn
  const ImVec2& mouse = ImGui::GetIO().MousePos;
  const bool pressed = ImGui::IsMouseClicked(ImGuiMouseButton_Left) || ImGui::IsMouseClicked(ImGuiMouseButton_Right);
  const bool beside = pressed && !r.contains(mouse.x, mouse.y) && !ImGui::IsWindowAppearing();
  if (beside || key_down(key::escape)) ImGui::CloseCurrentPopup();
  return true;
}

void page_through_sheet() {
  constexpr float share = 0.85f;  // of what is seen: some rows stay
  if (ImGui::IsWindowAppearing()) return;
  const float at = ImGui::GetScrollY(), page = share * ImGui::GetWindowHeight();
  if (ImGui::IsKeyPressed(key::page_up, true)) ImGui::SetScrollY(std::max(0.0f, at - page));
  if (!ImGui::IsKeyPressed(key::page_down, false)) return;
  if (at < ImGui::GetScrollMaxY() - 1)
    ImGui::SetScrollY(at + page);
  else
    ImGui::CloseCurrentPopup();
}

bool search_field(Ui& ui, std::string& words, const char* hint) {
  if (ImGui::IsWindowAppearing()) {
    words.clear();
    ImGui::SetKeyboardFocusHere();
  }
  ImGui::SetNextItemWidth(-1);
  const bool entered = ImGui::InputTextWithHint("##search", hint, &words, ImGuiInputTextFlags_EnterReturnsTrue);
  if (entered) ImGui::SetKeyboardFocusHere(-1);  // Enter has no effect if no row is left
  const ImVec2 lo = ImGui::GetItemRectMin(), hi = ImGui::GetItemRectMax();
  ui.rects["search"] = {lo.x, lo.y, hi.x, hi.y};
  return entered;
}

bool matches(const std::string& text, const std::string& wanted) {
  static const std::map<std::string, std::vector<std::string>> others = {
      {"box", {"aabb", "obb"}},  {"cube", {"box", "aabb"}}, {"ball", {"sphere"}},      {"circle", {"sphere"}},
      {"bvh", {"hierarchy"}},    {"tree", {"hierarchy"}},   {"camera", {"frustum"}},   {"view", {"culling", "picking"}},
      {"mouse", {"picking"}},    {"hull", {"convex"}},      {"inside", {"polygon"}},   {"rounding", {"robust"}},
      {"cylinder", {"capsule"}}, {"line", {"ray"}},         {"moving", {"collision"}}, {"ray", {"segment"}}};
  const std::string all = lower(text);
  const auto stands = [&](const std::string& word) { return all.find(word) != std::string::npos; };
  std::istringstream words(lower(wanted));
  for (std::string word; words >> word;) {
    const auto found = others.find(word);
    if (!stands(word) && (found == others.end() || std::ranges::none_of(found->second, stands))) return false;
  }
  return true;
}

void sheets(WindowSession& s, const Rect& window) {
  const Sheet open = std::exchange(s.requests.sheet, Sheet::none);
  if (open == Sheet::keys) ImGui::OpenPopup("key sheet");
  if (open == Sheet::picker) ImGui::OpenPopup("picker");
  if (open == Sheet::terms) ImGui::OpenPopup("terms");
  if (open == Sheet::reviews) ImGui::OpenPopup("reviews");
  if (open == Sheet::save) ImGui::OpenPopup("save sheet");
  if (open == Sheet::progress) ImGui::OpenPopup("progress sheet");
  if (open == Sheet::stops && s.hour) ImGui::OpenPopup("list of stops");
  key_sheet(s.ui, window);
  picker(s.player, s.ui, s.picker, {s.player.lessons(), s.course, s.settings, s.figures}, s.toast, window);
  terms_sheet(s.player, s.ui, s.searched_term, s.course, s.toast, window);
  if (std::exchange(s.picker.progress, false)) s.requests.sheet = Sheet::progress;
  reviews_sheet(s, window);
  progress_sheet(s, window);
  if (s.hour) stops_sheet(s, window);
  save_sheet(s.player, s.ui, s.save_sheet, s.settings, s.figures, kept_scene(s), s.requests, window);
  if (std::exchange(s.requests.save_back, false)) save_back(s);
  if (const int number = std::exchange(s.requests.review, 0)) begin_review(s, number);
}

}  // namespace isect::viz
