# Finds cargo, the Rust target for the C compiler and the system's libraries that Rust's standard library needs.
# Gives: SINS_CARGO, cargo_environment, target_argument, remap_argument, cargo_output, system_libraries.

set(mend "Install it from https://rustup.rs, or set SINS_CARGO to another cargo, and configure again.")
find_program(SINS_CARGO cargo PATHS "$ENV{CARGO_HOME}/bin" "$ENV{HOME}/.cargo/bin" "$ENV{USERPROFILE}/.cargo/bin"
    NO_CMAKE_FIND_ROOT_PATH DOC "Program that builds the library")
if(NOT SINS_CARGO)
    message(FATAL_ERROR "sins is built by Rust ${rust_version} or newer: no cargo was found. ${mend}")
endif()
execute_process(COMMAND ${SINS_CARGO} --version WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
    OUTPUT_VARIABLE answer ERROR_VARIABLE answer)
if(NOT answer MATCHES "^cargo ([0-9.]+)" OR CMAKE_MATCH_1 VERSION_LESS rust_version)
    string(STRIP "${answer}" answer)
    set(found ${SINS_CARGO})
    unset(SINS_CARGO CACHE) # to be looked for again
    message(FATAL_ERROR "sins is built by Rust ${rust_version} or newer: ${found} is \"${answer}\". ${mend}")
endif()
get_filename_component(folder "${SINS_CARGO}" DIRECTORY)
find_program(SINS_RUSTC rustc HINTS "${folder}" NO_CMAKE_FIND_ROOT_PATH DOC "Compiler that belongs to SINS_CARGO")

# Without a target cargo builds for its own machine: right for a C compiler that does so too, unless there are two kinds for it.
if(NOT SINS_CARGO_TARGET AND (CMAKE_CROSSCOMPILING OR WIN32))
    string(TOLOWER "${CMAKE_SYSTEM_PROCESSOR}" processor)
    if(processor MATCHES "^(x86_64|amd64|i.86|x86)$")
        set(processor x86_64)
        if(CMAKE_SIZEOF_VOID_P EQUAL 4)
            set(processor i686)
        endif()
    elseif(processor MATCHES "^(aarch64|arm64)$")
        set(processor aarch64)
    else()
        set(processor)
    endif()
    if(MSVC)
        set(system pc-windows-msvc)
    elseif(WIN32)
        set(system pc-windows-gnu)
    elseif(CMAKE_SYSTEM_NAME STREQUAL Linux)
        set(system unknown-linux-gnu)
    endif()
    if(NOT processor OR NOT system)
        message(FATAL_ERROR "sins: which Rust target is ${CMAKE_SYSTEM_NAME} on ${CMAKE_SYSTEM_PROCESSOR}? "
            "Set SINS_CARGO_TARGET to one of those that \"rustc --print target-list\" prints.")
    endif()
    set(SINS_CARGO_TARGET ${processor}-${system})
endif()

set(cargo_output ${SINS_CARGO_TARGET_DIR}/release)
set(target_argument)
set(cargo_environment)
if(SINS_CARGO_TARGET)
    set(cargo_output ${SINS_CARGO_TARGET_DIR}/${SINS_CARGO_TARGET}/release)
    set(target_argument --target ${SINS_CARGO_TARGET})
    if(CMAKE_CROSSCOMPILING AND NOT MSVC)
        string(TOUPPER "${SINS_CARGO_TARGET}" name)
        string(REPLACE - _ name "${name}")
        set(cargo_environment CARGO_TARGET_${name}_LINKER=${CMAKE_C_COMPILER})
    endif()
endif()

# In the configuration and not in the environment: flags that the user has set stay, and count instead.
include(${CMAKE_CURRENT_LIST_DIR}/remap.cmake)
sins_remap(flags "${CMAKE_CURRENT_SOURCE_DIR}" ${SINS_RUSTC})
list(TRANSFORM flags REPLACE "(.+)" "'\\1'")
list(JOIN flags "," flags)
set(remap_argument --config "build.rustflags=[${flags}]")

# Those that Rust's standard library names; the library itself adds none. C compilers link with libgcc_s and libc unasked, and
# programs linked by -static have no libgcc_s.
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/empty.rs "")
execute_process(COMMAND ${SINS_RUSTC} --crate-type staticlib --print native-static-libs ${target_argument} empty.rs -o empty.a
    WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} RESULT_VARIABLE status ERROR_VARIABLE answer)
if(NOT status EQUAL 0 OR NOT answer MATCHES "native-static-libs: ([^\n]*)")
    message(FATAL_ERROR "sins: no Rust for the target ${SINS_CARGO_TARGET}. rustc says:\n${answer}")
endif()
file(REMOVE ${CMAKE_CURRENT_BINARY_DIR}/empty.a)
string(REGEX REPLACE "[ \r]+" ";" system_libraries "${CMAKE_MATCH_1}")
list(REMOVE_ITEM system_libraries -lgcc_s -lc)
list(TRANSFORM system_libraries REPLACE "^/" "-") # of options of MSVC's linker, which CMake would take for paths
