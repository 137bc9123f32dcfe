# Every public header of the core, read by clang with warnings as errors: what GCC 12 lets pass may be no C++20.
#   cmake -D CLANG=... -D EIGEN=... -D ROOT=... -D WORK=... -P headers_by_clang.cmake
cmake_minimum_required(VERSION 3.22)
if(NOT CLANG)
  message("skipped: there is no clang++ (Debian's package clang)")
  return()
endif()
file(GLOB headers RELATIVE ${ROOT}/core
  ${ROOT}/core/isect/*.h ${ROOT}/core/isect/many/*.h ${ROOT}/core/isect/methods/*.h)
list(TRANSFORM headers REPLACE "(.+)" "#include <\\1>\n")
list(JOIN headers "" all)
foreach(shape Segment Ray Plane Sphere Capsule Aabb Obb)  # what a template says is looked at where it is used
  foreach(dimension 2 3)
    string(APPEND all "template struct isect::Described<isect::${shape}<double, ${dimension}>>;\n")
  endforeach()
endforeach()
file(MAKE_DIRECTORY ${WORK})
file(WRITE ${WORK}/all.cpp "${all}")
list(TRANSFORM EIGEN PREPEND -isystem)
execute_process(
  COMMAND ${CLANG} -std=c++20 -fsyntax-only -Wall -Wextra -Wpedantic -Wshadow -Werror
    -Wno-unknown-warning-option -Wno-bitwise-instead-of-logical -I${ROOT}/core ${EIGEN} ${WORK}/all.cpp
  COMMAND_ERROR_IS_FATAL ANY)
