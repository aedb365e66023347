# Programs of an installation that was copied elsewhere read the copy's shaders: taking one away is noticed.
include(${CMAKE_CURRENT_LIST_DIR}/consumer.cmake)
set(moved ${BINARY_DIR}/elsewhere)
file(REMOVE_RECURSE ${moved})
file(COPY ${PREFIX}/bin ${PREFIX}/share DESTINATION ${moved})
set(render ${moved}/bin/lanthorn render ${moved}/share/lanthorn/assets/cornell.glb --size 32x24 --preset low -o ${BINARY_DIR}/moved.png)
run(${render})
file(REMOVE ${moved}/share/lanthorn/shaders/engine/render/gbuffer.frag)
run_refused("${moved}/share/lanthorn/shaders/engine/render/gbuffer.frag: shader file not found" ${render})
