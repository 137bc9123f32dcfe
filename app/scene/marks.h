#pragma once
// Marks that the author of a scene puts into its picture: computed points, arrows, lengths, angles, braces. None of
// them is asked about; a mark whose place does not exist is told in words, not drawn.

#include <optional>
#include <string>
#include <vector>

#include "app/scene/spots.h"
#include "viz/camera.h"

namespace isect::program::scene {

struct AuthorMark {
  enum class Kind { point, arrow, line, dimension, brace, angle, right_angle };
  Kind kind = Kind::point;
  std::vector<Spot> spots = {};           ///< one of a point, three of an angle, else two
  std::string name = {};                  ///< of a point, by which later marks name it
  std::optional<std::string> label = {};  ///< markup; none: a length or an angle tells itself, a point its name
  std::optional<double> offset = {};      ///< of a length or a brace: how far it stands beside its points
  viz::Role role = viz::Role::text;
  StepRange steps = {};

  bool tells(const File&) const;  ///< whether the answer to a question tells one of its places
};

/// Reads "marks" into the file, whose objects were read before. Throws viz::BadInput, also for a right angle that is
/// none at the file's numbers.
void read_marks(Source&, File&);

/// A mark at the current numbers.
struct MarkPicture {
  std::vector<viz::Item> items = {};
  std::string said = {};     ///< markup, for readers who can't see it: "the length from p to q: 5"
  std::string missing = {};  ///< markup, a sentence: why it is not drawn; else empty
};
/// Draws a mark, lengths and braces across the view of this camera. Throws viz::BadInput if the core refuses the
/// numbers.
MarkPicture picture_of(const Context&, const AuthorMark&, const viz::Camera&);

}  // namespace isect::program::scene
