# The trace costs nothing when nobody listens: the untraced calls compile to the machine code of a copy of the core with
# every trace line deleted. The code is the same byte for byte, or the same instructions in another order with other
# registers: deleting a line renumbers what the compiler sees, and its scheduler breaks ties by number. Then padding,
# moves from register to register and addresses taken again instead of kept don't count; every calculation, load, store,
# jump and call does. Some compilers (GCC 13, 14) also turn a jump round, or take an operand from memory instead of a
# register that holds it: then there are as many calculations, comparisons, jumps and calls of each kind, whatever moves
# bring their operands, and no more instructions than without the lines, and that is told.
# The comparison can fail: a listener must change the code.
#
# An ordinary run leaves out the groups that take longest. It compiles the others as a release does, at -O3, the
# listener's with one group of calls, and what doubles leave open in small code but for two groups; a long one
# (ISECT_LONG=1) all in full, at -O2 too, and every group's listener.
#
#   cmake -DCALLS=RELATE -DCOMPILER=c++ "-DOPTIONS=<of isect::core>" -DOBJDUMP=objdump -DROOT=<repository>
#     -DWORK=<scratch> -DEIGEN=<include> -P zero_cost_trace.cmake
cmake_minimum_required(VERSION 3.22)

set(longest RAYS OUTLINES LINES STRAIGHTS SOLIDS ROUND ROUND_SOLIDS PIECES POLYGONS)
if(CALLS IN_LIST longest AND NOT "$ENV{ISECT_LONG}" STREQUAL 1)
  message("skipped: these calls take the longest to compile, and are for a long run (ISECT_LONG=1)")
  return()
endif()

# Copies the core to WORK/traced as it is and to WORK/untraced without its trace lines,
# both with big numbers out of line.
file(REMOVE_RECURSE ${WORK})
file(GLOB_RECURSE headers RELATIVE ${ROOT}/core ${ROOT}/core/isect/*.h)
set(deleted 0)
foreach(header IN LISTS headers)
  file(READ ${ROOT}/core/${header} text)
  string(REGEX MATCHALL "\n *(if constexpr \\([^\n]*\\)[ \n]+)?trace\\(" starts "${text}")
  list(LENGTH starts count)
  math(EXPR deleted "${deleted} + ${count}")
  string(REGEX REPLACE "\n *(if constexpr \\([^\n]*\\)[ \n]+)?trace\\([^;]*\\);" "" text "${text}")
  if(text MATCHES "[^a-z_]trace\\(")
    message(FATAL_ERROR "core/${header}: a trace call is no line of its own, so it can't be deleted")
  endif()
  file(WRITE ${WORK}/untraced/${header} "${text}")
  configure_file(${ROOT}/core/${header} ${WORK}/traced/${header} COPYONLY)
endforeach()
foreach(copy traced untraced)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/exact_out_of_line.h ${WORK}/${copy}/isect/numbers/exact.h COPYONLY)
endforeach()
if(deleted EQUAL 0)
  message(FATAL_ERROR "no trace lines found under ${ROOT}/core")
endif()
message(STATUS "deleted ${deleted} trace lines")

# disassemble(variable include flag...): the machine code of the calls against the core in `include`.
function(disassemble variable include)
  string(MAKE_C_IDENTIFIER "${variable}${ARGN}" name)
  execute_process(
    COMMAND ${COMPILER} -std=c++20 ${OPTIONS} ${ARGN} -I${include} -isystem ${EIGEN}
      -c ${CMAKE_CURRENT_LIST_DIR}/zero_cost_trace.cpp -o ${WORK}/${name}.o
    COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${OBJDUMP} -dr --no-show-raw-insn ${WORK}/${name}.o
    OUTPUT_VARIABLE code COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX REPLACE "^[^\n]*\n*[^\n]*file format[^\n]*\n" "" code "${code}")  # the file's name
  set(${variable} "${code}" PARENT_SCOPE)
endfunction()

# operations(variable code): its instructions without addresses, register names, padding and register moves, sorted.
function(operations variable code)
  string(REPLACE ";" "," code "${code}")
  string(REGEX REPLACE "\n[ \t]+[0-9a-f]+:[ \t]" "\n" code "${code}")             # where it stands
  string(REGEX REPLACE "[0-9a-f]+ <[^>\n]*>" "" code "${code}")                   # where it jumps
  string(REGEX REPLACE "%[a-z]+[0-9]*[dwb]?" "%" code "${code}")                  # its registers
  string(REGEX REPLACE "-?0x[0-9a-f]+" "" code "${code}")                         # its offsets
  string(REGEX REPLACE "[ \t]+" " " code "${code}")
  string(REGEX REPLACE "\n(data16 |cs )*(nop|xchg)[^\n]*" "" code "${code}")      # padding
  string(REGEX REPLACE "\nmov[a-z]* %,%" "" code "${code}")                       # register moves
  string(REGEX REPLACE "\nlea \\(%\\),%" "" code "${code}")                       # and addresses found again
  string(REGEX REPLACE "\n+" ";" code "${code}")
  list(SORT code)
  set(${variable} "${code}" PARENT_SCOPE)
endfunction()

# kinds(variable operations...): without moves and the places of operands,
# a jump on a condition like one on its opposite.
function(kinds variable)
  string(REGEX REPLACE " *#? *;" " ;" code ";${ARGN};")  # "#": of an operand at an address that is told
  string(REGEX REPLACE "%|\\(%[^)]*\\)" "_" code "${code}")
  foreach(pair "jae|jb" "je|jne" "ja|jbe" "jp|jnp" "jg|jle" "jl|jge" "js|jns")
    string(REGEX REPLACE ";(${pair}) " ";${pair} " code "${code}")
  endforeach()
  list(FILTER code EXCLUDE REGEX "^mov")
  list(SORT code)
  set(${variable} "${code}" PARENT_SCOPE)
endfunction()

set(levels -O3)
if(CALLS STREQUAL RAYS)
  set(levels -O2)  # at -O3 GCC schedules ray_plane::parameter, which has no trace line, in two ways
elseif("$ENV{ISECT_LONG}" STREQUAL 1)
  set(levels -O2 -O3)
endif()
if(NOT CALLS MATCHES "^(INTERSECT|METHODS)$" AND NOT "$ENV{ISECT_LONG}" STREQUAL 1)
  list(APPEND OPTIONS -DISECT_SMALL_CODE)
endif()
foreach(level ${levels})
  disassemble(traced ${WORK}/traced ${level} -D${CALLS})
  disassemble(untraced ${WORK}/untraced ${level} -D${CALLS})
  operations(traced_operations "${traced}")
  operations(untraced_operations "${untraced}")
  list(LENGTH traced_operations count)
  list(LENGTH untraced_operations untraced_count)
  if(count LESS 300)
    message(FATAL_ERROR "${CALLS} ${level}: only ${count} operations: there is nothing to compare")
  endif()

  if(traced STREQUAL untraced)
    message(STATUS "${CALLS} ${level}: ${count} operations, the same code byte for byte")
  elseif(traced_operations STREQUAL untraced_operations)
    message(STATUS "${CALLS} ${level}: ${count} operations, the same in another order")
  else()
    kinds(traced_kinds ${traced_operations})
    kinds(untraced_kinds ${untraced_operations})
    if(traced_kinds STREQUAL untraced_kinds AND count LESS_EQUAL untraced_count)
      message(STATUS "${CALLS} ${level}: ${count} operations, as many calculations, jumps and calls of each kind")
      continue()
    endif()
    foreach(code traced untraced)
      string(REPLACE ";" "\n" text "${${code}_operations}")
      file(WRITE ${WORK}/${code}.s "${text}\n")
    endforeach()
    execute_process(COMMAND diff -U0 ${WORK}/untraced.s ${WORK}/traced.s OUTPUT_VARIABLE difference)
    string(SUBSTRING "${difference}" 0 4000 difference)
    message(FATAL_ERROR "${CALLS} ${level}: the trace lines change the operations\n${difference}")
  endif()
endforeach()

if(NOT CALLS STREQUAL METHODS AND NOT "$ENV{ISECT_LONG}" STREQUAL 1)
  return()
endif()
list(GET levels -1 level)  # that of traced_operations
disassemble(heard ${WORK}/traced ${level} -D${CALLS} -DLISTEN)
operations(heard_operations "${heard}")
if(heard_operations STREQUAL traced_operations)
  message(FATAL_ERROR "${CALLS}: a listener changes nothing, so this test proves nothing")
endif()
