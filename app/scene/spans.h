#pragma once
// The place of each value in a JSON text, with comments allowed.

#include <map>
#include <string>
#include <vector>

namespace isect::program::scene {

class Spans {
 public:
  struct Span {
    std::size_t begin, end;
  };
  /// The most levels of nested lists and objects.
  static constexpr int most_levels = 64;

  /// If the text is no JSON, contains what could be made out.
  explicit Spans(const std::string& text);

  /// Returns the span of a value by its path: "/objects/2/center". Null: there is none.
  const Span* at(const std::string& path) const;
  const std::map<std::string, Span>& all() const { return all_; }
  /// Returns the paths of fields that an object gives twice.
  const std::vector<std::string>& twice() const { return twice_; }
  /// Returns where the first list or object begins that is nested too deep; npos: nowhere.
  std::size_t too_deep() const { return too_deep_; }

 private:
  void skip();
  std::string string();
  void value(const std::string& path, int level);

  const std::string& text_;
  std::size_t at_ = 0, too_deep_ = std::string::npos;
  std::map<std::string, Span> all_;
  std::vector<std::string> twice_;
};

}  // namespace isect::program::scene
