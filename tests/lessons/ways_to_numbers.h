#pragma once
// How readers compute the numbers that questions ask for, from what is on show.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "tests/lessons/on_show.h"

namespace isect::tests::on_show {

inline double distance(double x, double y, double px, double py, double qx, double qy) {
  const double dx = qx - px, dy = qy - py, length2 = dx * dx + dy * dy;
  const double t = length2 > 0 ? std::clamp(((x - px) * dx + (y - py) * dy) / length2, 0.0, 1.0) : 0;
  return std::hypot(px + t * dx - x, py + t * dy - y);
}

/// The square of the gap between an interval and c; of one with exchanged ends it is the gap to the lower end first.
inline double squared_gap(double lo, double hi, double c) {
  const double gap = c < lo ? lo - c : std::max(c - hi, 0.0);
  return gap * gap;
}

/// How a reader computes answers with digits behind the point, by a part of the prompt.
inline const std::vector<std::pair<std::string, double (*)(const OnShow&)>>& ways() {
  static const std::vector<std::pair<std::string, double (*)(const OnShow&)>> all = {
      {"What is r_b",
       [](const OnShow& o) {
         return o.told[0] * o("h_u of b") + o.told[1] * o("h_v of b") + o.told[2] * o("h_w of b");
       }},
      {"What is the discriminant",
       [](const OnShow& o) {
         const double four = o.code.find("4 A C") == o.code.npos ? 1 : 4;
         return o("B") * o("B") - four * o("A") * o("C");
       }},
      {"What is the least d so far?",
       [](const OnShow& o) {
         const Numbers& n = o.told;
         double least = o.values.contains("least d so far before") ? o("least d so far before") : INFINITY;
         for (std::size_t i = 0; i + 4 < n.size(); i += 2)
           least =
               std::min(least, distance(n[i], n[i + 1], n[n.size() - 4], n[n.size() - 3], n[n.size() - 2], n.back()));
         return least;
       }},
      {"after all three axes?",
       [](const OnShow& o) { return o("d² before") + squared_gap(o.told[0], o.told[1], o.told[2]); }},
      {"add to d²?", [](const OnShow& o) { return squared_gap(o.told[0], o.told[1], o.told[2]); }},
      {"What is m²?", [](const OnShow& o) { return o("l²") - o("s") * o("s"); }},
      {"At which t is", [](const OnShow& o) { return (o.told[2] - o.told[0]) / o.told[1]; }},
      {"At which t does the line meet the wall", [](const OnShow& o) { return (o.told[4] - o.told[0]) / o.told[2]; }},
      {"do they first meet?", [](const OnShow& o) { return o.told[0] / o.told[2]; }},
      {"How long may one step be", [](const OnShow& o) { return o.told[0] + o.told[1]; }},
      {"When do these extents meet",
       [](const OnShow& o) {
         return std::min((o.told[0] - o.told[3]) / o.told[4], (o.told[1] - o.told[2]) / o.told[4]);
       }},
      {"x-component of the velocity of b", [](const OnShow& o) { return o.told[2] - o.told[0]; }},
      {"y-component of the velocity of b", [](const OnShow& o) { return o.told[3] - o.told[1]; }},
      {"How long is what they share",  // the interval of a, and that of b
       [](const OnShow& o) { return std::min(o.told[1], o.told[3]) - std::max(o.told[0], o.told[2]); }},
      {"What is the volume of what the boxes share",
       [](const OnShow& o) {
         const double length = std::min(o.told[1], o.told[3]) - std::max(o.told[0], o.told[2]);
         return o("common length on x") * o("common length on y") * std::max(length, 0.0);
       }},
      {"What is the weight of a", [](const OnShow& o) { return 1 - o.told[0] - o.told[1]; }},
      {"What does it compute there", [](const OnShow& o) { return -o.told[0]; }},
      {"For how long do they share points", [](const OnShow& o) { return (o.told[0] + o.told[1]) / o.told[2]; }},
      {"What is it at the hit",
       [](const OnShow& o) {
         const double u = o("u"), v = o("v");
         return (1 - u - v) * o.told[0] + u * o.told[1] + v * o.told[2];
       }},
      {"What is the longest step that surely passes no contact", [](const OnShow& o) { return o.told[0] / o.told[1]; }},
      {"At which share of the edge", [](const OnShow& o) { return o.told[0] / (o.told[0] - o.told[1]); }},
      {"What is their dot product?",
       [](const OnShow& o) { return o.told[0] * o.told[3] + o.told[1] * o.told[4] + o.told[2] * o.told[5]; }},
      {"is the line of b nearest to it?",
       [](const OnShow& o) {
         double along = 0, length2 = 0;  // a point, the start of a line, its direction
         for (std::size_t k = 0; k < 3; ++k) {
           along += (o.told[k] - o.told[k + 3]) * o.told[k + 6];
           length2 += o.told[k + 6] * o.told[k + 6];
         }
         return along / length2;
       }},
      {"What is the square of the gap?",
       [](const OnShow& o) {
         const double gap = std::max({o.told[2] - o.told[1], o.told[0] - o.told[3], 0.0});
         return gap * gap;
       }},
      {"What is d² after z?",
       [](const OnShow& o) {
         const double gap = std::max({o.told[3] - o.told[2], o.told[1] - o.told[4], 0.0});
         return o.told[0] + gap * gap;
       }},
      {"How far apart may the segments be", [](const OnShow& o) { return o.told[0] + o.told[1] + o.told[2]; }},
  };
  return all;
}

}  // namespace isect::tests::on_show
