#pragma once
// Points and faces as a file has them become points and triangles.

#include <string>
#include <vector>

#include "app/scene/files/shape_file.h"

namespace isect::program::scene {

/// A face may name points that come after it. Faces of more than three corners are cut by ears, as they are seen along
/// the axis of the normal's largest component; where their corners lie in no one plane, a note says so.
class MeshBuilder {
 public:
  struct Places {
    std::string of_face = "line";  ///< what the numbers of places count
    int first_point = 0;           ///< the number that the file has for the first point
  };
  MeshBuilder(const std::string& file, Places places) : file_(file), places_(std::move(places)) {}

  /// Of a finite point.
  void add(const viz::Vec3& point, int place);
  std::size_t count() const { return mesh_.points.size(); }

  void begin_face(int place);
  /// A corner of the face that was begun last, by the number of its point from 0.
  void corner(long point);
  /// What has no area, as a line or a point, is told and left out.
  void leave_out(int place);

  /// Throws viz::BadInput where a face names no point, has fewer than three corners, or crosses itself.
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
