#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "bench/prose.h"
#include "bench/rows.h"
#include "lessons/lessons.h"
#include "lessons/speed_against_error/results.h"
#include "lessons/speed_against_error/telling.h"
#include "tests/catch.h"
#include "tests/viz/drawn.h"
#include "viz/chart/chart.h"
#include "viz/compose/compose.h"
#include "viz/text/rich_text.h"
#include "viz/walk/closing.h"

namespace speed_against_error_test {
using namespace isect;
using namespace isect::viz;
using lessons::speed_against_error_lesson::results;
using lessons::speed_against_error_lesson::Teller;

namespace {

const Lesson& lesson() {
  for (const Lesson* l : lessons::all_lessons())
    if (l->id == "speed-against-error") return *l;
  throw std::runtime_error("no lesson speed-against-error");
}

bench::Row row(const std::string& method, double ns, const std::string& family, long wrong) {
  bench::Row r;
  r.test = "a-b", r.method = method, r.library = "isect", r.scalar = "double", r.family = family;
  r.hard = family != "ordinary", r.ns = r.median = ns, r.cases = r.judged = 1000, r.false_yes = wrong;
  r.standard = method == "naive", r.exact = method == "exact";
  return r;
}

/// Three methods on two families; the naive one is wrong `wrong` times on the hard one.
bench::Report report(double exact_ns, long wrong) {
  bench::Report r;
  for (const char* family : {"ordinary", "touch"}) {
    const bool hard = std::string(family) == "touch";
    for (const auto& one : {row("naive", 10, family, hard ? wrong : 0),
                            row("careful", 12, family, hard ? wrong / 2 : 0), row("exact", exact_ns, family, 0)})
      r.rows.push_back(one);
  }
  return r;
}

const Step& step(const Walk& walk, const std::string& slug) {
  for (const Step& s : walk.steps)
    if (s.slug == slug) return s;
  throw std::runtime_error("no step " + slug);
}

}  // namespace

TEST_CASE("the results carry tests with a naive method, an exact one and hard families", "[speed lesson]") {
  CHECK_FALSE(results().machine.cpu.empty());
  CHECK_FALSE(results().machine.flags.empty());
  CHECK(results().machine.build == "portable");
  std::set<std::string> ids;
  for (const Preset& p : lesson().presets) {
    ids.insert(p.id);
    CHECK_NOTHROW(validate(lesson(), p.parameters));
  }
  for (const char* id : {"ray-sphere", "sphere-sphere", "orient2d"}) CHECK(ids.count(id) == 1);
}

TEST_CASE("no exact call of the results was ever wrong", "[speed lesson]") {
  for (const bench::Row& r : results().rows)
    if (r.exact && r.library == "isect") {
      INFO(r.test << ", " << r.method << ", " << r.scalar << ", " << r.family);
      CHECK(r.wrong() == 0);
      CHECK(r.judged > 0);
    }
}

TEST_CASE("every line of the reading is reached, and each step says it shortly", "[speed lesson]") {
  std::set<int> reached;
  std::size_t lines = 0;
  for (const Preset& p : lesson().presets) {
    const Walk walk = lesson().walk(p.parameters);
    lines = walk.pseudocode.size();
    std::set<std::string> slugs;
    for (const Step& s : walk.steps) {
      INFO(p.id << ", " << s.slug << ": " << s.caption);
      if (s.slug == closing_slug) continue;
      reached.insert(s.line);
      CHECK(slugs.insert(s.slug).second);
      CHECK(s.source.find(results().machine.flags) != std::string::npos);
      CHECK(bool(s.scene.chart) == (s.slug != "typical"));
      CHECK(s.caption.find("nan") == std::string::npos);
      int words = 0;
      std::istringstream text(plain(s.caption));
      for (std::string word; text >> word;) {
        ++words;
        CHECK(words <= 20);
        if (word.find_last_of(".:?!") == word.size() - 1) words = 0;
      }
    }
    CHECK(walk.steps.back().verdict.kind == Verdict::Kind::yes);
  }
  CHECK(reached.size() == lines);
}

TEST_CASE("questions about the results have one right answer", "[speed lesson]") {
  int asked = 0;
  for (const Preset& p : lesson().presets)
    for (const Step& s : lesson().walk(p.parameters).steps) {
      if (!s.question) continue;
      ++asked;
      INFO(p.id << ", " << s.slug << ": " << s.question->prompt);
      const std::vector<std::string>& choices = s.question->choices;
      REQUIRE(s.question->answer >= 0);
      REQUIRE(s.question->answer < static_cast<int>(choices.size()));
      CHECK(std::set<std::string>(choices.begin(), choices.end()).size() == choices.size());
      if (s.slug != "front") continue;
      const auto rows = bench::rows_of(results(), p.id, "double", "ordinary");
      const bool by_value = std::ranges::any_of(rows, [](const bench::Row* r) { return r->ulps.has_value(); });
      const auto error = [&](const bench::Row* r) { return by_value ? r->ulps->p99 : r->wrong_per_million(); };
      // the step draws those that are kept, so the answer is theirs
      const auto kept = std::ranges::count_if(rows, [&](const bench::Row* one) {
        return std::ranges::none_of(rows, [&](const bench::Row* r) {
          return r->ns <= one->ns && error(r) <= error(one) && (r->ns < one->ns || error(r) < error(one));
        });
      });
      CHECK(choices[s.question->answer] == std::to_string(kept));
      CHECK_THAT(s.caption, test::Contains(std::to_string(kept) + " of " + std::to_string(rows.size())));
    }
  CHECK(asked >= 3);
}

TEST_CASE("what the lesson says follows from the numbers", "[speed lesson]") {
  const bench::Report dear = report(40, 100), cheap = report(10, 100), harmless = report(40, 0);
  const Walk walk = Teller(dear, "a-b").tell();
  CHECK(step(walk, "touch").caption.find("10 % wrong") != std::string::npos);
  CHECK(step(walk, "touch").question->choices[step(walk, "touch").question->answer] == "naive");
  CHECK(step(walk, "wrong-verdicts").caption.find("The exact call was never wrong, in 2000 cases.") !=
        std::string::npos);
  CHECK(step(walk, "cost").question->answer == 3);
  CHECK(step(walk, "cost").caption.find("4 times as long as naive") != std::string::npos);
  CHECK(walk.steps.back().caption.find("takes 30 ns less") != std::string::npos);

  CHECK(Teller(cheap, "a-b").tell().steps.back().caption.find("costs no more than naive") != std::string::npos);

  // Which families' cost is mentioned: the exact call takes four times as long as naive on the hard one alone.
  bench::Report mixed = report(10, 100);
  for (bench::Row& r : mixed.rows)
    if (r.exact && r.hard) r.ns = r.median = 40;
  const std::string told = Teller(mixed, "a-b").tell().steps.back().caption;
  CHECK_THAT(told, Catch::Matchers::StartsWith("On ordinary cases the exact call costs no more than naive."));
  CHECK_THAT(told,
             test::Contains("On the hard family the exact call takes longer, at most 4 times as long: on “touch”. "
                            "There the naive method is wrong on 10 % of the cases."));
  CHECK_THAT(Teller(cheap, "a-b").tell().steps.back().caption, !test::Contains("takes longer"));

  const Walk calm = Teller(harmless, "a-b").tell();
  CHECK(calm.steps.back().caption.find("No case judged here broke naive") != std::string::npos);
  CHECK(std::ranges::none_of(calm.steps, [](const Step& s) { return s.slug == "wrong-verdicts"; }));
}

TEST_CASE("a cost that is told without its families is one of all families drawn beside it", "[speed lesson]") {
  int told = 0;
  for (const Preset& p : lesson().presets) {
    const std::string caption = step(lesson().walk(p.parameters), "choose").caption;
    INFO(p.id << ": " << caption);
    std::size_t hard = 0, slower = 0;
    double most = 0;
    for (const std::string& family : bench::families_of(bench::rows_of(results(), p.id, "double"))) {
      const auto rows = bench::rows_of(results(), p.id, "double", family);
      const bench::Row *naive = bench::standard_of(rows), *exact = bench::exact_of(rows);
      if (!naive || !exact) continue;
      const double times = exact->ns / naive->ns;
      if (!exact->hard && caption.find("costs no more") != caption.npos) CHECK(times <= 1 + results().machine.noise);
      if (!exact->hard) continue;
      ++hard, slower += times > 1 + results().machine.noise;
      most = std::max(most, times);
    }
    if (caption.find("costs no more") == caption.npos) continue;
    ++told;
    CHECK_THAT(caption, Catch::Matchers::StartsWith("On ordinary cases"));
    CHECK_THAT(caption, test::Contains(slower == hard ? std::string("On every hard family the exact call takes longer")
                                                      : fmt::format("On {} of {} hard families the exact call takes "
                                                                    "longer",
                                                                    slower, hard)));
    CHECK_THAT(caption, test::Contains("at most " + bench::ratio_text(most) + " times as long"));
  }
  CHECK(told >= 1);
}

TEST_CASE("no label of the lesson's charts meets another or leaves the picture", "[speed lesson]") {
  for (const Preset& p : lesson().presets) {
    const Walk walk = lesson().walk(p.parameters);
    for (const ThemeName name : {ThemeName::screen, ThemeName::print, ThemeName::grey, ThemeName::dark})
      for (const auto& [w, h] : {std::pair{227, 142}, {480, 360}, {960, 600}})
        for (const Step& s : walk.steps) {
          if (!s.scene.chart) continue;
          const Figure f = figure(s, lesson().camera, name, w, h);
          for (std::size_t i = 0; i < f.labels.size(); ++i) {
            const TextBox& b = f.labels[i].box;
            INFO(p.id << ", " << s.slug << ", " << name_of(name) << " " << w << "x" << h << ": " << f.labels[i].text);
            CHECK((b.left >= 0 && b.top >= 0 && b.right <= w && b.bottom <= h));
            for (std::size_t j = 0; j < i; ++j) {
              INFO("and " << f.labels[j].text);
              CHECK_FALSE(meet(b, f.labels[j].box));
            }
          }
        }
  }
}

}  // namespace speed_against_error_test
