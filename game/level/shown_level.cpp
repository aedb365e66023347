#include "game/level/shown_level.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "lanthorn/ecs/snapshot.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/runtime/present_plugin.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/spawn.h"
#include "lanthorn/scene/view.h"

namespace lanthorn::game {

namespace {

// The camera that shows a level at its best, for title and pictures, if it has one of that name.
constexpr const char* kShownFrom = "camera";

}  // namespace

ShownLevel::ShownLevel(const Options& options, const SceneData& scene, const shell::Spending& spending)
    : playthrough_(options, scene), quality_(options, session().seed()) {
    quality_.choose(spending);
    gi::add_picture_plugins(app(), quality_.settings());
    app().add<PresentPlugin>();
}

void ShownLevel::spend(const shell::Spending& spending) {
    quality_.choose(spending);
    gi::apply_settings(app(), quality_.settings());
}

std::string ShownLevel::state() const {
    return ecs::Snapshot::save(world(), playthrough_.app().registry()).to_bytes();
}

std::vector<std::string> ShownLevel::restore(std::string_view state, std::string_view source) {
    const ecs::Snapshot snapshot = ecs::Snapshot::from_bytes(state, app().registry(), source);
    snapshot.restore(app().world());
    return snapshot.left_out();
}

void ShownLevel::look_about(double seconds) {
    constexpr double kTurn = 0.12, kRise = 0.03;  // radians
    constexpr double kAside = 0.25;               // metres
    const ecs::Entity shown = find_by_name(app().world(), kShownFrom);
    const ecs::Entity camera = shown && world().has<CameraComponent>(shown) ? shown : app().view().camera;
    // Render space is known from the first frame on.
    if (!camera || world().resource<FrameScene>().instances.empty()) {
        return;
    }
    const double phase = 0.22 * seconds;
    const dmat4& still = world().get<WorldTransform>(camera).matrix;
    const dvec3 place = dvec3(still[3]) + kAside * std::sin(phase) * dvec3(still[0]);
    dmat4 at = glm::rotate(dmat4(1), kTurn * std::sin(phase), dvec3(0, 1, 0)) * dmat4(glm::dmat3(still));
    at = at * glm::rotate(dmat4(1), kRise * std::sin(0.7 * phase), dvec3(1, 0, 0));
    at[3] = dvec4(place, 1);
    const dvec3 origin = world().resource<FrameScene>().origin;
    app().view().placed = camera_view(world().get<CameraComponent>(camera).camera, at, origin);
}

}  // namespace lanthorn::game
