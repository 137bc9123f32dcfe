#pragma once
// A trapezoidal map, and the questions by which it is searched, as pictures.

#include <map>
#include <vector>

#include <isect/many/trapezoid_map.h>
#include "lessons/concave_polygon/picture.h"

namespace isect::lessons::concave_polygon_lesson {

/// How deep each question or trapezoid stands below the root, by its longest way.
std::map<int, int> depths(const TrapezoidMap&, int root = 0);
/// The trapezoids that a search from this question may end in.
std::vector<int> reachable(const TrapezoidMap&, int node);
/// How many questions and trapezoids there are.
struct Sizes {
  int questions, trapezoids;
};
Sizes sizes(const TrapezoidMap&);

/// Name of an x-node's vertex or a y-node's edge.
std::string name(const TrapezoidMap::Node&);

/// The trapezoid within the frame.
viz::Region trapezoid(const Frame&, const TrapezoidMap&, const TrapezoidMap::Trapezoid&, viz::Role);
/// The walls of all trapezoids.
void add_walls(viz::Scene&, const Frame&, const TrapezoidMap&);
/// The edge of a piece.
viz::Line edge(const TrapezoidMap&, int piece, viz::Role, viz::Pen);
/// All questions, in the table's place: circles for vertices, squares for edges, dots for trapezoids.
void add_graph(viz::Scene&, const Frame&, const TrapezoidMap&, bool named);

/// A question on the way of a search, and how it was answered.
struct Asked {
  int node, side;
};
/// The questions asked, one below the other; the last one is the one of this step.
void add_path(viz::Scene&, const Frame&, const TrapezoidMap&, const std::vector<Asked>&);

/// The map while it grows, with these edges inserted, the last one `fresh`; -1: none.
viz::Scene grown(const Setup&, const TrapezoidMap&, const std::vector<int>& inserted, int fresh);
/// The map during a search, with what can be reached from the node `next`; -1: none.
viz::Scene searched(const Setup&, const TrapezoidMap&, const std::vector<Asked>&, int next);
/// The map with the trapezoid found; -1: on an edge.
viz::Scene found(const Setup&, const TrapezoidMap&, const std::vector<Asked>&, int reached);

}  // namespace isect::lessons::concave_polygon_lesson
