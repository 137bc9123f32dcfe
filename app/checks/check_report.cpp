#include "app/checks/check_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/checks/causes.h"
#include "app/shell/terminal.h"
#include "viz/formats/files.h"
#include "viz/player/reader_state.h"

namespace isect::program {

namespace {

using Json = nlohmann::ordered_json;
using Kind = Failure::Kind;

bool open(const Failure& f) { return !f.accepted; }
std::size_t open_failures(const Report& r) { return static_cast<std::size_t>(std::ranges::count_if(r.failures, open)); }

std::string counted(std::size_t n, const std::string& what) {
  return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

/// Returns "2 failures in 5 pictures and the trace of 1 preset".
std::string failed(const Report& r) {
  const std::string failures = counted(open_failures(r), "failure");
  if (r.checked.empty()) return failures;  // no preset could be read
  return fmt::format("{} in {} and the trace{} of {}", failures, counted(r.pictures, "picture"),
                     r.checked.size() == 1 ? "" : "s", counted(r.checked.size(), "preset"));
}

/// Whether not one file of the preset exists, which is reported in one line.
bool all_missing(const Failure& f) {
  return f.kind == Kind::missing && !viz::is_there(std::filesystem::path(f.baseline).parent_path());
}

/// More failures of one cause than this are told in a line each, after the first.
constexpr std::size_t most_in_full = 6;

/// Returns a failure's line, and if it is told `in_full`, the lines below it.
std::string text_of(const Failure& f, bool in_full) {
  if (f.accepted)
    return fmt::format("{} {}: {}\n", inked(Ink::good, f.kind == Kind::orphan ? "removed" : "accepted"), where(f),
                       f.kind == Kind::moved ? "moved from " + f.baseline : f.baseline);
  if (f.kind == Kind::moved) return fmt::format("{} {}: {}\n", inked(Ink::bad, "MOVED"), where(f), f.what);
  if (all_missing(f)) {
    if (f.step >= 0) return {};
    return fmt::format("{} {}: {}\n", inked(Ink::bad, "MISSING"), where(f),
                       std::filesystem::path(f.baseline).parent_path().string());
  }
  if (f.kind == Kind::missing) return fmt::format("{} {}: {}\n", inked(Ink::bad, "MISSING"), where(f), f.baseline);
  if (f.pointer) return fmt::format("{} {}: {} is {}\n", inked(Ink::bad, "FAILED"), where(f), f.baseline, f.what);
  std::string text = fmt::format("{} {}: {}: {}\n", inked(Ink::bad, "FAILED"), where(f), name_of(f.kind), f.what);
  if (!in_full) return text;
  constexpr std::size_t enough = 4;
  for (std::size_t i = 0; i < std::min(enough, f.more.size()); ++i) text += fmt::format("    {}\n", f.more[i]);
  if (f.more.size() > enough) text += fmt::format("    and {} more\n", f.more.size() - enough);
  for (const std::string& line : details(f)) text += "    " + line + "\n";
  return text;
}

/// Whether a failure that is told in full takes several lines.
bool takes_lines(const Failure& f) {
  return f.kind != Kind::missing && f.kind != Kind::orphan && f.kind != Kind::moved && !f.pointer;
}

/// Returns all failures, and how many there are of each cause.
std::string text_of_all(const Report& r) {
  const std::vector<CauseGroup> groups = by_cause(r);
  std::set<const Failure*> in_short;
  for (const CauseGroup& group : groups)
    if (group.failures.size() > most_in_full && takes_lines(*group.failures.front()))
      in_short.insert(group.failures.begin() + 1, group.failures.end());
  std::string text;
  for (const Failure& f : r.failures)
    if (!(r.nothing_there && f.kind == Kind::missing)) text += text_of(f, !in_short.contains(&f));
  if (in_short.empty() || r.nothing_there) return text;
  text += "by cause:\n";
  for (const CauseGroup& group : groups) text += "    " + heading(group) + "\n";
  return text;
}

std::string nothing_there(const Report& r) {
  const std::string whose =
      r.lessons.size() > 3 ? counted(r.lessons.size(), "lesson") : fmt::format("{}", fmt::join(r.lessons, ", "));
  std::string text = fmt::format("no baselines here: those of {} are looked for in {}\n", whose,
                                 std::filesystem::absolute(r.folder).lexically_normal().string());
  if (r.asked.dir.empty())
    text += "  if they lie elsewhere, give --snapshots DIR; for presets of your own, --dir DIR\n";
  return text +
         fmt::format("  to see what would be accepted, give --report new.html; to accept it: {}\n", accept_command(r));
}

}  // namespace

std::string where(const Failure& f) {
  std::string text = f.lesson.empty() ? f.preset : f.lesson + " " + f.preset;
  if (f.step >= 0) text += fmt::format(", step {}{}", f.step + 1, f.slug.empty() ? "" : " (" + f.slug + ")");
  if (!f.look.empty()) text += ", " + f.look;
  return text;
}

std::string summary(const Report& r) {
  std::string text = open_failures(r) > 0 ? failed(r)
                                          : fmt::format("ok: {} of {}", counted(r.pictures, "picture"),
                                                        counted(r.checked.size(), "preset"));
  const auto settled = [&](bool removed) {
    return std::ranges::count_if(r.failures,
                                 [&](const Failure& f) { return f.accepted && (f.kind == Kind::orphan) == removed; });
  };
  if (const auto n = settled(false); n > 0) text += fmt::format("; {} accepted", n);
  if (const auto n = settled(true); n > 0) text += fmt::format("; {} removed", n);
  return text;
}

std::vector<std::string> details(const Failure& f) {
  std::vector<std::string> lines;
  if (f.kind != Kind::preset) lines.push_back("baseline    " + f.baseline);
  if (!f.fresh.empty()) lines.push_back("new         " + f.fresh);
  if (!f.difference.empty()) lines.push_back("difference  " + f.difference);
  for (const std::string& note : f.notes) lines.push_back("note        " + note);
  if (f.foreign && !f.pointer)
    lines.push_back(
        "note        the file in its place was not made by isect, so nothing replaces it; move it away "
        "first");
  return lines;
}

std::string left_alone_text(const std::string& file) try {
  return file + (is_lfs_pointer(viz::read_regular_file(file)) ? " is a Git LFS pointer; git lfs pull fetches the file"
                                                              : " was not made by isect");
} catch (const viz::FileError& e) {
  return e.what();
}

int status(const Report& r) {
  const auto any_open = [&](auto&& of_kind) {
    return std::ranges::any_of(r.failures, [&](const Failure& f) { return open(f) && of_kind(f.kind); });
  };
  if (any_open([](Kind k) { return k != Kind::missing && k != Kind::preset; })) return check_failed;
  if (any_open([](Kind k) { return k == Kind::preset; })) return bad_input;
  return any_open([](Kind) { return true; }) ? baseline_missing : done;
}

std::string to_text(const Report& r) {
  std::string text = text_of_all(r);
  if (r.nothing_there) return text + nothing_there(r);
  for (const std::string& file : r.left_alone) text += fmt::format("left alone: {}\n", left_alone_text(file));
  if (const std::string command = accept_command(r); !command.empty())
    text += fmt::format("to accept {}: {}\n", open_failures(r) == 1 ? "it" : "all of it", command);
  return text + summary(r) + "\n";
}

std::string to_json(const Report& r) {
  Json failures = Json::array();
  for (const Failure& f : r.failures) {
    Json object = {{"kind", name_of(f.kind)}, {"lesson", f.lesson}, {"preset", f.preset}};
    if (f.step >= 0) object.update({{"step", f.step + 1}, {"slug", f.slug}});
    if (!f.look.empty()) object["look"] = f.look;
    object.update({{"what", f.what}, {"cause", cause_of(f)}, {"baseline", f.baseline}});
    if (f.line > 0) object["line"] = f.line;
    if (!f.more.empty()) object["more"] = f.more;
    if (!f.notes.empty()) object["notes"] = f.notes;
    if (f.foreign) object["foreign"] = true;
    if (f.kind == Kind::picture)
      object.update({{"pixels_over_8", f.pixels.over_8},
                     {"pixels_over_1", f.pixels.over_1},
                     {"share_seen", f.eye.share_seen()},
                     {"largest_oklab", f.eye.largest},
                     {"mean_oklab", f.eye.mean}});
    if (!f.fresh.empty()) object["new"] = f.fresh;
    if (!f.difference.empty()) object["difference"] = f.difference;
    object["accepted"] = f.accepted;
    if (const std::string command = accept_command(r, f); !command.empty()) object["accept"] = command;
    failures.push_back(object);
  }
  Json causes = Json::array();
  for (const CauseGroup& group : by_cause(r))
    causes.push_back({{"cause", group.cause}, {"failures", group.failures.size()}});
  Json result = {{"passed", open_failures(r) == 0},
                 {"version", viz::version()},
                 {"lessons", r.lessons},
                 {"presets", r.checked.size()},
                 {"pictures", r.pictures},
                 {"causes", causes},
                 {"failures", failures},
                 {"left_alone", r.left_alone}};
  if (const std::string command = accept_command(r); !command.empty()) result["accept"] = command;
  return result.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace isect::program
