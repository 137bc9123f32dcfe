#include "app/scene/place.h"

namespace isect::program::scene {

namespace {

/// side sqrt(square)
struct Root {
  int side;
  Exact square;

  int sign() const { return side * square.sign(); }
};

/// The sign of n + a + b, by squaring what two terms of opposite signs have: |a| = sqrt(a^2), and so on.
int sign_of_sum(const Exact& n, const Root& a, const Root& b) {
  const int roots =
      a.sign() * b.sign() >= 0 ? (a.sign() != 0 ? a.sign() : b.sign()) : a.sign() * (a.square - b.square).sign();
  if (n.sign() * roots >= 0) return roots != 0 ? roots : n.sign();

  // (a + b)^2 - n^2 = rest + 2 a b
  const Exact rest = a.square + b.square - n * n, product = a.square * b.square;
  const int mixed = a.sign() * b.sign();
  const int larger = rest.sign() * mixed >= 0 ? (rest.sign() != 0 ? rest.sign() : mixed)
                                              : rest.sign() * (rest * rest - Exact(4.0) * product).sign();
  return larger == 0 ? 0 : larger > 0 ? roots : -roots;
}

}  // namespace

int compare(const Place& x, const Place& y) {
  const Exact n = x.num * y.den - y.num * x.den;
  if (x.side == 0 && y.side == 0) return n.sign();
  const auto root = [](int side, const Place& p, const Exact& times) {
    return side == 0 ? Root{0, {}} : Root{side, p.square * times * times};
  };
  return sign_of_sum(n, root(x.side, x, y.den), root(-y.side, y, x.den));
}

}  // namespace isect::program::scene
