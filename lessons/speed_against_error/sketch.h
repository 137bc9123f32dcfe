#pragma once
// A small drawing in the plane of points, lines and circles of any size, scaled to the room of an inset.

#include <array>
#include <string>
#include <vector>

#include "viz/scene.h"

namespace isect::lessons::speed_against_error_lesson {

class Sketch {
 public:
  void ring(std::vector<viz::Vec2> corners, viz::Role role, bool dotted = false);
  void line(const viz::Vec2& from, const viz::Vec2& to, viz::Role role, viz::Pen pen = viz::Pen::solid);
  void arrow(const viz::Vec2& from, const viz::Vec2& to, viz::Role role);
  void circle(const viz::Vec2& center, double radius, viz::Role role);
  void dot(const viz::Vec2& at, viz::Role role);
  /// Lengths across and up are scaled apart: for what is too thin to be seen. Not with circles.
  void stretch() { stretched_ = true; }

  /// All of it as large as an inset may be, in coordinates that are the same on every machine.
  std::vector<viz::Item> items() const;

 private:
  struct Piece {
    enum class Kind { ring, line, arrow, circle, dot } kind;
    std::vector<viz::Vec2> points;
    viz::Role role;
    viz::Pen pen = viz::Pen::solid;
    double radius = 0;
    bool dotted = false;
  };

  std::vector<Piece> pieces_;
  bool stretched_ = false;
};

/// The outline of a convex body, and its edges, as they are seen from one direction.
struct Shadow {
  std::vector<viz::Vec2> outline;
  std::vector<std::array<viz::Vec2, 2>> edges;

  void draw(Sketch&, viz::Role) const;
};
/// Returns the shadow of a box with these eight corners, numbered so that the ends of an edge differ in one bit.
Shadow shadow(const std::array<viz::Vec2, 8>& corners);

/// "≈ 3.6" or "2": the number with two digits, as a note below a drawing has room for.
std::string about(double);
/// "*r* ≈ 3.6 and 0.2", or "*r* = 2" if both are.
std::string is_about(const std::string& name, double x, double y);
inline std::string is_about(const std::string& name, double x) { return is_about(name, x, x); }

/// One case, as it is drawn, and what the drawing can't show, as markup.
struct Drawing {
  Sketch sketch;
  std::string note = {};
};

}  // namespace isect::lessons::speed_against_error_lesson
