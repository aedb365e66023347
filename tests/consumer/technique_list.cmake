# A program that links a list of techniques has them; one that links none is refused by the linker instead of drawing less.
include(${CMAKE_CURRENT_LIST_DIR}/consumer.cmake)
configure_command(technique_list)
run(${configure} -DLINKS=lanthorn::emc-only)
run(${CMAKE_COMMAND} --build ${build})
run(${build}/technique_list)

run(${configure} -DLINKS=lanthorn::gi)
run_refused("lanthorn::gi::register_techniques()" ${CMAKE_COMMAND} --build ${build})
