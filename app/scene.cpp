// isect scene: objects of one's own, and the exact answers about them.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <memory>

#include "app/options.h"
#include "app/program.h"
#include "app/scene/file.h"
#include "app/scene/lesson.h"
#include "app/scene/save.h"
#include "app/terminal.h"
#include "viz/files.h"

namespace isect::program {

namespace {

namespace fs = std::filesystem;

struct SceneOptions {
  std::string path, save;
  Selection asked;
  bool json = false;
};

/// Writes over the scene itself, and over nothing else.
void save(const SceneOptions& options, const std::string& text, const scene::File& file, const viz::Parameters& to) {
  std::error_code absent;
  if (fs::exists(options.save, absent) && !fs::equivalent(options.save, options.path, absent))
    throw viz::FileError(
        fmt::format("cannot write '{}': there is a file; give another name, or the scene's own", options.save));
  viz::write_file(options.save, scene::with_numbers(text, file, to));
}

int tell(const SceneOptions& options) {
  try {
    const std::string text = viz::read_file(options.path), folder = fs::path(options.path).parent_path().string();
    scene::File file = scene::read_scene(text, folder);
    const viz::Lesson lesson = scene::lesson_of(text, folder);  // refuses what has no shape, asked about or not
    const viz::Parameters to = changed(lesson, file.parameters, options.asked.changes);
    if (!options.save.empty()) save(options, text, file, to);
    file.parameters = to;
    const scene::Json all = scene::answers(file);
    if (options.json) {
      print(all.dump(2) + "\n");
      return done;
    }
    for (const scene::Json& answer : all) print(answer["verdict"].get<std::string>() + "\n");
    if (!file.not_asked.empty())
      say(fmt::format("not asked, as there is no test of such pairs: {}", fmt::join(file.not_asked, ", ")));
    else if (all.empty())
      say(fmt::format("{}: nothing is asked; add \"ask\": \"all pairs\", say", options.path));
    return done;
  } catch (const viz::BadInput& e) {
    throw viz::BadInput(fmt::format("{}: {}", options.path, e.what()));
  }
}

}  // namespace

void add_scene(CLI::App& app, Program& program) {
  CLI::App& sub = *app.add_subcommand("scene", "objects of one's own, and the exact answers about them");
  const auto options = std::make_shared<SceneOptions>();
  sub.add_option("FILE", options->path, "a scene, as JSON; comments are allowed")
      ->required()
      ->type_name("")
      ->check(not_empty());
  sub.add_flag("--json", options->json, "the answers with the queries behind them, as JSON");
  add_set(sub, options->asked);
  sub.add_option("--save", options->save,
                 "write the scene with these numbers, all else as it is: the scene's own file, or\na new one")
      ->type_name("FILE")
      ->check(not_empty());
  sub.footer(
      "A scene:\n"
      "  {\"title\": \"A ray past a box\",\n"
      "   \"objects\": [{\"ray\": \"r\", \"origin\": [-4, 0, 1], \"dir\": [1, 0, 0]},\n"
      "               {\"box\": \"A\", \"lo\": [-1, -1, -1], \"hi\": [1, 1, 1]}],\n"
      "   \"ask\": [[\"r\", \"A\"], {\"first hit\": \"r\"}]}\n"
      "Objects, with two coordinates or with three (what stands in brackets may be left out). A name has 1 to 16\n"
      "letters a to z, A to Z and digits, a letter first; y points up.\n"
      "  point at           segment from to      ray origin dir [tmin] [tmax]\n"
      "  line origin dir    plane normal d       sphere (or circle) center radius\n"
      "  box lo hi          obb center u v [w] half\n"
      "  capsule p q r      triangle points      polygon points (or rings, for holes)\n"
      "  kdop normals lo hi (lists)              hull points (or file)\n"
      "  cloud points (or file, .csv)            mesh file (.obj, .stl, .ply; or points triangles)\n"
      "  frustum eye forward up angle [aspect] near far\n"
      "A plane is where normal . x + d = 0. An obb reaches from center as far as half tells along u, v and, in space,\n"
      "w: axes of length 1 at right angles. angle is in degrees, from bottom to top.\n"
      "Numbers are decided exactly as the doubles nearest to them: 0.1 + 0.2 lies above 0.3. Where objects are to\n"
      "touch, write halves, quarters or whole numbers.\n"
      "Questions: two names; {\"first hit\": \"r\"}; {\"fit\": \"M\"} with \"volume\": sphere, box, obb, kdop or hull, "
      "or\n"
      "all five; {\"clip\": \"r\", \"to\": \"A\"}; {\"hierarchy\": \"M\"}, or [\"A\", \"B\"], or \"all\"; {\"walk\": "
      "[\"r\", \"S\"]},\n"
      "step by step as in the usual lesson, or with \"lesson\": \"convex-polygon\" in that one; {\"walk\": \"H\"} of "
      "points.\n"
      "\"ask\" may be \"all pairs\".\n"
      "\"notes\": [{\"at\": [0, 2, 0], \"text\": \"*h*\"}] and \"camera\": {\"azimuth\": 30, \"elevation\": 20} may "
      "follow.\n"
      "A lesson takes a scene's objects, too: show crossings --scene mine.json.\n"
      "Whatever takes a preset's file takes a scene: show, render, strip, explain, handout, deck, check --dir.\n"
      "Of \"all pairs\" those that no test is for are named and passed over.\n"
      "With --set, as in A.radius=2, the answers are those of other numbers; --save writes them into the file.\n"
      "Example: isect scene mine.json && isect render mine.json --format pdf --width 8cm");
  sub.callback([&program, options] { program.chosen = [options] { return tell(*options); }; });
}

}  // namespace isect::program
