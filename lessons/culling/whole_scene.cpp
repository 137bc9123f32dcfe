// All volumes of a scene: each plane rejects some, and what is left is drawn.

#include <fmt/format.h>

#include <algorithm>

#include "lessons/culling/picture.h"
#include "lessons/shared/plural.h"
#include "lessons/shared/questions.h"
#include "lessons/shared/script.h"

namespace isect::lessons::culling_lesson {

using namespace viz;

namespace {

const std::vector<Volume>& volumes() {
  static const std::vector<Volume> all = {Box{{1, -1, -1.25}, {1.75, -0.25, -0.5}},
                                          Ball{{-0.25, 0.125, 0.5}, 0.5},
                                          Box{{2.5, 0.25, 0.5}, {3.5, 1.25, 1.5}},
                                          Ball{{0.75, 1.25, -0.25}, 0.375},
                                          Box{{-2, 1.25, -0.25}, {-1.25, 2, 0.5}},
                                          Ball{{-0.75, -0.25, 2.25}, 0.5},
                                          Ball{{-0.5, -1.75, 0.5}, 0.5},
                                          Box{{-0.75, -0.25, -3.25}, {0.25, 0.75, -2.25}},
                                          Ball{{1.5, 0.25, 2.25}, 0.5},
                                          Box{{3.75, -0.75, -1.5}, {4.5, 0, -0.75}}};
  return all;
}

class WholeScene {
 public:
  WholeScene(const Frustum<double>& view, const Vec3& eye)
      : view_(view),
        eye_(eye),
        script_({"Lecture note, view-volume culling; Akenine-Möller and Haines, Real-Time Rendering (2002), ch. 13",
                 {},
                 {"for each volume of the scene",                              // 0
                  "    for each plane: skip the volume if it lies beyond",     // 1
                  "    if no plane cuts it: draw it, and test nothing in it",  // 2
                  "    else: draw it, as it may be visible"},                  // 3
                 "a scene"}) {
    for (const Volume& volume : volumes()) answers_.push_back(ask(volume, view));
  }

  Walk tell() {
    script_.value("volumes", size());
    script_
        .add("scene", "A scene", 0,
             "Each volume bounds an object. What lies wholly outside the frustum need not be drawn.")
        .scene = picture(-1, false, false);
    for (int plane = 0; plane < 6; ++plane) reject(plane);
    const int inside = count(Culling::inside), crossing = count(Culling::crossing);
    script_.walk().alt =
        fmt::format("A view frustum with its eye, and {} boxes and balls: {} inside, {} crossing, {} outside.", size(),
                    inside, crossing, size() - inside - crossing);
    script_.value("inside", inside, {}, Role::hit);
    script_
        .add("inside", "Inside all six", 2,
             inside == 0
                 ? "None of those left lies inside all six planes."
                 : fmt::format("No plane cuts {} of them: {} inside. What {} needs no test and no clipping.", inside,
                               inside == 1 ? "it lies" : "they lie", inside == 1 ? "it bounds" : "they bound"))
        .scene = picture(6, true, false);
    script_.value("crossing", crossing);
    script_.settle(inside + crossing > 0 ? Verdict::Kind::yes : Verdict::Kind::no,
                   fmt::format("{} of {} volumes are drawn", inside + crossing, size()));
    script_
        .add("all", "All volumes of the scene", 3,
             fmt::format("{}\nEarly rejection saves plane tests: {} were made, not {}.",
                         crossing == 0   ? "None crosses."
                         : crossing == 1 ? "One crosses and may be visible, so it is drawn too and clipped later."
                                         : fmt::format("{} cross and may be visible, so they are drawn too and clipped "
                                                       "later.",
                                                       crossing),
                         planes_asked(), 6 * size()))
        .scene = picture(6, true, true);
    return std::move(script_.walk());
  }

 private:
  int size() const { return static_cast<int>(answers_.size()); }
  int count(Culling c) const {
    return static_cast<int>(std::ranges::count_if(answers_, [&](const Answer& a) { return a.culling == c; }));
  }
  int rejected_by(int plane) const {
    return static_cast<int>(
        std::ranges::count_if(answers_, [&](const Answer& a) { return a.rejecting_plane() == plane; }));
  }
  int planes_asked() const {
    int sum = 0;
    for (const Answer& a : answers_) sum += static_cast<int>(a.tested.size());
    return sum;
  }

  /// The scene with what the planes up to `plane` reject, and the inner and crossing volumes once they are known.
  Scene picture(int plane, bool inside, bool crossing) const {
    Scene scene;
    add_view(view_, eye_, scene);
    for (std::size_t i = 0; i < answers_.size(); ++i) {
      const Answer& a = answers_[i];
      const bool known = a.culling == Culling::outside  ? a.rejecting_plane() <= plane
                         : a.culling == Culling::inside ? inside
                                                        : crossing;
      if (known)
        add(volumes()[i], a, scene);
      else
        add(volumes()[i], Role::muted, scene);
    }
    scene.handles = {{"eye", Handle::Kind::point, eye_, Vec3::Zero(), Role::first}};
    return scene;
  }

  void reject(int plane) {
    const int gone = rejected_by(plane), left = size() - (rejected_ += gone);
    const std::string name = plane_names[plane];
    script_.value("outside", rejected_, {}, Role::miss);
    Step& step =
        script_.add("plane-" + name, fmt::format("The {} plane", name), 1,
                    std::string(gone == 0   ? "No volume that is left lies beyond it."
                                : gone == 1 ? "It rejects one volume, which lies wholly beyond it."
                                            : fmt::format("It rejects {} volumes, which lie wholly beyond it.", gone)) +
                        (plane == 5 ? "" : fmt::format(" The next plane is tested for {}.", plural(left, "volume"))));
    step.decides = gone > 0;
    step.scene = picture(plane, false, false);
    add_plane(view_, plane, step.scene);
    step.question =
        which_count(fmt::format("Only volumes that no earlier plane rejected are tested. Inside the {} plane is {}. "
                                "How many does it reject?",
                                name, inner_side(view_.planes[plane])),
                    gone,
                    {{static_cast<double>(rejected_), "That counts those that earlier planes have rejected, too."},
                     {static_cast<double>(left), "That is how many it leaves."},
                     {0, "At least one of those left lies wholly beyond it."}},
                    "Those that lie wholly beyond it.");
    give_before(script_.walk(), {"outside"});
  }

  const Frustum<double> view_;
  const Vec3 eye_;
  Script script_;
  std::vector<Answer> answers_;
  int rejected_ = 0;
};

}  // namespace

Walk whole_scene(const Frustum<double>& view, const Vec3& eye) { return WholeScene(view, eye).tell(); }

}  // namespace isect::lessons::culling_lesson
