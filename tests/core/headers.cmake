# Every header of the core has a test: isect/<name>.h, in whichever folder there, in tests/core/<name>_test.cpp, or a
# part of another header in the test named here, which must include it, directly or by way of others.
#   cmake -D ROOT=... -P headers.cmake
cmake_minimum_required(VERSION 3.22)
set(tested_by
  any_shape=answer
  ask=answer
  ask_meshes=answer
  ask_pairs=answer
  batch_aabb=batch
  batch_point_polygon=batch
  batch_ray_sphere=batch
  bvh_split=bvh
  capsule_half_spaces=half_spaces
  conventions=shapes
  convex_hull_3d_growth=convex_hull_3d
  directions=kdop_polytope
  fit_guess=fit
  fit_tight_guess=fit_tight
  frustum_planes=aabb_frustum
  index_pair=all_pairs
  inequalities=half_spaces
  inequality_distance=half_spaces
  inner_point=mesh_half_spaces
  instruction_set=batch
  mesh_surface=mesh_mesh
  obb_obb_axes=obb_obb
  obb_obb_first_pass=obb_obb
  obb_obb_methods=obb_obb
  overlapping_pairs=all_pairs
  overlapping_pairs_corners=all_pairs
  overlapping_pairs_level=all_pairs
  place=first_place
  plane_cone_methods=plane_cone
  plane_cylinder_methods=plane_cylinder
  plane_round=plane_cylinder
  point_cone_methods=point_cone
  point_cylinder_methods=point_cylinder
  point_polygon_fast=point_polygon
  point_segment=sphere_capsule
  predicate=bounded
  quotient=bounded
  ray_cone_methods=ray_cone
  ray_cylinder_methods=ray_cylinder
  ray_half_spaces=half_spaces
  ray_mesh_parts=ray_mesh
  ray_range=ray_plane
  ray_round=ray_cylinder
  ray_sphere_meeting=ray_sphere
  ray_sphere_roots=ray_sphere
  ray_sphere_settle=ray_sphere
  root=ray_capsule
  round_half_spaces=cylinder_half_spaces
  slabs=ray_aabb
  round_solid=point_cylinder
  sphere_cone_methods=sphere_cone
  sphere_cylinder_methods=sphere_cylinder
  sphere_half_spaces=half_spaces
  sphere_round=sphere_cylinder
  straight=ray_capsule
  triangle_aabb_first_pass=triangle_aabb
  triangle_aabb_methods=triangle_aabb
  triangle_half_spaces=half_spaces
  two_triangles=mesh_mesh
  unit_of_length=capsule_capsule)

# All files of ours that a file includes.
function(includes_of file result)
  set(seen ${file})
  set(open ${file})
  while(open)
    list(POP_FRONT open next)
    file(STRINGS ${ROOT}/${next} lines REGEX "^#include (\"|<isect/)")
    foreach(line ${lines})
      string(REGEX REPLACE "^#include [<\"]([^>\"]*).*" "\\1" included ${line})
      string(REGEX REPLACE "^isect/" "core/isect/" included ${included})
      if(NOT included IN_LIST seen AND EXISTS ${ROOT}/${included})
        list(APPEND seen ${included})
        list(APPEND open ${included})
      endif()
    endforeach()
  endwhile()
  set(${result} "${seen}" PARENT_SCOPE)
endfunction()

set(complaints "")
file(GLOB_RECURSE headers RELATIVE ${ROOT}/core ${ROOT}/core/isect/*.h)
list(LENGTH headers count)
if(count LESS 90)
  message(FATAL_ERROR "only ${count} headers in ${ROOT}/core")
endif()
foreach(header ${headers})
  get_filename_component(name ${header} NAME_WE)
  set(test ${name})
  set(listed ${tested_by})
  list(FILTER listed INCLUDE REGEX "^${name}=")
  list(REMOVE_ITEM tested_by "${listed}")
  if(listed)
    string(REPLACE "${name}=" "" test ${listed})
    if(EXISTS ${ROOT}/tests/core/${name}_test.cpp)
      string(APPEND complaints "core/${header} has a test of its own, so it needs no line in headers.cmake\n")
    endif()
  endif()
  set(file tests/core/${test}_test.cpp)
  if(NOT EXISTS ${ROOT}/${file})
    string(APPEND complaints "core/${header} has no test: write ${file}, or name the test in headers.cmake\n")
    continue()
  endif()
  includes_of(${file} included)
  if(NOT core/${header} IN_LIST included)
    string(APPEND complaints "${file} doesn't include core/${header}\n")
  endif()
endforeach()
foreach(entry ${tested_by})
  string(APPEND complaints "${entry}: there is no such header\n")
endforeach()
if(complaints)
  message(FATAL_ERROR "${complaints}")
endif()
