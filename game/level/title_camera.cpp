#include "game/level/title_camera.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "lanthorn/scene/components.h"
#include "lanthorn/scene/spawn.h"
#include "lanthorn/scene/view.h"

namespace lanthorn::game {

namespace {

// The camera that shows a level at its best, for title and pictures, if it has one of that name.
constexpr const char* kShownFrom = "camera";

}  // namespace

ecs::Entity title_camera(ShownScene& level) {
    const ecs::Entity shown = find_by_name(level.world(), kShownFrom);
    return shown && level.world().has<CameraComponent>(shown) ? shown : level.camera();
}

void look_from_title(ShownScene& level, double seconds) {
    constexpr double kTurn = 0.12, kRise = 0.03;  // radians
    constexpr double kAside = 0.25;               // metres
    ecs::World& world = level.world();
    const ecs::Entity camera = title_camera(level);
    // Render space is known from the first frame on.
    if (!camera || level.frame().instances.empty()) {
        return;
    }
    const double phase = 0.22 * seconds;
    const dmat4& still = world.get<WorldTransform>(camera).matrix;
    const dvec3 place = dvec3(still[3]) + kAside * std::sin(phase) * dvec3(still[0]);
    dmat4 at = glm::rotate(dmat4(1), kTurn * std::sin(phase), dvec3(0, 1, 0)) * dmat4(glm::dmat3(still));
    at = at * glm::rotate(dmat4(1), kRise * std::sin(0.7 * phase), dvec3(1, 0, 0));
    at[3] = dvec4(place, 1);
    level.app().view().placed =
        camera_view(world.get<CameraComponent>(camera).camera, at, level.frame().origin);
}

void look_with_eyes(ShownScene& level) {
    level.app().view().placed.reset();
}

}  // namespace lanthorn::game
