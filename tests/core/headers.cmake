# Every header of the core has a test, which must include it, directly or by way of others, and stands in its room.
# The test of isect/<name>.h, be it among parts or numbers, is tests/core/<name>_test.cpp, that of isect/many/<name>.h
# many/<name>_test.cpp there, that of isect/methods/<name>.h methods/<name>_methods_test.cpp, or the one named here.
# What is exact includes no method, what is naive is one, and no source includes a header by an old name.
#   cmake -D ROOT=... -P headers.cmake
cmake_minimum_required(VERSION 3.22)
set(tested_by
  any_shape=answer
  ask=answer
  ask_any=compiled
  ask_meshes=answer
  ask_pairs=answer
  bvh_split=many/bvh
  capsule_half_spaces=half_spaces
  components=bounded
  conventions=shapes
  convex_hull_3d_growth=convex_hull_3d
  directions=kdop_polytope
  fit_guess=fit
  fit_tight_guess=fit_tight
  frustum_planes=aabb_frustum
  index_pair=many/all_pairs
  inequalities=half_spaces
  inequality_distance=half_spaces
  inner_point=mesh_half_spaces
  instruction_set=many/batch
  interval=shapes
  many/batch_aabb=many/batch
  many/batch_point_polygon=many/batch
  many/batch_ray_sphere=many/batch
  many/overlapping_pairs=many/all_pairs
  mesh_surface=mesh_mesh
  methods/obb_obb=obb_obb
  methods/plane_aabb=plane_aabb
  methods/plane_cone=plane_cone
  methods/plane_cylinder=plane_cylinder
  methods/point_cone=point_cone
  methods/point_convex_polygon=point_convex_polygon
  methods/point_cylinder=point_cylinder
  methods/ray_cone=ray_cone
  methods/ray_cylinder=ray_cylinder
  methods/ray_sphere_stable=methods/ray_sphere_stable
  methods/sphere_cone=sphere_cone
  methods/sphere_cylinder=sphere_cylinder
  methods/triangle_aabb=triangle_aabb
  obb_obb_axes=obb_obb
  obb_obb_first_pass=obb_obb
  overlapping_pairs_corners=many/all_pairs
  overlapping_pairs_level=many/all_pairs
  place=first_place
  plane_round=plane_cylinder
  point_polygon_fast=point_polygon
  point_segment=sphere_capsule
  polygon_edges=polygon_polygon
  polygon_overlay=polygon_polygon
  predicate=bounded
  quotient=bounded
  ray_half_spaces=half_spaces
  ray_mesh_parts=many/ray_mesh
  ray_range=ray_plane
  ray_round=ray_cylinder
  ray_sphere_arithmetic=arithmetic
  ray_sphere_meeting=ray_sphere
  ray_sphere_roots=ray_sphere
  ray_sphere_settle=ray_sphere
  root=ray_capsule
  round_half_spaces=cylinder_half_spaces
  round_solid=point_cylinder
  slabs=ray_aabb
  sphere_half_spaces=half_spaces
  sphere_round=sphere_cylinder
  straight=ray_capsule
  three_quotients=bounded
  triangle_aabb_first_pass=triangle_aabb
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
  string(REGEX REPLACE "^isect/(parts/|numbers/)?|\\.h$" "" name ${header})
  string(REGEX REPLACE "^methods/.*" "\\0_methods" test ${name})
  set(own ${test})
  set(listed ${tested_by})
  list(FILTER listed INCLUDE REGEX "^${name}=")
  list(REMOVE_ITEM tested_by "${listed}")
  if(listed)
    string(REPLACE "${name}=" "" test ${listed})
    if(NOT test STREQUAL own AND EXISTS ${ROOT}/tests/core/${own}_test.cpp)
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

# Exact headers neither include a method nor have one.
foreach(header ${headers})
  if(header MATCHES "^isect/methods/")
    continue()
  endif()
  file(STRINGS ${ROOT}/core/${header} methods REGEX "^#include [<\"](isect/)?methods/")
  file(STRINGS ${ROOT}/core/${header} naive REGEX "[Nn]aive")
  if(methods)
    string(APPEND complaints "core/${header} includes a method: move what it needs to isect/parts/\n")
  endif()
  if(naive)
    string(APPEND complaints "core/${header} has what is naive: it belongs in isect/methods/\n")
  endif()
endforeach()

# Sources include headers by the names that they have now.
include(${ROOT}/core/moved.cmake)
set(olds ${isect_moved})
list(TRANSFORM olds REPLACE "=.*" "")
list(JOIN olds "|" olds)
foreach(ring core viz bench lessons app tests web examples)
  file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/${ring}/*.h ${ROOT}/${ring}/*.cpp)
  list(REMOVE_ITEM files tests/packaging/main.cpp)
  foreach(file ${files})
    file(STRINGS ${ROOT}/${file} old REGEX "^ *#include [<\"]isect/(${olds})\\.h[>\"]")
    if(old)
      string(APPEND complaints "${file} includes by an old name: ${old}\n")
    endif()
  endforeach()
endforeach()
foreach(moved ${isect_moved})
  string(REGEX MATCH "(.*)=(.*)" moved ${moved})
  if(EXISTS ${ROOT}/core/isect/${CMAKE_MATCH_1}.h OR NOT EXISTS ${ROOT}/core/isect/${CMAKE_MATCH_2}.h)
    string(APPEND complaints "core/moved.cmake: ${moved} is not where a header was and where it is\n")
  endif()
endforeach()
if(complaints)
  message(FATAL_ERROR "${complaints}")
endif()
