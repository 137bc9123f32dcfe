// Questions for a line of the pseudocode and for an order: the truth is what the walk itself lights or computes, and
// each usual wrong answer is told its mistake.

#include <map>
#include <set>
#include <sstream>

#include "tests/lessons/asked_for.h"
#include "tests/lessons/words.h"
#include "viz/text/rich_text.h"
#include "viz/walk/given_answer.h"
#include "viz/walk/given_order.h"
#include "viz/walk/pointed_line.h"

namespace lines_and_orders_words_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;

namespace {

/// Whether the sentences are short and there is at least one.
bool short_sentences(const std::string& markup) {
  std::istringstream text(plain(markup));
  int words = 0, all = 0;
  for (std::string word; text >> word;) {
    if (++all, ++words > 20) return false;
    if (word.ends_with('.') || word.ends_with(':') || word.ends_with('?')) words = 0;
  }
  return all > 0;
}

void check_line(const Walk& walk, int step) {
  const Step& asked = walk.steps[static_cast<std::size_t>(step)];
  const Question& question = *asked.question;
  const LineAsked& line = *question.line;
  CHECK(line.truth == asked.line);  // the core's event has lit it
  REQUIRE(line.offered.size() == question.choices.size());
  CHECK(line.offered.at(static_cast<std::size_t>(question.answer)) == line.truth);
  for (std::size_t i = 0; i < line.offered.size(); ++i)
    CHECK(question.choices[i] == as_markup(unindented(walk.pseudocode.at(static_cast<std::size_t>(line.offered[i])))));
  const std::vector<std::string> replies = line_replies(walk, step);
  for (int k = 0; k < static_cast<int>(replies.size()); ++k) {
    INFO("line " << k + 1 << ": " << replies[static_cast<std::size_t>(k)]);
    CHECK(replies[static_cast<std::size_t>(k)].empty() == (k == line.truth));
    if (k != line.truth) CHECK(short_sentences(replies[static_cast<std::size_t>(k)]));
    CHECK((choice_of_line(question, k) == question.answer) == (k == line.truth));
    const GivenAnswer typed = answer_from(walk, step, std::to_string(k + 1));
    CHECK((typed.line == k && (typed.choice == question.answer) == (k == line.truth)));
  }
  std::set<int> wrong;
  for (const WrongLine& w : line.wrong) {
    CHECK((w.line != line.truth && w.line >= 0 && w.line < static_cast<int>(walk.pseudocode.size())));
    CHECK(wrong.insert(w.line).second);
  }
}

void check_order(const Walk& walk, int step) {
  const Question& question = *walk.steps[static_cast<std::size_t>(step)].question;
  const OrderAsked& order = *question.order;
  const std::size_t n = order.tiles.size();
  REQUIRE((n >= 3 && n <= 8 && order.ranks.size() == n && order.offered.size() == question.choices.size()));
  CHECK(std::set<std::string>(order.tiles.begin(), order.tiles.end()).size() == n);
  for (const std::string& tile : order.tiles) CHECK(plain(tile).size() <= 24);
  CHECK_FALSE(std::ranges::is_sorted(order.ranks));  // as they stand they are in no right order
  for (std::size_t i = 0; i < n; ++i) {              // ranks are 0, 1, ...
    const int rank = order.ranks[i];
    CHECK((rank == 0 || std::ranges::count(order.ranks, rank - 1) > 0));
  }
  for (std::size_t i = 0; i < order.offered.size(); ++i) {
    CHECK(order.offered[i].size() == n);
    CHECK((first_wrong(order, order.offered[i]) < 0) == (static_cast<int>(i) == question.answer));
    CHECK(question.choices[i] == tiles_in(order, order.offered[i]));
  }
  for (const WrongOrder& w : order.wrong) {
    INFO(tiles_in(order, w.order) << ": " << w.reply);
    CHECK(first_wrong(order, w.order) >= 0);
    CHECK(reply_to(order, w.order) == w.reply);
    CHECK(short_sentences(w.reply));
  }
  std::string letters;  // the right order is taken as it is typed
  for (const int tile : order.offered.at(static_cast<std::size_t>(question.answer))) letters += tile_letter(tile);
  CHECK(answer_from(walk, step, letters).choice == question.answer);
}

/// Checks a walk. Counts its questions by kind.
void check(const Walk& walk, std::map<std::string, int>& kinds) {
  for (int i = 0; i < static_cast<int>(walk.steps.size()); ++i) {
    const auto& question = walk.steps[static_cast<std::size_t>(i)].question;
    if (!question) continue;
    INFO(walk.steps[static_cast<std::size_t>(i)].slug << ": " << plain(question->prompt));
    CHECK(question->number.has_value() + question->line.has_value() + question->order.has_value() <= 1);
    ++kinds[question->number ? "number" : question->line ? "line" : question->order ? "order" : "choice"];
    if (question->line) check_line(walk, i);
    if (question->order) check_order(walk, i);
    if (question->line || question->order) CHECK(short_sentences(question->because));
  }
}

}  // namespace

TEST_CASE("a line asked for is the one that is lit, an order is the computed one, and no usual wrong answer is right",
          "[every lesson]") {
  std::map<std::string, int> kinds;
  std::set<std::string> with_lines, with_orders;
  for (const Lesson* lesson : those_asked_for())
    for (const Preset& p : lesson->presets) {
      INFO(lesson->id << " " << p.id);
      std::map<std::string, int> own;
      check(lesson->walk(p.parameters), own);
      if (own["line"] > 0) with_lines.insert(lesson->id);
      if (own["order"] > 0) with_orders.insert(lesson->id);
      for (const auto& [kind, count] : own) kinds[kind] += count;
    }
  if (those_asked_for().size() != lessons::all_lessons().size()) return;
  std::ostringstream shares;
  for (const auto& [kind, count] : kinds) shares << kind << " " << count << ", ";
  INFO(shares.str());
  CHECK(with_lines.size() >= 6);
  CHECK(with_orders.size() >= 6);
}

TEST_CASE("in any setting, too, lines asked for are lit and orders are computed", "[every lesson]") {
  std::map<std::string, int> kinds;
  for (const Lesson* lesson : those_asked_for())
    on_random_settings(lesson->id, 3, [&](const Parameters&, const Walk& walk) { check(walk, kinds); });
}

}  // namespace lines_and_orders_words_test
