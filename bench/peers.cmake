# The libraries that measure_peers asks the same questions, as far as they are installed.
#   isect_add_peers(target) links those found and defines ISECT_PEERS and ISECT_HAS_<PEER> for each.
find_package(CGAL QUIET)
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(BULLET QUIET IMPORTED_TARGET bullet)
endif()
find_library(FCL_LIBRARY fcl)  # its own CMake file asks for libraries that bounding volumes don't need
find_library(EMBREE_LIBRARY embree3)
find_library(GEOS_LIBRARY geos)
find_library(QHULL_LIBRARY qhull_r)

# Their versions, for the report: "CGAL 5.5.1, Boost 1.74.0"; as far as Debian's packages tell.
set(peers_versions)
foreach(peer CGAL:libcgal-dev Boost:libboost-dev Eigen:libeigen3-dev Bullet:libbullet-dev FCL:libfcl-dev
    Embree:libembree-dev GEOS:libgeos++-dev Qhull:libqhull-dev)
  string(REPLACE ":" ";" peer ${peer})
  list(GET peer 0 name)
  list(GET peer 1 package)
  execute_process(COMMAND dpkg-query -W -f "\${source:Upstream-Version}" ${package} OUTPUT_VARIABLE version ERROR_QUIET)
  if(version)
    string(REGEX REPLACE "[+].*" "" version ${version})
    list(APPEND peers_versions "${name} ${version}")
  endif()
endforeach()
list(JOIN peers_versions ", " peers_versions)

function(isect_add_peers target)
  target_compile_options(${target} PRIVATE -w -Wno-error)  # other people's headers
  # packaged FCL was compiled for 16 bytes; wider instructions would raise it
  target_compile_definitions(${target} PRIVATE ISECT_PEERS ISECT_HAS_BOOST ISECT_HAS_EIGEN EIGEN_MAX_ALIGN_BYTES=16)
  foreach(peer CGAL BULLET FCL EMBREE GEOS QHULL)
    if(peer STREQUAL CGAL AND CGAL_FOUND)
      set(library CGAL::CGAL)
    elseif(peer STREQUAL BULLET AND BULLET_FOUND)
      set(library PkgConfig::BULLET)
    elseif(${peer}_LIBRARY)
      set(library ${${peer}_LIBRARY})
    else()
      continue()
    endif()
    target_link_libraries(${target} PRIVATE ${library})
    target_compile_definitions(${target} PRIVATE ISECT_HAS_${peer})
  endforeach()
endfunction()
