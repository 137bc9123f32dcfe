// Ray tracing (N01): one pixel's ray, its closest hit, its shading and its shadow ray; then all pixels.
//
// The tracer stands in ray_tracing/tracer, the eye and the objects' ray tests in sight/sight.

#include <fmt/format.h>

#include <cmath>

#include "lessons/ray_tracing/tracer.h"
#include "lessons/script.h"

namespace isect::lessons {
namespace {

using namespace viz;
using namespace sight;
using namespace ray_tracing_lesson;

const std::vector<std::string> pseudocode = {
    "for each pixel: ray ← from the eye through the pixel",  // 0
    "    hit ← the object met at the least t ≥ 0",           // 1
    "    if there is none: the colour of the sky",           // 2
    "    n ← its normal at the hit, l ← towards the lamp",   // 3
    "    if n · l ≤ 0: dim, it faces away from the lamp",    // 4
    "    if anything stands between hit and lamp: dim",      // 5
    "    else: as bright as n · l says"                      // 6
};

const Vec3 standard_lamp = {-1, 2.25, -1.5};

class Teller {
 public:
  Teller(const Vec3& pixel, const Vec3& lamp)
      : world_(scene_objects()),
        eye_(columns, rows),
        lamp_(lamp),
        aim_(aimed(pixel)),
        ray_(eye_.through(aim_)),
        traced_(trace(world_, ray_, lamp, work_)),
        script_({"Note, N01, N16; Whitted (1980)",
                 "An eye looks through a picture plane at balls, a box and a floor. " + outcome() + ".",
                 pseudocode}) {}

  Walk tell() {
    step("picture-plane", "A picture of pixels", 0,
         "The eye looks at a scene through a plane of 48 × 36 pixels. Each pixel asks: what is seen through "
         "me?",
         {});
    show_ray_ = true;
    step("ray", "One ray through one pixel", 0,
         "The ray starts at the eye **o** and runs through the middle of the pixel. On the picture plane *t* "
         "= 1.\n"
         "Light travels the other way, but few of a lamp's rays reach the eye. So rays are traced backwards.",
         "**p** = **o** + *t* **d**,  *t* ≥ 0");
    closest();
    if (traced_.hit) shade();
    image();
    return std::move(script_.walk());
  }

 private:
  /// The middle of the pixel that holds the point.
  Vec3 aimed(const Vec3& point) {
    const Vec2 p = eye_.pixel(point);
    column_ = static_cast<int>(std::clamp(std::floor(p.x()), 0.0, columns - 1.0));
    row_ = static_cast<int>(std::clamp(std::floor(p.y()), 0.0, rows - 1.0));
    handle_ = {plane_x, point.y(), point.z()};
    return eye_.on_plane({column_ + 0.5, row_ + 0.5});
  }

  std::string name() const { return world_.object(traced_.hit->primitive).name; }

  std::string outcome() const {
    if (!traced_.hit) return "The pixel shows the sky";
    if (!(traced_.cosine > 0)) return "The pixel shows a side that faces away from the lamp";
    return traced_.blocker ? "The pixel shows a point in shadow" : "The pixel shows a point that is lit";
  }

  Step& step(const std::string& slug, const std::string& title, int line, const std::string& caption,
             const std::string& formula) {
    Step& s = script_.add(slug, title, line, caption, formula);
    s.scene = picture();
    return s;
  }

  Scene picture() const {
    Scene scene;
    sight::add(eye_, scene);
    for (const Object& o : world_.objects) sight::add(o, scene);
    for (const Object& o : world_.objects) add_name(o, scene);
    scene.items.emplace_back(Dot{lamp_, Mark::diamond, Role::highlight});
    scene.items.emplace_back(Label{lamp_, "lamp", Role::text});
    add_pixel(scene);
    if (show_ray_) add_ray(scene);
    if (show_normal_) {
      const Vec3 p = traced_.point;
      scene.items.emplace_back(Arrow{p, p + 0.8 * traced_.normal, Role::text, Pen::thick});
      scene.items.emplace_back(Label{p + 0.8 * traced_.normal, "**n**", Role::text});
    }
    if (show_shadow_ray_)
      scene.items.emplace_back(Line{traced_.point, lamp_, traced_.blocker ? Role::miss : Role::hit,
                                    traced_.blocker ? Pen::excluded : Pen::thick});
    scene.axis = axis();
    scene.handles = {{"pixel", Handle::Kind::point, handle_, Vec3::Zero(), Role::first},
                     {"lamp", Handle::Kind::point, lamp_, Vec3::Zero(), Role::highlight}};
    return scene;
  }

  /// The ray's own t-axis: the picture plane at 1, and what it meets.
  Axis axis() const {
    Axis axis;
    axis.lo = -0.25, axis.hi = 4, axis.range_hi = INFINITY;
    axis.ticks.push_back({1, Mark::diamond, Role::highlight, "pixel"});
    for (int i = 0; show_hits_ && i < static_cast<int>(world_.objects.size()); ++i) {
      const std::optional<double> t = first_hit(ray_, world_.object(i).shape);
      if (!t || *t > axis.hi) continue;
      const bool closest = traced_.hit->primitive == i;
      axis.ticks.push_back({*t, closest ? Mark::disc : Mark::uncounted,
                            closest ? Role::hit : Role::construction, short_name(world_.object(i))});
    }
    return axis;
  }

  void add_pixel(Scene& scene) const {
    Region pixel;
    pixel.role = Role::highlight, pixel.pen = Pen::highlight;
    pixel.rings.emplace_back();
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
      pixel.rings[0].push_back(eye_.on_plane({column_ + x, row_ + y}));
    scene.items.emplace_back(pixel);
    scene.items.emplace_back(Label{aim_, "pixel", Role::text});
  }

  void add_ray(Scene& scene) const {
    const double far = 3.2;
    scene.items.emplace_back(show_hits_ && traced_.hit
                                 ? Item(Line{ray_.origin, traced_.point, Role::first, Pen::thick})
                                 : Item(Arrow{ray_.origin, ray_.at(far), Role::first}));
    if (!show_hits_) return;
    for (int i = 0; i < static_cast<int>(world_.objects.size()); ++i) {
      const std::optional<double> t = first_hit(ray_, world_.object(i).shape);
      if (!t) continue;
      const bool closest = traced_.hit->primitive == i;
      scene.items.emplace_back(
          Dot{ray_.at(*t), closest ? Mark::disc : Mark::uncounted, closest ? Role::hit : Role::construction});
      if (!closest)
        scene.items.emplace_back(Line{traced_.point, ray_.at(*t), Role::construction, Pen::construction});
    }
  }

  void closest() {
    int met = 0;
    for (const Object& o : world_.objects)
      if (const std::optional<double> t = first_hit(ray_, o.shape)) {
        ++met;
        script_.value(std::string("*t* of ") + o.name, *t, "t", o.role);
      }
    show_hits_ = true;
    script_.value("objects met", met);
    if (!traced_.hit) script_.settle(Verdict::Kind::no, "the ray meets nothing: sky");
    Step& s = step(
        "closest", "The closest hit", traced_.hit ? 1 : 2,
        !traced_.hit ? "The ray meets none of the objects, so the pixel shows the sky."
        : met == 1   ? "The ray meets one object only. The least *t* ≥ 0 is what the eye sees."
                   : fmt::format("The ray meets {} objects. The least *t* ≥ 0 hides the others: the eye sees "
                                 "the first one only.",
                                 met),
        traced_.hit ? "*t* = " + shown(traced_.hit->t) : "");
    s.decides = true;
    Question q = {"What does the pixel show?", {}, 0, "The object met at the least *t* ≥ 0."};
    for (const Object& o : world_.objects) q.choices.emplace_back(o.name);
    q.choices.emplace_back("the sky");
    q.answer = traced_.hit ? traced_.hit->primitive : static_cast<int>(world_.objects.size());
    s.question = q;
  }

  void shade() {
    show_normal_ = true;
    const bool away = !(traced_.cosine > 0);
    script_.value("**n** · **l**", traced_.cosine, "light");
    Step& s =
        step("normal", away ? "It faces away" : "How it faces the lamp", away ? 4 : 3,
             away ? "The angle between normal and lamp exceeds a right angle. No ray to the lamp is needed."
                  : "The normal **n** and the way **l** to the lamp, both of length 1, tell how steeply "
                    "light falls "
                    "in.",
             "**n** · **l** = " + shown(traced_.cosine));
    Script::decide(
        s, {"**n** · **l** > 0", 0, traced_.cosine, !away, away ? "it faces away" : "it faces the lamp"});
    if (!away) shadow();
    script_.value("brightness", traced_.light, "light", Role::highlight);
    const bool lit = !away && !traced_.blocker;
    script_.settle(lit ? Verdict::Kind::yes : Verdict::Kind::no,
                   away ? fmt::format("{}, turned away from the lamp", name())
                   : traced_.blocker
                       ? fmt::format("{}, in the shadow of {}", name(), world_.object(*traced_.blocker).name)
                       : fmt::format("{}, lit", name()));
  }

  void shadow() {
    show_shadow_ray_ = true;
    Step& s = step(
        "shadow", "A ray to the lamp", traced_.blocker ? 5 : 6,
        traced_.blocker
            ? "Something stands in the way, so the point is in shadow. Which object it is does not matter.\n"
              "So the search ends with any hit: yes or no suffices."
            : "Nothing stands between the point and the lamp, so its light arrives.\n"
              "The object itself is left out. It is convex, and this side faces the lamp.",
        "**p** + *t* (lamp − **p**),  0 ≤ *t* ≤ 1");
    s.decides = true;
    s.question = {"Does the lamp's light reach the point?",
                  {"yes", "no"},
                  traced_.blocker ? 1 : 0,
                  "A segment from the point to the lamp is tested, not a ray without end."};
  }

  void image() {
    const Image all = trace(world_, eye_, lamp_);
    script_.value("eye rays", all.work.eye_rays, "rays");
    script_.value("shadow rays", all.work.shadow_rays, "rays");
    script_.value("objects asked", all.work.tests);
    const int each = static_cast<int>(world_.objects.size());
    Step& s = script_.add("image", "All pixels", 0,
                          fmt::format("{} eye rays and {} shadow rays make the picture.\nA hierarchy of "
                                      "boxes spares most tests: {} objects "
                                      "were asked, not {}.",
                                      all.work.eye_rays, all.work.shadow_rays, all.work.tests,
                                      each * (all.work.eye_rays + all.work.shadow_rays)));
    std::vector<Cell> cells;
    for (const Traced& t : all.pixels) cells.push_back(cell_of(world_, t));
    const Raster raster = sight::picture(eye_, std::move(cells), {0.25, 0, 0}, 5);
    std::vector<Vec3> pixel;
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
      pixel.push_back(on_picture(raster, eye_, {column_ + x, row_ + y}));
    s.scene.axis = axis();
    s.scene.items.emplace_back(raster);
    s.scene.items.emplace_back(Chain{pixel, true, Role::highlight, Pen::highlight});
  }

  const World world_;
  const Eye eye_;
  const Vec3 lamp_;
  int column_ = 0, row_ = 0;
  Vec3 handle_ = Vec3::Zero();
  const Vec3 aim_;
  const Ray3 ray_;
  Work work_;
  const Traced traced_;
  Script script_;
  bool show_ray_ = false, show_hits_ = false, show_normal_ = false, show_shadow_ray_ = false;
};

Walk walk(const Parameters& values) {
  return Teller(std::get<Vec3>(values.at("pixel")), std::get<Vec3>(values.at("lamp"))).tell();
}

Preset preset_of(const char* id, const char* title, int column, int row) {
  const Vec3 at = Eye(columns, rows).on_plane({column + 0.5, row + 0.5});
  return {id, title, "", {{"pixel", at}, {"lamp", standard_lamp}}};
}

}  // namespace

const Lesson& ray_tracing() {
  static const Lesson lesson = {
      .id = "ray-tracing",
      .title = "Ray tracing",
      .rows = "N01, N16",
      .summary = "A picture by sight lines: the closest hit, its normal, and a ray to the lamp.",
      .parameters = {{"pixel", "pixel",
                      "A point of the picture plane, in world units; its first coordinate is not used.",
                      Vec3(plane_x, 0, 0), -1e6, 1e6, -2, 2},
                     {"lamp", "lamp", "Where the lamp hangs, in world units.", standard_lamp, -1e6, 1e6, -5,
                      5}},
      .group_by = "",
      .presets = {preset_of("lit", "lit", 7, 25), preset_of("shadow", "in shadow", 24, 29),
                  preset_of("turned-away", "turned away", 19, 28), preset_of("sky", "sky", 24, 5)},
      .camera = from_outside(),
      .walk = walk,
  };
  return lesson;
}

}  // namespace isect::lessons
