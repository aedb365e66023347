# One component, with the packages of all the others hidden; an unknown one is refused with the list of those there are;
# a component whose package is missing is refused by that package's name.
include(${CMAKE_CURRENT_LIST_DIR}/consumer.cmake)
configure_command(components)
set(hidden "")
foreach(package BulletDouble JPEG PNG draco embree glfw3 meshoptimizer nlohmann_json OpenEXR OpenSubdiv PkgConfig spdlog)
    list(APPEND hidden -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()
run(${configure} -DCOMPONENTS=ecs ${hidden})
run(${CMAKE_COMMAND} --build ${build})
run(${build}/steps)

run_refused("lanthorn has no component 'sound'; expected one of: core, ecs, scene" ${configure} "-DCOMPONENTS=ecs\;sound" ${hidden})
run_refused("BulletDouble" ${configure} "-DCOMPONENTS=ecs\;physics" ${hidden})
