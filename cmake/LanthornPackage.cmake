# Debian packages of what is installed; tools/package makes them (docs/packaging.md).
#   lanthorn       the command line
#   lamplighter    the game and its levels
#   lanthorn-images  the module that reads images by OpenImageIO; nobody needs it to start
#   lanthorn-data  shaders and scenes, for both and for programs that are built with lanthorn-dev
#   lanthorn-dev   headers, static libraries, the CMake package
if(NOT LANTHORN_BUILD_TOOLS OR NOT LANTHORN_BUILD_GAME OR NOT LANTHORN_BUILD_IMAGE_MODULE OR LANTHORN_SANITIZE)
    return()
endif()

# What Debian wants beside the files themselves, and the game where Debian has games; only in packages.
foreach(package lanthorn lamplighter lanthorn-images lanthorn-data lanthorn-dev)
    install(SCRIPT ${PROJECT_SOURCE_DIR}/packaging/install_debian_files.cmake COMPONENT debian_${package} EXCLUDE_FROM_ALL)
    install(CODE "install_debian_files(\"${PROJECT_SOURCE_DIR}\" ${package} \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}/doc\")"
        COMPONENT debian_${package} EXCLUDE_FROM_ALL)
endforeach()
install(TARGETS lamplighter RUNTIME DESTINATION games COMPONENT debian_game EXCLUDE_FROM_ALL)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME lanthorn)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL "")

# lanthorn_package(NAME SECTION COMPONENTS ... [NEEDS package ...] [DEPENDS text] [RECOMMENDS text] [DESCRIPTION lines])
macro(lanthorn_package name section)
    cmake_parse_arguments(ARG "" "ARCHITECTURE;DEPENDS;RECOMMENDS;DESCRIPTION" "COMPONENTS;NEEDS" ${ARGN})
    string(TOUPPER ${name} upper)
    foreach(component ${ARG_COMPONENTS} debian_${name})
        string(TOUPPER ${component} upper_component)
        set(CPACK_COMPONENT_${upper_component}_GROUP ${name})
        list(APPEND CPACK_COMPONENTS_ALL ${component})
    endforeach()
    set(CPACK_COMPONENT_${upper}_DEPENDS ${ARG_NEEDS})
    set(CPACK_COMPONENT_${upper}_DESCRIPTION "${ARG_DESCRIPTION}")
    set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name})
    set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
    set(CPACK_DEBIAN_${upper}_PACKAGE_ARCHITECTURE "${ARG_ARCHITECTURE}")
    set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${ARG_DEPENDS}")
    set(CPACK_DEBIAN_${upper}_PACKAGE_RECOMMENDS "${ARG_RECOMMENDS}")
endmacro()

# libepoxy opens these while the program runs: no binary says so.
set(opengl "libegl1, libgl1")
lanthorn_package(lanthorn graphics COMPONENTS tools NEEDS lanthorn-data DEPENDS "${opengl}" RECOMMENDS lanthorn-images DESCRIPTION
"Global illumination for dynamic scenes, from the command line
Renders glTF 2.0 scenes with indirect light that is never baked: photons
bounce through environment maps on OpenGL 4.5 and rays gather their light;
other techniques stand beside it, and a path tracer as their reference.
Compares pictures and measures error, flicker and time.

Without a GPU it draws on the CPU.")
lanthorn_package(lamplighter games COMPONENTS debian_game game_files NEEDS lanthorn-data
    DEPENDS "${opengl}, fonts-cabin, fonts-quattrocento" RECOMMENDS lanthorn-images DESCRIPTION
"Game of bounced light: colours off walls wake crystals
A lantern is carried through rooms, doors and shutters are opened, and walls
colour the light that they reflect: crystals wake where enough light of their
colour arrives. All light is dynamic, computed while it is played.")
lanthorn_package(lanthorn-images graphics COMPONENTS images DESCRIPTION
"More image formats for the Lanthorn engine
Reads and writes Radiance HDR, TIFF, TGA, BMP, DDS, PSD, DPX and other images
by OpenImageIO, and EXR files of every kind, for lanthorn, lamplighter and
programs made with lanthorn-dev. PNG, JPEG, WebP and plain EXR need it not.")
lanthorn_package(lanthorn-data graphics COMPONENTS shaders scenes ARCHITECTURE all DESCRIPTION
"Shaders and scenes of the Lanthorn engine
What lanthorn, lamplighter and programs made with lanthorn-dev read while
they run, and scenes to try lanthorn with.")
get_property(libraries GLOBAL PROPERTY LANTHORN_DEBIAN_PACKAGES)
list(REMOVE_DUPLICATES libraries)
list(SORT libraries)
list(JOIN libraries ", " libraries)
lanthorn_package(lanthorn-dev libdevel COMPONENTS development NEEDS lanthorn-data DEPENDS "${libraries}, pkg-config"
    RECOMMENDS "cmake, g++, lanthorn-images" DESCRIPTION
"Entity-component game engine with dynamic global illumination
Headers, static libraries and the CMake package of Lanthorn: entities and
schedules, glTF scenes, animation, physics, replays, rendering, and indirect
light that is never baked. Every library is a component of
find_package(lanthorn), usable without the others.")
include(CPack)
