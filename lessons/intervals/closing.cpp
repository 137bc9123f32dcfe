// What a reader takes along from two intervals, and what there is to do.

#include "lessons/intervals/picture.h"

namespace isect::lessons::intervals_lesson {

using namespace viz;

namespace {

bool touching(const Parameters& p) { return setup(p).truth == Relation::touching; }
bool b_inside_a(const Parameters& p) { return setup(p).truth == Relation::b_inside_a; }

}  // namespace

const std::string& opening() {
  static const std::string text =
      "Do two intervals have a number in common? Boxes, slabs and separating axes all need this, once for each axis.\n"
      "It is easier to say when they have none: one begins after the other has ended. So does the lecture note "
      "*Intersection Detection*.\n"
      "The interval a runs from *a*_{min} to *a*_{max}, and b from *b*_{min} to *b*_{max}.";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result =
          "Intervals are closed sets. Two that are not empty meet if and only if *a*_{min} ≤ *b*_{max} and *b*_{min} ≤ "
          "*a*_{max}. What "
          "they share is [max of the lower ends, min of the upper ends].",
      .cost =
          "Two comparisons at most, one if the first finds a gap, no arithmetic. So the answer is exact, unless an "
          "interval is empty or has a NaN.",
      .choose =
          "By endpoints where only yes or no is needed. By larger lower and smaller upper end where the common part is "
          "needed, or where branches are costly.",
      .used = "Sweep and prune in broad phases, slab tests of rays and boxes, separating axes, range clipping.",
      .bug = "Ends that are exchanged. The comparisons treat the empty interval as an ordinary one.",
      .bug_preset = "empty",
      .reading = {"Lecture note *Intersection Detection*, intervals.",
                  "Christer Ericson, *Real-Time Collision Detection*, 2005, section 4.2: axis-aligned bounding boxes.",
                  "James F. Allen, Maintaining Knowledge about Temporal Intervals, *Communications of the ACM* 26, "
                  "1983, pages 832–843."},
      .exercises = {
          {"Drag the ends of b until the intervals touch.",
           "They touch where an end of one equals the opposite end of the other.",
           "b-after-a",
           touching,
           {{"b_min", "-1"}}},
          {"Make b lie inside a, and touch one end of a from inside.",
           "Equal ends are allowed: a subset may share boundary points.",
           "overlapping",
           b_inside_a,
           {{"b_max", "1"}}},
          {"Derive the test for overlap by negating *a*_{min} > *b*_{max} or *b*_{min} > *a*_{max}.",
           "De Morgan: *a*_{min} ≤ *b*_{max} and *b*_{min} ≤ *a*_{max}. Both > become ≤, and \"or\" becomes \"and\".\n"
           "Open intervals do not contain their ends. Two that are not empty are disjoint if and only if *a*_{min} ≥ "
           "*b*_{max} or *b*_{min} ≥ *a*_{max}.\n"
           "That holds for numbers. With a NaN neither > nor ≤ holds. So the form with ≤ says DISJOINT. The form with "
           "> says OVERLAP, unless its other comparison finds a gap: [NaN, 1] and [2, 3] are DISJOINT by both."},
          {"Allen counts 13 relations of two proper intervals. Which of them are one relation here?",
           "Disjoint: before, after. Touching: meets, met by. Overlapping: overlaps, overlapped by.\n"
           "a inside b: starts, during, finishes. b inside a: started by, contains, finished by. Equals stands alone."},
          wrong_line(),
      }};
  return closing;
}

}  // namespace isect::lessons::intervals_lesson
