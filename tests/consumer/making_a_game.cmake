# The tutorial: its programs against the installation, its commands in their order, and the level that it ends at.
include(${CMAKE_CURRENT_LIST_DIR}/consumer.cmake)
configure_command(making_a_game)
run(${configure})
run(${CMAKE_COMMAND} --build ${build})

file(COPY ${SOURCE_DIR}/making_a_game/room.gltf DESTINATION ${BINARY_DIR})
set(ENV{PATH} "${PREFIX}/bin:$ENV{PATH}")
execute_process(COMMAND ${SOURCE_DIR}/making_a_game/commands.sh WORKING_DIRECTORY ${BINARY_DIR} RESULT_VARIABLE result
    OUTPUT_VARIABLE said ERROR_VARIABLE said)
message(STATUS "${said}")
if(NOT result EQUAL 0)
    message(FATAL_ERROR "commands.sh failed (${result})")
endif()
find_program(xvfb_run xvfb-run)
find_program(xdotool xdotool)
if(xvfb_run AND xdotool)
    run(${xvfb_run} -a "--server-args=-noreset -screen 0 1280x1024x24" ${SOURCE_DIR}/making_a_game/look.sh ${build}/window room.gltf ${BINARY_DIR})
endif()
foreach(words
        "node 'shutter': shutter.seconds is 0, expected a number more than 0, at most 60 s"
        "room.rec: 600 steps, every state as recorded")
    string(FIND "${said}" "${words}" place)
    if(place EQUAL -1)
        message(FATAL_ERROR "commands.sh did not say '${words}'")
    endif()
endforeach()
# Recorded, replayed, and replayed with pictures; but not where nothing is drawn, and sensors read nothing.
string(REGEX MATCHALL "the level is solved" solved "${said}")
list(LENGTH solved count)
if(NOT count EQUAL 3)
    message(FATAL_ERROR "the level was solved ${count} times, expected 3")
endif()

execute_process(COMMAND lamplighter --headless --level ${PREFIX}/share/lanthorn/assets/levels/red-wall.glb
    --replay ${SOURCE_DIR}/../replay/red-wall.rec RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(NOT result EQUAL 0 OR NOT said MATCHES "the level is solved")
    message(FATAL_ERROR "red-wall.rec (${result}): ${said}")
endif()
