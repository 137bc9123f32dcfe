// What core/README.md shows of isect/compiled.h.

#include <cstdio>

#include <isect/compiled.h>

using isect::compiled::Shape3;

int main() {
  const Shape3 ball = Shape3::sphere({0, 0, 0}, 1), box = Shape3::aabb({0.5, 0, 0}, {2, 1, 1});
  std::puts(ask(ball, box)->meet ? "they meet" : "they are apart");
}
