#include "web/browser_session.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/book/picture_size.h"
#include "app/figures/value_words.h"
#include "app/pages/html.h"
#include "viz/chart/case_map.h"
#include "viz/compose/paper.h"
#include "viz/formats/page_svg.h"
#include "viz/formats/svg_path.h"
#include "viz/player/camera_moves.h"
#include "viz/player/lights.h"
#include "viz/snapshot/snapshot.h"
#include "viz/text/names.h"
#include "viz/text/rich_text.h"
#include "viz/text/tex.h"
#include "viz/walk/alt_text.h"
#include "viz/walk/closing.h"
#include "viz/walk/pseudocode.h"
#include "viz/window/number_text.h"
#include "viz/window/scene_names.h"

namespace isect::web {

namespace {

using program::html_text;
using program::book::Station;
using viz::BadInput;
using viz::Vec2;
using viz::Vec3;
using Json = BrowserSession::Json;

/// A press of an arrow key moves what is held by eight of these, in units of the picture.
constexpr double a_pixel = 0.4;
/// The size of a map beside the scene, in units of the picture.
constexpr double map_width = 264, map_height = 190;
/// The width of strokes that light up, as a share of the window's.
constexpr double thinner = 0.45;

Vec2 point_in(const Json& request) { return {request.at("x").get<double>(), request.at("y").get<double>()}; }

/// Which way an arrow key goes.
Vec2 way_in(const Json& request) { return {request.at("x").get<double>(), request.at("y").get<double>()}; }

std::string name_of(const viz::Handle& h) { return fmt::format("{}/{}", h.parameter, static_cast<int>(h.kind)); }

/// "1,5" is a number, and "1, 5, 2" or "(1, 5, 2)" a point: its coordinates are written as numbers are.
std::string number_text(const std::string& text) { return viz::to_text(viz::Setting(viz::number_from(text))); }
std::string point_text(std::string text) {
  const std::size_t first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
  if (first != text.npos && text[first] == '(' && text[last] == ')') text = text.substr(first + 1, last - first - 1);
  const char parts_at = text.find(';') != text.npos ? ';' : ',';
  std::string out;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t end = std::min(text.find(parts_at, from), text.size());
    out += (from > 0 ? "," : "") + number_text(text.substr(from, end - from));
    from = end + 1;
  }
  return out;
}

/// Works as `set` of viz/lesson.h, for what people type.
void set_typed(const viz::Lesson& lesson, viz::Parameters& to, const std::string& name, const std::string& text) {
  const auto p = std::ranges::find(lesson.parameters, name, &viz::Parameter::name);
  if (p == lesson.parameters.end()) return viz::set(lesson, to, name, text);  // which says what there is
  if (std::holds_alternative<double>(p->initial)) return viz::set(lesson, to, name, number_text(text));
  if (std::holds_alternative<Vec3>(p->initial)) return viz::set(lesson, to, name, point_text(text));
  viz::set(lesson, to, name, text);
}

std::string camera_text(const viz::Camera& c) {
  return fmt::format("{},{},{},{},{},{},{}", c.azimuth, c.elevation, c.half_height, c.target.x(), c.target.y(),
                     c.target.z(), c.perspective ? 1 : 0);
}

std::optional<viz::Camera> camera_from(const std::string& text, const viz::Lesson& lesson) {
  std::vector<double> n;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t end = std::min(text.find(',', from), text.size());
    n.push_back(viz::number_from(text.substr(from, end - from)));
    from = end + 1;
  }
  if (n.size() != 7 || !(n[2] > 0)) throw BadInput("camera: seven numbers, the third more than 0");
  viz::Camera camera = viz::opening(lesson);
  camera.azimuth = n[0], camera.elevation = std::clamp(n[1], -1.5707963, 1.5707963), camera.half_height = n[2];
  camera.target = {n[3], n[4], n[5]}, camera.perspective = n[6] != 0 && !lesson.flat;
  return camera;
}

/// Calls read(), and adds the part's name to what is wrong with that part of a link.
template <class Read>
void read_named(const std::string& name, const Read& read) {
  try {
    read();
  } catch (const BadInput& e) {
    const std::string why = e.what();
    throw BadInput(why.find(name) != why.npos ? why : name + ": " + why);
  }
}

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

/// A walk of this one step, whose page is laid out as the whole walk's.
viz::Walk alone(const viz::Walk& walk, viz::Step step) {
  viz::Walk one;
  one.steps.resize(1);
  if (viz::has_axis(walk)) one.steps[0].scene.axis = viz::Axis();
  one.steps.push_back(std::move(step));
  return one;
}

}  // namespace

BrowserSession::BrowserSession(std::vector<const viz::Lesson*> lessons, ReadScene read_scene)
    : lessons_(std::move(lessons)), read_scene_(std::move(read_scene)) {
  const auto known = [&](const char* name, Json (BrowserSession::*member)(const Json&)) {
    asked_[name] = [this, member](const Json& request) { return (this->*member)(request); };
  };
  known("open", &BrowserSession::open);
  known("go", &BrowserSession::go);
  known("load", &BrowserSession::load);
  known("set", &BrowserSession::set);
  known("take", &BrowserSession::take);
  known("drag", &BrowserSession::drag);
  known("drop", &BrowserSession::drop);
  known("push", &BrowserSession::push);
  known("turn", &BrowserSession::turn);
  known("zoom", &BrowserSession::zoom);
  known("frame all", &BrowserSession::frame_all);
  known("undo", &BrowserSession::undo);
  known("redo", &BrowserSession::redo);
  known("look", &BrowserSession::look);
  known("point", &BrowserSession::point);
  known("light", &BrowserSession::light);
  known("copy", &BrowserSession::copy);
  known("whole", &BrowserSession::whole);
}

std::string BrowserSession::answer(const std::string& text) {
  const auto wrong = [](const std::string& why) { return Json{{"wrong", why}}.dump(); };
  try {
    const Json request = Json::parse(text);
    const auto found = asked_.find(request.at("do").get<std::string>());
    if (found == asked_.end()) return wrong("nothing of that name can be asked for");
    return found->second(request).dump();
  } catch (const std::exception& e) {
    return wrong(e.what());
  }
}

viz::Player& BrowserSession::player() {
  if (!player_) throw BadInput("no lesson is open");
  return *player_;
}

program::book::WalkSection BrowserSession::section(program::book::WalkSection::Picture picture) const {
  return {{player_->lesson(), player_->parameters(), player_->walk()}, "live", std::move(picture), names_};
}

Station BrowserSession::station() const {
  return player_->quiz().asked() ? Station{player_->index() + 1, true} : Station{player_->index(), false};
}

void BrowserSession::stand_at(const Station& at) {
  player_->go_to(at.asks ? at.step - 1 : at.step);
  if (at.asks) player_->next();
}

// What can be asked for.

/// {"lesson", "preset", "step", "asks", "changes": [[name, text]], "camera"}: all but the first may be absent. Or
/// {"scene"}, the text of a scene file, in place of the first.
Json BrowserSession::open(const Json& request) {
  std::optional<Scene> scene;
  if (request.contains("scene")) {
    if (!read_scene_) throw BadInput("scenes are opened on the page of scenes");
    scene = read_scene_(request.at("scene").get<std::string>());
  }
  const viz::Lesson& lesson =
      scene ? *scene->lesson : viz::lesson_named(lessons_, request.at("lesson").get<std::string>());
  viz::ReaderState state;
  state.lesson = lesson.id;
  state.preset = request.value("preset", lesson.presets.front().id);
  viz::Parameters setting = viz::preset(lesson, state.preset).parameters;
  for (const Json& change : request.value("changes", Json::array())) {
    const std::string name = change.at(0).get<std::string>();
    read_named(name, [&] { set_typed(lesson, setting, name, change.at(1).get<std::string>()); });
  }
  viz::validate(lesson, setting);
  state.parameters = setting;
  if (const std::string camera = request.value("camera", ""); !camera.empty())
    read_named("camera", [&] { state.camera = camera_from(camera, lesson); });
  const bool again = player_ && !scene && !scene_;
  viz::Player fresh = again ? *player_ : viz::Player(scene ? std::vector{&lesson} : lessons_, state, true);
  if (again) fresh.go(state);  // what was done before can be undone
  const std::vector<Station> all = program::book::stations(fresh.walk());
  const double number = request.value("step", 0.0);  // an address may hold any
  const Station wanted = {static_cast<int>(std::clamp(number, -1.0, 1e6)), request.value("asks", false)};
  const bool known = std::ranges::find(all, wanted) != all.end();
  player_ = std::move(fresh);
  scene_ = std::move(scene);
  held_.reset(), map_start_.reset();
  stand_at(known ? wanted : Station{});
  Json reply = frame(Drawn::at_rest);
  if (!known)
    reply["told"] = wanted.asks ? fmt::format("Nothing is asked at step {:.0f} here.", number + 1)
                                : fmt::format("There is no step {:.0f} here.", number + 1);
  reply["parameters"] = parameters();
  reply["flat"] = lesson.flat;
  return reply;
}

/// {"at"}: one of the stations, from 0.
Json BrowserSession::go(const Json& request) {
  const std::vector<Station> all = program::book::stations(player().walk());
  const int at = std::clamp(request.at("at").get<int>(), 0, static_cast<int>(all.size()) - 1);
  stand_at(all[at]);
  return frame(Drawn::at_rest);
}

/// {"preset"}
Json BrowserSession::load(const Json& request) {
  player().load(viz::preset(player().lesson(), request.at("preset").get<std::string>()));
  player_->go_to(0);
  return frame(Drawn::at_rest);
}

/// {"name", "text"}: as it was typed.
Json BrowserSession::set(const Json& request) {
  const std::string name = request.at("name").get<std::string>();
  viz::Parameters typed = player().parameters();
  set_typed(player_->lesson(), typed, name, request.at("text").get<std::string>());
  player_->end_action(), player_->remember("type");
  player_->edit(name, typed.at(name));
  return frame(Drawn::at_rest);
}

/// {"handle", "x", "y"}, or "x" and "y" of the map
Json BrowserSession::take(const Json& request) {
  player().end_action(), player_->remember("drag");
  if (!request.contains("handle")) {
    if (plane_) map_start_ = viz::case_at(map_.cases(), *plane_, point_in(request));
    return Json::object();
  }
  const viz::Handle handle = handle_named(request.at("handle").get<std::string>());
  held_ = Held{handle, handle.at, point_in(request) - figure_.view.project(handle.at).at};
  return Json::object();
}

/// {"x", "y", "snap"}
Json BrowserSession::drag(const Json& request) {
  const bool snap = request.value("snap", false);
  if (map_start_ && plane_) {
    const Vec2 to = viz::case_at(map_.cases(), *plane_, point_in(request));
    return frame(Drawn::in_motion, viz::drag_on_map(player(), *map_start_, to, snap));
  }
  if (!held_) return Json::object();
  const Vec3 to = viz::brought(figure_.view, held_->handle, point_in(request) - held_->grip);
  const viz::Moved moved = viz::drag_to(player(), held_->handle, held_->start, to, snap);
  if (const viz::Handle* now = viz::same_handle(player_->scene(), held_->handle)) held_->handle = *now;
  return frame(Drawn::in_motion, moved);
}

Json BrowserSession::drop(const Json&) {
  held_.reset(), map_start_.reset();
  player().end_action();
  return frame(Drawn::at_rest);
}

/// {"handle", "x", "y", "snap"}: an arrow key; without a handle, on the map
Json BrowserSession::push(const Json& request) {
  const Vec2 way = a_pixel * way_in(request);
  if (request.contains("handle"))
    return frame(Drawn::in_motion,
                 viz::nudge(player(), figure_.view, handle_named(request.at("handle").get<std::string>()), way,
                            request.value("snap", false)));
  if (!plane_ || !map_.cases().here) return Json::object();
  const Vec2 from = viz::pixel_of(map_.cases(), *plane_, map_.cases().here->at);
  player().remember("nudge on the map");
  player_->go_to_case(viz::case_at(map_.cases(), *plane_, from + 8 * way));
  return frame(Drawn::in_motion);
}

/// {"x", "y"}: a drag of the scene itself, in units of the picture
Json BrowserSession::turn(const Json& request) {
  const Vec2 middle = figure_.view.corner() + Vec2(figure_.view.width(), figure_.view.height()) / 2;
  if (player().lesson().flat)
    viz::pan(*player_, figure_.view, middle, middle + way_in(request));
  else
    viz::orbit(*player_, way_in(request) / a_pixel);
  return frame(Drawn::in_motion);
}

/// {"factor"}: above 1 closer
Json BrowserSession::zoom(const Json& request) {
  const Vec2 middle = figure_.view.corner() + Vec2(figure_.view.width(), figure_.view.height()) / 2;
  viz::zoom(player(), figure_.view, middle, std::clamp(request.at("factor").get<double>(), 0.2, 5.0));
  return frame(Drawn::at_rest);
}

Json BrowserSession::frame_all(const Json&) {
  viz::frame_all(player());
  return frame(Drawn::at_rest);
}

Json BrowserSession::undo(const Json&) {
  player().undo();
  return frame(Drawn::at_rest);
}

Json BrowserSession::redo(const Json&) {
  player().redo();
  return frame(Drawn::at_rest);
}

/// {"dark", "map"}
Json BrowserSession::look(const Json& request) {
  if (request.contains("dark")) theme_ = request.at("dark").get<bool>() ? viz::ThemeName::dark : viz::ThemeName::screen;
  if (request.contains("map")) with_map_ = request.at("map").get<bool>();
  return player_ ? frame(Drawn::at_rest) : Json::object();
}

/// {"x", "y"}: the pointer, in the picture
Json BrowserSession::point(const Json& request) {
  const Vec2 at = point_in(request);
  for (const viz::PlacedLabel& label : figure_.labels)
    if (at.x() >= label.box.left - 2 && at.x() <= label.box.right + 2 && at.y() >= label.box.top - 2 &&
        at.y() <= label.box.bottom + 2)
      return lit(viz::keys_of(label, names_));
  return lit(viz::names_near(player().scene(), figure_.view, at, names_));
}

/// {"names"}, or {"handle"}
Json BrowserSession::light(const Json& request) {
  if (request.contains("handle"))
    return lit(viz::keys_of(handle_named(request.at("handle").get<std::string>()), player().lesson()));
  return lit(request.at("names").get<std::vector<std::string>>());
}

/// The step for other documents: {"svg", "latex", "markdown", "alt", "place", "file"}.
Json BrowserSession::copy(const Json&) {
  const viz::Player& p = player();
  const viz::Step& step = p.step();
  const auto camera = [&](double) { return p.camera().goal(); };
  const auto made = viz::readable_figure(p.walk(), p.index(), viz::ThemeName::screen, {320, 200}, true, camera);
  const viz::Drawing& drawing = made ? made->figure.drawing : figure_.drawing;
  const std::string alt = viz::alt_text(p.lesson(), p.parameters(), p.walk(), p.index());
  std::string line = alt;
  std::ranges::replace(line, '\n', ' ');
  line.erase(line.find_last_not_of(' ') + 1);
  const std::string file = fmt::format("{}-{}", p.lesson().id, viz::file_stem(p.index(), step));
  const std::string caption = viz::figure_caption(p.lesson(), step);
  return {{"svg", viz::lone_svg(drawing, alt, "figure-")},
          {"width", drawing.width},
          {"height", drawing.height},
          {"background", viz::svg_colour(drawing.background)},
          {"alt", alt},
          {"file", file},
          {"place", viz::to_json(p.reader_state())},
          {"latex", fmt::format("\\begin{{figure}}\n  \\centering\n  \\includegraphics[width=8cm,alt={{{}}}]{{{}}}\n"
                                "  \\caption{{{}}}\n\\end{{figure}}\n",
                                viz::tex_said(line), file, viz::tex(caption))},
          {"markdown", fmt::format("![{}]({}.svg)\n\n{}\n", line, file, viz::plain(caption))}};
}

/// Every station with its picture, one below the other: {"html"}.
Json BrowserSession::whole(const Json&) {
  const Station before = station();
  const auto picture = [&](const Station& at) {
    stand_at(at);
    const viz::Figure drawn = composed(Drawn::at_rest);
    return fmt::format("<figure{}>{}</figure>\n",
                       program::book::attributes_of_picture(drawn.drawing.width, drawn.drawing.height),
                       viz::lone_svg(drawn.drawing, viz::drawn_text(player_->walk(), player_->scene(), !at.asks),
                                     fmt::format("whole-{}-{}-", at.step, at.asks)));
  };
  const viz::Player kept = player();
  const viz::PaperSize size = size_;
  const std::string html = section(picture).html();
  player_ = kept, size_ = size;
  stand_at(before);
  return {{"html", html}};
}

// What is shown.

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
  const viz::Walk one = alone(p.walk(), std::move(bare));
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
                {"refused", p.shown().refused},
                {"untaken", p.shown().untaken},
                {"handles", handles()},
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
    std::string label = h.one_of, value;
    for (const viz::Parameter& p : player_->lesson().parameters) {
      if (p.name != h.parameter) continue;
      if (label.empty()) label = viz::plain(p.label.empty() ? p.name : p.label);
      if (player_->parameters().contains(p.name))
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
    Json one = {{"name", p.name},
                {"label", html_text(p.label.empty() ? p.name : p.label)},
                {"help", p.help},
                {"kind", kind},
                {"choices", p.choices}};
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

/// The numbers of the exercises that this setting solves.
Json BrowserSession::solved() const {
  Json all = Json::array();
  if (const viz::Closing* closing = player_->lesson().closing)
    for (std::size_t i = 0; i < closing->exercises.size(); ++i)
      if (const viz::Exercise& e = closing->exercises[i]; e.found && e.found(player_->parameters())) all.push_back(i);
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
