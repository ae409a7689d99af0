"""Conan 2: builds the library of this source tree by its CMake project.

conan create release/conan                              the shared library
conan create release/conan -o "sins/*:shared=False"     the static one

With conandata.yml beside it, as release/recipes.sh writes it, the sources are those of a release, which are downloaded. The build needs Rust and the network, for the crates. docs/packages.md, "Package managers"
"""

import os
import re

from conan import ConanFile
from conan.errors import ConanInvalidConfiguration
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy, get, load, rm, rmdir, save


class Sins(ConanFile):
    name = "sins"
    license = "MIT OR Apache-2.0"
    description = "Strapdown inertial navigation system (SINS) simulator behind a C ABI"
    topics = ("inertial", "navigation", "ins", "imu", "simulator")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False]}
    default_options = {"shared": True}

    @property
    def _tree(self):
        return os.path.join(self.recipe_folder, "..", "..")

    def _path(self, *parts):
        return os.path.join(self.package_folder, *parts)

    @property
    def _release(self):
        """Version: address and hash of its sources; empty in a source tree."""
        return (self.conan_data or {}).get("sources", {})

    def set_version(self):
        if self._release:
            (self.version,) = self._release
            return
        manifest = load(self, os.path.join(self._tree, "Cargo.toml"))
        self.version = re.search(r'^version = "(.*)"', manifest, re.MULTILINE).group(1)

    def source(self):
        if self._release:
            get(self, **self._release[self.version], strip_root=True)

    def export_sources(self):
        if self._release:
            return
        # The program, the unit and the tests are members of the workspace: Cargo reads them, but does not build them.
        for part in (
            "Cargo.*", "CMakeLists.txt", "LICENSE-*", "CHANGELOG.md", "build.rs",
            "bindings/*", "build/*", "apps/cli/*", "cmake/*", "apps/fmu/*", "include/*", "src/*", "tests/*Cargo.toml", "release/licences.py",
        ):
            copy(self, part, self._tree, self.export_sources_folder)

    def validate(self):
        if self.settings.os not in ("Linux", "Windows"):
            raise ConanInvalidConfiguration(f"sins {self.version} is built for Linux and Windows, not for {self.settings.os}")

    def layout(self):
        cmake_layout(self)

    def generate(self):
        CMakeToolchain(self).generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        # The libraries of the system that a static sins needs stand in sins.pc.
        needed = re.search(r"^Libs.private:(.*)", load(self, self._path("lib", "pkgconfig", "sins.pc")), re.MULTILINE).group(1)
        save(self, self._path("lib", "system_libraries"), needed.replace("-l", ""))
        copy(self, "LICENSE-*", self.source_folder, self._path("licenses"))
        rmdir(self, self._path("lib", "cmake"))  # CMakeDeps writes these
        rmdir(self, self._path("lib", "pkgconfig"))
        if self.options.shared:
            rm(self, "libsins.a", self._path("lib"))
            rm(self, "sins_static.lib", self._path("lib"))
        else:
            for pattern in ("libsins.so*", "libsins.dll.a", "sins.lib"):
                rm(self, pattern, self._path("lib"))
            rmdir(self, self._path("bin"))

    def package_id(self):
        # Rust compiles the library, optimised in every build type. On Windows the files are named after the compiler's habit.
        if self.info.settings.os == "Linux":
            del self.info.settings.compiler
        del self.info.settings.build_type

    def package_info(self):
        is_msvc = str(self.settings.compiler) == "msvc"
        self.cpp_info.libs = ["sins_static" if is_msvc and not self.options.shared else "sins"]
        self.cpp_info.set_property("cmake_target_name", "sins::sins")
        # As for Cargo: 0.2 does not replace 0.1, and 1.2 replaces 1.1.
        is_first = self.version.startswith("0.")
        self.cpp_info.set_property("cmake_config_version_compat", "SameMinorVersion" if is_first else "SameMajorVersion")
        if not self.options.shared:
            self.cpp_info.defines = ["SINS_STATIC"]
            self.cpp_info.set_property("cmake_target_aliases", ["sins::static"])
            self.cpp_info.system_libs = load(self, self._path("lib", "system_libraries")).split()
