// isect scene: a user's own objects, and the exact answers about them.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <memory>

#include "app/program.h"
#include "app/scene/edit.h"
#include "app/scene/file.h"
#include "app/scene/lesson.h"
#include "app/scene/markup.h"
#include "app/scene/save.h"
#include "app/scene/written.h"
#include "app/shell/named_file.h"
#include "app/shell/options.h"
#include "app/shell/terminal.h"
#include "viz/formats/files.h"
#include "viz/lang/language.h"

namespace isect::program {

namespace {

namespace fs = std::filesystem;

struct SceneOptions {
  std::string path, save;
  Selection asked;
  bool json = false;
};

/// Writes over the scene itself, and over no other file.
void save(const SceneOptions& options, const std::string& text, const scene::File& file, const viz::Parameters& to) {
  std::error_code absent;
  if (fs::exists(options.save, absent) && !fs::equivalent(options.save, options.path, absent))
    throw viz::FileError(
        fmt::format("cannot write '{}': there is a file; give another name, or the scene's own", options.save));
  viz::write_file(options.save, scene::with_numbers(text, file, to));
}

std::string verdicts(const scene::File& file) {
  std::string all;
  scene::each_answer(file, [&](const scene::Json& answer) { all += answer["verdict"].get<std::string>() + "\n"; });
  return all;
}

/// Returns a list of answers, one below the other.
std::string as_json(const scene::File& file) {
  std::string all;
  scene::each_answer(file, [&](const scene::Json& answer) {
    all += all.empty() ? "[\n  " : ",\n  ";
    for (const char c : answer.dump(2)) all += c == '\n' ? std::string("\n  ") : std::string(1, c);
  });
  return all.empty() ? "[]\n" : all + "\n]\n";
}

int tell(const SceneOptions& options) {
  try {
    scene::set_by_tex_alone(true);  // answers are told, not drawn
    const std::string text = read_named_file(options.path), folder = fs::path(options.path).parent_path().string();
    scene::File file = scene::naming_scene(options.path, [&] { return scene::read_scene(text, folder); });
    if (const std::string& code = options.asked.lang; !code.empty())
      file = scene::read_scene(scene::with_language(text, viz::language_named(code).code), folder);
    const viz::Parameters to = changed(scene::without_steps(file), file.parameters, options.asked.changes);
    scene::File asked = file;
    asked.parameters = to;
    const std::string all = [&] {
      const SaidLater busy = deciding(options.path);
      return options.json ? as_json(asked) : verdicts(asked);
    }();
    if (!options.save.empty()) save(options, text, file, to);
    for (const scene::Object& o : file.objects)
      if (!o.note.empty()) say(fmt::format("{}: {}: {}", options.path, o.name, o.note));
    print(all);
    if (all.empty()) say(fmt::format("{}: nothing is asked; add \"ask\": \"all pairs\", say", options.path));
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
  add_language(sub, options->asked);
  sub.add_option("--save", options->save,
                 "write the scene with these numbers, all else as it is: the scene's own file, or\na new one")
      ->type_name("FILE")
      ->check(not_empty());
  std::string footer = scene::how_written();
  footer +=
      "A lesson takes a scene's objects, too: show crossings --scene mine.json.\n"
      "Whatever takes a preset's file takes a scene: show, render, strip, explain, handout, deck, check --dir.\n"
      "With --set, as in A.radius=2, the answers are those of other numbers; --save writes them into the file.\n"
      "Example: isect scene mine.json && isect render mine.json --format pdf --width 8cm";
  sub.footer(footer);
  sub.callback([&program, options] { program.chosen = [options] { return tell(*options); }; });
}

}  // namespace isect::program
