#pragma once
// Where each value of a JSON text stands, comments allowed.

#include <map>
#include <string>
#include <vector>

namespace isect::program::scene {

class Spans {
 public:
  struct Span {
    std::size_t begin, end;
  };
  /// Lists and objects within each other.
  static constexpr int most_levels = 64;

  /// Of a text that is no JSON, what of it could be made out.
  explicit Spans(const std::string& text);

  /// By the path of a value: "/objects/2/center". Null: there is none.
  const Span* at(const std::string& path) const;
  const std::map<std::string, Span>& all() const { return all_; }
  /// Paths of fields that an object gives twice.
  const std::vector<std::string>& twice() const { return twice_; }
  /// Where the first list or object begins that lies too deep; npos: nowhere.
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
