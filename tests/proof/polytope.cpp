#include "tests/proof/polytope.h"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace isect::proof {

Vec operator+(const Vec& a, const Vec& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vec operator-(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vec operator*(const Rational& k, const Vec& a) { return {k * a[0], k * a[1], k * a[2]}; }
Rational dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
bool is_zero(const Vec& a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }

bool Face::holds(const Vec& x) const {
  const int side = sgn(beyond(x));
  return equation ? side == 0 : side <= 0;
}
bool holds(const Faces& faces, const Vec& x) {
  return std::ranges::all_of(faces, [&](const Face& f) { return f.holds(x); });
}

std::size_t farthest(const Points& points, const Vec& along) {
  std::size_t best = 0;
  Rational most = dot(points[0], along);
  for (std::size_t i = 1; i < points.size(); ++i)
    if (Rational here = dot(points[i], along); here > most) most = std::move(here), best = i;
  return best;
}

namespace {

/// The vector times its least common denominator: whole numbers, which are multiplied faster.
Vec whole(const Vec& x) {
  mpz_class least = x[0].get_den();
  for (int i = 1; i < 3; ++i) mpz_lcm(least.get_mpz_t(), least.get_mpz_t(), x[i].get_den_mpz_t());
  return Rational(least) * x;
}

/// A point of the difference of two polytopes, as a mean of differences of their corners.
struct Corner {
  std::size_t a, b;
  Vec at;
  Rational weight;
};

/// The weights of the point nearest to 0 of the plane, line or point through the corners, which are independent.
std::vector<Rational> weights_of_nearest(const std::vector<Corner>& corners) {
  const std::size_t n = corners.size() - 1;
  std::vector<Vec> edges;
  for (std::size_t i = 0; i < n; ++i) edges.push_back(corners[i + 1].at - corners[0].at);
  std::vector<std::vector<Rational>> rows(n, std::vector<Rational>(n + 1));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) rows[i][j] = dot(edges[i], edges[j]);
    rows[i][n] = -dot(edges[i], corners[0].at);
  }
  for (std::size_t k = 0; k < n; ++k)  // a matrix of products of independent vectors needs no exchange of rows
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k || rows[i][k] == 0) continue;
      const Rational factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j <= n; ++j) rows[i][j] -= factor * rows[k][j];
    }
  std::vector<Rational> weights = {1};
  for (std::size_t i = 0; i < n; ++i) {
    weights.push_back(rows[i][n] / rows[i][i]);
    weights[0] -= weights.back();
  }
  return weights;
}

}  // namespace

Nearest nearest(const Points& a, const Points& b) {
  std::vector<Corner> corners = {{0, 0, a[0] - b[0], 1}};
  Vec x = corners[0].at;
  while (!is_zero(x)) {
    const Vec along = whole(x);
    const Vec back = Rational(-1) * along;
    const std::size_t i = farthest(a, back), j = farthest(b, along);
    Vec at = a[i] - b[j];
    if (dot(at, along) >= dot(x, along)) return {dot(x, x), {}};
    corners.push_back({i, j, std::move(at), 0});
    while (true) {
      const std::vector<Rational> weights = weights_of_nearest(corners);
      Rational share = 1;  // of the way there that stays within the corners' hull
      for (std::size_t k = 0; k < corners.size(); ++k)
        if (weights[k] <= 0) share = std::min(share, Rational(corners[k].weight / (corners[k].weight - weights[k])));
      for (std::size_t k = 0; k < corners.size(); ++k) corners[k].weight += share * (weights[k] - corners[k].weight);
      if (share == 1) break;
      std::erase_if(corners, [](const Corner& c) { return c.weight == 0; });
    }
    std::erase_if(corners, [](const Corner& c) { return c.weight == 0; });
    x = {};
    for (const Corner& c : corners) x = x + c.weight * c.at;
  }
  Vec point = {};
  for (const Corner& c : corners) point = point + c.weight * a[c.a];
  return {0, point};
}

namespace {

/// Whether some y has n . y < 0 for all normals of inequalities, and n . y = 0 for those of equations: whether the
/// largest s with n . y + s <= 0 and s <= 1 is positive. Uses the simplex method with Bland's rule.
bool all_can_fall(const Faces& faces) {
  constexpr int columns = 4;  // y and s
  struct Row {
    std::array<Rational, columns> of;  ///< what is not in the basis
    Rational left;
    int name;  ///< of the variable that it gives the value of: below 4 free, else at least 0
  };
  std::vector<Row> rows;
  const auto add = [&](const Vec& n, int s, int left) {
    rows.push_back({{n[0], n[1], n[2], Rational(s)}, left, columns + static_cast<int>(rows.size())});
  };
  add({}, 1, 1);
  for (const Face& f : faces) {
    add(f.normal, f.equation ? 0 : 1, 0);
    if (f.equation) add(Rational(-1) * f.normal, 0, 0);
  }
  std::array<int, columns> outside = {0, 1, 2, 3};
  std::array<Rational, columns> gain = {0, 0, 0, 1};
  while (true) {
    int enters = -1;
    for (int j = 0; j < columns; ++j)
      if ((outside[j] < columns ? gain[j] != 0 : gain[j] > 0) && (enters < 0 || outside[j] < outside[enters]))
        enters = j;
    if (enters < 0) return false;
    const int way = sgn(gain[enters]);
    std::size_t leaves = rows.size();
    Rational least;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (rows[i].name < columns || sgn(rows[i].of[enters]) * way <= 0) continue;
      const Rational room = rows[i].left / abs(rows[i].of[enters]);
      if (leaves == rows.size() || room < least || (room == least && rows[i].name < rows[leaves].name))
        leaves = i, least = room;
    }
    if (leaves == rows.size() || least > 0) return true;  // s rises with it
    Row& pivot = rows[leaves];
    const Rational by = 1 / pivot.of[enters];
    for (Rational& x : pivot.of) x *= by;
    pivot.left *= by, pivot.of[enters] = by;
    std::swap(pivot.name, outside[enters]);
    const auto without = [&](std::array<Rational, columns>& of) {
      const Rational factor = of[enters];
      if (factor == 0) return factor;
      of[enters] = 0;
      for (int j = 0; j < columns; ++j) of[j] -= factor * pivot.of[j];
      return factor;
    };
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (i != leaves) rows[i].left -= without(rows[i].of) * pivot.left;
    without(gain);
  }
}

}  // namespace

bool interiors_meet(const Faces& a, const Faces& b, const Vec& common) {
  Faces tight;
  for (const Faces* faces : {&a, &b})
    for (const Face& f : *faces)
      if (f.equation || f.beyond(common) == 0) tight.push_back(f);
  if (std::ranges::all_of(tight, &Face::equation)) return true;
  return all_can_fall(tight);
}

namespace {

/// The affine span of points: one of them and up to three directions to others.
struct Span {
  Vec from;
  std::vector<Vec> along;
};
Span span_of(const Points& points) {
  Span span = {points[0], {}};
  for (const Vec& p : points) {
    const Vec d = p - span.from;
    const auto& v = span.along;
    const bool more = v.empty()       ? !is_zero(d)
                      : v.size() == 1 ? !is_zero(cross(v[0], d))
                      : v.size() == 2 ? dot(cross(v[0], v[1]), d) != 0
                                      : false;
    if (more) span.along.push_back(d);
  }
  return span;
}

Face through(const Vec& normal, const Vec& point, bool equation = false) {
  return {normal, dot(normal, point), equation};
}

/// Adds the plane as a face if all points lie on one side, its normal pointing away from them. Returns which lie in it.
std::optional<std::vector<bool>> add_if_face(const Points& points, const Vec& normal, const Vec& point, Faces& faces) {
  Face face = through(normal, point);
  int side = 0;
  std::vector<bool> within;
  for (const Vec& p : points) {
    const int here = sgn(face.beyond(p));
    within.push_back(here == 0);
    if (here * side < 0) return {};
    if (here != 0) side = here;
  }
  if (side > 0) face.normal = Rational(-1) * face.normal, face.offset = -face.offset;
  faces.push_back(face);
  return within;
}

}  // namespace

Faces faces_of(const Points& points, bool flat) {
  const Span span = span_of(points);
  const std::vector<Vec>& v = span.along;
  const Vec z = {0, 0, 1};
  Faces faces;
  const auto equation = [&](const Vec& n) { faces.push_back(through(n, span.from, true)); };
  if (v.empty()) {
    for (int i = 0; i < (flat ? 2 : 3); ++i) {
      Vec n = {};
      n[i] = 1;
      equation(n);
    }
    return faces;
  }
  if (v.size() == 1) {
    add_if_face(points, v[0], points[farthest(points, v[0])], faces);
    const Vec back = Rational(-1) * v[0];
    add_if_face(points, back, points[farthest(points, back)], faces);
    if (flat) return equation(cross(z, v[0])), faces;
    Vec n = {};
    for (int i = 0; i < 3 && is_zero(n); ++i) {
      Vec axis = {};
      axis[i] = 1;
      n = cross(axis, v[0]);
    }
    return equation(n), equation(cross(n, v[0])), faces;
  }
  std::vector<std::vector<bool>> found;  // corners of the faces so far
  const auto known = [&](std::initializer_list<std::size_t> corners) {
    return std::ranges::any_of(found, [&](const std::vector<bool>& within) {
      return std::ranges::all_of(corners, [&](std::size_t i) { return within[i]; });
    });
  };
  const std::size_t n = points.size();
  if (v.size() == 2) {
    const Vec normal = flat ? z : cross(v[0], v[1]);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < n; ++j) {
        const Vec side = cross(normal, points[j] - points[i]);
        if (is_zero(side) || known({i, j})) continue;
        if (auto within = add_if_face(points, side, points[i], faces)) found.push_back(*within);
      }
    if (!flat) equation(normal);
    return faces;
  }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      for (std::size_t k = j + 1; k < n; ++k) {
        const Vec normal = cross(points[j] - points[i], points[k] - points[i]);
        if (is_zero(normal) || known({i, j, k})) continue;
        if (auto within = add_if_face(points, normal, points[i], faces)) found.push_back(*within);
      }
  return faces;
}

Points corners_of(const Faces& faces, bool flat) {
  Points corners;
  const auto add = [&](const Vec& a, const Vec& b, const Vec& c, const Rational& x, const Rational& y,
                       const Rational& z) {
    const Vec bc = cross(b, c);
    const Rational determinant = dot(a, bc);
    if (determinant == 0) return;
    const Vec sum = x * bc + y * cross(c, a) + z * cross(a, b);
    const Vec corner = Rational(1 / determinant) * sum;
    if (holds(faces, corner) && std::ranges::find(corners, corner) == corners.end()) corners.push_back(corner);
  };
  const std::size_t n = faces.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      if (flat) {
        add(faces[i].normal, faces[j].normal, {0, 0, 1}, faces[i].offset, faces[j].offset, 0);
        continue;
      }
      for (std::size_t k = j + 1; k < n; ++k)
        add(faces[i].normal, faces[j].normal, faces[k].normal, faces[i].offset, faces[j].offset, faces[k].offset);
    }
  return corners;
}

}  // namespace isect::proof
