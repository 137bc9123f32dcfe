#pragma once
// Turns the points and faces of a file into points and triangles.

#include <string>
#include <vector>

#include "app/scene/files/shape_file.h"

namespace isect::program::scene {

/// A face may name points that come after it. Faces of more than three corners are cut by ears, seen along the axis of
/// the normal's largest component; if their corners are not coplanar, a note says so.
class MeshBuilder {
 public:
  struct Places {
    std::string of_face = "line";  ///< the unit that place numbers count
    int first_point = 0;           ///< the file's number for the first point
  };
  MeshBuilder(const std::string& file, Places places) : file_(file), places_(std::move(places)) {}

  /// Adds a finite point.
  void add(const viz::Vec3& point, int place);
  std::size_t count() const { return mesh_.points.size(); }

  void begin_face(int place);
  /// Adds a corner to the face that was begun last, by the number of its point from 0.
  void corner(long point);
  /// Notes and leaves out an object without area, such as a line or a point.
  void leave_out(int place);

  /// Returns the shape; throws viz::BadInput if a face names no point, has fewer than three corners, or crosses itself.
  ShapeFile made();

 private:
  struct Face {
    int place = 0;
    std::size_t begin = 0;  ///< of its corners
  };
  void cut(const Face&, const int* corners, std::size_t count);
  void keep(int a, int b, int c, int place);
  void add_notes();
  [[noreturn]] void refuse(int place, const std::string& why) const;

  const std::string& file_;
  Places places_;
  ShapeFile mesh_;
  std::vector<int> corners_;
  std::vector<Face> faces_;

  struct Told {
    int count = 0, first = 0;
    void see(int place) {
      if (count++ == 0) first = place;
    }
  };
  Told bent_, left_out_;
  double farthest_off_ = 0;
};

}  // namespace isect::program::scene
