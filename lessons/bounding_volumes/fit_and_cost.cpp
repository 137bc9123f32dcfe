#include "lessons/bounding_volumes/fit_and_cost.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <isect/volume.h>
#include "lessons/bounding_volumes/picture.h"
#include "lessons/bounding_volumes/upkeep.h"
#include "lessons/shared/order_question.h"
#include "lessons/shared/questions.h"
#include "lessons/shared/script.h"
#include "viz/chart/chart.h"

namespace isect::lessons::bounding_volumes_lesson {

using namespace viz;

namespace {

using Mesh3 = TriangleMesh<double>;

const char* const void_part = "empty share";  ///< the value of the volume that a step is about

/// The share of the volume that the object does not fill. Both volumes are rounded, so a little may be none.
double part_that_is_void(const Measured& m) {
  const double part = m.void_volume / m.volume;
  return part < 1e-12 ? 0 : part;
}

/// That number as "79.3 %".
std::string in_percent(double part) {
  const double percent = 100 * part;
  return percent < 99.95 ? shown(std::round(10 * percent) / 10) + " %" : "nearly all";
}

class Fit {
 public:
  Fit(const std::string& name, const Vec3& tip, int k)
      : mesh_(object(name, tip)),
        k_(k),
        fitted_(mesh_, k),
        dops_(measured_kdops(fitted_.hull, fitted_.object)),
        all_(measured(fitted_, dops_[std::ranges::find(sizes_of_dops, std::to_string(k)) - sizes_of_dops.begin()])),
        tip_(tip),
        object_(drawn(mesh_, Role::first)),
        script_({"Lecture note, bounding volumes; Ericson, Real-Time Collision Detection (2005), ch. 4",
                 fmt::format("A {} in a sphere, an AABB, an OBB, {} {}-DOP and its convex hull.", name,
                             k == 18 ? "an" : "a", k),
                 {"sphere: a centre, and the distance of the farthest vertex",  // 0
                  "AABB: on each axis the least and the greatest coordinate",   // 1
                  "OBB: the same along three axes of its own",                  // 2
                  "k-DOP: the least and the greatest n·x for each normal n",    // 3
                  "void ← volume of the bounding volume − volume of a"},        // 4
                 "four kinds of volume"}) {}

  Walk tell() {
    script_.value("object", fitted_.object, "volume", Role::first);
    add("object", "An object of many parts", -1,
        fmt::format("A mesh of {} triangles: an exact test may have to test them all.\n"
                    "A bounding volume encloses them all, and is cheap to test instead.",
                    mesh_.triangles.size()),
        {}, {}, fmt::format("{} triangles", mesh_.triangles.size()));
    sphere(), aabb(), obb(), slab_of_dop(), dops();
    tightness();
    tell_upkeep(script_, upkeep(fitted_.obb, all_[2]), upkeep(fitted_.kdop, fitted_.hull.vertices, all_[3]));
    trade_off();
    return std::move(script_.walk());
  }

 private:
  /// Adds a step that shows the object with `around` drawn around it, and a note below.
  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption,
            const std::string& formula, const std::vector<Item>& around, const std::string& note) {
    Step& step = script_.add(slug, title, line, caption, formula);
    std::vector<Item>& items = step.scene.items;
    items.push_back(object_);
    items.insert(items.end(), around.begin(), around.end());
    items.push_back(below(items, note));
    step.scene.handles = {{"tip", Handle::Kind::point, tip_, Vec3::Zero(), Role::first}};
    return step;
  }

  /// Adds a step about volume `i` with its own numbers drawn on it.
  Step& volume_step(std::size_t i, int line, const std::string& title, const std::string& caption,
                    std::vector<Item> own, const std::string& formula) {
    const Measured& m = all_[i];
    script_.value(m.name, m.volume, "volume", Role::second);
    script_.value(void_part, part_that_is_void(m));
    std::string slug = m.name;
    std::ranges::transform(slug, slug.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    own.insert(own.begin(), m.drawn);
    return add(slug, title, line, caption, formula, own,
               fmt::format("{} numbers, void {}", m.numbers, void_of(m, fitted_.object)));
  }

  void sphere() {
    volume_step(
        0, 0, "Sphere: a centre and a radius",
        "It holds every point **x** within the radius *r* of the centre **c**; *r* reaches to the farthest vertex.\n"
        "When the object turns, only the centre moves with it.\n"
        "Void is what of a volume the object leaves empty: the volume less the object's. The picture tells it in "
        "volumes of the object.\n"
        "As a part of the volume itself it is the empty share: of this sphere, " +
            in_percent(part_that_is_void(all_[0])) + ".",
        radius(fitted_.ball, farthest(mesh_, fitted_.ball)), "|**x** − **c**| ≤ *r*");
  }

  void aabb() {
    Step& step = volume_step(1, 1, "AABB: two extreme points",
                             "An axis-aligned bounding box (AABB): the least and the greatest coordinate on each axis "
                             "*i*, so *a*_{min,*i*} ≤ *a*_{max,*i*}. A coordinate *x_i* of a point in it lies between "
                             "them. The ends are found and tested by comparisons alone.\n"
                             "When the object turns, the box must be fitted again.",
                             corners(fitted_.aabb), "*a*_{min,*i*} ≤ *x_i* ≤ *a*_{max,*i*} for *i* = x, y, z");
    const double box = all_[1].volume, ball = all_[0].volume;
    step.question = Question{"Which has less void?",
                             {"the sphere", "the AABB", "both the same"},
                             box < ball   ? 1
                             : ball < box ? 0
                                          : 2,
                             fmt::format("The AABB's volume is {}, and the sphere's {}.", shown(box), shown(ball))};
  }

  void obb() {
    volume_step(2, 2, "OBB: axes and half-lengths",
                "An oriented bounding box (OBB): a centre **b**_c, three unit axes **b***_i* (orthogonal, "
                "right-handed) and a half-length *h_i* along each.\n"
                "It rotates with the object: its axes are rotated. Finding the tightest axes takes a search.",
                axes(fitted_.obb), "|(**x** − **b**_c) · **b***_i*| ≤ *h_i* for *i* = u, v, w")
        .question = which_count("An OBB keeps a centre, three axes and three half-lengths. How many numbers are that?",
                                static_cast<double>(all_[2].numbers),
                                {{6, "An AABB keeps that many: it needs no axes."},
                                 {9, "That counts three numbers for all axes. Each axis takes three."},
                                 {12, "That leaves out one axis. It follows from the other two, but is kept."}},
                                "Three for the centre, nine for the axes and three half-lengths.");
  }

  void slab_of_dop() {
    const std::size_t i = seen_best(fitted_.kdop);
    const Interval<double>& s = fitted_.kdop.slabs[i];
    const Vec3& n = fitted_.kdop.normals[i];
    script_.forget({void_part});
    script_.value("*lo* = −*d*_{max}", s.lo);
    script_.value("*hi* = −*d*_{min}", s.hi);
    add("slab", "A slab between two planes", 3,
        "The note's planes are **n** · **x** + *d* = 0, so its slab is −*d*_{max} ≤ **n** · **x** ≤ "
        "−*d*_{min}. Note the sign.\n"
        "A *k*-DOP (discrete oriented polytope) is the intersection of *k*/2 slabs. The note uses unit "
        "normals; integer normals let us decide touching exactly, if **n** · **x** is not rounded.",
        fmt::format("{} ≤ **n** · **x** ≤ {},  **n** = ({}, {}, {})", shown(s.lo), shown(s.hi), shown(n.x()),
                    shown(n.y()), shown(n.z())),
        slab(fitted_.kdop, i), "2 numbers");
  }

  void dops() {
    script_.value(all_[3].name, all_[3].volume, "volume", Role::second);
    script_.value(void_part, part_that_is_void(all_[3]));
    Step& step = script_.add(
        "k-dops", "k-DOPs: more slabs, less void", 3,
        "*k* is even, as each normal **n***_i* gives a slab with two bounds, *lo_i* and *hi_i*. More slabs "
        "can only cut off more.\n"
        "All objects share the normals, so only *k* bounds are stored. With *k* = 6 this is the AABB.\n"
        "Two *k*-DOPs are tested on these normals alone. For a larger *k*, crosses of edges may separate in space, "
        "too: then the test may say overlap of disjoint ones.\n"
        "In the plane the normals are enough, where each bound is tight.",
        "*lo_i* ≤ **n***_i* · **x** ≤ *hi_i* for each *i*");
    step.scene.items = side_by_side(mesh_, fitted_.object, dops_);  // no handle: the object stands in each of them
    step.question = k_ > 6 ? void_of_dop() : void_of_6_dop();
    keep_picture(script_.walk());
  }

  Question void_of_dop() const {
    return {fmt::format("How much void can {} {}-DOP have, compared with the AABB?", k_ == 18 ? "an" : "a", k_),
            {"never more", "always less", "more, for some objects"},
            0,
            fmt::format("Its normals are those of the AABB and {} more, which may cut nothing off.", k_ / 2 - 3)};
  }
  static Question void_of_6_dop() {
    return {"How much void does the 6-DOP have, compared with the AABB?",
            {"less", "just as much", "more"},
            1,
            "Its three normals are those of the AABB, and so are its slabs."};
  }

  /// Asks for the order of the four volumes without the hull by their void. A 6-DOP is the same as the AABB.
  std::optional<Question> by_void() const {
    std::vector<InOrder> volumes;
    std::vector<double> numbers, as_told;
    for (std::size_t i = 0; i < 4; ++i) {
      const Measured& m = all_[k_ == 6 && i == 3 ? 1 : i];
      volumes.push_back(
          {all_[i].name, std::round(1e9 * m.void_volume / fitted_.object) / 1e9});  // an OBB may be the AABB
      numbers.push_back(-static_cast<double>(all_[i].numbers)), as_told.push_back(static_cast<double>(i));
    }
    return which_order("Sort these four volumes by their void, from less to more.", volumes,
                       {{numbers, "That goes by the numbers stored. More numbers do not ensure less void."},
                        {as_told, "That is the order in which they were told."}},
                       "Void is what of a volume the object leaves empty. What was told of each volume decides.");
  }

  void tightness() {
    script_.value("hull", all_[4].volume, "volume", Role::second);
    script_.forget({void_part});
    Step& step =
        script_.add("side-by-side", "Tightness, storage, cost", 4,
                    "Void is given relative to the object's own volume. No convex volume is tighter than the hull.\n"
                    "A cell is one stored number, and at most 33 are drawn. Operations are for one test that finds an "
                    "overlap.");
    step.scene.items = side_by_side(mesh_, fitted_.object, all_);
    step.question = by_void();
    if (step.question) keep_picture(script_.walk());
  }

  void trade_off() {
    std::vector<Measured> points = {all_[0], all_[1], all_[2]};
    points.insert(points.end(), dops_.begin() + 1, dops_.end());  // a 6-DOP is the AABB
    std::vector<Vec2> places;
    Plot plot;
    double least = 1e300, greatest = 0;
    constexpr Glyph glyphs[] = {Glyph::disc,     Glyph::square,   Glyph::diamond,
                                Glyph::triangle, Glyph::pentagon, Glyph::hexagon};
    for (const Measured& m : points) {
      const double empty = m.void_volume / fitted_.object;
      places.emplace_back(m.operations(), empty);
      least = std::min(least, empty), greatest = std::max(greatest, empty);
      const bool dop = m.name.ends_with("DOP");
      plot.series.push_back({m.name, glyphs[plot.series.size()], dop ? Role::first : Role::second});
    }
    const std::vector<bool> front = pareto_front(places);
    Panel panel;
    for (std::size_t i = 0; i < points.size(); ++i)
      panel.spots.push_back({static_cast<int>(i), places[i].x(), places[i].y(), {}, front[i]});
    plot.x = {Scale::Kind::log, 5, 400, "operations of a test that finds an overlap"};
    plot.y = {Scale::Kind::linear, 0, 1.15 * greatest, "void / object"};
    plot.panels = {panel};
    const auto kept = static_cast<int>(std::ranges::count(front, true));
    script_.settle(Verdict::Kind::yes, fmt::format("{} of {} on the Pareto front", kept, points.size()));
    Step& step = script_.add("trade-off", "Tightness against cost", -1,
                             "Those on the Pareto front (steps) are the tightest at their cost; the others are "
                             "dominated.\n"
                             "Three *k*-DOPs are plotted, with *k* = 14, 18 and 26; the hull has no fixed cost. "
                             "Another object may change the order: drag its tip in an earlier step.");
    step.scene.chart = std::make_shared<const Chart>(Chart{plot});
  }

  const Mesh3 mesh_;
  const int k_;
  const Fitted fitted_;
  const std::vector<Measured> dops_, all_;
  const Vec3 tip_;
  const Item object_;
  Script script_;
};

}  // namespace

Walk fit_and_cost(const std::string& name, const Vec3& tip, int k) { return Fit(name, tip, k).tell(); }

}  // namespace isect::lessons::bounding_volumes_lesson
