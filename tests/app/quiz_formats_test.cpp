// Every question of every lesson as learning platforms read it from each format: its text, its answers, the right one,
// and what is said to each, as the lesson has them. The readers share no code with the writers.

#include "app/platforms/quiz_formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <numeric>

#include "app/figures/blocks.h"
#include "app/figures/ownership.h"
#include "app/platforms/scorm.h"
#include "lessons/lessons.h"
#include "tests/app/readers/gift.h"
#include "tests/app/readers/h5p.h"
#include "tests/app/readers/qti.h"
#include "tests/catch.h"
#include "viz/text/rich_text.h"
#include "viz/walk/given_answer.h"
#include "viz/walk/given_order.h"
#include "viz/walk/pointed_line.h"
#include "viz/walk/step_text.h"
#include "viz/walk/typed_answer.h"

namespace quiz_formats_test {
namespace viz = isect::viz;
namespace platforms = isect::program::platforms;
using namespace isect::test;
using isect::program::Excerpt;
using platforms::QuizItem;
using platforms::QuizSheet;

namespace {

/// The letters of markup, without its marks.
std::string letters(const std::string& markup) {
  std::string out;
  for (const viz::Run& run : viz::parse_markup(markup)) out += run.text;
  return out;
}

/// The text without the space around each of its lines, and without empty lines.
std::string trimmed(const std::string& text) {
  std::string out, line;
  for (const char c : text + "\n") {
    if (c != '\n') {
      line += c;
      continue;
    }
    const std::size_t begin = line.find_first_not_of(' '), end = line.find_last_not_of(' ');
    if (begin != line.npos) out += line.substr(begin, end + 1 - begin) + "\n";
    line.clear();
  }
  return out;
}

/// A picture that is none, different for each question.
platforms::QuizPicture picture_for(const std::string& id) {
  return {std::string("\x89PNG\r\n\x1a\n\0", 9) + id, "Drawn: <a> & “b” of " + id, 340, 200};
}

/// A question as the lesson has it, and what a platform must read of it.
struct Wanted {
  const Excerpt* e;
  int step;
  viz::QuestionText q;
  std::string id, title, png, alt;
  const viz::Question& asked() const { return *q.asked; }
};

struct Sheet {
  Excerpt e;
  QuizSheet quiz;
  std::vector<Wanted> wanted;
};

Sheet sheet_of(const viz::Lesson& lesson, const viz::Preset& preset) {
  Sheet sheet;
  sheet.e = {&lesson, preset.id, preset.id, preset.parameters, lesson.walk(preset.parameters), {}};
  sheet.quiz = {"Questions: " + preset.id, lesson.id + "/" + preset.id, {}};
  return sheet;
}
void fill(Sheet& sheet) {
  for (int step = 0; step < static_cast<int>(sheet.e.walk.steps.size()); ++step) {
    const auto q = viz::question_text(sheet.e.walk, step);
    if (!q) continue;
    const std::string title = "A title: question " + std::to_string(q->number);
    QuizItem item = platforms::item_of(sheet.e, step, title);
    if (sheet.quiz.items.size() % 5 != 4) item.picture = picture_for(item.id);
    sheet.wanted.push_back({&sheet.e, step, *q, item.id, title, item.picture ? item.picture->png : "",
                            item.picture ? item.picture->alt : ""});
    sheet.quiz.items.push_back(item);
  }
}

/// The lines of code with their numbers, without the space before them.
std::vector<std::string> code_of(const Excerpt& e) {
  std::vector<std::string> lines;
  for (const std::string& line : isect::program::code(e).lines) {
    const std::string code = letters(line);
    const std::size_t in = std::min(code.find_first_not_of(' '), code.size());
    std::string number = std::to_string(lines.size() + 1);
    for (std::size_t i = 0; i < in + 2; ++i) number += "\u00a0";
    lines.push_back(number + code.substr(in));
  }
  return lines;
}

/// What a question says besides its answers. `typed`: the letters of an order are to be typed.
std::string words_wanted(const Wanted& w, bool typed_order, bool number) {
  std::string out = "Given " + letters(isect::program::given(*w.e->lesson, w.e->parameters, w.e->walk)) + "\n";
  if (!w.asked().line)
    for (const std::string& line : code_of(*w.e)) out += line + "\n";
  out += letters(w.q.whole_prompt) + "\n";
  if (w.asked().order && typed_order) {
    for (std::size_t i = 0; i < w.asked().order->tiles.size(); ++i)
      out += fmt::format("({}) {}\n", viz::tile_letter(static_cast<int>(i)), letters(w.asked().order->tiles[i]));
    out += "Answer with the letters in their order, without spaces.";
    if (w.q.answer.find("in any order") != std::string::npos) out += " Of equal ones, any may come first.";
    out += "\n";
  }
  if (w.asked().number && number)
    out += w.asked().number->digits == 0 ? "Answer with a whole number.\n"
                                         : fmt::format("Answer with a number {}.\n", viz::exactness(*w.asked().number));
  return trimmed(out);
}

std::string solution_wanted(const Wanted& w) {
  const bool in_words = w.asked().line || w.asked().order;
  return letters((in_words ? w.q.answer : w.q.choices.at(w.q.right) + ".") + " " + w.q.because);
}

void check_head(const Wanted& w, const ReadQuestion& read) {
  CHECK(read.title == w.title);
  CHECK(read.png == w.png);
  CHECK(read.alt == w.alt);
  CHECK(trimmed(read.solution) == trimmed(solution_wanted(w)));
}

/// The choices are the lesson's or, where it asks for a line, all lines; one of them is right, each wrong one has its
/// reply.
void check_choices(const Wanted& w, const std::vector<ReadAnswer>& answers) {
  const auto& line = w.asked().line;
  const std::vector<std::string> lines = code_of(*w.e);
  REQUIRE(answers.size() == (line ? lines.size() : w.q.choices.size()));
  for (std::size_t i = 0; i < answers.size(); ++i) {
    INFO("answer " << i + 1);
    const bool right = line ? static_cast<int>(i) == line->truth : i == w.q.right;
    CHECK(answers[i].text == (line ? lines[i] : letters(w.q.choices[i])));
    CHECK(answers[i].right == right);
    std::string reply;
    if (line) reply = viz::line_replies(w.e->walk, w.step).at(i);
    if (!line && !right) reply = viz::reply_to(w.e->walk, w.step, viz::GivenAnswer{static_cast<int>(i)});
    CHECK(answers[i].reply == letters(reply));
  }
}

/// Numbers that a reader may type: the right one and near it, all that a reply is known to, some others.
std::vector<double> numbers_to_try(const viz::Numeric& number) {
  const double truth = number.truth, off = viz::tolerance(number, truth);
  std::vector<double> all = {
      truth, truth + 0.5 * off, truth - 0.5 * off, truth + 3 * off, truth * 1.01, -truth, truth + 1, truth + 1e9, 0};
  for (const viz::WrongNumber& wrong : number.wrong) all.push_back(wrong.value);
  return all;
}

/// What a platform says to an answer: whether it is right, and the reply.
struct Said {
  bool right = false;
  std::string reply = {};
  bool operator==(const Said&) const = default;
};
Said said(const ReadAnswer* answer) { return answer ? Said{answer->right, answer->reply} : Said{}; }

template <class Judge>
void check_numbers(const viz::Numeric& number, const Judge& judge) {
  for (const double typed : numbers_to_try(number)) {
    INFO("typed " << typed);
    const Said told = judge(typed);
    CHECK(told.right == viz::is_right(number, typed));
    CHECK(told.reply == letters(viz::reply_to(number, typed)));
  }
}

/// Every order is right or wrong as the lesson says; those with a known mistake, and those offered, have their reply.
template <class Judge>
void check_orders(const viz::OrderAsked& asked, const Judge& judge) {
  std::vector<int> order(asked.tiles.size());
  std::iota(order.begin(), order.end(), 0);
  int tried = 0;
  do {
    const Said told = judge(order);
    INFO(viz::letters_of(order));
    const bool right =
        viz::first_wrong(asked, order)<0, known = std::ranges::count(asked.wrong, order, &viz::WrongOrder::order)> 0;
    if (told.right != right) CHECK(told.right == right);
    const bool has_reply = known || (!right && std::ranges::count(asked.offered, order) > 0);
    CHECK(told.reply == (has_reply ? letters(viz::reply_to(asked, order)) : ""));
  } while (std::next_permutation(order.begin(), order.end()) && ++tried < 800);
}

void check_typed(const Wanted& w, const ReadQuestion& read) {
  check_head(w, read);
  CHECK(trimmed(read.words) == words_wanted(w, true, true));
  if (w.asked().order) {
    CHECK(read.kind == "letters");
    check_orders(*w.asked().order,
                 [&](const std::vector<int>& order) { return said(read.of_letters(viz::letters_of(order))); });
  } else if (w.asked().number) {
    CHECK(read.kind == "number");
    check_numbers(*w.asked().number, [&](double typed) { return said(read.of_number(typed)); });
  } else {
    CHECK(read.kind == "choice");
    check_choices(w, read.answers);
  }
}

/// What an item of QTI says to a response.
Said said(const QtiItem& item, const std::vector<std::string>& response) {
  const QtiOutcome outcome = qti_outcome(item, response);
  CHECK((outcome.score == 0 || outcome.score == 1));
  CHECK(outcome.feedbacks.contains("SOLUTION"));
  Said told = {outcome.score == 1};
  for (const std::string& feedback : outcome.feedbacks)
    if (feedback != "SOLUTION" && item.told.contains(feedback)) told.reply += trimmed(item.told.at(feedback));
  if (!told.reply.empty()) told.reply.pop_back();
  return told;
}

void check_qti(const Wanted& w, const QtiItem& item) {
  check_head(w, item.read);
  CHECK(item.read.id == w.id);
  CHECK(trimmed(item.read.words) == words_wanted(w, false, true));
  const std::string response = item.cardinality + " " + item.type;
  const std::string by = item.xml.one("responseProcessing").at("template");
  if (!by.empty()) CHECK(by == "http://www.imsglobal.org/question/qti_v2p1/rptemplates/match_correct");
  if (w.asked().order) {
    CHECK(item.read.kind == "letters");
    CHECK(response == "ordered identifier");
    CHECK(item.correct.size() == item.choices.size());
    const auto named = [&](const std::vector<int>& order) {
      std::vector<std::string> all;
      for (const int tile : order) all.push_back(item.choices.at(static_cast<std::size_t>(tile)));
      return all;
    };
    for (std::size_t i = 0; i < item.choices.size(); ++i)
      CHECK(item.read.answers[i].text == letters(w.asked().order->tiles[i]));
    CHECK(said(item, item.correct).right);
    CHECK(by.empty() == viz::has_ties(*w.asked().order));
    check_orders(*w.asked().order, [&](const std::vector<int>& order) { return said(item, named(order)); });
    return;
  }
  REQUIRE(item.correct.size() == 1);
  if (w.asked().number) {
    CHECK(item.read.kind == "number");
    CHECK(response == "single float");
    CHECK(by.empty());
    CHECK(qti_outcome(item, {}).score == 0);
    check_numbers(*w.asked().number, [&](double typed) { return said(item, {fmt::format("{}", typed)}); });
    return;
  }
  CHECK(item.read.kind == "choice");
  CHECK(response == "single identifier");
  CHECK_FALSE(by.empty());
  std::vector<ReadAnswer> answers = item.read.answers;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const Said told = said(item, {item.choices[i]});
    answers[i].right = told.right, answers[i].reply = told.reply;
    CHECK(told.right == (item.correct.front() == item.choices[i]));  // what the template says
  }
  check_choices(w, answers);
}

void check_h5p(const Wanted& w, const ReadQuestion& read) {
  check_head(w, read);
  CHECK(trimmed(read.words) == words_wanted(w, false, false));
  check_choices(w, read.answers);
}

std::string written(const QuizSheet& sheet, const std::string& name) {
  const auto& all = platforms::quiz_formats();
  const auto format = std::ranges::find(all, name, &platforms::QuizFormat::name);
  REQUIRE(format != all.end());
  const std::string file = format->write(sheet, format->mark);
  CHECK((format->packed ? file.ends_with(format->mark) : file.starts_with(format->mark)));
  return file;
}

/// Feedback is HTML in one paragraph or none; here only its words count.
ReadQuestion in_one_line(ReadQuestion read) {
  for (ReadAnswer& answer : read.answers)
    while (answer.reply.ends_with('\n')) answer.reply.pop_back();
  return read;
}

}  // namespace

TEST_CASE("every question of every lesson is read from each format as the lesson asks and answers it", "[quiz]") {
  int questions = 0, numbers = 0, orders = 0, lines = 0;
  for (const viz::Lesson* lesson : isect::lessons::all_lessons())
    for (const viz::Preset& preset : lesson->presets) {
      Sheet sheet = sheet_of(*lesson, preset);
      fill(sheet);
      if (sheet.wanted.empty()) continue;
      std::string category;
      const std::vector<ReadQuestion> moodle = read_moodle(written(sheet.quiz, "moodle"), category);
      CHECK(category == "$course$/top/isect/" + sheet.quiz.name);
      const std::vector<ReadQuestion> gift = read_gift(written(sheet.quiz, "gift"), category);
      CHECK(category == "$course$/top/isect/" + sheet.quiz.name);
      const std::vector<QtiItem> qti = read_qti(unzipped(written(sheet.quiz, "qti")));
      const std::vector<ReadQuestion> h5p = read_h5p(unzipped(written(sheet.quiz, "h5p")));
      REQUIRE(moodle.size() == sheet.wanted.size());
      REQUIRE(gift.size() == sheet.wanted.size());
      REQUIRE(qti.size() == sheet.wanted.size());
      REQUIRE(h5p.size() == sheet.wanted.size());
      for (std::size_t i = 0; i < sheet.wanted.size(); ++i) {
        const Wanted& w = sheet.wanted[i];
        INFO(w.id << ": " << viz::plain(w.q.prompt));
        CHECK(moodle[i].id == w.id);
        CHECK(gift[i].id == w.id);
        check_typed(w, in_one_line(moodle[i]));
        check_typed(w, in_one_line(gift[i]));
        check_qti(w, qti[i]);
        check_h5p(w, h5p[i]);
        ++questions, numbers += bool(w.asked().number), orders += bool(w.asked().order), lines += bool(w.asked().line);
      }
    }
  CHECK(questions > 500);
  CHECK((numbers > 50 && orders > 5 && lines > 5));
}

namespace {

/// A question whose texts are what formats would interpret.
QuizItem hostile(const std::string& text) {
  QuizItem item;
  item.id = platforms::identifier("hostile/" + text), item.title = text + ": question 1";
  item.given = viz::as_markup(text), item.code = {viz::as_markup(text)}, item.prompt = viz::as_markup(text);
  item.choices = {{viz::as_markup(text), {}}, {viz::as_markup("no " + text), viz::as_markup(text)}};
  item.solution = viz::as_markup(text);
  item.picture = platforms::QuizPicture{"png " + text, text, 10, 20};
  return item;
}

const std::vector<std::string> attacks = {"~=#{}:\\",
                                          "a ~ b = c # d {e} f: g \\ h",
                                          "[html]x",
                                          "[markdown] *x*",
                                          "%50%half",
                                          "<b>&\"'</b><script>",
                                          "]]>",
                                          "&amp; &lt; &#60;",
                                          "::name::",
                                          "####",
                                          "-> // $CATEGORY: x",
                                          "\\n \\: \\\\",
                                          "// no comment",
                                          "=right ~wrong",
                                          "{#1:0}",
                                          "@@PLUGINFILE@@/x",
                                          "a*b_c^d",
                                          "ü “é” − √2 ∈ 𝔸",
                                          "x\u00a0y",
                                          "}",
                                          "{",
                                          "TRUE",
                                          "\\"};

}  // namespace

TEST_CASE("texts that a format would interpret are read as they are", "[quiz]") {
  for (const std::string& text : attacks) {
    INFO(text);
    const QuizSheet sheet = {text, "folder/it", {hostile(text)}};
    std::string category;
    const auto check = [&](const ReadQuestion& read) {
      CHECK(read.title == text + ": question 1");
      CHECK(trimmed(read.words) == trimmed("Given " + text + "\n" + text + "\n" + text));
      CHECK(trimmed(read.solution) == trimmed(text));
      CHECK(read.alt == text);
      CHECK(read.png == "png " + text);
      REQUIRE(read.answers.size() == 2);
      CHECK(trimmed(read.answers[0].text) == trimmed(text));
      CHECK(trimmed(read.answers[1].text) == trimmed("no " + text));
    };
    const auto check_judged = [&](const ReadQuestion& read) {
      check(read);
      CHECK(read.kind == "choice");
      CHECK((read.answers[0].right && !read.answers[1].right));
      CHECK(trimmed(read.answers[1].reply) == trimmed(text));
    };
    check_judged(read_moodle(written(sheet, "moodle"), category).at(0));
    check_judged(read_gift(written(sheet, "gift"), category).at(0));
    check_judged(read_h5p(unzipped(written(sheet, "h5p"))).at(0));
    const QtiItem item = read_qti(unzipped(written(sheet, "qti"))).at(0);
    check(item.read);
    CHECK(said(item, {item.choices[0]}) == Said{true});
    CHECK(said(item, {item.choices[1]}).reply + "\n" == trimmed(text));
  }
}

TEST_CASE("GIFT escapes exactly its signs, each with one backslash", "[quiz]") {
  QuizItem item = hostile("~=#{}:\\");
  item.picture.reset();
  const std::string file = written({"t", "f", {item}}, "gift");
  CHECK_THAT(file, Contains("::\\~\\=\\#\\{\\}\\:\\\\\\: question 1::[html]"));
  CHECK_THAT(
      file, Contains("=[html]\\~\\=\\#\\{\\}\\:\\\\\n~[html]no \\~\\=\\#\\{\\}\\:\\\\#[html]\\~\\=\\#\\{\\}\\:\\\\\n"));
}

TEST_CASE("an identifier suits XML and Moodle, is the same each time, and different for different names", "[quiz]") {
  CHECK(platforms::identifier("ray-sphere/two-roots/03-foot") == "isect.ray-sphere.two-roots.03-foot");
  std::vector<std::string> names = {"a/b",
                                    "a.b",
                                    "a b",
                                    "a_b",
                                    "a+b",
                                    "ä/b",
                                    "a/b/",
                                    "",
                                    "/",
                                    "2nd/1",
                                    std::string(94, 'x'),
                                    std::string(95, 'x'),
                                    std::string(300, 'x'),
                                    std::string(301, 'x')};
  std::set<std::string> all, uuids;
  for (const std::string& name : names) {
    const std::string id = platforms::identifier(name);
    INFO(id);
    CHECK(is_qti_identifier(id));
    CHECK(id.size() <= 100);
    CHECK(id == platforms::identifier(name));
    CHECK(all.insert(id).second);
    CHECK(uuids.insert(platforms::uuid(name)).second);
  }
}

TEST_CASE("a number is written without an exponent, and read again as it was", "[quiz]") {
  for (const double x : {0.0, 1.0, -1.5, 0.1, 1 / 3.0, 1e-12, 4e-9, 123456.789, -1e7, 1e15, 1e17, 2.5e-5}) {
    const std::string text = platforms::decimal(x);
    INFO(text);
    CHECK(text.find('e') == text.npos);
    CHECK(std::abs(std::stod(text) - x) <= 1e-20 + 1e-7 * std::abs(x));
    if (std::abs(x) >= 1e-4) CHECK(std::stod(text) == x);
  }
}

TEST_CASE("a package is the same in every time zone", "[quiz]") {
  const QuizSheet sheet = {"t", "f", {hostile("x")}};
  const char* const before = std::getenv("TZ");
  const std::string kept = before ? before : "";
  std::set<std::string> files;
  for (const char* zone : {"UTC", "Pacific/Kiritimati", "America/Los_Angeles", "Asia/Kolkata"}) {
    setenv("TZ", zone, 1), tzset();
    files.insert(written(sheet, "qti"));
    files.insert(written(sheet, "h5p"));
  }
  if (before)
    setenv("TZ", kept.c_str(), 1);
  else
    unsetenv("TZ");
  tzset();
  CHECK(files.size() == 2);
}

TEST_CASE("a SCORM package launches its page, and names what it holds", "[quiz][book]") {
  const viz::Lesson& lesson = *isect::lessons::all_lessons().front();
  const std::string file = platforms::scorm_package(lesson, {"page.html", "<!DOCTYPE html>"}, "the end");
  CHECK(file.ends_with("the end"));
  const auto files = unzipped(file);
  REQUIRE(files.size() == 2);
  CHECK(files.at("page.html") == "<!DOCTYPE html>");
  const Xml manifest = parsed_xml(files.at("imsmanifest.xml"));
  CHECK(manifest.at("identifier") == "isect." + lesson.id);
  CHECK(manifest.one("metadata").one("schema").text == "ADL SCORM");
  CHECK(manifest.one("metadata").one("schemaversion").text == "1.2");
  const Xml& course = manifest.one("organizations").one("organization");
  CHECK(manifest.one("organizations").at("default") == course.at("identifier"));
  const Xml& page = manifest.one("resources").one("resource");
  CHECK(course.one("item").at("identifierref") == page.at("identifier"));
  CHECK(course.one("item").one("title").text == viz::plain(lesson.title));
  CHECK(page.at("adlcp:scormtype") == "sco");
  CHECK(page.at("type") == "webcontent");
  CHECK(files.contains(page.at("href")));
  CHECK(page.one("file").at("href") == page.at("href"));
}

}  // namespace quiz_formats_test
