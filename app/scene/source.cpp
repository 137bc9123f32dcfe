#include "app/scene/source.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace isect::program::scene {

namespace {

/// "objects[2].lo"
std::string told(const Path& path) {
  std::string text;
  for (const std::string& key : path) {
    const bool entry = key.find_first_not_of("0123456789") == key.npos;
    text += entry ? "[" + key + "]" : (text.empty() ? "" : ".") + key;
  }
  return text;
}

/// The last part of the parser's sentence.
std::string reason(const std::string& what) {
  const std::size_t dash = what.find(" - ");
  return dash == what.npos ? what.substr(what.find("] ") + 2) : what.substr(dash + 3);
}

}  // namespace

Path below(Path path, const std::string& key) {
  path.push_back(key);
  return path;
}

Source::Source(const std::string& text) : text_(text) {
  try {
    json_ = Json::parse(text, nullptr, true, true);
  } catch (const Json::parse_error& e) {
    throw viz::BadInput(fmt::format("line {}: no JSON; {}", line_at(e.byte > 0 ? e.byte - 1 : 0), reason(e.what())));
  }
}

int Source::line_at(std::size_t byte) const {
  return 1 + static_cast<int>(std::count(
                 text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text_.size())), '\n'));
}

/// The line of a field: its keys are looked for one after the other, entries of "objects" by how often they begin.
int Source::line_of(const Path& path) const {
  std::size_t at = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (i == 1 && path[0] == "objects") {
      for (int left = std::stoi(path[1]) + 1; left > 0 && at != text_.npos; --left) at = text_.find('{', at + 1);
    } else if (path[i].find_first_not_of("0123456789") != path[i].npos) {
      const std::size_t found = text_.find('"' + path[i] + '"', at);
      if (found != text_.npos) at = found;
    }
    if (at == text_.npos) return line_at(text_.size());
  }
  return line_at(at);
}

void Source::refuse(const Path& path, const std::string& why) const {
  throw viz::BadInput(fmt::format("line {}: {}: {}", line_of(path), path.empty() ? "the file" : told(path), why));
}

void Source::only(const Json& object, const Path& path, const std::vector<std::string>& allowed) const {
  if (!object.is_object()) refuse(path, "an object in braces is expected");
  for (const auto& [key, value] : object.items())
    if (std::ranges::find(allowed, key) == allowed.end())
      refuse(below(path, key), fmt::format("unknown; did you mean \"{}\"? Allowed: {}", viz::nearest(key, allowed),
                                           fmt::join(allowed, ", ")));
}

const Json& Source::member(const Json& object, const Path& path, const std::string& key) const {
  if (!object.contains(key)) refuse(path, fmt::format("\"{}\" is missing", key));
  return object[key];
}

std::string Source::text(const Json& value, const Path& path) const {
  if (!value.is_string()) refuse(path, "a text is expected");
  return value;
}

double Source::number(const Json& value, const Path& path) const {
  if (!value.is_number() || !std::isfinite(value.get<double>())) refuse(path, "a finite number is expected");
  return value;
}

const Json& Source::list(const Json& value, const Path& path, std::size_t least, std::size_t most,
                         const std::string& of) const {
  if (!value.is_array() || value.size() < least || value.size() > most)
    refuse(path, least == most ? fmt::format("{} {} {} expected", least, of, least == 1 ? "is" : "are")
                               : fmt::format("a list of {} to {} {} is expected", least, most, of));
  return value;
}

void Source::need_dimension(std::size_t coordinates, const Path& path) {
  if (dimension_ == 0) dimension_ = coordinates;
  if (dimension_ != coordinates)
    refuse(path, fmt::format("{} coordinates in a scene whose others have {}", coordinates, dimension_));
}

viz::Vec3 Source::vector(const Json& value, const Path& path) {
  const bool two = value.is_array() && value.size() == 2, three = value.is_array() && value.size() == 3;
  if (!two && !three) refuse(path, "two or three numbers are expected, as in [1, 2]");
  need_dimension(value.size(), path);
  viz::Vec3 v = viz::Vec3::Zero();
  for (std::size_t i = 0; i < value.size(); ++i)
    v[static_cast<int>(i)] = number(value[i], below(path, std::to_string(i)));
  return v;
}

}  // namespace isect::program::scene
