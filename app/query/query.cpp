#include "app/query/query.h"

#include <algorithm>
#include <new>
#include <sstream>

#include "app/query/handlers.h"
#include "app/query/spelling.h"

namespace isect::query {

namespace {

const std::vector<std::string> common = {"id", "kind", "scalar", "variant", "trace"};

/// A kind, and all fields that its case may have.
struct KnownKind {
  const Handler* handler;
  std::vector<std::string> fields;
};

std::vector<KnownKind> known_kinds() {
  std::vector<KnownKind> all;
  for (const auto* table :
       {&point_handlers(), &pair_handlers(), &ray_handlers(), &round_handlers(), &polygon_handlers()})
    for (const Handler& handler : *table) {
      std::vector<std::string> fields;
      std::istringstream inputs(handler.inputs);
      for (std::string name; inputs >> name;) {
        std::erase_if(name, [](char c) { return c == '[' || c == ']'; });
        fields.push_back(name);
      }
      fields.insert(fields.end(), common.begin(), common.end());
      fields.insert(fields.end(), notes().begin(), notes().end());
      all.push_back({&handler, fields});
    }
  return all;
}

const std::vector<KnownKind>& known() {
  static const std::vector<KnownKind> all = known_kinds();
  return all;
}

/// Throws for a missing "kind"; it may be misspelt.
[[noreturn]] void complain_of_no_kind(const Field& fields) {
  std::vector<std::string> all;
  for (const KnownKind& kind : known()) all.insert(all.end(), kind.fields.begin(), kind.fields.end());
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  fields.only(all);
  throw BadCase("field \"kind\" is missing");
}

const KnownKind& kind_of(const Field& fields) {
  const auto given = fields.find("kind");
  if (!given) complain_of_no_kind(fields);
  const std::string kind = given->text();
  const auto found = std::ranges::find_if(known(), [&](const KnownKind& k) { return k.handler->kind == kind; });
  if (found != known().end()) return *found;
  std::vector<std::string> names;
  for (const KnownKind& k : known()) names.push_back(k.handler->kind);
  given->refuse(described_text(kind) + " is not known" + spelling::instead(kind, names, "allowed: " + listed(names)));
}

/// Returns the text of a field, one of those allowed; the first of them if the field is missing.
std::string chosen(const Field& fields, const char* key, const std::vector<std::string>& allowed,
                   const std::string& whose) {
  const auto given = fields.find(key);
  if (!given) return allowed.front();
  const std::string text = given->text();
  if (std::ranges::find(allowed, text) != allowed.end()) return text;
  given->refuse(described_text(text) + " is not known; allowed" + whose + ": " + listed(allowed));
}

/// Returns the reply behind its id.
std::string solved(const Field& fields) {
  const KnownKind& kind = kind_of(fields);
  fields.only(kind.fields);
  const Handler& handler = *kind.handler;
  const bool f32 = chosen(fields, "scalar", {"f64", "f32"}, "") == "f32";
  const auto traced = fields.find("trace");
  Job job = {fields, chosen(fields, "variant", handler.variants, std::string(" for ") + handler.kind),
             traced && traced->boolean(), ""};
  std::string reply = "\"result\":" + written((f32 ? handler.f32 : handler.f64)(job));
  if (job.traced) reply += ",\"trace\":[" + job.trace + "]";
  return reply;
}

Answer failed(const std::string& id, std::size_t number, const std::string& what) {
  const std::string where = id == "null" && number > 0 ? "line " + std::to_string(number) + ": " : "";
  return {"{\"id\":" + id + ",\"error\":" + written(where + what) + "}", true};
}
/// Returns an error about the line as a whole.
Answer failed(std::size_t number, const std::string& what) {
  return failed("null", number, number > 0 ? what : "the line: " + what);
}

Answer answered(const std::string& line, std::size_t number, bool strict) {
  Document document(line);
  document.strict = strict;
  if (!document.error.empty()) return failed(document.id, number, document.error);
  try {
    const Field fields(document, 0);
    return {"{\"id\":" + document.id + "," + solved(fields) + "}", false};
  } catch (const BadCase& e) {
    return failed(document.id, number, e.what());
  }
}

}  // namespace

Answer answer(const std::string& line, std::size_t number, bool strict) {
  if (line.size() > most_bytes()) return too_long(number);
  try {
    return answered(line, number, strict);
  } catch (const std::bad_alloc&) {  // the line's memory has been released
    return out_of_memory(number);
  } catch (const std::exception& e) {
    return failed(number, e.what());
  }
}

bool blank(std::string_view line) { return line.find_first_not_of(" \t\r\n") == std::string_view::npos; }

int most_levels() { return Document::most_levels; }
std::size_t most_bytes() { return Document::most_bytes; }

Answer too_long(std::size_t number) {
  return failed(number, "it is longer than the " + std::to_string(most_bytes() >> 20) + " MiB that are allowed");
}

Answer out_of_memory(std::size_t number) { return failed(number, "there is not enough memory to answer it"); }

const std::vector<std::string>& notes() {
  static const std::vector<std::string> names = {"name",        "note", "comment",  "source",       "license",
                                                 "conventions", "tags", "expected", "peer_differs", "peer"};
  return names;
}

std::vector<Kind> kinds() {
  std::vector<Kind> all;
  for (const KnownKind& k : known()) all.push_back({k.handler->kind, k.handler->inputs, k.handler->variants});
  return all;
}

}  // namespace isect::query
