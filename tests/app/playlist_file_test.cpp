// Playlists: what their files say, every error by file, stop, line and field, and what the program does with them.

#include "app/playlist_file.h"

#include <filesystem>
#include <optional>

#include "app/preset_folder.h"
#include "lessons/lessons.h"
#include "tests/app/shell.h"
#include "tests/catch.h"
#include "viz/formats/files.h"
#include "viz/player/player.h"

namespace playlist_file_test {
namespace fs = std::filesystem;
namespace viz = isect::viz;
namespace program = isect::program;
using namespace isect::test;
using Catch::Matchers::StartsWith;

namespace {

const program::Program& isect_program() {
  static const program::Program whole = {"isect", isect::lessons::all_lessons()};
  return whole;
}

constexpr const char* a_scene = R"({"objects": [{"sphere": "A", "center": [0, 0], "radius": 2},
             {"point": "p", "at": [1, 1]}], "ask": [["p", "A"]]})";

/// Writes stops, one a line from the third on, and returns the file.
std::string file_of(const Shell& shell, const std::string& stops) {
  const fs::path file = shell.work() / "hour.json";
  write(file, "{\"title\": \"An hour\",  // of the course\n \"stops\": [\n" + stops + "\n]}\n");
  return file.string();
}

viz::Playlist read(const Shell& shell, const std::string& stops) {
  return program::read_playlist(isect_program(), file_of(shell, stops));
}

/// Returns why a playlist's file is refused.
std::string refusal(const std::string& file) {
  try {
    program::read_playlist(isect_program(), file);
  } catch (const viz::BadInput& e) {
    return e.what();
  } catch (const viz::FileError& e) {
    return e.what();
  }
  return "it is accepted";
}

int steps_in(const viz::Playlist& list) {
  int steps = 0;
  for (const viz::Stop& stop : list.stops) steps += static_cast<int>(stop.steps.size());
  return steps;
}

}  // namespace

TEST_CASE("a playlist names presets, preset files and scenes, each with its steps", "[playlist]") {
  const Shell shell;
  write(shell.work() / "mine/grazing.json", R"({"lesson": "ray-sphere", "preset": "tangent", "step": 4})");
  write(shell.work() / "disc.json", a_scene);
  const viz::Playlist list =
      read(shell, R"({"lesson": "ray-sphere", "preset": "miss", "steps": "3-6", "note": "*Why*?"},
    {"lesson": "rays"},
    {"preset": "mine/grazing.json"},
    {"preset": "mine/grazing.json", "steps": "passes-by,verdict"},
    {"scene": "disc.json"},
    {"scene": "./disc.json", "steps": -1},
    {"lesson": "ray-sphere", "steps": 2, "parameters": {"radius": 1.25}})");
  CHECK(list.title == "An hour");
  CHECK(list.file == (shell.work() / "hour.json").string());
  REQUIRE(list.stops.size() == 7);
  const std::vector<viz::Stop>& s = list.stops;

  CHECK((s[0].lesson->id == "ray-sphere" && s[0].name == "miss" && s[0].note == "*Why*?"));
  CHECK(s[0].steps == std::vector<int>{2, 3, 4, 5});
  CHECK((s[0].state.step == 2 && !s[0].whole && !s[0].asks));
  CHECK((s[1].whole && s[1].state.preset == s[1].lesson->presets.front().id && s[1].state.step == 0));
  CHECK((s[2].name == "grazing" && s[2].steps == std::vector<int>{3} && s[2].asks));
  CHECK(s[3].steps == std::vector<int>{5, 10});
  CHECK((s[4].whole && s[4].name == "disc" && s[4].lesson->id == "scene" && s[4].steps.size() >= 2));
  CHECK(s[5].lesson == s[4].lesson);
  CHECK(s[5].steps == std::vector<int>{s[4].steps.back()});
  CHECK((s[6].name.empty() && std::get<double>(s[6].state.parameters->at("radius")) == 1.25));

  const std::vector<program::Excerpt> all = program::excerpts_of(list);
  REQUIRE(all.size() == 7);
  CHECK((all[0].folder == "miss" && all[0].preset == "miss" && all[0].steps == s[0].steps));
  CHECK((all[2].folder == "grazing" && all[2].preset == "tangent"));
  CHECK((all[6].folder == "stop-7" && all[6].preset.empty()));
  for (const program::Excerpt& e : all)
    for (const int step : e.steps) CHECK(step < static_cast<int>(e.walk.steps.size()));
}

TEST_CASE("a copied state with a time is a stop whose step is drawn at it", "[playlist]") {
  const Shell shell;
  viz::Player player(isect::lessons::all_lessons());
  player.go({"moving-bodies", "boxes-meet", 7});
  player.set_time(0.75);
  const std::string copied = viz::to_json(player.reader_state());
  const auto with = [&](const std::string& steps) {
    return copied.substr(0, copied.rfind('}')) + ", \"steps\": \"" + steps + "\"}";
  };
  const viz::Playlist list = read(shell, copied + ", " + with("7-9") + ", " + with("1-2"));
  REQUIRE(list.stops.size() == 3);
  CHECK((list.stops[0].timed == 7 && list.stops[0].state.time == 0.75));
  CHECK((list.stops[1].timed == 7 && list.stops[1].state.step == 6 && list.stops[1].state.time == 0.75));
  CHECK_FALSE((list.stops[2].timed || list.stops[2].state.time));  // another step's
  const std::vector<program::Excerpt> all = program::excerpts_of(list);
  for (const std::size_t i : {0, 1}) CHECK(all[i].walk.steps[7].scene.time->now == 0.75);
  CHECK(all[2].walk.steps[7].scene.time->now == 0);

  const std::string wrong = R"({"lesson": "moving-bodies", "preset": "boxes-meet", "step": 8, "time": 3})";
  CHECK_THAT(refusal(file_of(shell, wrong)), Contains("stop 1, line 3: time: 3") && Contains("from 0 to 2"));
}

TEST_CASE("what Ctrl+C copies in the window is a stop: its step, or those that are named", "[playlist]") {
  const Shell shell;
  viz::Player player(isect::lessons::all_lessons());
  player.open(viz::lesson_named(player.lessons(), "ray-sphere"));
  player.edit("radius", 1.125);
  player.go_to(3);
  const std::string copied = viz::to_json(player.reader_state());
  const viz::Playlist list =
      read(shell, copied + ", " + copied.substr(0, copied.rfind('}')) + ", \"steps\": \"1-2\", \"note\": \"Again\"}");
  REQUIRE(list.stops.size() == 2);
  CHECK(list.stops[0].steps == std::vector<int>{3});
  CHECK(list.stops[1].steps == std::vector<int>{0, 1});
  for (const viz::Stop& stop : list.stops) {
    CHECK(*stop.state.parameters == player.parameters());
    CHECK(stop.state.camera.has_value());
  }
}

TEST_CASE("each wrong stop is refused by its file, number, line and field, with what is allowed", "[playlist]") {
  const Shell shell;
  write(shell.work() / "disc.json", a_scene);
  write(shell.work() / "bad.json", "{\"objects\": [\n {\"sphere\": \"A\", \"center\": [0, 0]}]}");
  write(shell.work() / "mine.json", R"({"lesson": "ray-spere"})");
  struct Wrong {
    const char *stop, *field, *hint;
  };
  const std::vector<Wrong> all = {
      {"7", "7 is no stop", "\"lesson\": \"ray-sphere\""},
      {"{}", "lesson: missing", "a scene's file"},
      {R"({"preset": "tangent"})", "lesson: missing", "NAME.json"},
      {R"({"lesson": "ray-spere"})", "lesson: \"ray-spere\"", "\"ray-sphere\""},
      {R"({"lesson": 3})", "lesson: 3", "give a text"},
      {R"({"lesson": "ray-sphere", "preset": "tangnt"})", "preset: \"tangnt\"", "\"tangent\""},
      {R"({"lesson": "ray-sphere", "stepps": "1"})", "field of a stop: \"stepps\"", "\"step"},
      {R"({"lesson": "ray-sphere", "steps": "99"})", "steps: \"99\"", "two-roots has steps 1 to 13"},
      {R"({"lesson": "ray-sphere", "steps": 0})", "steps: \"0\"", "1 to 13"},
      {R"({"lesson": "ray-sphere", "steps": "1,pases-by"})", "steps: \"pases-by\"", "\"passes-by\""},
      {R"({"lesson": "ray-sphere", "steps": ""})", "steps: \"\"", "1 to 13"},
      {R"({"lesson": "ray-sphere", "steps": [1]})", "steps: [1]", "give a text"},
      {R"({"lesson": "ray-sphere", "step": 99})", "step: 99", "from 1 to 13"},
      {R"({"lesson": "ray-sphere", "note": 5})", "note: 5", "give a text"},
      {R"({"lesson": "ray-sphere", "parameters": {"radius": -1}})", "radius", "0 to"},
      {R"({"lesson": "ray-sphere", "camera": {"azimut": 1}})", "azimut", "azimuth"},
      {R"({"lesson": "ray-sphere", "beside": {"method": "hanes"}})", "beside method", "haines"},
      {R"({"scene": "gone.json"})", "scene: ", "gone.json"},
      {R"({"scene": ""})", "scene: \"\"", "no file's name"},
      {R"({"scene": 1})", "scene: 1", "give a text"},
      {R"({"scene": "bad.json"})", "bad.json: line 2", "radius"},
      {R"({"scene": "disc.json", "steps": "9"})", "steps: \"9\"", "disc has steps 1 to"},
      {R"({"scene": "disc.json", "lesson": "rays"})", "field of a stop with a scene: \"lesson\"", "scene, steps, note"},
      {R"({"preset": "gone.json"})", "preset: ", "gone.json"},
      {R"({"preset": "mine.json"})", "mine.json: lesson: \"ray-spere\"", "\"ray-sphere\""},
      {R"({"preset": "mine.json", "lesson": "ray-sphere"})", "\"lesson\"", "preset, steps, note"},
      {R"({"preset": "disc.json"})", "disc.json: it is a scene", "\"scene\""},
  };
  for (const Wrong& w : all) {
    INFO(w.stop);
    const std::string file = file_of(shell, std::string("{\"lesson\": \"rays\"},\n") + w.stop);
    CHECK_THAT(refusal(file), StartsWith(file + ": stop 2, line 4: ") && Contains(w.field) && Contains(w.hint));
    const viz::Playlist kept = program::read_playlist(isect_program(), file, program::Faults::kept);
    REQUIRE(kept.stops.size() == 2);
    CHECK(kept.stops[0].fault.empty());
    CHECK(file + ": " + kept.stops[1].fault == refusal(file));
    CHECK(kept.stops[1].lesson == nullptr);
    CHECK(program::excerpts_of(kept).size() == 1);
  }
}

TEST_CASE("the line of a wrong field is that of the field", "[playlist]") {
  const Shell shell;
  const std::string file = file_of(shell, "{\"lesson\": \"ray-sphere\",\n /* of\n two */ \"steps\": \"99\"}");
  CHECK_THAT(refusal(file), Contains("stop 1, line 5: steps: "));
}

TEST_CASE("a file that is no playlist is refused with its line", "[playlist]") {
  const Shell shell;
  const fs::path file = shell.work() / "hour.json";
  const auto why = [&](const std::string& text) {
    write(file, text);
    return refusal(file.string());
  };
  CHECK_THAT(why("{\"stops\": [\n {\"lesson\": \"rays\"},\n]}"), Contains("hour.json: line 3, column 1: no JSON"));
  CHECK_THAT(why("{\"stops\": []}"), Contains("line 1: stops: a list of 1 to 1000 stops is expected"));
  CHECK_THAT(why("{\"stops\": {}}"), Contains("line 1: stops: a list"));
  CHECK_THAT(why("{\"title\": \"T\"}"), Contains("\"stops\" is missing"));
  CHECK_THAT(why("{\"tilte\": \"T\", \"stops\": []}"), Contains("tilte: unknown") && Contains("\"title\""));
  CHECK_THAT(why("{\"title\": 5, \"stops\": [{}]}"), Contains("title: a text is expected"));
  CHECK_THAT(why("{\"stops\": [], \"stops\": []}"), Contains("it is given twice"));
  CHECK_THAT(refusal((shell.work() / "gone.json").string()), Contains("gone.json"));
}

TEST_CASE("a playlist is told from presets, scenes and other files", "[playlist]") {
  CHECK(program::is_playlist("{\"stops\": []}"));
  CHECK(program::is_playlist("// an hour\n{\"title\": \"T\", \"stops\": [ {"));
  for (const char* other : {"", "7", "[{\"stops\": []}]", a_scene, "{\"lesson\": \"rays\"}", "{\"a\": {\"stops\": []}}",
                            "{\"lesson\": \"rays\", \"stops\": []}"})
    CHECK_FALSE(program::is_playlist(other));
  for (const auto& entry : fs::directory_iterator(ISECT_EXAMPLE_SCENES))
    if (entry.path().extension() == ".json") CHECK_FALSE(program::is_playlist(contents(entry.path())));

  const Shell shell;
  file_of(shell, R"({"lesson": "rays"})");
  write(shell.work() / "tangent.json", R"({"lesson": "ray-sphere", "preset": "tangent"})");
  const program::PresetFolder found = program::preset_folder(shell.work().string(), isect_program());
  CHECK((found.presets.size() == 1 && found.broken.empty()));
  CHECK(found.foreign == std::vector<std::string>{(shell.work() / "hour.json").string()});
}

TEST_CASE("the example is some twenty minutes of an hour", "[playlist]") {
  const viz::Playlist list =
      program::read_playlist(isect_program(), ISECT_EXAMPLE_SCENES "/playlists/ray-and-ball.json");
  CHECK_FALSE(list.title.empty());
  CHECK((list.stops.size() >= 12 && list.stops.size() <= 16));
  CHECK((steps_in(list) >= 40 && steps_in(list) <= 60));  // some 25 seconds each
  int scenes = 0, asking = 0, notes = 0;
  for (const viz::Stop& stop : list.stops) {
    scenes += !stop.lesson->made_from.empty(), asking += stop.asks, notes += !stop.note.empty();
  }
  CHECK((scenes >= 1 && asking >= 3 && notes >= 5));
  CHECK(program::excerpts_of(list).size() == list.stops.size());
}

TEST_CASE("the program opens a playlist, tells what it can't open of it, and refuses what makes no sense",
          "[playlist]") {
  const Shell shell;
  write(shell.work() / "disc.json", a_scene);
  const auto ran = [&](const std::string& stops, const std::string& words) {
    file_of(shell, stops);
    return shell("isect " + words);
  };
  const std::string good = R"({"lesson": "rays"}, {"scene": "disc.json"}, {"scene": "disc.json", "steps": "1"})";
  const Ran opened = ran(good, "show hour.json");
  CHECK(opened.status == 77);  // nothing is missing but a display
  CHECK_THAT(opened.err, Contains("isect handout hour.json") && !Contains("stop 1"));
  const Ran partly = ran(good + ", {\"lesson\": \"ray\"}", "show hour.json");
  CHECK(partly.status == 77);
  CHECK_THAT(partly.err, Contains("isect: hour.json: stop 4, line 3: lesson: \"ray\""));

  const auto refused = [&](const std::string& stops, const std::string& words, const std::string& why) {
    const Ran r = ran(stops, words);
    INFO(words);
    CHECK(r.status == 2);
    CHECK(r.out.empty());
    CHECK_THAT(r.err, StartsWith("isect: ") && Contains(why));
  };
  refused("{}", "show hour.json", "hour.json: stop 1, line 3: lesson: missing");
  refused("{\"lesson\": \"rays\"", "show hour.json", "hour.json: line 4");
  refused(good, "show hour.json --step 3", "step: not allowed with a playlist");
  refused(good, "show hour.json --preset tangent", "preset: not allowed with a playlist");
  refused(good, "show hour.json --set radius=2", "set: not allowed with a playlist");
  refused(good, "show hour.json --scene disc.json", "scene: not allowed with a playlist");
  refused(good, "show --preset hour.json", "this is a playlist");
  refused(good, "render hour.json", "this is a playlist");
  refused(good, "explain hour.json", "this is a playlist");
  refused(good, "scene hour.json", "this is a playlist");
  const Ran help = shell("isect show --help");
  CHECK_THAT(help.out, Contains("playlist") && Contains("\"stops\"") && Contains("Page Down"));
}

}  // namespace playlist_file_test
