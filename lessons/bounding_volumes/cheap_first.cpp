#include "lessons/bounding_volumes/cheap_first.h"

#include <fmt/format.h>

#include <algorithm>

#include <isect/aabb_aabb.h>
#include <isect/fit.h>
#include <isect/methods/aabb_aabb.h>
#include <isect/methods/triangle_aabb.h>
#include <isect/point_mesh.h>
#include <isect/triangle_aabb.h>
#include "lessons/bounding_volumes/picture.h"
#include "lessons/shared/plural.h"
#include "lessons/shared/script.h"
#include "viz/solids.h"

namespace isect::lessons::bounding_volumes_lesson {

using namespace viz;

namespace {

using C = Counted<double>;
using Mesh3 = TriangleMesh<double>;
using Box = Aabb<double, 3>;

int operations(const Tally& t) { return t.mul + t.add + t.div + t.sqrt + t.compare; }

/// Whether the box `inner`, which is not empty, lies in `outer`, axis by axis.
bool inside(const Aabb<C, 3>& inner, const Aabb<C, 3>& outer) {
  for (int axis = 0; axis < 3; ++axis)
    if (inner.lo[axis] < outer.lo[axis] || inner.hi[axis] > outer.hi[axis]) return false;
  return true;
}

/// The object tested against the box, and the operations that this took.
struct TestedObject {
  TestedObject(const Mesh3& mesh, const Box& window, const Vec3& middle)
      : around(fit_aabb(mesh.vertices)), truth(relate(around, window)) {
    tally() = {};
    rejected = !aabb_aabb::by_axis(cast<C>(around), cast<C>(window));
    accepted = !rejected && inside(cast<C>(around), cast<C>(window));
    cheap = tally();
    tally() = {};
    for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i)
      triangle_aabb::akenine_moller(cast<C>(triangle(mesh, i)), cast<C>(window));
    expensive = tally();
    for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i)
      if (intersects(triangle(mesh, i), window)) hits.push_back(i);
    if (!rejected && !accepted && hits.empty()) within = locate(middle, mesh) == Location::in;
  }

  Box around;
  Relation truth;
  bool rejected, accepted;
  bool within = false;     ///< b lies wholly in the object, and meets no triangle of its surface
  Tally cheap, expensive;  ///< operations of the volume's tests; of all triangles' tests
  std::vector<int> hits;   ///< triangles that meet the window, exactly
};

class Teller {
 public:
  Teller(const Mesh3& mesh, const Vec3& tip, const Vec3& middle, double reach)
      : mesh_(mesh),
        window_{middle - Vec3::Constant(reach), middle + Vec3::Constant(reach)},
        test_(mesh, window_, middle),
        script_({"Lecture note, bounding volumes",
                 "An object a in its bounding box, and another box, b: " + outcome() + ".",
                 {"if the volume of a is disjoint from b",        // 0
                  "    return OUTSIDE",                           // 1
                  "if the volume of a lies in b",                 // 2
                  "    return INSIDE",                            // 3
                  "for each triangle of a",                       // 4
                  "    if it meets b: return CROSSING",           // 5
                  "if the middle of b lies in a: return B IN A",  // 6
                  "return OUTSIDE"},                              // 7
                 "cheap test first"}) {
    handles_ = {{"q", Handle::Kind::point, middle, Vec3::Zero(), Role::second},
                {"tip", Handle::Kind::point, tip, Vec3::Zero(), Role::first}};
  }

  Walk tell() {
    script_.value("triangles", static_cast<double>(mesh_.triangles.size()));
    add("question", "How much of a lies in b?", 0,
        fmt::format("All of the object, none, or a part? All its {} triangles may have to be tested.\n"
                    "So its bounding box is tested first: it may settle the question.",
                    mesh_.triangles.size()),
        false, false);
    volume_first();
    if (!test_.rejected && !test_.accepted) triangles_then();
    return std::move(script_.walk());
  }

 private:
  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption, bool volume,
            bool hits, const std::string& formula = {}) {
    Step& step = script_.add(slug, title, line, caption, formula);
    Scene& scene = step.scene;
    Mesh3 plain = mesh_, hit = mesh_;
    if (hits) {
      plain.triangles.clear(), hit.triangles.clear();
      for (int i = 0; i < static_cast<int>(mesh_.triangles.size()); ++i)
        (std::ranges::binary_search(test_.hits, i) ? hit : plain).triangles.push_back(mesh_.triangles[i]);
    }
    scene.items.push_back(drawn(plain, Role::first));
    if (hits && !test_.hits.empty()) scene.items.push_back(drawn(hit, Role::hit));
    scene.items.push_back(solid(window_, Role::second));
    if (volume) scene.items.push_back(solid(test_.around, Role::first));
    scene.items.push_back(Label{{window_.hi.x(), window_.hi.y(), window_.lo.z()}, "b", Role::second});
    if (volume)
      scene.items.push_back(
          Label{{test_.around.lo.x(), test_.around.hi.y(), test_.around.lo.z()}, "volume of a", Role::first});
    scene.handles = handles_;
    return step;
  }

  std::string outcome() const {
    if (test_.rejected) return "trivial reject";
    if (test_.accepted) return "trivial accept";
    if (test_.within) return "b lies wholly in the object";
    return test_.hits.empty() ? "only the void of the volume overlaps b" : "the object's surface meets b";
  }

  /// Why one point of b decides, where no triangle meets b.
  static std::string said_of_side(const std::string& side) {
    return "b is connected and meets no triangle, so it lies on one side of the surface. Any of its points decides: "
           "its middle lies " +
           side + ", so all of b does.\n";
  }

  void volume_first() {
    const int cheap = operations(test_.cheap), all = operations(test_.expensive);
    script_.count(test_.cheap);
    script_.value("volumes", cheap, "operations", Role::hit);
    script_.value("all triangles", all, "operations", Role::muted);
    const bool trivial = test_.rejected || test_.accepted;
    if (!test_.rejected) script_.refuse(0, {1});
    if (!trivial) script_.refuse(2, {3});
    if (trivial) {
      script_.leave_early();
      script_.settle(test_.rejected ? Verdict::Kind::no : Verdict::Kind::yes,
                     test_.rejected ? "trivial reject: OUTSIDE" : "trivial accept: INSIDE");
    }
    Step& step =
        add("volume-first", "The volume first",
            test_.rejected   ? 1
            : test_.accepted ? 3
                             : 2,
            test_.rejected ? "The volume misses b, so its contents do too. No triangle is tested.\n"
                             "A no to objects that meet would be a false negative. A volume that contains its object "
                             "gives none."
            : test_.accepted
                ? "The volume lies in b, so its contents do too. No triangle is tested."
                : "The volume and b overlap. That decides nothing about the object: the overlap is only potential.",
            true, false, fmt::format("{}, where all triangles take {}", plural(cheap, "operation"), counted(all)));
    step.decides = true;
    step.question = Question{
        "What does the volume's test show?",
        {"trivial reject", "trivial accept", "potential overlap"},
        test_.rejected   ? 0
        : test_.accepted ? 1
                         : 2,
        fmt::format("Each of the two tests takes six comparisons at most: here {} in all.", operations(test_.cheap))};
  }

  void triangles_then() {
    const bool meets = !test_.hits.empty();
    const Tally &c = test_.cheap, &e = test_.expensive;
    script_.count({c.mul + e.mul, c.add + e.add, c.div + e.div, c.sqrt + e.sqrt, c.compare + e.compare});
    script_.value("triangles that meet b", static_cast<double>(test_.hits.size()), {}, meets ? Role::hit : Role::miss);
    add("triangles", "Now every triangle", 4,
        meets ? "Those marked meet b. A yes-or-no test could stop at the first."
              : "No triangle meets b. Finding that out took a test of each.\n"
                "One case is left: a box deep inside the object meets no triangle of its surface either.",
        true, true, fmt::format("{} of {} triangles meet b", test_.hits.size(), mesh_.triangles.size()))
        .question = Question{"Where does b lie?",
                             {"across the object's surface", "in the void of the volume", "wholly inside the object"},
                             meets          ? 0
                             : test_.within ? 2
                                            : 1,
                             "Each triangle is tested against b; where none meets it, any one point of b decides."};
    const bool within = test_.within;
    script_.settle(meets || within ? Verdict::Kind::yes : Verdict::Kind::no,
                   meets    ? "CROSSING: the object's surface meets b"
                   : within ? "b lies inside a"
                            : "OUTSIDE: b lies in the void");
    if (!meets) script_.refuse(5, {});
    if (!meets && !within) script_.refuse(6, {});
    Step& step = add("verdict",
                     meets    ? "A true overlap"
                     : within ? "Containment"
                              : "A false positive",
                     meets    ? 5
                     : within ? 6
                              : 7,
                     meets    ? "The volume's test was not wasted: for most pairs of a scene it is the last one."
                     : within ? said_of_side("inside") +
                                    "A test of triangles alone would call this OUTSIDE. Of two closed surfaces that do "
                                    "not meet, either may contain the other: test a point of each."
                              : said_of_side("outside") +
                                    "So only the void of the volume met it: a yes of the cheap test, though a and b do "
                                    "not meet. Less void means fewer false positives. That is why tightness counts.",
                     true, true);
    step.decides = true;
  }

  const Mesh3& mesh_;
  const Box window_;
  const TestedObject test_;
  Script script_;
  std::vector<Handle> handles_;
};

}  // namespace

Walk cheap_first(const Mesh3& mesh, const Vec3& tip, const Vec3& middle, double reach) {
  return Teller(mesh, tip, middle, reach).tell();
}

}  // namespace isect::lessons::bounding_volumes_lesson
