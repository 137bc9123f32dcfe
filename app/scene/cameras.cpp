#include "app/scene/cameras.h"

#include <cmath>
#include <numbers>
#include <string>

namespace isect::program::scene {

namespace {

constexpr double degree = std::numbers::pi / 180;

/// Reads the direction and the projection, as far as they are given.
void read_direction(const Source& source, const Json& camera, const Path& path, viz::Camera& to) {
  if (camera.contains("azimuth")) to.azimuth = degree * source.number(camera["azimuth"], below(path, "azimuth"));
  if (camera.contains("elevation")) {
    const double elevation = source.number(camera["elevation"], below(path, "elevation"));
    if (std::abs(elevation) > 90) source.refuse(below(path, "elevation"), "-90 to 90 degrees are expected");
    to.elevation = degree * elevation;
  }
  if (camera.contains("perspective")) {
    if (!camera["perspective"].is_boolean()) source.refuse(below(path, "perspective"), "true or false is expected");
    to.perspective = camera["perspective"];
  }
}

}  // namespace

viz::Camera read_camera(const Source& source) {
  viz::Camera camera;
  if (!source.json().contains("camera")) return camera;
  const Json& json = source.json()["camera"];
  source.only(json, {"camera"}, {"azimuth", "elevation", "perspective"});
  read_direction(source, json, {"camera"}, camera);
  return camera;
}

viz::StepView read_step_camera(Source& source, const Json& json, const Path& path, const viz::Camera& of_scene) {
  constexpr double narrowest = 0.5, widest = 178;  // degrees
  constexpr double least = 1e-300;
  source.only(json, path, {"azimuth", "elevation", "target", "half_height", "perspective", "field_of_view"});
  if (json.empty()) source.refuse(path, "it is empty");
  viz::StepView view = {of_scene};
  if (source.flat()) {
    for (const std::string field : {"azimuth", "elevation", "perspective", "field_of_view"})
      if (json.contains(field))
        source.refuse(below(path, field),
                      "a scene in the plane is seen straight on; \"target\" and \"half_height\" are allowed");
    view.camera.azimuth = view.camera.elevation = 0, view.camera.perspective = false;
  }
  read_direction(source, json, path, view.camera);
  if (json.contains("field_of_view")) {
    const Path to = below(path, "field_of_view");
    const double angle = source.number(json["field_of_view"], to);
    if (!(angle >= narrowest && angle <= widest)) source.refuse(to, "0.5 to 178 degrees are expected");
    view.camera.field_of_view = degree * angle;
  }
  if (json.contains("target"))
    view.camera.target = source.vector(json["target"], below(path, "target")), view.has_target = true;
  if (json.contains("half_height")) {
    const Path to = below(path, "half_height");
    view.camera.half_height = source.number(json["half_height"], to), view.has_half_height = true;
    if (!(view.camera.half_height >= least))
      source.refuse(to, "a length above 0 is expected: from the middle of the picture to its top edge");
  }
  return view;
}

}  // namespace isect::program::scene
