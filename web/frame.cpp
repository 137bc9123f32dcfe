// The frame that a page gets: all that it shows of the player's state.

#include <fmt/format.h>

#include <algorithm>

#include "app/book/picture_size.h"
#include "app/figures/value_words.h"
#include "app/pages/html.h"
#include "viz/chart/case_map.h"
#include "viz/compose/paper.h"
#include "viz/formats/page_svg.h"
#include "viz/formats/svg_path.h"
#include "viz/player/lights.h"
#include "viz/player/scene_time.h"
#include "viz/text/names.h"
#include "viz/text/rich_text.h"
#include "viz/walk/alt_text.h"
#include "viz/walk/exercise_text.h"
#include "viz/walk/pseudocode.h"
#include "viz/window/scene_names.h"
#include "web/browser_session.h"
#include "web/request.h"

namespace isect::web {

namespace {

using program::html_text;
using program::book::Station;
using viz::BadInput;
using viz::Vec2;
using viz::Vec3;
using Json = BrowserSession::Json;

/// The size of a map beside the scene, in units of the picture.
constexpr double map_width = 264, map_height = 190;
/// The width of strokes that light up, as a share of the window's.
constexpr double thinner = 0.45;

std::string name_of(const viz::Handle& h) { return fmt::format("{}/{}", h.id(), static_cast<int>(h.kind)); }

std::string svg_of(const viz::LitStroke& s) {
  const std::string width = fmt::format("stroke-width=\"{}\"", viz::svg_number(thinner * s.width));
  if (s.radius > 0)
    return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>", viz::svg_number(s.a.x()), viz::svg_number(s.a.y()),
                       viz::svg_number(s.radius), width);
  return fmt::format("<path d=\"M{} {}L{} {}\" {}/>", viz::svg_number(s.a.x()), viz::svg_number(s.a.y()),
                     viz::svg_number(s.b.x()), viz::svg_number(s.b.y()), width);
}

std::string svg_of(const viz::TextBox& b) {
  return fmt::format("<rect class=\"lit-label\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"2\"/>",
                     viz::svg_number(b.left - 1), viz::svg_number(b.top - 1), viz::svg_number(b.right - b.left + 2),
                     viz::svg_number(b.bottom - b.top + 2));
}

bool meet(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  return std::ranges::any_of(a, [&](const std::string& name) { return std::ranges::find(b, name) != b.end(); });
}

bool has_handles(const viz::Walk& walk) {
  return std::ranges::any_of(walk.steps, [](const viz::Step& step) { return !step.scene.handles.empty(); });
}

/// Whether a setting is of the objects that an exercise speaks of: a choice that it does not ask for stays as given.
bool keeps_objects(const viz::Lesson& lesson, const viz::Exercise& e, const viz::Parameters& setting) {
  if (e.preset.empty()) return true;
  const viz::Parameters& given = viz::preset(lesson, e.preset).parameters;
  return std::ranges::all_of(lesson.parameters, [&](const viz::Parameter& p) {
    const bool asked = std::ranges::count(e.by, p.name, &std::pair<std::string, std::string>::first) > 0;
    if (p.choices.empty() || p.name == lesson.group_by || asked) return true;
    const auto was = given.find(p.name), is = setting.find(p.name);
    return was == given.end() || is == setting.end() || was->second == is->second;
  });
}

/// A walk of this one step, whose page is laid out as the whole walk's.
viz::Walk alone(const viz::PlayedWalk& played, viz::Step step) {
  viz::Walk one;
  one.steps.resize(1);
  if (played.has_axis()) one.steps[0].scene.axis = viz::Axis();
  one.steps.push_back(std::move(step));
  return one;
}

}  // namespace

viz::Handle BrowserSession::handle_named(const std::string& name) const {
  for (const viz::Handle& h : player_->scene().handles)
    if (name_of(h) == name) return h;
  throw BadInput("there is no handle " + name);
}

viz::Figure BrowserSession::composed(Drawn how) {
  viz::Player& p = player();
  viz::Step bare;
  bare.slug = p.step().slug, bare.title = p.step().title;
  bare.scene = viz::with_names(p);
  const viz::Walk one = alone(p.played(), std::move(bare));
  const bool chart = bool(one.steps[1].scene.chart);
  const auto camera = [&](double aspect) {
    if (!chart) p.set_aspect(aspect);
    return p.camera().goal();
  };
  if (how == Drawn::at_rest) {
    const viz::PaperSize asked = program::book::picture_size(one.steps[1].scene);
    if (auto made = viz::readable_figure(one, 1, theme_, asked, false, camera)) {
      size_ = made->size;
      return std::move(made->figure);
    }
    size_ = asked;
  }
  const viz::PageLayout layout = viz::paper_layout(one, 1, theme_, size_, false);
  return viz::figure(one.steps[1], camera(layout.width / layout.picture_height()), layout);
}

Json BrowserSession::frame(Drawn how, const viz::Moved& moved) {
  viz::Player& p = player();
  figure_ = composed(how);
  if (how == Drawn::at_rest || names_.empty()) names_ = viz::names_of(p.lesson(), p.walk());
  const auto none = [](const Station&) { return std::string(); };
  const program::book::WalkSection told = section(none);
  const std::vector<Station> all = program::book::stations(p.walk());
  const Station here = station();
  Json reply = {{"at", std::ranges::find(all, here) - all.begin()},
                {"count", all.size()},
                {"step", here.step},
                {"steps", std::ranges::count(all, false, &Station::asks)},
                {"asks", here.asks},
                {"asked", here.asks ? told.asked_name(here.step) : std::string()},
                {"title", here.asks ? std::string() : html_text(p.walk().steps[here.step].title)},
                {"picture", viz::lone_svg(figure_.drawing, viz::drawn_text(p.walk(), p.scene(), !here.asks), "live-")},
                {"width", figure_.drawing.width},
                {"height", figure_.drawing.height},
                {"above", told.above(here)},
                {"below", told.below(here)},
                {"given", told.given()},
                {"opinions", told.opinions()},
                {"outcome", told.outcome()},
                {"line", p.shown().line},
                {"said", told.said(here)},
                {"refused", p.shown().refused},
                {"untaken", p.shown().untaken},
                {"handles", handles()},
                {"moves", p.played().has_time()},
                {"time", time_shown()},
                {"has handles", has_handles(p.walk())},
                {"chart", bool(p.scene().chart)},
                {"values", values()},
                {"idle", idle()},
                {"place", place()},
                {"map", map_beside()},
                {"has map", p.lesson().map && p.lesson().map->place(p.parameters()).allFinite()},
                {"undo", p.history().can_undo()},
                {"redo", p.history().can_redo()},
                {"told", moved.told},
                {"refuses", moved.refused}};
  if (how == Drawn::at_rest) {
    reply["algorithm"] = told.algorithm(), reply["solved"] = solved();
    if (scene_) reply["scene"] = scene_->text(p.parameters());
  }
  return reply;
}

/// The handles: where each stands in the picture, and what it is.
Json BrowserSession::handles() const {
  Json all = Json::array();
  for (const viz::Handle& h : player_->scene().handles) {
    const viz::Projected at = figure_.view.project(h.at);
    if (!(at.depth > 0)) continue;
    std::string label = viz::plain(h.one_of), value;
    for (const viz::Parameter& p : player_->lesson().parameters) {
      if (p.name != h.parameter) continue;
      if (label.empty()) label = viz::plain(p.label.empty() ? p.name : p.label);
      if (h.with.empty() && player_->parameters().contains(p.name))
        value = program::in_words(player_->parameters().at(p.name), player_->lesson().flat);
    }
    all.push_back({{"name", name_of(h)},
                   {"label", label + (value.empty() ? "" : " = " + value)},
                   {"role", viz::name_of(h.role)},
                   {"x", at.at.x()},
                   {"y", at.at.y()}});
  }
  return all;
}

/// Where the scene stands in its motion, as shares of it, and in words; null where nothing moves. `chosen`: it is not
/// the step's own picture.
Json BrowserSession::time_shown() const {
  const viz::Scene::Time* const motion = player_->time();
  if (!motion) return nullptr;
  const auto share = [&](double t) { return (t - motion->lo) / (motion->hi - motion->lo); };
  return {{"now", share(player_->now())},
          {"contact", motion->contact ? Json(share(*motion->contact)) : Json()},
          {"chosen", player_->time_is_chosen()},
          {"words", html_text(viz::time_words(*motion, player_->now()))}};
}

Json BrowserSession::values() const {
  Json all = Json::object();
  for (const auto& [name, value] : player_->parameters()) all[name] = viz::to_text(value);
  return all;
}

/// The parameters that change nothing in this setting.
Json BrowserSession::idle() const {
  Json all = Json::array();
  for (const viz::Parameter& p : player_->lesson().parameters)
    if (!viz::counts(p, player_->parameters())) all.push_back(p.name);
  return all;
}

/// The state for the address: the preset that all began with, and what differs from it.
Json BrowserSession::place() const {
  const viz::Lesson& lesson = player_->lesson();
  Json changes = Json::array();
  const viz::Parameters& before = viz::preset(lesson, player_->origin()).parameters;
  for (const auto& [name, value] : player_->parameters())
    if (const auto was = before.find(name); was == before.end() || was->second != value)
      changes.push_back({name, viz::to_text(value)});
  Json place = {{"origin", player_->origin()},
                {"preset", player_->played().preset_id()},
                {"preset title", html_text(scene_ ? lesson.title : viz::preset(lesson, player_->origin()).title)},
                {"method", html_text(player_->walk().method)},
                {"changes", changes}};
  if (player_->time_is_chosen()) place["time"] = viz::to_text(player_->now());
  if (player_->camera().moved()) place["camera"] = camera_text(player_->camera().goal());
  return place;
}

/// The parameters that a reader can set.
Json BrowserSession::parameters() const {
  Json all = Json::array();
  for (const viz::Parameter& p : player_->lesson().parameters) {
    const char* kind = std::holds_alternative<double>(p.initial) ? "number"
                       : std::holds_alternative<Vec3>(p.initial) ? "point"
                                                                 : "choice";
    Json titles = Json::array();
    for (const std::string& choice : p.choices) titles.push_back(player_->played().title_of(p, choice));
    Json one = {{"name", p.name},
                {"label", html_text(p.label.empty() ? p.name : p.label)},
                {"help", p.help},
                {"kind", kind},
                {"choices", p.choices}};
    one["titles"] = std::move(titles);
    if (!p.where.empty()) one["where"] = viz::told_where(p);
    if (kind == std::string("number")) one["from"] = std::max(p.lo, p.drag_lo), one["to"] = std::min(p.hi, p.drag_hi);
    all.push_back(one);
  }
  return all;
}

/// The map; null where the lesson has none, this step shows it itself, or the reader does not want it.
Json BrowserSession::map_beside() {
  plane_.reset();
  if (player_->scene().chart) {  // the step's own may be dragged over
    const viz::Cases* cases = player_->lesson().map ? std::get_if<viz::Cases>(&player_->scene().chart->kind) : nullptr;
    if (!cases) return nullptr;
    map_.find(*player_);
    const viz::View& view = figure_.view;
    plane_ = viz::plane_of(*cases, view.corner(), view.width(), view.height(), viz::paper_theme(theme_));
    return {{"own", true}};
  }
  if (!with_map_ || !player_->lesson().map) return nullptr;
  const viz::Cases& cases = map_.find(*player_);
  const viz::Theme theme = viz::paper_theme(theme_);
  viz::Drawing drawing{map_width, map_height, theme.background, {}};
  drawing.shapes = viz::compose_map(cases, Vec2::Zero(), map_width, map_height, theme).shapes;
  plane_ = viz::plane_of(cases, Vec2::Zero(), map_width, map_height, theme);
  const std::string here = player_->quiz().asked() ? "here: after your answer"
                           : cases.here            ? "here: " + cases.branches[cases.here->branch]
                                                   : "beyond this map";
  return {{"own", false},
          {"svg", viz::lone_svg(drawing, viz::plain(here), "map-")},
          {"here", html_text(here)},
          {"width", map_width},
          {"height", map_height}};
}

/// The exercises that this setting solves: {"exercise": its number from 0, "told": what is said of it}
Json BrowserSession::solved() const {
  Json all = Json::array();
  if (const viz::Closing* closing = player_->lesson().closing)
    for (std::size_t i = 0; i < closing->exercises.size(); ++i)
      if (const viz::Exercise& e = closing->exercises[i];
          e.found && keeps_objects(player_->lesson(), e, player_->parameters()) && e.found(player_->parameters()))
        all.push_back({{"exercise", i}, {"told", viz::plain(viz::found_text(e, player_->parameters()))}});
  return all;
}

/// {"names", "marks": what lights up in the picture, "sum": what is known of the one name}
Json BrowserSession::lit(const std::vector<std::string>& names) const {
  std::string marks;
  if (!names.empty()) {
    viz::each_named(player_->scene(), names_, [&](const viz::Item& item, const std::vector<std::string>& own) {
      const auto stroke = meet(own, names) ? viz::lit_stroke(item, figure_.view) : std::nullopt;
      if (stroke) marks += svg_of(*stroke);
    });
    for (const viz::PlacedLabel& label : figure_.labels)
      if (meet(viz::keys_of(label, names_), names)) marks += svg_of(label.box);
  }
  const viz::Player& p = *player_;
  return {{"names", names},
          {"marks", marks},
          {"sum", names.size() == 1 ? viz::sum_of(p.lesson(), p.parameters(), p.walk(), p.index(), names[0]) : ""}};
}

}  // namespace isect::web
