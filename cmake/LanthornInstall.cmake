# What `cmake --install` lays down: programs, libraries, headers, shaders, levels and the package file that
# find_package(lanthorn) reads.
#   include/lanthorn          public headers, a folder a library (lanthorn_library installs them)
#   share/lanthorn/shaders    shaders, and the headers that they include
#   share/lanthorn/assets     the project's own scenes
include(CMakePackageConfigHelpers)

set(lanthorn_cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/lanthorn)
set(shader_dir ${CMAKE_INSTALL_DATADIR}/lanthorn/shaders)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/engine ${PROJECT_SOURCE_DIR}/gi_module DESTINATION ${shader_dir} COMPONENT shaders
    FILES_MATCHING PATTERN "*.glsl" PATTERN "*.vert" PATTERN "*.frag" PATTERN "*.comp" PATTERN "*.geom")
install(SCRIPT ${CMAKE_CURRENT_LIST_DIR}/install_shader_headers.cmake COMPONENT shaders)
install(CODE "install_shader_headers(\"${PROJECT_SOURCE_DIR}\" \"\${CMAKE_INSTALL_PREFIX}/${shader_dir}\")" COMPONENT shaders)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/assets/ DESTINATION ${CMAKE_INSTALL_DATADIR}/lanthorn/assets
    FILES_MATCHING PATTERN "*.glb" PATTERN "*.gltf" PATTERN "*.png")

# An export set a library, so that a component brings in its own libraries only.
get_property(components GLOBAL PROPERTY LANTHORN_COMPONENTS)
set(component_lines "")
foreach(name ${components})
    install(EXPORT lanthorn-${name} NAMESPACE lanthorn:: DESTINATION ${lanthorn_cmake_dir})
    get_property(lines GLOBAL PROPERTY LANTHORN_COMPONENT_LINES_${name})
    string(APPEND component_lines "${lines}")
endforeach()
list(JOIN components " " components)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/lanthorn-config.cmake.in ${PROJECT_BINARY_DIR}/lanthorn-config.cmake
    INSTALL_DESTINATION ${lanthorn_cmake_dir} PATH_VARS CMAKE_INSTALL_DATADIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/lanthorn-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/lanthorn-config.cmake ${PROJECT_BINARY_DIR}/lanthorn-config-version.cmake
    ${PROJECT_SOURCE_DIR}/cmake/FindBulletDouble.cmake ${PROJECT_SOURCE_DIR}/cmake/FindOpenImageIO.cmake ${PROJECT_SOURCE_DIR}/cmake/FindOpenSubdiv.cmake
    DESTINATION ${lanthorn_cmake_dir})
