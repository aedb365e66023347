# OpenImageIO::OpenImageIO through pkg-config. Debian's own OpenImageIO config file cannot be used without the
# OpenImageIO tools, OpenCV's headers and Qt: it checks for programs that other packages hold.
include(FindPackageHandleStandardArgs)
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
    pkg_check_modules(OpenImageIO_PC QUIET OpenImageIO)
endif()
find_path(OpenImageIO_INCLUDE_DIR OpenImageIO/imageio.h HINTS ${OpenImageIO_PC_INCLUDE_DIRS})
find_library(OpenImageIO_LIBRARY OpenImageIO HINTS ${OpenImageIO_PC_LIBRARY_DIRS})
find_library(OpenImageIO_UTIL_LIBRARY OpenImageIO_Util HINTS ${OpenImageIO_PC_LIBRARY_DIRS})
find_path(OpenImageIO_IMATH_DIR ImathVec.h PATH_SUFFIXES Imath)
find_package_handle_standard_args(OpenImageIO
    REQUIRED_VARS OpenImageIO_LIBRARY OpenImageIO_UTIL_LIBRARY OpenImageIO_INCLUDE_DIR OpenImageIO_IMATH_DIR
    VERSION_VAR OpenImageIO_PC_VERSION)
mark_as_advanced(OpenImageIO_INCLUDE_DIR OpenImageIO_LIBRARY OpenImageIO_UTIL_LIBRARY OpenImageIO_IMATH_DIR)

if(OpenImageIO_FOUND AND NOT TARGET OpenImageIO::OpenImageIO)
    add_library(OpenImageIO::OpenImageIO UNKNOWN IMPORTED)
    set_target_properties(OpenImageIO::OpenImageIO PROPERTIES
        IMPORTED_LOCATION "${OpenImageIO_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${OpenImageIO_INCLUDE_DIR};${OpenImageIO_IMATH_DIR}"
        INTERFACE_LINK_LIBRARIES "${OpenImageIO_UTIL_LIBRARY}")
endif()
