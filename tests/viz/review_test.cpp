// Which questions a review asks, and the record of answers that it is drawn from.

#include "viz/walk/review.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <set>

#include "tests/catch.h"
#include "tests/settings.h"
#include "tests/viz/sample_lesson.h"

namespace review_test {
using namespace isect;
using namespace isect::viz;

namespace {

/// The questions of five lessons, some in several settings and under two methods, and some of their answers.
struct Drawn {
  std::vector<ReviewPrompt> prompts;
  AnswerRecord record;
  std::vector<ReviewPrompt> asked;
};

std::string step_of(const ReviewPrompt& p) { return p.lesson + "/" + p.question.substr(p.question.rfind('/') + 1); }

Drawn random_review(std::mt19937_64& random) {
  const auto up_to = [&](int most) { return std::uniform_int_distribution<int>(0, most)(random); };
  Drawn d;
  for (const char* lesson : {"relations", "points", "intervals", "rays", "boxes"}) {
    const int questions = up_to(5);
    for (int q = 0; q <= questions; ++q)
      for (int setting = 0; setting <= up_to(2); ++setting) {
        const std::string method = up_to(1) ? "quick" : "exact", step = std::string(1, static_cast<char>('a' + q));
        d.prompts.push_back({lesson, method + "/" + step, "setting-" + std::to_string(setting), q + 1});
      }
  }
  const int answers = up_to(30);
  for (int i = 0; i < answers; ++i) {
    const ReviewPrompt& p = d.prompts[static_cast<std::size_t>(up_to(static_cast<int>(d.prompts.size()) - 1))];
    d.record.keep(p.lesson, p.question, up_to(2) > 0);
  }
  for (const int i : draw_review(d.prompts, d.record, static_cast<std::uint32_t>(d.record.answers)))
    d.asked.push_back(d.prompts[static_cast<std::size_t>(i)]);
  return d;
}

/// 0: answered wrong the last time, 1: never answered, 2: answered right.
int turn_of(const ReviewPrompt& p, const AnswerRecord& record) {
  const AskedBefore* before = record.find(p.lesson, p.question);
  return !before ? 1 : before->right ? 2 : 0;
}

int last_of(const ReviewPrompt& p, const AnswerRecord& record) { return record.find(p.lesson, p.question)->last; }

std::vector<Lesson> numbered_lessons(int count) {
  std::vector<Lesson> all;
  for (int i = 0; i < count; ++i) {
    all.push_back(sample::lesson());
    all.back().id = "lesson-" + std::to_string(i);
  }
  return all;
}

std::vector<const Lesson*> pointers(const std::vector<Lesson>& lessons) {
  std::vector<const Lesson*> all;
  for (const Lesson& l : lessons) all.push_back(&l);
  return all;
}

}  // namespace

TEST_CASE("a page and the program draw the same", "[review]") {
  std::ifstream file(ISECT_REVIEW_CASES);
  const nlohmann::json cases = nlohmann::json::parse(file);  // app/book/review.js is held to it, too
  REQUIRE(cases.size() > 9);
  for (const auto& one : cases) {
    INFO(one.at("told").get<std::string>());
    std::vector<ReviewPrompt> prompts;
    for (const auto& p : one.at("prompts"))
      prompts.push_back({p.at(0).get<std::string>(), p.at(1).get<std::string>(), p.at(2).get<std::string>()});
    const AnswerRecord record = answer_record_from(one.at("record").dump());
    CHECK(draw_review(prompts, record, one.at("seed").get<std::uint32_t>()) == one.at("drawn").get<std::vector<int>>());
  }
}

TEST_CASE("a review asks no step twice, and eight questions where there are as many", "[review]") {
  std::mt19937_64 random(tests::seed());
  for (int i = 0; i < tests::cases(300, 3000); ++i) {
    const Drawn d = random_review(random);
    std::set<std::string> steps, all;
    for (const ReviewPrompt& p : d.prompts) all.insert(step_of(p));
    for (const ReviewPrompt& p : d.asked) steps.insert(step_of(p));
    CHECK(steps.size() == d.asked.size());
    CHECK(d.asked.size() == std::min<std::size_t>(questions_a_review, all.size()));
  }
}

TEST_CASE("what was wrong returns first, the most recent fault before the others", "[review]") {
  std::mt19937_64 random(tests::seed() + 1);
  for (int i = 0; i < tests::cases(300, 3000); ++i) {
    const Drawn d = random_review(random);
    CHECK(std::ranges::is_sorted(d.asked, {}, [&](const ReviewPrompt& p) { return turn_of(p, d.record); }));
    std::vector<int> faults;
    std::set<std::string> asked;
    for (const ReviewPrompt& p : d.asked) {
      asked.insert(step_of(p));
      if (turn_of(p, d.record) == 0) faults.push_back(-last_of(p, d.record));
    }
    CHECK(std::ranges::is_sorted(faults));
    for (const ReviewPrompt& p : d.prompts) {
      if (turn_of(p, d.record) > 0 || asked.contains(step_of(p))) continue;
      REQUIRE(static_cast<int>(faults.size()) == questions_a_review);  // there was no room for it
      CHECK(-last_of(p, d.record) > faults.back());
    }
  }
}

TEST_CASE("questions are spread over the lessons, and what was asked longest ago comes before the rest", "[review]") {
  std::mt19937_64 random(tests::seed() + 2);
  for (int i = 0; i < tests::cases(300, 3000); ++i) {
    const Drawn d = random_review(random);
    std::map<std::string, int> drawn;
    std::set<std::string> steps;
    for (const ReviewPrompt& p : d.asked) {
      const int turn = turn_of(p, d.record);
      for (const ReviewPrompt& other : d.prompts) {
        if (turn == 0 || turn_of(other, d.record) != turn || steps.contains(step_of(other))) continue;
        CHECK(drawn[p.lesson] <= drawn[other.lesson]);
        if (turn == 2 && drawn[p.lesson] == drawn[other.lesson])
          CHECK(last_of(p, d.record) <= last_of(other, d.record));
      }
      ++drawn[p.lesson];
      steps.insert(step_of(p));
    }
  }
}

TEST_CASE("the same record draws the same, and another seed other questions", "[review]") {
  std::vector<ReviewPrompt> prompts;
  for (int i = 0; i < 40; ++i) prompts.push_back({"lesson-" + std::to_string(i % 5), "/" + std::to_string(i), "one"});
  std::set<std::vector<int>> drawn;
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    CHECK(draw_review(prompts, {}, seed) == draw_review(prompts, {}, seed));
    drawn.insert(draw_review(prompts, {}, seed));
  }
  CHECK(drawn.size() > 15);
}

TEST_CASE("a lesson's questions are offered in every setting, each once, and named alike in all", "[review]") {
  const Lesson lesson = sample::lesson();
  const std::vector<ReviewPrompt> all = prompts_of(lesson);
  CHECK(all.size() == lesson.presets.size());
  std::set<std::string> names;
  for (const ReviewPrompt& p : all) {
    names.insert(p.question);
    CHECK(lesson.walk(preset(lesson, p.preset).parameters).steps[static_cast<std::size_t>(p.step)].question);
    CHECK(p.asks == "Where is **p**?");
  }
  CHECK(names == std::set<std::string>{"squared/compare", "distance/compare"});
}

TEST_CASE("every fifth lesson ends with a review, and the last one", "[review]") {
  const std::vector<Lesson> lessons = numbered_lessons(13);
  const std::vector<const Lesson*> all = pointers(lessons);
  CHECK(review_count(all) == 3);
  for (int i = 0; i < 13; ++i)
    CHECK(review_after(all, lessons[static_cast<std::size_t>(i)]) == (i == 4 ? 1 : i == 9 ? 2 : i == 12 ? 3 : 0));
  CHECK(lessons_of_review(all, 2) == std::vector<const Lesson*>(all.begin() + 5, all.begin() + 10));
  CHECK(lessons_of_review(all, 3).size() == 3);
  CHECK(review_count({all.front(), all.back()}) == 0);
  std::vector<Lesson> with_scene = numbered_lessons(5);
  with_scene.back().made_from = "{}";
  CHECK(review_count(pointers(with_scene)) == 0);  // a scene is none of the course
}

TEST_CASE("a review returns faults of earlier lessons, and nothing else of them", "[review]") {
  const std::vector<Lesson> lessons = numbered_lessons(10);
  const std::vector<const Lesson*> all = pointers(lessons);
  AnswerRecord record;
  record.keep("lesson-1", "squared/compare", false);
  record.keep("lesson-1", "distance/compare", true);
  record.keep("lesson-2", "squared/compare", true);
  std::map<std::string, std::set<std::string>> offered;
  for (const ReviewPrompt& p : prompts_of_review(all, 2, record)) offered[p.lesson].insert(p.question);
  CHECK(offered.size() == 6);
  CHECK(offered.at("lesson-1") == std::set<std::string>{"squared/compare"});
  const std::vector<ReviewPrompt> own = prompts_of_review(all, 1, record);
  CHECK(std::ranges::none_of(own, [](const ReviewPrompt& p) { return p.lesson > "lesson-4"; }));
}

TEST_CASE("a record survives as text, and a damaged one is refused with its place", "[review]") {
  AnswerRecord record;
  record.keep("rays", "/foot", false);
  record.keep("rays", "/foot", true);
  record.keep("points", "/größe", false);
  record.reviews[2] = {6, 8};
  CHECK(record.find("rays", "/foot")->times == 2);
  CHECK(record.find("rays", "/foot")->wrong == 1);
  CHECK(record.find("points", "/größe")->last == 3);
  CHECK(record.find("points", "/foot") == nullptr);
  CHECK(answer_record_from(text_of(record)) == record);
  CHECK(answer_record_from(text_of({})) == AnswerRecord());

  const std::string good = text_of(record);
  for (std::size_t cut = 0; cut < good.size(); ++cut)
    CHECK_THROWS_AS(answer_record_from(good.substr(0, cut)), BadInput);
  const auto with = [&](const std::string& part, const std::string& other) {
    std::string text = good;
    REQUIRE(text.find(part) != text.npos);
    return text.replace(text.find(part), part.size(), other);
  };
  for (const std::string& bad :
       {with("\"version\":1", "\"version\":2"), with("\"version\":1", "\"version\":\"1\""),
        with("\"answers\":3", "\"answers\":-3"), with("\"answers\":3", "\"answers\":1e99"),
        with("\"right\":true", "\"right\":1"), with("\"of\":8", "\"of\":0.5"), with("\"2\":", "\"two\":"),
        std::string("[]"), std::string("null"), std::string("{}")}) {
    INFO(bad);
    CHECK_THROWS_WITH(answer_record_from(bad), Catch::Matchers::StartsWith("record"));
  }
}

}  // namespace review_test
