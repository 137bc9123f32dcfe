#include "app/shell/options.h"

#include <algorithm>

#include "app/scene/walks.h"
#include "viz/lang/language.h"
#include "viz/text/spelling.h"

namespace isect::program {

void add_lesson(CLI::App& sub, const Program& program, Selection& to, Takes takes, const std::string& help) {
  if (program.only) return;
  CLI::Option* lesson = sub.add_option("LESSON", to.lessons, help)->type_name("");
  if (takes == Takes::one) lesson->expected(0, 1);
}

void add_preset(CLI::App& sub, Selection& to, Takes takes, const std::string& help) {
  if (takes == Takes::one)
    sub.add_option("--preset", to.preset, help)->type_name("NAME|FILE")->check(not_empty());
  else
    sub.add_option("--preset", to.presets, help)->type_name("NAME|FILE,...")->allow_extra_args(false);
}

void add_step(CLI::App& sub, Selection& to, Takes takes, const std::string& help) {
  sub.add_option("--step", to.step, help)->type_name(takes == Takes::one ? "N|NAME" : "N|A-B|NAME|all");
}

void add_scene_file(CLI::App& sub, const Program& program, Selection& to, Takes takes) {
  if (program.only) return;
  constexpr std::size_t widest = 60;
  std::string help = "the lesson on the objects of a scene's file; those that take\nsome: ", row = "some: ";
  for (const std::string& id : scene::walking_lessons()) {
    if (row.size() + id.size() + 2 > widest) help += "\n", row.clear();
    help += id + ", ", row += id + ", ";
  }
  help.resize(help.size() - 2);
  help += ".\nIn collision and hierarchy --preset chooses the method";
  CLI::Option* scene = takes == Takes::one
                           ? sub.add_option("--scene", to.scene, help)->type_name("FILE")
                           : sub.add_option("--scene", to.scenes, help)->type_name("FILE,...")->allow_extra_args(false);
  scene->check(not_empty());
}

void note_order(const CLI::App& sub, Selection& to) {
  const auto place = [&](const char* name) {
    return std::ranges::find(sub.parse_order(), sub.get_option_no_throw(name)) - sub.parse_order().begin();
  };
  to.presets_first = place("--preset") < place("LESSON");
}

void add_set(CLI::App& sub, Selection& to) {
  sub.add_option("--set", to.changes, "change a parameter; may be repeated")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
}

void add_answers(CLI::App& sub, Selection& to) {
  sub.add_option("--answers", to.answers,
                 "of a scene: hidden draws its questions alone, as an exercise\nsheet; shown tells them, too")
      ->type_name("WORD");
}

void add_language(CLI::App& sub, Selection& to) {
  std::string codes;
  for (const viz::Language& language : viz::languages()) codes += (codes.empty() ? "" : ", ") + language.code;
  sub.add_option("--lang", to.lang, "the language of what isect says: " + codes + ".\n`isect lang` lists what each has")
      ->type_name("CODE")
      ->check(not_empty());
}

CLI::Validator not_empty() {
  const auto complaint = [](const std::string& value) { return value.empty() ? "empty; give a name" : ""; };
  return {complaint, ""};
}

CLI::Option* add_path(CLI::App& sub, const std::string& name, std::string& to, const std::string& help,
                      const std::string& type) {
  return sub.add_option(name, to, help)->type_name(type)->check(not_empty());
}

}  // namespace isect::program
