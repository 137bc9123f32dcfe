# The core's Debian package is made, and lintian has nothing to say of it.
#   cmake -D ROOT=... -D SCRATCH=... -P debian.cmake
cmake_minimum_required(VERSION 3.22)
foreach(tool dpkg-deb lintian)
  find_program(FOUND_${tool} ${tool})
  if(NOT FOUND_${tool})
    message("skipped: there is no ${tool}")
    return()
  endif()
endforeach()

# must(WORDS...)   runs a command; sets `said`
function(must)
  execute_process(COMMAND ${ARGV} WORKING_DIRECTORY ${SCRATCH}
    RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT status EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "${command}\n${text}")
  endif()
  set(said "${text}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
file(MAKE_DIRECTORY ${SCRATCH})
must(${CMAKE_COMMAND} -G Ninja -S ${ROOT} -B ${SCRATCH} -D ISECT_VIZ=OFF -D ISECT_BENCH=OFF -D BUILD_TESTING=OFF)
must(${CMAKE_CPACK_COMMAND})
file(GLOB packages ${SCRATCH}/*.deb)
must(dpkg-deb --contents ${packages})
foreach(file include/isect/ray_sphere.h share/cmake/isect/isect-config.cmake share/pkgconfig/isect.pc
    share/doc/libisect-dev/copyright)
  if(NOT said MATCHES " ./usr/${file}\n")
    message(FATAL_ERROR "${packages} has no ${file}:\n${said}")
  endif()
endforeach()
must(lintian --pedantic --fail-on error,warning,info,pedantic ${packages})
file(REMOVE_RECURSE ${SCRATCH})
