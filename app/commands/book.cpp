// isect book: the lessons as a folder of web pages, which open from disk and from any web server.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "app/book/contents_page.h"
#include "app/book/fonts.h"
#include "app/book/lesson_page.h"
#include "app/book/playlist_page.h"
#include "app/book/review_page.h"
#include "app/book/scene_page.h"
#include "app/book/terms_script.h"
#include "app/figures/digest.h"
#include "app/figures/ownership.h"
#include "app/pages/pages.h"
#include "app/platforms/scorm.h"
#include "app/shell/environment.h"
#include "app/shell/options.h"
#include "app/shell/terminal.h"
#include "lessons/course.h"
#include "viz/formats/files.h"
#include "viz/player/reader_state.h"
#include "viz/walk/review.h"

namespace isect::program {

namespace {

namespace fs = std::filesystem;

struct BookOptions {
  std::string lesson, out = "book";
  std::string live, live_scenes;  ///< files with the compiled lessons
  std::vector<std::string> playlists;
  bool single = false, scorm = false;
};

/// The fonts once more, for figures that are saved: a script can't read a style sheet from disk.
constexpr const char* letters_file = "letters.js";
/// Characters that changed settings may show, in addition to those of all presets.
const std::string lesson_letters = "0123456789.,+-−()=<>≤≥≠ e";

/// How each file of WebAssembly begins.
const std::string wasm_head("\0asm\1\0\0\0", 8);

/// Returns the words as a comment in that file's language; in HTML, CSS and WebAssembly the file goes on behind it.
std::string comment(const std::string& file, const std::string& words) {
  if (file.ends_with(".wasm")) {  // a section of its own, which browsers pass over: 0, its size, a name, the words
    const std::string section = "\5isect" + words;
    return std::string(1, '\0') + static_cast<char>(section.size()) + section;  // of less than 128 bytes
  }
  if (file.ends_with(".css")) return fmt::format("/* {} */", words);
  if (file.ends_with(".js")) return fmt::format("// {}", words);
  return fmt::format("<!-- {} -->", words);
}
/// Whether a file is a package: all that says whose it is stands in its last line, its archive's comment.
bool is_package(const std::string& file) { return file.ends_with(".zip"); }
std::string first_line(const std::string& file) {
  if (is_package(file)) return {};
  return (file.ends_with(".wasm") ? wasm_head : std::string()) + comment(file, book::mark(file));
}

/// Returns the last line, which shows that nobody has edited what stands above.
std::string last_line(const std::string& file, const std::string& text) {
  const std::string told = "Digest of all above: " + digest(text);
  if (is_package(file)) return told + ". " + book::mark(file);
  const std::string line = comment(file, told);
  return file.ends_with(".wasm") ? line : "\n" + line + "\n";
}
/// Whether somebody has edited a page; one from before there were such lines counts as not edited.
bool is_edited(const std::string& file, const std::string& page) {
  const std::string line = last_line(file, "");
  const std::size_t end = page.rfind(line.substr(0, line.find(':')));
  return end != page.npos && page != page.substr(0, end) + last_line(file, page.substr(0, end));
}

/// The folder of a book: writes over isect's own pages only.
class Shelf {
 public:
  /// Throws viz::BadInput if the folder holds baselines, viz::FileError if one of the files is somebody else's.
  Shelf(const std::string& folder, const Program& program, const std::vector<std::string>& files) : folder_(folder) {
    if (const auto trace = baseline_below(folder, program))
      throw viz::BadInput(
          fmt::format("out: {} holds baselines ({}), and pages never lie among them; give another folder, such as "
                      "--out book",
                      folder, trace->string()));
    std::vector<PageFile> own;
    for (const std::string& file : files)
      own.push_back({file, is_package(file) ? book::mark(file) : first_line(file), is_package(file)});
    need_own(path(""), own);
  }

  /// Adds a file. If someone has edited it, it stays as it is, with a message.
  void add(const std::string& file, const std::string& text) {
    added_.insert(file);
    std::error_code absent;
    if (fs::is_regular_file(path(file), absent) && is_edited(file, viz::read_regular_file(path(file))))
      return say_left_alone(path(file));
    viz::write_file(path(file), text + last_line(file, text));
    print(path(file) + "\n");
  }

  /// Removes pages of lessons that no longer exist, and those of playlists that are not asked for, with their scripts.
  /// A page not under its own name stays, and so does an edited one.
  void remove_stale() const {
    std::vector<fs::path> gone;
    std::error_code absent;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_, absent)) {
      const std::string name = entry.path().filename().string();
      const bool of_playlist = name.starts_with("hour-") && name.ends_with(".js");
      if (!(name.ends_with(".html") || of_playlist) || added_.contains(name) || entry.is_symlink() ||
          !entry.is_regular_file())
        continue;
      const std::string page = viz::read_regular_file(entry.path().string());
      if (!page.starts_with(first_line(name))) continue;
      if (is_edited(name, page))
        say_left_alone(entry.path().string());
      else
        gone.push_back(entry.path());
    }
    for (const fs::path& page : gone) fs::remove(page);
  }

 private:
  std::string path(const std::string& file) const { return (fs::path(folder_) / file).string(); }

  std::string folder_;
  std::set<std::string> added_;
};

std::vector<Excerpt> all_presets(const Program& program, const viz::Lesson& lesson) {
  Selection asked;
  if (!program.only) asked.lessons = {lesson.id};
  asked.presets = {"all"};
  return excerpts(program, asked);
}

std::string style(const viz::PageColours& colours) {
  return fmt::format(
      ":root {{ color-scheme: light dark; {}}}\n@media screen and (prefers-color-scheme: dark) {{ :root {{ {}}} "
      "}}\n{}{}",
      colours.variables(false), colours.variables(true), book::style_text(), colours.rules());
}

/// What makes pages live.
struct LiveCode {
  std::string script;  ///< empty if none was given
  std::string packed;  ///< the compiled lessons as a script
  std::string wasm;    ///< the same as they are; empty if they were not beside the file
};

/// Throws viz::FileError, or viz::BadInput if the file, or the WebAssembly beside it, is something else.
LiveCode live_code(const std::string& file) {
  if (file.empty()) return {};
  const std::string code = viz::read_regular_file(file);
  const std::size_t packed = code.find("isect_module.packed = ");
  if (packed == code.npos)
    throw viz::BadInput(fmt::format("live: {} is not what web/ is compiled to; ./run book makes it", file));
  LiveCode live = {book::live_script_text() + code.substr(0, packed), code.substr(packed), {}};
  const fs::path wasm = fs::path(file).replace_extension(".wasm");
  if (std::error_code absent; !fs::is_regular_file(wasm, absent)) return live;
  live.wasm = viz::read_regular_file(wasm.string());
  if (!live.wasm.starts_with(wasm_head))
    throw viz::BadInput(fmt::format("live: {} is no WebAssembly; ./run book makes it", wasm.string()));
  return live;
}

/// Returns the files of it, with their contents behind the first line.
std::vector<std::pair<std::string, std::string>> files_of(const LiveCode& live, const std::string& script) {
  if (live.script.empty()) return {};
  std::vector<std::pair<std::string, std::string>> all = {{script, "\n" + live.script},
                                                          {book::packed_of(script), "\n" + live.packed}};
  if (!live.wasm.empty()) all.emplace_back(book::wasm_of(script), live.wasm.substr(wasm_head.size()));
  return all;
}

/// Throws viz::BadInput, also if two would have the same page, and viz::FileError.
std::vector<book::PlaylistPages> playlists_of(const Program& program, const std::vector<std::string>& paths) {
  std::vector<book::PlaylistPages> all;
  for (const std::string& path : paths) {
    all.emplace_back(program, path);
    for (std::size_t i = 0; i + 1 < all.size(); ++i)
      if (all[i].name() == all.back().name())
        throw viz::BadInput(
            fmt::format("playlist: {} and {} would both be {}; rename a file", paths[i], path, all.back().file()));
  }
  return all;
}

/// Returns the names of a lesson's questions, each once.
std::vector<std::string> question_names(const viz::Lesson& lesson) {
  std::vector<std::string> names;
  for (const viz::ReviewPrompt& prompt : viz::prompts_of(lesson))
    if (std::ranges::count(names, prompt.question) == 0) names.push_back(prompt.question);
  return names;
}

int single(const Program& program, const BookOptions& options) {
  const viz::Lesson& lesson = program.only ? *program.only : viz::lesson_named(program.lessons, options.lesson);
  const std::string file = book::file_of(lesson), package = lesson.id + ".scorm.zip";
  const LiveCode live = live_code(options.live);
  Shelf shelf(options.out, program, {options.scorm ? package : file});
  need_environment(program);
  viz::PageColours colours;
  book::Page page =
      book::lesson_page(lesson, all_presets(program, lesson), program.lessons, {nullptr, nullptr, true}, colours);
  if (options.scorm) page.reported = question_names(lesson);
  const std::string terms = book::terms_script(lessons::course(), program.lessons, true);
  const std::string html =
      first_line(file) + book::html(page, {book::fonts_text(page.body + terms + lesson_letters), style(colours),
                                           book::script_text() + terms, live.script + live.packed});
  if (!options.scorm) {
    shelf.add(file, html);
    return done;
  }
  // The archive's comment is the file's last line, which the shelf adds: it is always as long as this one.
  const std::string end = last_line(package, {});
  const std::string archive = platforms::scorm_package(lesson, {file, html + last_line(file, html)}, end);
  shelf.add(package, archive.substr(0, archive.size() - end.size()));
  return done;
}

int whole(const Program& program, const BookOptions& options) {
  std::vector<std::string> files = {"index.html", "glossary.html", "book.css", "book.js", "fonts.css"};
  const LiveCode live = live_code(options.live), live_scenes = live_code(options.live_scenes);
  const bool lives = !live.script.empty(), has_scenes = !live_scenes.script.empty();
  auto code = files_of(live, book::live_file), code_of_scenes = files_of(live_scenes, book::live_scenes_file);
  code.insert(code.end(), code_of_scenes.begin(), code_of_scenes.end());
  for (const auto& [file, text] : code) files.push_back(file);
  if (lives) files.push_back(letters_file);
  if (has_scenes) files.push_back(book::scene_file);
  for (const viz::Lesson* lesson : program.lessons) files.push_back(book::file_of(*lesson));
  for (int i = 1; i <= viz::review_count(program.lessons); ++i) files.push_back(book::review_file(i));
  const std::vector<book::PlaylistPages> playlists = playlists_of(program, options.playlists);
  for (const book::PlaylistPages& playlist : playlists)
    for (const std::string& file : playlist.files()) files.push_back(file);
  Shelf shelf(options.out, program, files);
  need_environment(program);

  const std::vector<const viz::Lesson*>& course = program.lessons;
  viz::PageColours colours;
  std::vector<Excerpt> firsts;
  book::Letters letters;
  const auto add = [&](const book::Page& page) {
    letters.add(page.body);
    shelf.add(page.file,
              first_line(page.file) +
                  book::html(page, {{}, {}, {}, (page.file == book::scene_file ? live_scenes : live).script}));
  };
  shelf.add("book.js", first_line("book.js") + "\n" + book::script_text() +
                           book::terms_script(lessons::course(), program.lessons, false));
  Progress progress(course.size());
  std::optional<book::ReviewPage> review;
  for (std::size_t i = 0; i < course.size(); ++i) {
    std::vector<Excerpt> presets = all_presets(program, *course[i]);
    const viz::Lesson* const after = i + 1 < course.size() ? course[i + 1] : nullptr;
    add(book::lesson_page(*course[i], presets, course, {i > 0 ? course[i - 1] : nullptr, after}, colours));
    if (!review) review.emplace(colours);
    review->add(*course[i], presets);
    if (const int number = viz::review_after(course, *course[i])) {
      add(review->page(number, {course[i], after}));
      review.reset();
    }
    firsts.push_back(std::move(presets.front()));
    progress.done(course[i]->id);
  }
  if (has_scenes) add(book::scene_page(colours));
  std::string links;
  for (const book::PlaylistPages& playlist : playlists) {
    links += playlist.link();
    add(playlist.page());
    for (const book::Page& page : playlist.own_pages(colours)) add(page);
    shelf.add(playlist.script_file(), first_line(playlist.script_file()) + "\n" + playlist.script());
  }
  add(book::contents_page(firsts, lessons::course(), {lives, has_scenes}, links, colours));
  add(book::glossary_page(lessons::course(), course));
  shelf.add("book.css", first_line("book.css") + "\n" + style(colours));
  letters.add(lesson_letters);
  const std::string fonts = letters.fonts();
  shelf.add("fonts.css", first_line("fonts.css") + "\n" + fonts);
  for (const auto& [file, text] : code) shelf.add(file, first_line(file) + text);
  if (lives)
    shelf.add(letters_file,
              first_line(letters_file) + "\nvar isect_letters = " + nlohmann::ordered_json(fonts).dump() + ";\n");
  shelf.remove_stale();
  return done;
}

int make_book(const Program& program, const BookOptions& options) {
  const char* alone = options.scorm ? "scorm" : "single";
  const bool single_lesson = options.single || options.scorm;
  if (single_lesson && !program.only && options.lesson.empty())
    throw viz::BadInput(
        fmt::format("{0}: one lesson in one file; name the lesson, such as isect book ray-sphere --{0}", alone));
  if (single_lesson && !options.playlists.empty())
    throw viz::BadInput(fmt::format("playlist: it leads through the pages of a whole book; leave out --{}", alone));
  if (!single_lesson && !options.lesson.empty())
    throw viz::BadInput(
        fmt::format("lesson: a book holds all lessons; for {0} alone, in one file: isect book {0} --single",
                    viz::lesson_named(program.lessons, options.lesson).id));
  return single_lesson || program.only ? single(program, options) : whole(program, options);
}

}  // namespace

void add_book(CLI::App& app, Program& program) {
  CLI::App& sub = *app.add_subcommand("book", "the lessons as web pages");
  const auto options = std::make_shared<BookOptions>();
  if (!program.only) {
    sub.add_option("LESSON", options->lesson, "with --single or --scorm: the lesson")->type_name("");
    sub.add_flag("--single", options->single, "one lesson in one file, for a learning platform");
  }
  sub.add_flag("--scorm", options->scorm, "one lesson as a SCORM 1.2 package");
  add_path(sub, "--live", options->live,
           "the compiled lessons, build/web/live.js: the pages can be dragged and changed", "FILE");
  if (!program.only)
    add_path(sub, "--live-scenes", options->live_scenes,
             "build/web/live_scenes.js: and a page for scenes of the reader's own", "FILE")
        ->needs("--live");
  if (!program.only)
    sub.add_option("--playlist", options->playlists,
                   "a page with the stops of a playlist, which leads through the\nlessons' "
                   "pages step by step; may be repeated")
        ->type_name("FILE")
        ->allow_extra_args(false)
        ->check(not_empty());
  add_path(sub, "--out", options->out, "folder; book if not given", "DIR");
  sub.footer(
      "DIR/index.html is the first page. The pages open from disk and from any web server, and need no network.\n"
      "Without scripts, and on paper, all presets stand one below the other. Files that isect did not make, or that\n"
      "someone has edited since, stay.\n"
      "With --playlist a page hour-NAME.html lists the stops of NAME.json, and each opens its steps: Page Down, N and\n"
      "the arrows go on and back from there, question by question. Scenes and settings made by hand have pages of\n"
      "their own.\n"
      "With --live what they show can be dragged and changed, too: ./run book compiles the lessons for that.\n"
      "With --scorm the file is DIR/LESSON.scorm.zip. Its page tells the learning platform a score, a status, a place\n"
      "and the time. The score is the share of the questions of all presets that were answered right the last time; a\n"
      "question that several presets ask counts once. The status is completed when a preset's last step was shown. At\n"
      "the place the reader goes on, with the answers that were given. A newer package of the same lesson has the "
      "same\n"
      "identifiers: it can replace the older one.\n"
      "Example: " +
      program.name + " book" + (program.only ? "" : " ray-sphere --single") + " --out site");
  sub.callback([&program, options] { program.chosen = [&program, options] { return make_book(program, *options); }; });
}

}  // namespace isect::program
