# What the scripts of this folder share. Nothing of this machine's settings for Lanthorn reaches the outside projects.
unset(ENV{LANTHORN_SHADERS})
unset(ENV{LANTHORN_ASSETS})

# Runs a command that must succeed.
function(run)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
    if(NOT result EQUAL 0)
        list(JOIN ARGN " " command)
        message(FATAL_ERROR "failed (${result}): ${command}")
    endif()
endfunction()

# Runs a command that must fail and say `words`.
function(run_refused words)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE out ERROR_VARIABLE out)
    string(REGEX REPLACE "[ \n]+" " " out "${out}")
    string(FIND "${out}" "${words}" place)
    if(result EQUAL 0 OR place EQUAL -1)
        list(JOIN ARGN " " command)
        message(FATAL_ERROR "expected to fail (it ended with ${result}) and to say '${words}': ${command}\n${out}")
    endif()
endfunction()

# The command that configures the outside project `folder` into ${build}, freshly.
macro(configure_command folder)
    set(build ${BINARY_DIR}/build)
    file(REMOVE_RECURSE ${build})
    set(configure ${CMAKE_COMMAND} -S ${SOURCE_DIR}/${folder} -B ${build} -G ${GENERATOR}
        -DCMAKE_BUILD_TYPE=${BUILD_TYPE} -DCMAKE_PREFIX_PATH=${PREFIX})
    if(SANITIZE)
        list(APPEND configure -DCMAKE_CXX_FLAGS=-fsanitize=${SANITIZE})
    endif()
    if(LAUNCHER)
        list(APPEND configure "-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}")
    endif()
endmacro()
