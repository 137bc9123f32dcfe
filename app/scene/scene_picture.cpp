#include "app/scene/scene_picture.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "app/scene/types.h"

namespace isect::program::scene {

namespace {

using viz::Role;

/// Above this many objects, a step about some shows only these, and the step about all shows them without names.
constexpr std::size_t most_in_all_pictures = 200;
/// Above this many objects, only those that a step is about, if they are no more, have a handle for each number.
constexpr std::size_t most_with_all_handles = 3;

/// Points, clouds and what runs along a line come first.
Role usual_role(Type t) {
  return runs_along_a_line(t) || t == Type::point || t == Type::cloud ? Role::first : Role::second;
}

/// Returns the own colours of the objects, each for the first and for the second object of a step: in all steps alike.
std::vector<viz::OwnColour> own_colours(const File& file) {
  std::vector<viz::OwnColour> all;
  for (const Object& o : file.objects)
    if (o.colour && std::ranges::find(all, *o.colour, &viz::OwnColour::rgb) == all.end())
      for (const Role like : {Role::first, Role::second}) all.push_back({*o.colour, like});
  return all;
}

/// Returns the items with those of this role in another one.
std::vector<viz::Item> in_role(std::vector<viz::Item> items, Role was, Role now) {
  for (viz::Item& item : items)
    std::visit(
        [&](auto& part) {
          if constexpr (requires { part.role; })
            if (part.role == was) part.role = now;
        },
        item);
  return items;
}

/// Moves the name of a body of many corners, in its middle or at its top, off the names of others, as this camera sees
/// them: to the highest corner that is free or, if none is, to the one farthest from them.
void part_names(viz::Scene& scene, const Room& room, const viz::Camera& camera) {
  const viz::Vec3 ahead = viz::View(camera, 1, 1).forward();
  const double apart = 0.15 * room.reach;
  std::vector<viz::Label*> names;
  for (viz::Item& item : scene.items)
    if (viz::Label* label = std::get_if<viz::Label>(&item)) names.push_back(label);
  for (viz::Label* label : names) {
    const auto to_others = [&](const viz::Vec3& p) {
      double least = INFINITY;
      for (const viz::Label* other : names)
        if (other != label) least = std::min(least, (other->at - p).cross(ahead).norm());
      return least;
    };
    if (label->until || to_others(label->at) > apart) continue;
    for (const viz::Item& item : scene.items) {
      const std::vector<viz::Vec3>* corners = nullptr;
      if (const viz::Mesh* mesh = std::get_if<viz::Mesh>(&item); mesh && mesh->name == label->text)
        corners = &mesh->vertices;
      if (const viz::Solid* solid = std::get_if<viz::Solid>(&item); solid && solid->name == label->text)
        corners = &solid->vertices;
      if (!corners) continue;
      const auto height = [&](const viz::Vec3& p) { return std::pair(to_others(p) > apart, p.y()); };
      const viz::Vec3& best = *std::ranges::max_element(*corners, {}, height);
      label->at = height(best).first ? best : *std::ranges::max_element(*corners, {}, to_others);
    }
  }
}

}  // namespace

std::vector<Role> roles_of_all(const File& file) {
  std::vector<Role> roles;
  for (const Object& o : file.objects) roles.push_back(usual_role(o.type));
  if (roles.size() < 2 || std::ranges::adjacent_find(roles, std::ranges::not_equal_to{}) != roles.end()) return roles;
  std::vector<std::vector<std::size_t>> asked_before(roles.size());  // the earlier ones they are asked with
  for (const Asked& asked : file.asked)
    if (const PairAsked* pair = std::get_if<PairAsked>(&asked))
      asked_before[std::max(pair->a, pair->b)].push_back(std::min(pair->a, pair->b));
  for (std::size_t i = 0; i < roles.size(); ++i) {
    const auto first = std::ranges::count_if(asked_before[i], [&](std::size_t k) { return roles[k] == Role::first; });
    const auto second = std::ssize(asked_before[i]) - first;
    roles[i] = (first == second ? i % 2 == 0 : first < second) ? Role::first : Role::second;
  }
  return roles;
}

viz::Scene scene_picture(const Context& context, ObjectPictures& pictures, const std::vector<Role>& roles,
                         const std::vector<std::size_t>& lit, int step, const viz::Camera& camera) {
  viz::Scene scene;
  scene.colours = own_colours(context.file);
  const bool few = context.file.objects.size() <= most_with_all_handles;
  for (std::size_t i = 0; i < context.file.objects.size(); ++i) {
    const Object& o = context.object(i);
    if (o.hidden) continue;
    const auto at = std::ranges::find(lit, i);
    if (at == lit.end() && !o.steps.has(step)) continue;
    Role role = lit.empty() ? roles[i] : usual_role(o.type);
    if (!lit.empty() && at == lit.end()) {
      if (context.file.objects.size() > most_in_all_pictures) continue;
      role = Role::muted;
    }
    if (lit.size() == 2 && at != lit.end()) role = at == lit.begin() ? Role::first : Role::second;
    const bool in_colour = role != Role::muted && o.colour;
    if (role != Role::muted && o.role) role = *o.role;
    const HandlesOf which =
        few || (at != lit.end() && lit.size() <= most_with_all_handles) ? HandlesOf::all : HandlesOf::points;
    const ObjectPictures::Picture& picture = pictures.of(context.numbers, o, i, context.room, role, which);
    if (in_colour) {
      const auto known = std::ranges::find(scene.colours, viz::OwnColour{*o.colour, role});
      const Role own = viz::own_role(static_cast<std::size_t>(known - scene.colours.begin()));
      std::ranges::move(in_role(picture.items, role, own), std::back_inserter(scene.items));
    } else {
      std::ranges::copy(picture.items, std::back_inserter(scene.items));
    }
    std::ranges::copy(picture.handles, std::back_inserter(scene.handles));
  }
  const bool too_many = context.file.objects.size() > most_in_all_pictures;
  if (too_many && lit.empty())
    std::erase_if(scene.items, [](const viz::Item& item) { return std::holds_alternative<viz::Label>(item); });
  else if (!too_many && !context.file.flat)
    part_names(scene, context.room, camera);
  for (const Note& note : context.file.notes)  // each on its point
    scene.items.push_back(viz::Label{note.at, note.text, Role::text, note.at});
  return scene;
}

}  // namespace isect::program::scene
