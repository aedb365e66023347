// Skies: even, black, and dark but for one pixel.
#include <memory>

#include "tests/extremes/row.h"
#include "tests/extremes/scenes.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::extremes {

namespace {

// A court of four walls with a block, open above.
Stage court_under(vec3 nits, bool one_pixel) {
    using gi::test::box;
    using gi::test::lambertian;
    using gi::test::quad;
    Stage stage;
    stage.meshes = {quad({0, 0, 3}, {4, 0, 0}, {0, 0, -3}, 0),
                    quad({0, 0, 0}, {4, 0, 0}, {0, 2.6f, 0}, 0),
                    quad({4, 0, 0}, {0, 0, 3}, {0, 2.6f, 0}, 0),
                    quad({4, 0, 3}, {-4, 0, 0}, {0, 2.6f, 0}, 0),
                    quad({0, 0, 3}, {0, 0, -3}, {0, 2.6f, 0}, 0),
                    box(vec3(1.6f, 0, 0.7f), vec3(2.4f, 1.2f, 2.3f), false, 1)};
    stage.materials = {lambertian(vec3(0.6f)), lambertian(vec3(0.5f))};
    stage.camera.y_fov = 1.2f;
    stage.eye = vec3(3.7f, 2.2f, 2.8f);
    stage.target = vec3(1, 0.6f, 1);
    SkyImage image;
    image.width = 128;
    image.height = 64;
    image.radiance.assign(std::size_t{128} * 64, one_pixel ? vec3(0) : nits);
    image.radiance[std::size_t{8} * 128 + 70] = nits;
    stage.sky.image = std::make_shared<const SkyImage>(std::move(image));
    return stage;
}

Row in_court(std::string name, vec3 nits, bool one_pixel) {
    Row row;
    row.name = std::move(name);
    row.stage = [=] { return court_under(nits, one_pixel); };
    row.lost = 1;
    row.reason = "lost: the court is open";
    return row;
}

Row even_sky() {
    Row row = in_court("an even sky", vec3(100), false);
    row.error = 1.52;
    row.reason = "lost: the court is open; error: 0.1662, and the ordinary room's fell from 0.1116 to 0.1107";
    return row;
}

// A beam, of which all is indirect light: images from files have such a pixel as a light of its own.
Row bright_pixel() {
    Row row = in_court("a sky of one pixel of 1e6 nits", vec3(1e6f), true);
    row.error = 2.4;
    row.flux = 0.06;
    row.reason = "lost: the court is open; error, flux: splats blur the edges of a beam";
    return row;
}

Row black_sky() {
    Row row = in_court("a black sky and a bulb", vec3(0), false);
    row.stage = [] {
        Stage stage = court_under(vec3(0), false);
        stage.lights = {gi::test::point_light(vec3(2, 2, 0.4f), 100)};
        return stage;
    };
    return row;
}

}  // namespace

std::vector<Row> rows_of_skies() {
    return {even_sky(), bright_pixel(), black_sky()};
}

}  // namespace lanthorn::extremes
