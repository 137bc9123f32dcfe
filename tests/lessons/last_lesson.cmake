# A lesson whose line is added at the very end of lessons/CMakeLists.txt is a lesson: the program lists it last, and it has
# a program of its own. A copy of the sources is configured, not built.
#   cmake -D ROOT=... -D SCRATCH=... -D CXX=... -P last_lesson.cmake
cmake_minimum_required(VERSION 3.22)

file(REMOVE_RECURSE ${SCRATCH})
file(COPY ${ROOT}/CMakeLists.txt ${ROOT}/lessons DESTINATION ${SCRATCH}/isect)
foreach(folder core viz bench)
  file(CREATE_LINK ${ROOT}/${folder} ${SCRATCH}/isect/${folder} SYMBOLIC)
endforeach()
file(WRITE ${SCRATCH}/isect/lessons/one-more.cpp "")
file(APPEND ${SCRATCH}/isect/lessons/CMakeLists.txt "isect_lesson(one-more)\n")

execute_process(COMMAND ${CMAKE_COMMAND} -S ${SCRATCH}/isect -B ${SCRATCH}/build -D CMAKE_CXX_COMPILER=${CXX}
  -D BUILD_TESTING=OFF -D ISECT_BENCH=OFF RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE text)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${text}")
endif()

file(READ ${SCRATCH}/build/lessons/generated/lessons.cpp list)
if(NOT list MATCHES "const viz::Lesson& one_more\\(\\);" OR NOT list MATCHES "      &one_more\\(\\),\n  };")
  message(FATAL_ERROR "the list of lessons does not end with one-more:\n${list}")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} --build ${SCRATCH}/build --target help OUTPUT_VARIABLE targets)
if(NOT targets MATCHES "one-more")
  message(FATAL_ERROR "there is no program one-more")
endif()
file(REMOVE_RECURSE ${SCRATCH})
