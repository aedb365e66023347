# Installs the build tree into a fresh prefix, then configures, builds and runs the outside project against it.
function(run)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
    if(NOT result EQUAL 0)
        list(JOIN ARGN " " command)
        message(FATAL_ERROR "failed (${result}): ${command}")
    endif()
endfunction()

set(prefix ${CONSUMER_BINARY_DIR}/install)
set(build ${CONSUMER_BINARY_DIR}/build)
file(REMOVE_RECURSE ${prefix} ${build})
run(${CMAKE_COMMAND} --install ${LANTHORN_BINARY_DIR} --prefix ${prefix})
run(${CMAKE_COMMAND} -S ${CONSUMER_SOURCE_DIR} -B ${build} -G ${GENERATOR} -DCMAKE_BUILD_TYPE=${BUILD_TYPE}
    -DCMAKE_PREFIX_PATH=${prefix})
run(${CMAKE_COMMAND} --build ${build})
# The installed shaders and scenes, so that nothing of the source tree is needed.
set(ENV{LANTHORN_SHADERS} ${prefix}/share/lanthorn/shaders)
run(${build}/hello ${prefix}/share/lanthorn/assets/cornell.glb ${CONSUMER_BINARY_DIR}/hello.png)
