#pragma once
// The walk of a polygon against a box: comparisons first, then a cut at each side.

#include "lessons/clipping/picture.h"
#include "lessons/shared/script.h"

namespace isect::lessons::clipping_lesson {

class PolygonTeller {
 public:
  PolygonTeller(const Ring<double, 2>&, const Box&);
  viz::Walk tell();

 private:
  // polygon.cpp
  bool trivial();
  void add_sides();
  void end();
  std::string end_caption(std::size_t n) const;

  // polygon_cut.cpp
  void cut(const Side&);
  int line_of(const Cut&) const;
  std::string caption(std::int64_t out, const Cut&) const;

  const Box box_;
  const Ring<double, 2> truth_;
  const std::size_t kept_;  ///< different vertices of what the two share
  Script script_;
  Rest known_;
  bool trivial_ = false, astray_ = false, bridges_ = false;
};

}  // namespace isect::lessons::clipping_lesson
