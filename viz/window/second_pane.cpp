#include "viz/window/second_pane.h"

#include <algorithm>
#include <utility>

#include "viz/text/names.h"
#include "viz/text/rich_text.h"
#include "viz/walk/walk_difference.h"
#include "viz/window/panels.h"

namespace isect::viz {
namespace {

std::string method_title(const Player& p, const std::string& choice) {
  for (const Method& m : p.played().methods())
    if (m.choice == choice) return plain(m.title);
  return choice;
}

std::string preset_title(const Player& p, const std::string& id) {
  const auto found = std::ranges::find(p.lesson().presets, id, &Preset::id);
  return found == p.lesson().presets.end() ? "changed" : plain(p.told_title(*found));
}

/// Returns the title of the method or preset in the first pane.
std::string first_title(const Player& first, const Beside& side) {
  return side.method.empty() ? preset_title(first, first.played().preset_id())
                             : method_title(first, first.played().method());
}
std::string second_title(const Player& first, const Beside& side) {
  return side.method.empty() ? preset_title(first, side.preset) : method_title(first, side.method);
}

/// Returns the one after `now`, cyclically; empty if there is no other one.
std::string next_of(const std::vector<std::string>& all, const std::string& now) {
  const auto at = std::ranges::find(all, now);
  const std::string& next = at == all.end() || at + 1 == all.end() ? all.front() : at[1];
  return next == now ? std::string() : next;
}

/// Returns the next method, else the preset that was left by hand, else the next preset.
std::optional<Beside> usual(const Player& p) {
  std::vector<std::string> methods, presets;
  for (const Method& m : p.played().methods()) methods.push_back(m.choice);
  for (const Preset* preset : p.played().group()) presets.push_back(preset->id);
  Beside side{p.lesson().id, {}, {}};
  if (methods.size() > 1)
    side.method = next_of(methods, p.played().method());
  else if (p.played().preset_id().empty() && !p.origin().empty())
    side.preset = p.origin();
  else if (!presets.empty())
    side.preset = next_of(presets, p.played().preset_id());
  if (side.method.empty() && side.preset.empty()) return std::nullopt;
  return side;
}

/// Draws what the second pane can show: methods, then presets of the first one's method. Its choice becomes `chosen`.
void menu(const Player& first, Ui& ui, Beside& chosen, const ImVec2& at) {
  ImGui::SetNextWindowPos(at);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{6, 6});
  if (ImGui::BeginPopup("other side")) {
    std::vector<std::pair<std::string, Beside>> rows;
    const std::string& lesson = first.lesson().id;
    for (const Method& m : first.played().methods()) rows.emplace_back(plain(m.title), Beside{lesson, m.choice, {}});
    for (const Preset* p : first.played().group())
      rows.emplace_back(plain(first.told_title(*p)), Beside{lesson, {}, p->id});
    float width = 160;
    for (const auto& [title, side] : rows) width = std::max(width, text_width(ui.fonts.body, title) + 28);
    const ImVec2 top = ImGui::GetCursorScreenPos();
    float y = top.y;
    for (const auto& [title, side] : rows) {
      const std::string name = "against " + (side.method.empty() ? side.preset : side.method);
      if (chip(ui, name, {top.x, y, top.x + width, y + 28}, title, side == chosen)) {
        chosen = side;
        ImGui::CloseCurrentPopup();
      }
      y += 31;
    }
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

/// What each pane marks.
Parted parted_first(const WalkDifference& d) { return {d.line_a, d.value_a, d.renamed}; }
Parted parted_second(const WalkDifference& d) { return {d.line_b, d.value_b, d.renamed}; }

/// Draws "≠ line 6, m²": the first difference; or else "≈ same but for a name, line 2". Pressed, it brings the line
/// into view. `side`: its names' prefix.
void told(Ui& ui, const std::string& side, const Step& step, const Parted& parted, float left, float right, float y) {
  const bool alike = parted.line < 0 && parted.value < 0;
  const int line = !alike ? parted.line : parted.renamed.empty() ? -1 : parted.renamed.front();
  std::string words = line < 0 ? "" : "line " + std::to_string(line + 1);
  if (parted.value >= 0) words += (words.empty() ? "" : ", ") + plain(step.values[parted.value].name);
  if (words.empty() || right - left < 60) return;
  const std::string whole = alike ? "≈ same but for a name, " + words : "≠ " + words;
  words = fitted(ui.fonts.body, whole, right - left);
  const Rect r{right - text_width(ui.fonts.body, words) - 6, y - 14, right + 6, y + 14};
  const Press p = line < 0 ? Press{} : press(ui, side + "differs", r);
  if (p.hovered) filled(r, ui.palette.hovered);
  if (p.hovered && words != whole) tooltip(ui, whole);
  if (p.clicked) ui.focus.take(side + "line " + std::to_string(line + 1));
  text(ui.fonts.body, right, y, packed(alike ? ui.palette.muted : ui.palette.miss), words, 1);
}

/// Draws what stands above the panes. Returns whether the second one is to be closed.
bool heads(const Player& first, const Player& other, const WalkDifference& difference, Ui& ui, Beside& side,
           const PanesLayout& at) {
  begin_region(ui, "pane heads", at.heads);
  const float y = at.heads.middle_y(), left = at.heads.left + 20, middle = at.second_scene.left;
  const float end = left + text(ui.fonts.bold, left, y, packed(ui.palette.text),
                                fitted(ui.fonts.bold, first_title(first, side), middle - left - 12));
  told(ui, "", first.step(), parted_first(difference), end + 16, middle - 16, y);
  const Rect close{at.heads.right - 48, y - 14, at.heads.right - 20, y + 14};
  bool pressed = false;
  const Opener against{"against",
                       "against " + second_title(first, side),
                       "Another method or preset on this side",
                       middle + 20,
                       y,
                       close.left - middle - 40};
  const float opened = opener(ui, against, false, pressed);
  told(ui, "other ", other.step(), parted_second(difference), opened + 16, close.left - 12, y);
  if (pressed) ImGui::OpenPopup("other side");
  menu(first, ui, side, {middle + 12, at.heads.bottom});
  const Press p = press(ui, "one pane", close);
  if (p.hovered) filled(close, ui.palette.hovered), tooltip(ui, "One pane again (V)");
  cross(close.middle_x(), y, 15, packed(ui.palette.text));
  rule(ui, at.heads.left, at.heads.right, at.heads.bottom - 1);
  filled({middle, at.heads.top, middle + 1, at.heads.bottom}, ui.palette.rule, 0);
  ImGui::End();
  return p.clicked;
}

/// Returns where the panes part, without values while a question is open: those on show belong to no step.
WalkDifference difference_now(const Player& first, const Player& second) {
  WalkDifference difference = walk_difference(first.walk(), first.index(), second.walk(), second.index());
  if (first.quiz().asked() || second.quiz().asked()) difference.value_a = difference.value_b = -1;
  return difference;
}

}  // namespace

bool two_panes(const Player& player, const Settings& settings) {
  return settings.beside && settings.beside->lesson == player.lesson().id;
}

void toggle_panes(const Player& player, Settings& settings, Toast& toast) {
  if (std::exchange(settings.beside, std::nullopt)) return;
  settings.beside = usual(player);
  if (!settings.beside) return toast.say("There is nothing to set against this");
  settings.map = false;
}

/// Returns false if the other side does not exist; then there is one pane.
bool SecondPane::follow(Player& first, Settings& settings, Toast& toast) {
  const Beside& side = *settings.beside;
  const Lesson& lesson = first.lesson();
  try {
    Parameters parameters = first.parameters();
    if (side.method.empty())
      parameters = preset(lesson, side.preset).parameters;
    else
      parameters[lesson.group_by] = side.method;
    if (!other_) other_.emplace(first), scene_.forget(), names_.clear();
    other_->follow(first, parameters);
    first.accompany(&*other_);
    return true;
  } catch (const BadInput& wrong) {
    toast.complain(wrong.what());
    leave(first, settings);
    return false;
  }
}

void SecondPane::leave(Player& first, Settings& settings) {
  settings.beside.reset();  // it may be of another lesson
  first.accompany(nullptr);
  other_.reset();
}

void SecondPane::on_its_side(const ScenePane& first, Settings& settings, const std::function<void(Player&)>& draw) {
  Player& lead = first.player;
  if (!two_panes(lead, settings) || !follow(lead, settings, first.toast)) return;
  if (std::exchange(named_, other_->revision()) != other_->revision() || names_.empty())
    names_ = names_of(other_->lesson(), other_->walk());
  std::swap(first.ui.names, names_);
  on_other_side(first.ui, [&] { draw(*other_); });
  std::swap(first.ui.names, names_);

  const bool methods = !settings.beside->method.empty();
  Parameters shared = methods ? other_->parameters() : lead.parameters();
  if (methods) shared[lead.lesson().group_by] = lead.played().method();
  attempt(first.toast, [&] { lead.take_from(*other_, shared); });
}

void SecondPane::show_other(const ScenePane& first, Settings& settings, const PanesLayout& at) {
  on_its_side(first, settings, [&](Player& other) {
    const Parted parted = parted_second(difference_now(first.player, other));
    const Pane pane = settings.beside->method.empty() ? Pane::fixed : Pane::along;
    Toast toast;
    double zoom = 1;
    scene_.show({other, first.ui, toast, zoom, pane}, at.second_scene);
    if (at.second_code.height() > 0) code_panel(other, first.ui, at.second_code, &parted);
  });
}

void SecondPane::show(const ScenePane& first, Settings& settings, SceneView& lead, const PanesLayout& at) {
  if (!follow(first.player, settings, first.toast)) return;
  const WalkDifference difference = difference_now(first.player, *other_);
  if (heads(first.player, *other_, difference, first.ui, *settings.beside, at))
    toggle_panes(first.player, settings, first.toast);
  const Parted parted = parted_first(difference);
  lead.show(first, at.first_scene);
  if (at.first_code.height() > 0) code_panel(first.player, first.ui, at.first_code, &parted);
  show_other(first, settings, at);
}

}  // namespace isect::viz
