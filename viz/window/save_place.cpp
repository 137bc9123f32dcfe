#include "viz/window/save_place.h"

#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <vector>

namespace isect::viz {
namespace {

constexpr float place_row = 42, place_label = 80;

std::string without_spaces_around(const std::string& words) {
  const std::size_t from = words.find_first_not_of(' '), to = words.find_last_not_of(' ');
  return from == words.npos ? std::string() : words.substr(from, to - from + 1);
}

/// Returns the reader's own folder; empty if it is not known.
std::string home_folder() {
  const char* const home = std::getenv("HOME");
  return home && *home == '/' ? home : std::string();
}

/// Returns folders that may be chosen where `tried` can't be written.
std::vector<std::string> other_folders(const std::string& tried, const std::string& usual) {
  std::vector<std::string> all = {whole_path(usual)};
  if (!home_folder().empty()) all.push_back(home_folder() + "/isect");
  std::error_code error;
  const std::filesystem::path passing = std::filesystem::temp_directory_path(error);
  if (!error) all.push_back((passing / "isect").string());
  std::erase(all, tried);
  return all;
}

/// Draws a field for a line of text.
void text_field(Ui& ui, const std::string& name, std::string& typed, const std::string& hint, const Rect& r,
                bool wrong) {
  ui.rects[name] = r;
  const bool held = focused(ui, name, r);
  ImGui::SetCursorScreenPos(top_left(r));
  ImGui::SetNextItemWidth(r.width());
  if (held && (ui.focus.pressed() || ui.focus.moved())) ImGui::SetKeyboardFocusHere();
  ImGui::InputTextWithHint(("##" + name).c_str(), hint.c_str(), &typed, ImGuiInputTextFlags_AutoSelectAll);
  if (ImGui::IsItemActive() && !held && ui.focus.moved()) ImGui::ClearActiveID();
  left_by_tab(ui, name);
  if (wrong) outlined(r, ui.palette.miss, 1.5f);
}

/// Says why the last file was not written, and draws other folders, each to be chosen.
void failure(Ui& ui, SaveSheet& sheet, const Settings& settings, const std::string& usual, const Rect& r) {
  const Palette& c = ui.palette;
  const std::size_t quoted = sheet.failed.rfind("': ");  // cannot write 'a/file': the reason
  const std::string why = quoted == sheet.failed.npos ? sheet.failed : sheet.failed.substr(quoted + 3);
  text(ui.fonts.bold, r.left, r.top + 10, packed(c.miss), "Nothing can be written there");
  text(ui.fonts.body, r.left, r.top + 30, packed(c.text),
       fitted(ui.fonts.body, why + ". Choose another folder:", r.width()));
  const float below = r.top + 40;
  ui.rects["refused folder"] = {r.left, r.top, r.right, below};
  float x = r.left;
  const std::vector<std::string> others = other_folders(whole_folder(sheet, settings, usual), usual);
  for (std::size_t i = 0; i < others.size(); ++i) {
    const std::string words = fitted(ui.fonts.body, others[i], 150);
    const float width = text_width(ui.fonts.body, words) + 20;
    const Rect at{x, below + 4, x + width, below + 30};
    if (chip(ui, "folder " + std::to_string(i + 1), at, words, false)) sheet.folder = others[i], sheet.failed.clear();
    if (ImGui::IsItemHovered()) tooltip(ui, others[i]);
    x += width + 6;
  }
}

}  // namespace

std::string whole_path(const std::string& path) {
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::absolute(path, error).lexically_normal();
  return error ? path : whole.string();
}

std::string given_name(const SaveSheet& sheet, const Settings& settings) {
  const std::string name = without_spaces_around(sheet.name);
  for (const std::string& ending : {"." + settings.save_format, std::string(".json")})
    if (name.size() > ending.size() && name.ends_with(ending)) return name.substr(0, name.size() - ending.size());
  return name;
}

std::string wrong_name(const SaveSheet& sheet, const Settings& settings) {
  constexpr std::string_view never = "/\\:*?\"<>|";  // in names of files, on one system or another
  constexpr std::size_t longest = 100;
  const std::string name = given_name(sheet, settings);
  if (name.starts_with('.')) return "A name begins with no dot";
  if (name.size() > longest) return "This name is too long for a file";
  const auto wrong = std::ranges::find_if(
      name, [&](char c) { return static_cast<unsigned char>(c) < 32 || never.find(c) != never.npos; });
  return wrong == name.end() ? std::string() : std::string("A name has no ") + *wrong + " in it";
}

std::string whole_folder(const SaveSheet& sheet, const Settings& settings, const std::string& usual) {
  std::string folder = without_spaces_around(sheet.folder);
  if (folder.empty()) folder = settings.save_folder.empty() ? usual : settings.save_folder;
  if ((folder == "~" || folder.starts_with("~/")) && !home_folder().empty()) folder.replace(0, 1, home_folder());
  return whole_path(folder);
}

void place_fields(Ui& ui, SaveSheet& sheet, const Settings& settings, const std::string& usual, const std::string& stem,
                  const std::string& ending, const Rect& r) {
  const Palette& c = ui.palette;
  const float left = r.left + place_label;
  const std::string usual_name = stem.substr(stem.rfind('/') + 1), wrong = wrong_name(sheet, settings);
  float y = r.top;
  text(ui.fonts.body, r.left, y, packed(c.muted), "Name");
  text_field(ui, "save name", sheet.name, usual_name, {left, y - 15, r.right, y + 15}, !wrong.empty());
  y += place_row;
  text(ui.fonts.body, r.left, y, packed(c.muted), "Folder");
  const std::string folder = sheet.folder;
  text_field(ui, "save folder", sheet.folder, whole_path(usual), {left, y - 15, r.right, y + 15},
             !sheet.failed.empty());
  if (sheet.folder != folder) sheet.failed.clear();  // it is another one, which may do
  y += 24;
  if (!wrong.empty()) {
    text(ui.fonts.body, left, y + 8, packed(c.miss), wrong);
    ui.rects["refused name"] = {left, y, r.right, y + 16};
  } else if (!sheet.failed.empty()) {
    failure(ui, sheet, settings, usual, {left, y, r.right, r.bottom});
  } else {
    const std::string name = given_name(sheet, settings);
    const std::string file =
        (sheet.what == SaveSheet::What::figure ? "Figure: " : "File: ") + (name.empty() ? stem : name) + "." + ending;
    text(ui.fonts.body, left, y + 8, packed(c.muted), fitted(ui.fonts.body, file, r.right - left));
  }
}

}  // namespace isect::viz
