# Installs the build tree BINARY_DIR into a fresh PREFIX.
file(REMOVE_RECURSE ${PREFIX})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BINARY_DIR} --prefix ${PREFIX} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
foreach(private bullet_types.h gltf_context.h physics_state.h)
    file(GLOB_RECURSE installed ${PREFIX}/*${private})
    if(installed)
        message(FATAL_ERROR "installed, but private: ${installed}")
    endif()
endforeach()
