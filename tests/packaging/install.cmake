# Installs isect to a fresh prefix, then configures, builds and runs the consumer in another folder.
#   cmake -D ISECT_BUILD=... -D CONSUMER=... -D SCRATCH=... -D CXX=... -P install.cmake
function(must)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT status EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "${command}\n${text}")
  endif()
  set(text "${text}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
must(${CMAKE_COMMAND} --install ${ISECT_BUILD} --prefix ${SCRATCH}/prefix)
must(${CMAKE_COMMAND} -S ${CONSUMER} -B ${SCRATCH}/build -D CMAKE_PREFIX_PATH=${SCRATCH}/prefix
  -D CMAKE_CXX_COMPILER=${CXX} -D CMAKE_BUILD_TYPE=Release)
must(${CMAKE_COMMAND} --build ${SCRATCH}/build --verbose)
if(NOT text MATCHES "-ffp-contract=off")
  message(FATAL_ERROR "isect::core does not export -ffp-contract=off:\n${text}")
endif()
must(${SCRATCH}/build/consumer)
if(NOT text STREQUAL "hit at 1.5 and 2.5\n")
  message(FATAL_ERROR "the consumer said: ${text}")
endif()
