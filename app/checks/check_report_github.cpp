// The result for GitHub Actions: annotations as workflow commands, and a summary of the job in Markdown.
//
// Source: GitHub Docs, "Workflow commands for GitHub Actions"; the escapes are those of actions/toolkit, command.ts.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/checks/causes.h"
#include "app/checks/check_report.h"

namespace isect::program {

namespace {

constexpr std::size_t most_annotations = 10;  ///< errors that GitHub shows of a step
constexpr std::size_t most_rows = 40;         ///< of the summary
constexpr std::size_t most_places = 5;        ///< of a cause

/// Returns a text of at most so many bytes, letters whole.
std::string cut_to(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  std::size_t end = most;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return text.substr(0, end) + "…";
}

std::string with_escapes(const std::string& text, const std::string& special) {
  std::string out;
  for (const char c : text)
    out += special.find(c) == special.npos
               ? std::string(1, c)
               : fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
  return out;
}

/// Returns the file as the repository calls it, in which the check was started.
std::string file_in_repository(const std::string& file) {
  const std::filesystem::path path = file, here = std::filesystem::current_path();
  const std::filesystem::path below = path.is_absolute() ? path.lexically_relative(here) : path.lexically_normal();
  return below.empty() || *below.begin() == ".." ? file : below.string();
}

std::string error_at(const std::string& file, int line, const std::string& title, const std::string& message) {
  const std::string place =
      file.empty() ? "" : fmt::format("file={},line={},", github_property(file_in_repository(file)), std::max(line, 1));
  return fmt::format("::error {}title={}::{}\n", place, github_property(cut_to("isect check: " + title, 200)),
                     github_message(cut_to(message, 3000)));
}

/// Returns where it happened: "a, step 1; b, step 2; and 9 more".
std::string places_of_cause(const CauseGroup& group) {
  std::string text;
  for (std::size_t i = 0; i < std::min(most_places, group.failures.size()); ++i)
    text += (i == 0 ? "" : "; ") + where(*group.failures[i]);
  if (group.failures.size() > most_places) text += fmt::format("; and {} more", group.failures.size() - most_places);
  return text;
}

std::string to_accept_all(const Report& r) {
  const std::string command = accept_command(r);
  return command.empty() ? "" : "\nto accept all of it: " + command;
}

std::string annotation_of(const Report& r, const CauseGroup& group) {
  const Failure& first = *group.failures.front();
  const std::string others = group.failures.size() > 1 ? "\nin " + places_of_cause(group) : "";
  return error_at(first.baseline, first.line, heading(group),
                  fmt::format("{}: {}{}{}", where(first), first.what, others, to_accept_all(r)));
}

/// Returns the text so that Markdown, in a table, shows it as it is.
std::string as_markdown(const std::string& text) {
  std::string out;
  for (const char c : text)
    if (c == '\n' || c == '\r')
      out += ' ';
    else if (c == '<' || c == '&')
      out += c == '<' ? "&lt;" : "&amp;";
    else
      out += (std::string_view("\\`*_{}[]#|~$").find(c) == std::string_view::npos ? "" : "\\") + std::string(1, c);
  return out;
}

}  // namespace

std::string github_message(const std::string& text) { return with_escapes(text, "%\r\n"); }
std::string github_property(const std::string& text) { return with_escapes(text, "%\r\n:,"); }

std::string to_github(const Report& r) {
  const std::vector<CauseGroup> groups = by_cause(r);
  const std::size_t own = groups.size() > most_annotations ? most_annotations - 1 : groups.size();
  std::string text;
  for (std::size_t i = 0; i < own; ++i) text += annotation_of(r, groups[i]);
  if (own == groups.size()) return text;
  std::string rest;
  for (std::size_t i = own; i < groups.size(); ++i) rest += (i == own ? "" : "\n") + heading(groups[i]);
  const Failure& first = *groups[own].failures.front();
  return text + error_at(first.baseline, first.line, fmt::format("{} more causes", groups.size() - own), rest);
}

std::string to_markdown(const Report& r) {
  const std::vector<CauseGroup> groups = by_cause(r);
  std::string text = fmt::format("## isect check\n\n{}\n", as_markdown(summary(r)));
  if (groups.empty()) return text;
  text += "\n| failed | cause | where |\n| --- | --- | --- |\n";
  for (std::size_t i = 0; i < std::min(most_rows, groups.size()); ++i)
    text += fmt::format("| {} | {} | {} |\n", counted(groups[i].failures), as_markdown(cut_to(groups[i].cause, 200)),
                        as_markdown(cut_to(places_of_cause(groups[i]), 300)));
  if (groups.size() > most_rows) text += fmt::format("\nand {} more causes\n", groups.size() - most_rows);
  if (const std::string command = accept_command(r); !command.empty())
    text += fmt::format("\nTo accept all of it:\n\n```\n{}\n```\n", cut_to(command, 2000));
  return text;
}

}  // namespace isect::program
