#pragma once
// The two walks of two triangles, and what they share: the corners' sides, the verdict, and what a mesh needs.

#include <isect/counted.h>
#include "lessons/shared/teller.h"
#include "lessons/triangle_triangle/picture.h"

namespace isect::lessons::triangle_triangle_lesson {

viz::Walk intervals(const Setup&);  ///< by the parts of the line of both planes
viz::Walk signs(const Setup&);      ///< by the signs of volumes alone

/// "**a**_0"
std::string corner_name(int which, int i);
/// "a", "b"
inline std::string triangle_name(int which) { return which == 0 ? "a" : "b"; }

class Teller : protected PictureTeller<Setup, Known> {
 protected:
  Teller(const Setup&, const std::string& title, const std::string& source, std::vector<std::string> pseudocode);

  void two_triangles(int line);
  /// How the corners of one triangle lie to the other's plane, as `signs` say.
  std::string told_sides(int which, const triangle_triangle::Signs& signs) const;
  /// Asks what follows from the sides of the corners of a. `given` tells them.
  viz::Question sides_question(const triangle_triangle::Signs& signs, const std::string& given) const;
  /// Says whether a side of one has the other beyond it, by the last of the events.
  void in_plane(int line, const triangle_triangle::InPlane& last);
  /// Adds the last steps: the last side that was asked, if in one plane, what the exact test says, and what that is to
  /// a mesh.
  viz::Walk end();

  std::optional<triangle_triangle::InPlane> last_side_;
  int line_ = 13;       ///< where the method ends
  bool found_ = false;  ///< what the method says

 private:
  std::string reason() const;
  std::string interior() const;  ///< what the word means here
  std::string in_a_mesh() const;
};

}  // namespace isect::lessons::triangle_triangle_lesson
