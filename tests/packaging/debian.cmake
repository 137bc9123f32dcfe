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

include(${CMAKE_CURRENT_LIST_DIR}/must.cmake)
set(work ${SCRATCH})

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
