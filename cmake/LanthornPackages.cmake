# Which package each library that we link comes from, so that a component of find_package(lanthorn) finds its own
# dependencies and no others.

# LINK_TARGET|arguments of find_package|Debian package. PkgConfig:NAME is found by pkg-config.
set(LANTHORN_PACKAGES
    "glm::glm|glm|libglm-dev"
    "fmt::fmt|fmt|libfmt-dev"
    "spdlog::spdlog|spdlog|libspdlog-dev"
    "TBB::tbb|TBB|libtbb-dev"
    "nlohmann_json::nlohmann_json|nlohmann_json|nlohmann-json3-dev"
    "OpenSubdiv::osdCPU|OpenSubdiv|libosd-dev"
    "BulletDouble::Dynamics|BulletDouble|libbullet-dev"
    "meshoptimizer::meshoptimizer|meshoptimizer|libmeshoptimizer-dev"
    "draco::draco|draco|libdraco-dev"
    "JPEG::JPEG|JPEG|libjpeg62-turbo-dev"
    "OpenEXR::OpenEXR|OpenEXR|libopenexr-dev"
    "PNG::PNG|PNG|libpng-dev"
    "PkgConfig::libwebp|PkgConfig:libwebp|libwebp-dev"
    "PkgConfig::libwebpdemux|PkgConfig:libwebpdemux|libwebp-dev"
    "PkgConfig::libzstd|PkgConfig:libzstd|libzstd-dev"
    "embree|embree 3|libembree-dev"
    "glfw|glfw3|libglfw3-dev"
    "PkgConfig::imgui|PkgConfig:imgui|libimgui-dev"
    "PkgConfig::openal|PkgConfig:openal|libopenal-dev"
    "PkgConfig::epoxy|PkgConfig:epoxy|libepoxy-dev")

# Header-only libraries that only our own sources include are nothing that an outside program has to link.
set(LANTHORN_HEADER_ONLY nlohmann_json::nlohmann_json nanoflann::nanoflann)
function(lanthorn_hide_header_only list)
    foreach(library ${LANTHORN_HEADER_ONLY})
        list(TRANSFORM ${list} REPLACE "^${library}$" "$<BUILD_INTERFACE:${library}>")
    endforeach()
    set(${list} "${${list}}" PARENT_SCOPE)
endfunction()

# Notes the component `name` with what its links need: other components and packages.
function(lanthorn_component name)
    set(components "")
    set(packages "")
    foreach(link ${ARGN})
        if(link MATCHES "^lanthorn::(.+)$")
            list(APPEND components ${CMAKE_MATCH_1})
        elseif(NOT link MATCHES "^(-|\\$<BUILD_INTERFACE:)")
            set(found "")
            foreach(row ${LANTHORN_PACKAGES})
                if(row MATCHES "^${link}\\|(.+)\\|(.+)$")
                    set(found ${CMAKE_MATCH_1})
                    set_property(GLOBAL APPEND PROPERTY LANTHORN_DEBIAN_PACKAGES ${CMAKE_MATCH_2})
                endif()
            endforeach()
            if(NOT found)
                message(FATAL_ERROR "lanthorn_library(${name}): links ${link}; expected a row of LANTHORN_PACKAGES that says which package it comes from")
            endif()
            list(APPEND packages "${found}")
        endif()
    endforeach()
    set_property(GLOBAL APPEND PROPERTY LANTHORN_COMPONENTS ${name})
    set_property(GLOBAL PROPERTY LANTHORN_COMPONENT_LINES_${name}
        "set(_lanthorn_${name}_components ${components})\nset(_lanthorn_${name}_packages \"${packages}\")\n")
endfunction()
