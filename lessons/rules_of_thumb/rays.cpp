// Rules 4 and 5, on rays.

#include <fmt/format.h>

#include <array>

#include <isect/methods/ray_polygon.h>
#include <isect/methods/ray_sphere.h>
#include "lessons/rules_of_thumb/experiment.h"
#include "lessons/shared/plural.h"

namespace isect::lessons::rules_of_thumb_lesson {

using namespace viz;

namespace {

using C = Counted<double>;

int expensive(const Tally& t) { return t.sqrt + t.div; }

}  // namespace

Experiment postpone(const Flat& p) {
  constexpr double radius = 0.4375;
  const std::vector<Flat> centers = {{-2.75, 1.25}, {-2.5, -0.25}, {-2.25, -1.25}, {-1.5, 0.75}, {-1.25, -0.875},
                                     {-0.5, 0.25},  {-0.25, 1.5},  {0.125, -1.5},  {0.5, -0.25}, {0.75, 1}};
  Experiment e = {.title = "4: postpone expensive calculations",
                  .source = "Lecture note, rules of thumb (4), ray and sphere",
                  .alt = {},
                  .pseudocode = {"for each ball", "    without: solve the quadratic equation for both roots",
                                 "    with: behind the ray: no; too far beside it: no",
                                 "    only then: a square root, for the nearer point"},
                  .unit = "costly operations"};
  const Ray<C, 2> ray = {p.cast<C>(), {C(1), C(0)}, {C(0), C(infinite<double>.hi)}};
  double all_before = 0, all_after = 0;
  int behind = 0, beside = 0, hits = 0;
  for (Part& part : e.parts) part.items.emplace_back(Arrow{flat(p), {1.2, p.y(), 0}, Role::first, Pen::solid});
  e.parts[1].items.emplace_back(line({-3.3, p.y()}, p, Role::first, Pen::construction));
  for (const Flat& c : centers) {
    const Sphere<C, 2> ball = {c.cast<C>(), C(radius)};
    bool hit = false;
    const Tally without = counted([&] { hit = ray_sphere::quadratic(ray, ball).has_value(); });
    bool rejected_behind = false, rejected_beside = false;
    const Tally with = counted([&] {
      Record<ray_sphere::HainesEvent<C, 2>> record;
      ray_sphere::haines(ray, ball, record);
      for (const auto& event : record.events) {
        if (const auto* b = std::get_if<ray_sphere::Behind<C>>(&event)) rejected_behind = b->holds;
        if (const auto* b = std::get_if<ray_sphere::PassesBy<C>>(&event)) rejected_beside = b->holds;
      }
    });
    e.before += expensive(without), e.after += expensive(with);
    all_before += total(without), all_after += total(with);
    behind += rejected_behind, beside += rejected_beside, hits += hit;
    const Role found = hit ? Role::hit : Role::second;
    e.parts[0].items.emplace_back(circle(c, radius, Role::second, Pen::solid, true));
    e.parts[1].items.emplace_back(circle(c, radius, expensive(without) > 0 ? found : Role::second,
                                         expensive(without) > 0 ? Pen::thick : Pen::solid, true));
    const Role why = rejected_behind ? Role::construction : rejected_beside ? Role::muted : found;
    for (const std::size_t k : {std::size_t{2}, std::size_t{3}})
      e.parts[k].items.emplace_back(circle(c, radius, why,
                                           hit               ? Pen::thick
                                           : rejected_behind ? Pen::construction
                                                             : Pen::solid,
                                           !rejected_behind));
    if (expensive(without) > 0)
      e.parts[1].items.emplace_back(
          text({c.x(), c.y() + radius + 0.16}, std::to_string(expensive(without)), Role::muted));
    if (expensive(with) > 0)
      e.parts[3].items.emplace_back(text({c.x(), c.y() + radius + 0.16}, std::to_string(expensive(with)), Role::muted));
  }
  e.details = {{"all operations, without", all_before}, {"all operations, with", all_after}};
  e.parts[0].title = "Expensive operations last";
  e.parts[0].caption =
      "Which balls does the ray from **p** hit? A square root or a division takes as long as several "
      "products.";
  e.parts[1].title = "A square root for every line that hits";
  e.parts[1].caption =
      "The quadratic formula takes a square root and two divisions wherever the *line* meets a ball, even "
      "behind **p**.\nThe numbers count them.";
  e.parts[2].title = "Reject by products alone";
  e.parts[2].caption = fmt::format(
      "Haines' method rejects balls by sums and products only: {} behind the ray, {} beside it.", behind, beside);
  e.parts[3].title = "One square root per hit";
  e.parts[3].caption = hits == 0
                           ? "No ball is hit, so no square root is taken."
                           : fmt::format(
                                 "A square root is taken for {} hit, and no division at all: the direction has unit "
                                 "length.",
                                 plural(hits, "ball"));
  e.alt = fmt::format("A ray to the right and {} balls: {} behind it, {} beside it, {} hit.", centers.size(), behind,
                      beside, hits);
  e.saving = "Balls behind or beside the ray cost no square root at all.";
  return e;
}

Experiment fewer_axes(const Flat& p) {
  const std::vector<Flat> shape = {{-2.75, -1.25}, {-1.25, -1.75}, {-0.75, -0.5}, {0.5, -1.25},
                                   {0.875, 1.25},  {-0.5, 0.5},    {-1.5, 1.75},  {-2.25, 0.5}};
  Experiment e = {.title = "5: reduce the dimension",
                  .source = "Lecture note, rules of thumb (5), ray and polygon",
                  .alt = "A polygon in a tilted plane, seen from above, and a ray that comes down at a point.",
                  .pseudocode = {"many rays, and a polygon whose normal is stored",
                                 "    without: meet the triangles of a fan, in space",
                                 "    with: meet the plane; drop a coordinate", "    count crossings in the plane"},
                  .unit = "operations"};
  Ring<C, 3> ring;
  for (const Flat& v : shape) ring.push_back(Point<double, 3>(v.x(), v.y(), (v.x() + v.y()) / 4).cast<C>());
  const Ray<C, 3> ray = {Point<double, 3>(p.x(), p.y(), 4).cast<C>(),
                         Vector<double, 3>(0, 0, -1).cast<C>(),
                         {C(0), C(infinite<double>.hi)}};
  bool fan = false, hit = false;
  int normal = 0;  // operations up to the normal
  e.before = total(counted([&] { fan = ray_polygon::fan(ray, ring).has_value(); }));
  const auto listen = [&]<class E>(const E&) {
    if constexpr (std::is_same_v<E, ray_polygon::Normal<C>>) normal = total(tally());
  };
  e.after = total(counted([&] { hit = ray_polygon::projected(ray, ring, listen).has_value(); })) - normal;
  for (std::size_t k = 0; k < 4; ++k)
    e.parts[k].items.emplace_back(region(shape, k % 2 == 1 && hit ? Role::hit : Role::second));
  for (std::size_t i = 2; i + 1 < shape.size(); ++i)
    e.parts[1].items.emplace_back(line(shape[0], shape[i], Role::construction, Pen::construction));
  for (const std::size_t k : {std::size_t{2}, std::size_t{3}})
    e.parts[k].items.emplace_back(Arrow{flat(p), {1.2, p.y(), 0}, Role::first, Pen::solid});
  int crossings = 0;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const Flat &a = shape[i], &b = shape[(i + 1) % shape.size()];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    const double x = a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y());
    if (x <= p.x()) continue;
    ++crossings;
    e.parts[3].items.emplace_back(Dot{{x, p.y(), 0}, Mark::disc, Role::hit});
  }
  e.details = {{"triangles", static_cast<double>(shape.size()) - 2}, {"for the normal, once", normal}};
  e.parts[0].title = "Space, plane, line";
  e.parts[0].caption = "A ray comes straight down at **p**. Does it hit the polygon, which lies tilted in space?";
  e.parts[1].title = "Six triangles in space";
  e.parts[1].caption = "A fan of triangles, each met in space: cross products and dot products of three coordinates.";
  e.parts[2].title = "Into the plane";
  e.parts[2].caption = "The plane is met once. Then the coordinate is dropped along which the normal is largest: *z*.";
  e.parts[3].title = "A test of two coordinates";
  e.parts[3].caption = fmt::format(
      "Now {} of a ray in the plane decide{}.{}\nThe normal was stored before: {} operations, once (rule 6). For a "
      "single "
      "ray they come on top.",
      plural(crossings, "crossing"), crossings == 1 ? "s" : "", fan == hit ? " The answer is the same." : "", normal);
  e.saving = fan == hit ? "Comparisons in the plane replace products in space." : "Rounding decides on the outline.";
  return e;
}

}  // namespace isect::lessons::rules_of_thumb_lesson
