#include "viz/window/scene_marks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "viz/chart/chart.h"
#include "viz/compose/item_names.h"
#include "viz/player/camera_moves.h"
#include "viz/player/pick.h"
#include "viz/text/names.h"
#include "viz/text/rich_text.h"
#include "viz/walk/closing.h"
#include "viz/window/scene_names.h"

namespace isect::viz {
namespace {

Rect projection_rect(const Player& player, const Ui& ui, const Rect& scene) {
  const char* name = player.camera().goal().perspective ? "perspective" : "orthographic";
  const float width = text_width(ui.fonts.body, name);
  return {scene.right - 28 - width, scene.bottom - 38, scene.right - 12, scene.bottom - 10};
}

std::size_t corners_of(const Region& region) {
  std::size_t corners = 0;
  for (const std::vector<Vec3>& ring : region.rings)
    if (std::ranges::any_of(ring, [&](const Vec3& v) { return v != ring[0]; })) corners += ring.size();
  return corners;
}

}  // namespace

namespace {

constexpr float low_head = 42, high_head = 60;
/// Returns the distance from the scene's edges to its chips.
float edge(const Rect& scene) { return is_low(scene) ? 8.0f : 20.0f; }

/// Whether methods differ; not before the outcome: it would tell what the exact method says.
bool has_alarm(const Player& player) {
  const bool known = player.index() >= outcome(player.walk());
  return player.played().methods_differ() && known && !player.quiz().asked() && !is_card(player.step().scene);
}

std::string alarm_words(const Player& player) {
  const std::vector<Opinion>& said = player.played().opinions();
  const auto differ = std::ranges::count_if(said, [](const Opinion& o) { return !o.agrees; });
  return fmt::format("{} of {} methods {}", differ, said.size(), differ == 1 ? "differs" : "differ");
}

float alarm_width(const Player& player, const Ui& ui) { return 46 + text_width(ui.fonts.body, alarm_words(player)); }

/// Returns the verdict on one line if there is room, else on several.
Paragraph verdict_words(const Player& player, Ui& ui, const Rect& scene, const std::string& verdict) {
  Paragraph words{.markup = verdict, .colour = ui.palette.text};
  if (is_low(scene)) words.size = 13, words.line_pitch = 19;  // as names in the picture
  const float alarm = is_low(scene) && has_alarm(player) ? alarm_width(player, ui) + 12 : 0;
  const float room = scene.width() - 60 - 2 * edge(scene) - alarm;
  if (ui.texts.size_of(words).x > room) words.width = room;
  return words;
}

/// Returns the height of the verdict's chip; 0 if there is none.
float verdict_height(const Player& player, Ui& ui, const Rect& scene, const Step& step) {
  if (step.verdict.text.empty() || is_card(step.scene)) return 0;
  return ui.texts.size_of(verdict_words(player, ui, scene, step.verdict.text)).y + (is_low(scene) ? 9.0f : 13.0f);
}
float verdict_height(const Player& player, Ui& ui, const Rect& scene) {
  return verdict_height(player, ui, scene, player.shown());
}

}  // namespace

/// Returns the tallest of the walk's verdicts, which may take several lines. Of very many it measures the longest.
static float tallest_verdict(const Player& player, Ui& ui, const Rect& scene) {
  constexpr std::size_t most = 100;
  std::vector<const Step*> told;
  for (const Step& step : player.walk().steps)
    if (told.empty() || told.back()->verdict.text != step.verdict.text) told.push_back(&step);
  if (told.size() > most) {
    const auto length = [](const Step* step) { return step->verdict.text.size(); };
    std::ranges::nth_element(told, told.begin() + most, std::greater{}, length);
    told.resize(most);
  }
  float tallest = 0;
  for (const Step* step : told) tallest = std::max(tallest, verdict_height(player, ui, scene, *step));
  return tallest;
}

float steady_head(const Player& player, Ui& ui, TallestVerdict& known, const Rect& scene) {
  const bool low = is_low(scene);
  TallestVerdict wanted = {.walk = player.walk_number(),
                           .width = scene.width(),
                           .height = scene.height(),
                           .alarm = has_alarm(player) ? alarm_width(player, ui) : 0,
                           .tallest = known.tallest};
  if (wanted != known) wanted.tallest = tallest_verdict(player, ui, scene), known = wanted;
  const float tallest = wanted.tallest;
  if (tallest > 0) return std::max(low ? low_head : high_head, edge(scene) + tallest + 5);
  return low && player.played().methods_differ() ? low_head : 0;
}

float head_of(const Player& player, Ui& ui, float steady, const Rect& scene) {
  if (!player.scene().chart) return steady;
  const float verdict = verdict_height(player, ui, scene), alarm = has_alarm(player) ? 40.0f : 0.0f;
  if (is_low(scene)) return std::max(verdict, alarm) + 14;
  return (verdict > 0 ? verdict + 28 : 12) + alarm;
}

float chips_height(const Player& player, Ui& ui, const Rect& scene) {
  const float verdict = verdict_height(player, ui, scene), alarm = has_alarm(player) && !is_low(scene) ? 40.0f : 0.0f;
  return verdict + alarm > 0 ? edge(scene) + verdict + alarm : 0;
}

const Colour& verdict_ink(const Palette& c, Verdict::Kind kind) {
  switch (kind) {
    case Verdict::Kind::yes:
      return c.hit;
    case Verdict::Kind::no:
      return c.miss;
    case Verdict::Kind::on:
      return c.highlight;
    case Verdict::Kind::open:
      break;
  }
  return c.muted;
}

void verdict_sign(Verdict::Kind kind, float x, float y, float size, ImU32 ink) {
  switch (kind) {
    case Verdict::Kind::yes:
      return tick(x, y, size, ink);
    case Verdict::Kind::no:
      return ring(x, y, size, ink);
    case Verdict::Kind::on:
      return diamond(x, y, size - 1, ink);
    case Verdict::Kind::open:
      for (const float dot : {-0.375f, 0.0f, 0.375f})
        ImGui::GetWindowDrawList()->AddCircleFilled({x + dot * size, y}, 0.1125f * size, ink);
  }
}

void verdict_chip(const Player& player, Ui& ui, const Rect& scene) {
  const Verdict& verdict = player.shown().verdict;
  const float height = verdict_height(player, ui, scene), in = edge(scene);
  if (height == 0) return;
  const Colour& ink = verdict_ink(ui.palette, verdict.kind);
  const Paragraph words = verdict_words(player, ui, scene, verdict.text);
  const ImVec2 size = ui.texts.size_of(words);
  const Rect r{scene.left + in, scene.top + in, scene.left + in + 60 + size.x, scene.top + in + height};
  ui.rects["verdict"] = r;
  filled(r, ui.palette.window, 8);
  outlined(r, ink, 1.5f, 8);
  verdict_sign(verdict.kind, r.left + 22, r.middle_y(), 16, packed(ink));
  rich(ui, words, {r.left + 40, r.middle_y() - size.y / 2});
}

void alarm_chip(const Player& player, Ui& ui, const Rect& scene) {
  if (!has_alarm(player)) return;
  const float verdict = verdict_height(player, ui, scene), width = alarm_width(player, ui), in = edge(scene);
  const bool low = is_low(scene);
  const float top = scene.top + in + (verdict > 0 && !low ? verdict + 8 : 0);
  const float left = low ? scene.right - in - width : scene.left + in;
  const Rect r{left, top, left + width, top + (low ? 28.0f : 32.0f)};
  ui.rects["alarm"] = r;
  filled(r, ui.palette.window, 8);
  outlined(r, ui.palette.miss, 1.5f, 8);
  cross(r.left + 20, r.middle_y(), 11, packed(ui.palette.miss));
  text(ui.fonts.body, r.left + 40, r.middle_y(), packed(ui.palette.text), alarm_words(player));
  if (!ImGui::IsMouseHoveringRect(top_left(r), bottom_right(r))) return;
  std::string all;
  for (const Opinion& o : player.played().opinions())
    all += fmt::format("{}{}: {}{}", all.empty() ? "" : "\n", plain(o.method), plain(o.says),
                       o.agrees ? "" : "  (differs)");
  tooltip(ui, all);
}

namespace {

bool meets_handle(const std::vector<Handle>& handles, const View& view, const Rect& r) {
  constexpr double ring = 14;
  return std::ranges::any_of(handles, [&](const Handle& handle) {
    const Vec2 at = view.project(handle.at).at;
    return at.x() > r.left - ring && at.x() < r.right + ring && at.y() > r.top - ring && at.y() < r.bottom + ring;
  });
}

bool meets_label(const Rect& place, const Rect& scene, const std::vector<PlacedLabel>& labels) {
  return std::ranges::any_of(labels, [&](const PlacedLabel& label) {
    return label.box.left < place.right - scene.left && place.left - scene.left < label.box.right &&
           label.box.top < place.bottom - scene.top && place.top - scene.top < label.box.bottom;
  });
}

}  // namespace

void tripod(Ui& ui, const View& view, const Rect& scene, const std::vector<PlacedLabel>& labels,
            const std::vector<Handle>& handles) {
  constexpr float length = 28;
  const ImVec2 origin{scene.left + 46, scene.bottom - 44};
  const Rect place{origin.x - 40, origin.y - 46, origin.x + 46, origin.y + 36};
  if (meets_label(place, scene, labels) || meets_handle(handles, view, place)) return;
  ui.rects["tripod"] = place;
  const Palette& c = ui.palette;
  const ImU32 ink = packed(c.muted);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (int i = 0; i < 3; ++i) {
    const ImVec2 way{static_cast<float>(view.right()[i]), static_cast<float>(-view.up()[i])};
    const float size = std::hypot(way.x, way.y);
    if (size < 0.15f) continue;  // the axis points at the viewer
    const ImVec2 tip{origin.x + way.x * length, origin.y + way.y * length};
    const ImVec2 u{way.x / size, way.y / size};
    list.AddLine(origin, tip, ink, 1.2f);
    list.AddTriangleFilled({tip.x + 5 * u.x, tip.y + 5 * u.y}, {tip.x - 2.5f * u.y, tip.y + 2.5f * u.x},
                           {tip.x + 2.5f * u.y, tip.y - 2.5f * u.x}, ink);
    const Paragraph name{.markup = std::array{"*x*", "*y*", "*z*"}[i], .colour = c.muted};
    rich_line(ui, name, tip.x + 14 * u.x, tip.y + 15 * u.y, 0.5f);
  }
  list.AddCircleFilled(origin, 1.5f, ink, 8);
}

namespace {

bool shows_cases(const Scene& scene) { return scene.chart && std::holds_alternative<Cases>(scene.chart->kind); }

}  // namespace

/// Whether the setting is no preset, or an edited scene is not as its file has it.
static bool is_changed(const Player& player, const Lesson* in_file) {
  return in_file || player.played().preset_id().empty();
}

float changed_room(const Player& player, const Lesson* in_file) {
  const Scene& scene = player.scene();
  if (!is_changed(player, in_file) || !scene.handles.empty() || shows_cases(scene)) return 0;
  return scene.chart || is_page(scene) ? 26 : 0;
}

static Rect changed_rect(const Player& player, const Ui& ui, const Rect& scene, const Lesson* in_file) {
  const float left = scene.right - 28 - text_width(ui.fonts.body, "changed"), right = scene.right - 12;
  if (const float room = changed_room(player, in_file); room > 0)
    return {left, scene.bottom - room, right, scene.bottom - 2};
  if (shows_cases(player.scene()) && !is_low(scene))  // beside the verdict, above all numbers
    return {left, scene.top + 26, right, scene.top + 50};
  return {left, scene.bottom - 64, right, scene.bottom - 40};
}

void changed_mark(Player& player, Ui& ui, Toast& toast, const Rect& scene, const Lesson* in_file) {
  if (!is_changed(player, in_file)) return;
  if (press(ui, "changed", changed_rect(player, ui, scene, in_file)).clicked)
    attempt(toast, [&] { in_file ? player.show_version(*in_file) : player.restart(); });
}

void changed_text(const Player& player, const Ui& ui, const Rect& scene, const Lesson* in_file) {
  if (!is_changed(player, in_file)) return;
  const Rect r = changed_rect(player, ui, scene, in_file);
  text(ui.fonts.body, r.right - 8, r.middle_y(), packed(ui.palette.fresh_text), "changed", 1);
  if (ImGui::IsMouseHoveringRect(top_left(r), bottom_right(r)))
    tooltip(ui, in_file
                    ? "The scene was edited since it was saved. Here: back to the saved one. Ctrl+Z: one change back"
                    : "Parameters were changed by hand. Here or R: back to the preset. Ctrl+Z: one change back");
}

void projection_name(Player& player, Ui& ui, const View& view, const Rect& scene, const std::vector<Handle>& handles) {
  if (meets_handle(handles, view, projection_rect(player, ui, scene))) return;
  if (press(ui, "projection", projection_rect(player, ui, scene)).clicked)
    set_perspective(player, !player.camera().goal().perspective);
}

void projection_text(const Player& player, Ui& ui, const Rect& scene, const std::vector<PlacedLabel>& labels) {
  const Rect r = projection_rect(player, ui, scene);
  if (!ui.rects.contains("projection")) return;
  if (meets_label({r.left + 8, r.top + 4, r.right - 4, r.bottom - 4}, scene, labels)) return;
  ui.rects["projection text"] = r;
  const bool hovered = ImGui::IsMouseHoveringRect(top_left(r), bottom_right(r));
  const Palette& c = ui.palette;
  const char* name = player.camera().goal().perspective ? "perspective" : "orthographic";
  text(ui.fonts.body, r.right - 8, r.middle_y(), packed(hovered ? c.text : c.muted), name, 1);
}

namespace {

/// Above the place of "changed".
Rect pin_rect(const Rect& scene) { return {scene.right - 40, scene.bottom - 94, scene.right - 12, scene.bottom - 66}; }

void pin_sign(float x, float y, bool filled, ImU32 ink) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddLine({x, y}, {x, y + 9}, ink, 1.5f);
  if (filled) list.AddCircleFilled({x, y - 3}, 5, ink, 20);
  list.AddCircle({x, y - 3}, 5, ink, 20, 1.5f);
}

}  // namespace

void toggle_pin(Player& player, Toast& toast) {
  player.pin_camera(!player.camera().pinned());
  toast.say(player.camera().pinned() ? "This view stays whatever preset is loaded; L lets it go"
                                     : "A preset frames itself again");
}

void pin_mark(Player& player, Ui& ui, Toast& toast, const View& view, const Rect& scene,
              const std::vector<Handle>& handles) {
  if (!player.camera().moved() || player.scene().chart) return;
  if (!player.camera().pinned() && meets_handle(handles, view, pin_rect(scene))) return;
  if (press(ui, "pin", pin_rect(scene)).clicked) toggle_pin(player, toast);
}

void pin_text(const Player& player, const Ui& ui, const Rect& scene) {
  if (!ui.rects.contains("pin")) return;
  const Rect r = pin_rect(scene);
  const bool hovered = ImGui::IsMouseHoveringRect(top_left(r), bottom_right(r)), pinned = player.camera().pinned();
  filled(r, ui.palette.window.with_alpha(0.85));
  pin_sign(r.middle_x(), r.middle_y() - 1, pinned, packed(hovered || pinned ? ui.palette.text : ui.palette.muted));
  if (hovered)
    tooltip(ui, pinned ? "This view stays whatever preset is loaded. Here or L: let it go"
                       : "You have moved the view; a preset frames itself anew. Here or L: keep this view");
}

void handle_by_keyboard(const Player& player, Ui& ui, const View& view, const Handle& handle) {
  if (is_named(player, handle)) return;
  const Vec2 at = view.project(handle.at).at;
  const float x = static_cast<float>(at.x()) + 20, y = static_cast<float>(at.y());
  rich_line(ui, {.markup = name_of(player, handle), .colour = ui.palette.text}, x, y);
  ui.rects["name of the ringed handle"] = {x, y - 9, x + 40, y + 9};
}

void item_under_pointer(const Player& player, Ui& ui, const View& view, const Vec2& pixel) {
  const auto picked = pick(player.scene(), view.viewing_ray(pixel));
  if (!picked) return;
  const float x = static_cast<float>(pixel.x()), y = static_cast<float>(pixel.y());
  ui.rects["item under pointer"] = {x, y, x + 1, y + 1};
  std::string name = "surface";
  if (const Ball* ball = std::get_if<Ball>(picked->item)) {
    name = "ball: centre " + value_in_words(Setting(ball->center), player.lesson().flat) + ", radius " +
           shown(ball->radius);
    const Vec2 middle = view.project(ball->center).at;
    const double radius = ball->radius * view.scale_at(ball->center);
    ui.rects["ball under pointer"] = {static_cast<float>(middle.x() - radius), static_cast<float>(middle.y() - radius),
                                      static_cast<float>(middle.x() + radius), static_cast<float>(middle.y() + radius)};
  } else if (const Solid* solid = std::get_if<Solid>(picked->item))
    name = fmt::format("solid: {} corners, {} faces", solid->vertices.size(), solid->faces.size());
  else if (const Mesh* mesh = std::get_if<Mesh>(picked->item))
    name = fmt::format("mesh: {} triangles", mesh->triangles.size());
  else if (const Region* region = std::get_if<Region>(picked->item))
    name = fmt::format("polygon: {} corners", corners_of(*region));
  const std::string own = std::visit(  // a scene of many objects does not show it
      [](const auto& it) -> std::string {
        if constexpr (requires { it.name; })
          return plain(it.name);
        else
          return {};
      },
      *picked->item);
  if (!own.empty()) name = own + ", " + name;
  tooltip(ui, name + "\nthe viewing ray meets it at " + value_in_words(Setting(picked->at), player.lesson().flat));
}

}  // namespace isect::viz
