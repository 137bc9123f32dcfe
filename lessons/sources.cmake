# What the lessons are made of, for the native build and for the one in web/.

# The order of the course: ideas, tests, uses, robustness; each lesson after those that it builds on. Lessons not listed
# come last.
set(course relations points intervals rays aabb_aabb sphere_sphere sphere_aabb ray_sphere obb_obb bounding_volumes
  convex_hull capsule_capsule distance hierarchy crossings ray_polygon convex_polygon concave_polygon collision
  moving_bodies triangle_triangle clipping culling ray_tracing picking rules_of_thumb robustness rounding_bound
  ray_triangle speed_against_error)
file(GLOB lessons CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_LIST_DIR} ${CMAKE_CURRENT_LIST_DIR}/*/lesson.cpp)
list(TRANSFORM lessons REPLACE "/lesson.cpp" "")
foreach(subject ${course})
  if(NOT subject IN_LIST lessons)
    message(FATAL_ERROR
      "lessons/sources.cmake: the course names ${subject}, but there is no lessons/${subject}/lesson.cpp")
  endif()
endforeach()
list(PREPEND lessons ${course})
list(REMOVE_DUPLICATES lessons)

# isect_add_lessons(TARGET): all files of the lessons, and those that are generated.
function(isect_add_lessons target)
  set(here ${CMAKE_CURRENT_FUNCTION_LIST_DIR})
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/generated)

  target_sources(${target} PRIVATE ${here}/course.cpp ${here}/glossary.cpp)
  foreach(subject shared ${lessons})
    file(GLOB files CONFIGURE_DEPENDS ${here}/${subject}/*.cpp)
    target_sources(${target} PRIVATE ${files})
  endforeach()

  # all_lessons(), in that order.
  set(declarations "")
  set(references "")
  foreach(subject ${lessons})
    string(APPEND declarations "namespace ${subject}_lesson {\nconst viz::Lesson& lesson();\n}\n")
    string(APPEND references "      &${subject}_lesson::lesson(),\n")
  endforeach()
  configure_file(${here}/lessons.cpp.in ${generated}/lessons.cpp @ONLY)
  target_sources(${target} PRIVATE ${generated}/lessons.cpp)

  # speed_against_error embeds bench/results.json, a string literal a line.
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${here}/../bench/results.json)
  file(READ ${here}/../bench/results.json results)
  string(REGEX REPLACE "([^\n]+)\n" "    R\"json(\\1)json\"\n" ISECT_RESULTS "${results}")
  configure_file(${here}/speed_against_error/results.cpp.in ${generated}/speed_against_error_results.cpp @ONLY)
  target_sources(${target} PRIVATE ${generated}/speed_against_error_results.cpp)
endfunction()
