#pragma once
// A scene's text with many objects.

#include <fmt/format.h>

#include <string>

namespace isect::test {

/// Balls b0, b1 and so on in rows, not far from each other.
inline std::string many_balls(int n, const std::string& ask) {
  std::string objects;
  for (int i = 0; i < n; ++i)
    objects += fmt::format(R"({}{{"sphere": "b{}", "center": [{}, {}, {}], "radius": 0.4}})", i == 0 ? "" : ",", i,
                           i % 10, i / 10 % 10, i / 100);
  return R"({"objects": [)" + objects + R"(], "ask": )" + ask + "}";
}

}  // namespace isect::test
