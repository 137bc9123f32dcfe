# No shape and no question takes a scalar that is neither float nor double:
# it does not compile, and one sentence says why.
#   cmake -D COMPILER=... -D EIGEN=... -D ROOT=... -D WORK=... -P scalars.cmake
cmake_minimum_required(VERSION 3.22)
# Headers, and a question to each.
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
# The headers are read once: GCC and Clang find what is compiled of them beside them.
list(TRANSFORM headers REPLACE "(.+)" "#include <isect/\\1.h>" OUTPUT_VARIABLE included)
list(JOIN included "\n" included)
file(WRITE ${WORK}/headers.h "${included}\n")
set(compile ${COMPILER} -std=c++20 -ffp-contract=off -I${ROOT}/core ${EIGEN})
execute_process(COMMAND ${compile} -x c++-header ${WORK}/headers.h -o ${WORK}/headers.h.gch
  COMMAND_ERROR_IS_FATAL ANY)

# compiled("SCALAR;..." QUESTION...)   asks each scalar the questions; sets `failed`, and `said`: what the compiler says
function(compiled scalars)
  file(WRITE ${WORK}/asked.cpp "using namespace isect;\n")
  set(count 0)
  foreach(scalar IN LISTS scalars)
    foreach(question IN LISTS ARGN)
      math(EXPR count "${count} + 1")
      file(APPEND ${WORK}/asked.cpp
        "namespace asked_${count} {\nusing S = ${scalar};\nauto asked() { return ${question}; }\n}\n")
    endforeach()
  endforeach()
  execute_process(COMMAND ${compile} -fsyntax-only -include ${WORK}/headers.h ${WORK}/asked.cpp
    RESULT_VARIABLE failed ERROR_VARIABLE said)
  set(failed ${failed} PARENT_SCOPE)
  set(said "${said}" PARENT_SCOPE)
endfunction()

compiled("float;double" ${questions})
if(failed)
  message(FATAL_ERROR "float or double does not compile:\n${said}")
endif()
foreach(question IN LISTS questions)
  foreach(scalar int "long double")
    compiled(${scalar} "${question}")
    if(NOT failed OR NOT said MATCHES "isect: a scalar is float or double; no error bound is proved for any other")
      message(FATAL_ERROR "${scalar} compiles, or is refused without a reason: ${question}\n${said}")
    endif()
  endforeach()
endforeach()
