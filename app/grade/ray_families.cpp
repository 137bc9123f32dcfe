// Rays against one shape.

#include "app/grade/drawing_numbers.h"

namespace isect::grade {

namespace {

/// Makes ordinary rays begin outside and point inwards.
void aim(Draw& draw) {
  if (draw.kind != Kind::ordinary) {
    draw.point(3), draw.direction(3);
    return;
  }
  const auto from = (3 * draw.random.heading<3>()).eval(), to = draw.random.in_box<3>(1);
  for (const double coordinate : from) draw.put({coordinate});
  for (int i = 0; i < 3; ++i) draw.put({to[i] - from[i]});
}

Numbers ray_and_ball(Random& random, Kind kind) {
  Draw draw(random, kind);
  aim(draw), draw.ball();
  return draw.x;
}
/// Along a coordinate axis, at a distance of the radius, `most` ulps more or less.
template <int most>
Numbers tangent_ray(Random& random) {
  const int along = random.below(3), aside = (along + 1 + random.below(2)) % 3;
  Numbers x(10, 0.0);
  for (int i = 0; i < 3; ++i) x[i] = x[6 + i] = random.integer(-9, 9);
  const int radius = random.integer(1, 9);
  x[along] -= random.integer(0, 9), x[aside] += random.one_in(2) ? radius : -radius;
  x[3 + along] = random.integer(1, 4), x[9] = bench::moved(static_cast<double>(radius), random.integer(-most, most));
  return x;
}
Numbers from_inside_ball(Random& random) {
  Numbers x = ray_and_ball(random, Kind::ordinary);
  const auto from = random.in_box<3>(0.5 * x[9]);
  for (int i = 0; i < 3; ++i) x[i] = x[6 + i] + from[i];
  return x;
}
Numbers from_the_surface(Random& random) {
  Numbers x = ray_and_ball(random, Kind::grid);
  const int i = random.below(3);
  for (int k = 0; k < 3; ++k) x[k] = x[6 + k];
  x[i] += random.one_in(2) ? x[9] : -x[9];
  return x;
}
Numbers ball_behind(Random& random) {
  Numbers x = ray_and_ball(random, Kind::ordinary);
  for (int i = 3; i < 6; ++i) x[i] = -x[i];
  return x;
}
Numbers ball_of_radius_zero(Random& random) {
  Numbers x = ray_and_ball(random, Kind::grid);
  x[9] = 0;
  const int away = random.integer(-1, 3);
  for (int i = 0; i < 3; ++i)
    if (random.below(4) > 0) x[6 + i] = x[i] + away * x[3 + i];
  return x;
}

Numbers ray_and_plane(Random& random, Kind kind) {
  Draw draw(random, kind);
  aim(draw), draw.direction(3);
  const Kind size = kind == Kind::huge || kind == Kind::tiny ? kind : Kind::grid;
  draw.kind = kind == Kind::ordinary || kind == Kind::nudged || kind == Kind::decimal ? kind : size;
  draw.point(1);
  if (kind == Kind::distant)  // the plane is where the ray begins
    for (int i = 0; i < 3; ++i) draw.x[9] -= draw.x[6 + i] * draw.x[i];
  if (kind == Kind::huge || kind == Kind::tiny)  // a product of two such sizes is no number
    for (int i = 6; i < 9; ++i) draw.x[i] = random.integer(1, 4);
  return draw.x;
}
/// The direction is at a right angle to the normal; in the plane, or beside it.
Numbers parallel_to_plane(Random& random) {
  Draw draw(random, Kind::grid);
  draw.point(3), draw.direction(3), draw.direction(3);
  Numbers& x = draw.x;
  const double n[3] = {x[6], x[7], x[8]}, w[3] = {x[3], x[4], x[5]};
  for (int i = 0; i < 3; ++i) x[3 + i] = n[(i + 1) % 3] * w[(i + 2) % 3] - n[(i + 2) % 3] * w[(i + 1) % 3];
  if (x[3] == 0 && x[4] == 0 && x[5] == 0) return parallel_to_plane(random);
  x.push_back(-(n[0] * x[0] + n[1] * x[1] + n[2] * x[2]));
  if (random.one_in(2)) x[9] += random.integer(1, 3);
  return x;
}
Numbers from_the_plane(Random& random) {
  Numbers x = ray_and_plane(random, random.one_in(2) ? Kind::grid : Kind::decimal);
  x[9] = -(x[6] * x[0] + x[7] * x[1] + x[8] * x[2]);
  if (random.one_in(2)) x[9] = beside(x[9], random.integer(-1, 1));
  return x;
}

Numbers ray_and_box(Random& random, Kind kind) {
  Draw draw(random, kind);
  aim(draw), draw.box(3);
  return draw.x;
}
/// Along an axis, in the plane of a face: 0 times infinity lurks.
Numbers along_a_face(Random& random) {
  Numbers x = ray_and_box(random, Kind::grid);
  const int along = random.below(3), aside = (along + 1) % 3;
  for (int i = 3; i < 6; ++i) x[i] = 0;
  x[3 + along] = random.one_in(2) ? 1 : -2;
  x[aside] = x[(random.one_in(2) ? 6 : 9) + aside];
  if (random.one_in(4)) x[aside] = beside(x[aside], random.integer(-1, 1));
  return x;
}
/// Through a corner or an edge, at whole numbers.
Numbers through_a_corner(Random& random) {
  Numbers x = ray_and_box(random, Kind::grid);
  const int steps = random.integer(1, 3);
  for (int i = 0; i < 3; ++i) x[i] = x[(random.one_in(2) ? 6 : 9) + i] - steps * x[3 + i];
  return x;
}
Numbers from_inside_box(Random& random) {
  Numbers x = ray_and_box(random, Kind::ordinary);
  for (int i = 0; i < 3; ++i) x[i] = random.uniform(x[6 + i], x[9 + i]);
  return x;
}
Numbers ray_and_flat_box(Random& random) {
  Numbers x = ray_and_box(random, Kind::grid);
  const int i = random.below(3);
  x[9 + i] = x[6 + i];
  return x;
}

Numbers ray_and_triangle(Random& random, Kind kind) {
  Draw draw(random, kind);
  aim(draw);
  for (int i = 0; i < 3; ++i) draw.point(3);
  return draw.x;
}
/// Aimed at a corner, or the middle of an edge. From 6 on stand the corners.
void aim_at_edge(Random& random, Numbers& x, std::size_t first, int count) {
  const std::size_t i = first + 3 * static_cast<std::size_t>(random.below(count)),
                    j = first + (i - first + 3) % (3 * static_cast<std::size_t>(count));
  const bool corner = random.one_in(2);
  const int steps = random.integer(0, 3);
  for (std::size_t k = 0; k < 3; ++k) {
    const double target = corner ? x[i + k] : (x[i + k] + x[j + k]) / 2;
    x[k] = target - steps * x[3 + k];
  }
}
Numbers through_an_edge(Random& random) {
  Numbers x = ray_and_triangle(random, Kind::grid);
  aim_at_edge(random, x, 6, 3);
  if (random.one_in(3)) x[0] = beside(x[0], random.integer(-1, 1));
  return x;
}
Numbers within_the_plane(Random& random) {
  Numbers x = ray_and_triangle(random, Kind::grid);
  const int flat = random.below(3);
  for (const int first : {6, 9, 12}) x[first + flat] = x[flat];
  x[3 + flat] = 0;
  if (x[3] == 0 && x[4] == 0 && x[5] == 0) x[3 + (flat + 1) % 3] = 1;
  if (random.one_in(4)) x[flat] += 1;
  return x;
}
Numbers triangle_without_area(Random& random) {
  Numbers x = ray_and_triangle(random, Kind::grid);
  const int steps = random.integer(-1, 2);
  for (int i = 0; i < 3; ++i) x[12 + i] = x[6 + i] + steps * (x[9 + i] - x[6 + i]);
  aim_at_edge(random, x, 6, 3);
  return x;
}
Numbers triangle_behind(Random& random) {
  Numbers x = ray_and_triangle(random, Kind::ordinary);
  for (int i = 3; i < 6; ++i) x[i] = -x[i];
  return x;
}

/// A polygon of whole numbers in the plane z = a x + b y + c, its axes in some order; or at any height, level.
Numbers ray_and_polygon(Random& random, Kind kind) {
  Draw draw(random, kind);
  aim(draw);
  const int count = random.integer(3, 8), up = random.below(3);
  const bool level = kind == Kind::ordinary || kind == Kind::nudged || kind == Kind::decimal;
  const int a = level ? 0 : random.integer(-2, 2), b = level ? 0 : random.integer(-2, 2);
  const double height = draw.number();
  draw.put({static_cast<double>(count)});
  for (int i = 0; i < count; ++i) {
    double u = draw.number(), v = draw.number();
    if (kind == Kind::ordinary) {  // in order around a centre
      const double angle = 6.283185307179586 * i / count, r = random.uniform(0.3, 1.2);
      u = r * std::cos(angle), v = r * std::sin(angle);
    }
    const double origin = kind == Kind::distant ? 1e8 : 0;
    const double w = height + a * (u - origin) + b * (v - origin);
    const double p[3] = {u, v, w};
    for (int k = 0; k < 3; ++k) draw.put({p[(k + up) % 3]});
  }
  return draw.x;
}
Numbers through_an_edge_of_polygon(Random& random) {
  Numbers x = ray_and_polygon(random, Kind::grid);
  aim_at_edge(random, x, 7, static_cast<int>(x[6]));
  return x;
}
Numbers parallel_to_polygon(Random& random) {
  Numbers x = ray_and_polygon(random, Kind::ordinary);
  const std::size_t count = static_cast<std::size_t>(x[6]);
  for (std::size_t k = 0; k < 3; ++k) {
    bool level = true;
    for (std::size_t i = 1; i < count; ++i) level = level && x[7 + 3 * i + k] == x[7 + k];
    if (level) x[3 + k] = random.one_in(2) ? 0 : random.sign() * 1e-300;
  }
  return x;
}

Numbers ray_and_balls(Random& random, Kind kind) {
  Draw draw(random, kind);
  aim(draw);
  const int count = random.integer(1, 12);
  draw.put({static_cast<double>(count)});
  for (int i = 0; i < count; ++i) {
    const double size = draw.size();
    draw.point(3), draw.put({kind == Kind::ordinary ? size / 3 : size});
  }
  return draw.x;
}
/// The nearest centre is not the nearest hit: a large ball reaches towards the ray's origin.
Numbers small_before_large(Random& random) {
  Numbers x = {0, 0, 0, 1, 0, 0, 3};
  for (int i = 0; i < 3; ++i) {
    const double away = random.integer(4, 12), radius = random.one_in(2) ? away - random.integer(1, 3) : 1;
    x.insert(x.end(), {away, static_cast<double>(random.integer(-1, 1)), 0.0, radius});
  }
  return x;
}
Numbers balls_behind_and_around(Random& random) {
  Numbers x = {0, 0, 0, 1, 0, 0, 4};
  for (int i = 0; i < 4; ++i) {
    const double at = random.integer(-8, 8);
    x.insert(x.end(), {at, 0.0, static_cast<double>(random.integer(-1, 1)), static_cast<double>(random.integer(0, 9))});
  }
  return x;
}

}  // namespace

std::vector<Family> ray_families(const std::string& task) {
  if (task == "ray-sphere")
    return with_own(of_all_numbers<ray_and_ball>(),
                    {{"tangent", "the ray touches the sphere, at whole numbers", tangent_ray<0>},
                     {"nearly tangent", "the same, up to two ulps off", tangent_ray<2>},
                     {"from inside", "the ray begins inside", from_inside_ball},
                     {"from the surface", "the ray begins on the sphere", from_the_surface},
                     {"behind", "the sphere is behind the ray", ball_behind},
                     {"degenerate", "spheres of radius 0", ball_of_radius_zero}});
  if (task == "ray-plane")
    return with_own(of_all_numbers<ray_and_plane>(),
                    {{"parallel", "the ray is parallel to the plane, or lies in it", parallel_to_plane},
                     {"from the plane", "the ray begins on the plane, or beside it by rounding", from_the_plane}});
  if (task == "ray-aabb")
    return with_own(of_all_numbers<ray_and_box>(),
                    {{"along a face", "the ray runs in the plane of a face", along_a_face},
                     {"through a corner", "the ray goes to a corner", through_a_corner},
                     {"from inside", "the ray begins inside", from_inside_box},
                     {"degenerate", "flat boxes", ray_and_flat_box}});
  if (task == "ray-triangle")
    return with_own(of_all_numbers<ray_and_triangle>(),
                    {{"through an edge or a corner", "at whole numbers, or an ulp beside", through_an_edge},
                     {"parallel", "the ray lies in the triangle's plane, or beside it", within_the_plane},
                     {"behind", "the triangle is behind the ray", triangle_behind},
                     {"degenerate", "triangles without area", triangle_without_area}});
  if (task == "ray-polygon")
    return with_own(of_all_numbers<ray_and_polygon>(),
                    {{"through an edge or a corner", "at whole numbers", through_an_edge_of_polygon},
                     {"parallel", "the ray is parallel to the plane, or nearly so", parallel_to_polygon}});
  if (task == "closest-hit")
    return with_own(of_all_numbers<ray_and_balls>(),
                    {{"large and small", "the nearest centre is not the nearest hit", small_before_large},
                     {"behind and around", "spheres behind the ray, or around its origin", balls_behind_and_around}});
  return {};
}

}  // namespace isect::grade
