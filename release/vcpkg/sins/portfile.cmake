# An overlay port: it builds the library of the source tree that it lies in, or of the release whose address and hash stand in
# release.cmake, as release/recipes.sh writes it. docs/packages.md, "Package managers"
#
#   vcpkg install sins --overlay-ports=release/vcpkg
if(EXISTS "${CURRENT_PORT_DIR}/release.cmake")
    include("${CURRENT_PORT_DIR}/release.cmake")
    vcpkg_download_distfile(archive URLS "${url}" FILENAME "${name}" SHA512 "${sha512}")
    vcpkg_extract_source_archive(SOURCE_PATH ARCHIVE "${archive}")
else()
    get_filename_component(SOURCE_PATH "${CURRENT_PORT_DIR}/../../.." ABSOLUTE)
endif()

# Rust optimises the library in every build type: one build is for both.
set(VCPKG_BUILD_TYPE release)
set(VCPKG_POLICY_MISMATCHED_NUMBER_OF_BINARIES enabled)
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}")
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/sins)
vcpkg_fixup_pkgconfig()

# An installation has both libraries, a triplet wants one.
if(VCPKG_LIBRARY_LINKAGE STREQUAL static)
    file(GLOB others "${CURRENT_PACKAGES_DIR}/lib/libsins.so*" "${CURRENT_PACKAGES_DIR}/lib/libsins.dll.a"
        "${CURRENT_PACKAGES_DIR}/lib/sins.lib" "${CURRENT_PACKAGES_DIR}/bin")
else()
    file(GLOB others "${CURRENT_PACKAGES_DIR}/lib/libsins.a" "${CURRENT_PACKAGES_DIR}/lib/sins_static.lib")
endif()
file(REMOVE_RECURSE ${others})

file(INSTALL "${CURRENT_PORT_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE-MIT" "${SOURCE_PATH}/LICENSE-APACHE")
