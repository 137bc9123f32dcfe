#include "app/checks/accept_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "app/program.h"
#include "app/shell/terminal.h"
#include "viz/formats/files.h"
#include "viz/lesson.h"
#include "viz/snapshot/json.h"

namespace isect::program {

namespace {

using AcceptJson = nlohmann::ordered_json;
using Became = Acceptance::Outcome::Is;

constexpr std::size_t no_file = static_cast<std::size_t>(-1);

bool is_digest(const std::string& text) {
  return text.size() == 16 && text.find_first_not_of("0123456789abcdef") == text.npos;
}

/// Whether the path stays below the folder that it is relative to.
bool stays_below(const std::filesystem::path& path) {
  return !path.empty() && path.is_relative() && path.has_filename() && path.lexically_normal() == path &&
         *path.begin() != "..";
}

std::string text_field(const AcceptJson& entry, const char* field) {
  if (!entry.contains(field)) throw viz::BadInput(fmt::format("{}: missing", field));
  if (!entry[field].is_string()) throw viz::BadInput(fmt::format("{}: {} is no text", field, entry[field].dump()));
  return entry[field].get<std::string>();
}

Reviewed reviewed_of(const AcceptJson& entry) {
  if (!entry.is_object())
    throw viz::BadInput(fmt::format("{} is no object with \"file\" and \"digest\"", entry.dump()));
  for (const auto& item : entry.items())
    if (item.key() != "file" && item.key() != "digest" && item.key() != "remove")
      throw viz::unknown("field", item.key(), {"file", "digest", "remove"});
  Reviewed reviewed = {text_field(entry, "file"), text_field(entry, "digest")};
  if (!stays_below(reviewed.file))
    throw viz::BadInput(fmt::format("file: \"{}\" is no path below the folder of the baselines", reviewed.file));
  if (!is_digest(reviewed.digest))
    throw viz::BadInput(fmt::format("digest: \"{}\" has not 16 hexadecimal digits", reviewed.digest));
  if (entry.contains("remove")) {
    if (!entry["remove"].is_boolean())
      throw viz::BadInput(fmt::format("remove: {} is neither true nor false", entry["remove"].dump()));
    reviewed.remove = entry["remove"].get<bool>();
  }
  return reviewed;
}

}  // namespace

std::string reviewed_json(const std::vector<Reviewed>& files) {
  AcceptJson list = AcceptJson::array();
  for (const Reviewed& r : files) {
    list.push_back({{"file", r.file}, {"digest", r.digest}});
    if (r.remove) list.back()["remove"] = true;
  }
  return list.dump(-1, ' ', false, AcceptJson::error_handler_t::replace);
}

std::vector<Reviewed> read_accept_file(const std::string& text) {
  const AcceptJson json = viz::snap::parsed(text);
  if (!json.is_object() || !json.contains("accept") || !json["accept"].is_array())
    throw viz::BadInput("this is no list that a report of isect check has saved: {\"accept\": [...]} is expected");
  std::vector<Reviewed> files;
  std::set<std::string> known;
  std::size_t number = 0;
  for (const AcceptJson& entry : json["accept"]) {
    ++number;
    try {
      files.push_back(reviewed_of(entry));
      if (!known.insert(files.back().file).second)
        throw viz::BadInput(fmt::format("file: {} is named before", files.back().file));
    } catch (const viz::BadInput& e) {
      throw viz::BadInput(fmt::format("accept {}: {}", number, e.what()));
    }
  }
  if (files.empty()) throw viz::BadInput("accept: no file is named; tick some in the report");
  return files;
}

Acceptance::Acceptance(std::vector<Reviewed> files) : files_(std::move(files)) {
  for (const Reviewed& r : files_) outcomes_.push_back({Became::open, r.file, {}});
}

std::size_t Acceptance::find(const std::string& file, bool remove) const {
  const auto found =
      std::ranges::find_if(files_, [&](const Reviewed& r) { return r.file == file && r.remove == remove; });
  return found == files_.end() ? no_file : static_cast<std::size_t>(found - files_.begin());
}

void Acceptance::end(std::size_t i, Outcome::Is is, const std::string& why) {
  outcomes_[i].is = is, outcomes_[i].why = why;
}

bool Acceptance::names(const std::string& file) const { return find(file, false) != no_file; }

bool Acceptance::names_some_in(const std::string& folder) const {
  return std::ranges::any_of(files_, [&](const Reviewed& r) { return r.file.starts_with(folder + "/"); });
}

bool Acceptance::removes() const { return std::ranges::any_of(files_, &Reviewed::remove); }

bool Acceptance::takes(const std::string& file, const Found& found) {
  const std::size_t i = find(file, false);
  if (i == no_file) return false;
  const bool as_reviewed = found.now == files_[i].digest;
  if (found.there == files_[i].digest || (as_reviewed && !found.differs)) {
    end(i, Became::already);
  } else if (!as_reviewed) {
    end(i, Became::refused, "it is something else now than what was reviewed; look at it in a new report");
  } else if (!found.hindrance.empty()) {
    end(i, Became::refused, found.hindrance);
  } else {
    end(i, Became::accepted);
  }
  return outcomes_[i].is == Became::accepted;
}

bool Acceptance::takes_away(const std::string& file, const std::string& there) {
  const std::size_t i = find(file, true);
  if (i == no_file) return false;
  if (there == files_[i].digest)
    end(i, Became::removed);
  else
    end(i, Became::refused, "it is something else now than what was reviewed; look at it in a new report");
  return outcomes_[i].is == Became::removed;
}

void Acceptance::close(const std::string& folder) {
  for (std::size_t i = 0; i < files_.size(); ++i) {
    if (outcomes_[i].is != Became::open) continue;
    if (!files_[i].remove)
      end(i, Became::refused, "no step has a baseline of this name; is this the folder that was reviewed?");
    else if (viz::is_there(folder + "/" + files_[i].file))
      end(i, Became::refused, "it is not left over: a step has it, or isect did not make it");
    else
      end(i, Became::already);
  }
}

std::string to_text(const Acceptance& acceptance) {
  std::string text;
  std::size_t accepted = 0, already = 0, refused = 0;
  for (const Acceptance::Outcome& o : acceptance.outcomes()) {
    accepted += o.is == Became::accepted || o.is == Became::removed;
    already += o.is == Became::already;
    refused += o.is == Became::refused;
    if (o.is == Became::accepted || o.is == Became::removed)
      text += fmt::format("{} {}\n", inked(Ink::good, o.is == Became::removed ? "removed" : "accepted"), o.file);
    else if (o.is == Became::already)
      text += fmt::format("as reviewed already {}\n", o.file);
    else
      text += fmt::format("{} {}: {}\n", inked(Ink::bad, "REFUSED"), o.file, o.why);
  }
  text += fmt::format("{} of {} accepted", accepted, acceptance.outcomes().size());
  if (already > 0) text += fmt::format("; {} as reviewed already", already);
  if (refused > 0) text += fmt::format("; {} refused", refused);
  return text + "\n";
}

std::string to_json(const Acceptance& acceptance) {
  AcceptJson json = {{"accepted", AcceptJson::array()},
                     {"removed", AcceptJson::array()},
                     {"already", AcceptJson::array()},
                     {"refused", AcceptJson::array()}};
  for (const Acceptance::Outcome& o : acceptance.outcomes())
    if (o.is == Became::refused)
      json["refused"].push_back({{"file", o.file}, {"why", o.why}});
    else
      json[o.is == Became::accepted ? "accepted" : o.is == Became::removed ? "removed" : "already"].push_back(o.file);
  return json.dump(2, ' ', false, AcceptJson::error_handler_t::replace) + "\n";
}

int status(const Acceptance& acceptance) {
  const bool refused =
      std::ranges::any_of(acceptance.outcomes(), [](const Acceptance::Outcome& o) { return o.is == Became::refused; });
  return refused ? check_failed : done;
}

}  // namespace isect::program
