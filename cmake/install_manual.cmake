# install_manual(PROGRAM NAME SECTION SHARE): what a built program prints of itself, below SHARE: its manual page, compressed, and its
# completion.
function(install_manual program name section share)
    string(RANDOM work)  # two installations may run at once
    set(work ${CMAKE_CURRENT_LIST_DIR}/manual-${work})
    file(MAKE_DIRECTORY ${work})
    set(page ${work}/${name}.${section})
    execute_process(COMMAND ${program} --print-manual OUTPUT_FILE ${page} COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND ${program} --print-completion OUTPUT_FILE ${work}/${name} COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND gzip -9nf ${page} COMMAND_ERROR_IS_FATAL ANY)
    file(INSTALL ${page}.gz DESTINATION ${share}/man/man${section})
    file(INSTALL ${work}/${name} DESTINATION ${share}/bash-completion/completions)
    file(REMOVE_RECURSE ${work})
endfunction()
