# Verdicts and values are the same on every machine, bit for bit, and values keep their promises: values_everywhere.cpp
# as the compiler makes it, and in small code without fused products; in a long run (ISECT_LONG=1) also without fused
# products alone, with all that this machine has, with a long double of 64 bits, and, where a cross-compiler and an
# emulator are found, on aarch64.
#
#   cmake -DCOMPILER=c++ "-DOPTIONS=<of isect::core>" -DROOT=<repository> -DWORK=<scratch> -DEIGEN=<include>
#     [-DCROSS=aarch64-linux-gnu-g++ -DEMULATOR=qemu-aarch64] -P values_everywhere.cmake
cmake_minimum_required(VERSION 3.22)
file(MAKE_DIRECTORY ${WORK})

# told(variable compiler emulator flag...): what the program says.
function(told variable compiler emulator)
  string(MAKE_C_IDENTIFIER "${variable}${ARGN}" name)
  execute_process(
    COMMAND ${compiler} -std=c++20 -O1 ${OPTIONS} ${ARGN} -I${ROOT} -I${ROOT}/core -isystem ${EIGEN}
      ${CMAKE_CURRENT_LIST_DIR}/values_everywhere.cpp -o ${WORK}/${name}
    COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${emulator} ${WORK}/${name} OUTPUT_VARIABLE said RESULT_VARIABLE failed)
  message(STATUS "${variable} ${ARGN}\n${said}")
  if(failed)
    message(FATAL_ERROR "${variable}: a promise is broken")
  endif()
  set(${variable} "${said}" PARENT_SCOPE)
endfunction()

told(here ${COMPILER} "")
if(NOT here MATCHES "verdicts [0-9a-f]+\nvalues [0-9a-f]+")
  message(FATAL_ERROR "the program tells no verdicts and values")
endif()

# same(compiler emulator flag...): the program says the same when it is made so; nothing where the flags are unknown.
function(same compiler emulator)
  file(WRITE ${WORK}/empty.cpp "int main() {}\n")
  execute_process(COMMAND ${compiler} ${ARGN} -c ${WORK}/empty.cpp -o ${WORK}/empty.o RESULT_VARIABLE unknown
    ERROR_QUIET)
  if(unknown)
    return()
  endif()
  told(there ${compiler} "${emulator}" ${ARGN})
  if(NOT there STREQUAL here)
    message(FATAL_ERROR "${ARGN}: the core says something else")
  endif()
endfunction()

same(${COMPILER} "" -Os -DISECT_DISPATCH=0)
if(NOT "$ENV{ISECT_LONG}" STREQUAL 1)
  message(STATUS "the other builds and aarch64: in a long run, ISECT_LONG=1")
  return()
endif()
same(${COMPILER} "" -DISECT_DISPATCH=0)
same(${COMPILER} "" -march=native)
same(${COMPILER} "" -mlong-double-64)
if(CROSS AND EMULATOR)
  same(${CROSS} ${EMULATOR} -static)
endif()
