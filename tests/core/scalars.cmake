# No shape and no question takes a scalar that is neither float nor double:
# it does not compile, and one sentence says why.
#   cmake -D COMPILER=... -D EIGEN=... -D ROOT=... -D WORK=... -P scalars.cmake
cmake_minimum_required(VERSION 3.22)
set(questions
  "intersect(Ray<S, 3>{{S(0), S(0), S(-5)}, {S(0), S(0), S(1)}}, Sphere<S, 3>{{S(0), S(0), S(0)}, S(2)})"
  "intersects(Sphere<S, 3>{Point<S, 3>::Zero(), S(1)}, Sphere<S, 3>{Point<S, 3>::Ones(), S(1)})"
  "relate(Aabb<S, 2>{Point<S, 2>::Zero(), Point<S, 2>::Ones()}, Aabb<S, 2>{Point<S, 2>::Zero(), Point<S, 2>::Ones()})"
  "relate(Interval<S>{S(0), S(1)}, Interval<S>{S(0), S(1)})"
  "equal(Point<S, 2>::Zero().eval(), Point<S, 2>::Ones().eval())"
  "locate(Point<S, 2>::Zero().eval(), Ring<S, 2>{Point<S, 2>::Zero(), Point<S, 2>::Ones()})"
  "convex_hull(Ring<S, 2>{Point<S, 2>::Zero(), Point<S, 2>::Ones()})"
  "fit_aabb(std::vector<Point<S, 3>>{Point<S, 3>::Zero()})")
list(TRANSFORM EIGEN PREPEND -isystem)
file(MAKE_DIRECTORY ${WORK})
set(includes "")
foreach(header aabb_aabb convex_hull fit interval_interval point_point point_polygon ray_sphere sphere_sphere)
  string(APPEND includes "#include <isect/${header}.h>\n")
endforeach()
# compiled(SCALAR QUESTION...)   sets `failed`, and `said`: what the compiler says
function(compiled scalar)
  set(text "${includes}using namespace isect;\nusing S = ${scalar};\n")
  set(number 0)
  foreach(question IN LISTS ARGN)
    string(APPEND text "auto asked_${number}() { return ${question}; }\n")
    math(EXPR number "${number} + 1")
  endforeach()
  file(WRITE ${WORK}/asked.cpp "${text}")
  execute_process(
    COMMAND ${COMPILER} -std=c++20 -ffp-contract=off -fsyntax-only -I${ROOT}/core ${EIGEN} ${WORK}/asked.cpp
    RESULT_VARIABLE failed ERROR_VARIABLE said)
  set(failed ${failed} PARENT_SCOPE)
  set(said "${said}" PARENT_SCOPE)
endfunction()

foreach(scalar float double)
  compiled(${scalar} ${questions})
  if(failed)
    message(FATAL_ERROR "${scalar} does not compile:\n${said}")
  endif()
endforeach()
foreach(scalar int "long double")
  foreach(question IN LISTS questions)
    compiled(${scalar} ${question})
    if(NOT failed OR NOT said MATCHES "isect: a scalar is float or double; no error bound is proved for any other")
      message(FATAL_ERROR "${scalar} compiles, or is refused without a reason: ${question}\n${said}")
    endif()
  endforeach()
endforeach()
