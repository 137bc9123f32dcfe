#pragma once
// The text of a scene file while it is read: fields by their path, and errors with their lines.

#include <string>
#include <vector>

#include "app/scene/objects.h"
#include "app/scene/spans.h"

namespace isect::program::scene {

/// Keys, and numbers of entries: {"objects", "2", "lo"}.
using Path = std::vector<std::string>;
Path below(Path, const std::string& key);

class Source {
 public:
  /// Throws viz::BadInput if it is no JSON, nests too deep or gives a field twice.
  explicit Source(const std::string& text);

  const Json& json() const { return json_; }
  /// Throws viz::BadInput: "line 3: objects[2].lo: why".
  [[noreturn]] void refuse(const Path&, const std::string& why) const;
  /// Returns "line 3: objects[2].lo".
  std::string place(const Path&) const;
  /// Returns the line of a field, from 1, or of the object that lacks it.
  int line_of(const Path&) const;

  // Return or check what is expected at a place; anything else is refused.
  void only(const Json& object, const Path&, const std::vector<std::string>& allowed,
            const std::vector<std::string>& ignored = {}) const;
  const Json& member(const Json& object, const Path&, const std::string& key) const;
  std::string text(const Json&, const Path&) const;
  double number(const Json&, const Path&) const;
  const Json& list(const Json&, const Path&, std::size_t least, std::size_t most, const std::string& of) const;
  /// Reads a vector with as many coordinates as the first one of the file.
  viz::Vec3 vector(const Json&, const Path&);

  bool flat() const { return dimension_ == 2; }
  /// Requires two or three coordinates, for the whole scene from here on.
  void need_dimension(std::size_t, const Path&);

 private:
  int line_at(std::size_t byte) const;
  int column_at(std::size_t byte) const;

  Json parsed() const;

  const std::string& text_;
  Spans spans_;
  Json json_;
  std::size_t dimension_ = 0;  ///< 0 until there is a point
};

}  // namespace isect::program::scene
