#include "web/browser_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/book/picture_size.h"
#include "viz/compose/paper.h"
#include "viz/formats/page_svg.h"
#include "viz/formats/svg_path.h"
#include "viz/player/camera_moves.h"
#include "viz/player/dragging.h"
#include "viz/player/lights.h"
#include "viz/player/reader_state.h"
#include "viz/player/scene_time.h"
#include "viz/player/side_at.h"
#include "viz/snapshot/snapshot.h"
#include "viz/text/number_text.h"
#include "viz/text/rich_text.h"
#include "viz/text/tex.h"
#include "viz/walk/alt_text.h"
#include "viz/walk/step_text.h"
#include "web/request.h"

namespace isect::web {

namespace {

using program::book::Station;
using viz::BadInput;
using viz::Vec2;
using viz::Vec3;
using Json = BrowserSession::Json;

/// A press of an arrow key moves what is held by eight of these, in units of the picture.
constexpr double a_pixel = 0.4;

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

/// Reads the time of a link that opens this station.
double time_from(const std::string& text, const viz::Walk& walk, const Station& at) {
  if (at.asks) throw BadInput("time: nothing moves while a question is open");
  return viz::checked_time(walk, at.step, viz::number_from(text));
}

}  // namespace

BrowserSession::BrowserSession(std::vector<const viz::Lesson*> lessons, ReadScene read_scene, TakeFile take_file)
    : lessons_(std::move(lessons)), read_scene_(std::move(read_scene)), take_file_(std::move(take_file)) {
  const auto on = [&](const char* name, Json (BrowserSession::*member)(const Json&)) {
    asked_[name] = [this, member](const Json& request) { return (this->*member)(request); };
  };
  on("open", &BrowserSession::open);
  on("go", &BrowserSession::go);
  on("load", &BrowserSession::load);
  on("set", &BrowserSession::set);
  on("take", &BrowserSession::take);
  on("drag", &BrowserSession::drag);
  on("drop", &BrowserSession::drop);
  on("push", &BrowserSession::push);
  on("turn", &BrowserSession::turn);
  on("zoom", &BrowserSession::zoom);
  on("frame all", &BrowserSession::frame_all);
  on("time", &BrowserSession::time);
  on("undo", &BrowserSession::undo);
  on("redo", &BrowserSession::redo);
  on("look", &BrowserSession::look);
  on("point", &BrowserSession::point);
  on("light", &BrowserSession::light);
  on("copy", &BrowserSession::copy);
  on("whole", &BrowserSession::whole);
  on("file", &BrowserSession::file);
  on("corner", &BrowserSession::corner);
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

/// Returns the first of a scene's answers, behind the step that shows its objects; `the_same`: the one that the reader
/// stands at, as long as it is asked for.
Station BrowserSession::answer_in(const viz::Walk& walk, bool the_same) const {
  if (the_same && player_ && scene_) {
    const std::string& here = player_->walk().steps[station().step].slug;
    for (std::size_t i = 1; i < walk.steps.size(); ++i)
      if (walk.steps[i].slug == here) return {static_cast<int>(i), false};
  }
  const std::vector<Station> all = program::book::stations(walk);
  return all[std::min<std::size_t>(1, all.size() - 1)];
}

// What can be asked for.

/// {"lesson", "preset", "step", "asks", "changes": [[name, text]], "camera", "time"}: all but the first may be absent.
/// Or
/// {"scene"}, the text of a scene file, in place of the first, and then "step" may also be "answer" or "same answer".
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
  const Json step = request.contains("step") ? request.at("step") : Json(0.0);
  const double number = step.is_string() ? 0.0 : step.get<double>();  // an address may hold any
  const Station wanted = step.is_string()
                             ? answer_in(fresh.walk(), step.get<std::string>() == "same answer")
                             : Station{static_cast<int>(std::clamp(number, -1.0, 1e6)), request.value("asks", false)};
  const bool known = std::ranges::find(all, wanted) != all.end();
  if (const std::string time = request.value("time", ""); !time.empty() && known)
    read_named("time", [&] { state.time = time_from(time, fresh.walk(), wanted); });
  player_ = std::move(fresh);
  scene_ = std::move(scene);
  held_.reset(), map_start_.reset();
  stand_at(known ? wanted : Station{});
  if (state.time) player_->set_time(*state.time);
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

/// {"factor", "moving"}: above 1 closer; whether more is to come
Json BrowserSession::zoom(const Json& request) {
  const Vec2 middle = figure_.view.corner() + Vec2(figure_.view.width(), figure_.view.height()) / 2;
  viz::zoom(player(), figure_.view, middle, std::clamp(request.at("factor").get<double>(), 0.2, 5.0));
  return frame(request.value("moving", false) ? Drawn::in_motion : Drawn::at_rest);
}

Json BrowserSession::frame_all(const Json&) {
  viz::frame_all(player());
  return frame(Drawn::at_rest);
}

/// {"share"}: of the motion, from 0 to 1, first contact where it is next to that; or {"seconds"} of play; or {"still"},
/// where nothing is to move by itself: the next one.
Json BrowserSession::time(const Json& request) {
  const viz::Scene::Time* const motion = player().time();
  if (!motion) throw BadInput("nothing moves in this step");
  const double length = motion->hi - motion->lo;
  if (request.contains("seconds"))
    player_->set_time(
        viz::time_after(*motion, player_->now(), std::clamp(request.at("seconds").get<double>(), 0.0, 1.0)));
  else if (request.contains("still"))
    player_->set_time(viz::next_still(*motion, player_->now()));
  else
    player_->set_time(viz::time_near(*motion, motion->lo + request.at("share").get<double>() * length, 0.004 * length));
  return frame(Drawn::in_motion);
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
  const viz::Walk walk = p.drawn_walk();
  const viz::Step& step = walk.steps[static_cast<std::size_t>(p.index())];
  const auto camera = [&](double) { return p.camera().goal(); };
  const auto made = viz::readable_figure(walk, p.index(), viz::ThemeName::screen, {320, 200}, true, camera);
  const viz::Drawing& drawing = made ? made->figure.drawing : figure_.drawing;
  const std::string alt = viz::alt_text(p.lesson(), p.parameters(), walk, p.index());
  std::string line = alt;
  std::ranges::replace(line, '\n', ' ');
  line.erase(line.find_last_not_of(' ') + 1);
  const std::string file = fmt::format("{}-{}", p.lesson().id, viz::file_stem(p.index(), step));
  const std::string caption = viz::figure_caption(p.lesson(), step);
  return {{"svg", viz::lone_svg(drawing, alt, "figure-")},
          {"width", drawing.width},
          {"height", drawing.height},
          {"background", viz::hex_of(drawing.background)},
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
    return fmt::format("<figure{}>{}</figure>\n", program::book::attributes_of_picture(drawn.drawing.width),
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

/// {"name", "base64", "begins", "ends"}: a part of a file, in order. What ends it is answered with {"scene"}: a text
/// that names the file.
Json BrowserSession::file(const Json& request) {
  if (!take_file_) throw BadInput("files are opened on the page of scenes");
  if (request.value("begins", false)) coming_.clear();
  coming_ += bytes_of(request.at("base64").get<std::string>());
  if (!request.value("ends", false)) return Json::object();
  const std::string bytes = std::exchange(coming_, {});
  return {{"scene", take_file_(request.at("name").get<std::string>(), bytes)}};
}

/// {"handle", "behind"}: removes the corner of an outline that it moves, or adds one in the middle of the side that
/// begins there; {"x", "y"}: adds one to the side that passes there. Answered with {"scene"}, the text after that; with
/// nothing where there is no such corner or side.
Json BrowserSession::corner(const Json& request) {
  constexpr double reach = 4;  // units of the picture
  if (!scene_ || player().quiz().asked()) return Json::object();
  const std::vector<viz::SceneSide> sides = scene_->sides(player_->parameters());
  viz::SceneEdit edit = {.kind = viz::SceneEdit::Kind::add_corner};
  if (request.contains("handle")) {
    const viz::Handle handle = handle_named(request.at("handle").get<std::string>());
    const auto side = std::ranges::find(sides, handle.id(), &viz::SceneSide::parameter);
    if (side == sides.end()) return Json::object();
    if (!request.value("behind", false)) edit.kind = viz::SceneEdit::Kind::remove_corner;
    edit.what = side->object, edit.corner = side->corner, edit.middle = side->from / 2 + side->to / 2;
  } else {
    const std::optional<viz::PlaceOnSide> place = viz::side_at(sides, figure_.view, point_in(request), reach);
    if (!place) return Json::object();
    edit.what = place->side.object, edit.corner = place->side.corner, edit.middle = place->at;
  }
  return {{"scene", scene_->edited(player_->parameters(), edit)}};
}

}  // namespace isect::web
