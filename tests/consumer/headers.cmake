include(${CMAKE_CURRENT_LIST_DIR}/consumer.cmake)
configure_command(headers)
run(${configure})
run(${CMAKE_COMMAND} --build ${build})
