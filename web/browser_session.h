#pragma once
// A lesson on an interactive page: requests and answers are JSON texts, so that the page's script holds no state except
// what it shows.

#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/book/walk_section.h"
#include "viz/player/map_beside.h"
#include "viz/player/player.h"
#include "viz/scene_editor.h"

namespace isect::web {

/// A scene file that was read: its lesson, what writes its text with other numbers, and what changes its outlines.
struct Scene {
  const viz::Lesson* lesson;
  std::function<std::string(const viz::Parameters&)> text;
  std::function<std::vector<viz::SceneSide>(const viz::Parameters&)> sides;  ///< as in viz::SceneEditor
  /// Returns the text after a change. Throws viz::BadInput, which says why it is refused.
  std::function<std::string(const viz::Parameters&, const viz::SceneEdit&)> edited;
};
/// Throws viz::BadInput.
using ReadScene = std::function<Scene(const std::string& text)>;
/// Keeps a mesh, points or a polygon under its file's name, which scenes may name from then on, and returns a scene's
/// text that does. Throws viz::BadInput, which names the file and its line.
using TakeFile = std::function<std::string(const std::string& name, const std::string& bytes)>;

class BrowserSession {
 public:
  using Json = nlohmann::ordered_json;

  /// `read_scene` and `take_file`: empty where readers can open no scenes of their own.
  explicit BrowserSession(std::vector<const viz::Lesson*>, ReadScene read_scene = {}, TakeFile take_file = {});

  /// `request`: an object whose "do" names what is asked for, such as {"do": "go", "at": 3}. The first is "open". A
  /// request that can't be met changes nothing and is answered, in plain words, with {"wrong": "..."}.
  std::string answer(const std::string& request);

 private:
  struct Held {
    viz::Handle handle;
    viz::Vec3 start;
    viz::Vec2 grip;  ///< from the handle to the pointer that took it
  };
  enum class Drawn { at_rest, in_motion };  ///< in motion a picture keeps its size, and what stays is not sent again

  Json open(const Json&);
  Json go(const Json&);
  Json load(const Json&);
  Json set(const Json&);
  Json take(const Json&);
  Json drag(const Json&);
  Json drop(const Json&);
  Json push(const Json&);
  Json turn(const Json&);
  Json zoom(const Json&);
  Json frame_all(const Json&);
  Json time(const Json&);
  Json undo(const Json&);
  Json redo(const Json&);
  Json look(const Json&);
  Json point(const Json&);
  Json light(const Json&);
  Json copy(const Json&);
  Json whole(const Json&);
  Json file(const Json&);
  Json corner(const Json&);

  viz::Player& player();
  program::book::WalkSection section(program::book::WalkSection::Picture) const;
  program::book::Station station() const;
  void stand_at(const program::book::Station&);
  program::book::Station answer_in(const viz::Walk&, bool the_same) const;
  viz::Handle handle_named(const std::string& name) const;
  /// All that the page shows, after a change.
  Json frame(Drawn, const viz::Moved& = {});
  viz::Figure composed(Drawn);
  Json handles() const;
  Json time_shown() const;
  Json values() const;
  Json idle() const;
  Json place() const;
  Json parameters() const;
  Json map_beside();
  Json solved() const;
  Json lit(const std::vector<std::string>& names) const;

  std::vector<const viz::Lesson*> lessons_;
  ReadScene read_scene_;
  TakeFile take_file_;
  std::string coming_;  ///< the bytes of a file of which more is to come
  std::map<std::string, std::function<Json(const Json&)>> asked_;
  std::optional<viz::Player> player_;
  std::optional<Scene> scene_;  ///< the scene that the player is in, if any
  viz::ThemeName theme_ = viz::ThemeName::screen;
  viz::Figure figure_ = {{}, {}, viz::View({}, 1, 1)};  ///< that is shown
  viz::PaperSize size_;                                 ///< its own
  std::set<std::string> names_;                         ///< of the walk, that can be lit
  std::optional<Held> held_;
  bool with_map_ = false;
  viz::MapBeside map_;
  std::optional<viz::Box2> plane_;      ///< of the map that is shown
  std::optional<viz::Vec2> map_start_;  ///< while it is dragged over
};

}  // namespace isect::web
