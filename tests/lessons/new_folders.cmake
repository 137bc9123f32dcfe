# A folder with a lesson.cpp is a lesson: it is listed, last as the course does not name it, and has a program of its
# own. A folder with a suite.cpp is a suite of measurements. A copy of the sources is configured, not built.
#   cmake -D ROOT=... -D SCRATCH=... -D CXX=... -P new_folders.cmake
cmake_minimum_required(VERSION 3.22)

file(REMOVE_RECURSE ${SCRATCH})
file(COPY ${ROOT}/CMakeLists.txt ${ROOT}/package.cmake ${ROOT}/CHANGELOG.md ${ROOT}/bench ${ROOT}/lessons
  DESTINATION ${SCRATCH}/isect)
foreach(folder app core examples viz)
  file(CREATE_LINK ${ROOT}/${folder} ${SCRATCH}/isect/${folder} SYMBOLIC)
endforeach()
file(WRITE ${SCRATCH}/isect/lessons/one_more/lesson.cpp "")
file(WRITE ${SCRATCH}/isect/bench/one_more/suite.cpp "")

execute_process(COMMAND ${CMAKE_COMMAND} -G Ninja -S ${SCRATCH}/isect -B ${SCRATCH}/build -D CMAKE_CXX_COMPILER=${CXX}
  -D BUILD_TESTING=OFF -D ISECT_BENCH=OFF RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE text)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${text}")
endif()

# must_match(what file pattern)
function(must_match what file pattern)
  file(READ ${SCRATCH}/build/${file} list)
  if(NOT list MATCHES "${pattern}")
    message(FATAL_ERROR "the list of ${what} does not end with one_more:\n${list}")
  endif()
endfunction()
must_match(lessons lessons/generated/lessons.cpp
  "namespace one_more_lesson {.*      &one_more_lesson::lesson\\(\\),\n  };")
must_match(suites bench/suite_names.cpp "      \"one-more\",\n  };")
execute_process(COMMAND ${CMAKE_COMMAND} --build ${SCRATCH}/build --target help OUTPUT_VARIABLE targets)
if(NOT targets MATCHES "one-more")
  message(FATAL_ERROR "there is no program one-more")
endif()
file(REMOVE_RECURSE ${SCRATCH})
