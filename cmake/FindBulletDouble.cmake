# BulletDouble::Dynamics: rigid bodies and collision of Bullet Physics in double precision. Bullet's own
# BulletConfig-float64.cmake sets variables and no target, and cannot be found by find_package under that name.
include(FindPackageHandleStandardArgs)
find_path(BulletDouble_INCLUDE_DIR btBulletDynamicsCommon.h PATH_SUFFIXES bullet)
set(bullet_libraries "")
foreach(part BulletDynamics BulletCollision LinearMath)
    find_library(BulletDouble_${part}_LIBRARY ${part}-float64)
    list(APPEND bullet_libraries BulletDouble_${part}_LIBRARY)
    mark_as_advanced(BulletDouble_${part}_LIBRARY)
endforeach()
find_package_handle_standard_args(BulletDouble REQUIRED_VARS ${bullet_libraries} BulletDouble_INCLUDE_DIR)
mark_as_advanced(BulletDouble_INCLUDE_DIR)

if(BulletDouble_FOUND AND NOT TARGET BulletDouble::Dynamics)
    add_library(BulletDouble::Dynamics UNKNOWN IMPORTED)
    set_target_properties(BulletDouble::Dynamics PROPERTIES
        IMPORTED_LOCATION "${BulletDouble_BulletDynamics_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${BulletDouble_INCLUDE_DIR}"
        INTERFACE_COMPILE_DEFINITIONS BT_USE_DOUBLE_PRECISION
        INTERFACE_LINK_LIBRARIES "${BulletDouble_BulletCollision_LIBRARY};${BulletDouble_LinearMath_LIBRARY}")
endif()
