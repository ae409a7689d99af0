# The flags with which the libraries name no folder of the machine that builds them: those of the places of panics. Included by CMake;
# release/build.sh runs it as a script, which prints one flag a line.
#
#   cmake -DSOURCE=FOLDER "-DRUSTC=rustc;+TOOLCHAIN" -P cmake/remap.cmake

# sins_remap(VARIABLE SOURCE RUSTC...): the flags, of the sources in a folder and of a compiler.
function(sins_remap variable source)
    execute_process(COMMAND ${ARGN} --print sysroot OUTPUT_VARIABLE sysroot OUTPUT_STRIP_TRAILING_WHITESPACE)
    set(cargo "$ENV{CARGO_HOME}")
    if(NOT cargo AND WIN32)
        set(cargo "$ENV{USERPROFILE}/.cargo")
    elseif(NOT cargo)
        set(cargo "$ENV{HOME}/.cargo")
    endif()
    set(flags)
    foreach(pair "${source}|/sins" "${cargo}|/cargo" "${sysroot}/lib/rustlib/src/rust|/rust")
        string(REPLACE "|" ";" pair "${pair}")
        list(POP_FRONT pair folder name)
        if(CMAKE_HOST_WIN32) # file(TO_NATIVE_PATH) would put a backslash before each blank elsewhere
            string(REPLACE "/" "\\" folder "${folder}")
        endif()
        list(APPEND flags "--remap-path-prefix=${folder}=${name}")
    endforeach()
    set(${variable} "${flags}" PARENT_SCOPE)
endfunction()

if(CMAKE_SCRIPT_MODE_FILE)
    sins_remap(flags "${SOURCE}" ${RUSTC})
    list(JOIN flags "\n" flags)
    execute_process(COMMAND ${CMAKE_COMMAND} -E echo "${flags}") # message() would print to the other stream
endif()
