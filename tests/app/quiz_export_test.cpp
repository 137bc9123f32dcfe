// isect quiz --format and isect book --scorm as a user runs them: which files, what stands in them, what stays as it
// was, and what is refused.

#include <filesystem>

#include "lessons/lessons.h"
#include "tests/app/readers/gift.h"
#include "tests/app/readers/h5p.h"
#include "tests/app/readers/qti.h"
#include "tests/app/shell.h"
#include "tests/catch.h"
#include "viz/formats/files.h"
#include "viz/player/reader_state.h"
#include "viz/walk/review.h"

namespace quiz_export_test {
namespace fs = std::filesystem;
namespace viz = isect::viz;
using namespace isect::test;
using Catch::Matchers::StartsWith;

namespace {

const std::vector<std::string> files = {"quiz.moodle.xml", "quiz.gift.txt", "quiz.qti.zip", "quiz.h5p"};

/// What the four files of a folder hold, read in the order of `files`.
std::vector<std::vector<ReadQuestion>> read_all(const fs::path& folder) {
  std::string category;
  std::vector<ReadQuestion> qti;
  for (const QtiItem& item : read_qti(unzipped(contents(folder / files[2])))) qti.push_back(item.read);
  return {read_moodle(contents(folder / files[0]), category), read_gift(contents(folder / files[1]), category), qti,
          read_h5p(unzipped(contents(folder / files[3])))};
}

std::set<std::string> ids_of(const std::vector<ReadQuestion>& questions) {
  std::set<std::string> ids;
  for (const ReadQuestion& q : questions) ids.insert(q.id);
  return ids;
}

int asking_steps(const std::string& lesson, const std::string& preset) {
  const viz::Lesson& found = viz::lesson_named(isect::lessons::all_lessons(), lesson);
  const viz::Walk walk = found.walk(viz::preset(found, preset).parameters);
  return static_cast<int>(
      std::ranges::count_if(walk.steps, [](const viz::Step& step) { return step.question.has_value(); }));
}

}  // namespace

TEST_CASE("a quiz goes out in each format, with pictures that do not name the setting", "[quiz]") {
  const Shell shell;
  const std::string command = "isect quiz ray-sphere --preset tangent --format moodle,gift,qti,h5p";
  const Ran r = shell(command);
  CHECK(r.err.empty());
  REQUIRE(r.status == 0);
  const std::string folder = "quizzes/ray-sphere/tangent/";
  std::string wanted;
  for (const std::string& file : files) wanted += folder + file + "\n";
  CHECK(r.out == wanted);
  CHECK_FALSE(fs::exists(shell.work() / folder / "quiz.tex"));
  const auto all = read_all(shell.work() / folder);
  for (const std::vector<ReadQuestion>& questions : all) {
    REQUIRE(static_cast<int>(questions.size()) == asking_steps("ray-sphere", "tangent"));
    int pictures = 0;
    for (const ReadQuestion& q : questions) {
      INFO(q.title);
      CHECK_THAT(q.title, StartsWith("Ray and sphere: question ") && !Contains("tangent"));
      CHECK_THAT(q.words, StartsWith("Given ") && !Contains("tangent"));
      if (q.png.empty()) continue;
      ++pictures;
      CHECK_THAT(q.alt, StartsWith("Drawn: "));
      const viz::Picture picture = viz::read_png(q.png);
      CHECK(picture.width > 500);  // twice as fine as it is shown
      CHECK_FALSE(viz::png_metadata(q.png).contains("preset"));
      CHECK_THAT(q.png, !Contains("tangent"));
    }
    CHECK(pictures >= 2);
  }
  for (std::size_t i = 0; i < all[0].size(); ++i)
    for (std::size_t k = 1; k < all.size(); ++k) CHECK(all[k][i].png == all[0][i].png);
  CHECK(ids_of(all[0]) == ids_of(all[1]));
  CHECK(ids_of(all[0]) == ids_of(all[2]));
  CHECK(all[0].front().id.starts_with("isect.ray-sphere.tangent."));
  for (const std::size_t zip : {2u, 3u})  // by another program, too
    CHECK_THAT(shell("python3 -m zipfile -t " + folder + files[zip]).out, Contains("Done testing"));

  std::vector<std::string> before;
  for (const std::string& file : files) before.push_back(contents(shell.work() / folder / file));
  REQUIRE(shell("TZ=Asia/Kolkata " + command).out == wanted);  // over its own files, with the same bytes
  for (std::size_t i = 0; i < files.size(); ++i) CHECK(contents(shell.work() / folder / files[i]) == before[i]);
  CHECK(shell("ray-sphere quiz --preset tangent --format qti --out one").out ==
        "one/ray-sphere/tangent/quiz.qti.zip\n");
  CHECK(contents(shell.work() / "one/ray-sphere/tangent/quiz.qti.zip") == before[2]);
}

TEST_CASE("a quiz of all presets has each question once, under the lesson's name", "[quiz]") {
  const Shell shell;
  REQUIRE(shell("isect quiz points --preset all --format gift,moodle").out ==
          "quizzes/points/quiz.gift.txt\nquizzes/points/quiz.moodle.xml\n");
  std::string category;
  const std::vector<ReadQuestion> all = read_gift(contents(shell.work() / "quizzes/points/quiz.gift.txt"), category);
  int wanted = 0;
  const viz::Lesson& lesson = viz::lesson_named(isect::lessons::all_lessons(), "points");
  for (const viz::Preset& preset : lesson.presets) wanted += asking_steps("points", preset.id);
  CHECK(static_cast<int>(all.size()) == wanted);
  CHECK(ids_of(all).size() == all.size());
  CHECK(category == "$course$/top/isect/points");
  CHECK_THAT(all.back().title, Contains("question " + std::to_string(wanted)));
  const Ran paper = shell("isect quiz points --preset all");
  CHECK(paper.status == 2);
  CHECK_THAT(paper.err, StartsWith("isect: preset: \"all\" is not for paper"));
}

TEST_CASE("a playlist's quiz goes out with its questions numbered through, and paper beside it", "[quiz][playlist]") {
  const Shell shell;
  write(shell.work() / "hour.json", R"({"title": "Rays & balls", "stops": [
    {"lesson": "ray-sphere", "preset": "tangent", "steps": "3-6"}, {"lesson": "ray-sphere", "preset": "miss"}]})");
  REQUIRE(shell("isect quiz hour.json --format paper,moodle,gift,qti,h5p").out ==
          "quizzes/hour/quiz.tex\nquizzes/hour/quiz.html\nquizzes/hour/quiz.moodle.xml\nquizzes/hour/quiz.gift.txt\n"
          "quizzes/hour/quiz.qti.zip\nquizzes/hour/quiz.h5p\n");
  for (const std::vector<ReadQuestion>& questions : read_all(shell.work() / "quizzes/hour")) {
    for (std::size_t i = 0; i < questions.size(); ++i)
      CHECK(questions[i].title == "Rays & balls: question " + std::to_string(i + 1));
    CHECK(ids_of(questions).size() == questions.size());
    CHECK(questions.size() > 4);
  }
}

TEST_CASE("files of a quiz that somebody else made, or has edited, stay as they were", "[quiz]") {
  const Shell shell;
  const viz::Lesson& lesson = viz::lesson_named(isect::lessons::all_lessons(), "points");
  const std::string preset = lesson.presets.front().id, place = "quizzes/points/" + preset + "/";
  for (const std::string& file : files) {
    INFO(file);
    const fs::path mine = shell.work() / place / file;
    write(mine, "mine");
    const Ran r = shell("isect quiz points --format moodle,gift,qti,h5p");
    CHECK(r.status == 4);
    CHECK(r.out.empty());
    CHECK_THAT(r.err, Contains(file) && Contains("--out"));
    CHECK(contents(mine) == "mine");
    CHECK(files_in(shell.work()).size() == 1);
    fs::remove(mine);
  }
  REQUIRE(shell("isect quiz points --format gift,qti").status == 0);
  const fs::path gift = shell.work() / place / "quiz.gift.txt", qti = shell.work() / place / "quiz.qti.zip";
  const std::string edited = contents(gift) + "// a note of mine\n", packed = "x" + contents(qti);
  write(gift, edited), write(qti, packed);
  const Ran r = shell("isect quiz points --format gift,qti --theme grey");
  CHECK(r.status == 0);
  CHECK(r.out.empty());
  CHECK(count(r.err, "left alone: " + place) == 2);
  CHECK(contents(gift) == edited);
  CHECK(contents(qti) == packed);
}

TEST_CASE("a format that a quiz does not have is refused with those that it has", "[quiz]") {
  const Shell shell;
  const auto refused = [&](const std::string& words, const std::string& why) {
    const Ran r = shell("isect quiz " + words);
    INFO(words);
    CHECK(r.status == 2);
    CHECK(r.out.empty());
    CHECK_THAT(r.err, StartsWith("isect: ") && Contains(why));
    CHECK(files_in(shell.work()).empty());
  };
  refused("ray-sphere --format moodel", "mean \"moodle\"");
  refused("ray-sphere --format gift,", "format: \"\"");
  refused("ray-sphere --format docx", "h5p");
  refused("ray-sphere --format scorm", "book LESSON --scorm");
  refused("ray-sphere --step 1 --format gift", "asks a question");
  refused("ray-sphere --format gift --theme dark", "white pages");
  refused("ray-sphere --format gift --width 8", "width: ");
  const std::string help = shell("isect quiz --help").out;
  for (const char* word : {"moodle", "gift", "qti", "h5p", "--scorm", "tolerances", "keeps its id"})
    CHECK_THAT(help, Contains(word));
}

TEST_CASE("a lesson's page goes out as a SCORM package, the same each time, over its own file only", "[quiz][book]") {
  const Shell shell;
  const Ran r = shell("isect book ray-sphere --scorm --out site");
  CHECK(r.err.empty());
  REQUIRE(r.out == "site/ray-sphere.scorm.zip\n");
  const fs::path file = shell.work() / "site/ray-sphere.scorm.zip";
  CHECK(files_in(shell.work()) == std::vector<std::string>{"site/ray-sphere.scorm.zip"});
  const std::string bytes = contents(file);
  const auto held = unzipped(bytes);
  REQUIRE(held.size() == 2);
  const std::string& page = held.at("ray-sphere.html");
  CHECK_THAT(held.at("imsmanifest.xml"), Contains("adlcp:scormtype=\"sco\" href=\"ray-sphere.html\""));
  CHECK_THAT(shell("python3 -m zipfile -t site/ray-sphere.scorm.zip").out, Contains("Done testing"));

  // The page reports its questions, each once. A page that is in no package reports none.
  const std::vector<std::string> told = all_between(page, " data-scorm=\"");
  REQUIRE(told.size() == 1);
  std::set<std::string> names, wanted;
  for (std::size_t from = 0; from < told[0].size();) {
    const std::size_t end = std::min(told[0].find(' ', from), told[0].size());
    CHECK(names.insert(told[0].substr(from, end - from)).second);
    from = end + 1;
  }
  for (const viz::ReviewPrompt& prompt :
       viz::prompts_of(viz::lesson_named(isect::lessons::all_lessons(), "ray-sphere")))
    wanted.insert(prompt.question);
  CHECK(names == wanted);
  for (const std::string& asked : all_between(page, " data-asked=\""))
    CHECK(names.contains(asked.substr(asked.find(' ') + 1)));
  CHECK_THAT(page, Contains("LMSInitialize") && Contains("<body data-lesson=\"ray-sphere\" data-scorm=\""));
  REQUIRE(shell("isect book ray-sphere --single --out alone").status == 0);
  CHECK_THAT(contents(shell.work() / "alone/ray-sphere.html"), !Contains(" data-scorm=\""));

  REQUIRE(shell("TZ=Pacific/Kiritimati isect book ray-sphere --scorm --out site").status == 0);
  CHECK(contents(file) == bytes);
  write(file, "x" + bytes);
  const Ran edited = shell("isect book ray-sphere --scorm --out site");
  CHECK(edited.status == 0);
  CHECK_THAT(edited.err, Contains("left alone: site/ray-sphere.scorm.zip was edited"));
  CHECK(contents(file) == "x" + bytes);
  write(file, "mine");
  const Ran foreign = shell("isect book ray-sphere --scorm --out site");
  CHECK(foreign.status == 4);
  CHECK(contents(file) == "mine");

  for (const std::string words : {"--scorm", "--scorm --playlist hour.json ray-sphere"}) {
    const Ran refused = shell("isect book " + words);
    INFO(words);
    CHECK(refused.status == 2);
    CHECK_THAT(refused.err, Contains("--scorm"));
  }
}

}  // namespace quiz_export_test
