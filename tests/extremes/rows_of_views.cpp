// Narrow, wide and grazing views of the room.
#include <fmt/format.h>
#include <glm/trigonometric.hpp>

#include "tests/extremes/row.h"
#include "tests/extremes/scenes.h"

namespace lanthorn::extremes {

namespace {

Row seen(std::string name, std::function<Stage()> stage) {
    Row row;
    row.name = std::move(name);
    row.stage = std::move(stage);
    return row;
}

Row field_of_view(float degrees) {
    return seen(fmt::format("field of view {:g} degrees", degrees), [degrees] {
        Stage stage = room();
        stage.camera.y_fov = glm::radians(degrees);
        return stage;
    });
}

// Most pixels show the floor at angles of a degree and less.
Stage eye_on_the_floor() {
    Stage stage = room();
    stage.eye = vec3(3.9f, 0.005f, 2.9f);
    stage.target = vec3(0, 0.002f, 1.9f);
    stage.camera.z_near = 1e-3f;
    return stage;
}

Row keyhole() {
    Row row = field_of_view(1);
    row.flux = 0.1;
    row.reason = "flux: of a single spot";
    return row;
}

}  // namespace

std::vector<Row> rows_of_views() {
    Row low = seen("eye 5 mm above the floor", eye_on_the_floor);
    low.seeds = 8;  // half the picture is floor within a metre, and few splats decide: 0.94 to 1.07
    return {keyhole(), field_of_view(170), low};
}

}  // namespace lanthorn::extremes
