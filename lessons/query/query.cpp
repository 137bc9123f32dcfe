#include "lessons/query/query.h"

#include <algorithm>

#include "lessons/query/handlers.h"

namespace isect::query {

namespace {

std::vector<const Handler*> handlers() {
  std::vector<const Handler*> all;
  for (const auto* table : {&point_handlers(), &pair_handlers(), &ray_handlers(), &polygon_handlers()})
    for (const Handler& handler : *table) all.push_back(&handler);
  return all;
}

/// "a, b or c"
std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 < names.size() ? ", " : " or ") + names[i];
  return text;
}

/// `text` itself if it is no longer than a line of a message.
std::string quoted(const std::string& text) {
  return text.size() <= 40 ? '"' + text + '"' : "a text of " + std::to_string(text.size()) + " bytes";
}

const Handler& handler_of(const std::string& kind) {
  static const std::vector<const Handler*> all = handlers();
  const auto found = std::ranges::find_if(all, [&](const Handler* h) { return h->kind == kind; });
  if (found != all.end()) return **found;
  std::vector<std::string> names;
  for (const Handler* h : all) names.push_back(h->kind);
  throw BadCase("field \"kind\": " + quoted(kind) + " is not known; allowed: " + listed(names));
}

std::string variant_of(const Handler& handler, const Field& fields) {
  const auto given = fields.find("variant");
  const std::string variant = given ? given->text() : handler.variants.front();
  if (std::ranges::find(handler.variants, variant) != handler.variants.end()) return variant;
  throw BadCase("field \"variant\": " + quoted(variant) + " is not known; allowed for " + handler.kind +
                ": " + listed(handler.variants));
}

bool wants_f32(const Field& fields) {
  const auto given = fields.find("scalar");
  const std::string scalar = given ? given->text() : "f64";
  if (scalar != "f32" && scalar != "f64")
    throw BadCase("field \"scalar\": " + quoted(scalar) + " is not known; allowed: f64 or f32");
  return scalar == "f32";
}

/// The reply without its id.
Json solve(const Field& fields) {
  const Handler& handler = handler_of(fields["kind"].text());
  const bool f32 = wants_f32(fields);
  const auto traced = fields.find("trace");
  Job job = {fields, variant_of(handler, fields), traced && traced->boolean()};
  Json reply = {{"result", (f32 ? handler.f32 : handler.f64)(job)}};
  if (job.traced) reply["trace"] = job.trace;
  return reply;
}

std::string parse_complaint(const std::string& line, const Json::exception& e) {
  if (e.id == 406) return "a number is too large for double precision";
  const auto* parse = dynamic_cast<const Json::parse_error*>(&e);
  if (!parse) return "no JSON";
  if (parse->byte > line.size()) return "no JSON: the line ends too early";
  return "no JSON: character " + std::to_string(parse->byte) + " is out of place";
}

Answer failed(const Json& id, const std::string& what) {
  const Json reply = {{"id", id}, {"error", what}};
  return {reply.dump(-1, ' ', false, Json::error_handler_t::replace), true};
}

}  // namespace

Answer answer(const std::string& line) {
  Json request;
  try {
    request = Json::parse(line);
  } catch (const Json::exception& e) {
    return failed(nullptr, parse_complaint(line, e));
  }
  const Json id = request.is_object() ? request.value("id", Json()) : Json();
  try {
    Json reply = {{"id", id}};
    reply.update(solve(Field(request, "")));
    return {reply.dump(-1, ' ', false, Json::error_handler_t::replace), false};
  } catch (const std::exception& e) {  // BadCase, or what the core refuses in so many words
    return failed(id, e.what());
  }
}

Answer too_long(std::size_t limit) {
  return failed(nullptr, "the line is longer than " + std::to_string(limit >> 20) + " MiB");
}

std::vector<Kind> kinds() {
  std::vector<Kind> all;
  for (const Handler* h : handlers()) all.push_back({h->kind, h->variants});
  return all;
}

}  // namespace isect::query
