# What `cmake --install` lays down: programs, libraries, headers, shaders, levels and the package file that
# find_package(lanthorn) reads.
#   include/lanthorn          public headers, a folder a library (lanthorn_library installs them)
#   share/lanthorn/shaders    shaders, and the headers that they include
#   share/lanthorn/assets     the project's own scenes
#   share/man, share/bash-completion   what the programs print of themselves
#   lib/lanthorn              the image module, which a program loads when an image needs it
# Each file belongs to a component: `development`, `images`, `shaders`, `scenes`, `tools` (the command line), `game`, `game_files`; LanthornPackage.cmake
# makes packages of them.
include(CMakePackageConfigHelpers)

set(lanthorn_cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/lanthorn)
set(shader_dir ${CMAKE_INSTALL_DATADIR}/lanthorn/shaders)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/engine ${PROJECT_SOURCE_DIR}/gi_module DESTINATION ${shader_dir} COMPONENT shaders
    FILES_MATCHING PATTERN "*.glsl" PATTERN "*.vert" PATTERN "*.frag" PATTERN "*.comp" PATTERN "*.geom")
install(SCRIPT ${CMAKE_CURRENT_LIST_DIR}/install_shader_headers.cmake COMPONENT shaders)
install(CODE "install_shader_headers(\"${PROJECT_SOURCE_DIR}\" \"\${CMAKE_INSTALL_PREFIX}/${shader_dir}\")" COMPONENT shaders)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/assets/ DESTINATION ${CMAKE_INSTALL_DATADIR}/lanthorn/assets COMPONENT scenes
    FILES_MATCHING PATTERN "levels" EXCLUDE PATTERN "*.glb" PATTERN "*.gltf" PATTERN "*.png")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/assets/levels DESTINATION ${CMAKE_INSTALL_DATADIR}/lanthorn/assets COMPONENT game_files
    FILES_MATCHING PATTERN "*.glb" PATTERN "*.gltf" PATTERN "*.png")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/assets/languages DESTINATION ${CMAKE_INSTALL_DATADIR}/lanthorn/assets COMPONENT game_files
    FILES_MATCHING PATTERN "*.json")

# What a program prints of itself: its manual page and its completion.
function(lanthorn_install_manual program section component)
    install(SCRIPT ${PROJECT_SOURCE_DIR}/cmake/install_manual.cmake COMPONENT ${component})
    install(CODE "install_manual(\"$<TARGET_FILE:${program}>\" ${program} ${section} \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}\")"
        COMPONENT ${component})
endfunction()
if(LANTHORN_BUILD_TOOLS)
    lanthorn_install_manual(lanthorn 1 tools)
endif()
if(LANTHORN_BUILD_GAME)
    lanthorn_install_manual(lamplighter 6 game_files)
    install(FILES ${PROJECT_SOURCE_DIR}/packaging/lamplighter.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT game_files)
    install(FILES ${PROJECT_SOURCE_DIR}/packaging/org.lanthorn.lamplighter.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo
        COMPONENT game_files)
    foreach(side 48 128 256)
        install(FILES ${PROJECT_SOURCE_DIR}/packaging/icons/lamplighter-${side}.png COMPONENT game_files
            DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/${side}x${side}/apps RENAME lamplighter.png)
    endforeach()
endif()

# An export set a library, so that a component brings in its own libraries only.
get_property(components GLOBAL PROPERTY LANTHORN_COMPONENTS)
set(component_lines "")
foreach(name ${components})
    # The file reads those that begin with its own name: "gi" must not begin "gi-shared".
    install(EXPORT lanthorn-${name} FILE lanthorn-${name}-targets.cmake NAMESPACE lanthorn:: DESTINATION ${lanthorn_cmake_dir} COMPONENT development)
    get_property(lines GLOBAL PROPERTY LANTHORN_COMPONENT_LINES_${name})
    string(APPEND component_lines "${lines}")
endforeach()
# Everything that is installed, and no more than that.
list(TRANSFORM components PREPEND lanthorn_ OUTPUT_VARIABLE installed)
add_custom_target(installed)
add_dependencies(installed ${installed})
foreach(program lanthorn lamplighter lanthorn_image_module)
    if(TARGET ${program})
        add_dependencies(installed ${program})
    endif()
endforeach()
list(JOIN components " " components)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/lanthorn-config.cmake.in ${PROJECT_BINARY_DIR}/lanthorn-config.cmake
    INSTALL_DESTINATION ${lanthorn_cmake_dir} PATH_VARS CMAKE_INSTALL_DATADIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/lanthorn-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/lanthorn-config.cmake ${PROJECT_BINARY_DIR}/lanthorn-config-version.cmake
    ${PROJECT_SOURCE_DIR}/cmake/FindBulletDouble.cmake ${PROJECT_SOURCE_DIR}/cmake/FindOpenSubdiv.cmake
    DESTINATION ${lanthorn_cmake_dir} COMPONENT development)
