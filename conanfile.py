"""The core as a package of Conan 2:

    conan create . -s compiler.cppstd=20
"""

import os

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, rmdir


class Isect(ConanFile):
    name = "isect"
    version = "1.0.0"
    description = "Exact intersection tests of shapes, header-only"
    license = "MIT"
    package_type = "header-library"
    settings = "os", "arch", "compiler", "build_type"
    exports_sources = "CMakeLists.txt", "package.cmake", "CHANGELOG.md", "LICENSE", "bench/CMakeLists.txt", "core/*"

    def requirements(self):
        self.requires("eigen/[>=3.4 <4]", transitive_headers=True)

    def validate(self):
        check_min_cppstd(self, 20)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        for part in "ISECT_VIZ", "ISECT_BENCH", "BUILD_TESTING":
            toolchain.cache_variables[part] = False
        toolchain.generate()

    def package(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.install()
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        for folder in "share", "res":  # Conan writes files for CMake and pkg-config of its own
            rmdir(self, os.path.join(self.package_folder, folder))

    def package_id(self):
        self.info.clear()

    def package_info(self):
        self.cpp_info.set_property("cmake_target_name", "isect::core")
        self.cpp_info.bindirs = []
        self.cpp_info.libdirs = []
        self.cpp_info.cxxflags = ["-ffp-contract=off"]
        if self.settings.compiler == "gcc":
            self.cpp_info.cxxflags.append("-fno-tree-slp-vectorize")
