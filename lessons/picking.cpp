// Picking (N01): which object is under the pointer, by the closest hit of its sight line; bounding volumes first.
//
// The objects stand in picking/objects, the eye and the objects' ray tests in sight/sight.

#include <fmt/format.h>

#include <algorithm>

#include "lessons/picking/objects.h"
#include "lessons/script.h"

namespace isect::lessons {
namespace {

using namespace viz;
using namespace sight;
using namespace picking_lesson;

const std::vector<std::string> pseudocode = {
    "ray ← from the eye through the pointer",          // 0
    "for each object whose bounding ball it meets",    // 1
    "    t ← where it meets the object itself first",  // 2
    "    keep the object if t is the least so far",    // 3
    "return the object kept, or none"                  // 4
};

class Teller {
 public:
  explicit Teller(const Vec3& pointer)
      : world_(objects()),
        eye_(48, 36),
        pointer_(plane_x, pointer.y(), pointer.z()),
        ray_(eye_.through(pointer_)),
        truth_(world_.closest(ray_)),
        script_({"Note, N01, N03, N16",
                 "An eye, a picture plane with the pointer, and the sight line through it. It picks " +
                     (truth_ ? std::string(world_.object(truth_->primitive).name) : std::string("nothing")) +
                     ".",
                 pseudocode}) {}

  Walk tell() {
    step("pointer", "What is under the pointer?", 0,
         "The user points at the picture plane. What is meant is what the eye sees there.");
    show_ray_ = true;
    step("sight-line", "The pointer's sight line", 0,
         "A ray from the eye **o** through the pointer: all that can appear at this place lies on it.\n"
         "On the picture plane *t* = 1.",
         "**p** = **o** + *t* **d**,  *t* ≥ 0");
    volumes();
    for (int i = 0; i < size(); ++i)
      if (met(i)) object(i);
    picked();
    return std::move(script_.walk());
  }

 private:
  int size() const { return static_cast<int>(world_.objects.size()); }
  bool met(int i) const { return first_hit(ray_, bounding_ball(world_.object(i).shape)).has_value(); }
  std::string name(int i) const { return world_.object(i).name; }

  Step& step(const std::string& slug, const std::string& title, int line, const std::string& caption,
             const std::string& formula = {}) {
    Step& s = script_.add(slug, title, line, caption, formula);
    s.scene = picture();
    return s;
  }

  Scene picture() const {
    Scene scene;
    sight::add(eye_, scene);
    for (int i = 0; i < size(); ++i) sight::add(world_.object(i), scene, !show_volumes_ || met(i));
    for (const Object& o : world_.objects) name_beside(o, scene);
    for (int i = 0; i < size(); ++i)
      if (show_volumes_ && std::holds_alternative<Triangles>(world_.object(i).shape)) add_volume(i, scene);
    scene.items.emplace_back(Dot{pointer_, Mark::diamond, Role::highlight});
    scene.items.emplace_back(Label{pointer_, "pointer", Role::text});
    if (show_ray_) {
      scene.items.emplace_back(Arrow{ray_.origin, ray_.at(far), Role::first});
      for (const auto& [i, t] : hits_)
        if (!tied() || i == kept_)
          scene.items.emplace_back(Dot{ray_.at(t), mark_of(i), i == kept_ ? Role::hit : Role::construction});
    }
    scene.axis = axis();
    scene.handles = {{"pointer", Handle::Kind::point, pointer_, Vec3::Zero(), Role::highlight}};
    return scene;
  }

  /// The balls stand one on the other, so each has its name to the right.
  static void name_beside(const Object& o, Scene& scene) {
    const auto* ball = std::get_if<Sphere<double, 3>>(&o.shape);
    if (!ball) return add_name(o, scene);
    const View outside(from_outside(), 1, 1);
    scene.items.emplace_back(Label{ball->center + ball->radius * outside.right(), short_name(o), o.role});
  }

  void add_volume(int i, Scene& scene) const {
    const auto ball = bounding_ball(world_.object(i).shape);
    const View outside(from_outside(), 1, 1);  // its outline as seen from there
    scene.items.emplace_back(Circle{.center = ball.center,
                                    .radius = ball.radius,
                                    .role = met(i) ? Role::hit : Role::miss,
                                    .pen = met(i) ? Pen::solid : Pen::construction,
                                    .normal = outside.forward()});
  }

  bool tied() const { return hits_.size() == 2 && hits_[0].second == hits_[1].second; }
  Mark mark_of(int i) const { return tied() ? Mark::double_disc : i == kept_ ? Mark::disc : Mark::uncounted; }

  Axis axis() const {
    Axis axis;
    axis.lo = -0.25, axis.hi = far, axis.range_hi = INFINITY;
    axis.ticks.push_back({1, Mark::diamond, Role::highlight, "pointer"});
    for (const auto& [i, t] : hits_) {
      if (tied() && i != kept_) continue;
      const std::string label = tied() ? short_name(world_.object(hits_[0].first)) + ", " +
                                             short_name(world_.object(hits_[1].first))
                                       : short_name(world_.object(i));
      axis.ticks.push_back({t, mark_of(i), i == kept_ ? Role::hit : Role::construction, label});
    }
    return axis;
  }

  /// Ray tests with bounding balls first. A ball is its own, so it takes one test.
  int tests(const Ray3& ray) const {
    int sum = 0;
    for (const Object& o : world_.objects) {
      const int own = tests_of(o.shape);
      sum += 1 + (own > 1 && first_hit(ray, bounding_ball(o.shape)) ? own : 0);
    }
    return sum;
  }

  void volumes() {
    show_volumes_ = true;
    int all = 0, left = 0;
    for (int i = 0; i < size(); ++i) all += tests_of(world_.object(i).shape), left += met(i);
    const int few = tests(ray_);
    script_.value("tests, balls first", few, "tests", Role::hit);
    script_.value("tests without", all, "tests");
    if (left == 0) script_.leave_early();
    const std::string cost = few < all
                                 ? fmt::format("\nThat takes {} tests, and {} without the balls.", few, all)
                                 : "\nBoth large objects are left: here the balls cost more than they save.";
    Step& s = step(
        "volumes", "Bounding balls first", 1,
        (left == 0
             ? "The ray meets no bounding ball: nothing is there."
             : fmt::format("A ray that misses the ball around an object (dashed) misses all its triangles. "
                           "{} of {} objects are left.",
                           left, size())) +
            cost);
    s.decides = true;
    s.question = {
        "How many objects need a closer look?", {}, left, "Those whose bounding ball the ray meets."};
    for (int i = 0; i <= size(); ++i) s.question->choices.push_back(std::to_string(i));
  }

  void object(int i) {
    const std::optional<double> t = first_hit(ray_, world_.object(i).shape);
    const bool first = t && (kept_ < 0 || *t < kept_t_);
    const bool tie = t && kept_ >= 0 && *t == kept_t_;
    if (t) script_.value(fmt::format("*t* of {}", name(i)), *t, "t", first ? Role::hit : Role::muted);
    if (t) hits_.emplace_back(i, *t);
    const double before = kept_t_;
    const bool had = kept_ >= 0;
    if (first) kept_ = i, kept_t_ = *t;
    Step& s = step(fmt::format("object-{}", i), fmt::format("Does it meet {}?", name(i)), first ? 3 : 2,
                   !t     ? "The ray passes through the bounding ball's void, and misses the object."
                   : tie  ? "It is met at the very same *t* as the one kept: a tie, which is not nearer. The "
                            "one kept stays."
                   : !had ? "The first one met. It is kept, until one is met at a smaller *t*."
                   : first ? "This one is nearer: it hides the one kept so far, and takes its place."
                           : "It is met too, but farther off. The one kept hides it.",
                   t ? "*t* = " + shown(*t) : "no *t*");
    if (t && had)
      Script::decide(s, {"*t* < least *t*", *t, before, first, first ? "nearer" : tie ? "a tie" : "farther"});
    s.question = {fmt::format("Is {} the nearest so far?", name(i)),
                  {"yes", "no"},
                  first ? 0 : 1,
                  !t ? "The ray does not meet it." : "Its *t* is compared with the least one so far."};
  }

  void picked() {
    if (truth_) {
      const int i = truth_->primitive;
      const bool tie = std::ranges::count_if(hits_, [&](const auto& h) { return h.second == truth_->t; }) > 1;
      script_.settle(tie ? Verdict::Kind::on : Verdict::Kind::yes,
                     "picked: " + name(i) + (tie ? ", after a tie" : ""));
      last(tie ? "Both objects are seen at this point, as they touch there. A rule must choose: here the "
                 "first in order.\n"
                 "What matters is that it is always the same one, in any order of tests."
               : "The nearest object is the one that the eye sees under the pointer (highlighted).\n"
                 "Those behind it cannot be picked here, though the ray meets them.",
           "least *t* = " + shown(truth_->t));
    } else {
      script_.settle(Verdict::Kind::no, "nothing is picked");
      last("No object is met, so the pointer is on the background: a click there may deselect.", "");
    }
  }

  void last(const std::string& caption, const std::string& formula) {
    int sum = 0;
    for (int y = 0; y < eye_.rows; ++y)
      for (int x = 0; x < eye_.columns; ++x) sum += tests(eye_.through(eye_.on_plane({x + 0.5, y + 0.5})));
    script_.value("tests, mean of all pixels", 1.0 * sum / (eye_.rows * eye_.columns), "tests");
    script_.add("picked", "What the eye sees there", 4, caption, formula).scene = seen();
  }

  /// The picture as the eye sees it.
  Scene seen() const {
    std::vector<Cell> cells;
    for (int y = 0; y < eye_.rows; ++y)
      for (int x = 0; x < eye_.columns; ++x) {
        const auto hit = world_.closest(eye_.through(eye_.on_plane({x + 0.5, y + 0.5})));
        if (!hit)
          cells.push_back({Role::grid, {}});
        else if (truth_ && hit->primitive == truth_->primitive)
          cells.push_back({Role::highlight, {}});
        else
          cells.push_back(
              {world_.object(hit->primitive).role, 0.4 + 0.15 * hit->primitive});  // apart in grey, too
      }
    Scene scene;
    const Raster raster = sight::picture(eye_, std::move(cells), Vec3::Zero(), 4.5);
    scene.items.emplace_back(raster);
    scene.items.emplace_back(Dot{on_picture(raster, eye_, eye_.pixel(pointer_)), Mark::ring, Role::text});
    scene.axis = axis();
    return scene;
  }

  static constexpr double far = 2.9;  ///< the end of the ray as drawn

  const World world_;
  const Eye eye_;
  const Vec3 pointer_;
  const Ray3 ray_;
  const std::optional<BvhHit<double>> truth_;
  Script script_;
  std::vector<std::pair<int, double>> hits_;
  int kept_ = -1;
  double kept_t_ = 0;
  bool show_ray_ = false, show_volumes_ = false;
};

Walk walk(const Parameters& values) { return Teller(std::get<Vec3>(values.at("pointer"))).tell(); }

Preset preset_of(const char* id, const char* title, double y, double z) {
  return {id, title, "", {{"pointer", Vec3(plane_x, y, z)}}};
}

}  // namespace

const Lesson& picking() {
  static const Lesson lesson = {
      .id = "picking",
      .title = "Picking",
      .rows = "N01, N03, N16",
      .summary =
          "Which object is under the pointer: the closest hit of its sight line, bounding volumes first.",
      .parameters = {{"pointer", "pointer",
                      "A point of the picture plane, in world units; its first coordinate is not used.",
                      Vec3(plane_x, 0.25, -0.4375), -1e6, 1e6, -2, 2}},
      .group_by = "",
      .presets = {preset_of("front", "the one in front", 0.25, -0.4375),
                  preset_of("behind", "one behind", 0.5, -0.75), preset_of("miss", "nothing", 0.875, 0.25),
                  preset_of("tie", "a tie", 0.25, 0.5625)},
      .camera = from_outside(),
      .walk = walk,
  };
  return lesson;
}

}  // namespace isect::lessons
