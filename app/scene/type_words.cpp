#include "app/scene/type_words.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace isect::program::scene {

namespace {

using viz::message;
using viz::message_as;
using viz::message_count;

struct TypeWords {
  viz::Message in_list, counted, with_article;
};
/// In the order of Type.
constexpr TypeWords type_words[] = {
    {message_as("in a list", "point"), message_count("{n} point", "{n} points"),
     message_as("no test is made for", "a point")},
    {message_as("in a list", "segment"), message_count("{n} segment", "{n} segments"),
     message_as("no test is made for", "a segment")},
    {message_as("in a list", "ray"), message_count("{n} ray", "{n} rays"), message_as("no test is made for", "a ray")},
    {message_as("in a list", "line"), message_count("{n} line", "{n} lines"),
     message_as("no test is made for", "a line")},
    {message_as("in a list", "plane"), message_count("{n} plane", "{n} planes"),
     message_as("no test is made for", "a plane")},
    {message_as("in a list", "sphere"), message_count("{n} sphere", "{n} spheres"),
     message_as("no test is made for", "a sphere")},
    {message_as("in a list", "box"), message_count("{n} box", "{n} boxes"), message_as("no test is made for", "a box")},
    {message_as("in a list", "oriented box"), message_count("{n} oriented box", "{n} oriented boxes"),
     message_as("no test is made for", "an obb")},
    {message_as("in a list", "capsule"), message_count("{n} capsule", "{n} capsules"),
     message_as("no test is made for", "a capsule")},
    {message_as("in a list", "cylinder"), message_count("{n} cylinder", "{n} cylinders"),
     message_as("no test is made for", "a cylinder")},
    {message_as("in a list", "cone"), message_count("{n} cone", "{n} cones"),
     message_as("no test is made for", "a cone")},
    {message_as("in a list", "triangle"), message_count("{n} triangle", "{n} triangles"),
     message_as("no test is made for", "a triangle")},
    {message_as("in a list", "polygon"), message_count("{n} polygon", "{n} polygons"),
     message_as("no test is made for", "a polygon")},
    {message_as("in a list", "k-DOP"), message_count("{n} kdop", "{n} kdops"),
     message_as("no test is made for", "a kdop")},
    {message_as("in a list", "frustum"), message_count("{n} frustum", "{n} frustums"),
     message_as("no test is made for", "a frustum")},
    {message_as("in a list", "hull"), message_count("{n} hull", "{n} hulls"),
     message_as("no test is made for", "a hull")},
    {message_as("in a list", "mesh"), message_count("{n} mesh", "{n} meshes"),
     message_as("no test is made for", "a mesh")},
    {message_as("in a list", "point cloud"), message_count("{n} cloud", "{n} clouds"),
     message_as("no test is made for", "a cloud")},
};
/// A sphere in the plane.
constexpr TypeWords circle_words = {message_as("in a list", "circle"), message_count("{n} circle", "{n} circles"),
                                    message_as("no test is made for", "a sphere")};

const TypeWords& words_of(Type type, bool flat) {
  return flat && type == Type::sphere ? circle_words : type_words[static_cast<std::size_t>(type)];
}

constexpr VolumeWords volume_words[] = {
    {"sphere", true, message_as("in a list", "smallest circle"), message("The smallest circle of {a}"),
     message("the smallest circle of {a} has area {size}"), message("area of the smallest circle")},
    {"sphere", false, message_as("in a list", "smallest ball"), message("The smallest ball of {a}"),
     message("the smallest ball of {a} has volume {size}"), message("volume of the smallest ball")},
    {"box", true, message_as("in a list", "AABB"), message("The AABB of {a}"),
     message("the AABB of {a} has area {size}"), message("area of the AABB")},
    {"box", false, message_as("in a list", "AABB"), message("The AABB of {a}"),
     message("the AABB of {a} has volume {size}"), message("volume of the AABB")},
    {"obb", true, message_as("in a list", "OBB"), message("The OBB of {a}"), message("the OBB of {a} has area {size}"),
     message("area of the OBB")},
    {"obb", false, message_as("in a list", "OBB"), message("The OBB of {a}"),
     message("the OBB of {a} has volume {size}"), message("volume of the OBB")},
    {"kdop", true, message_as("in a list", "8-DOP"), message("The 8-DOP of {a}"),
     message("the 8-DOP of {a} has area {size}"), message("area of the 8-DOP")},
    {"kdop", false, message_as("in a list", "26-DOP"), message("The 26-DOP of {a}"),
     message("the 26-DOP of {a} has volume {size}"), message("volume of the 26-DOP")},
    {"hull", true, message_as("in a list", "hull"), message("The hull of {a}"),
     message("the hull of {a} has area {size}"), message("area of the hull")},
    {"hull", false, message_as("in a list", "hull"), message("The hull of {a}"),
     message("the hull of {a} has volume {size}"), message("volume of the hull")},
};

}  // namespace

std::string type_in_list(Type type, bool flat) { return tr(words_of(type, flat).in_list); }

std::string counted_types(std::size_t n, Type type, bool flat) { return tr_count(n, words_of(type, flat).counted); }

std::string article_and_type(Type type) { return tr(words_of(type, false).with_article); }

std::string asked_volume(const std::string& volume, bool flat, const std::string& name) {
  const viz::Filling object = {{"a", name}};
  if (volume == "sphere" && flat) return viz::tr("Which circle fits {a} tightly?", object);
  if (volume == "sphere") return viz::tr("Which sphere fits {a} tightly?", object);
  if (volume == "box") return viz::tr("Which box fits {a} tightly?", object);
  if (volume == "obb") return viz::tr("Which oriented box fits {a} tightly?", object);
  if (volume == "kdop") return viz::tr("Which kdop fits {a} tightly?", object);
  return viz::tr("Which hull fits {a} tightly?", object);
}

const VolumeWords& words_of(const std::string& volume, bool flat) {
  const auto* const found = std::ranges::find_if(
      volume_words, [&](const VolumeWords& words) { return words.flat == flat && words.volume == volume; });
  if (found == std::end(volume_words)) throw std::logic_error("there is no volume called " + volume);
  return *found;
}

}  // namespace isect::program::scene
