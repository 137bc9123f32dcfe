// The table of the tasks.

#include "app/grade/task.h"
#include "viz/lesson.h"
#include "viz/text/spelling.h"

namespace isect::grade {

namespace {

using Shape = Field::Shape;

constexpr double root_ulps = 4096;  // 1e-12: what the usual formulas give where nothing cancels
constexpr double slab_ulps = 64;

Field number_field(const char* name, const char* what, const char* bounds = "") {
  return {name, Shape::number, 1, 1, what, bounds};
}
Field vector_field(const char* name, int width, const char* what, const char* bounds = "") {
  return {name, Shape::vector, 1, width, what, bounds};
}
Field rows_field(const char* name, int rows, int width, const char* what, const char* bounds = "") {
  return {name, Shape::rows, rows, width, what, bounds};
}
Field list_field(const char* name, int width, const char* what, const char* bounds) {
  return {name, Shape::list, 0, width, what, bounds};
}

const char* const yes_or_no = "1 if they share a point, else 0 (yes, no, true and false are read, too)";
const char* const t_or_miss = "t of the first shared point, in lengths of dir, or the word miss";
const char* const closed = "All sets are closed: shapes that merely touch share a point.";
const char* const exact = "The numbers count as they are: there is no tolerance.";
const char* const of_ray = "The ray is origin + t dir with t >= 0; the origin belongs to it.";

std::vector<Field> ray_and(std::vector<Field> others) {
  std::vector<Field> fields = {vector_field("origin", 3, "where the ray begins"),
                               vector_field("dir", 3, "its direction, of any length", "not 0 0 0")};
  fields.insert(fields.end(), others.begin(), others.end());
  return fields;
}

std::vector<Task> of_volumes() {
  const auto obb = [](const std::string& name) {
    return std::vector<Field>{{name + ".c", Shape::vector, 1, 3, "the centre of " + name},
                              {name + ".u", Shape::rows, 3, 3, "its three axes, one a row", "unit, but for rounding"},
                              {name + ".e", Shape::vector, 1, 3, "its half-lengths along them", ">= 0"}};
  };
  std::vector<Field> two = obb("a");
  for (const Field& field : obb("b")) two.push_back(field);
  return {
      {"interval",
       "Interval and interval",
       "Do two intervals share a number?",
       "interval_interval",
       "intervals",
       Output::yes_no,
       yes_or_no,
       {vector_field("a", 2, "the ends of a", "a[0] <= a[1]"), vector_field("b", 2, "the ends of b", "b[0] <= b[1]")},
       {closed, exact, "An interval may be a single number."}},
      {"aabb",
       "Box and box",
       "Do two axis-aligned boxes share a point?",
       "box_box",
       "aabb-aabb",
       Output::yes_no,
       yes_or_no,
       {vector_field("alo", 3, "the least corner of a"), vector_field("ahi", 3, "its greatest corner", "alo <= ahi"),
        vector_field("blo", 3, "the least corner of b"), vector_field("bhi", 3, "its greatest corner", "blo <= bhi")},
       {closed, exact, "A box may be flat, or a point."}},
      {"sphere-sphere",
       "Sphere and sphere",
       "Do two balls share a point?",
       "sphere_sphere",
       "sphere-sphere",
       Output::yes_no,
       yes_or_no,
       {vector_field("c1", 3, "the centre of the first"), number_field("r1", "its radius", ">= 0"),
        vector_field("c2", 3, "the centre of the second"), number_field("r2", "its radius", ">= 0")},
       {closed, exact, "The spheres are filled: one within the other shares points with it."},
       "Balls that touch from outside do not meet: squared distance < squared sum of the radii."},
      {"sphere-aabb",
       "Sphere and box",
       "Do a ball and an axis-aligned box share a point?",
       "sphere_box",
       "sphere-aabb",
       Output::yes_no,
       yes_or_no,
       {vector_field("center", 3, "the ball's centre"), number_field("radius", "its radius", ">= 0"),
        vector_field("lo", 3, "the box's least corner"), vector_field("hi", 3, "its greatest corner", "lo <= hi")},
       {closed, exact, "Both are filled."},
       "A ball that touches the box does not meet it: squared distance < squared radius."},
      {"obb-obb",
       "Oriented boxes",
       "Do two oriented boxes share a point?",
       "obb_obb",
       "obb-obb",
       Output::yes_no,
       yes_or_no,
       two,
       {closed, exact,
        "A box is all c + s0 u[0] + s1 u[1] + s2 u[2] with |si| <= e[i], with the axes as they are given."}},
  };
}

std::vector<Task> of_rays() {
  return {
      {"ray-sphere",
       "Ray and sphere",
       "Where does a ray first meet a sphere's surface?",
       "ray_sphere",
       "ray-sphere",
       Output::first_t,
       t_or_miss,
       ray_and({vector_field("center", 3, "the sphere's centre"), number_field("radius", "its radius", ">= 0")}),
       {closed, of_ray, "The sphere is its surface: from inside, the first shared point is where the ray leaves."},
       "",
       root_ulps},
      {"ray-plane",
       "Ray and plane",
       "Where does a ray first meet a plane?",
       "ray_plane",
       "ray-polygon",
       Output::first_t,
       t_or_miss,
       ray_and({vector_field("normal", 3, "the plane's normal, of any length", "not 0 0 0"),
                number_field("d", "the plane is normal . x + d = 0")}),
       {closed, of_ray, "A ray within the plane meets it at t = 0."},
       "",
       root_ulps},
      {"ray-aabb",
       "Ray and box",
       "Where does a ray first meet an axis-aligned box?",
       "ray_box",
       "ray-tracing",
       Output::first_t,
       t_or_miss,
       ray_and(
           {vector_field("lo", 3, "the box's least corner"), vector_field("hi", 3, "its greatest corner", "lo <= hi")}),
       {closed, of_ray, "The box is filled: from inside, t = 0. Numbers of dir may be 0."},
       "",
       slab_ulps},
      {"ray-triangle",
       "Ray and triangle",
       "Where does a ray first meet a triangle?",
       "line_triangle",
       "ray-triangle",
       Output::first_t,
       t_or_miss,
       ray_and({rows_field("tri", 3, 3, "its corners, one a row")}),
       {closed, of_ray, "Both sides count. A ray within the triangle's plane meets it where it first reaches it.",
        "A triangle without area is the segment or the point that its corners leave."},
       "",
       root_ulps},
      {"ray-polygon",
       "Ray and polygon",
       "Where does a ray meet a flat polygon?",
       "ray_polygon",
       "ray-polygon",
       Output::first_t,
       t_or_miss,
       ray_and({list_field("polygon", 3, "its corners in order", "3 to 12 of them, in one plane")}),
       {closed, of_ray, "Both sides count. No ray lies within the polygon's plane.",
        "The polygon need not be convex. Edges and corners belong to it."},
       "",
       root_ulps},
  };
}

std::vector<Task> of_polygons() {
  const char* const in_on_out = "in, on or out";
  return {
      {"crossings",
       "Point in polygon",
       "Is a point in a polygon, on its boundary, or outside?",
       "pip",
       "crossings",
       Output::location,
       in_on_out,
       {list_field("rings", 2, "the polygon's corners in order", "3 to 9 of them, in either sense"),
        vector_field("point", 2, "the point")},
       {exact,
        "The polygon may cross itself: a point is in it if a ray from it crosses the boundary an odd number of times.",
        "A point on an edge or a corner is on."}},
      {"convex-polygon",
       "Point in convex polygon",
       "Is a point in a convex polygon, on its boundary, or outside?",
       "pip",
       "convex-polygon",
       Output::location,
       in_on_out,
       {list_field("rings", 2, "the corners, counter-clockwise", "3 to 12 of them, no three on one line"),
        vector_field("point", 2, "the point")},
       {exact, "A point on an edge or a corner is on.", "A binary search takes O(lg n)."}},
      {"hull",
       "Convex hull",
       "Which points are the corners of the convex hull?",
       "convex_hull2d",
       "convex-hull",
       Output::corners,
       "how many corners, then the two coordinates of each",
       {list_field("points", 2, "the points", "1 to 20 of them, some may be equal")},
       {exact, "Corners only: no point within an edge, and none twice.",
        "Counter-clockwise, from any of them on. Points on one line give the two ends; equal points give one."}},
      {"clip-segment",
       "Segment and box",
       "Which part of a segment lies in an axis-aligned box?",
       "segment_box",
       "clipping",
       Output::span,
       "t where that part begins and where it ends, or the word miss",
       {rows_field("segment", 2, 2, "its ends, one a row"), vector_field("lo", 2, "the box's least corner"),
        vector_field("hi", 2, "its greatest corner", "lo <= hi")},
       {closed, "t is 0 at the first end and 1 at the second. A part may be a point.",
        "A segment whose ends are equal is that point: 0 1 if it is in the box."},
       "",
       slab_ulps},
      {"sat-polygons",
       "Convex polygons",
       "Do two convex polygons share a point?",
       "convex_polygons",
       "obb-obb",
       Output::yes_no,
       yes_or_no,
       {list_field("a", 2, "the corners of a, counter-clockwise", "3 to 12 of them, no three on one line"),
        list_field("b", 2, "the corners of b, counter-clockwise", "3 to 12 of them, no three on one line")},
       {closed, exact, "Both are filled."}},
  };
}

std::vector<Task> of_many() {
  return {
      {"all-pairs",
       "All pairs of boxes",
       "Which of many boxes share a point?",
       "",
       "collision",
       Output::pairs,
       "how many pairs, then each pair as two indices from 0",
       {list_field("boxes", 6, "the boxes, each its least corner and then its greatest", "1 to 20 of them")},
       {closed, exact, "Each pair once, in any order, the two indices as well."}},
      {"closest-hit",
       "The closest hit",
       "Which of many spheres does a ray meet first, and where?",
       "",
       "ray-tracing",
       Output::nearest,
       "the sphere's index from 0 and t of the first shared point, or the word miss",
       ray_and({list_field("spheres", 4, "the spheres, each its centre and then its radius", "1 to 20, radii >= 0")}),
       {closed, of_ray,
        "Spheres are surfaces, as in ray-sphere. Where several are equally near, any of them is right."},
       "",
       root_ulps},
  };
}

}  // namespace

const std::vector<Task>& tasks() {
  static const std::vector<Task> all = [] {
    std::vector<Task> made = of_volumes();
    for (const auto& more : {of_rays(), of_polygons(), of_many()}) made.insert(made.end(), more.begin(), more.end());
    return made;
  }();
  return all;
}

const Task& task_named(const std::string& id) {
  std::vector<std::string> names;
  for (const Task& task : tasks()) {
    if (task.id == id) return task;
    names.push_back(task.id);
  }
  throw viz::unknown("task", id, names);
}

}  // namespace isect::grade
