# OpenSubdiv's CPU library, shared. Debian's own package file names static libraries that the package lacks and
# therefore fails.
find_path(OpenSubdiv_INCLUDE_DIR opensubdiv/far/topologyRefiner.h)
find_library(OpenSubdiv_LIBRARY osdCPU)
if(OpenSubdiv_INCLUDE_DIR AND EXISTS ${OpenSubdiv_INCLUDE_DIR}/opensubdiv/version.h)
    file(STRINGS ${OpenSubdiv_INCLUDE_DIR}/opensubdiv/version.h OpenSubdiv_VERSION_LINE REGEX "OPENSUBDIV_VERSION v[0-9_]+")
    string(REGEX REPLACE ".*v([0-9]+)_([0-9]+)_([0-9]+).*" "\\1.\\2.\\3" OpenSubdiv_VERSION "${OpenSubdiv_VERSION_LINE}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenSubdiv REQUIRED_VARS OpenSubdiv_LIBRARY OpenSubdiv_INCLUDE_DIR
    VERSION_VAR OpenSubdiv_VERSION)
mark_as_advanced(OpenSubdiv_INCLUDE_DIR OpenSubdiv_LIBRARY)

if(OpenSubdiv_FOUND AND NOT TARGET OpenSubdiv::osdCPU)
    add_library(OpenSubdiv::osdCPU SHARED IMPORTED GLOBAL)
    set_target_properties(OpenSubdiv::osdCPU PROPERTIES
        IMPORTED_LOCATION ${OpenSubdiv_LIBRARY}
        INTERFACE_INCLUDE_DIRECTORIES ${OpenSubdiv_INCLUDE_DIR})
endif()
