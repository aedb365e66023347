#include "tests/extremes/scenes.h"

#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::extremes {

namespace {

constexpr float kSphereCandela = 100;

}  // namespace

Stage room() {
    Stage stage;
    stage.meshes = {gi::test::box(vec3(0), vec3(4, 2.6f, 3), true, 0),
                    gi::test::box(vec3(1.6f, 0, 0.6f), vec3(2.4f, 1.6f, 1.4f), false, 1),
                    gi::test::box(vec3(0.1f, 0, 2.0f), vec3(1.5f, 0.5f, 2.6f), false, 2)};
    stage.materials = {gi::test::lambertian(vec3(0.7f)), gi::test::lambertian(vec3(0.7f, 0.2f, 0.15f)),
                       gi::test::lambertian(vec3(0.2f, 0.55f, 0.25f))};
    stage.lights = {gi::test::point_light(vec3(0.8f, 2.1f, 1.5f), 100)};
    stage.eye = vec3(3.7f, 1.6f, 2.7f);
    stage.target = vec3(1.2f, 1.0f, 1.1f);
    stage.camera.y_fov = 1.2f;
    return stage;
}

Stage sphere(float albedo) {
    Stage stage;
    stage.meshes = {gi::test::inward_sphere(1, 4, 0)};
    stage.materials = {gi::test::lambertian(vec3(albedo))};
    stage.lights = {gi::test::point_light(vec3(0), kSphereCandela)};
    stage.eye = vec3(0, 0, 0.5f);
    stage.camera.y_fov = 1.4f;
    return stage;
}

double sphere_irradiance(float albedo, int bounces) {
    double sum = 0;
    for (int b = 1; b <= bounces; ++b) sum += std::pow(static_cast<double>(albedo), b) * kSphereCandela;
    return sum;
}

}  // namespace lanthorn::extremes
