// isect scene: objects of one's own, and the exact answers about them.

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "app/options.h"
#include "app/program.h"
#include "app/scene/file.h"
#include "app/scene/lesson.h"
#include "app/terminal.h"
#include "viz/files.h"

namespace isect::program {

namespace {

int tell(const std::string& path, bool json) {
  try {
    const std::string text = viz::read_file(path), folder = std::filesystem::path(path).parent_path().string();
    const scene::File file = scene::read_scene(text, folder);
    static_cast<void>(scene::lesson_of(text, folder));  // refuses what has no shape, asked about or not
    const scene::Json all = scene::answers(file);
    if (json) {
      print(all.dump(2) + "\n");
      return done;
    }
    for (const scene::Json& answer : all) print(answer["verdict"].get<std::string>() + "\n");
    if (all.empty()) say(fmt::format("{}: nothing is asked; add \"ask\": \"all pairs\", say", path));
    return done;
  } catch (const viz::BadInput& e) {
    throw viz::BadInput(fmt::format("{}: {}", path, e.what()));
  }
}

}  // namespace

void add_scene(CLI::App& app, Program& program) {
  CLI::App& sub = *app.add_subcommand("scene", "objects of one's own, and the exact answers about them");
  const auto path = std::make_shared<std::string>();
  const auto json = std::make_shared<bool>(false);
  sub.add_option("FILE", *path, "a scene, as JSON; comments are allowed")
      ->required()
      ->type_name("")
      ->check(not_empty());
  sub.add_flag("--json", *json, "the answers with the queries behind them, as JSON");
  sub.footer(
      "A scene:\n"
      "  {\"title\": \"A ray past a box\",\n"
      "   \"objects\": [{\"ray\": \"r\", \"origin\": [-4, 0, 1], \"dir\": [1, 0, 0]},\n"
      "               {\"box\": \"A\", \"lo\": [-1, -1, -1], \"hi\": [1, 1, 1]}],\n"
      "   \"ask\": [[\"r\", \"A\"], {\"first hit\": \"r\"}]}\n"
      "Objects, with two coordinates or with three (what stands in brackets may be left out):\n"
      "  point at           segment from to      ray origin dir [tmin] [tmax]\n"
      "  line origin dir    plane normal d       sphere center radius\n"
      "  box lo hi          obb center u v [w] half\n"
      "  capsule p q r      triangle points      polygon points (or rings, for holes)\n"
      "  kdop normals lo hi (lists)              hull points (or file)\n"
      "  cloud points (or file, .csv)            mesh file (.obj, .stl, .ply; or points triangles)\n"
      "  frustum eye forward up angle [aspect] near far\n"
      "Questions: two names; {\"first hit\": \"r\"}; {\"fit\": \"M\"} with \"volume\": sphere, box, obb, kdop or hull, "
      "or\n"
      "all five; {\"clip\": \"r\", \"to\": \"A\"}; {\"hierarchy\": \"M\"}, or [\"A\", \"B\"], or \"all\"; {\"walk\": "
      "[\"r\", \"S\"]},\n"
      "step by step as in the lesson. \"ask\" may be \"all pairs\".\n"
      "\"notes\": [{\"at\": [0, 2, 0], \"text\": \"*h*\"}] and \"camera\": {\"azimuth\": 30, \"elevation\": 20} may "
      "follow.\n"
      "Whatever takes a preset's file takes a scene: show, render, strip, explain, handout, deck, check --dir.\n"
      "Example: isect scene mine.json && isect render mine.json --format pdf --width 8cm");
  sub.callback([&program, path, json] { program.chosen = [path, json] { return tell(*path, *json); }; });
}

}  // namespace isect::program
