// JUnit XML, which build servers read.

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/checks/check_report.h"

namespace isect::program {

namespace {

using Kind = Failure::Kind;

const std::string junit_head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"isect check\" ";

/// The open failures of one preset, in the order they were found.
using Case = std::vector<const Failure*>;
using Cases = std::vector<std::pair<std::string, Case>>;  ///< by preset

/// Returns a suite per lesson that was checked, then one per other name: of lessons that are gone, of broken presets.
std::vector<std::pair<std::string, Cases>> suites(const Report& r) {
  std::vector<std::pair<std::string, Cases>> found;
  const auto at = [](auto& list, const std::string& name) -> auto& {
    const auto known = std::ranges::find(list, name, [](const auto& entry) { return entry.first; });
    if (known != list.end()) return known->second;
    list.push_back({name, {}});
    return list.back().second;
  };
  for (const auto& [lesson, preset] : r.checked) at(at(found, lesson), preset);
  for (const Failure& f : r.failures)
    if (!f.accepted) at(at(found, f.lesson.empty() ? "presets" : f.lesson), f.preset).push_back(&f);
  return found;
}

/// Names the pictures that were written, as GitLab and Jenkins look for them.
std::string attachments(const Case& failures) {
  std::string files;
  for (const Failure* f : failures)
    for (const std::string& file : {f->fresh, f->difference})
      if (!file.empty()) files += "[[ATTACHMENT|" + escaped(file) + "]]\n";
  return files.empty() ? files : "      <system-out>" + files + "</system-out>\n";
}

std::string test_case(const Report& r, const std::string& lesson, const std::string& preset, const Case& failures) {
  const std::string head = fmt::format("    <testcase classname=\"{}\" name=\"{}\"", escaped(lesson), escaped(preset));
  if (failures.empty()) return head + "/>\n";
  std::string text;
  for (const Failure* f : failures) {
    text += fmt::format("{}: {}: {}\n", where(*f), name_of(f->kind), f->what);
    for (const std::string& more : f->more) text += "  " + more + "\n";
    for (const std::string& line : details(*f)) text += "  " + line + "\n";
  }
  std::string accept;  // for the whole preset, if anything may be accepted
  for (const Failure* f : failures)
    if (accept.empty() || f->kind != Kind::missing)
      if (const std::string command = accept_command(r, *f); !command.empty()) accept = command;
  if (!accept.empty()) text += "to accept: " + accept + "\n";
  const Failure& first = *failures.front();
  const char* tag = first.kind == Kind::preset ? "error" : "failure";
  return fmt::format("{0}>\n      <{1} type=\"{2}\" message=\"{3}\">{4}</{1}>\n{5}    </testcase>\n", head, tag,
                     name_of(first.kind), escaped(first.what), escaped(text), attachments(failures));
}

/// Returns "tests=\"27\" failures=\"2\" errors=\"0\"" for these suites.
std::string counts(const std::vector<std::pair<std::string, Cases>>& all) {
  int tests = 0, failures = 0, errors = 0;
  for (const auto& [lesson, cases] : all)
    for (const auto& [preset, found] : cases) {
      ++tests;
      if (!found.empty()) ++(found.front()->kind == Kind::preset ? errors : failures);
    }
  return fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\"", tests, failures, errors);
}

}  // namespace

std::string escaped(const std::string& text) {
  using Value = nlohmann::ordered_json;  // its escapes replace broken UTF-8
  const std::string whole = Value::parse(Value(text).dump(-1, ' ', false, Value::error_handler_t::replace));
  std::string out;
  for (const char c : whole)
    out += c == '&'                                      ? "&amp;"
           : c == '<'                                    ? "&lt;"
           : c == '>'                                    ? "&gt;"
           : c == '"'                                    ? "&quot;"
           : c >= 0 && c < ' ' && c != '\n' && c != '\t' ? "?"
                                                         : std::string(1, c);
  return out;
}

bool begins_junit_report(const std::string& bytes) { return bytes.starts_with(junit_head); }

std::string to_junit(const Report& r) {
  const auto all = suites(r);
  std::string xml = junit_head + counts(all) + ">\n";
  for (const auto& suite : all) {
    xml += fmt::format("  <testsuite name=\"{}\" {}>\n", escaped(suite.first), counts({suite}));
    for (const auto& [preset, failures] : suite.second) xml += test_case(r, suite.first, preset, failures);
    xml += "  </testsuite>\n";
  }
  return xml + "</testsuites>\n";
}

}  // namespace isect::program
