# install_debian_files(SOURCE PACKAGE DOC): copyright and both changelogs of PACKAGE, below DOC. The version and its date are those of
# tools/package: LANTHORN_DEB_VERSION, LANTHORN_DEB_MAINTAINER, SOURCE_DATE_EPOCH.
function(install_debian_files source package doc)
    foreach(variable LANTHORN_DEB_VERSION LANTHORN_DEB_MAINTAINER SOURCE_DATE_EPOCH)
        if(NOT DEFINED ENV{${variable}})
            message(FATAL_ERROR "${variable} is not set: packages are made by tools/package")
        endif()
    endforeach()
    execute_process(COMMAND date -u -R -d "@$ENV{SOURCE_DATE_EPOCH}" OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE
        COMMAND_ERROR_IS_FATAL ANY)
    string(RANDOM work)  # two packagings may run at once
    set(work ${CMAKE_CURRENT_LIST_DIR}/debian-${work})
    file(MAKE_DIRECTORY ${work})
    file(COPY_FILE ${source}/packaging/copyright ${work}/copyright)
    file(COPY_FILE ${source}/CHANGELOG.md ${work}/changelog)
    file(WRITE ${work}/changelog.Debian "lanthorn ($ENV{LANTHORN_DEB_VERSION}) unstable; urgency=medium\n\n"
        "  * Made from Lanthorn's own repository. See changelog.gz for its changes.\n\n"
        " -- $ENV{LANTHORN_DEB_MAINTAINER}  ${date}\n")
    execute_process(COMMAND gzip -9nf changelog changelog.Debian WORKING_DIRECTORY ${work} RESULT_VARIABLE code)
    if(NOT code EQUAL 0)
        file(REMOVE_RECURSE ${work})
        message(FATAL_ERROR "gzip failed: ${code}")
    endif()
    file(INSTALL ${work}/ DESTINATION ${doc}/${package})
    file(REMOVE_RECURSE ${work})
endfunction()
