# Which package each library that we link comes from, so that a component of find_package(lanthorn) finds its own
# dependencies and no others.

# LINK_TARGET|arguments of find_package. PkgConfig:NAME is found by pkg-config.
set(LANTHORN_PACKAGES
    "glm::glm|glm"
    "fmt::fmt|fmt"
    "spdlog::spdlog|spdlog"
    "TBB::tbb|TBB"
    "nlohmann_json::nlohmann_json|nlohmann_json"
    "OpenImageIO::OpenImageIO|OpenImageIO"
    "OpenSubdiv::osdCPU|OpenSubdiv"
    "BulletDouble::Dynamics|BulletDouble"
    "meshoptimizer::meshoptimizer|meshoptimizer"
    "draco::draco|draco"
    "PNG::PNG|PNG"
    "embree|embree 3"
    "glfw|glfw3"
    "PkgConfig::epoxy|PkgConfig:epoxy")

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
                if(row MATCHES "^${link}\\|(.+)$")
                    set(found ${CMAKE_MATCH_1})
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
