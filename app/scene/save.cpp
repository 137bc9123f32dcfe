#include "app/scene/save.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <vector>

#include "viz/files.h"

namespace isect::program::scene {

namespace {

struct Span {
  std::size_t begin, end;
};

/// Where each value of a JSON text stands, by its path: "objects/2/center". The text has been read before, so it is
/// JSON, with comments.
class Spans {
 public:
  explicit Spans(const std::string& text) : text_(text) { value(""); }

  const Span* at(const std::string& path) const {
    const auto found = all_.find(path);
    return found == all_.end() ? nullptr : &found->second;
  }

 private:
  void skip() {
    for (;;) {
      at_ = std::min(text_.find_first_not_of(" \t\r\n,:", at_), text_.size());
      if (text_.compare(at_, 2, "//") == 0)
        at_ = std::min(text_.find('\n', at_), text_.size());
      else if (text_.compare(at_, 2, "/*") == 0)
        at_ = std::min(text_.find("*/", at_) + 2, text_.size());
      else
        return;
    }
  }

  std::string string() {
    const std::size_t begin = ++at_;
    while (at_ < text_.size() && text_[at_] != '"') at_ += text_[at_] == '\\' ? 2 : 1;
    return text_.substr(begin, at_++ - begin);
  }

  void value(const std::string& path) {
    skip();
    const std::size_t begin = at_;
    const char first = at_ < text_.size() ? text_[at_] : '\0';
    if (first == '{' || first == '[') {
      ++at_;
      int count = 0;
      for (skip(); at_ < text_.size() && text_[at_] != '}' && text_[at_] != ']'; skip())
        value(path + "/" + (first == '{' ? string() : std::to_string(count++)));
      ++at_;
    } else if (first == '"') {
      string();
    } else {
      at_ = std::min(text_.find_first_of(" \t\r\n,]}/", at_), text_.size());
    }
    all_[path] = {begin, at_};
  }

  const std::string& text_;
  std::size_t at_ = 0;
  std::map<std::string, Span> all_;
};

/// The paths at which a field may stand: that of a vertex depends on how the object is written.
std::vector<std::string> places(const Object& o, const std::string& field) {
  std::vector<std::string> all = {"/" + field};
  if (o.type == Type::kdop) all.push_back(fmt::format("/{}/{}", field.substr(0, 2), std::stoi(field.substr(2)) - 1));
  if (field.find_first_not_of("0123456789") != field.npos) return all;
  int left = std::stoi(field) - 1;
  all.push_back(fmt::format("/points/{}", left));
  for (std::size_t ring = 0; ring < o.rings.size(); left -= o.rings[ring++])
    if (left >= 0 && left < o.rings[ring]) all.push_back(fmt::format("/rings/{}/{}", ring, left));
  return all;
}

std::string written(const viz::Setting& setting, bool flat) {
  if (const double* x = std::get_if<double>(&setting)) return viz::to_text(*x);
  const auto& p = std::get<viz::Vec3>(setting);
  return fmt::format("[{}, {}{}]", viz::to_text(p.x()), viz::to_text(p.y()), flat ? "" : ", " + viz::to_text(p.z()));
}

}  // namespace

std::string with_numbers(const std::string& text, const File& file, const viz::Parameters& parameters) {
  const Spans spans(text);
  std::map<std::size_t, std::pair<std::size_t, std::string>, std::greater<>> changes;  // the last one first
  for (std::size_t i = 0; i < file.objects.size(); ++i)
    for (const std::string& field : file.objects[i].fields) {
      const std::string name = file.objects[i].name + "." + field;
      if (parameters.at(name) == file.parameters.at(name)) continue;
      const Span* span = nullptr;
      for (const std::string& place : places(file.objects[i], field))
        if (!span) span = spans.at(fmt::format("/objects/{}{}", i, place));
      if (!span)
        throw viz::BadInput(fmt::format("{}: it stands in a file of its own, which isect does not change", name));
      changes[span->begin] = {span->end, written(parameters.at(name), file.flat)};
    }
  std::string out = text;
  for (const auto& [begin, change] : changes) out.replace(begin, change.first - begin, change.second);
  return out;
}

KeptFile::KeptFile(const std::string& path) : path_(path), text_(viz::read_regular_file(path)) {}

void KeptFile::save(const viz::Parameters& parameters) {
  if (viz::read_regular_file(path_) != text_)
    throw viz::FileError(
        fmt::format("cannot write '{}': somebody has changed it since it was opened; open it again", path_));
  const File file = read_scene(text_, std::filesystem::path(path_).parent_path().string());
  const std::string text = with_numbers(text_, file, parameters);
  viz::write_file(path_, text);
  text_ = text;
}

}  // namespace isect::program::scene
