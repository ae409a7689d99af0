# Runs the port of release/vcpkg without vcpkg: stand-ins for the functions that it calls do the part of each that is documented.
#
#   cmake -DCURRENT_PORT_DIR=... -DLINKAGE=dynamic|static -DFOLDER=... -DCARGO=... -P tests/package_managers/vcpkg.cmake
#
# FOLDER/installed is then what vcpkg would install. CARGO: the folder in which cargo builds.
cmake_minimum_required(VERSION 3.20)
set(PORT sins)
set(VCPKG_LIBRARY_LINKAGE ${LINKAGE})
set(CURRENT_PACKAGES_DIR ${FOLDER}/installed)
file(REMOVE_RECURSE ${FOLDER})

# The manifest: JSON with the version of the library, and only the helpers whose functions the port calls.
file(READ ${CURRENT_PORT_DIR}/vcpkg.json manifest)
string(JSON name GET "${manifest}" name)
string(JSON version GET "${manifest}" version)
string(JSON licence GET "${manifest}" license)
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/../../Cargo.toml cargo REGEX "^(version|license) = " LIMIT_COUNT 2)
if(NOT "${name}" STREQUAL sins OR NOT "license = \"${licence}\";version = \"${version}\"" STREQUAL "${cargo}")
    message(FATAL_ERROR "vcpkg.json: ${name} ${version}, ${licence}: not ${cargo} of Cargo.toml")
endif()

function(run)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(status)
        message(FATAL_ERROR "${ARGN}\n${output}")
    endif()
endfunction()

function(vcpkg_download_distfile variable)
    cmake_parse_arguments(PARSE_ARGV 1 given "" "URLS;FILENAME;SHA512" "")
    file(DOWNLOAD ${given_URLS} ${FOLDER}/${given_FILENAME} EXPECTED_HASH SHA512=${given_SHA512})
    set(${variable} ${FOLDER}/${given_FILENAME} PARENT_SCOPE)
endfunction()

function(vcpkg_extract_source_archive variable)
    cmake_parse_arguments(PARSE_ARGV 1 given "" "ARCHIVE" "")
    file(ARCHIVE_EXTRACT INPUT ${given_ARCHIVE} DESTINATION ${FOLDER}/source)
    file(GLOB folders ${FOLDER}/source/*)
    set(${variable} ${folders} PARENT_SCOPE)
endfunction()

function(vcpkg_cmake_configure)
    cmake_parse_arguments(PARSE_ARGV 0 given "" "SOURCE_PATH" "OPTIONS")
    run(${CMAKE_COMMAND} -S ${given_SOURCE_PATH} -B ${FOLDER}/build -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_LIBDIR:STRING=lib
        -DCMAKE_INSTALL_BINDIR:STRING=bin -DCMAKE_INSTALL_PREFIX=${CURRENT_PACKAGES_DIR}
        -DCMAKE_ERROR_ON_ABSOLUTE_INSTALL_DESTINATION=ON -DSINS_CARGO_TARGET_DIR=${CARGO} ${given_OPTIONS})
endfunction()

function(vcpkg_cmake_install)
    run(${CMAKE_COMMAND} --build ${FOLDER}/build --target install)
endfunction()

function(vcpkg_cmake_config_fixup)
    cmake_parse_arguments(PARSE_ARGV 0 given "" "CONFIG_PATH" "")
    file(MAKE_DIRECTORY ${CURRENT_PACKAGES_DIR}/share)
    file(GLOB configs ${CURRENT_PACKAGES_DIR}/${given_CONFIG_PATH}/*.cmake)
    foreach(config ${configs})
        file(READ ${config} text)
        string(REGEX REPLACE "(PACKAGE_PREFIX_DIR \"\\\${CMAKE_CURRENT_LIST_DIR})/[./]*\"" "\\1/../..\"" text "${text}")
        get_filename_component(file ${config} NAME)
        file(WRITE ${CURRENT_PACKAGES_DIR}/share/${PORT}/${file} "${text}")
    endforeach()
    file(REMOVE_RECURSE ${CURRENT_PACKAGES_DIR}/lib/cmake)
endfunction()

function(vcpkg_fixup_pkgconfig)
    set(ENV{PKG_CONFIG_PATH} ${CURRENT_PACKAGES_DIR}/lib/pkgconfig)
    run(pkg-config --exists sins)
endfunction()

function(vcpkg_install_copyright)
    cmake_parse_arguments(PARSE_ARGV 0 given "" "" "FILE_LIST")
    foreach(file ${given_FILE_LIST})
        file(READ ${file} text)
        file(APPEND ${CURRENT_PACKAGES_DIR}/share/${PORT}/copyright "${text}")
    endforeach()
endfunction()

include(${CURRENT_PORT_DIR}/portfile.cmake)
