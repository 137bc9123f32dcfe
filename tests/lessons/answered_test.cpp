// Every question at any setting is answered from what is on show: a sample in an ordinary run, all with ISECT_LONG=1.

#include "tests/lessons/answered.h"

#include <map>
#include <stdexcept>

#include "tests/catch.h"
#include "tests/lessons/asked_for.h"
#include "tests/lessons/random_settings.h"

namespace answered_test {
using namespace isect;
using namespace isect::viz;
using tests::on_show::How;

namespace {

/// One setting in so many is looked at in an ordinary run, and each in a long one.
int one_in() { return tests::long_run() ? 1 : 23; }

/// The questions of a lesson: how many were answered, and each fault once with the setting that shows it.
class Asked {
 public:
  explicit Asked(const Lesson& lesson) : lesson_(lesson) {}

  int by_numbers = 0, by_rounding = 0;

  void look_at(const Parameters& setting) {
    const Walk walk = lesson_.walk(setting);
    for (int k = 0; k < static_cast<int>(walk.steps.size()); ++k)
      if (walk.steps[static_cast<std::size_t>(k)].question) answer(walk, k, setting);
  }
  void tell() const {
    for (const auto& [what, where] : faults_) FAIL_CHECK(lesson_.id << ": " << what << "\n  " << where);
  }

 private:
  void answer(const Walk& walk, int k, const Parameters& setting) {
    const Step& step = walk.steps[static_cast<std::size_t>(k)];
    std::string way, why;
    try {
      const How how = tests::on_show::answered(walk, k, &way);
      by_numbers += how == How::by_numbers, by_rounding += how == How::by_rounding;
      if (how == How::wrongly) why = "what is on show gives another answer";
      if (how == How::not_at_all) why = "nothing on show gives the answer";
    } catch (const std::out_of_range& missing) {
      why = std::string("a number is not on show: ") + missing.what();
    }
    if (why.empty()) return;
    std::string told = step.slug + ": " + plain(step.question->prompt) + "\n     with";
    for (const auto& [name, value] : setting) told += " --set " + name + "=" + to_text(value);
    faults_.emplace(why + (way.empty() ? "" : ", at “" + way + "”"), told);
  }

  const Lesson& lesson_;
  std::map<std::string, std::string> faults_;
};

/// Answers every `of`-th lesson's questions, so that tests can run in parallel.
void answer_lessons(std::size_t first, std::size_t of) {
  const std::vector<const Lesson*> lessons = those_asked_for();
  int by_numbers = 0, by_rounding = 0;
  for (std::size_t i = first; i < lessons.size(); i += of) {
    Asked asked(*lessons[i]);
    int seen = 0;
    tests::at_any_settings(*lessons[i], [&](const Parameters& setting) {
      if (seen++ % one_in() == 0) asked.look_at(setting);
    });
    asked.tell();
    by_numbers += asked.by_numbers, by_rounding += asked.by_rounding;
  }
  CHECK(4 * by_rounding <= by_numbers);  // beside a border more hang on it than elsewhere
  if (lessons.size() > of) CHECK(by_numbers > 100);
}

}  // namespace

TEST_CASE("every question at any setting is answered from what is on show: first lesson of four", "[every lesson]") {
  answer_lessons(0, 4);
}
TEST_CASE("every question at any setting is answered from what is on show: second of four", "[every lesson]") {
  answer_lessons(1, 4);
}
TEST_CASE("every question at any setting is answered from what is on show: third of four", "[every lesson]") {
  answer_lessons(2, 4);
}
TEST_CASE("every question at any setting is answered from what is on show: last of four", "[every lesson]") {
  answer_lessons(3, 4);
}

TEST_CASE("an answer that hangs on rounding is told from one that is wrong", "[answered]") {
  const Question sum = {"How far apart may the segments be, with 1.2345, 1 and 2?", {"4.2345", "4.2346", "7"}, 0, ""};
  const auto answer = [&](const tests::on_show::OnShow& shown) {
    return tests::on_show::way_to_answer(sum).choice(shown);
  };
  const tests::on_show::OnShow shown = {tests::on_show::numbers_in(sum.prompt)};
  REQUIRE(shown.told.size() == 3);
  CHECK(answer(shown) == 0);
  const auto may_be = [&](int choice) {
    return tests::on_show::if_read_otherwise(shown, [&](const auto& moved) { return answer(moved) == choice; });
  };
  CHECK(may_be(1));
  CHECK_FALSE(may_be(2));
}

}  // namespace answered_test
