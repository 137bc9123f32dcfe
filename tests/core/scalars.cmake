# No shape and no question takes a scalar that is neither float nor double:
# it does not compile, and one sentence says why.
#   cmake -D COMPILER=... -D EIGEN=... -D ROOT=... -D WORK=... -P scalars.cmake
cmake_minimum_required(VERSION 3.22)
# Each header, and a question that it answers.
set(headers ray_sphere sphere_sphere aabb_aabb interval_interval point_point point_polygon convex_hull fit)
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
# compiled(SCALAR HEADER QUESTION)   sets `failed`, and `said`: what the compiler says
function(compiled scalar header question)
  file(WRITE ${WORK}/asked.cpp
    "#include <isect/${header}.h>\nusing namespace isect;\nusing S = ${scalar};\n"
    "auto asked() { return ${question}; }\n")
  execute_process(
    COMMAND ${COMPILER} -std=c++20 -ffp-contract=off -fsyntax-only -I${ROOT}/core ${EIGEN} ${WORK}/asked.cpp
    RESULT_VARIABLE failed ERROR_VARIABLE said)
  set(failed ${failed} PARENT_SCOPE)
  set(said "${said}" PARENT_SCOPE)
endfunction()

foreach(header question IN ZIP_LISTS headers questions)
  foreach(scalar float double)
    compiled(${scalar} ${header} "${question}")
    if(failed)
      message(FATAL_ERROR "${scalar} does not compile: ${question}\n${said}")
    endif()
  endforeach()
  foreach(scalar int "long double")
    compiled(${scalar} ${header} "${question}")
    if(NOT failed OR NOT said MATCHES "isect: a scalar is float or double; no error bound is proved for any other")
      message(FATAL_ERROR "${scalar} compiles, or is refused without a reason: ${question}\n${said}")
    endif()
  endforeach()
endforeach()
