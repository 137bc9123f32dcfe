#include "app/scene/spans.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace isect::program::scene {

namespace {

/// Decodes escapes: "\u0061" is "a".
std::string without_escapes(const std::string& written) {
  if (written.find('\\') == written.npos) return written;
  const nlohmann::json text = nlohmann::json::parse('"' + written + '"', nullptr, false);
  return text.is_string() ? text.get<std::string>() : written;
}

}  // namespace

Spans::Spans(const std::string& text) : text_(text) { value("", 1); }

const Spans::Span* Spans::at(const std::string& path) const {
  const auto found = all_.find(path);
  return found == all_.end() ? nullptr : &found->second;
}

void Spans::skip() {
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

std::string Spans::string() {
  const std::size_t begin = std::min(++at_, text_.size());
  while (at_ < text_.size() && text_[at_] != '"') at_ += text_[at_] == '\\' ? 2 : 1;
  at_ = std::min(at_, text_.size());
  return text_.substr(begin, at_++ - begin);
}

void Spans::value(const std::string& path, int level) {
  skip();
  const std::size_t begin = at_;
  const char first = at_ < text_.size() ? text_[at_] : '\0';
  if (first == '{' || first == '[') {
    if (level > most_levels) {
      too_deep_ = at_, at_ = text_.size();
      return;
    }
    ++at_;
    int count = 0;
    for (skip(); at_ < text_.size() && text_[at_] != '}' && text_[at_] != ']'; skip()) {
      const std::size_t before = at_;
      const std::string below = path + "/" + (first == '{' ? without_escapes(string()) : std::to_string(count++));
      if (all_.contains(below)) twice_.push_back(below);
      value(below, level + 1);
      if (at_ <= before) ++at_;  // no JSON
    }
    ++at_;
  } else if (first == '"') {
    string();
  } else {
    at_ = std::min(text_.find_first_of(" \t\r\n,]}/", at_), text_.size());
  }
  at_ = std::min(at_, text_.size());
  all_[path] = {begin, at_};
}

}  // namespace isect::program::scene
