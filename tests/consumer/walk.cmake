# The sample with a window: in a level of the installation, under an X server of its own, walked about in by keys.
include(${CMAKE_CURRENT_LIST_DIR}/consumer.cmake)
configure_command(walk)
run(${configure})
run(${CMAKE_COMMAND} --build ${build})
run(xvfb-run -a "--server-args=-noreset -screen 0 1280x1024x24" ${SOURCE_DIR}/walk/keys.sh ${build}/walk
    ${PREFIX}/share/lanthorn/assets/levels/red-wall.glb)
run_refused("walk: nothing.glb" xvfb-run -a ${build}/walk nothing.glb)
