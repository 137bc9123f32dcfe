# Verdicts are the same on every machine, and values keep their promises: values_everywhere.cpp as the compiler makes it,
# with a long double of 64 bits, and, where a cross-compiler and an emulator are found, on aarch64. Without fused
# multiply-adds the values are the same bit for bit.
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
string(REGEX MATCH "verdicts [0-9a-f]+" verdicts "${here}")
if(verdicts STREQUAL "")
  message(FATAL_ERROR "the program tells no verdicts")
endif()

set(short "int main() { static_assert(sizeof(long double) == 8); }\n")
file(WRITE ${WORK}/short.cpp "${short}")
execute_process(COMMAND ${COMPILER} -mlong-double-64 -c ${WORK}/short.cpp -o ${WORK}/short.o RESULT_VARIABLE unknown ERROR_QUIET)
if(NOT unknown)
  told(short_long_double ${COMPILER} "" -mlong-double-64)
  if(NOT short_long_double STREQUAL here)
    message(FATAL_ERROR "a short long double changes what the core says")
  endif()
endif()

if(CROSS AND EMULATOR)
  told(elsewhere ${CROSS} ${EMULATOR} -static)
  if(NOT elsewhere MATCHES "${verdicts}")
    message(FATAL_ERROR "the verdicts on aarch64 are others")
  endif()
endif()
