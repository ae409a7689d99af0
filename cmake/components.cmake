# Read by cpack: the components of the packages of each kind.
set(CPACK_COMPONENTS_ALL run_time licences development cmake)
if(CPACK_GENERATOR STREQUAL DEB)
    list(APPEND CPACK_COMPONENTS_ALL run_time_debian development_debian)
endif()
