#include "app/book/playlist_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/book/lesson_page.h"
#include "app/figures/blocks.h"
#include "app/pages/html.h"
#include "app/playlist_file.h"
#include "app/preset_folder.h"
#include "viz/chart/case_map.h"
#include "viz/formats/svg_path.h"
#include "viz/text/rich_text.h"
#include "viz/walk/closing.h"

namespace isect::program::book {

namespace {

using viz::xml_escaped;

/// Returns a name for addresses: lower-case letters, digits and hyphens.
std::string address_name(const std::string& stem) {
  std::string name;
  for (const char c : stem) {
    const char low = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    const bool plain = (low >= 'a' && low <= 'z') || (low >= '0' && low <= '9');
    if (plain)
      name += low;
    else if (!name.empty() && name.back() != '-')
      name += '-';
  }
  while (name.ends_with('-')) name.pop_back();
  return name.empty() ? "playlist" : name;
}

/// Returns a place as an address that names the playlist and the stop, too.
std::string in_hour(const std::string& place, const std::string& hour, std::size_t stop) {
  const std::size_t hash = place.find('#');
  return fmt::format("{}?hour={}&stop={}{}", place.substr(0, hash), hour, stop, place.substr(hash));
}

std::string told_note(const std::string& note) {
  return note.empty() ? note : "<div class=\"note\">\n" + program::html(Blocks{Prose{note}}) + "</div>\n";
}

}  // namespace

PlaylistPages::PlaylistPages(const Program& program, const std::string& path)
    : list_(read_playlist(program, path)), excerpts_(excerpts_of(list_)) {
  const std::string stem = std::filesystem::path(path).stem().string();
  require_utf8({path, stem});
  name_ = address_name(stem);
  if (list_.title.empty()) list_.title = viz::as_markup(stem);
  for (std::size_t i = 0; i < excerpts_.size(); ++i) stops_.push_back(shown(i));
}

PlaylistPages::Shown PlaylistPages::shown(std::size_t i) const {
  const Excerpt& e = excerpts_[i];
  const viz::Lesson& lesson = *e.lesson;
  const bool own = e.preset.empty();
  const std::string title = lesson.made_from.empty() ? viz::short_title(lesson) : lesson.title;
  Shown stop = {own ? fmt::format("hour-{}-{}.html", name_, i + 1) : file_of(lesson), own ? "setting" : e.preset,
                html_text(title), xml_escaped(viz::steps_in_words(list_.stops[i]))};
  stop.note = list_.stops[i].note;
  for (const int step : e.steps) {
    if (e.walk.steps[step].slug == viz::closing_slug) {
      stop.places.push_back(file_of(lesson) + "#remember");
      continue;
    }
    const std::string place = fmt::format("{}#{}/{}", stop.page, stop.setting, step + 1);
    if (e.walk.steps[step].question) stop.places.push_back(place + "/question");
    stop.places.push_back(!own && e.time && e.step == step ? fmt::format("{}?time={}", place, viz::to_text(*e.time))
                                                           : place);
  }
  return stop;
}

std::vector<std::string> PlaylistPages::files() const {
  std::vector<std::string> all = {file(), script_file()};
  for (std::size_t i = 0; i < stops_.size(); ++i)
    if (excerpts_[i].preset.empty()) all.push_back(stops_[i].page);
  return all;
}

std::string PlaylistPages::link() const {
  return fmt::format("<li><a href=\"{}\">{}</a></li>\n", file(), html_text(list_.title));
}

Page PlaylistPages::page() const {
  const std::string title = viz::plain(list_.title);
  const auto address = [&](std::size_t i) { return xml_escaped(in_hour(stops_[i].places.front(), name_, i + 1)); };
  Page page = {file(), title, fmt::format("A playlist of {} stops.", stops_.size()), {}, {}};
  std::string stops;
  for (std::size_t i = 0; i < stops_.size(); ++i) {
    const Shown& stop = stops_[i];
    stops += fmt::format("<li><a href=\"{}\">{}</a>{}\n{}</li>\n", address(i), stop.name,
                         stop.steps.empty() ? "" : ", " + stop.steps, told_note(stop.note));
  }
  const std::string how = "Each opens the steps in question; Page Down and N go on from there, Page Up goes back.";
  page.body = fmt::format(
      "<div class=\"opening\">\n<h1>{}</h1>\n<p class=\"summary\">{} stops. {}</p>\n</div>\n"
      "<p class=\"hour-begin\" data-hour=\"{}\"><a href=\"{}\">Begin</a></p>\n<ol class=\"stops\">\n{}</ol>\n",
      html_text(list_.title), stops_.size(), how, name_, address(0), stops);
  return page;
}

std::string PlaylistPages::script() const {
  nlohmann::ordered_json all = {{"title", viz::plain(list_.title)}, {"stops", nlohmann::ordered_json::array()}};
  for (const Shown& stop : stops_)
    all["stops"].push_back({{"name", stop.name}, {"note", html_text(stop.note)}, {"places", stop.places}});
  return fmt::format("var isect_hour = {};\n", all.dump());
}

std::vector<Page> PlaylistPages::own_pages(viz::PageColours& colours) const {
  std::vector<Page> all;
  for (std::size_t i = 0; i < stops_.size(); ++i)
    if (excerpts_[i].preset.empty()) all.push_back(own_page(i, colours));
  return all;
}

Page PlaylistPages::own_page(std::size_t i, viz::PageColours& colours) const {
  Excerpt e = excerpts_[i];
  e.walk = viz::walk_with_map(*e.lesson, e.parameters);
  draw_at_time(e);
  const viz::Lesson& lesson = *e.lesson;
  const viz::Preset as = {stops_[i].setting, fmt::format("Stop {} of {}", i + 1, stops_.size()), "", e.parameters};
  viz::PagePictures pictures(colours);
  const std::string walk = walk_section(e, as, true, pictures);
  const std::string lesson_link =
      lesson.made_from.empty() ? fmt::format(" <a href=\"{}\">The lesson</a>", file_of(lesson)) : "";
  Page page = {stops_[i].page, viz::plain(lesson.title), viz::plain(lesson.summary), {}, {}};
  page.body = fmt::format(
      "<div class=\"opening\">\n<h1>{}</h1>\n<p class=\"summary\">{}{}</p>\n</div>\n{}"
      "<nav class=\"settings\" aria-label=\"Settings\">\n<ul>\n<li><a href=\"#{}\">{}</a></li>\n</ul>\n</nav>\n"
      "<div id=\"walks\">\n{}</div>\n",
      html_text(lesson.title), html_text(lesson.summary), lesson_link, pictures.shared(), as.id, as.title, walk);
  return page;
}

}  // namespace isect::program::book
