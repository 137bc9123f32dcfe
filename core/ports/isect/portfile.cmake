# The core of the isect that this port lies in:
#   vcpkg install isect --overlay-ports=core/ports
get_filename_component(SOURCE_PATH ${CMAKE_CURRENT_LIST_DIR}/../../.. ABSOLUTE)
set(VCPKG_BUILD_TYPE release)  # header-only
vcpkg_cmake_configure(SOURCE_PATH ${SOURCE_PATH} OPTIONS -DISECT_VIZ=OFF -DISECT_BENCH=OFF -DBUILD_TESTING=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH share/cmake/isect)
vcpkg_fixup_pkgconfig()
vcpkg_install_copyright(FILE_LIST ${SOURCE_PATH}/LICENSE)
