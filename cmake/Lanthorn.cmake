# How every Lanthorn target is made: one function, so that warnings, standard and include root are the same
# everywhere.
include(GNUInstallDirs)
include(LanthornPackages)

set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release)
endif()

find_program(LANTHORN_CCACHE ccache)
if(LANTHORN_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${LANTHORN_CCACHE})
    if(NOT DEFINED ENV{CCACHE_BASEDIR})
        # What one checkout has compiled serves another, precompiled headers included.
        set(CMAKE_CXX_COMPILER_LAUNCHER env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1
            CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${LANTHORN_CCACHE})
    endif()
endif()

# Less time to build everything, more to build again after a change.
option(LANTHORN_UNITY "Compile the sources of libraries sixteen at a time" OFF)

# Standard, warnings and sanitizers of our own code.
function(lanthorn_compile_options target)
    target_compile_features(${target} PUBLIC cxx_std_20)
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})  # "engine/ecs/value_json.h", "game/..."
    set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Werror)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        target_compile_options(${target} PRIVATE -fpch-preprocess)  # so that ccache knows objects made with precompiled headers
        # Half a gigabyte before the compiler collects its garbage, which it does all the time otherwise: a tenth less time to build.
        target_compile_options(${target} PRIVATE "SHELL:--param ggc-min-expand=200" "SHELL:--param ggc-min-heapsize=524288")
    endif()
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
        target_compile_options(${target} PRIVATE -Wno-restrict)  # false alarms on std::string, GCC bug 105651
    endif()
    if(LANTHORN_SANITIZE)
        # -O1 and lines alone: less than half the time to build of -O2 -g, and stacks that are still told in full.
        target_compile_options(${target} PRIVATE -fsanitize=${LANTHORN_SANITIZE} -fno-omit-frame-pointer -O1 -g1)
        if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
            # False alarms on std::regex under the address sanitizer, GCC bug 105562.
            target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized)
        endif()
        target_link_options(${target} PUBLIC -fsanitize=${LANTHORN_SANITIZE})
    endif()
    if(LANTHORN_UNITY)
        set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 16)
        target_compile_options(${target} PRIVATE -Wno-subobject-linkage)  # a batch's sources look like headers to GCC
    endif()
    if(LANTHORN_FUZZ)
        # What is undefined ends the program; other compilers' warnings do not end the build.
        target_compile_options(${target} PRIVATE -fno-sanitize-recover=all -Wno-error
            $<IF:$<CXX_COMPILER_ID:Clang>,-fsanitize=fuzzer-no-link,-fsanitize-coverage=trace-pc>)
    endif()
endfunction()

# Common headers, compiled once for all libraries that add no headers of their own, instead of once a source: two thirds of their time
# to build. Sources include what they use all the same: LANTHORN_PCH=OFF builds without.
#   lanthorn_precompile(TARGET [more headers ...])
option(LANTHORN_PCH "Precompile common headers" ON)
function(lanthorn_precompile target)
    if(NOT LANTHORN_PCH)
        return()
    endif()
    if(ARGN)
        target_precompile_headers(${target} PRIVATE ${PROJECT_SOURCE_DIR}/engine/core/common_headers.h ${ARGN})
    else()
        set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)  # as the header is compiled
        target_precompile_headers(${target} REUSE_FROM lanthorn_common_headers)
    endif()
endfunction()

# A static library of the engine, installed and exported as lanthorn::NAME.
#   lanthorn_library(NAME SOURCES ... [INCLUDES ...] [LINKS ...] [PRIVATE_LINKS ...])
# Its public headers lie in include/lanthorn/NAME (INCLUDES names other folders instead of include/): they are installed and
# included as "lanthorn/NAME/x.h". Other headers are private: they are included from the repository root, "engine/NAME/x.h".
# The library is also the component NAME of find_package(lanthorn); which packages it needs follows from its links.
function(lanthorn_library name)
    cmake_parse_arguments(ARG "" "" "SOURCES;INCLUDES;LINKS;PRIVATE_LINKS" ${ARGN})
    add_library(lanthorn_${name} STATIC ${ARG_SOURCES})
    add_library(lanthorn::${name} ALIAS lanthorn_${name})
    set_target_properties(lanthorn_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
    if(NOT ARG_INCLUDES AND EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/include)
        set(ARG_INCLUDES include)
    endif()
    foreach(folder ${ARG_INCLUDES})
        target_include_directories(lanthorn_${name} PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/${folder}>)
        install(DIRECTORY ${folder}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development FILES_MATCHING PATTERN "*.h")
    endforeach()
    target_include_directories(lanthorn_${name} PUBLIC $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    lanthorn_hide_header_only(ARG_PRIVATE_LINKS)
    target_link_libraries(lanthorn_${name} PUBLIC ${ARG_LINKS} PRIVATE ${ARG_PRIVATE_LINKS})
    lanthorn_compile_options(lanthorn_${name})
    lanthorn_component(${name} ${ARG_LINKS} ${ARG_PRIVATE_LINKS})
    install(TARGETS lanthorn_${name} EXPORT lanthorn-${name} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
endfunction()

# What waits for people and files, not for the processor: light optimisation, which takes a quarter less time to build.
function(lanthorn_light_optimisation target)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# What the simulation is computed by: the same bits whether or not the compiler may fuse multiply-adds, so that a
# recording holds on other processors.
function(lanthorn_repeatable target)
    target_compile_options(${target} PRIVATE -ffp-contract=off)
endfunction()

# A program of ours.   lanthorn_program(NAME SOURCES ... LINKS ...)
function(lanthorn_program name)
    cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
    add_executable(${name} ${ARG_SOURCES})
    target_link_libraries(${name} PRIVATE ${ARG_LINKS})
    lanthorn_compile_options(${name})
    set_target_properties(${name} PROPERTIES UNITY_BUILD OFF)
endfunction()
