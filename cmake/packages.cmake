# Packages for Debian and for RPM of what is installed, by CPack: docs/packages.md, "Package managers".
#
#   cpack --config target/cpack/CPackConfig.cmake -G DEB -B target/dist
set(run_time libsins${abi})
set(revision 1)
set(contact "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>") # of Debian's own tools, at the time of `cmake -B`
if(contact STREQUAL " <>")
    cmake_host_system_information(RESULT host QUERY FQDN)
    set(contact "sins <sins@${host}>")
endif()

# The documents of the packages; those of Debian have a changelog and a copyright each. `cmake --install` leaves them out.
set(documents ${CMAKE_CURRENT_BINARY_DIR}/documents)
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(READ LICENSE-MIT mit)
configure_file(cmake/changelog.in ${documents}/changelog.Debian @ONLY)
configure_file(CHANGELOG.md ${documents}/changelog COPYONLY)
execute_process(COMMAND gzip -9nf ${documents}/changelog.Debian ${documents}/changelog)
set(licences_target ${SINS_CARGO_TARGET})
if(NOT licences_target)
    execute_process(COMMAND ${SINS_RUSTC} --version --verbose OUTPUT_VARIABLE answer)
    string(REGEX REPLACE ".*host: ([^\n]*).*" "\\1" licences_target "${answer}")
endif()

# sins_documents(NAME COMPONENT CRATE...): the licences of a package, of the project and of the crates that the CRATEs contain.
function(sins_documents name component)
    set(folder ${documents}/${name})
    list(JOIN ARGN " " crates)
    configure_file(cmake/copyright.in ${folder}/copyright @ONLY)
    install(CODE "execute_process(COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/release/licences.py ${licences_target} ${crates}
            WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} OUTPUT_FILE ${folder}/crates.txt RESULT_VARIABLE status)
        if(status)
            message(FATAL_ERROR \"release/licences.py: \${status}\")
        endif()" COMPONENT ${component} EXCLUDE_FROM_ALL)
    install(FILES ${folder}/copyright ${folder}/crates.txt DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name}
        COMPONENT ${component} EXCLUDE_FROM_ALL)
endfunction()

set(folder ${CMAKE_INSTALL_DATADIR}/doc)
sins_documents(${run_time} licences sins)
install(FILES ${documents}/changelog.Debian.gz ${documents}/changelog.gz DESTINATION ${folder}/${run_time}
    COMPONENT run_time_debian EXCLUDE_FROM_ALL)
install(FILES ${documents}/${run_time}/copyright ${documents}/changelog.Debian.gz ${documents}/changelog.gz
    DESTINATION ${folder}/libsins-dev COMPONENT development_debian EXCLUDE_FROM_ALL)
if(SINS_PROGRAM)
    sins_documents(sins program_licences sins sins-cli)
    install(FILES ${documents}/changelog.Debian.gz ${documents}/changelog.gz DESTINATION ${folder}/sins
        COMPONENT program_debian EXCLUDE_FROM_ALL)
endif()

set(about "The library computes what perfect gyros and accelerometers measure on a flight,
adds the errors of the sensors, and navigates on the result as an inertial
navigation system does. It reports the errors of the navigation.")
set(development "This package has the headers for C and C++, the static library, files for
pkg-config and CMake, and the interface for Fortran, Ada and Python.")
set(program "This package has the program sins: it flies scenes and flight logs, draws the errors
and computes budgets and statistics of them. It has the library within it.")
set(summary "strapdown inertial navigation simulator")
set(CPACK_PACKAGE_NAME sins)
set(CPACK_PACKAGE_VENDOR "The sins developers")
set(CPACK_PACKAGE_CONTACT "${contact}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_SOURCE_DIR}/cmake/components.cmake)

file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/triggers "activate-noawait ldconfig\n") # renews the cache of the loader
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE ${revision})
set(CPACK_DEBIAN_RUN_TIME_PACKAGE_NAME ${run_time})
set(CPACK_DEBIAN_RUN_TIME_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_RUN_TIME_DESCRIPTION "${summary}\n${about}")
set(CPACK_DEBIAN_RUN_TIME_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_RUN_TIME_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_BINARY_DIR}/triggers)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libsins-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "${summary} - development files\n${about}\n${development}")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${run_time} (= ${version}-${revision})")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME sins)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "${summary} - program\n${about}\n${program}")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)

set(CPACK_RPM_COMPONENT_INSTALL ON)
set(CPACK_RPM_FILE_NAME RPM-DEFAULT)
set(CPACK_RPM_PACKAGE_LICENSE "MIT OR Apache-2.0")
set(CPACK_RPM_PACKAGE_RELEASE ${revision})
set(CPACK_RPM_PACKAGE_RELOCATABLE OFF)
# With SOURCE_DATE_EPOCH, one commit gives the same bytes.
set(CPACK_RPM_SPEC_MORE_DEFINE "%define _buildhost localhost
%define use_source_date_epoch_as_buildtime 1
%define clamp_mtime_to_source_date_epoch 1
%define _build_id_links none")
foreach(folder cmake pkgconfig) # of the system
    list(APPEND CPACK_RPM_EXCLUDE_FROM_AUTO_FILELIST_ADDITION ${CPACK_PACKAGING_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}/${folder})
endforeach()
foreach(folder man man/man1 bash-completion bash-completion/completions fish fish/vendor_completions.d zsh zsh/site-functions)
    list(APPEND CPACK_RPM_EXCLUDE_FROM_AUTO_FILELIST_ADDITION ${CPACK_PACKAGING_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}/${folder})
endforeach()
set(CPACK_RPM_RUN_TIME_PACKAGE_NAME ${run_time})
set(CPACK_RPM_RUN_TIME_PACKAGE_SUMMARY "${summary}")
set(CPACK_RPM_RUN_TIME_PACKAGE_DESCRIPTION "${about}")
set(CPACK_RPM_DEVELOPMENT_PACKAGE_NAME libsins-devel)
set(CPACK_RPM_DEVELOPMENT_PACKAGE_SUMMARY "${summary}, development files")
set(CPACK_RPM_DEVELOPMENT_PACKAGE_DESCRIPTION "${about}\n${development}")
set(CPACK_RPM_DEVELOPMENT_PACKAGE_REQUIRES "${run_time} = ${version}-${revision}")
set(CPACK_RPM_PROGRAM_PACKAGE_NAME sins)
set(CPACK_RPM_PROGRAM_PACKAGE_SUMMARY "${summary}, program")
set(CPACK_RPM_PROGRAM_PACKAGE_DESCRIPTION "${about}\n${program}")

set(CPACK_SINS_PROGRAM ${SINS_PROGRAM}) # for components.cmake
include(CPack)
cpack_add_component(run_time GROUP run_time)
cpack_add_component(licences GROUP run_time)
cpack_add_component(run_time_debian GROUP run_time)
cpack_add_component(development GROUP development)
cpack_add_component(cmake GROUP development)
cpack_add_component(development_debian GROUP development)
if(SINS_PROGRAM)
    foreach(component program program_zsh program_licences program_debian)
        cpack_add_component(${component} GROUP program)
    endforeach()
endif()
