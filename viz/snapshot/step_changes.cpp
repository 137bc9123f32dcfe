#include <fmt/format.h>

#include <algorithm>

#include "viz/snapshot/step_json.h"
#include "viz/text/rich_text.h"

namespace isect::viz::snap {
namespace {

std::string readable(const Json& value) { return value.is_string() ? plain(shown(value)) : shown(value); }

/// Moves `at` back to the start of a word (`forward`: on to the end of one), or by a few words beyond.
std::size_t word_before(const std::string& text, std::size_t at, int words) {
  while (at > 0 && (text[at - 1] != ' ' || --words >= 0)) --at;
  return at;
}
std::size_t word_after(const std::string& text, std::size_t at, int words) {
  while (at < text.size() && (text[at] != ' ' || --words >= 0)) ++at;
  return at;
}

/// Returns the words in which two texts differ, with two on either side, and dots where more was left out.
std::pair<std::string, std::string> differing_words(const std::string& was, const std::string& is) {
  const std::size_t least = std::min(was.size(), is.size());
  std::size_t head = 0, tail = 0;
  while (head < least && was[head] == is[head]) ++head;
  while (tail < least - head && was[was.size() - 1 - tail] == is[is.size() - 1 - tail]) ++tail;
  const auto cut = [&](const std::string& text) {
    const std::size_t from = word_before(text, head, 2), to = word_after(text, text.size() - tail, 2);
    return (from > 0 ? "… " : "") + text.substr(from, to - from) + (to < text.size() ? " …" : "");
  };
  return {cut(was), cut(is)};
}

std::string left_relation(const Json& c) { return shown(at(c, "left")) + " " + shown(at(c, "relation")); }

std::string both_sides(const Json& c) { return fmt::format("{} with {}", shown(at(c, "left")), shown(at(c, "right"))); }

/// Returns the inequalities that a condition joins.
Json parts_of(const Json& c) {
  const Json parts = at(c, "parts");
  return parts.is_array() ? parts : Json::array();
}

/// Compares one inequality, or a condition that joins several.
void compare_comparisons(const Json& was, const Json& is, Changes& changes) {
  if (was == is) return;
  const bool both = was.is_object() && is.is_object();
  if (!both)
    return changes.add(was.is_object()        ? "compares nothing any more"
                       : is.contains("parts") ? "compares " + readable(at(is, "text"))
                                              : "compares " + left_relation(is) + " " + shown(at(is, "right")));
  const Json old_parts = parts_of(was), parts = parts_of(is);
  if (parts.size() != old_parts.size())
    return changes.compare_texts("what is compared", at(was, "text"), at(is, "text"));
  for (std::size_t i = 0; i < parts.size(); ++i) compare_comparisons(old_parts[i], parts[i], changes);
  if (parts.empty() && both_sides(was) != both_sides(is))
    return changes.add(fmt::format("compared {}, now {}", both_sides(was), both_sides(is)));
  if (at(was, "relation") != at(is, "relation"))
    changes.add(fmt::format("{} {} became {} {}", left_relation(was), shown(at(is, "right")), shown(at(is, "relation")),
                            shown(at(is, "right"))));
  if (at(was, "holds") != at(is, "holds"))
    changes.add(fmt::format("the comparison of {} was {}, is {}",
                            parts.empty() ? both_sides(is) : readable(at(is, "text")), at(was, "holds").dump(),
                            at(is, "holds").dump()));
  // Each side by its name; a side that is a bare number has that number in its name.
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}})
    if (at(was, "values").is_array() && at(was, "values").size() == 2)
      changes.compare(shown(at(is, i == 0 ? "left" : "right")), at(was, "values")[i], at(is, "values")[i]);
  changes.compare_texts("text of the comparison", at(was, "text"), at(is, "text"));
  changes.compare_texts("meaning of the comparison", at(was, "meaning"), at(is, "meaning"));
}

/// Returns one of the values' columns, by name; a value that is listed twice is numbered.
Json column(const Json& values, std::size_t index) {
  Json object = Json::object();
  if (!values.is_array()) return object;
  for (const Json& v : values) {
    if (!v.is_array() || v.empty() || !v[0].is_string()) continue;
    const std::string name = plain(v[0].get<std::string>());
    std::string key = name;
    for (int n = 2; object.contains(key); ++n) key = fmt::format("{} #{}", name, n);
    object[key] = index < v.size() ? v[index] : Json("none");
  }
  return object;
}

void compare_values(const Json& was, const Json& is, Changes& changes) {
  if (was == is) return;
  changes.compare_all("", column(was, 1), column(is, 1));
  const std::size_t before = changes.count();
  constexpr std::pair<const char*, std::size_t> others[] = {{"unit", 2}, {"role", 3}, {"light", 4}};
  for (const auto& [what, index] : others) {
    const Json old_column = column(was, index), new_column = column(is, index);
    for (const auto& item : new_column.items())
      if (old_column.contains(item.key()))
        changes.compare(fmt::format("{} of {}", what, item.key()), old_column[item.key()], item.value());
  }
  if (changes.count() == before && column(was, 1) == column(is, 1)) changes.compare("values", was, is);
}

void compare_questions(const Json& was, const Json& is, Changes& changes) {
  if (was == is) return;
  if (!was.is_object()) return changes.add(fmt::format("asks “{}” now", readable(at(is, "prompt"))));
  if (!is.is_object()) return changes.add(fmt::format("asks “{}” no more", readable(at(was, "prompt"))));
  changes.compare_texts("answer", at(was, "answer"), at(is, "answer"));
  changes.compare_texts("question", at(was, "prompt"), at(is, "prompt"));
  changes.compare("choices", at(was, "choices"), at(is, "choices"));
  changes.compare_texts("reason of the answer", at(was, "because"), at(is, "because"));
  changes.compare("numbers given with the question", at(was, "given"), at(is, "given"));
  changes.compare("number to type", at(was, "number"), at(is, "number"));
  changes.compare("line to point at", at(was, "line to point at"), at(is, "line to point at"));
  changes.compare("order to give", at(was, "order"), at(is, "order"));
}

}  // namespace

void Changes::add(const std::string& what, const std::string& cause) {
  const auto known = [&](const Change& c) { return c.step == step_ && c.what == what; };
  if (std::ranges::none_of(found_, known)) found_.push_back({step_, what, of_, cause.empty() ? what : cause});
}

void Changes::compare(const std::string& name, const Json& was, const Json& is) {
  if (was == is) return;
  const std::string what = fmt::format("{} was {}, is {}", name, shown(was), shown(is));
  add(what, of_ == Change::Of::setting ? what : name + " changed");
}

void Changes::compare_texts(const std::string& name, const Json& was, const Json& is) {
  if (was == is) return;
  if (!was.is_string() || !is.is_string()) return compare(name, was, is);
  const std::string before = readable(was), now = readable(is);
  if (before == now) return compare("markup of the " + name, was, is);
  const auto [old_words, new_words] = differing_words(before, now);
  add(fmt::format("{} was {}, is {}", name, old_words, new_words), name + " changed");
}

void Changes::compare_all(const std::string& prefix, const Json& was, const Json& is) {
  for (const auto& item : is.items()) compare(prefix + item.key(), at(was, item.key()), item.value());
  for (const auto& item : was.items())
    if (!is.contains(item.key())) compare(prefix + item.key(), item.value(), at(is, item.key()));
}

void compare_steps(const Json& was, const Json& is, Changes& changes) {
  if (was == is) return;
  if (at(was, "slug") != at(is, "slug"))
    return changes.add(fmt::format("{} became {}", shown(at(was, "slug")), shown(at(is, "slug"))));
  const std::size_t before = changes.count();
  compare_comparisons(at(was, "comparison"), at(is, "comparison"), changes);
  changes.compare_texts("verdict", at(was, "verdict"), at(is, "verdict"));
  changes.compare("verdict of the core", at(was, "verdict of the core"), at(is, "verdict of the core"));
  changes.compare("pseudocode line", at(was, "line"), at(is, "line"));
  for (const std::string key : {"decides", "untaken", "refused"})
    changes.compare(key == "decides" ? key : key + " lines", at(was, key), at(is, key));
  for (const std::string key : {"title", "formula"}) changes.compare_texts(key, at(was, key), at(is, key));
  compare_values(at(was, "values"), at(is, "values"), changes);
  if (at(was, "counters").is_object()) changes.compare_all("count of ", at(was, "counters"), at(is, "counters"));
  changes.are_of(Change::Of::wording);
  compare_questions(at(was, "question"), at(is, "question"), changes);
  for (const std::string key : {"caption", "source"}) changes.compare_texts(key, at(was, key), at(is, key));
  if (changes.count() == before) changes.add("is written differently");
}

}  // namespace isect::viz::snap
