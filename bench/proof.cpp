#include "bench/proof.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "bench/prose.h"

namespace isect::bench {

using Json = nlohmann::ordered_json;

Proof proof_of(const std::string& json) try {
  const Json o = Json::parse(json);
  const Json &verdicts = o.at("verdicts"), &tests = o.at("tests");
  Proof p;
  p.commit = o.at("commit"), p.date = o.at("date");
  p.seeds = verdicts.at("seeds"), p.wrong_verdicts = verdicts.at("wrong");
  for (const Json& t : verdicts.at("tests")) p.judged.push_back({t.at("test"), t.at("cases"), t.at("judged")});
  p.tests = tests.at("run"), p.skipped = tests.at("skipped"), p.failed = tests.at("wrong"),
  p.again = tests.value("again", 0L);
  p.seconds = tests.at("seconds");
  for (const Json& f : o.at("fuzz"))
    p.fuzzed.push_back({f.at("target"), f.at("minutes"), f.at("inputs"), f.at("wrong")});
  return p;
} catch (const Json::exception& e) {
  throw std::runtime_error(fmt::format("no long proof: {}", e.what()));
}

std::string proof_text(const Proof& p) {
  long cases = 0, judged = 0;
  for (const Proof::Judged& t : p.judged) cases += t.cases, judged += t.judged;
  const auto told = [](long wrong) { return wrong == 0 ? std::string("none") : count(wrong); };
  std::string text = fmt::format(
      "## The long proof\n\nNothing here is timed. All of it was run on commit {}, {}, or on one with the same core "
      "and "
      "program, by `tests/proof/run.py`.\n\n"
      "- **{} cases** of all families, {} of them for each seed of {}, were judged by the oracles: {} answers of the "
      "exact calls, {} wrong.\n"
      "- Every test was run with `ISECT_LONG=1`, which draws up to a thousand times the random shapes: {} tests in {} "
      "minutes, {} skipped, {} failed{}.\n",
      p.commit, p.date, count(cases), count(p.seeds > 0 ? cases / p.seeds : cases), count(p.seeds), count(judged),
      told(p.wrong_verdicts), count(p.tests), count((p.seconds + 59) / 60), told(p.skipped), told(p.failed),
      p.again > 0 ? fmt::format("; {} had failed, were mended and run again", count(p.again)) : "");
  for (const Proof::Fuzzed& f : p.fuzzed)
    text += fmt::format("- The fuzz target `{}` ran for {} minutes: {} inputs, {}.\n", f.target, count(f.minutes),
                        count(f.inputs), f.wrong == 0 ? "no fault" : "a fault");
  text += "\n| test | cases | answers judged |\n| --- | --: | --: |\n";
  for (const Proof::Judged& t : p.judged)
    text += fmt::format("| {} | {} | {} |\n", t.test, count(t.cases), count(t.judged));
  return text + '\n';
}

}  // namespace isect::bench
