# Debian packages by `cpack`: libisect-dev, the core, and isect, the program, where it is built. What they need beside
# the files that `cmake --install` puts in place is installed by `cpack` alone, or by `cmake --install --component`.
include(GNUInstallDirs)
set(maintainer "isect developers <isect@users.noreply.github.com>")

# isect_debian_papers(component package) installs copyright and changelog as Debian asks for them.
file(STRINGS CHANGELOG.md released REGEX "^## \\[${PROJECT_VERSION}\\] - ")
string(REGEX REPLACE ".* - " "" released "${released}")
execute_process(COMMAND date -R -u -d ${released} OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE)
function(isect_debian_papers component package)
  set(folder ${PROJECT_BINARY_DIR}/debian/${package})
  file(CONFIGURE OUTPUT ${folder}/changelog @ONLY CONTENT
    "isect (@PROJECT_VERSION@) unstable; urgency=medium\n\n  * Release.\n\n -- @maintainer@  @date@\n")
  execute_process(COMMAND gzip -9nf ${folder}/changelog)
  install(FILES ${folder}/changelog.gz DESTINATION share/doc/${package} COMPONENT ${component} EXCLUDE_FROM_ALL)
  install(FILES LICENSE RENAME copyright DESTINATION share/doc/${package} COMPONENT ${component} EXCLUDE_FROM_ALL)
endfunction()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_PACKAGE_CONTACT ${maintainer})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_COMPONENTS_ALL core)

isect_debian_papers(core libisect-dev)
set(CPACK_DEBIAN_CORE_PACKAGE_NAME libisect-dev)
if(NOT ISECT_COMPILED)
  set(CPACK_DEBIAN_CORE_PACKAGE_ARCHITECTURE all)
endif()
set(CPACK_DEBIAN_CORE_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_CORE_PACKAGE_DEPENDS "libeigen3-dev (>= 3.4)")
set(CPACK_DEBIAN_CORE_DESCRIPTION "exact intersection tests of shapes, header-only
Answers in C++20 whether and where rays, boxes, spheres, polygons, meshes
and other shapes intersect, exactly for the floating-point numbers given.")

if(ISECT_VIZ)
  install(TARGETS isect OPTIONAL COMPONENT program)
  set(manual ${PROJECT_BINARY_DIR}/debian/isect.1)
  configure_file(app/isect.1.in ${manual} @ONLY)
  execute_process(COMMAND gzip -9nf ${manual})
  install(FILES ${manual}.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
  list(APPEND CPACK_COMPONENTS_ALL program)
  isect_debian_papers(program isect)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME isect)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION math)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "fonts-dejavu-core, fonts-stix")
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "libgl1-mesa-dri, libosmesa6")
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS ffmpeg)
  set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "lessons on intersection tests, step by step, exactly right
Shows lessons that step through intersection tests, in a window or as
figures, draws scenes of one's own and answers queries exactly.")
endif()
include(CPack)
