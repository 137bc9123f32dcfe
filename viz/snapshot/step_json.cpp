#include "viz/snapshot/step_json.h"

#include <fmt/format.h>

#include <array>

#include "viz/text/rich_text.h"
#include "viz/theme.h"

namespace isect::viz::snap {
namespace {

std::string digits(double x) { return fmt::format("{:.9g}", x == 0 ? 0.0 : x); }  // -0 is 0

/// Returns the relation of two numbers, exactly.
std::string relation(double a, double b) { return a < b ? "<" : a > b ? ">" : a == b ? "=" : "?"; }

/// Splits "m² ≤ r²" into {"m²", "r²"}, the names of both sides; returns the numbers if there is no sign between
/// them.
std::pair<std::string, std::string> sides(const Comparison& c) {
  const std::string text = plain(c.text);
  for (const std::string sign : {" ≤ ", " ≥ ", " < ", " > ", " = ", " ≠ ", " <= ", " >= "})
    if (const std::size_t at = text.find(sign); at != std::string::npos)
      return {text.substr(0, at), text.substr(at + sign.size())};
  return {digits(c.left), digits(c.right)};
}

Json told(const Comparison& c) {
  if (!c.parts.empty()) {
    Json whole = {{"holds", c.holds}, {"text", c.text}, {"meaning", c.meaning}};
    for (const Comparison& part : c.parts) whole["parts"].push_back(told(part));
    return whole;
  }
  const auto [left, right] = sides(c);
  return {{"left", left},        {"relation", relation(c.left, c.right)},
          {"right", right},      {"values", {digits(c.left), digits(c.right)}},
          {"holds", c.holds},    {"text", c.text},
          {"meaning", c.meaning}};
}

Json told(const Counters& c) {
  return {{"mul", c.mul},   {"add", c.add},         {"div", c.div},
          {"sqrt", c.sqrt}, {"compare", c.compare}, {"early out", c.early_out}};
}

/// Returns name, value, unit, role, and whether it is lit.
Json told(const Value& v) {
  Json list = {v.name, digits(v.value), v.unit, name_of(v.role)};
  if (v.fresh) list.push_back("fresh");
  return list;
}

Json told(const Numeric& n) {
  Json object = {{"truth", digits(n.truth)}, {"digits", n.digits}, {"wrong", Json::array()}};
  for (const WrongNumber& wrong : n.wrong) object["wrong"].push_back(Json::array({digits(wrong.value), wrong.reply}));
  return object;
}

Json told(const LineAsked& l) {
  Json object = {{"truth", l.truth + 1}, {"wrong", Json::array()}};
  for (const WrongLine& wrong : l.wrong) object["wrong"].push_back(Json::array({wrong.line + 1, wrong.reply}));
  return object;
}

Json told(const OrderAsked& o) {
  Json object = {{"tiles", o.tiles}, {"ranks", o.ranks}, {"wrong", Json::array()}};
  for (const WrongOrder& wrong : o.wrong) {
    Json tiles = Json::array();
    for (const int tile : wrong.order) tiles.push_back(o.tiles.at(static_cast<std::size_t>(tile)));
    object["wrong"].push_back(Json::array({tiles, wrong.reply}));
  }
  return object;
}

Json told(const Question& q) {
  Json object = {{"prompt", q.prompt}, {"choices", q.choices}};
  if (q.answer >= 0 && q.answer < static_cast<int>(q.choices.size())) object["answer"] = q.choices[q.answer];
  object["because"] = q.because;
  if (q.number) object["number"] = told(*q.number);
  if (q.line) object["line to point at"] = told(*q.line);
  if (q.order) object["order"] = told(*q.order);
  for (const Value& v : q.given) object["given"].push_back(told(v));
  return object;
}

std::string told(const Verdict& v) {
  constexpr std::array kinds = {"open", "yes", "no", "on"};
  const std::string kind = kinds.at(static_cast<std::size_t>(v.kind));
  return v.text.empty() ? kind : kind + ": " + v.text;
}

Json from_one(const std::vector<int>& lines) {
  Json list = Json::array();
  for (const int line : lines) list.push_back(line + 1);
  return list;
}

}  // namespace

Json json_of(const Step& step) {
  Json object = {{"slug", step.slug}, {"title", step.title}, {"caption", step.caption}};
  if (!step.formula.empty()) object["formula"] = step.formula;
  if (!step.source.empty()) object["source"] = step.source;
  object["line"] = step.line + 1;
  if (!step.untaken.empty()) object["untaken"] = from_one(step.untaken);
  if (!step.refused.empty()) object["refused"] = from_one(step.refused);
  object["decides"] = step.decides;
  object["verdict"] = told(step.verdict);
  if (!step.verdict.exact.empty()) object["verdict of the core"] = step.verdict.exact;
  if (step.comparison) object["comparison"] = told(*step.comparison);
  object["values"] = Json::array();
  for (const Value& v : step.values) object["values"].push_back(told(v));
  object["counters"] = told(step.counters);
  if (step.question) object["question"] = told(*step.question);
  return object;
}

Json json_of(const std::vector<Exercise>& exercises) {
  Json list = Json::array();
  for (const Exercise& e : exercises) {
    Json one = {{"prompt", e.prompt}, {"solution", e.solution}};
    if (!e.program.empty()) one["program"] = e.program;
    list.push_back(one);
  }
  return list;
}

Json json_of(const std::vector<Erratum>& errata) {
  Json list = Json::array();
  for (const Erratum& e : errata)
    list.push_back({{"published", e.published}, {"corrected", e.corrected}, {"why", e.why}, {"preset", e.preset}});
  return list;
}

Json json_of(const std::vector<Opinion>& opinions) {
  Json list = Json::array();
  for (const Opinion& o : opinions) list.push_back({{"method", o.method}, {"says", o.says}, {"agrees", o.agrees}});
  return list;
}

}  // namespace isect::viz::snap
